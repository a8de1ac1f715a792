"""Every page of a book in headless Chromium: axe-core in light and dark, the console, a telephone.

    gainproof book --out BOOK --exercises 2
    python tests/campaigns/book_pages.py BOOK [--kind NAME] [--part K/N]

Needs Chromium on the path and the extra `browser`; nothing is loaded from elsewhere. Prints the
pages that have faults: findings of axe-core that are serious or critical, anything in the console,
a page that is wider than a telephone's 360 pixels. `--kind` takes one folder of the book only
(`kernels`, `sources`), `--part 1/2` every second page, so that two can work side by side. Exit
status 1 where there is a fault, 2 where there is no book or no browser.
"""

from __future__ import annotations

import argparse
import re
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from browser import missing, opened
from page_faults import page_faults

HELP = "every page of a book in headless Chromium: axe-core, the console, a telephone's width"
TOLD_EVERY = 25


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("book", type=Path, metavar="BOOK", help="the folder of the site")
    parser.add_argument("--kind", metavar="NAME", help="pages of one folder of it only")
    parser.add_argument("--part", metavar="K/N", type=part, default=(1, 1), help="default: 1/1")
    options = parser.parse_args()
    start = options.book / options.kind if options.kind else options.book
    first, step = options.part
    pages = sorted(start.rglob("*.html"))[first - 1 :: step]
    wrong = missing() or ("" if pages else f"{start}: there are no pages")
    if wrong:
        sys.stderr.write(f"{wrong}\n")
        return 2
    begun, spoiled = time.monotonic(), 0
    with opened() as browser:
        for number, (path, faults) in enumerate(page_faults(browser, pages), 1):
            spoiled += bool(faults)
            for fault in faults:
                sys.stdout.write(f"{path.relative_to(options.book)}: {fault}\n")
                sys.stdout.flush()
            if number % TOLD_EVERY == 0:
                spent = time.monotonic() - begun
                sys.stderr.write(f"{number} of {len(pages)} ({spent:.0f} s)\n")
    sys.stdout.write(f"{len(pages)} pages, {spoiled} with faults\n")
    return 1 if spoiled else 0


def part(text: str) -> tuple[int, int]:
    """`K/N`: the K-th of N parts."""
    found = re.fullmatch(r"(\d{1,4})/(\d{1,4})", text)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise argparse.ArgumentTypeError(f"K/N with 1 <= K <= N is wanted, got {text!r}")
    return int(found[1]), int(found[2])


if __name__ == "__main__":
    sys.exit(main())
