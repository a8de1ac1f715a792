"""Links of the site that lead nowhere."""

from __future__ import annotations

import html
import posixpath
import re
from collections.abc import Mapping
from urllib.parse import unquote

_TAG = re.compile(rb"<[a-z][^>]*>")
_NAMED = re.compile(rb'\s(id|href|src)="([^"]*)"')


def broken(files: Mapping[str, bytes]) -> tuple[int, list[str]]:
    """How many links there are within the site, and `page: link` of each without a target."""
    anchors: dict[str, set[str]] = {}
    links: list[tuple[str, str]] = []
    for path, content in files.items():
        if not path.endswith(".html"):
            continue
        anchors[path] = set()
        for tag in _TAG.findall(content):
            for name, value in _NAMED.findall(tag):
                text = html.unescape(value.decode())
                if name == b"id":
                    anchors[path].add(text)
                else:
                    links.append((path, text))
    inner = [(path, link) for path, link in links if not re.match(r"[a-z]+:", link)]
    wrong = [f"{path}: {link}" for path, link in inner if not _leads(path, link, files, anchors)]
    return len(inner), wrong


def _leads(
    path: str, link: str, files: Mapping[str, bytes], anchors: Mapping[str, set[str]]
) -> bool:
    """Whether there is what a link of a page leads to."""
    place, _, anchor = unquote(link).partition("#")
    target = posixpath.normpath(posixpath.join(posixpath.dirname(path), place)) if place else path
    if target not in files:
        return False
    return not anchor or anchor in anchors.get(target, set())
