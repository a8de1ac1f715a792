"""A page for each kernel: signature, domain, proved bound, source, and what it looks like."""

from __future__ import annotations

import ast
import importlib
import inspect
import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

from markupsafe import Markup

from gainproof.book.highlighted import highlighted
from gainproof.book.kernel_pictures import pictures
from gainproof.book.page import Finding, Page
from gainproof.book.plain_formulas import coded, set_line
from gainproof.book.written_signature import written_signature
from gainproof.subjects.derived import Derived

_NAMED = re.compile(r"(?!Source: )[`\w]+: ")
_WRITTEN = (
    (re.compile(r"(?<=\d) \* (?=2\^)"), " \N{MULTIPLICATION SIGN} "),
    (re.compile(r"\b2\^(-?\d+)"), r"2<sup>\1</sup>"),
    (re.compile(r"&lt;="), "\N{LESS-THAN OR EQUAL TO}"),
)
"""What is shown for what docstrings write, in HTML."""


@dataclass(frozen=True)
class KernelLink:
    """A kernel as others point to it."""

    name: str
    summary: str
    path: str


def address(module: str, kernel: str) -> str:
    """Where the page of a kernel lies."""
    return f"kernels/{module}.{kernel}.html"


def links(derived: Derived) -> list[KernelLink]:
    """The kernels of a subject."""
    return [
        KernelLink(each["name"], each["summary"], address(each["module"], each["name"]))
        for each in derived.kernels
    ]


def kernel_pages(derived: Derived, sampled: Mapping[str, Mapping[str, Any]]) -> list[Page]:
    """The pages of a subject's kernels; `sampled`: values and errors by module and name."""
    modules = {
        each["module"]: importlib.import_module(f"gainproof.generated.{each['module']}")
        for each in derived.kernels
    }
    return [_page(derived, each, modules[each["module"]], sampled) for each in derived.kernels]


def _page(
    derived: Derived,
    kernel: Mapping[str, Any],
    module: ModuleType,
    sampled: Mapping[str, Mapping[str, Any]],
) -> Page:
    name = kernel["name"]
    function = getattr(module, name)
    full = f"gainproof.generated.{kernel['module']}.{name}"
    told = inspect.getdoc(function) or ""
    found = sampled.get(f"{kernel['module']}.{name}")
    return Page(
        path=address(kernel["module"], name),
        title=f"{kernel['module']}.{name}",
        kind="kernel",
        template="kernel.html",
        data={
            "full": full,
            "name": name,
            "module": kernel["module"],
            "summary": kernel["summary"],
            "signature": f"{name}{written_signature(function)}",
            "sections": _sections(told),
            "source": _source(function),
            "subject": derived.name,
            "title": derived.title,
            "plots": pictures(found) if found is not None else (),
        },
        findings=(Finding(f"{kernel['module']}.{name}", f"{kernel['summary']} {derived.title}"),),
    )


def _sections(told: str) -> list[tuple[tuple[Markup, ...], bool]]:
    """Paragraphs of a docstring after its first, each as entries without line breaks; true for
    those of formulas, which are set in and have an entry a line.
    """
    return [
        (tuple(map(set_line, inspect.cleandoc(text).splitlines())), True)
        if text.startswith("    ")
        else (tuple(map(_entry, _entries(text))), False)
        for text in told.split("\n\n")[1:]
    ]


def _entries(text: str) -> tuple[str, ...]:
    """`name: what it is`, each whole; a paragraph that does not begin with a name is one entry."""
    found: list[str] = []
    for line in text.splitlines():
        if found and not (_NAMED.match(text) and _NAMED.match(line)):
            found[-1] = f"{found[-1]} {line.strip()}"
        else:
            found.append(line.strip())
    return tuple(found)


def _entry(text: str) -> Markup:
    """An entry with its name as code, and its numbers as they are written by hand."""
    name = _NAMED.match(text)
    if name is None:
        return _numbers(coded(text))
    bare = name[0].removesuffix(": ").strip("`")
    return Markup("<code>{}</code>: ").format(bare) + _numbers(coded(text[name.end() :]))


def _numbers(text: Markup) -> Markup:
    """`1.69 * 2^-52` with its sign and its power, `<=` as one sign."""
    # of plain text, since the parts of a Markup are escaped when they are put together again
    html = str(text)
    for plain, shown in _WRITTEN:
        html = plain.sub(shown, html)
    return Markup(html)


def _source(function: Any) -> Markup:
    """The function without its docstring, which the page shows."""
    text = inspect.getsource(function)
    (defined,) = ast.parse(text).body
    assert isinstance(defined, ast.FunctionDef)
    if ast.get_docstring(defined) is not None:
        told = defined.body[0]
        assert told.end_lineno is not None
        lines = text.splitlines(keepends=True)
        text = "".join([*lines[: told.lineno - 1], *lines[told.end_lineno :]])
    return highlighted(text, "python")
