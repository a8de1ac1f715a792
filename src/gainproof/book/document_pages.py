"""Pages of docs/ as pages of the site: Markdown with mathematics and code."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token
from markupsafe import Markup, escape

from gainproof.book import reference_pages
from gainproof.book.highlighted import highlighted
from gainproof.book.page import Finding, Page


@dataclass(frozen=True)
class Part:
    """A part of the documentation: what it is for, and the names of its pages."""

    title: str
    names: tuple[str, ...]


PARTS = (
    Part(
        "Is this formula right?",
        ("ask", "check-a-formula", "claim-files", "reader", "conventions-and-repairs"),
    ),
    Part("Which gains do I take?", ("design", "steady", "position-and-velocity", "time-varying")),
    Part("Where does it come from?", ("follow-a-derivation", "edit-a-page", "lecture-figures")),
    Part("Code for it?", ("generate", "own-models", "stable-forms", "use-kernels")),
    Part("Radar coordinates?", ("coordinates", "converted-measurements")),
    Part("Where are the targets?", ("locate", "track")),
    Part(
        "Why should I believe it?",
        ("what-proved-rests-on", "certify", "stability-policy", "moved", "history"),
    ),
)
"""The pages in the order of a user's questions."""


def address(name: str) -> str:
    """Where a page of the documentation lies."""
    return f"documents/{name}.html"


def document_pages(folder: Path) -> list[Page]:
    """The pages of a folder of Markdown files, and then the list of them."""
    texts = {path.stem: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.md"))}
    titles = {name: text.partition("\n")[0].lstrip("# ") for name, text in texts.items()}
    pages = [
        Page(
            path=address(name),
            title=titles[name],
            kind="document",
            template="document.html",
            data={"body": rendered(text, set(texts))},
            findings=_findings(titles[name], text),
        )
        for name, text in texts.items()
    ]
    return [*pages, _list(titles)]


def _list(titles: Mapping[str, str]) -> Page:
    placed = {name for part in PARTS for name in part.names}
    parts = [*PARTS, Part("More", tuple(name for name in titles if name not in placed))]
    return Page(
        path="documents/index.html",
        title="Documentation",
        kind="list",
        template="documents.html",
        data={
            "parts": [
                (
                    part.title,
                    [(titles[name], address(name)) for name in part.names if name in titles],
                )
                for part in parts
            ]
            + [("Python interface", _interface())]
        },
    )


def _interface() -> list[tuple[str, str]]:
    """Modules with their names, and the kernels."""
    modules = [(name, reference_pages.address(name)) for name in reference_pages.MODULES]
    return [*modules, ("gainproof.generated: all kernels", "kernels/index.html")]


def rendered(text: str, names: set[str]) -> Markup:
    """Markdown as HTML: code coloured, headings with anchors, links between pages kept. HTML in the
    text is shown as it is written.
    """
    reader = MarkdownIt("commonmark", {"html": False}).enable("table")
    tokens = reader.parse(text)
    _anchors(tokens)
    for token in tokens:
        if token.children:
            token.children = _linked(token.children, names)

    def fence(
        self: object, tokens: Sequence[Token], place: int, options: object, env: object
    ) -> str:
        del self, options, env
        return str(highlighted(tokens[place].content, tokens[place].info.split(" ")[0]))

    reader.add_render_rule("fence", fence)
    html = reader.renderer.render(tokens, reader.options, {})
    # a table that is wider than the page scrolls in its own box
    html = html.replace("<table>", '<div class="wide" tabindex="0"><table>')
    return Markup(html.replace("</table>", "</table></div>"))


def slug(title: str) -> str:
    """A heading as an anchor, as repositories show it: links in the pages work there too."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def _anchors(tokens: Sequence[Token]) -> None:
    for token, text in pairwise(tokens):
        if token.type == "heading_open":
            token.attrSet("id", slug(text.content))


def _linked(tokens: Sequence[Token], names: set[str]) -> list[Token]:
    """Links to other pages and to the outside; those to files of the repository, which the site
    does not have, are plain text.
    """
    found, opened = [], list[bool]()
    for token in tokens:
        if token.type == "link_open":
            target = _target(str(token.attrGet("href")), names)
            opened.append(target is not None)
            if target is not None:
                token.attrSet("href", target)
        if token.type not in ("link_open", "link_close") or opened[-1]:
            found.append(token)
        if token.type == "link_close":
            opened.pop()
    return found


def _target(href: str, names: set[str]) -> str | None:
    """What a link leads to on the site, None for a file that it does not have."""
    file, _, anchor = href.partition("#")
    if not file or re.match(r"https?://", file):
        return href
    name = posixpath.basename(file).removesuffix(".md")
    if not file.endswith(".md") or name not in names:
        return None
    return f"{name}.html" + (f"#{anchor}" if anchor else "")


def _findings(title: str, text: str) -> tuple[Finding, ...]:
    """The page, and each of its headings with what stands below it."""
    parts = re.split(r"^#+ (.*)$", text, flags=re.MULTILINE)
    return tuple(
        Finding(
            title if place == 1 else f"{title}: {heading}",
            str(escape(" ".join(words.split())[:300])),
            "" if place == 1 else slug(heading),
        )
        for place, heading, words in zip(
            range(1, len(parts), 2), parts[1::2], parts[2::2], strict=True
        )
    )
