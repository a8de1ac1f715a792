"""Coupled roots: two positive numbers, each the root of a sum that contains the other.

A coupled pair is the x, y > 0 with

    x^2 = a + b y,    y^2 = c + e x,    a, c >= 0,  b, e > 0.

There is exactly one. Put h(x) = sqrt(a + b sqrt(c + e x)) for x > 0; then x, y solve both equations
just if h(x) = x and y = sqrt(c + e x).
Existence: h is continuous; h(x) >= sqrt(b sqrt(e x)) exceeds x where x^3 < b^2 e; and h(x)/x tends
to 0 as x grows.
Uniqueness: the logarithmic slope k = x h'/h is (1/4) (b y/(a + b y)) (e x/(c + e x)), hence above 0
and at most 1/4, so that log h(e^t) - t falls strictly: it vanishes once.

Reduction puts a + b y for x^2 and c + e x for y^2. Each replacement lowers the total degree in x
and y, so it ends, at terms in 1, x, y and x y. Both equations hold at every point, so polynomials
with a difference that reduces to zero are equal there. (The converse may fail; then a true
statement is rejected, never a false one accepted.)

x y >= b e: for t = x y, t^2 = (a + b y)(c + e x) = a c + a e x + b c y + b e t, so that t (t - b e)
is not negative. Hence 4 x y - b e > 0, and likewise

    (4 x y - b e) x y = 4 a c + 4 a e x + 4 b c y + 3 b e x y,

in which every term has a plain sign. That is the determinant of the equations for the derivatives,
2 x x' - b y' = a' + b' y and -e x' + 2 y y' = c' + e' x; so, by the theorem on implicit functions,
x and y are differentiable wherever a, b, c and e are, and Cramer's rule gives x' and y'.
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.certificate.polynomial import Polynomial, Ring


@dataclass(frozen=True, slots=True)
class Pair:
    """x and y at ``position`` and the next: ``free`` are a and c, ``slopes`` b and e."""

    symbols: tuple[str, str]
    position: int
    free: tuple[Polynomial, Polynomial]
    slopes: tuple[Polynomial, Polynomial]

    @property
    def ring(self) -> Ring:
        """The ring of the coefficients."""
        return self.free[0].ring

    @property
    def variables(self) -> tuple[Polynomial, Polynomial]:
        """x and y."""
        return self.ring.variable(self.position), self.ring.variable(self.position + 1)

    @property
    def radicands(self) -> tuple[Polynomial, Polynomial]:
        """a + b y and c + e x."""
        first, second = self.variables
        return self.free[0] + self.slopes[0] * second, self.free[1] + self.slopes[1] * first

    @property
    def coefficients(self) -> tuple[Polynomial, ...]:
        """a, c, b and e: what the pair is made of."""
        return *self.free, *self.slopes

    @property
    def determinant(self) -> Polynomial:
        """4 a c + 4 a e x + 4 b c y + 3 b e x y, which is (4 x y - b e) x y."""
        (a, c), (b, e), (x, y) = self.free, self.slopes, self.variables
        four, three = self.ring.constant(4), self.ring.constant(3)
        return four * (a * c + a * e * x + b * c * y) + three * (b * e * x * y)
