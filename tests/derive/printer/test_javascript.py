"""Small kernels printed as JavaScript: functions, choices, names, and what is not printed."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import node
import numpy as np
import pytest

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.javascript.page_kernels import PLAYED
from gainproof.derive.printer.javascript.script import RUNTIME_NAME, runtime, script, scripts
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, Requirement, signed
from gainproof.derive.printer.library_functions import ULP


def module(*kernels: Kernel, name: str = "small_things") -> Module:
    return Module(name, "Small things", "gainproof generate small", "a test", kernels)


def functions() -> Kernel:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("new")
    ends = {name: b.call(name, x) for name in ("sin", "cos", "exp", "expm1", "log1p")}
    ends |= {name: b.call(name, x, y) for name in ("atan2", "hypot")}
    ends["chosen"] = b.select(x, Fraction(1, 3), x * Fraction(-1, 3), y - 2)
    inputs = tuple(Input(name, "a number", "1/1000", "5", False, False) for name in ("x", "new"))
    outputs = tuple(Output(name, "a number") for name in ends)
    graph = b.graph(ends, {"exp": ends["exp"], "const": ends["sin"]})
    return Kernel("functions", "Functions", "Functions.", (), inputs, outputs, graph, "a test")


@node.needs_node
def test_functions_choices_and_names(tmp_path: Path) -> None:
    kernel = functions()
    (tmp_path / RUNTIME_NAME).write_text(runtime(), encoding="utf-8")
    (tmp_path / "small.js").write_text(script(module(kernel), ["functions"]), encoding="utf-8")
    points = np.random.default_rng(3).uniform(0.001, 5.0, (1000, 2))
    points[:2] = [[1 / 3, 1.0], [np.nextafter(1 / 3, 0.0), 1.0]]
    names = [output.name for output in kernel.outputs]
    calls = {("small-things", "functions"): (points, names)}
    paths = [tmp_path / RUNTIME_NAME, tmp_path / "small.js"]
    (found,) = node.evaluated(paths, calls, tmp_path).values()
    x, y = points.T
    # 1/3 itself lies a third of a unit above the number nearest to it
    chosen = np.where(x <= 1 / 3, x * (-1 / 3), y - 2)
    wanted = [np.sin(x), np.cos(x), np.exp(x), np.expm1(x), np.log1p(x), np.arctan2(x, y)]
    table = np.column_stack([*wanted, np.hypot(x, y), chosen])
    # either side is within its assumption
    np.testing.assert_allclose(found, table, rtol=2 * ULP * 2.0**-52)
    assert np.array_equal(found[:, -1], chosen)


def test_text_of_a_signed_input() -> None:
    b = GraphBuilder()
    graph = b.graph({"y": b.symbol("x") * 3})
    inputs = (signed("x", "a number", "1e-3", "10"),)
    kernel = Kernel("thrice", "T", "Three times.", (), inputs, (Output("y", "y"),), graph, "a test")
    lines = script(module(kernel), ["thrice"]).splitlines()
    assert lines[:3] == [
        "// Made by: gainproof generate small",
        "// From: a test",
        "// Small things",
    ]
    condition = "x === 0 || (within(x, -10.0, 10.0) && Math.abs(x) >= 0.001)"
    words = '"thrice", "x", "0 or of magnitude 1e-3 to 10", x'
    assert f"      if (!({condition})) refuse({words});" in lines
    assert "      const t2 = x * 3.0;" in lines
    assert "      return { y: t2 };" in lines


def test_requirements_are_not_printed() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    graph = b.graph({"y": x * 3, "size": b.sqrt(x * x)})
    inputs = (signed("x", "a number", "1e-3", "10"),)
    required = (Requirement("size", "size", "1", "1"),)
    outputs = (Output("y", "y"),)
    kernel = Kernel("y", "Y", "Y.", (), inputs, outputs, graph, "a test", requirements=required)
    with pytest.raises(ValueError, match="y: what inputs are together is not printed"):
        script(module(kernel), ["y"])


def test_a_kernel_that_is_not_there() -> None:
    with pytest.raises(KeyError, match="gains"):
        script(module(functions()), ["gains"])


def test_modules_that_nothing_plays_with_have_no_script() -> None:
    assert "small_things" not in PLAYED
    assert scripts(module(functions())) == {}
