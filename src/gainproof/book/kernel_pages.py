"""A page for each kernel: signature, domain, proved bound, source, and what it looks like."""

from __future__ import annotations

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
from gainproof.derived import Derived

_NAMED = re.compile(r"[`\w]+: ")


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
            "signature": f"{name}{_signature(function)}",
            "sections": _sections(told),
            "source": _source(function),
            "subject": derived.name,
            "title": derived.title,
            "plots": pictures(found) if found is not None else (),
        },
        findings=(Finding(f"{kernel['module']}.{name}", f"{kernel['summary']} {derived.title}"),),
    )


def _signature(function: Any) -> str:
    """As it is written, its annotations being text."""
    return str(inspect.signature(function)).replace("'", "")


def _sections(told: str) -> list[tuple[tuple[str, ...], bool]]:
    """Paragraphs of a docstring after its first, each as entries without line breaks; true for
    those of formulas, which are set in and have one entry with its lines.
    """
    return [
        ((inspect.cleandoc(text),), True) if text.startswith("    ") else (_entries(text), False)
        for text in told.split("\n\n")[1:]
    ]


def _entries(text: str) -> tuple[str, ...]:
    """`name: what it is`, each whole; a paragraph without names is one entry."""
    found: list[str] = []
    for line in text.splitlines():
        if found and not _NAMED.match(line):
            found[-1] = f"{found[-1]} {line.strip()}"
        else:
            found.append(line.strip())
    return tuple(found)


def _source(function: Any) -> Markup:
    """The function without its docstring, which the page shows."""
    return highlighted(inspect.getsource(function), "python")
