"""`gainproof generate`: kernels and certificates written."""

from __future__ import annotations

import argparse

HELP = "write kernels and certificates, or compare them with a fresh derivation"
DESCRIPTION = """\
Derives afresh and writes the kernels (NumPy modules) with their certificates (JSON): all of them,
those of one subject, or those of a model of your own. FILE is a Python file that defines MODEL, a
gainproof.derive.model.Model; the file is executed. With --check nothing is written: exit status 1
if a file is missing, different or left over."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subject", metavar="NAME|FILE", nargs="?", help="default: everything")
    parser.add_argument("--out", metavar="DIR", help="default: the package's own folder")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0; with --check 1 on a difference."""
    from pathlib import Path

    from gainproof import derivations, drift, generated_files, places
    from gainproof.bad_input import BadInputError
    from gainproof.workshop import open_workshop

    shop = open_workshop(fresh=options.fresh)
    if options.subject and derivations.is_file(options.subject) and not options.out:
        raise BadInputError("kernels of your own model need a place: give --out DIR")
    folder = Path(options.out) if options.out else places.generated_folder()
    files = generated_files.fresh(options.subject, shop, own=not options.out)
    differences = drift.compare(files, folder, only=bool(options.subject or options.out))
    if options.check:
        for difference in differences:
            print(difference.text())
        if differences:
            print(f"{len(differences)} files are not as derived; {drift.CURE}")
            return 1
        print(f"{len(files)} files are as derived")
        return 0
    written = generated_files.put(files, differences, folder)
    print(f"{written} of {len(files)} files written to {places.shown(folder)}, the rest unchanged")
    return 0
