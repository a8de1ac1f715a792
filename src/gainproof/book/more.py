"""What a site may have besides the book itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from gainproof.book.page import Page


@dataclass(frozen=True)
class More:
    """`pages`; `scripts` that they load, by name; `files`: texts by path; `front`: what the front
    page is told of them.
    """

    pages: Sequence[Page] = ()
    scripts: Mapping[str, str] = field(default_factory=dict)
    files: Mapping[str, str] = field(default_factory=dict)
    front: Mapping[str, object] = field(default_factory=dict)
