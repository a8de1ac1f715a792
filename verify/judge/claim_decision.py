"""One claim in one environment."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import graphs_of_claim, reached
from gainproof.verify.judge.convention import Convention
from gainproof.verify.judge.convention_effect import Chosen
from gainproof.verify.judge.dimensions.claim import (
    claim_readings,
    degrees_are_open,
    likeliest_first,
)
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import judge_reading
from gainproof.verify.judge.kinds.claim_domain import where_model_is
from gainproof.verify.judge.kinds.decimal_reading import decimals_read, with_rounded
from gainproof.verify.judge.meaning.definition_names import Reach
from gainproof.verify.judge.quick_refutation import seen_false, seen_to_fail
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import Environment, NotEstablished, algebra
from gainproof.verify.judge.source_symbols import in_source_symbols
from gainproof.verify.judge.two_parameter_claims import judge_in
from gainproof.verify.judge.verdict import Finding

WITH_MODEL = ("steady_state", "growing_memory", "fading_memory", "kalman_bucy", "fixed_gain")
EQUATIONS, ORDERS = "identity", "inequality"
FEW = 2
"""Symbols of an order that is looked at: it is decided over cells, which takes time."""
NORMAL_MEANS = (
    "moments of a normal noise v of mean 0 and variance s, by parts of its density: "
    "E[v f(v)] = s E[f'(v)], hence E[e^(i k v)] = e^(-k^2 s/2); of independent noises they multiply"
)


def judge_claim(claim: Claim, setting: Setting, environment: Environment) -> Finding:
    """One claim in one environment; of several readings the one that is proved, else the first."""
    findings = []
    for reading, attempt in _attempts(claim, setting, environment):
        finding = _attempt(attempt)
        if reading is not None:
            own = [finding.reading] if finding.reading else []
            words = own + _how_read(claim, reading, setting, finding.verdict)
            finding = with_rounded(finding, claim, reading, setting, environment)
            finding = replace(finding, reading="; ".join(words) or None)
        if environment.conditions and not environment.hidden:
            finding = _of_one_filter(finding, environment.parameter)
        else:
            finding = in_source_symbols(finding, setting, environment)
        finding = where_model_is(finding, claim, setting, environment)
        # the places were told in the domain and have done their work
        finding = replace(finding, region=())
        told = {
            "established": [fact.sentence for fact in environment.facts],
            "cited": cited(claim, setting),
        }
        if finding.certificate:
            more = {name: sentences for name, sentences in told.items() if sentences}
            finding = replace(finding, certificate={**finding.certificate, **more})
        if finding.verdict == "proved":
            return replace(finding, any_filter=holds_for_any_filter(claim, reading, setting))
        findings.append(finding)
    if len({f.verdict for f in findings}) > 1 and any(f.verdict == "undecided" for f in findings):
        return next(f for f in findings if f.verdict == "undecided")
    return findings[0]


def _how_read(claim: Claim, reading: Reading, setting: Setting, verdict: str) -> list[str]:
    """How a formula was read where it may be read otherwise; of a refuted one, which another
    reading may save, what its chains say, of which a witness has one link, and how the definitions
    of what it prints were read.
    """
    words = [reading.text, decimals_read(claim, reading), *reading.taken]
    if verdict != "refuted":
        return [said for said in words if said]
    # a chain that is told with its signs is not told twice
    words += [said for said in reading.chains if not any(said in t for t in reading.taken)]
    for token in claim.formula.symbols if claim.formula else ():
        entry = setting.symbols.get(token)
        definition = None if entry is None else entry.definition
        # which of several readings is meant is chosen for the setting and told there
        taken = () if definition is None else definition.readings[0].taken
        words += [f"in the definition of {token} {said}" for said in taken]
    return [said for said in words if said]


def _of_one_filter(finding: Finding, parameter: str | None) -> Finding:
    """Without the parameter of a filter in numbers, if it has one: that has one value, and no name
    in a source.
    """
    if not parameter:
        return finding
    value = rf"{re.escape(parameter)} = [^,:;]*"
    reason = re.sub(rf"at {value}:", "with", finding.reason)
    reason = re.sub(rf"{value}, ", "", reason)
    domain = finding.domain and (re.sub(rf"for {value}(, )?", "", finding.domain) or "everywhere")
    witness = finding.witness
    if witness is not None:
        point = {name: shown for name, shown in witness.point.items() if name != parameter}
        witness = replace(witness, point=point)
    return replace(finding, reason=reason, domain=domain, witness=witness)


def _attempts(
    claim: Claim, setting: Setting, environment: Environment
) -> Iterator[tuple[Reading | None, Callable[[], Finding]]]:
    readings, fault = claim_readings(claim, setting)
    if fault is not None:
        yield None, lambda: _of_dimensions(claim, fault, setting, environment)
    elif claim.formula is None:
        yield None, lambda: judge_in(claim, None, setting, environment)
    for reading in readings:
        yield (
            reading,
            lambda r=reading: judge_in(claim, r, setting, environment),  # type: ignore[misc]
        )


def _of_dimensions(claim: Claim, fault: str, setting: Setting, environment: Environment) -> Finding:
    """Refuted for its dimensions, with a point at which it fails in units of its own, if one is
    seen.
    """
    if (doubt := degrees_are_open(claim, setting)) is not None:
        raise Undecided(doubt)
    readings = () if claim.formula is None else likeliest_first(claim.formula)
    failing = [seen_to_fail(claim, r, setting, environment) for r in readings]
    if not failing or failing[0] is None or not all(failing):
        return Finding("refuted", fault, method="dimensions")
    first = failing[0]
    certificate = first.certificate
    return Finding("refuted", fault, None, "dimensions", first.witness, certificate)


def _attempt(work: Callable[[], Finding]) -> Finding:
    try:
        return work()
    except UndefinedSymbol as reason:
        return Finding("undefined", str(reason), certificate={"symbol": reason.token})
    except (Undecided, Malformed, NotEstablished) as reason:
        return Finding("undecided", str(reason))
    except (RecursionError, ArithmeticError, ValueError) as reason:  # lack of memory is no finding
        return Finding("undecided", f"the arithmetic stopped: {type(reason).__name__}: {reason}")


def holds_for_any_filter(claim: Claim, reading: Reading | None, setting: Setting) -> bool:
    """Whether a claim that is proved of a filter is proved of any numbers in place of its
    quantities too; False also where that is not known, and where the claim differentiates, since
    what a quantity changes with is a matter of the filter.
    """
    if reading is None or setting.kind not in WITH_MODEL or reading.connective != "if":
        return False
    used = reached(claim, setting)
    plain = claim.kind == EQUATIONS or (claim.kind == ORDERS and len(used) <= FEW)
    if not plain or any(n[0] == "derivative" for g in graphs_of_claim(claim) for n in g["nodes"]):
        return False
    symbols = {
        token: replace(entry, role="free", quantity=None) if entry.quantity else entry
        for token, entry in setting.symbols.items()
    }
    free = replace(setting, kind="algebra", model=None, own_model=None, symbols=symbols)
    try:
        # most are false at two points of their own: no more is asked of these
        if seen_false(claim, Convention(algebra(), free, open=False, chosen=Chosen())) is not None:
            return False
        found = judge_reading(claim, reading, Scope(free, algebra(), held=claim.held))
    except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError, ValueError):
        return False
    return found.verdict == "proved"


def cited(claim: Claim, setting: Setting) -> list[str]:
    """What is used where the claim, or a definition that it uses, takes means of normal noises."""
    if claim.formula is None:
        return []
    reach = Reach(setting.symbols)
    met = {token: None for name in claim.formula.symbols for token in (name, *reach.of(name))}
    entries = [setting.symbols[token] for token in met if token in setting.symbols]
    formulas = [claim.formula, *(e.definition for e in entries if e.definition is not None)]
    takes_means = any(
        node[:2] == ["call", "expectation"]
        for formula in formulas
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in map(list, graph["nodes"])
    )
    return [NORMAL_MEANS] if takes_means and any(e.normal for e in entries) else []
