"""`gainproof figure`: the figures of a source drawn anew from the kernels."""

from __future__ import annotations

import argparse

HELP = "draw a figure of a source from the kernels, as SVG, PNG and CSV"
DESCRIPTION = """\
Draws a figure of a source anew: its quantities from the kernels, ranges of our own, noise with a
seed. SOURCE is suzuki, lecture, patent or doppler; without NAME its figures are listed. What a
source leaves open is said on the figure and in its CSV. Writes SVG, PNG and CSV; pictures need
Matplotlib (the extra `figures`), --csv alone does without."""
FOLDER = "figures"


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "source", metavar="SOURCE", help="whose figure: suzuki, lecture, patent or doppler"
    )
    parser.add_argument("name", metavar="NAME", nargs="?", help="which; without it: list them")
    parser.add_argument("--out", metavar="DIR", help=f"where to write; default: {FOLDER}")
    parser.add_argument("--csv", action="store_true", help="write the numbers alone, no picture")
    parser.add_argument("--json", action="store_true", help="print the numbers, write no file")


def run(options: argparse.Namespace) -> int:
    """0; 2 for a figure there is not, or where Matplotlib is wanted and missing."""
    import json
    from pathlib import Path

    from gainproof.bad_input import BadInputError
    from gainproof.figures import catalogue, writing
    from gainproof.files import places

    if "\0" in (options.out or ""):
        raise BadInputError(f"--out takes the name of a folder, got {options.out!r}")
    if options.name is None:
        return _list(options)
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


def _list(options: argparse.Namespace) -> int:
    """The names of a source's figures, each with what it shows."""
    import json

    from gainproof.bad_input import BadInputError
    from gainproof.figures import catalogue

    own = catalogue.of_source(options.source)
    if options.out or options.csv:
        names = ", ".join(entry.name for entry in own)
        raise BadInputError(f"which figure of {options.source}? {names}")
    if options.json:
        print(json.dumps({entry.name: entry.shows for entry in own}, indent=1))
        return 0
    width = max(len(entry.name) for entry in own)
    for entry in own:
        print(f"{entry.name:{width}}  {entry.shows}")
    return 0


def _told(name: str, value: object) -> str:
    if isinstance(value, dict):
        return "\n".join([f"{name}:", *(f"  {key}: {_short(part)}" for key, part in value.items())])
    return f"{name}: {_short(value)}"


def _short(number: object) -> str:
    """Four digits behind the point of a share, fewer of what is larger; words and whole numbers as
    they are.
    """
    if not isinstance(number, float):
        return str(number)
    if 0 < abs(number) < 5e-5:
        return f"{number:.2g}"
    places = next((p for p, limit in ((4, 1), (2, 10)) if abs(number) < limit), 1)
    return f"{number:.{places}f}"
