"""Counterexamples: an exact instance with the place where it fails."""

from __future__ import annotations

from decimal import Context, Decimal

from flint import fmpq, fmpq_mat

from gainproof.verify.judge.exact.statement import Enclosure, Witness
from gainproof.verify.judge.matrices.definite_values import bad_direction, compared, is_symmetric
from gainproof.verify.judge.matrices.exact_instance import Instance, NoValueError
from gainproof.verify.judge.matrices.letters import MatrixSetting
from gainproof.verify.judge.matrices.proof import Question, links
from gainproof.verify.judge.matrices.tree import Node
from gainproof.verify.judge.matrices.used_definitions import names_in, outside_means
from gainproof.verify.judge.verdict_words import LACKS_VALUE, Shown

DIGITS = 30


def witness_of(question: Question, setting: MatrixSetting, instance: Instance) -> Witness:
    """The instance and two numbers that should be in the relation claimed and are not."""
    point = _point(question, setting, instance)
    for left, operator, right in links(question.chains):
        try:
            one, other = instance.of(left), instance.of(right)
        except NoValueError:
            first, second = _side(instance, left), _side(instance, right)
            return Witness(point, operator, first, second, note=LACKS_VALUE)
        if not compared(one, operator, other):
            return _difference(point, operator, one, other)
    number = Enclosure("0", "0")
    return Witness(point, "!=", number, number, exact=True, note="the determinant is 0")


def _side(instance: Instance, side: Node) -> Enclosure:
    """The value of one side, a number or a whole matrix, or why it has none."""
    try:
        value = instance.of(side)
    except NoValueError as reason:
        return Enclosure("", "", str(reason))
    is_number = value.nrows() == value.ncols() == 1
    return _number(value[0, 0]) if is_number else Enclosure(text_of(value), "0")


def _point(question: Question, setting: MatrixSetting, instance: Instance) -> dict[str, str]:
    """Sizes, and the free letters that the claim depends on; of random ones of which it takes means
    their variances say all.
    """
    needed = outside_means(question.nodes(), setting)
    used = [
        name
        for name in names_in(question.nodes(), setting)
        if setting.letters[name].variance is None or name in needed
    ]
    sizes = {name: str(size.value(instance.steps)) for name, size in setting.sizes.names.items()}
    free = [name for name in used if name in instance.values]
    return sizes | {name: text_of(instance.values[name]) for name in free}


def text_of(matrix: fmpq_mat) -> str:
    """`[[1, 2], [0, 1/2]]`."""
    rows = [
        ", ".join(str(matrix[i, j]) for j in range(matrix.ncols())) for i in range(matrix.nrows())
    ]
    return "[" + ", ".join(f"[{row}]" for row in rows) + "]"


def _difference(point: dict[str, str], operator: str, left: fmpq_mat, right: fmpq_mat) -> Witness:
    if operator == "=":
        i, j = next(
            (i, j)
            for i in range(left.nrows())
            for j in range(left.ncols())
            if left[i, j] != right[i, j]
        )
        one, other = _number(left[i, j]), _number(right[i, j])
        note = f"entry ({i + 1}, {j + 1})"
        return Witness(point, "=", one, other, note=note, shows=Shown.ENTRY)
    gap = left - right
    if not is_symmetric(gap):
        i, j = next((i, j) for i in range(gap.nrows()) for j in range(i) if gap[i, j] != gap[j, i])
        note = f"entries ({i + 1}, {j + 1}) and ({j + 1}, {i + 1}) of the difference"
        return Witness(point, "=", _number(gap[i, j]), _number(gap[j, i]), note=note)
    signed = gap if operator.startswith(">") else -gap
    direction = bad_direction(signed, "=" not in operator)
    assert direction is not None
    column = fmpq_mat(len(direction), 1, direction)
    sides = [(column.transpose() * side * column)[0, 0] for side in (left, right)]
    note = f"x^T X x of both sides for x = ({', '.join(map(str, direction))})"
    exact = sides[0] == sides[1]
    return Witness(point, operator, _number(sides[0]), _number(sides[1]), exact=exact, note=note)


def _number(value: fmpq) -> Enclosure:
    """In decimal, exact where it ends."""
    context = Context(prec=DIGITS)
    shown = context.divide(Decimal(int(value.p)), Decimal(int(value.q)))
    exact = shown * int(value.q) == int(value.p) if abs(value.p) < 10**DIGITS else False
    radius = "0" if exact else str(context.scaleb(abs(shown), Decimal(3 - DIGITS)))
    return Enclosure(str(shown), radius)
