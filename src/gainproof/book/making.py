"""The pages of the book from its contents."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType

import gainproof
from gainproof.book import document_pages, kernel_pages, list_pages, play, reference_pages, site
from gainproof.book.check_page import check_files, check_page
from gainproof.book.contents import Contents
from gainproof.book.derivation_pages import derivation_page
from gainproof.book.more import More
from gainproof.book.page import Page
from gainproof.book.source_pages import source_pages


def pages(contents: Contents, runtime: Mapping[str, bytes] = MappingProxyType({})) -> list[Page]:
    """Every page, the front page first; `runtime` as for `check_page`."""
    found = list_pages.list_pages(contents.subjects, contents.judgements, contents.versions)
    for subject, report in zip(contents.subjects, contents.reports, strict=True):
        found.append(derivation_page(subject, report, kernel_pages.links(subject)))
        found += kernel_pages.kernel_pages(subject, contents.sampled)
    judged = zip(contents.judgements, contents.said, contents.checked, strict=True)
    for judgement, said, checked in judged:
        found += source_pages(judgement, said, {name: word for name, (_, word) in checked.items()})
    found += [*reference_pages.reference_pages(), check_page(runtime)]
    return found + document_pages.document_pages(documents())


def documents() -> Path:
    """The folder of the documentation: in the package, or in the checkout that it is used from."""
    package = Path(gainproof.__file__).resolve().parent
    installed = package / "docs"
    return installed if installed.is_dir() else package.parents[1] / "docs"


def build(
    contents: Contents,
    folder: Path,
    tell: Callable[[str], None],
    more: More | None = None,
    runtime: Mapping[str, bytes] = MappingProxyType({}),
) -> dict[str, bytes]:
    """Write the site; the files that it has, by their paths."""
    more = more or More()
    front, *others = pages(contents, runtime)
    front = replace(front, data={**front.data, **more.front})
    loaded = {**scripts(contents), **more.scripts}
    made = site.files([front, *others, *more.pages], loaded, tell)
    made |= check_files(runtime)
    made.update((path, text.encode()) for path, text in more.files.items())
    site.write(made, folder)
    return made


def scripts(contents: Contents) -> dict[str, str]:
    """Texts by file name of what the pages load besides the site's own scripts."""
    found: dict[str, str] = {}
    for subject in contents.subjects:
        game = play.section(subject)
        found.update(game.scripts if game is not None else ())
    return found
