"""What a measurement rests on: processor, caches, versions, compiler. No host name and no path."""

from __future__ import annotations

import contextlib
import os
import platform
import re
import subprocess
from importlib import metadata
from pathlib import Path

from gainproof.bench.compiler import FLAGS, compiler
from gainproof.version import VERSION

PACKAGES = (
    "numpy",
    "sympy",
    "scipy",
    "numexpr",
    "numba",
    "jax",
    "jaxlib",
    "python-flint",
    "threadpoolctl",
)
CACHES = Path("/sys/devices/system/cpu/cpu0/cache")


def facts() -> dict[str, str]:
    """By what they are about; what cannot be found out is left out."""
    found = {
        "processor": _processor(),
        "processors": str(os.cpu_count() or "unknown"),
        "caches": ", ".join(_caches()),
        "system": f"{platform.system()} {platform.machine()}",
        "C": _compiler(),
        "gainproof": VERSION,
        "Python": f"{platform.python_implementation()} {platform.python_version()}",
    }
    for package in PACKAGES:
        with contextlib.suppress(metadata.PackageNotFoundError):
            found[package] = metadata.version(package)
    return {name: value for name, value in found.items() if value}


def load() -> float | None:
    """How many processes want to run, as a mean of the last minute; None where nobody counts."""
    try:
        return round(os.getloadavg()[0], 1)
    except (AttributeError, OSError):
        return None


def _processor() -> str:
    with contextlib.suppress(OSError):
        text = Path("/proc/cpuinfo").read_text("utf-8", errors="replace")
        named = re.search(r"^model name\s*:\s*(.+)$", text, re.MULTILINE)
        if named:
            return named[1].strip()
    return platform.processor() or platform.machine()


def _caches() -> list[str]:
    """Of the first processor, as Linux tells."""
    found = []
    for folder in sorted(CACHES.glob("index*")):
        with contextlib.suppress(OSError):
            level, kind, size = (
                (folder / name).read_text("ascii").strip() for name in ("level", "type", "size")
            )
            found.append(f"L{level} {kind.lower()} {size}")
    return found


def _compiler() -> str:
    command = compiler()
    if command is None:
        return ""
    try:
        done = subprocess.run([command, "--version"], capture_output=True, text=True, check=False)
    except OSError:
        return ""
    first = done.stdout.partition("\n")[0]
    # the first word may be a path
    version = " ".join([Path(command).name, *first.split()[1:]])
    return f"{version}, {' '.join(flag for flag in FLAGS if flag not in ('-shared', '-fPIC'))}"
