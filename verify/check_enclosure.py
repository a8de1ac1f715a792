"""Decides one certificate about a steady state: `python check_enclosure.py certificate.json`.

It needs Python alone. Of x+ = F x + w, y = H x + v the covariances of w, of v, of w with v are Q, R
and S; [c, r] is any number from c - r to c + r. With rational X, Y (`upper` less `slack`) and K
(`predictor`), G = [H; F] and W = [R S'; S Q], exact elimination decides W >= 0, X >= Y, X >= [-K I]
(G X G' + W) [-K I]', which is at least Ric(X), and G Y G' + W - [0 0; 0 Y] > 0, that is Ric(Y) > Y
and H Y H' + R > 0. From Y to X the Riccati map is monotone: Ric(Ric(...X)) falls to a fixed point P
between them. Its gain makes the filter stable, as P - Y >= A (P - Y) A' + what is definite; there
is no other such P. Errors follow by Cauchy and Schwarz, with H Y H' + R >= diag(`floor`).
"""

import json
import re
import sys
from fractions import Fraction
from math import isqrt, lcm
from typing import Any

FORMAT = "gainproof steady state 1"
NUMBER = re.compile(r"(?a:-?\d{1,1200}(\.\d{1,1200})?(/\d{1,1200}|e-?\d{1,3})?)").fullmatch
Rows = list[list[Fraction]]
ZERO = Fraction(0)


def require(condition: object, reason: str) -> None:
    if not condition:
        raise ValueError(reason)


class Box:
    """All matrices whose entries differ from `c` by at most `r`; r is None for one matrix."""

    def __init__(self, c: Rows, r: Rows | None = None) -> None:
        self.c, self.r = c, r if r and any(map(any, r)) else None
        self.radius = self.r or [[ZERO] * len(row) for row in c]
        self.most = [[abs(x) + e for x, e in zip(*rows)] for rows in zip(c, self.radius)]

    def turned(self) -> "Box":
        return Box(*(list(map(list, zip(*rows))) for rows in (self.c, self.radius)))

    def __matmul__(self, other: "Box") -> "Box":
        c = times(self.c, other.c)
        if self.r is other.r is None:
            return Box(c)
        least = times(*([list(map(abs, row)) for row in rows] for rows in (self.c, other.c)))
        return Box(c, (Box(times(self.most, other.most)) - Box(least)).c)

    def __sub__(self, other: "Box") -> "Box":
        return self.__add__(other, -1)

    def __add__(self, other: "Box", sign: int = 1) -> "Box":
        c = [[x + sign * y for x, y in zip(*rows)] for rows in zip(self.c, other.c)]
        return Box(c, [[x + y for x, y in zip(*rows)] for rows in zip(self.radius, other.radius)])

    def over(self, below: "Box") -> "Box":
        return Box(self.c + below.c, self.radius + below.radius)


def diagonal(values: list[Fraction]) -> Box:
    return Box([[x if i == j else ZERO for j in range(len(values))] for i, x in enumerate(values)])


def times(a: Rows, b: Rows) -> Rows:
    return [[sum((x * y for x, y in zip(row, column)), ZERO) for column in zip(*b)] for row in a]


def definite(box: Box, what: str, strict: bool = False) -> None:
    # an error beside the diagonal takes no more from a matrix than itself on both places of it
    rows = (box - diagonal([sum(row, ZERO) for row in box.radius])).c
    require(rows == list(map(list, zip(*rows))), f"not symmetric: {what}")
    below, last = lcm(*[x.denominator for row in rows for x in row]), 1
    a = [[x.numerator * (below // x.denominator) for x in row] for row in rows]
    while a:
        (pivot, *row), *rest = a
        require(pivot > 0 or not (pivot or strict or any(row)), f"not shown: {what}")
        by = pivot or last  # a row of zeros leaves the others as they are
        last, a = by, [[(by * y - x[0] * z) // last for y, z in zip(x[1:], row)] for x in rest]


def root(x: Fraction) -> Fraction:
    """The square root, rounded up by less than one part in 2^30."""
    shift = 2 * max(0, 33 + (x.denominator.bit_length() - x.numerator.bit_length()) // 2)
    return x and Fraction(isqrt((x.numerator << shift) // x.denominator) + 1, 1 << shift // 2)


def decide(data: Any) -> dict[str, Box]:
    """Enclosures of the covariances `predicted`, `updated` and of the gains `filter`, `predictor`
    of all models in the boxes with W >= 0. Raises ValueError and others where this is not shown."""
    require(data["format"] == FORMAT, f"no {FORMAT}")
    inner, outer = data["parts"]  # states and measurements with other numbers do not meet
    n, m = len(inner), len(outer)

    def read(name: str, rows: list[int], columns: list[int]) -> Box:
        lists = [row for row in data[name] if type(row) is list]
        grid = [[(x, "0") if isinstance(x, str) else x for x in row] for row in lists]
        require([len(row) for row in grid] == [len(columns)] * len(rows), f"shape of {name}")
        told = grid and all(NUMBER(c) and NUMBER("-" + r) for row in grid for c, r in row)
        require(told, f"no numbers, or a radius below 0, in {name}")
        box = Box(*([[Fraction(x[k]) for x in row] for row in grid] for k in (0, 1)))
        met = all(i == j or not x for i, row in zip(rows, box.most) for j, x in zip(columns, row))
        require(met and (name in "FHQRS" or not box.r), f"parts that meet or radii in {name}")
        return box

    f, q, x, slack = (read(name, inner, inner) for name in ("F", "Q", "upper", "slack"))
    h, r, s = read("H", outer, inner), read("R", outer, outer), read("S", inner, outer)
    (floor,) = read("floor", [0], [0] * m).c
    w = r.over(s).turned().over(s.turned().over(q).turned())
    definite(Box((w + diagonal([sum(row, ZERO) for row in w.radius])).c), "W >= 0")
    definite(slack, "X >= Y")
    g, y = h.over(f), x - slack
    padded = Box([[ZERO] * (m + n)] * m + [[ZERO] * m + row for row in y.c])
    definite(g @ y @ g.turned() + w - padded, "Ric(Y) > Y", strict=True)
    require(min(floor) > 0, "a floor that is not above 0")
    definite(h @ y @ h.turned() + r - diagonal(floor), "H Y H' + R >= diag(floor)")
    inverse, unit, none = [1 / b for b in floor], diagonal([Fraction(1)] * n), Box([[ZERO] * m] * n)
    lost = sum((inverse[i] * e[i] for i, e in enumerate((h @ slack @ h.turned()).most)), ZERO)

    def within(middle: Box, a: list[Fraction], b: list[Fraction], to: list[int]) -> Box:
        radii = [[root(p * q) if i == j else ZERO for q, j in zip(b, to)] for p, i in zip(a, inner)]
        return middle + Box([[ZERO] * len(to)] * n, radii)

    def best(gain: Box, t: Box, qt: Box, st: Box) -> tuple[Box, Box, Box]:
        """The covariance of the error of t x by `gain` at X; the least one at P; its gain."""
        keep = t - gain @ h
        rest = keep @ x @ h.turned() + st - gain @ r
        at_x = keep @ x @ keep.turned() + qt - gain @ st.turned() - (st - gain @ r) @ gain.turned()
        errors, far = [], []
        for i, row in enumerate((keep @ slack @ keep.turned()).most):
            e = sum((a * a * b for a, b in zip(rest.most[i], inverse)), ZERO)
            told = at_x.most[i][i] == 0  # by this gain without an error
            far.append(ZERO if told else (root(lost * row[i]) + root(e)) ** 2)
            errors.append(ZERO if told else row[i] + far[i])
        return at_x, within(at_x, errors, errors, inner), within(gain, far, inverse, outer)

    moved, _, predictor = best(read("predictor", inner, outer), f, q, s)
    definite(x - moved, "X >= Ric(X)")
    _, updated, gain = best(read("filter", inner, outer), unit, unit - unit, none)
    errors = [row[i] if x.c[i][i] else ZERO for i, row in enumerate(slack.c)]
    predicted = within(x, errors, errors, inner)
    return {"predicted": predicted, "updated": updated, "filter": gain, "predictor": predictor}


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as stream:
        data = json.loads(stream.read(4_000_000))
    for name, box in decide(data).items():
        for i, row in enumerate(zip(box.c, box.radius), 1):
            told = [(v, e + abs(c - Fraction(v))) for c, e in zip(*row) for v in [repr(float(c))]]
            print(name, i, *(f"{v} +- {1.1 * float(e) + (e and 1e-323):.1e}" for v, e in told))
    print("proved of", *(f"{name} = {json.dumps(data[name])}" for name in "FHQRS"), sep="\n")
