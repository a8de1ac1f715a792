"""Polynomials that keep one sign on a box, shown by their coefficients after a change of variables.

With v = lower + x, v = upper - x or v = (lower x + upper) / (1 + x), x > 0, the box becomes the set
of all positive x; a polynomial without negative coefficients is positive there. A variable without
bounds stays, and may stand in even powers only.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.polynomial import Poly, coefficients_in, constant, rational, terms

Corner = int | None
"""The exponent of x that is left at a closed face: 0, or the degree for the face at infinity."""


def keeps_sign(p: Poly, boxes: Sequence[Box], *, closed: bool) -> bool:
    """Whether p is shown to vanish nowhere in the box; `closed`: its closed faces included."""
    faces: list[tuple[Corner, ...]] = []
    for index, box in enumerate(boxes):
        degree = max(0, int(p.degrees()[index]))
        p = _moved(p, index, box)
        faces.append(_faces(box, degree) if closed else (None,))
    entries = [(e, c) for e, c in terms(p)]
    if len({c > 0 for _, c in entries}) != 1:
        return False
    loose = [i for i, box in enumerate(boxes) if box.lower is None and box.upper is None]
    if any(e[i] % 2 for e, _ in entries for i in loose):
        return False
    firm = [e for e, _ in entries if not any(e[i] for i in loose)]
    return all(
        any(all(c is None or e[i] == c for i, c in enumerate(corner)) for e in firm)
        for corner in product(*faces)
    )


def _moved(p: Poly, index: int, box: Box) -> Poly:
    if box.lower is None and box.upper is None:
        return p
    context = p.context()
    x, one = context.gen(index), constant(context, 1)
    parts = coefficients_in(p, index)
    total = constant(context, 0)
    if box.lower is None or box.upper is None:
        low, high = box.lower, box.upper
        v = x + constant(context, low) if low is not None else constant(context, high or 0) - x
        for part in reversed(parts):
            total = total * v + part
        return total
    top, bottom = x * rational(box.lower) + rational(box.upper), x + one
    weight = one
    for part in reversed(parts):
        total = total * top + part * weight
        weight = weight * bottom
    return total


def _faces(box: Box, degree: int) -> tuple[Corner, ...]:
    """The closed faces as exponents of x that are left there; None where there is none.

    At a corner of the box only these terms are left. That each corner keeps one is enough: what is
    left on a larger face is more.
    """
    if box.lower is None and box.upper is None:
        return (None,)
    both = box.lower is not None and box.upper is not None
    found: list[Corner] = []
    if box.lower is not None and not box.lower_open:
        found.append(degree if both else 0)
    if box.upper is not None and not box.upper_open:
        found.append(0)
    return tuple(found) or (None,)
