"""A page of the site before it is set: where it lies, what it says and what it is found by."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Finding:
    """An entry of the search index: `title` is what is shown, `words` what else finds it, `anchor`
    the place on its page.
    """

    title: str
    words: str = ""
    anchor: str = ""


@dataclass(frozen=True)
class Page:
    """One file of the site.

    `path` is relative to the site's folder; `template` and `data` make its content; `findings` go
    into the search index; `scripts` are files of the site that it loads; `language` is a language
    of `book.words`, and `versions` are the paths of the same page by language.
    """

    path: str
    title: str
    kind: str
    template: str
    data: Mapping[str, Any]
    findings: tuple[Finding, ...] = ()
    scripts: tuple[str, ...] = ()
    language: str = "en"
    versions: Mapping[str, str] = field(default_factory=dict)

    def to(self, path: str) -> str:
        """The link from this page to a path of the site, which may have an anchor."""
        return posixpath.relpath(path, posixpath.dirname(self.path) or ".")
