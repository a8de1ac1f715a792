"""Claims of the lecture and of other sources judged as `gainproof check` does it, once in a
session, or by `gainproof run` before it: the user's cache holds what this code makes of them.
"""

from __future__ import annotations

import os
from functools import cache
from typing import Any

from catalogue_subjects import prepare_all, take_over

from gainproof.claims import judgements
from gainproof.jobs.session import open_session

LECTURE = "kosuge-slides"


def lecture_claims() -> list[dict[str, Any]]:
    """Each claim with its verdict and evidence, as plain data; nobody changes it."""
    return claims_of(LECTURE)


@cache
def claims_of(source: str) -> list[dict[str, Any]]:
    """The same for a claim file of gainproof by its key."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        prepare_all()
    session = open_session(quiet=True)
    take_over("trial", session.cache)
    (judged,) = judgements.judge([judgements.find(source)], session)
    claims: list[dict[str, Any]] = judged["claims"]
    return claims
