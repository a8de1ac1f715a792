"""A page of its own for a play, opened from a folder as the book is."""

from __future__ import annotations

from pathlib import Path

import gainproof
from gainproof.book.play import STYLE, section
from gainproof.subjects.derived import Derived

STATIC = Path(gainproof.__file__).resolve().parent / "book" / "static"
COLOURS = {
    "light": "--ink:#1d2530;--paper:#fff;--muted:#586372;--line:#d5dae1;--accent:#0b5cad;"
    "--good:#17693a;--bad:#a8231c;--panel:#f4f6f9",
    "dark": "--ink:#e3e8ee;--paper:#12161c;--muted:#9fabb9;--line:#353e4a;--accent:#7fb8f5;"
    "--good:#6fcf97;--bad:#ff938a;--panel:#1b2129",
}


def derived(name: str) -> Derived:
    """A derived subject of which only the name is known."""
    return Derived(name, "", "", None, (), {}, (), (), {}, (), {}, {})


def write_page(name: str, folder: Path, colours: str = "light") -> Path:
    """The page of a subject's play with its scripts and style beside it."""
    play = section(derived(name))
    assert play is not None
    for script, text in play.scripts:
        (folder / script).write_text(text, encoding="utf-8")
    (folder / STYLE).write_bytes((STATIC / STYLE).read_bytes())
    tags = "\n".join(f'<script src="{script}" defer></script>' for script, _ in play.scripts)
    path = folder / f"{name}-{colours}.html"
    path.write_text(
        f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{name}</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="{STYLE}">{tags}
<style>:root {{ color-scheme: {colours}; {COLOURS[colours]} }}
* {{ box-sizing: border-box }}
body {{ margin: 0; background: var(--paper); color: var(--ink); font: 1rem/1.5 sans-serif }}
main {{ max-width: 60rem; margin: auto; padding: 1rem }}
table {{ border-collapse: collapse }} th, td {{ border: 1px solid var(--line); padding: .2rem .5rem;
text-align: left }}</style></head>
<body><main><h1>{name}</h1>{play.html}</main></body></html>""",
        encoding="utf-8",
    )
    return path
