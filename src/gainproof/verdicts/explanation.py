"""The whole proof or witness of one claim as a page a reader can follow."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.claims.claim_proofs import parts as words_of
from gainproof.terminal_text import WIDTH, filled
from gainproof.verdicts import witness_text
from gainproof.verdicts.proof_text import proof_lines, result_lines
from gainproof.verdicts.verdict_reason import (
    ANY_FILTER,
    domain,
    reason,
    repairs_of,
    solutions,
    truth,
    verdict_of_repair,
)
from gainproof.verify.judge.explanation import sections
from gainproof.verify.judge.verdict_words import OTHERS

Claim = Mapping[str, Any]
_LABEL = 12


def explanation(claim: Claim, columns: int = WIDTH, words: str = "", checked: str = "") -> str:
    """Text for a claim in the form of `check --json`: what was shown, on what ground, and where it
    fails; nothing twice. `words` are those of a claim without a formula, `checked` says what came
    of its certificate when it was gone through again.
    """
    lines = [f"{claim['id']}: {claim['verdict']}"]
    lines += filled(
        " ".join((claim["latex"] or words or claim["kind"]).split()), "  ", "    ", columns
    )
    lines.append("")
    for label, value in _facts(claim, checked):
        lines += filled(value, f"{label + ':':<{_LABEL}}", " " * _LABEL, columns)
    for title, inner in parts(claim):
        lines += ["", title[0].upper() + title[1:]]
        for line in inner:
            indent = " " * (len(line) - len(line.lstrip()) + 2)
            lines += filled(line.strip(), indent, indent + "    ", columns)
    return "\n".join(lines) + "\n"


def parts(claim: Claim) -> list[tuple[str, list[str]]]:
    """Counterexample, nearest true formula, proof and what else there is, each a title with its
    lines, whose blanks at the beginning set them in.
    """
    certificate: Mapping[str, Any] = claim["evidence"]["certificate"] or {}
    witness = claim["evidence"]["witness"]
    found = [
        ("Counterexample", witness_text.in_full(witness) if witness else []),
        ("Nearest true formula", _repairs(claim)),
    ]
    found += [(section.title, list(section.lines)) for section in sections(certificate)]
    found += _in_words(claim)
    others = certificate.get(OTHERS, {})
    found.append(("Fails under other conventions", _others(others, witness)))
    return [(title, lines) for title, lines in found if lines]


def _in_words(claim: Claim) -> list[tuple[str, list[str]]]:
    """The proofs on matrices of every size: lemmas, and what was to be proved; of other claims that
    are used only what they say, as each has a page of its own.
    """
    found = []
    for name, part in words_of(claim["evidence"]["certificate"]):
        way = f"direction {name}: " if name else ""
        proofs = list(zip(part["claims"], part["words"], strict=True))
        last = {owner: number for number, (owner, _) in enumerate(proofs)}
        own = [number for number, (owner, _) in enumerate(proofs) if owner in ("", claim["id"])]
        for number, (owner, proof) in enumerate(proofs):
            if number in own:
                place = own.index(number) + 1
                title = "proof" if place == len(own) else f"lemma {place}"
                found.append((f"{way}{title}, for matrices of every size", proof_lines(proof)))
            elif last[owner] == number:
                found.append((f"{way}claim {owner}, used here", result_lines(proof)))
    return found


def _facts(claim: Claim, checked: str) -> list[tuple[str, str]]:
    """Short facts; the result is left out where a section below says it."""
    shown_below = isinstance(claim["evidence"]["witness"], Mapping)
    result = "" if shown_below else (reason(claim) or str(claim["reason"] or ""))
    found = (
        ("place", claim["place"]),
        ("convention", claim["convention"]),
        ("reading", claim["reading"]),
        ("domain", domain(claim)),
        ("method", claim["evidence"]["method"]),
        ("checked", checked),
        ("result", ANY_FILTER if claim.get("any_filter") else result),
        *(("undefined", text) for text in solutions(claim)),
    )
    return [(label, str(value)) for label, value in found if value]


def _repairs(claim: Claim) -> list[str]:
    lines = []
    for repair in repairs_of(claim):
        lines += [repair["latex"], *(f"  {change}" for change in repair["changes"])]
        lines.append(f"  {verdict_of_repair(repair)}")
    return lines or truth(claim)


def _others(others: Mapping[str, Any], witness: Any) -> list[str]:
    """One line for each convention that does not fit, the one shown above left out."""
    lines = []
    for name, other in others.items():
        if isinstance(other, str):
            lines.append(f"{name}: {other}")
        elif other != witness:
            lines.append(f"{name}: {witness_text.in_words(other)}")
    return lines
