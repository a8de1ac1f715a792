"""Where no method decides: exact rational points, which can refute and never prove."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.enclose import Balls, NoValue, Unresolved, enclosed
from gainproof.verify.judge.exact.enclosure import enclosure, separated
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement, Witness
from gainproof.verify.judge.exact.witness import inside

PRECISIONS = (128, 512, 2048)
AGREED_BITS = 400
WANTED = 35
"""All scales of all patterns: what is false far out only shows at the last."""
LEAST = 8
PATTERNS = (
    (1, 2, 3, 5, 7, 11),
    (2, 3, 5, 7, 11, 13),
    (5, 1, 7, 2, 3, 1),
    (1, 1, 1, 1, 1, 1),
    (9, 4, 1, 6, 2, 8),
    (-1, 2, -3, 5, -7, 11),
    (1, -2, -1, 3, 5, -4),
)


def try_points(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome | None:
    """`refuted` with a witness, `held` if at least LEAST points agree and none differs, or None.

    Only for statements of the form `relations if conditions`.
    """
    if statement.connective != "if":
        return None
    agreed = 0
    for tried, point in enumerate(_points(sorted(statement.symbols()), boxes), start=1):
        found = _at(statement, point, labels)
        if isinstance(found, Witness):
            reason = f"fails {found.text()}; where it may hold is not determined"
            return Outcome("refuted", "", reason, "balls at an exact point", found, {}, tried)
        agreed += found
    if agreed < LEAST:
        return None
    reason = f"agrees at {agreed} exact points to {AGREED_BITS * 3 // 10} digits; no proof"
    return Outcome("held", "", reason, "balls at exact points")


def failure_at(
    statement: Statement, point: Mapping[str, Fraction], labels: Mapping[str, str]
) -> Witness | None:
    """The witness if a statement of the form `relations if conditions` is seen to fail there."""
    found = _at(statement, point, labels) if statement.connective == "if" else None
    return found if isinstance(found, Witness) else None


def is_seen(rel: Rel) -> bool:
    """Whether balls show an inequality between numbers."""
    opposite = {">": "<=", ">=": "<", "<": ">=", "<=": ">"}.get(rel.operator)
    if opposite is None:
        return False
    return failure_at(Statement((Rel(opposite, rel.left, rel.right),)), {}, {}) is not None


def _points(names: list[str], boxes: Mapping[str, Box]) -> Iterator[dict[str, Fraction]]:
    """Simple points inside the boxes, then the same with halves and thirds, and far out."""
    made: set[tuple[Fraction, ...]] = set()
    for scale in (1, Fraction(1, 2), 10, Fraction(1, 30), 1000):
        for pattern in PATTERNS:
            values = []
            for k, name in enumerate(names):
                wanted = Fraction(pattern[k % len(pattern)] + 20 * (k // len(pattern))) * scale
                value = inside(boxes.get(name, Box(stated=False)), wanted)
                if value is None:
                    break
                values.append(value)
            if len(values) < len(names):
                continue
            if tuple(values) not in made and len(made) < WANTED:
                made.add(tuple(values))
                yield dict(zip(names, values, strict=True))


def _at(
    statement: Statement, point: Mapping[str, Fraction], labels: Mapping[str, str]
) -> Witness | int:
    """A witness, 1 if the statement was seen to hold at the point, 0 if it says nothing there."""
    for precision in PRECISIONS:
        balls = Balls(point, precision)
        try:
            if not all(_holds(rel, balls) for rel in statement.domain):
                return 0
            for needed in statement.needed:
                balls.round(needed)
            for rel in statement.relations:
                if not _holds(rel, balls):
                    shown = separated(balls.round(rel.left), balls.round(rel.right))
                    if shown is None:
                        raise Unresolved("sides too close")
                    where = {labels.get(name, name): str(value) for name, value in point.items()}
                    return Witness(where, rel.operator, *shown)
            return 1
        except Unresolved:
            continue
        except NoValue:
            return 0
    return 0


def _holds(rel: Rel, balls: Balls) -> bool:
    """Truth by balls; two sides that agree to AGREED_BITS count as equal. Raises Unresolved,
    NoValue.
    """
    a, b = balls.round(rel.left), balls.round(rel.right)
    if not a.overlaps(b):
        less = bool(a < b)
        return {"=": False, "!=": True, "<": less, "<=": less, ">": not less, ">=": not less}[
            rel.operator
        ]
    gap = a - b
    if rel.operator in ("=", "<=", ">=") and gap.abs_upper() * 2**AGREED_BITS < a.abs_upper() + 1:
        return True
    raise Unresolved("sides that overlap")


def with_values(
    witness: Witness, quantities: Mapping[str, Expr], labels: Mapping[str, str]
) -> Witness:
    """The witness with the values of named quantities at its point, where the point is rational."""
    try:
        point = {
            name: Fraction(witness.point[label])
            for name, label in labels.items()
            if label in witness.point
        }
    except ValueError:
        return witness
    values = {}
    for token, expr in quantities.items():
        try:
            values[token] = enclosure(enclosed(expr, point, PRECISIONS[0]), 12)
        except (NoValue, Unresolved):
            continue
    return replace(witness, values=values)
