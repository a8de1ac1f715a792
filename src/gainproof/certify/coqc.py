"""The lemmas of a certificate put before coqc."""

from __future__ import annotations

import re
from collections import Counter

from gainproof.certify import coq, external
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements, towers
from gainproof.certify.subjects import Subject

NAME, PROGRAM = "coq", "coqc"
_PLACE = re.compile(r'File "[^"]*", line (\d+)')


def certify(subject: Subject, limit: float) -> Outcome:
    """coqc reads lemma after lemma and stops at the first that it does not accept."""
    certificate = subject.certificate
    only = subject.only
    every = [each for each in statements(certificate) if only is None or each.id in only]
    chosen = [statement for statement in every if statement.goals]
    text, owners = coq.script(chosen, towers(certificate))
    answer = external.Answer(0, "", 0.0)
    if chosen:
        answer = external.ask([PROGRAM, "-q", "-noglob"], "certificate.v", text, limit)
    rejected, accepted = "", len(chosen) if answer.status == 0 else 0
    if answer.status:
        place = _PLACE.search(answer.text)
        line = int(place[1]) - 1 if place else 0
        said = " ".join(answer.text.split("Error:")[-1].split())
        rejected = f"{owners[line] or 'the file'}: {said[:200]}"
        accepted = len(set(owners[:line]) - {"", owners[line]})
    left_out = Counter(statement.left_out for statement in every if statement.left_out)
    return Outcome(
        subject.name,
        NAME,
        len(chosen),
        accepted,
        answer.seconds,
        rejected,
        answer.status is None,
        left_out,
    )
