"""The campaigns that come with gainproof, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from gainproof.campaign import float32, float64
from gainproof.campaign.campaign import Campaign


@dataclass(frozen=True)
class Entry:
    """What a campaign does, and the campaign of what is asked for, by names; of all without."""

    title: str
    build: Callable[[Sequence[str]], Campaign]


CAMPAIGNS: Mapping[str, Entry] = {
    "float32": Entry(float32.TITLE, float32.campaign),
    "float64": Entry(float64.TITLE, float64.campaign),
}
