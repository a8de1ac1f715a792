"""`gainproof bench`: how fast and how exact the kernels are."""

from __future__ import annotations

import argparse

from gainproof.bench.columns import explained

HELP = "measure the kernels: speed against C, memory, lambdify and SciPy, worst error and bound"
DESCRIPTION = f"""\
Measures each kernel in one run: its time as a ratio to a C loop of the same graph, to what memory
alone takes, to SymPy's lambdify and to SciPy's Riccati solver, and its worst measured error beside
the proved bound. Exit status 1 where a kernel is outside its bound.

--html and --json write all of this as a page of one file and as data, with numexpr, Numba and JAX
where they are installed (the extra `bench`), the domains, and the subtractions that are left. They
are written as kernels are measured; --resume continues from the data.

With --against it prints nanoseconds a point instead: `length`, against the elements of a block, of
which the runtime takes the marked one (BLOCK in generated/_blocks.py); `size`, against the number
of points, with given arrays, with fresh ones, and with threads.

The columns: {"; ".join(f"`{short}`, {meaning}" for short, meaning in explained())}."""


def configure(parser: argparse.ArgumentParser) -> None:
    """What is measured, and how."""
    parser.add_argument(
        "subject",
        metavar="SUBJECT",
        nargs="*",
        help="which (see `list`); without it: all, half an hour",
    )
    parser.add_argument(
        "--workers", type=_count, default=2, metavar="N", help="threads, where there are (2)"
    )
    parser.add_argument(
        "--constant",
        metavar="PREFIX",
        help="inputs whose names begin so are one number, not an array; C is left out then",
    )
    parser.add_argument(
        "--numbers",
        type=_divisor,
        default=1,
        metavar="N",
        help="N numbers each in place of one, each with each of the others, a million pairs (1)",
    )
    parser.add_argument(
        "--html", metavar="PLACE", help="write a page: a file, or a folder for page and data"
    )
    parser.add_argument("--json", metavar="FILE", help="write the data, from which to continue")
    parser.add_argument(
        "--resume", action="store_true", help="keep what the data have, measured on this machine"
    )
    parser.add_argument(
        "--against", choices=("length", "size"), help="nanoseconds a point in place of the table"
    )


def _count(text: str) -> int:
    """A number of threads."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of threads, 1 or more")
    return int(text)


def _divisor(text: str) -> int:
    """A number of which a million is a multiple."""
    if not text.isdecimal() or int(text) < 1 or 10**6 % int(text):
        raise argparse.ArgumentTypeError(f"{text!r} is no whole number that divides 1,000,000")
    return int(text)


def run(options: argparse.Namespace) -> int:
    """The status of the measurement."""
    from gainproof import bench

    return bench.run(options)
