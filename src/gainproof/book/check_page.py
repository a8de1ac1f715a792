"""The page "Check a formula": the judge in the browser of whoever reads it."""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Mapping
from pathlib import Path

from gainproof.book import check_runtime, site
from gainproof.book.page import Finding, Page
from gainproof.subjects import derivations
from gainproof.verify.judge.claim.settings import CONVENTIONS
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.reader.formula_limits import MOST_CHARACTERS
from gainproof.version import VERSION

TITLE = "Check a formula"
ADDRESS = "check.html"
SCRIPTS = ("check.js", "check.judge.js", "check.worker.js", "check.css")
FOLDER = "runtime"


def check_page(runtime: Mapping[str, bytes], *, alone: bool = False) -> Page:
    """The page, which runs on the files of `runtime`, by name, and without them says how to get
    them; `alone` in a folder of its own.
    """
    parts = [
        *((part.name, part.version, part.licence) for part in check_runtime.PARTS),
        ("gainproof", VERSION, "MIT"),
    ]
    return Page(
        "index.html" if alone else ADDRESS,
        TITLE,
        "check",
        "check.html",
        {
            "alone": alone,
            "parts": parts if runtime else [],
            "size": _megabytes(map(len, runtime.values())),
            "sent": _megabytes(len(zlib.compress(each)) for each in runtime.values()),
            "models": [(e["name"], e["title"]) for e in derivations.outlines() if e["model"]],
            "conventions": CONVENTIONS,
            "quantities": [(each.name, each.meaning) for each in quantity_names().values()],
            "most": MOST_CHARACTERS,
        },
        (Finding(TITLE, "judge LaTeX verdict browser"),),
    )


def check_files(runtime: Mapping[str, bytes]) -> dict[str, bytes]:
    """The scripts of the page and what it runs on, by path; none without the latter."""
    static = Path(__file__).resolve().parent / "static"
    found = {f"static/{name}": (static / name).read_bytes() for name in SCRIPTS}
    found |= {f"{FOLDER}/{name}": content for name, content in runtime.items()}
    return found if runtime else {}


def write(runtime: Mapping[str, bytes], folder: Path) -> dict[str, bytes]:
    """Write a folder with the page alone; its files by path. Raises BadInputError."""
    page = check_page(runtime, alone=True)
    made = site.files([page], {}, lambda _: None) | check_files(runtime)
    site.write(made, folder)
    return made


def _megabytes(sizes: Iterable[int]) -> str:
    return f"{sum(sizes) / 1e6:.1f} MB"
