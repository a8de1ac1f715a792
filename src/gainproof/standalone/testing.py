"""The tests of a package, run in a process of their own."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.files import places


def require_pytest() -> None:
    """Raises BadInputError where there is no pytest to test with."""
    if find_spec("pytest") is None:
        raise BadInputError("--test needs pytest: pip install pytest")


def passes(folder: Path) -> bool:
    """Whether all tests of the package pass; prints their number, or what pytest says of them.

    Options of a project around it do not count, nor what is installed for pytest: the tests need
    none of it, and Hypothesis alone takes longer to start than they take. Nothing is left in the
    folder.
    """
    quiet = ["-q", "--no-header", "-o", "addopts=", "-p", "no:cacheprovider"]
    own = {name: value for name, value in os.environ.items() if name != "PYTEST_ADDOPTS"}
    command = [sys.executable, "-m", "pytest", *quiet, str(folder)]
    done = subprocess.run(
        command,
        env=own | {"PYTHONDONTWRITEBYTECODE": "1", "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    fine = done.returncode == 0
    # the last line has the numbers and the seconds
    last = done.stdout.strip().rpartition("\n")[2]
    print(f"tests of {places.shown(folder)}: {last}" if fine else done.stdout)
    return fine
