"""Fills the lines of pages anew: `python -m gainproof.derive.pages.reflow FILE.md ...`."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.page import read_page


def main(files: Sequence[str]) -> int:
    """0; 2 where a page cannot be read or written: it stays as it is, and its mistake is told."""
    status = 0
    for name in files:
        path = Path(name)
        try:
            text = path.read_text(encoding="utf-8")
            filled = str(read_page(text, name))
            if filled != text:
                path.write_text(filled, encoding="utf-8")
        except (PageError, OSError, UnicodeDecodeError) as error:
            sys.stderr.write(f"{error if isinstance(error, PageError) else f'{name}: {error}'}\n")
            status = 2
        else:
            sys.stdout.write(f"{name}: {'as it was' if filled == text else 'filled anew'}\n")
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]) if sys.argv[1:] else __doc__)
