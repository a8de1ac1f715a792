"""Quantities of which each fixes the others."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.exact.functions import refuse_jumps
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.kinds.claim_domain import framed
from gainproof.verify.judge.kinds.kind import Kind, OwnFields
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding, finding_of

MOST_ABOUT = 20


def _about(claim: OwnFields, name: str) -> OwnField:
    about = tuple(claim.token(name, text) for text in claim.fields.texts(name, MOST_ABOUT))
    if len(set(about)) < 2:
        problem = "two symbols or more are wanted, each of which fixes the rest"
        raise claim.fields.fail(name, problem)
    return OwnField(symbols=about)


def judge_determines(claim: Claim, reading: Reading, scope: Scope) -> Finding:  # noqa: ARG001  # the signature of all kinds
    """Each of the quantities fixes the others: each is strictly monotone in the one parameter of
    the setting, for any given values of the other symbols.
    """
    parameter = scope.environment.parameter
    if parameter is None:
        raise Undecided("no model with one parameter")
    found: list[Finding] = []
    about = claim.own["about"].symbols
    for token in about:
        value = number_of(scope.symbol(token))
        refuse_jumps(value)
        slope = differentiated(value, parameter)
        frame = framed(claim, scope)
        if frame.conditions:
            raise Undecided("a domain that is no interval of the parameter")
        for operator in (">", "<"):
            rel = Rel(operator, slope, number(0))
            outcome = frame.decide(Statement((rel,), needed=(value,)))
            if outcome.verdict == "proved":
                found.append(finding_of(outcome))
                break
        else:
            raise Undecided(f"{token} is not strictly monotone in the parameter of the setting")
    certificate = {token: dict(f.certificate) for token, f in zip(about, found, strict=True)}
    method = "each quantity is strictly monotone in the one parameter, so each fixes all others"
    return replace(found[0], method=method, certificate=certificate)


DETERMINES = Kind(
    "determines",
    "each of several quantities fixes the others, everything else but the tracking index being "
    "given",
    judge_determines,
    own={"about": _about},
    own_words="`about`: the list of symbols",
    needs_formula=False,
    needs_text=True,
    of_setting=True,
)
