"""Domains and witnesses in symbols that the source has, in place of parameters that it has not.

A steady state is decided over a parameter of the judge's own, in which the tracking index and all
else are rational, say. What a source declares is a function of it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.algebraic_numbers import rational_point
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    symbol,
    symbols_of,
    whole_power,
)
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.images import image, images
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.region_text import region_text
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement, Witness
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    SAMPLE,
    Environment,
)
from gainproof.verify.judge.verdict import Finding

INPUTS = (INDEX, DEVIATION, "measurement_noise_variance")
"""Beginnings of quantities of a steady state that all others are functions of, with T."""
UNITS = (INTERVAL, DEVIATION)
MOST_POWER = 12
LONGEST = 200
"""Characters of an expression that is told beside a domain."""
BEFORE = r"(^|[(,;:]\s?|\b(?:and|for|if|only|or|where|with)\s)"
WITHIN = r"(^|[\s(])"
AFTER = r"(?=$|[,;:)]|\.$|\.?\s(?!\s*[-+*/^<>=]))"
"""What a condition stands between where all of it is meant: a number that goes on is another
one.
"""


@dataclass(frozen=True)
class Meant:
    """A parameter of the judge, its name in what it tells, and what of the source is this
    expression of it: a symbol, or a symbol over `powers` of T and of the noise deviation, by their
    own names in what is told; `token` is the symbol, `words` the whole.
    """

    name: str
    label: str
    token: str
    value: Expr
    words: str
    powers: Mapping[str, int] = field(default_factory=dict)


def in_source_symbols(finding: Finding, setting: Setting, environment: Environment) -> Finding:
    """The finding with its domain and witness told by symbols of the source, as far as one symbol
    is a function of one parameter; what cannot be told so says what the parameter is.
    """
    for meant in _meant(setting, environment):
        finding = _retold(finding, meant, environment)
    return finding


def _meant(setting: Setting, environment: Environment) -> Iterator[Meant]:
    labels = Scope(setting, environment).labels()
    given = [*INPUTS, *(["gain."] if environment.region is not None else [])]
    declared = {
        token: environment.quantities.get(entry.quantity)
        for token, entry in setting.symbols.items()
        if entry.quantity is not None and entry.quantity.startswith(tuple(given))
    }
    unit = {DEVIATION: environment.quantities.get(DEVIATION, symbol(DEVIATION))}
    declared |= {token: substituted(v, unit) for token, v in environment.assigned.items()}
    known = {token: value for token, value in declared.items() if value is not None}
    # T and the deviation come last: what is told of the others speaks of them
    for name in sorted(environment.boxes, key=lambda name: name in UNITS):
        own = [(t, v) for t, v in known.items() if symbols_of(v) == {name}]
        label = labels.get(name, name)
        # the parameter itself first, which may have its label by now
        own.sort(key=lambda pair: pair[1] != symbol(name))
        if own and own[0][0] != label:
            yield Meant(name, label, *own[0], own[0][0])
        elif own:
            continue
        elif name == environment.parameter and name != SAMPLE:
            scaled = (_scaled(name, t, v, known, labels, environment) for t, v in known.items())
            index = environment.quantities.get(INDEX)
            found = next(filter(None, scaled), None)
            if found is not None:
                yield found
            elif name != INDEX and index is not None and symbols_of(index) == {name}:
                # where no symbol stands for it, the name of the quantity is at least of the field
                yield Meant(name, label, INDEX, index, INDEX)


def _scaled(
    name: str,
    token: str,
    value: Expr,
    known: Mapping[str, Expr],
    labels: Mapping[str, str],
    environment: Environment,
) -> Meant | None:
    """A symbol that is a function of the parameter times powers of T and the deviation; None for
    others.
    """
    others = symbols_of(value) - {name}
    if name not in symbols_of(value) or not others <= set(UNITS):
        return None
    ones = {other: number(1) for other in others}
    bare = tidied(substituted(value, ones))
    powers: dict[str, int] = {}
    product = bare
    for other in sorted(others):
        at_two = substituted(value, {**ones, other: number(2), name: number(Fraction(1, 2))})
        at_one = substituted(bare, {name: number(Fraction(1, 2))})
        high, low = constant_value(at_two), constant_value(at_one)
        ratio = high / low if high and low else Fraction(0)
        fits = [k for k in range(-MOST_POWER, MOST_POWER + 1) if ratio == Fraction(2) ** k]
        if not fits:
            return None
        powers[other] = fits[0]
        product = product * whole_power(symbol(other), fits[0])
    try:
        same = decide(Statement((Rel("=", value, product),)), environment.boxes, name)
    except Undecided:
        return None
    if same.verdict != "proved":
        return None
    words = token
    variance = next((t for t, v in known.items() if v == power(symbol(DEVIATION), 2)), None)
    for other, k in sorted(powers.items(), key=lambda pair: pair[1]):
        by_variance = other == DEVIATION and variance is not None and k % 2 == 0
        plain = next((t for t, v in known.items() if v == symbol(other)), labels.get(other, other))
        told, size = (variance, k // 2) if by_variance else (plain, k)
        exponent = "" if abs(size) == 1 else f"^{abs(size)}"
        words += f"/{told}{exponent}" if size > 0 else f" {told}{exponent}"
    shown = {labels.get(other, other): k for other, k in powers.items()}
    return Meant(name, labels.get(name, name), token, bare, words, shown)


def _retold(finding: Finding, meant: Meant, environment: Environment) -> Finding:
    domain, reason, witness = finding.domain, finding.reason, finding.witness
    for old, new in _ends(meant, environment) if f"{meant.label} -> " in (domain or "") else ():
        old, new = f"as {meant.label} -> {old}", f"as {meant.words} -> {new}"
        domain, reason = _put(old, new, domain or "", WITHIN), _put(old, new, reason, WITHIN)
    if witness is not None and meant.label in witness.point:
        told = _at(witness, meant)
        reason = reason.replace(witness.text(), told.text())
        witness = told
    if domain is not None and speaks_of(domain, meant.label):
        for old, new in _regions(finding.region, meant, environment):
            domain, reason = _put(old, new, domain), _put(old, new, reason)
        if meant.value == symbol(meant.name):
            exchanged = _exchanged(domain, meant)
            reason, domain = _put(domain, exchanged, reason, r"(^|[\s(])"), exchanged
        if speaks_of(domain, meant.label):
            value = labelled(meant.value, {meant.name: meant.label})
            more = f"{domain}, where {meant.words} = {value}"
            if len(value) <= LONGEST:
                # added, not exchanged: any words may stand before
                reason, domain = _put(domain, more, reason, WITHIN), more
    return replace(finding, domain=domain, reason=reason, witness=witness)


def speaks_of(text: str, name: str) -> bool:
    """Whether a name stands in a text as a whole, not as a part of another name."""
    return re.search(_whole(name), text) is not None


def _whole(name: str) -> str:
    return rf"(?<![\w\\{{]){re.escape(name)}(?![\w}}])"


def _exchanged(text: str, meant: Meant) -> str:
    """The text with the words for a parameter that they are, in brackets amid a formula."""

    def put(found: re.Match[str]) -> str:
        amid = found.end() < len(text) and not re.match(r",| ->", text[found.end() :])
        return f"({meant.words})" if amid and re.search(r"[ /]", meant.words) else meant.words

    return re.sub(_whole(meant.label), put, text)


def _put(old: str, new: str, text: str, before: str = BEFORE) -> str:
    """The text with `new` wherever `old` stands as a whole condition."""
    return re.sub(before + re.escape(old) + AFTER, lambda found: found[1] + new, text)


def _at(witness: Witness, meant: Meant) -> Witness:
    """The witness with the value of the symbol in place of that of the parameter; T and the
    deviation are 1 where it speaks of neither.
    """
    units = {name: witness.point.get(name, "1") for name in meant.powers}
    try:
        at = rational_point(Fraction(witness.point[meant.label]))
        size = Fraction(1)
        for name, value in units.items():
            size *= Fraction(value) ** meant.powers[name]
        told = image(number(size) * meant.value, meant.name, at).text()
    except (ValueError, Undecided):
        return witness
    point = {
        (meant.token if name == meant.label else name): (told if name == meant.label else other)
        for name, other in witness.point.items()
    }
    return replace(witness, point={**point, **units})


def _ends(meant: Meant, environment: Environment) -> Iterator[tuple[str, str]]:
    """The ends of the values of the parameter, each with that to which the symbol goes."""
    box = environment.boxes[meant.name]
    lower, upper = (None if b is None else rational_point(b) for b in (box.lower, box.upper))
    within = rational_point(Place(left=lower, right=upper, is_cell=True).samples[0])
    try:
        edge = image(meant.value, meant.name, within)
        for end, far, half in (
            (lower, "-infinity", Place(left=lower, right=within, is_cell=True)),
            (upper, "infinity", Place(left=within, right=upper, is_cell=True)),
        ):
            found = images(meant.value, meant.name, box, [half])
            if not found:
                return
            rises = found[0].left == edge
            goes = found[0].right if rises else found[0].left
            infinite = "infinity" if rises else "-infinity"
            old, new = (far if end is None else end.text()), goes.text() if goes else infinite
            yield old, new
    except Undecided:
        return


def _regions(
    kept: tuple[Place, ...], meant: Meant, environment: Environment
) -> Iterator[tuple[str, str]]:
    """Sets of values of the parameter as they are told, each with that of the symbol."""
    box = environment.boxes[meant.name]
    lower, upper = (None if b is None else rational_point(b) for b in (box.lower, box.upper))
    whole = (Place(left=lower, right=upper, is_cell=True),)
    for places in (kept, whole):
        try:
            found = images(meant.value, meant.name, box, places) if places else None
        except Undecided:
            continue
        if found:
            yield region_text(places, meant.label), region_text(found, meant.words)
