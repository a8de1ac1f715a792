"""Claims about filters with free gains: decided over coordinates of the stable filters where these
prove it, else in the gains themselves.
"""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.catalogue import judge_reading
from gainproof.verify.judge.reader.latex_printer import relations_to_latex
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.verdict import Finding

CHARTED = ("identity", "inequality", "recursion", "implication", "equivalence")
ABOUT_STABILITY = ("stability", "optimum", "ordering")
STABLE = "wherever the filter is stable"


def judge_free(
    claim: Claim, reading: Reading | None, setting: Setting, environment: Environment
) -> Finding:
    """The finding on one reading. Raises Undecided, UndefinedSymbol, Malformed.

    Only what speaks of a steady quantity is about stable filters alone; all else is decided for
    all gains.
    """
    scope = Scope(setting, environment, held=claim.held)
    if environment.region is None or reading is None or claim.kind not in CHARTED:
        return _in_gains(claim, reading, scope)
    relations = (*reading.relations, *reading.conditions)
    if any(relation.operator == "->" for relation in relations):
        return _in_gains(claim, reading, scope)
    for relation in (*relations, *[r for f in claim.given for r in f.readings[0].relations]):
        scope.relations(relation)
    if not scope.uses_steady():
        return judge_reading(claim, reading, Scope(setting, environment, held=claim.held))
    try:
        chart = environment.region.charted
        found = judge_reading(claim, reading, Scope(setting, chart, held=claim.held))
    except Undecided:
        found = None
    if found is not None and found.verdict == "proved":
        return replace(found, domain=_domain(claim, reading))
    try:
        plain = _in_gains(claim, reading, Scope(setting, environment, held=claim.held))
    except Undecided:
        if found is None:
            raise
        return found
    settled = plain.verdict in ("proved", "refuted", "conditional")
    return plain if settled or found is None else found


def _in_gains(claim: Claim, reading: Reading | None, scope: Scope) -> Finding:
    """The finding over all gains, or over the stable ones where it speaks of what only these have,
    which is then said.
    """
    found = judge_reading(claim, reading, scope)
    told = claim.kind not in ABOUT_STABILITY and found.domain not in (None, "nowhere")
    if told and scope.uses_steady():
        return replace(found, domain=f"{found.domain}, {STABLE}")
    return found


def _domain(claim: Claim, reading: Reading) -> str:
    """Where it was proved, in words and in the source's symbols."""
    stated = list(claim.domain)
    if reading.connective == "if":
        stated += reading.conditions
    told = [relations_to_latex([relation]) for relation in stated]
    told += [relations_to_latex(f.readings[0].relations) for f in claim.given]
    return ", ".join([STABLE, *told])
