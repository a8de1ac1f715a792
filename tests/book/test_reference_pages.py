"""Pages of the Python interface, from the modules themselves."""

from __future__ import annotations

import importlib
import subprocess
import sys
import types

import pytest

from gainproof.book import reference_pages
from gainproof.book.reference_pages import MODULES, Entry, public_names
from gainproof.book.reference_pages import reference_pages as made
from gainproof.book.written_signature import written_signature


def everything() -> list[tuple[str, Entry]]:
    return [(page.title, entry) for page in made() for entry in page.data["entries"]]


def test_every_public_name_is_there_and_says_what_it_is() -> None:
    entries = everything()
    for module in MODULES:
        names = [entry.name for title, entry in entries if title == module]
        assert names == public_names(importlib.import_module(module))
    assert len(entries) > 80
    silent = [(t, e.name) for t, e in entries if e.kind != "constant" and not e.told]
    assert not silent
    for _, entry in entries:
        for each in (entry, *entry.inner):
            # an address in memory would differ each time
            assert " at 0x" not in each.signature


def test_a_name_without_a_docstring_is_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the test above would see."""
    module = types.ModuleType("gainproof_silent", "A module.")

    def said_nothing() -> None: ...

    said_nothing.__module__ = module.__name__
    module.said_nothing = said_nothing  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.setattr(reference_pages, "MODULES", (module.__name__,))
    ((_, entry),) = everything()
    assert entry.name == "said_nothing"
    assert not entry.told


def test_defaults_keep_their_quotation_marks() -> None:
    def of(noise: str = "white", *, count: int | None = None) -> list[str]: ...  # type: ignore[empty-body]

    assert (
        written_signature(of) == "(noise: str = 'white', *, count: int | None = None) -> list[str]"
    )


def test_docstrings_as_html() -> None:
    text = "First <b>.\n\n- one\n  more\n- `two`\n\n    a = b\n      c"
    assert reference_pages.told(text) == (
        "<p>First &lt;b&gt;.</p>\n<ul><li>one more</li><li><code>two</code></li></ul>\n"
        '<pre tabindex="0">a = b\n  c</pre>'
    )


def test_the_pages_need_no_extra() -> None:
    """The book's own extra has no SciPy and no Matplotlib."""
    program = (
        "import sys\nsys.modules.update(scipy=None, matplotlib=None)\n"
        "from gainproof.book.reference_pages import reference_pages\nprint(len(reference_pages()))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert int(done.stdout) == len(MODULES)
