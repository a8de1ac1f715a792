"""The kernels printed as JavaScript: the doubles and the refusals of the NumPy kernels."""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import ModuleType

import node
import numpy as np
import pytest
from numpy.typing import NDArray

from gainproof import generated
from gainproof.derive.printer.javascript.page_kernels import PLAYED

FOLDER = Path(generated.__file__).parent
SCRIPTS = (FOLDER / "_runtime.js", *(FOLDER / f"{module}.js" for module in PLAYED))
KERNELS = [(module, kernel) for module, kernels in PLAYED.items() for kernel in kernels]
POINTS = 10_000

Reals = NDArray[np.float64]


def module_of(name: str) -> ModuleType:
    return importlib.import_module(f"gainproof.generated.{name}")


def drawn(low: float, high: float, count: int, random: np.random.Generator) -> Reals:
    """Numbers of a positive domain: both ends, and evenly by logarithm, by size, and by the
    logarithm of what is left to the upper end.
    """
    thirds = np.array_split(np.arange(count - 2), 3)
    span = random.uniform(np.log2(low), np.log2(high), len(thirds[0]))
    some = random.uniform(0.0, 1.0, len(thirds[1])) * high
    rest = high * (1.0 - 2.0 ** random.uniform(-52.0, 0.0, len(thirds[2])))
    found = np.concatenate([[low, high], np.exp2(span), some, rest])
    return random.permutation(np.clip(found, low, high))


def points_of(module: str, kernel: str) -> Reals:
    signature = getattr(module_of(module), f"_{kernel.upper()}")
    random = np.random.default_rng(2)
    ends = [domain.double for domain in signature.inputs]
    columns = [drawn(low, high, POINTS, random) for low, high in ends]
    return np.column_stack(columns)


def by_numpy(module: str, kernel: str, points: Reals) -> Reals:
    return np.column_stack(getattr(module_of(module), kernel)(*points.T))


def outputs_of(module: str, kernel: str) -> Sequence[str]:
    return tuple(getattr(module_of(module), f"_{kernel.upper()}").outputs)


def differing(
    scripts: Sequence[Path], folder: Path, kernels: Sequence[tuple[str, str]]
) -> Iterator[str]:
    """The kernels, as (module, kernel), of which an output is another double somewhere."""
    calls = {
        (module.replace("_", "-"), kernel): (
            points_of(module, kernel),
            outputs_of(module, kernel),
        )
        for module, kernel in kernels
    }
    found = node.evaluated(scripts, calls, folder)
    for module, kernel in kernels:
        key = module.replace("_", "-"), kernel
        wanted = by_numpy(module, kernel, calls[key][0])
        assert not np.isnan(wanted).any()
        if not np.array_equal(found[key].view(np.int64), wanted.view(np.int64)):
            yield f"{module}.{kernel}"


@node.needs_node
def test_all_kernels_give_the_same_doubles(tmp_path: Path) -> None:
    assert list(differing(SCRIPTS, tmp_path, KERNELS)) == []


@node.needs_node
def test_an_altered_operation_is_seen(tmp_path: Path) -> None:
    altered = tmp_path / "random_jerk.js"
    text = (FOLDER / altered.name).read_text(encoding="utf-8")
    assert "p * 0.4166666666666667;" in text
    altered.write_text(text.replace("p * 0.4166666666666667;", "p * 0.4166666666666666;"))
    scripts = [altered if path.name == altered.name else path for path in SCRIPTS]
    asked = [("random_jerk", "gains"), ("random_velocity", "gains")]
    assert list(differing(scripts, tmp_path, asked)) == ["random_jerk.gains"]


REFUSED = [
    ("random_acceleration", "gains", (-1.0,)),
    ("random_acceleration", "gains", (float("nan"),)),
    ("random_jerk", "closed_loop_poles", (float("inf"),)),
    ("alpha_beta", "variances", (1e-31, 0.5)),
    ("alpha_beta", "variances", (0.5, 2.0)),
    ("alpha_beta", "lags", (1e22, 0.5)),
    ("alpha_beta", "minimum_variance_by_lag", (0.25,)),
    ("alpha_beta_gamma", "closed_loop_poles", (0.5, 0.1, -0.0)),
    ("position_velocity", "gains", (1.0, 123456.75e20)),
]


@node.needs_node
def test_refusals_have_the_words_of_the_numpy_kernels() -> None:
    program = """
        const numbers = { nan: NaN, inf: Infinity, zero: -0 };
        return given.map(([module, kernel, inputs]) => {
          try {
            gainproof.kernels[module][kernel](...inputs.map((x) => numbers[x] ?? x));
            return "nothing was refused";
          } catch (error) {
            return `${error.name} ${error.message}`;
          }
        });"""
    words = {"nan": "nan", "inf": "inf", "-0.0": "zero"}
    given = [
        (module.replace("_", "-"), kernel, [words.get(repr(x), x) for x in inputs])
        for module, kernel, inputs in REFUSED
    ]
    told = node.answers(program, SCRIPTS, given)
    for (module, kernel, inputs), text in zip(REFUSED, told, strict=True):
        with pytest.raises(ValueError, match=kernel) as error:
            getattr(module_of(module), kernel)(*inputs)
        assert text == f"RangeError {error.value}"


@node.needs_node
def test_what_is_no_number_is_refused() -> None:
    program = """
        try { gainproof.kernels["random-acceleration"].gains("1"); return "taken"; }
        catch (error) { return `${error.name} ${error.message}`; }"""
    told = node.answers(program, SCRIPTS)
    assert told == "TypeError gains: tracking_index must be a number, got string"
