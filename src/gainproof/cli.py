"""The command line: `gainproof COMMAND`. Nothing heavy is imported before a command needs it.

Exit status: 0 all is well, 1 the answer is no (see each command), 2 bad input or a lack of memory,
open files or room, 3 a fault of the program, 130 interrupted.
"""

from __future__ import annotations

import argparse
import errno
import gc
import io
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import NoReturn

from gainproof.bad_input import BadInputError, harmless, unknown_name
from gainproof.commands import (
    ask,
    bench,
    book,
    campaign,
    certify,
    check,
    cite,
    derive,
    design,
    explain,
    figure,
    generate,
    listing,
    locate,
    run,
    serve,
    steady,
    track,
)
from gainproof.jobs.resource_limits import lack
from gainproof.version import VERSION

COMMANDS: Mapping[str, ModuleType] = {
    "ask": ask,
    "check": check,
    "explain": explain,
    "design": design,
    "steady": steady,
    "generate": generate,
    "derive": derive,
    "list": listing,
    "cite": cite,
    "book": book,
    "figure": figure,
    "locate": locate,
    "track": track,
    "serve": serve,
    "run": run,
    "certify": certify,
    "bench": bench,
    "campaign": campaign,
}
"""In the order of a user's questions."""
COLLECTED = 100_000
"""New objects after which cycles are looked for. Certificates and verdicts are millions of objects
without any: after every 700, as is usual, looking took more than half of this process's time."""
DESCRIPTION = """\
For tracking filters: says whether a printed formula is right, finds the gains that belong to given
noises, shows derivations step by step, each step checked, and prints kernels whose error is proved.

To begin with:  gainproof ask 'beta = alpha^2/(2 - alpha)'"""


PLACES = (
    *("out", "report", "state", "plot", "html", "new", "draft", "covariance", "example", "save"),
    "certificate",
)
"""Options that name a file or folder: of an empty name the working folder would come."""
FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG)
"""What is wrong with an output that takes no more."""


class _Paragraphs(argparse.HelpFormatter):
    """Help whose descriptions are filled to the terminal, paragraph by paragraph."""

    def _fill_text(self, text: str, width: int, indent: str) -> str:
        paragraphs = text.split("\n\n")
        filled = [super(_Paragraphs, self)._fill_text(p, width, indent) for p in paragraphs]
        return "\n\n".join(filled)


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        super().error(harmless(message))


def make_parser() -> argparse.ArgumentParser:
    """The parser of the whole command line."""
    parser = _Parser(
        prog="gainproof",
        description=DESCRIPTION,
        formatter_class=_Paragraphs,
    )
    parser.add_argument("--version", action="version", version=f"gainproof {VERSION}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name, module in COMMANDS.items():
        command = commands.add_parser(
            name,
            help=module.HELP,
            description=module.DESCRIPTION,
            formatter_class=_Paragraphs,
        )
        module.configure(command)
        command.set_defaults(run=module.run)
    return parser


def main(arguments: Sequence[str] | None = None, asked: Callable[[], bool] = lambda: False) -> int:
    """Run one command and return its exit status; `asked` says whether an interrupt has come."""
    gc.set_threshold(COLLECTED)
    given = list(sys.argv[1:] if arguments is None else arguments)
    # Python has None for a stream that is closed; opened first, nothing else takes its descriptor
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115
    # a terminal without some sign of a formula shows a question mark; it is no reason to fail
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")
    try:
        if not given:
            make_parser().print_help()
            return 2
        if not given[0].startswith("-") and given[0] not in COMMANDS:
            raise unknown_name("command", given[0], COMMANDS)
        options = _options(given)
        for name in PLACES:
            if getattr(options, name, None) == "":
                raise BadInputError(f"--{name}: a name is wanted, got ''")
        status: int = options.run(options)
        sys.stdout.flush()
    except KeyboardInterrupt:
        return _interrupted()
    except Exception as error:  # noqa: BLE001 (the last stop: every fault gets its own exit status)
        # what was being imported may have made another error of an interrupt
        return _interrupted() if asked() else _told(error)
    return status


def _interrupted() -> int:
    print("gainproof: interrupted", file=sys.stderr)
    return 130


def _told(error: Exception) -> int:
    """Says what is wrong; the status."""
    if isinstance(error, BadInputError):
        print(f"gainproof: {harmless(str(error))}", file=sys.stderr)
        return 2
    if isinstance(error, BrokenPipeError):
        # whoever read our output has stopped
        _leave_output()
        return 0
    if isinstance(error, OSError) and error.errno in FULL and error.filename is None:
        _leave_output()
        print(f"gainproof: the output cannot be written: {error.strerror}", file=sys.stderr)
        return 2
    if lacks := lack(error):
        print(f"gainproof: {lacks}", file=sys.stderr)
        return 2
    return _fault(error)


def _leave_output() -> None:
    """Python writes what is left when it ends: it goes nowhere."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _options(given: list[str]) -> argparse.Namespace:
    """What the words say. argparse gives a list of names that may be empty what stands before the
    next option, and knows nothing to do with names after it: a command whose `more` says which list
    it is has them there.
    """
    parser = make_parser()
    options, beyond = parser.parse_known_args(given)
    more = getattr(options, "more", None)
    if beyond and (more is None or any(word.startswith("-") for word in beyond)):
        parser.error(f"unrecognized arguments: {' '.join(beyond)}")
    if more is not None:
        setattr(options, more, [*getattr(options, more), *beyond])
    return options


def _fault(error: Exception) -> int:
    import traceback

    from gainproof.jobs.workers import JobError

    if isinstance(error, JobError):
        print(f"gainproof: {error}", file=sys.stderr)
    else:
        traceback.print_exception(error)
    print("gainproof: a fault of the program, please report it", file=sys.stderr)
    return 3


if __name__ == "__main__":
    sys.exit(main())
