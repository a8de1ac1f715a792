"""`gainproof figure`: the figures of a source drawn anew from the kernels."""

from __future__ import annotations

import argparse

HELP = "draw a figure of a source from the kernels, as SVG, PNG and CSV"
DESCRIPTION = """\
Draws a figure of a source anew: its quantities from the kernels, logarithmic axes, ranges of our
own. SOURCE is suzuki; NAME is 1, 2 or 3, the number of the figure, or digits: where the printed
closed form loses its digits in double precision. Writes SVG, PNG and CSV; pictures need Matplotlib
(the extra `figures`), --csv alone does without."""
FOLDER = "figures"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", metavar="SOURCE", help="whose figure: suzuki")
    parser.add_argument("name", metavar="NAME", help="1, 2, 3 or digits")
    parser.add_argument("--out", metavar="DIR", help=f"where to write; default: {FOLDER}")
    parser.add_argument("--csv", action="store_true", help="write the numbers alone, no picture")
    parser.add_argument("--json", action="store_true", help="print the numbers, write no file")


def run(options: argparse.Namespace) -> int:
    """0; 2 for a figure there is not, or where Matplotlib is wanted and missing."""
    import json
    from pathlib import Path

    from gainproof import places
    from gainproof.bad_input import BadInputError
    from gainproof.figures import catalogue, writing

    entry = catalogue.find(options.source, options.name)
    if options.json:
        if options.out or options.csv:
            raise BadInputError("--json prints the numbers and writes no file: leave --out, --csv")
        print(json.dumps({"figure": entry.file, **entry.table().plain()}, indent=1))
        return 0
    table = entry.table()
    content = writing.files(entry, table, drawn=not options.csv)
    for path in writing.write(content, Path(options.out or FOLDER)):
        print(places.shown(path))
    for name, value in table.numbers.items():
        print(_told(name, value))
    return 0


def _told(name: str, value: object) -> str:
    if isinstance(value, dict):
        return "\n".join([f"{name}:", *(f"  {key}: {share:.4f}" for key, share in value.items())])
    return f"{name}: {value}"
