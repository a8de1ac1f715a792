"""gainproof: steady-state gains of tracking filters, derived, proved, printed and judged.

    import gainproof
    gainproof.derivation("random-velocity")   # a derivation, each step with the checker's word
    gainproof.check("my-paper.toml")          # verdicts on the claims of a file

Both show themselves in a notebook and print as the commands `gainproof derive` and `gainproof
check` do. Kernels are plain functions, with docstrings, in `gainproof.generated`.

Three folders lie under this name: `gainproof.derive` (what is true, and why), `gainproof.generated`
(NumPy kernels) and `gainproof.verify` (how we know). Importing `gainproof` imports none of them.
"""

from __future__ import annotations

from gainproof.version import VERSION as __version__

TYPE_CHECKING = False  # to checkers of types it is true; `typing` takes a while to import
if TYPE_CHECKING:
    from gainproof.notebook.front_door import Derivation
    from gainproof.notebook.judged_file import JudgedFile

__all__ = ["__version__", "check", "derivation"]


def derivation(name_or_file: str, *, fresh: bool = False) -> Derivation:
    """A subject of the catalogue (`gainproof list`), or the model of a Python file, which is
    executed: derived, and its certificate checked.

    `fresh`: take nothing from the cache. Deriving takes seconds to a minute, from the cache a
    moment. Raises gainproof.bad_input.BadInputError for a name that there is not and for a model
    that cannot be derived.
    """
    from gainproof.notebook import front_door

    return front_door.derivation(name_or_file, fresh=fresh)


def check(file: str, *, seconds: float | None = None, fresh: bool = False) -> JudgedFile:
    """The claims of a claim file, or of one of gainproof's own by its key, judged.

    A claim that takes more than `seconds` (None: as for `gainproof check`) is undecided. Raises
    gainproof.bad_input.BadInputError for a file that cannot be used.
    """
    from gainproof.claims.time_limit import DEFAULT
    from gainproof.notebook import front_door

    limit = DEFAULT if seconds is None else seconds
    return front_door.check(file, seconds=limit, fresh=fresh)
