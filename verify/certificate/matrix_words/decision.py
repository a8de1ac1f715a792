"""The kinds of matrix statements, and how each is decided.

Traces are words up to rotation and transposition, since tr(A B) = tr(B A) and tr(A') = tr(A).
What a statement rests upon is found without recursion: a chain of premises may be as long as the
certificate, and Python's stack is not.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from types import MappingProxyType
from typing import Protocol, TypeAlias

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.combination import combination, require_combination
from gainproof.verify.certificate.matrix_words.definiteness import (
    require_both_orders,
    require_full_rank,
    require_order,
    require_vanishing,
)
from gainproof.verify.certificate.matrix_words.expression import expand_matrix, expand_pair
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial, Powers, Word
from gainproof.verify.certificate.matrix_words.relations import (
    Conclusion,
    Ground,
    Premise,
    read_hypotheses,
)
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

Traces: TypeAlias = dict[tuple[Powers, Word, str], Fraction]


def prove(setting: Setting, statement: Statement, earlier: Sequence[Statement]) -> Conclusion:
    """What the statement says, proved; `earlier`: those before it, the only ones it may rest on.

    Raises RejectedError if it, or one that it rests on, is not proved.
    """
    known = setting.decided.get(statement.id)
    if known is not None and known[0] is statement:
        conclusion = known[1]
        if isinstance(conclusion, Conclusion):
            return conclusion
        raise RejectedError(str(conclusion))
    # Premises first, in their order: a chain of them may be as long as the certificate.
    for number in undecided(setting, statement, earlier):
        with suppress(RejectedError):  # kept, and said again where the premise is used
            _decide(setting, earlier[number], earlier[:number])
    return _decide(setting, statement, earlier)


def _decide(setting: Setting, statement: Statement, earlier: Sequence[Statement]) -> Conclusion:
    try:
        found = _prove(setting, statement, earlier)
    except RejectedError as rejection:
        setting.decided[statement.id] = (statement, str(rejection))
        raise
    setting.decided[statement.id] = (statement, found)
    return found


def _prove(setting: Setting, statement: Statement, earlier: Sequence[Statement]) -> Conclusion:
    place = statement.id
    numbers = {other.id: number for number, other in enumerate(earlier)}

    def premise(identifier: str) -> Conclusion:
        if identifier not in numbers:
            raise RejectedError(f"there is no earlier statement {identifier!r} in this setting")
        number = numbers[identifier]
        if earlier[number].kind not in KINDS:
            raise RejectedError(f"{identifier!r} is no matrix statement")
        return prove(setting, earlier[number], earlier[:number])

    if statement.kind not in KINDS:
        raise MalformedError(f"{place}: {statement.kind!r} is not decided in a setting of matrices")
    claim = schema.table(statement.claim, f"{place}.claim")
    if "given" not in claim:
        raise MalformedError(f"{place}.claim: the field 'given' is missing")
    ground = _ground(setting, claim["given"], premise, f"{place}.claim.given")
    conclusion = KINDS[statement.kind](statement, ground)
    idle = set(range(len(ground.hypotheses))) - ground.used
    if idle:
        raise RejectedError(f"{place}.claim.given: hypotheses {sorted(idle)} are not needed")
    return conclusion


def _ground(setting: Setting, given: Plain, premise: Premise, place: str) -> Ground:
    hypotheses = read_hypotheses(given, setting, place)
    numbers = tuple(map(setting.numbered, schema.items(given, place)))
    return Ground(setting, numbers, hypotheses, premise)


def _equal(statement: Statement, ground: Ground) -> Conclusion:
    """matrix_equal {"left", "right", "given"}; {"cofactors"}, {"cofactors", "definite", "side"},
    also with {"factor", "rest"}, or {"cofactors", "above", "below", "opposite"}: the difference is
    a combination of equations, vanishes since N' D N does and D > 0, as D K does for D >= 0, or
    is both >= 0 and <= 0.
    """
    place = statement.id
    claim = schema.record(statement.claim, ("left", "right", "given"), f"{place}.claim")
    left, right = expand_pair(claim["left"], claim["right"], ground.setting, f"{place}.claim")
    difference = left.minus(right, ground.setting.meter, place)
    evidence = schema.table(statement.evidence, f"{place}.evidence")
    if "side" in evidence:
        fields = ("cofactors", "definite", "side")
        more = ("factor", "rest") if "factor" in evidence else ()
        evidence = schema.record(evidence, (*fields, *more), f"{place}.evidence")
        require_vanishing(difference, evidence, ground, f"{place}.evidence")
    elif "above" in evidence:
        require_both_orders(difference, evidence, ground, f"{place}.evidence")
    else:
        evidence = schema.record(evidence, ("cofactors",), f"{place}.evidence")
        require_combination(difference, evidence["cofactors"], ground, f"{place}.evidence")
    return Conclusion("matrix_equal", ground.given, difference)


def _order(statement: Statement, ground: Ground) -> Conclusion:
    """matrix_order {"larger", "smaller", "relation": ">=" | ">", "given"}; {"squares",
    "cofactors"}, for ">" also "rank".
    """
    place = statement.id
    claim = schema.record(
        statement.claim, ("larger", "smaller", "relation", "given"), f"{place}.claim"
    )
    larger, smaller = expand_pair(
        claim["larger"], claim["smaller"], ground.setting, f"{place}.claim"
    )
    difference = larger.minus(smaller, ground.setting.meter, place)
    assert difference.shape is not None
    if difference.shape[0] != difference.shape[1]:
        raise RejectedError(f"{place}: an order is one of square matrices")
    if claim["relation"] not in (">=", ">"):
        raise MalformedError(f'{place}.claim.relation: ">=" or ">" is wanted')
    strict = claim["relation"] == ">"
    fields = ("squares", "cofactors", "rank") if strict else ("squares", "cofactors")
    evidence = schema.record(statement.evidence, fields, f"{place}.evidence")
    found = require_order(difference, evidence, ground, f"{place}.evidence")
    if strict:
        require_full_rank(found, evidence["rank"], difference.shape, ground, f"{place}.rank")
    return Conclusion("matrix_order", ground.given, difference, strict)


def _invertible(statement: Statement, ground: Ground) -> Conclusion:
    """matrix_invertible {"matrix": name, "given"}; {"because": ["given", n]}, invertible or
    definite by hypothesis; {"because": ["statement", id]}, the letter > 0 (A x = 0 makes x' A x
    zero, hence x); or {"left_inverse": polynomial, "cofactors"}: L A = I, so A x = 0 only for
    x = 0, and a square matrix of which this is true is invertible.
    """
    place, setting = statement.id, ground.setting
    claim = schema.record(statement.claim, ("matrix", "given"), f"{place}.claim")
    name = schema.name(claim["matrix"], f"{place}.claim")
    number = setting.index(name, f"{place}.claim")
    letter, shape = setting.letter(number), setting.shapes[number]
    if shape[0] != shape[1]:
        raise RejectedError(f"{place}: {name} is not square")
    evidence = schema.table(statement.evidence, f"{place}.evidence")
    if "because" in evidence:
        fields = schema.record(evidence, ("because",), f"{place}.evidence")
        because = schema.items(fields["because"], f"{place}.evidence")
        _require_known_invertible(because, number, ground, f"{place}.evidence")
    else:
        fields = schema.record(evidence, ("left_inverse", "cofactors"), f"{place}.evidence")
        left = setting.polynomial(fields["left_inverse"], shape, f"{place}.evidence")
        product = left.times(letter, setting.meter, place)
        rest = setting.unit(shape[0]).minus(product, setting.meter, place)
        require_combination(rest, fields["cofactors"], ground, f"{place}.evidence")
    return Conclusion("matrix_invertible", ground.given, letter, letter=number)


def _require_known_invertible(
    because: list[Plain], number: int, ground: Ground, place: str
) -> None:
    if len(because) == 2 and because[0] == "given":
        found = ground.hypothesis(because[1], ("invertible", "definite"), place)
        if found.letter != number:
            raise RejectedError(f"{place}: the hypothesis is about another matrix")
    elif len(because) == 2 and because[0] == "statement":
        earlier = ground.earlier(because[1], "matrix_order", place)
        if not earlier.strict or earlier.difference != ground.setting.letter(number):
            raise RejectedError(f"{place}: the letter itself is to be shown positive definite")
    else:
        raise MalformedError(f"{place}.because: given or statement is wanted")


def _trace(statement: Statement, ground: Ground) -> Conclusion:
    """matrix_trace {"left", "right", "given"}; {"used": [{"size", "cofactors"}, ...]}: the
    traces of two square matrices, of one size or of two.
    """
    place = statement.id
    claim = schema.record(statement.claim, ("left", "right", "given"), f"{place}.claim")
    left, right = (
        expand_matrix(claim[side], ground.setting, f"{place}.claim") for side in ("left", "right")
    )
    evidence = schema.record(statement.evidence, ("used",), f"{place}.evidence")
    require_traces(left, right, evidence["used"], ground, f"{place}.evidence")
    return Conclusion("matrix_trace", ground.given, left)


KINDS: Mapping[str, Callable[[Statement, Ground], Conclusion]] = MappingProxyType(
    {
        "matrix_equal": _equal,
        "matrix_order": _order,
        "matrix_invertible": _invertible,
        "matrix_trace": _trace,
    }
)


def add_trace(total: Traces, value: Polynomial, sign: int, ground: Ground, place: str) -> None:
    """Add the trace of a square matrix, or subtract it. That of a unit matrix is its size."""
    if value.shape is None or value.shape[0] != value.shape[1]:
        raise RejectedError(f"{place}: a square matrix is wanted")
    for (powers, word), coefficient in value.terms.items():
        ground.setting.meter.spend(2 * len(word) ** 2 + 1)
        key = (powers, _representative(word), "" if word else value.shape[0])
        rest = total.pop(key, Fraction(0)) + sign * coefficient
        if rest:
            total[key] = rest


def require_traces(
    left: Polynomial, right: Polynomial, value: Plain, ground: Ground, place: str
) -> None:
    """Reject unless the traces agree after equations are used, each in a square matrix:
    [{"size", "cofactors"}, ...].
    """
    total: Traces = {}
    add_trace(total, left, 1, ground, place)
    add_trace(total, right, -1, ground, place)
    for number, entry in enumerate(schema.items(value, place)):
        here = f"{place}[{number}]"
        fields = schema.record(entry, ("size", "cofactors"), here)
        size = schema.text(fields["size"], here)
        used = combination(fields["cofactors"], (size, size), ground, here)
        add_trace(total, used, -1, ground, here)
    if total:
        raise RejectedError(f"{place}: {len(total)} terms are left over")


def _representative(word: Word) -> Word:
    """The first of all rotations of the word and of its transpose."""
    if not word:
        return word
    other = tuple(letter ^ 1 for letter in reversed(word))
    return min(w[i:] + w[:i] for w in (word, other) for i in range(len(word)))


class Statement(Protocol):
    """A statement of a certificate: its id, kind, claim and evidence."""

    @property
    def id(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def claim(self) -> Plain: ...
    @property
    def evidence(self) -> Plain: ...


def undecided(setting: Setting, statement: Statement, earlier: Sequence[Statement]) -> list[int]:
    """The numbers, ascending, of the earlier statements that this one rests upon, also through
    others, and that are still to be decided.
    """
    numbers = {other.id: number for number, other in enumerate(earlier)}
    waiting, found = [statement], set[int]()
    while waiting:
        current = waiting.pop()
        end = numbers.get(current.id, len(earlier))
        for identifier in _named(current.evidence):
            number = numbers.get(identifier, end)
            if number < end and number not in found:
                known = setting.decided.get(identifier)
                if known is None or known[0] is not earlier[number]:
                    found.add(number)
                    waiting.append(earlier[number])
    return sorted(found)


def _named(evidence: Plain) -> Iterator[str]:
    """The ids in all that reads ["statement", id] or ["inverse", id, side]."""
    waiting = [evidence]
    while waiting:
        value = waiting.pop()
        if isinstance(value, dict):
            waiting += value.values()
        elif isinstance(value, list):
            if value[:1] in (["statement"], ["inverse"]):
                yield from (part for part in value[1:2] if isinstance(part, str))
            waiting += value
