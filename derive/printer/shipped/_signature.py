"""What a kernel is to those who call it: its name, inputs with their domains, and arithmetic."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt
    from numpy.typing import NDArray

    ArrayLike: TypeAlias = npt.ArrayLike | float  # a complex number is a float to some, not to all
    Array: TypeAlias = NDArray[np.floating[Any]]
    Arrays: TypeAlias = Sequence[Array]
    Real: TypeAlias = float | np.floating[Any] | NDArray[np.floating[Any]]
    Block: TypeAlias = Callable[[Arrays, Arrays, Arrays, bool], None]


class Domain(NamedTuple):
    """One input: its name, the numbers wanted in words, least and greatest of each type.

    `whole`: whole numbers only; `zero`: 0 besides; `signed`: of their magnitude.
    """

    name: str
    wanted: str
    double: tuple[float, float]
    single: tuple[float, float]
    whole: bool = False
    zero: bool = False
    signed: bool = False


class Required(NamedTuple):
    """What inputs must fulfil together: what `block` computes of them is at least `double`, in
    float32 at least `single`. It is nowhere less than the magnitude of the difference of the two
    inputs at the places of `leg`, if there are any: where that is enough nothing is computed.
    """

    name: str
    wanted: str
    double: float
    single: float
    work: int
    block: Block
    leg: tuple[int, ...] = ()


class Signature(NamedTuple):
    """A kernel: its name, inputs, names of outputs, number of work buffers, and arithmetic.

    `block(inputs, outputs, work, single)`, a function, fills arrays of one shape and type; it may
    use the outputs as buffers before it fills them. Its numbers are the defaults of further
    arguments. `only`: the one type of inputs and results, where others are refused. `numbers`: its
    arithmetic for one number each, followed by what they are (see `_numbers`); it raises
    ArithmeticError or ValueError where it is for arrays to say what is wrong.
    """

    name: str
    inputs: tuple[Domain, ...]
    outputs: tuple[str, ...]
    work: int
    block: Block
    required: tuple[Required, ...] = ()
    only: str = ""
    numbers: Callable[..., Sequence[Any]] | None = None
