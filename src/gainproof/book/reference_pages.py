"""A page for each module that people import: its names with signature and docstring.

`inspect` is enough: everything is imported anyway, and annotations are text as they are written.
"""

from __future__ import annotations

import importlib
import inspect
import textwrap
from collections.abc import Collection, Iterator
from dataclasses import dataclass, is_dataclass
from types import ModuleType
from typing import Any

from markupsafe import Markup

from gainproof.book.page import Finding, Page
from gainproof.book.plain_formulas import coded
from gainproof.book.written_signature import written_signature

MODULES = (
    "gainproof",
    "gainproof.time_varying",
    "gainproof.time_varying.three_states",
    "gainproof.position_velocity",
    "gainproof.fixed_gain",
    "gainproof.fixed_gain.two_states",
    "gainproof.fixed_gain.three_states",
    "gainproof.fixed_gain.interacting",
    "gainproof.fixed_gain.pole_discs",
    "gainproof.fixed_gain.steps",
    "gainproof.location",
    "gainproof.tracking",
)
"""What the documentation has people import; kernels have pages of their own."""


@dataclass(frozen=True)
class Entry:
    """A public name: `kind` is function, class, property or constant; `inner` are a class's own."""

    name: str
    kind: str
    signature: str
    told: Markup
    inner: tuple[Entry, ...] = ()


def address(module: str) -> str:
    """Where the page of a module lies."""
    return f"reference/{module}.html"


def reference_pages() -> list[Page]:
    """One for each module, in the order of `MODULES`."""
    return [_page(name, importlib.import_module(name)) for name in MODULES]


def _page(name: str, module: ModuleType) -> Page:
    entries = tuple(_entries(module))
    found = [Finding(name, _first(module))]
    found += [Finding(f"{name}.{e.name}", _first(getattr(module, e.name)), e.name) for e in entries]
    return Page(
        path=address(name),
        title=name,
        kind="document",
        template="reference.html",
        data={"told": told(inspect.getdoc(module) or ""), "entries": entries},
        findings=tuple(found),
    )


def public_names(module: ModuleType) -> list[str]:
    """`__all__` without dunders; where there is none, what the module itself defines."""
    listed = getattr(module, "__all__", None)
    if listed is not None:
        return [name for name in listed if not name.startswith("_")]
    return [
        name
        for name, value in vars(module).items()
        if not name.startswith("_") and getattr(value, "__module__", None) == module.__name__
    ]


def _entries(module: ModuleType) -> Iterator[Entry]:
    for name in public_names(module):
        yield _entry(name, getattr(module, name))


def _entry(name: str, value: Any) -> Entry:
    if inspect.isclass(value):
        return Entry(name, "class", f"{name}{_fields(value)}", _own(value), tuple(_methods(value)))
    if callable(value):
        return Entry(name, "function", f"{name}{written_signature(value)}", _own(value))
    return Entry(name, "constant", f"{name}{_held(value)}", Markup())


def _methods(owner: type) -> Iterator[Entry]:
    """Public methods and properties with a docstring, those that the class itself has."""
    for name, value in vars(owner).items():
        if name.startswith("_") or not inspect.getdoc(value):
            continue
        if isinstance(value, property):
            yield Entry(name, "property", name, _own(value))
        elif inspect.isfunction(value):
            yield Entry(name, "method", f"{name}{written_signature(value)}", _own(value))


def _own(value: Any) -> Markup:
    return told(inspect.getdoc(value) or "")


def _first(value: Any) -> str:
    """The first paragraph of a docstring; nothing of a constant, whose type has one."""
    has_own = inspect.ismodule(value) or callable(value)
    return (inspect.getdoc(value) or "").split("\n\n")[0] if has_own else ""


def _fields(owner: type) -> str:
    """The fields of a dataclass or named tuple; a class that is made otherwise by its signature."""
    if issubclass(owner, BaseException):
        return f"({owner.__bases__[0].__name__})"
    if is_dataclass(owner):
        return written_signature(owner, returns=False)
    names = getattr(owner, "_fields", None)
    return f"({', '.join(names)})" if names is not None else ""


def _held(value: Any) -> str:
    """The names that a constant holds."""
    if isinstance(value, Collection) and not isinstance(value, str):
        names = [str(getattr(each, "name", each)) for each in value]
        return f": {', '.join(names)}"
    return f" = {value!r}"


def told(text: str) -> Markup:
    """A docstring as HTML: paragraphs, lists with hyphens, what is set in as it stands."""
    return Markup("\n").join(_paragraph(each) for each in text.split("\n\n") if each.strip())


def _paragraph(text: str) -> Markup:
    if text.startswith("    "):
        return Markup('<pre tabindex="0">{}</pre>').format(textwrap.dedent(text))
    if not text.startswith("- "):
        return Markup("<p>{}</p>").format(coded(" ".join(text.split())))
    items = f"\n{text}".split("\n- ")[1:]
    rows = Markup().join(
        Markup("<li>{}</li>").format(coded(" ".join(item.split()))) for item in items
    )
    return Markup("<ul>{}</ul>").format(rows)
