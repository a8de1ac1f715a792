"""Text filled to the width of a page: that of the terminal, or a fixed one anywhere else."""

from __future__ import annotations

import shutil
import sys
import textwrap

WIDTH = 92
_NARROWEST, _WIDEST = 60, 120


def width() -> int:
    """Columns of the terminal that standard output is, within reason; `WIDTH` for files and pipes,
    so that what is kept does not depend on a window.
    """
    if not sys.stdout.isatty():
        return WIDTH
    return max(_NARROWEST, min(_WIDEST, shutil.get_terminal_size((WIDTH, 24)).columns))


def filled(text: str, first: str = "", rest: str | None = None, columns: int = WIDTH) -> list[str]:
    """The text in lines of at most `columns`, `first` before the first and `rest` before the
    others; long words are kept whole.
    """
    return textwrap.wrap(
        text,
        columns,
        initial_indent=first,
        subsequent_indent=first if rest is None else rest,
        break_long_words=False,
        break_on_hyphens=False,
    )
