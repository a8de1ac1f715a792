"""The printed kernels as their users see them: functions, and the promises of their docstrings."""

from __future__ import annotations

import importlib
import pkgutil
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

import gainproof.generated

DTYPES = ("float64", "float32")
EPSILON = {"float64": Fraction(1, 2**52), "float32": Fraction(1, 2**23)}
LARGEST = {"float64": 1.7976931348623157e308, "float32": 3.4028234663852886e38}
LEAST_NORMAL = {"float64": 2.2250738585072014e-308, "float32": 1.1754943508222875e-38}


@dataclass(frozen=True)
class Promise:
    """What a docstring says of one output in one format: the error over its scale is at most
    ``bound`` epsilon for arguments from ``lowest`` to ``highest``.
    """

    bound: Fraction
    lowest: float
    highest: float

    def error(self, dtype: str) -> Fraction:
        """The bound as a plain number."""
        return self.bound * EPSILON[dtype]

    def holds_at(self, argument: float) -> bool:
        return self.lowest <= argument <= self.highest


@dataclass(frozen=True)
class PrintedKernel:
    """One function of one module of ``generated``.

    ``domain`` gives the least and greatest argument of each format, as the guard has them;
    ``promises`` the docstring's, by format and output; ``by_terms`` the outputs whose error is
    over the sum of the terms whose difference they are.
    """

    family: str
    name: str
    function: Callable[..., Any]
    argument: str
    whole: bool
    domain: dict[str, tuple[float, float]]
    outputs: tuple[str, ...]
    promises: dict[str, dict[str, Promise]]
    by_terms: frozenset[str] = frozenset()

    @property
    def id(self) -> str:
        return f"{self.family}.{self.name}"

    def truth_name(self, output: str) -> str:
        """The name under which the oracles know an output."""
        if self.name.endswith("_second_derivatives"):
            return f"dd_{output}_by_terms" if output in self.by_terms else f"dd_{output}"
        derivative = self.name.endswith("_derivatives") and "_with_" not in self.name
        return f"d_{output}" if derivative else output


SIZES = "the sum of its terms' sizes"


def printed_kernels() -> tuple[PrintedKernel, ...]:
    """Every public kernel of one input of every generated module; LookupError if there is none.

    Those of several inputs are in `printed_pairs`.
    """
    found = tuple(_all())
    if not found:
        raise LookupError("gainproof.generated holds no kernels: run `gainproof generate`")
    return found


def _all() -> Iterator[PrintedKernel]:
    for module in pkgutil.iter_modules(gainproof.generated.__path__):
        if module.name.startswith("_"):
            continue
        loaded = importlib.import_module(f"gainproof.generated.{module.name}")
        for name in loaded.__all__:
            if not name[0].islower():  # a class of results
                continue
            signature = getattr(loaded, f"_{name.upper()}")
            if len(signature.inputs) > 1:
                continue
            (domain,) = signature.inputs
            function = getattr(loaded, name)
            text = re.sub(r"\s+", " ", function.__doc__)
            yield PrintedKernel(
                module.name,
                name,
                function,
                domain.name,
                domain.whole,
                {"float64": domain.double, "float32": domain.single},
                tuple(signature.outputs),
                {
                    dtype: {output: promise(text, output, dtype) for output in signature.outputs}
                    for dtype in DTYPES
                },
                frozenset(re.findall(rf" (\w+): [^:]*?Error over {SIZES} ", text)),
            )


def promise(text: str, output: str, dtype: str) -> Promise:
    """The promise about an output, read from a docstring on one line.

    LookupError when the docstring makes none: an output without a stated bound is a defect.
    """
    number = r"([-+.e\d]+)"
    start = re.search(rf" {output}: [^:]*?(?:Relative error|Error over [\w' ]+) at most ", text)
    if start is None:
        raise LookupError(f"no error is stated for {output}: {text[:60]}...")
    # up to the next output's statement
    later = re.split(r"(?:Relative error|Error over [\w' ]+) at most ", text[start.end() :])[0]
    digits = {"float64": 52, "float32": 23}[dtype]
    bound = re.search(rf"{number} \* 2\^-{digits} \({dtype}\)", later)
    ends = re.search(rf"{number} <= \w+ <= {number} \({dtype}\)", later)
    if bound is None or ends is None:
        raise LookupError(f"no bound with a range is stated for {output} in {dtype}: {later}")
    low, high = (float(np.dtype(dtype).type(end)) for end in ends.groups())
    return Promise(Fraction(bound.group(1)), low, high)


def groups(kernels: tuple[PrintedKernel, ...]) -> dict[tuple[str, str], list[PrintedKernel]]:
    """The kernels by family and argument: what one enclosed truth serves."""
    found: dict[tuple[str, str], list[PrintedKernel]] = {}
    for kernel in kernels:
        found.setdefault((kernel.family, kernel.argument), []).append(kernel)
    return found


def common_domain(kernels: list[PrintedKernel], dtype: str) -> tuple[float, float]:
    """The arguments that all of the kernels take."""
    return (
        max(kernel.domain[dtype][0] for kernel in kernels),
        min(kernel.domain[dtype][1] for kernel in kernels),
    )
