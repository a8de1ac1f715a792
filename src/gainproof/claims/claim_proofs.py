"""Proofs of claims, gone through again from their certificates alone.

Proofs on matrices of every size are decided by the checker of certificates, which shares nothing
with the judge that found them. That the statements are those of the claim, and that a lemma is what
a later part supposes, is the judge's own reading. Other proofs and refutations are replayed by the
judge's code.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from typing import Any

from gainproof.verify.certificate.matrix_words.proof import rejected

Plain = Mapping[str, Any]
WORDS = "words"


def parts(certificate: Plain | None) -> Iterator[tuple[str, Plain]]:
    """What holds the proofs in words of one claim: {"words": lemmas and then what was to be proved,
    "claims": the id of the claim in whose proof each was needed first}; with the name of its
    direction where the claim has several.
    """
    for name, part in (("", certificate), *(certificate or {}).items()):
        if isinstance(part, Mapping) and WORDS in part:
            yield name, part


def _proofs(claim: Plain) -> list[Plain]:
    return [proof for _, part in parts(claim["evidence"]["certificate"]) for proof in part[WORDS]]


def to_recheck(judgement: Plain) -> dict[str, Any] | None:
    """What `recheck` asks of a judged claim file; None for one without proofs in words."""
    claims = [
        {"id": claim["id"], "evidence": {"method": method, "certificate": certificate}}
        for claim in judgement["claims"]
        for method in [claim["evidence"]["method"]]
        for certificate in [claim["evidence"]["certificate"]]
        if method == WORDS or any(parts(certificate))
    ]
    return {"source": {"key": judgement["source"]["key"]}, "claims": claims} if claims else None


def recheck(judgement: Plain) -> dict[str, Any]:
    """{"source", "claims", "statements", "rejected": [{"id", "reason"}], "seconds"}: the proofs in
    words of a judged claim file, each decided again.
    """
    start = time.process_time()
    claims = statements = 0
    wrong: list[dict[str, str]] = []
    for claim in judgement["claims"]:
        proofs = _proofs(claim)
        found = [rejected(proof) for proof in proofs]
        reasons = [reason for reason in found if reason is not None]
        claims += bool(proofs)
        if not reasons:
            statements += sum(len(proof["statements"]) for proof in proofs)
        if not proofs and claim["evidence"]["method"] == WORDS:
            reasons.append("there is no proof")
        wrong += [{"id": claim["id"], "reason": reason} for reason in reasons[:1]]
    return {
        "source": judgement["source"]["key"],
        "claims": claims,
        "statements": statements,
        "rejected": wrong,
        "seconds": time.process_time() - start,
    }


DECIDED = ("proved", "refuted", "conditional")
NOT_AGAIN = "no: "
"""How the sentence begins on a certificate without a statement that could be decided again."""


def checked(claim: Plain) -> tuple[bool, str]:
    """Whether the certificate of a claim of `check --json` leads to its verdict again, and a
    sentence on it; none of a claim that is neither proved nor refuted.
    """
    proofs = _proofs(claim)
    if proofs:
        reasons = [reason for reason in map(rejected, proofs) if reason is not None]
        if reasons:
            return False, f"REJECTED by the checker of certificates: {reasons[0]}"
        count = sum(len(proof["statements"]) for proof in proofs)
        said = f"{count} statement{'' if count == 1 else 's'}"
        return True, f"again by the checker of certificates: {said} accepted"
    from gainproof.verify.judge.replay import replay_json, statements_of

    if not statements_of(claim["evidence"]["certificate"] or {}):
        return True, NOT_AGAIN + _not_again(claim) if claim["verdict"] in DECIDED else ""
    reason = replay_json(claim)
    if reason is not None:
        return False, f"REJECTED when replayed: {reason}"
    return True, "replayed from its certificate: the same verdict"


def _not_again(claim: Plain) -> str:
    """Why there is nothing to replay."""
    evidence = claim["evidence"]
    if evidence["method"] == "dimensions":
        return "the dimensions decide, and nothing is left to be decided between numbers"
    if evidence["method"] == "shapes":
        return "the shapes of the letters decide, and nothing is left to be decided between numbers"
    if claim["verdict"] == "refuted" and evidence["witness"]:
        return "the counterexample decides, and it can be put into the formula by hand"
    return "such a proof is not kept as a statement that could be decided again"
