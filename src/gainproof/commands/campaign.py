"""`gainproof campaign`: long work in blocks."""

from __future__ import annotations

import argparse

from gainproof.campaign.options import add_options

HELP = "long work in numbered blocks, over processes or a Dask cluster, resumed where it stopped"
DESCRIPTION = """\
Without NAME the campaigns are listed. A campaign is cut into numbered blocks that need nothing of
each other; its result is the same whatever carries them out: processes of this machine, or the
workers of a Dask cluster that have this gainproof too. What is done is kept in the state file, a
line a block: the same command goes on after an interrupt, begins anew what depends on code that has
changed, and prints the report at once where all is done. For several machines without Dask give
each its --blocks, and join their state files.

float32 [KERNEL ...] gives every float32 number that is not negative to each kernel of one input
(module, or module.kernel), and compares with its graph in double precision: in C where there is a
compiler, else in NumPy, which takes longer. The table has, of each output, the proved bound in
units of 2^-23 of the true value (or of the scale that the docstring names), the worst error in
these units and the first input where it is, the worst in units in the last place, how many inputs
lie outside those for which the bound is stated, and of how many of these the result is not what is
documented. Beside a kernel stands a digest of its arithmetic, domain and ranges and of what is
measured: a block that was done counts as long as these are the same, and kernels of one digest are
swept once. Guards, threads and bounds do not belong to it: bounds are compared in the report.

float64 [KERNEL ...] draws 1e8 float64 numbers from the whole domain of a kernel, as many of each
power of 2, and 1e8 from 2^-24 to 2^24, and compares with its graph in C's long double of 64 digits
or more; without KERNEL the three kernels of gains of two states. A row is a kernel and range, its
columns those of float32, in units of 2^-52. It needs a C compiler whose long double is longer than
double.

Exit status: 1 where the report is not as it should be."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", nargs="?", help="which campaign")
    parser.add_argument("only", metavar="ONLY", nargs="*", help="a part of it, by names")
    parser.set_defaults(more="only")
    add_options(parser)


def run(options: argparse.Namespace) -> int:
    """0, or 1 where the report is not as it should be."""
    from gainproof.bad_input import unknown_name
    from gainproof.campaign import float32, float64
    from gainproof.campaign.carrying_out import carry_out

    campaigns = {"float32": float32, "float64": float64}
    if options.name is None:
        for name, module in campaigns.items():
            print(f"{name}: {module.TITLE}")
        return 0
    if options.name not in campaigns:
        raise unknown_name("campaign", options.name, campaigns)
    return carry_out(campaigns[options.name].campaign(options.only), options)
