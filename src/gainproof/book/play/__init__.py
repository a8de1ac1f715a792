"""What a reader can move on a derivation's page."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derived import Derived


@dataclass(frozen=True)
class Play:
    """`html`: a fragment of the page; `scripts`: names and texts of the scripts that it needs."""

    html: str
    scripts: tuple[tuple[str, str], ...]


def section(derived: Derived) -> Play | None:
    """Nothing yet."""
    del derived
    return None
