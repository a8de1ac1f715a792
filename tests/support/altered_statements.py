"""Matrix statements made false, or without one of the hypotheses that they need."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from copy import deepcopy
from typing import Any

Data = dict[str, Any]


def altered_claims(statement: Mapping[str, Any]) -> Iterator[Data]:
    """Without one hypothesis; sides of an order exchanged; one side of an equation doubled."""
    for number in range(len(statement["claim"]["given"])):
        given = [*statement["claim"]["given"]]
        del given[number]
        yield {**statement, "claim": {**statement["claim"], "given": given}}
    altered = deepcopy(dict(statement))
    claim = altered["claim"]
    if "larger" in claim:
        claim["larger"], claim["smaller"] = claim["smaller"], claim["larger"]
        yield altered
    elif "left" in claim:
        end = claim["left"]["outputs"]["value"]
        claim["left"]["nodes"].append(["add", end, end])
        claim["left"]["outputs"]["value"] = len(claim["left"]["nodes"]) - 1
        yield altered
