"""What the book is made of, asked of the same places as `gainproof run` asks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof import code_digest, derivations, judgements, places
from gainproof.claim_words import Words, claim_words
from gainproof.derived import Derived
from gainproof.everything import DONE, committed, following
from gainproof.verdicts import Judgement
from gainproof.workshop import Workshop


@dataclass(frozen=True)
class Contents:
    """`reports`: the checker's on the committed certificate of each subject; `words`: those of
    claims without a formula, for each judgement.
    """

    versions: Mapping[str, str]
    subjects: Sequence[Derived]
    reports: Sequence[Mapping[str, Any]]
    judgements: Sequence[Judgement]
    words: Sequence[Words]


def gather(shop: Workshop) -> Contents:
    """Everything, derived, checked and judged where that is not known already."""
    folder, files = places.generated_folder(), places.claim_files()
    shop.ahead([derivations.CATALOGUE], following(shop, folder, files), DONE)
    subjects = derivations.derive(derivations.catalogue(shop), shop)
    pairs = [(committed(folder, subject.name), subject) for subject in subjects]
    return Contents(
        versions=code_digest.versions(),
        subjects=subjects,
        reports=derivations.recheck(pairs, shop),
        judgements=judgements.judge(files, shop),
        words=[claim_words(judgements.read(file)) for file in files],
    )
