"""Certificates of verdicts as files, to be decided without the judge; which verdicts have none."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from gainproof.bad_input import BadInputError
from gainproof.files import atomic_file, places
from gainproof.verify import check_matrices, check_memory
from gainproof.verify.judge.answer_certificate import NoCertificateError, answer_certificate

WITHOUT = "without.txt"
"""In a folder of certificates: claims that have none, and why."""
DECIDED = "decided by `python -m gainproof.verify.check_answer`, or a copy of it"
OTHERS = {check_matrices.FORMAT: "check_matrices", check_memory.FORMAT: "check_memory"}
"""Other files by the format of what they decide."""


def certificate_text(claim: Mapping[str, Any], formula: str = "") -> str:
    """The certificate of a claim as the text of a file; `formula`: as it was typed if that is not
    the claim's. Raises NoCertificateError.
    """
    found = answer_certificate(claim, formula)
    lines = ",\n".join(json.dumps(line, ensure_ascii=False) for line in found["lines"])
    head = json.dumps({name: part for name, part in found.items() if name != "lines"})
    return f'{head[:-1]}, "lines": [\n{lines}\n]}}\n'


def write(path: Path, text: str) -> None:
    """Raises BadInputError where it cannot be written."""
    try:
        atomic_file.write_text(path, text)
    except OSError as error:
        reason = error.strerror or error
        raise BadInputError(f"{places.shown(path)}: cannot be written: {reason}") from None


def write_folder(folder: Path, judged: Sequence[Mapping[str, Any]]) -> str:
    """FOLDER/SOURCE-claims/CLAIM.json for each claim that has a certificate, and a list of settled
    ones that have none; what to tell, by verdict and kind. Raises BadInputError.
    """
    settled, written = Counter[tuple[str, str]](), Counter[tuple[str, str]]()
    without = []
    for judgement in judged:
        key = judgement["source"]["key"]
        for claim in judgement["claims"]:
            sort = claim["verdict"], claim["kind"]
            if sort[0] not in ("proved", "refuted", "conditional"):
                continue
            settled[sort] += 1
            try:
                text = certificate_text(claim)
            except NoCertificateError as reason:
                without.append(f"{key} {claim['id']} ({', '.join(sort)}): {reason}"[:300])
                continue
            written[sort] += 1
            source, name = (quote(word, safe="") for word in (key, claim["id"]))
            write(folder / f"{source}-claims" / f"{name}.json", text)
    write(folder / WITHOUT, "".join(f"{line}\n" for line in without))
    lines = [
        f"  {' '.join(sort):<25}{written[sort]:>5} of {count}"
        for sort, count in sorted(settled.items(), key=lambda item: (-item[1], item[0]))
    ]
    total = f"certificates: {sum(written.values())} of {sum(settled.values())} settled claims"
    head = f"{total}, in {places.shown(folder)}; by verdict and kind:"
    others = "those about matrices of any size by check_matrices, about memories by check_memory"
    return "\n".join([head, *lines, f"{DECIDED};", others])


def write_one(name: str, claim: Mapping[str, Any], formula: str) -> str:
    """The certificate of one claim in a file of this name; what to tell. Raises BadInputError."""
    path = Path(name)
    try:
        text = certificate_text(claim, formula)
    except NoCertificateError as reason:
        raise BadInputError(f"no certificate: {reason}") from None
    write(path, text)
    other = next(
        (file for name, file in OTHERS.items() if f'"{name}"' in text[:80]), "check_answer"
    )
    decided = DECIDED.replace("check_answer", other)
    return f"certificate: {places.shown(path)}, {decided}"
