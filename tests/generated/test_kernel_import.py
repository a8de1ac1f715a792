"""Importing and using the kernels needs NumPy alone."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

SCRIPT = textwrap.dedent(
    """
    import importlib, pkgutil, sys
    import numpy
    before = set(sys.modules)
    import gainproof.generated as generated
    for module in pkgutil.iter_modules(generated.__path__):
        importlib.import_module(f"gainproof.generated.{module.name}")
    from gainproof.generated import random_velocity
    random_velocity.gains([0.5, 1.0])
    new = sorted({name.split(".")[0] for name in set(sys.modules) - before})
    ours = sorted(n for n in sys.modules if n.startswith("gainproof."))
    print(*new)
    print(*ours)
    """
)


def run(compiled: Path) -> tuple[set[str], set[str]]:
    """New top-level names and modules of ours; bytecode is kept in a folder."""
    without = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT],
        capture_output=True,
        text=True,
        check=True,
        env={**without, "PYTHONPYCACHEPREFIX": str(compiled)},
    )
    new, ours = done.stdout.splitlines()
    return set(new.split()), set(ours.split())


def test_no_computer_algebra_and_nothing_else_of_ours_is_imported(tmp_path: Path) -> None:
    new, ours = run(tmp_path)
    assert new - set(sys.stdlib_module_names) == {"gainproof"}
    assert {name.split(".")[1] for name in ours} == {"generated", "version"}
