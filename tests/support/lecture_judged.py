"""The lecture's claims judged as `gainproof check` does it, once in a session."""

from __future__ import annotations

import os
from functools import cache
from typing import Any

from catalogue_subjects import prepare_all

from gainproof import judgements
from gainproof.workshop import open_workshop

LECTURE = "kosuge-slides"


@cache
def lecture_claims() -> list[dict[str, Any]]:
    """Each claim with its verdict and evidence, as plain data; nobody changes it."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        prepare_all()
    (judged,) = judgements.judge([judgements.find(LECTURE)], open_workshop(quiet=True))
    claims: list[dict[str, Any]] = judged["claims"]
    return claims
