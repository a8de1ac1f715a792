"""How close Newton's steps come to the one fixed point of a map, proved from its shape.

Let g be a positive function of x > 0 with logarithmic slope k(x) = x g'/g, and let 0 <= k <= K < 1
and m <= x k' <= M for every x > 0; `slopes` reads K, m and M from the shape of g. Let X be the
fixed point of g, and h(t) = log g(e^t), so that h' = k and h'' = x k'.

1. One fixed point. t - h(t) has a slope between 1 - K > 0 and 1, so it takes the value 0 once.
2. Contraction. |log(g(x)/X)| <= K |log(x/X)|: the mean value theorem for h. Conversely
   log(x/X) lies between log(x/g(x)) and log(x/g(x))/(1 - K), the mean value theorem for t - h.
3. Curvature. x^2 g''/g = x k' - k (1 - k), whose size is at most c, `curvature`.
4. Newton's step for x - g(x) = 0 is N(x) = (g - x g')/(1 - g'), wherever g' = k g/x < 1. Taylor's
   theorem gives g(X) = g(x) + g'(x)(X - x) + g''(z)(X - x)^2/2 with z between x and X, hence
   N(x) - X = -g''(z) (x - X)^2/(2 (1 - g'(x))).
   a. For x >= X: g(z) <= X (z/X)^K by 2, so g(z)/z^2 <= 1/X, and g'(x) <= K (x/X)^(K - 1) <= K.
      With r = x/X - 1 therefore |N(x)/X - 1| <= c r^2/(2 (1 - K)).
   b. For X > x = s X > K X: g(z) <= X as g increases, z >= s X, and g'(x) <= K/s. So
      |N(x)/X - 1| <= c (1 - s)^2/(2 s (s - K)).
5. In floating point the step gives N(x) (1 + d) for the number x that it is given, where d is made
   of the roundings of this one step and of what does not hold x: the errors of x are no errors
   of the step. So the bounds e of |log(x_i/X)| follow each other by 4 and d, and that of the last
   step is its own roundings plus what 4 makes of the step before, which is of second order.
6. What is computed from the last x is g(x), whose errors in x count K times at most: by 2.

For g = sqrt(a + 2 sqrt(b + 2 d x)) with positive a, b, d: K = 1/4, 0 <= x k' <= 3/32, c = 3/16, and
4 a reads r^2/8.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.graph import GraphNode, operands

MOST_STEPS = 8
UP = 1.0 + 2.0**-30  # more than the roundings of `after_step`


@dataclass(frozen=True)
class Slopes:
    """Enclosures of a logarithmic slope, and of its derivative by the logarithm."""

    least: Fraction
    most: Fraction
    turn_least: Fraction
    turn_most: Fraction

    @property
    def curvature(self) -> Fraction:
        """A bound of |x^2 g''/g| (3 above): k (1 - k) is concave."""
        greatest = (
            Fraction(1, 4)
            if self.least <= Fraction(1, 2) <= self.most
            else max(k * (1 - k) for k in (self.least, self.most))
        )
        least = min(k * (1 - k) for k in (self.least, self.most))
        return max(abs(self.turn_least - greatest), abs(self.turn_most - least))

    @property
    def contracts(self) -> bool:
        """Whether the theorem holds."""
        return self.least >= 0 and self.most < 1


CONSTANT = Slopes(Fraction(0), Fraction(0), Fraction(0), Fraction(0))
ITSELF = Slopes(Fraction(1), Fraction(1), Fraction(0), Fraction(0))


def slopes(nodes: Sequence[GraphNode], unknown: int, end: int) -> Slopes:
    """Of node `end` by node `unknown`, whatever positive values the other nodes have.

    Slopes of products add, that of a square root is half. That of a sum of positive terms is their
    mean with the terms as weights; its derivative is the mean of the derivatives and the variance
    of the slopes, at most a quarter of their range squared. ValueError names a node that is no sum,
    product or square root, or that divides by what holds the unknown.
    """
    found: dict[int, Slopes] = {unknown: ITSELF}
    for number in range(unknown + 1, end + 1):
        node, parts = nodes[number], operands(nodes[number])
        if not any(part in found for part in parts):
            continue
        terms = [found.get(part, CONSTANT) for part in parts]
        match node[0]:
            case "add":
                least, most = min(t.least for t in terms), max(t.most for t in terms)
                found[number] = Slopes(
                    least,
                    most,
                    min(t.turn_least for t in terms),
                    max(t.turn_most for t in terms) + (most - least) ** 2 / 4,
                )
            case "mul":
                found[number] = _scaled(terms, Fraction(1))
            case "div" if parts[1] not in found:
                found[number] = _scaled(terms, Fraction(1))
            case "pow" if node[2] == "1/2":
                found[number] = _scaled(terms, Fraction(1, 2))
            case _:
                raise ValueError(
                    f"node {number} {node}: a map with a fixed point is made of sums, products and "
                    "square roots of positive terms, divided by what does not hold the unknown"
                )
    if end not in found:
        raise ValueError(f"node {end}: the map of a fixed point does not hold its unknown")
    return found[end]


def _scaled(terms: Sequence[Slopes], factor: Fraction) -> Slopes:
    zero = Fraction(0)
    return Slopes(
        factor * sum((t.least for t in terms), zero),
        factor * sum((t.most for t in terms), zero),
        factor * sum((t.turn_least for t in terms), zero),
        factor * sum((t.turn_most for t in terms), zero),
    )


@dataclass(frozen=True)
class Convergence:
    """What the theorem says of a map: its greatest slope K and its curvature c."""

    slope: Fraction
    curvature: Fraction

    def after_step(self, error: float) -> float:
        """e with |N(x)/X - 1| <= e/(1 + e) where x lies between X/(1 + error) and X (1 + error)."""
        most, c, s = float(self.slope) * UP, float(self.curvature) * UP, 1.0 / ((1.0 + error) * UP)
        if not s > most:
            return float("inf")
        above = c * error**2 / (2.0 * (1.0 - most))
        below = c * (1.0 - s) ** 2 / (2.0 * s * (s - most))
        found = max(above, below) * UP
        return found / (1.0 - found) * UP if found < 1.0 else float("inf")

    def steps(self, error: float, unit: float) -> int:
        """Newton's steps from a start so near until the next g(x) is right to half a rounding.

        ValueError if there are too many.
        """
        for count in range(MOST_STEPS + 1):
            if error * float(self.slope) <= unit / 2:
                return count
            error = self.after_step(error)
        raise ValueError(f"Newton's method needs more than {MOST_STEPS} steps from this start")
