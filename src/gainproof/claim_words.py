"""What claims without a printed formula say, in words: verdicts hold formulas only."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

Words = Mapping[str, str]


def claim_words(text: str) -> dict[str, str]:
    """The words of every claim that has no formula, by id. `text` is that of a claim file that was
    accepted.
    """
    found = {}
    for claim in tomllib.loads(text)["claims"]:
        if "latex" not in claim and "plain" not in claim:
            found[claim["id"]] = " ".join(_words(claim).split())
    return found


def _words(claim: Mapping[str, Any]) -> str:
    """Its paraphrase, or what its fields say."""
    if "text" in claim:
        return str(claim["text"])
    match claim["kind"]:
        case "monotone":
            return f"{claim['about'][0]} is {claim['trend']} in {claim['about'][1]}"
        case "location":
            return f"roots of {claim['polynomial']} in {claim['variable']}: {claim['where']}"
        case kind:
            return str(kind)
