"""Random radical statements, decided and compared with plain evaluation at random points."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from random import Random

from random_radicals import NoValue, Unclear, X, equal_pair, expression, near_pair, value

from gainproof.verify.judge.exact.algebraic_numbers import compare
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import roots_made_prime
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.truth import FALSE, NO_VALUE, TRUE
from gainproof.verify.judge.exact.truth_survey import Work, survey
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Undecided

BOXES = (
    Box(stated=False),
    Box(lower=Fraction(0)),
    Box(lower=Fraction(0), lower_open=False),
    Box(lower=Fraction(-3), upper=Fraction(2)),
    Box(lower=Fraction(1), lower_open=False, upper=Fraction(4), upper_open=False),
)
OPERATORS = ("=", "=", "=", "<", "<=", ">", ">=", "!=")


def statements(seed: int, count: int, depth: int = 2) -> Iterator[tuple[Rel, Box]]:
    """Random statements: true by construction, nearly true, and arbitrary."""
    random = Random(seed)
    for _ in range(count):
        kind = random.random()
        if kind < 0.5:
            left, right = equal_pair(random, depth)
        elif kind < 0.85:
            left, right = near_pair(random, depth)
        else:
            left, right = expression(random, depth + 1), expression(random, depth)
        yield Rel(random.choice(OPERATORS), left, right), random.choice(BOXES)


def holds(rel: Rel, at: Fraction) -> str:
    """The truth at a point by plain evaluation; sides whose balls of 600 bits overlap count as
    equal.

    Raises Unclear.
    """
    try:
        a, b = value(rel.left, at), value(rel.right, at)
    except NoValue:
        return NO_VALUE
    equal = a.overlaps(b)
    truth = {
        "=": equal,
        "!=": not equal,
        "<": not equal and a < b,
        "<=": equal or a < b,
        ">": not equal and a > b,
        ">=": equal or a > b,
    }[rel.operator]
    return TRUE if truth else FALSE


def place_of(found: list[tuple[Place, str]], at: Fraction) -> str | None:
    """What was found at the place that holds a point."""
    for place, truth in found:
        if place.at is not None:
            if place.at.is_rational and place.at.low == at:
                return truth
        elif (place.left is None or compare(place.left, at) < 0) and (
            place.right is None or compare(place.right, at) > 0
        ):
            return truth
    return None


def points(random: Random, box: Box, count: int) -> list[Fraction]:
    """Random points of a box, small integers and its closed faces among them."""
    drawn = [Fraction(n) for n in range(-4, 6)]
    drawn += [Fraction(random.randint(-80, 80), random.randint(1, 16)) for _ in range(count)]
    return [p for p in drawn if box.holds(p)]


def disagreements(
    seed: int, count: int, depth: int = 2, limits: Limits = DEFAULT_LIMITS
) -> tuple[list[str], Counter[str]]:
    """Every point at which verdict or place disagree with plain evaluation, and how often each
    verdict came.
    """
    random = Random(seed + 1)
    wrong: list[str] = []
    verdicts: Counter[str] = Counter()
    for number, (rel, box) in enumerate(statements(seed, count, depth)):
        plain = Rel(rel.operator, roots_made_prime(rel.left), roots_made_prime(rel.right))
        statement = Statement((plain,))
        try:
            outcome = decide(statement, {"x": box}, "x", limits=limits)
            work = Work(statement, {"x": box}, "x", {}, limits)
            found = [(j.place, j.truth) for j in survey(work)]
        except Undecided as reason:
            verdicts[f"undecided: {str(reason)[:60]}"] += 1
            continue
        verdicts[outcome.verdict] += 1
        for at in points(random, box, 12):
            try:
                seen = holds(rel, at)
            except Unclear:
                continue
            claimed = place_of(found, at)
            proved_wrong = (
                outcome.verdict == "proved" and seen != TRUE and (box.stated or seen != NO_VALUE)
            )
            if claimed != seen or proved_wrong:
                where = f"seed {seed} number {number} at {at}"
                wrong.append(f"{where}: found {claimed}, seen {seen}, {outcome.verdict}")
    return wrong, verdicts


def shown(expr: Expr) -> str:
    """Readable, for a failing example."""
    parts = [shown(p) for p in expr.parts]
    match expr.kind:
        case "number" | "symbol":
            return f"({expr.value})"
        case "pow":
            return f"{parts[0]}^({expr.value})"
        case _:
            sign = {"add": "+", "mul": "*", "div": "/", "neg": "-"}[expr.kind]
            return f"({sign.join(parts)})" if len(parts) > 1 else f"(-{parts[0]})"


__all__ = ["X", "disagreements", "holds", "shown", "statements"]
