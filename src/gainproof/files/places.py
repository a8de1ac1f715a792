"""Where things lie: the folders of the package, in a checkout or installed."""

from __future__ import annotations

import stat
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path

import gainproof
from gainproof.bad_input import BadInputError


@cache  # asked for each module that a digest of code follows
def package_folder(name: str) -> Path:
    """The folder of `gainproof.<name>`, links resolved.

    In a checkout without symbolic links the folder lies at the root of the tree.
    """
    home = Path(gainproof.__file__).resolve().parent
    inside = home / name
    return inside.resolve() if inside.is_dir() else home.parents[1] / name


def generated_folder() -> Path:
    """The committed kernels and certificates."""
    return package_folder("generated")


def certificates() -> list[Path]:
    """The committed certificates, by name: the JSON beside a module of kernels, and no other."""
    found = sorted(generated_folder().glob("*.json"))
    return [path for path in found if path.with_suffix(".py").is_file()]


def claims_folder() -> Path:
    """The committed claim files and their snapshots of verdicts."""
    return package_folder("verify") / "claims"


def claim_files() -> tuple[Path, ...]:
    """Every committed claim file: those of the main sources, then those of `outside/`, by name."""
    folder = claims_folder()
    return (*sorted(folder.glob("*.toml")), *sorted((folder / "outside").glob("*.toml")))


def shown(path: str | Path) -> str:
    """A path as people type it: relative where it lies below the working folder."""
    try:
        return Path(path).resolve().relative_to(Path.cwd()).as_posix()
    except (ValueError, RuntimeError):  # elsewhere, or a link that leads to itself
        return str(path)


def require_folder(path: Path) -> None:
    """Raises BadInputError where something else than a folder lies, or none can."""
    _require(path, stat.S_ISDIR, "a folder")


def require_writable(folder: Path) -> None:
    """Raises BadInputError where no file can be made in a folder, which need not be there yet: told
    before long work whose results would go there. Nothing is left of the trial.
    """
    require_folder(folder)
    there = next(path for path in (folder, *folder.absolute().parents) if path.exists())
    try:
        with tempfile.TemporaryDirectory(prefix=".gainproof-", dir=there):
            pass
    except OSError as error:
        reason = error.strerror or error
        raise BadInputError(f"{shown(folder)}: cannot be written: {reason}") from None


def require_file(path: Path) -> None:
    """Raises BadInputError where a folder or device lies, or nothing can; one that waits for a
    sender, as a pipe does, would never end.
    """
    _require(path, stat.S_ISREG, "a regular file")


def _require(path: Path, is_wanted: Callable[[int], bool], wanted: str) -> None:
    """That what lies there, if anything does, is what is wanted."""
    try:
        mode = path.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise BadInputError(f"{shown(path)}: {wanted} is wanted: {reason}") from None
    if not is_wanted(mode):
        raise BadInputError(f"{shown(path)}: {wanted} is wanted, this is none")


def snapshot_of(claim_file: Path) -> Path:
    """The snapshot of verdicts that belongs to a claim file."""
    return claim_file.with_name(f"{claim_file.stem}.verdicts.json")
