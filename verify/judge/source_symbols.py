"""Domains and witnesses in symbols that the source has, in place of parameters that it has not.

A steady state is decided over a parameter of the judge's own, in which the tracking index and all
else are rational, say. What a source declares is a function of it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.algebraic import rational_point
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.image import image, images
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.place import Place
from gainproof.verify.judge.exact.region import region_text
from gainproof.verify.judge.exact.statement import Witness
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, SAMPLE, Environment
from gainproof.verify.judge.verdict import Finding

INPUTS = (INDEX, DEVIATION, "measurement_noise_variance")
"""Beginnings of quantities of a steady state that all others are functions of, with T."""
LONGEST = 200
"""Characters of an expression that is told beside a domain."""


@dataclass(frozen=True)
class Meant:
    """A parameter of the judge, its name in what it tells, and a symbol of the source that is this
    expression of it.
    """

    name: str
    label: str
    token: str
    value: Expr


def in_source_symbols(finding: Finding, setting: Setting, environment: Environment) -> Finding:
    """The finding with its domain and witness told by symbols of the source, as far as one symbol
    is a function of one parameter; what cannot be told so says what the parameter is.
    """
    for meant in _meant(setting, environment):
        finding = _retold(finding, meant, environment)
    return replace(finding, region=())


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
    if environment.parameter not in (None, SAMPLE):
        # where no symbol stands for it, the name of the quantity is at least one of the field
        declared.setdefault(INDEX, environment.quantities.get(INDEX))
    for name in environment.boxes:
        found = [(t, v) for t, v in declared.items() if v is not None and symbols_of(v) == {name}]
        if found and not any(value == symbol(name) and token != name for token, value in found):
            token, value = found[0]
            if token != name:
                yield Meant(name, labels.get(name, name), token, value)


def _retold(finding: Finding, meant: Meant, environment: Environment) -> Finding:
    domain, reason, witness = finding.domain, finding.reason, finding.witness
    if witness is not None and meant.label in witness.point:
        told = _at(witness, meant)
        reason = reason.replace(witness.text(), told.text())
        witness = told
    if domain is not None and meant.label in domain:
        for old, new in _regions(finding.region, meant, environment):
            domain, reason = domain.replace(old, new), reason.replace(old, new)
        if meant.label in domain:
            value = labelled(meant.value, {meant.name: meant.label})
            more = f"{domain}, where {meant.token} = {value}"
            if len(value) <= LONGEST:
                reason, domain = reason.replace(domain, more), more
    return replace(finding, domain=domain, reason=reason, witness=witness)


def _at(witness: Witness, meant: Meant) -> Witness:
    """The witness with the value of the symbol in place of that of the parameter."""
    try:
        at = rational_point(Fraction(witness.point[meant.label]))
        value = image(meant.value, meant.name, at).text()
    except (ValueError, Undecided):
        return witness
    point = {
        (meant.token if name == meant.label else name): (value if name == meant.label else other)
        for name, other in witness.point.items()
    }
    return replace(witness, point=point)


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
            yield region_text(places, meant.label), region_text(found, meant.token)
