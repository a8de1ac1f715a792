"""Graphs of matrix formulas, expanded into words; shapes are checked at every sum and product.

The graph is {"nodes": [...], "outputs": {"value": number}} with nodes ["number", q],
["symbol", name], ["add", i, j, ...], ["mul", i, j, ...], ["neg", i], ["div", i, j] (by one term
of a number and positive parameters), ["pow", i, n] (of a number, n from 2 on, as text),
["transpose", i] and ["inverse", i] (of one letter that has an inverse in the setting). Every node
serves the value.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial, Powers, Word
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

MAXIMUM_WORD_NODES = 400
MAXIMUM_EXPONENT = 12


def expand(value: Plain, setting: Setting, place: str) -> Polynomial:
    """The value of a graph. Raises RejectedError where shapes do not fit."""
    fields = schema.record(value, ("nodes", "outputs"), place)
    entries = schema.items(fields["nodes"], f"{place}.nodes")
    if not 1 <= len(entries) <= MAXIMUM_WORD_NODES:
        raise MalformedError(f"{place}: between 1 and {MAXIMUM_WORD_NODES} nodes are wanted")
    outputs = schema.record(fields["outputs"], ("value",), f"{place}.outputs")
    if outputs["value"] != len(entries) - 1:
        raise MalformedError(f"{place}: the last node is the value")
    values: list[Polynomial] = []
    idle = set(range(len(entries) - 1))
    for number, entry in enumerate(entries):
        node = schema.items(entry, f"{place}.nodes[{number}]")
        here = f"{place}.nodes[{number}]"
        if not node or not isinstance(node[0], str):
            raise MalformedError(f"{here}: a node starts with its kind")
        if node[0] in ("number", "symbol") and len(node) == 2:
            values.append(_leaf(node, setting, here))
            continue
        power = _exponent(node[2], here) if node[0] == "pow" and len(node) == 3 else 1
        before = node[1:2] if power > 1 else node[1:]
        arguments = [schema.integer(n, 0, number - 1, here) for n in before]
        idle -= set(arguments)
        found = [values[n] for n in arguments]
        if power > 1:
            values.append(_power(found, power, setting, here))
        else:
            values.append(_operation(node[0], found, setting, here))
    if idle:
        raise MalformedError(f"{place}: nodes {sorted(idle)[:5]} serve no output")
    return values[-1]


def expand_matrix(value: Plain, setting: Setting, place: str) -> Polynomial:
    """The same of a matrix. Raises RejectedError for a number."""
    found = expand(value, setting, place)
    if found.shape is None:
        raise RejectedError(f"{place}: a matrix is wanted, a number found")
    return found


def expand_pair(
    left: Plain, right: Plain, setting: Setting, place: str
) -> tuple[Polynomial, Polynomial]:
    """Two matrices of one shape; one of them may be the number 0, which then is the zero matrix."""
    pair = [expand(value, setting, place) for value in (left, right)]
    for at, other in ((0, 1), (1, 0)):
        shape = pair[other].shape
        if pair[at].shape is None and not pair[at].terms and shape is not None:
            pair[at] = setting.zero(shape)
    if pair[0].shape is None or pair[0].shape != pair[1].shape:
        raise RejectedError(f"{place}: two matrices of one shape are wanted")
    return pair[0], pair[1]


def _leaf(node: list[Plain], setting: Setting, place: str) -> Polynomial:
    if node[0] == "number":
        return setting.number(schema.number(node[1], place))
    return setting.symbol(schema.name(node[1], place), place)


def _operation(kind: str, values: list[Polynomial], setting: Setting, place: str) -> Polynomial:
    meter = setting.meter
    if kind in ("add", "mul") and len(values) >= 2:
        total = values[0]
        for value in values[1:]:
            if kind == "add":
                total = total.plus(value, meter, place)
            else:
                total = total.times(value, meter, place)
        return total
    if kind == "neg" and len(values) == 1:
        return values[0].negative(meter)
    if kind == "div" and len(values) == 2:
        return values[0].times(_reciprocal(values[1], setting, place), meter, place)
    if kind == "transpose" and len(values) == 1:
        return values[0].transposed(meter)
    if kind == "inverse" and len(values) == 1:
        return _inverse(values[0], setting, place)
    raise MalformedError(f"{place}: {kind[:20]!r} of {len(values)} is not a node here")


def _exponent(value: Plain, place: str) -> int:
    exponent = schema.number(value, place)
    if exponent.denominator != 1 or not 2 <= exponent <= MAXIMUM_EXPONENT:
        raise MalformedError(f"{place}: an exponent from 2 to {MAXIMUM_EXPONENT} is wanted")
    return exponent.numerator


def _power(values: list[Polynomial], exponent: int, setting: Setting, place: str) -> Polynomial:
    if len(values) != 1 or values[0].shape is not None:
        raise RejectedError(f"{place}: powers are of numbers only")
    product = values[0]
    for _ in range(exponent - 1):
        product = product.times(values[0], setting.meter, place)
    return product


def _reciprocal(value: Polynomial, setting: Setting, place: str) -> Polynomial:
    if value.shape is not None or len(value.terms) != 1:
        raise RejectedError(f"{place}: a divisor is one term of a number and positive parameters")
    (((powers, _), coefficient),) = value.terms.items()
    for power, positive in zip(powers, setting.positive, strict=True):
        if power and not positive:
            raise RejectedError(f"{place}: division by a parameter that may vanish")
    key: tuple[Powers, Word] = (tuple(-power for power in powers), ())
    return Polynomial({key: Fraction(1) / coefficient}, None)


def _inverse(value: Polynomial, setting: Setting, place: str) -> Polynomial:
    if len(value.terms) == 1 and value.shape is not None:
        (((powers, word), coefficient),) = value.terms.items()
        if coefficient == 1 and len(word) == 1 and powers == setting.no_powers:
            for number, base in setting.inverses.items():
                if word == (2 * base,):
                    return setting.letter(number)
    raise RejectedError(f"{place}: the inverse of one letter that has one is wanted")
