"""Importing and using the kernels needs NumPy alone."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

SCRIPT = textwrap.dedent(
    """
    import importlib, pkgutil, sys, time
    import numpy
    before = set(sys.modules)
    start = time.process_time()
    import gainproof.generated as generated
    for module in pkgutil.iter_modules(generated.__path__):
        importlib.import_module(f"gainproof.generated.{module.name}")
    spent = time.process_time() - start
    from gainproof.generated import random_velocity
    random_velocity.gains([0.5, 1.0])
    new = sorted({name.split(".")[0] for name in set(sys.modules) - before})
    ours = sorted(n for n in sys.modules if n.startswith("gainproof."))
    print(spent)
    print(*new)
    print(*ours)
    """
)


def run(compiled: Path) -> tuple[float, set[str], set[str]]:
    """Seconds of import, new top-level names, modules of ours; bytecode is kept in a folder."""
    without = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", SCRIPT],
        capture_output=True,
        text=True,
        check=True,
        env={**without, "PYTHONPYCACHEPREFIX": str(compiled)},
    )
    spent, new, ours = done.stdout.splitlines()
    return float(spent), set(new.split()), set(ours.split())


def test_no_computer_algebra_and_nothing_else_of_ours_is_imported(tmp_path: Path) -> None:
    _, new, ours = run(tmp_path)
    assert new - set(sys.stdlib_module_names) == {"gainproof"}
    assert {name.split(".")[1] for name in ours} == {"generated", "version"}


def test_importing_all_kernels_is_quick(tmp_path: Path) -> None:
    # the promise is 20 ms beyond NumPy, once compiled; processor time, since other
    # processes share the machine, and the best of several
    assert min(run(tmp_path)[0] for _ in range(4)) < 0.02
