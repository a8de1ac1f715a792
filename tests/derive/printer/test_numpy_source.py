"""The text of printed modules: header, docstrings, registers, formatting."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of, text_of

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Input, Kernel
from gainproof.derive.printer.program import program
from gainproof.derive.printer.registers import plan

ROOT = Path(__file__).resolve().parents[3]


def wide() -> Kernel:
    """Every operation, constants in two parts and of two types, copies, a branch, many outputs."""
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.absolute(b.sqrt(7) - x)
    branch = b.select(x, b.sqrt(2), b.sqrt(x), (x + "1/3") / 3)
    outputs = {
        "a_rather_long_name_of_an_output": gap + x,
        "and_another_long_name_of_an_output": b.select(1, x, gap + 1, branch),
        "the_input_itself_under_a_long_name": x,
        "a_constant_root_under_a_long_name": b.sqrt(5) + b.number(0),
        "the_first_output_again_as_a_copy": gap + x,
        "negative": -(x * "1/7"),
    }
    return kernel_of(b.graph(outputs, {"gap": gap, "lambda": branch}), upper=10**6)


def test_header_and_names() -> None:
    text = text_of(wide())
    lines = text.splitlines()
    assert lines[0] == "# Made by: a command"
    assert lines[1] == "# From: a derivation"
    assert ast.get_docstring(ast.parse(text)) == "Made for a test."
    assert "gap = absolute(" in text
    assert "lambda_ = choose(mask, " in text
    assert re.search(r"rest = .* if single else ", text)
    assert max(map(len, lines)) <= 100


def test_the_docstring_says_what_a_user_needs() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    function = function_of(kernel_of(b.graph({"y": b.sqrt(x)}), upper=b.graph({"v": b.sqrt(2)})))
    text = " ".join(str(function.__doc__).split())
    for wanted in (
        "A kernel under test.",
        "y = f(x)",
        "x: the argument; a number above 0 and below 1.4142135623730951.",
        "y: a value. Relative error at most 0.51 * 2^-52 (float64), 0.51 * 2^-23 (float32), proved",
        "5e-324 <= x <= 1.414213562373095 (float64)",
        "1e-45 <= x <= 1.4142135 (float32)",
        "never as NaN",
        "ValueError",
        "TypeError",
        "Source: this test",
    ):
        assert wanted in text, wanted


@pytest.mark.parametrize("kind", [np.float32, np.float64])
def test_registers_never_overwrite_what_is_needed(kind: type[np.floating]) -> None:
    """The printed text against the steps carried out one by one in arrays of their own."""
    kernel = wide()
    x = np.concatenate([np.geomspace(1e-6, 9e5, 500), np.linspace(1, 3, 500)]).astype(kind)
    steps = program(kernel.graph)
    order = plan(steps, [steps.outputs[output.name] for output in kernel.outputs])
    assert order.work <= 3
    single = kind is np.float32
    values: list[np.ndarray] = []
    for step in steps.steps:
        parts = [values[part] for part in step.operands]
        match step.operation:
            case "input":
                value = x
            case "constant":
                assert step.constant is not None
                value = np.full_like(x, float(step.constant.between()[0]))
            case "mul" if step.scale is not None:
                value = parts[0] * kind(step.scale)
            case "select":
                value = np.where(parts[0] < parts[1], parts[2], parts[3])
            case name:
                names = {"sub": "subtract", "mul": "multiply", "div": "divide", "neg": "negative"}
                value = getattr(np, names.get(name, name))(*parts)
        values.append(value)
    for output, found in zip(kernel.outputs, function_of(kernel)(x), strict=True):
        wanted = values[steps.outputs[output.name]]
        # the difference with sqrt(7) is better in the kernel
        assert np.allclose(found, wanted, rtol=1e-5 if single else 1e-13, atol=0), output.name


def test_output_arrays_are_first_written_by_slow_operations() -> None:
    """The way of an array into the cache then costs no time of its own."""
    b = GraphBuilder()
    x = b.symbol("x")
    root = b.sqrt(x + 1)
    share = 2 / (root + x)
    kernel = kernel_of(b.graph({"first": root * share, "second": share * x}))
    steps = program(kernel.graph)
    chosen = plan(steps, [steps.outputs[output.name] for output in kernel.outputs])
    for output in (0, 1):
        first = next(step for step in chosen.order if chosen.register[step] == output)
        assert steps.steps[first].operation in ("div", "sqrt")


def test_a_quotient_waits_in_the_array_to_which_it_leads() -> None:
    """A step of a filter: the products with the gains take the places of the quotients."""
    b = GraphBuilder()
    ahead, speed, rest, t, alpha, beta = map(b.symbol, "pvrtab")
    rate = rest / t
    first, second = alpha * rest, beta * rate
    graph = b.graph({"position": ahead + first, "velocity": speed + second})
    steps = program(graph)
    chosen = plan(steps, [steps.outputs[name] for name in ("position", "velocity")])
    assert chosen.work == 1
    quotient, *_ = (n for n in chosen.order if steps.steps[n].operation == "div")
    assert chosen.register[quotient] == 1


def test_a_kernel_that_is_named_like_a_function_of_numpy_calls_that_function() -> None:
    """Of the same name are the kernel, its input, and what the kernel calls."""
    b = GraphBuilder()
    x = b.symbol("sqrt")
    kernel = replace(
        kernel_of(b.graph({"divide": b.sqrt(x) / 3, "square": x * x}), upper=100),
        name="square",
        inputs=(Input("sqrt", "the argument", "0", "100"),),
    )
    text = text_of(kernel)
    assert "from numpy import divide, sqrt\n" in text
    assert "np.square(sqrt_, square_)" in text
    assert list(function_of(kernel)(9.0)) == [1.0, 81.0]


def test_a_product_with_itself_is_a_square() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    assert " square(x, y)" in text_of(kernel_of(b.graph({"y": x * x}), upper=100))


def test_the_text_is_formatted_and_clean(tmp_path: Path) -> None:
    ruff = shutil.which("ruff", path=str(Path(sys.executable).parent)) or shutil.which("ruff")
    if ruff is None:
        pytest.skip("needs ruff")
    path = tmp_path / "made.py"
    path.write_text(text_of(wide()), encoding="utf-8")
    for command in (["format", "--diff"], ["check"]):
        options = ["--config", str(ROOT / "pyproject.toml"), "--no-cache", str(path)]
        run = subprocess.run(
            [ruff, *command, *options], capture_output=True, text=True, check=False
        )
        assert run.returncode == 0, run.stdout + run.stderr


def test_the_text_depends_on_nothing_but_the_kernel() -> None:
    assert text_of(wide()) == text_of(wide())
