"""What the book is made of, asked of the same places as `gainproof run` asks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.book import kernel_pictures
from gainproof.claims import judgements
from gainproof.claims.claim_proofs import checked
from gainproof.claims.source_words import Said, claims_said
from gainproof.files import places
from gainproof.jobs import code_digest
from gainproof.jobs.session import Session
from gainproof.subjects import derivations
from gainproof.subjects.derived import Derived
from gainproof.verdicts import verdict_snapshot
from gainproof.verdicts.verdict_snapshot import Judgement
from gainproof.verification.findings import ahead, committed


@dataclass(frozen=True)
class Contents:
    """`reports`: the checker's on the committed certificate of each subject; `said`: what the file
    of each judgement says of its claims beside the formulas; `checked`: whether the certificate of
    each of its claims leads to the verdict again, and a sentence on it; `sampled`: values and
    errors of kernels by module and name.
    """

    versions: Mapping[str, str]
    subjects: Sequence[Derived]
    reports: Sequence[Mapping[str, Any]]
    judgements: Sequence[Judgement]
    said: Sequence[Mapping[str, Said]]
    checked: Sequence[Mapping[str, tuple[bool, str]]]
    sampled: Mapping[str, Mapping[str, Any]]


def gather(session: Session) -> Contents:
    """Everything, derived, checked and judged where that is not known already.

    Raises BadInputError where an accident kept a claim from being judged.
    """
    folder, files = places.generated_folder(), places.claim_files()
    ahead(session, folder, files)
    subjects = derivations.derive(derivations.catalogue(), session)
    pairs = [(committed(folder, subject.name), subject) for subject in subjects]
    judged = judgements.judge(files, session)
    missing = [why for each in judged for why in verdict_snapshot.accidents(each).values()]
    if missing:
        raise BadInputError(f"not judged, by accident: {missing[0]}; make the book again")
    asked = [job for subject in subjects for job in kernel_pictures.jobs(subject)]
    sampled = session.results("pictures of kernels", asked)
    return Contents(
        versions=code_digest.versions(),
        subjects=subjects,
        reports=derivations.recheck(pairs, session),
        judgements=judged,
        said=[claims_said(judgements.read(file)) for file in files],
        checked=[{claim["id"]: checked(claim) for claim in each["claims"]} for each in judged],
        sampled={job.label: found for job, found in zip(asked, sampled, strict=True)},
    )
