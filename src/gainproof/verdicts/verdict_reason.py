"""Why a claim has its verdict, in a sentence or two."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.verdicts import witness_text
from gainproof.verify.judge.verdict_words import (
    ALONE,
    CONTRADICTED,
    DECIDES,
    NO_REPAIR,
    OTHERS,
    ROUNDED,
    STRENGTH,
)

Claim = Mapping[str, Any]

ANY_FILTER = "holds whatever the filter is: it follows from the file's own definitions"
DECIDED_AS_STATED = frozenset({"proved", "definition"})


def reasons(claim: Claim) -> list[str]:
    """What a reader has to know besides the verdict; nothing for a claim that is simply true."""
    where = where_true(claim)
    found = [where] if where else []
    if claim["reading"]:
        found.append(f"read so that {claim['reading']}")
    if claim.get("any_filter"):
        found.append(ANY_FILTER)
    why = reason(claim)
    if why:
        found.append(why)
    certificate = claim["evidence"]["certificate"] or {}
    if ROUNDED in certificate:
        found.append(certificate[ROUNDED])
    if ALONE in certificate:
        found.append(f"{ALONE}: {certificate[ALONE]}; not all claims of its setting are")
    strength = [f"{STRENGTH} {certificate[STRENGTH]}"] if certificate.get(STRENGTH) else []
    return found + repaired(claim) + solutions(claim) + strength


def where_true(claim: Claim) -> str:
    """Where a claim is true that is not true everywhere, or under what; empty for any other."""
    if claim["verdict"] != "conditional" or not claim["domain"]:
        return ""
    on = f"({claim['domain']})"
    if _is_proved_by_itself(claim):
        named = f" under {claim['convention']}" if claim["convention"] else ""
        return f"true{named} {on}; other claims of its setting want another choice"
    if not is_contradicted(claim):
        return f"true on a part only {on}"
    # true everywhere under a convention: the reason says under which
    part = "" if claim["domain"] == "everywhere" else f" {on}"
    return f"true under another convention{part}; not as the conventions are stated"


def domain(claim: Claim) -> str:
    """Where a claim was decided or holds; empty where it holds nowhere: that its verdict says."""
    return "" if claim["domain"] in (None, "nowhere") else str(claim["domain"])


def is_contradicted(claim: Claim) -> bool:
    """Whether it is true, with its setting, under another convention than the source states."""
    return CONTRADICTED in (claim["evidence"]["certificate"] or {})


def _is_proved_by_itself(claim: Claim) -> bool:
    """Whether only the other claims stand against it, which fit no convention that it fits."""
    evidence = claim["evidence"]
    # with a witness it is a part of the domain that stands against it
    decides = (evidence["certificate"] or {}).get(DECIDES)
    return decides == "proved" and evidence["witness"] is None


def repairs_of(claim: Claim) -> Sequence[Mapping[str, Any]]:
    """The nearest true formulas, the likeliest first, unless the claim comes with something better:
    where an inequality is true says more than another inequality.
    """
    if claim["verdict"] == "conditional" and claim["kind"] == "inequality":
        return ()
    one = claim["repair"]
    repairs: Sequence[Mapping[str, Any]] = claim.get("repairs") or ([one] if one else [])
    return [{"changes": [], "under": "", **repair} for repair in repairs]


def repaired(claim: Claim) -> list[str]:
    """The nearest true formulas with what was changed, or that none was found, and what is true."""
    repairs = repairs_of(claim)
    if not repairs:
        missing = claim["verdict"] == "refuted" and NO_REPAIR in str(claim["reason"])
        told = [NO_REPAIR] if missing and NO_REPAIR not in reason(claim) else []
        return told + truth(claim)
    return [
        f"{'as near' if number else 'nearest true formula'}: {repair['latex']} "
        f"({'; '.join([verdict_of_repair(repair), *repair['changes']])})"
        for number, repair in enumerate(repairs)
    ]


def truth(claim: Claim) -> list[str]:
    """What the formula should say, where no misprint explains it."""
    return [f"what is true: {claim['truth']}"] if claim.get("truth") else []


def verdict_of_repair(repair: Mapping[str, Any]) -> str:
    """`proved`, with the convention under which it is, if that was left open."""
    under = f" under {repair['under']}" if repair["under"] else ""
    return f"{repair['verdict']}{under}"


def reason(claim: Claim) -> str:
    """The ground of a verdict that is not simply `proved`: the witness, if there is one."""
    witness = claim["evidence"]["witness"]
    if isinstance(witness, Mapping):
        dimensions = f"{claim['reason']}; " if claim["evidence"]["method"] == "dimensions" else ""
        return f"{_against(claim, witness)}{dimensions}{witness_text.in_words(witness)}"
    if claim["verdict"] in DECIDED_AS_STATED:
        return ""
    if claim["verdict"] == "undefined" and solutions(claim):
        return ""
    return str(claim["reason"] or "")


def solutions(claim: Claim, places: Mapping[str, str] | None = None) -> list[str]:
    """Undefined symbols whose meaning the other claims fix, told by their places in the source if
    these are given, else by their ids; a solution that no claim bears out is told by the reason.
    """
    named = places or {}
    return [
        f"{entry['solution']}, fixed by "
        + ", ".join(str(named.get(n, n)) for n in entry["consumed"])
        for entry in claim["undefined"]
        if entry["consumed"]
    ]


def _against(claim: Claim, witness: Mapping[str, Any]) -> str:
    """Under which of several conventions the witness was found, if the claim fits none of them."""
    certificate = claim["evidence"]["certificate"] or {}
    others = certificate.get(OTHERS, {})
    name = next((name for name, other in others.items() if other == witness), None)
    if claim["verdict"] != "refuted" or name is None:
        return ""
    if len(others) == 1:
        return f"{name}: "
    return f"fits none of {len(others)} conventions; with {name}, "
