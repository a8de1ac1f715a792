"""gainproof: steady-state gains of tracking filters, derived, proved, printed and judged.

    import gainproof
    gainproof.ask(r"\\beta = \\frac{\\alpha^2}{2 - \\alpha}")   # the verdict on a formula
    gainproof.derivation("random-velocity")   # a derivation, each step with the checker's word
    gainproof.check("my-paper.toml")          # verdicts on the claims of a file
    gainproof.steady_state(F, H, Q, R)        # gains of a model in numbers, with proved errors

The first three show themselves in a notebook and print as the commands `gainproof ask`, `gainproof
derive` and `gainproof check` do; `Judge` answers many formulas. Kernels are plain
functions, with docstrings, in `gainproof.generated`.

Three folders lie under this name: `gainproof.derive` (what is true, and why), `gainproof.generated`
(NumPy kernels) and `gainproof.verify` (how we know). Importing `gainproof` imports none of them.
"""

from __future__ import annotations

from gainproof.version import VERSION as __version__

TYPE_CHECKING = False  # to checkers of types it is true; `typing` takes a while to import
if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence
    from typing import Any

    from gainproof.answers.answer import Answer
    from gainproof.answers.judge import Judge as Judge
    from gainproof.bad_input import BadInputError as BadInputError
    from gainproof.notebook.front_door import Derivation
    from gainproof.notebook.judged_file import JudgedFile
    from gainproof.steady.state import SteadyState

__all__ = [
    "BadInputError",
    "Judge",
    "__version__",
    "ask",
    "check",
    "derivation",
    "steady_state",
]


def __getattr__(name: str) -> object:
    """`Judge` and `BadInputError`, imported when they are asked for."""
    if name == "BadInputError":
        from gainproof.bad_input import BadInputError

        return BadInputError
    if name == "Judge":
        from gainproof.answers.judge import Judge

        return Judge
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def ask(
    formula: str,
    *,
    symbols: Mapping[str, str] | None = None,
    model: str | None = None,
    domain: str | None = None,
    given: str | Sequence[str] = (),
    conventions: Mapping[str, str] | None = None,
    seconds: float | None = None,
) -> Answer:
    """The verdict on a formula: whether it is right, where, and what it should say.

    Parameters
    ----------
    formula : str
        LaTeX or plain text.
    symbols : mapping, optional
        What symbols are, by their LaTeX: a quantity ("filter_gain.1"), a unit with a condition
        ("m > 0"), "integer" with a condition, or a definition ("= a + b"). What is not said is
        understood as the field uses it, and listed in `Answer.assumed`.
    model : str, optional
        A name of `gainproof list`, "search", "fixed" (a filter with any gains), "none" (real
        numbers).
    domain : str, optional
        Conditions under which the formula is claimed.
    given : str or sequence of str
        Equations and inequalities that are hypotheses.
    conventions : mapping, optional
        Such as {"gain": "predictor"}; what is left open is searched.
    seconds : float, optional
        Processor time for each way to understand the formula that is tried, after which it is
        undecided; None: as for `gainproof ask`.

    Returns
    -------
    Answer
        verdict, assumed, domain, witness, repairs, reading, certificate.

    Raises
    ------
    gainproof.BadInputError
        For a formula that cannot be read, with a mark under the place, and for other bad input.
    """
    from gainproof.answers.judge import Judge
    from gainproof.claims.time_limit import DEFAULT

    with Judge(seconds=DEFAULT if seconds is None else seconds) as judge:
        return judge.ask(
            formula,
            symbols=symbols,
            model=model,
            domain=domain,
            given=given,
            conventions=conventions,
        )


def derivation(name_or_file: str, *, fresh: bool = False) -> Derivation:
    """A subject of the catalogue (`gainproof list`), or the model of a Python file, which is
    executed: derived, and its certificate checked.

    `fresh`: take nothing from the cache. Deriving takes seconds to a minute, from the cache a
    moment. Raises gainproof.BadInputError for a name that there is not and for a model
    that cannot be derived.
    """
    from gainproof.notebook import front_door

    return front_door.derivation(name_or_file, fresh=fresh)


def check(file: str, *, seconds: float | None = None, fresh: bool = False) -> JudgedFile:
    """The claims of a claim file, or of one of gainproof's own by its key, judged.

    A claim that takes more than `seconds` (None: as for `gainproof check`) is undecided. Raises
    gainproof.BadInputError for a file that cannot be used.
    """
    from gainproof.claims.time_limit import DEFAULT
    from gainproof.notebook import front_door

    limit = DEFAULT if seconds is None else seconds
    return front_door.check(file, seconds=limit, fresh=fresh)


def steady_state(
    F: Iterable[Iterable[Any]],
    H: Iterable[Iterable[Any]],
    Q: Iterable[Iterable[Any]],
    R: Iterable[Iterable[Any]],
    S: Iterable[Iterable[Any]] | None = None,
) -> SteadyState:
    """The Kalman filter's steady state for x(k+1) = F x(k) + w(k), y(k) = H x(k) + v(k), proved.

    Parameters
    ----------
    F, H : matrix
        Transition (n by n) and measurement (m by n): rows of numbers, or arrays of two dimensions.
        Whole numbers, fractions, decimals and texts ("1/3", "1e-22") are taken exactly, a float as
        the binary number that it is.
    Q, R : matrix
        The covariances of w (n by n) and of v (m by m); both may be singular. A singular one in
        floats may have a negative eigenvalue by their rounding: write it in fractions or texts.
    S : matrix, optional
        The covariance E[w(k) v(k)'] (n by m); None: 0.

    Returns
    -------
    SteadyState
        filter_gain, predictor_gain, predicted_covariance, updated_covariance, each with `values`
        (doubles), `errors` (proved bounds), `centre` and `radius` (exact); poles; certificate.

    Raises
    ------
    gainproof.BadInputError
        Where a matrix cannot be used, or there is no steady state with a stable filter: which mode
        is not seen or not driven.
    """
    from gainproof.steady import state

    return state.steady_state(F, H, Q, R, S)
