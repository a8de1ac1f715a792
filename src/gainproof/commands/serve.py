"""`gainproof serve`: formulas judged for programs."""

from __future__ import annotations

import argparse

HELP = "answer programs and agents over the Model Context Protocol"
DESCRIPTION = """\
Speaks the Model Context Protocol over standard input and output, until the input ends: the tools
check_formula, explain, check_file, derivation, list_models and steady_state. A client starts it;
docs/ask.md says how. Nothing that a call brings is executed, no file is read or written but the
cache, and a call that is cancelled ends its work. Needs the extra `serve`."""


def configure(parser: argparse.ArgumentParser) -> None:
    """It has no options."""


def run(_: argparse.Namespace) -> int:
    """0 when the client has gone."""
    from gainproof.answers.server import serve
    from gainproof.jobs import interrupts

    interrupts.run(serve())
    return 0
