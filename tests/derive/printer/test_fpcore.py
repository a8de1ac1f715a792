"""FPCore: read back by a reader of its own and evaluated, it gives the bits of the kernel."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from graph_kernels import function_of, kernel_of

from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.fpcore import fpcore
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel, Module, Output, Requirement, closed, signed
from gainproof.derive.printer.module_bounds import prove_all

Tree = Any
KINDS = {"binary64": np.float64, "binary32": np.float32}
TOKEN = re.compile(r';[^\n]*|"(?:[^"\\]|\\.)*"|[()\[\]]|[^\s()\[\]";]+')


def read(text: str) -> list[Tree]:
    """The cores of a file as nested lists; brackets of both kinds must match."""
    stack: list[list[Tree]] = [[]]
    closes: list[str] = []
    for token in TOKEN.findall(text):
        if token.startswith(";"):
            continue
        if token in "([":
            stack.append([])
            closes.append(")" if token == "(" else "]")
        elif token in ")]":
            assert closes.pop() == token
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(token)
    (cores,) = stack
    return cores


def properties(core: Tree) -> dict[str, Tree]:
    return dict(zip(core[2:-1:2], core[3:-1:2], strict=True))


def value(tree: Tree, names: dict[str, Any], kind: type[Any]) -> Any:
    """An expression, every operation rounded to the precision."""
    if isinstance(tree, str):
        return names[tree] if tree in names else kind(float(tree))
    head, *rest = tree
    if head == "let*":
        for name, each in rest[0]:
            names = {**names, name: value(each, names, kind)}
        return value(rest[1], names, kind)
    parts = [value(each, names, kind) for each in rest]
    simple: dict[str, Callable[..., Any]] = {
        "+": lambda a, b: a + b,
        "-": lambda a, b=None: -a if b is None else a - b,
        "*": lambda a, b: a * b,
        "/": lambda a, b: a / b,
        "sqrt": np.sqrt,
        "fabs": abs,
        "if": lambda test, a, b: a if test else b,
        "<": lambda a, b: a < b,
        "<=": lambda *each: all(a <= b for a, b in itertools.pairwise(each)),
        ">=": lambda a, b: a >= b,
        "==": lambda a, b: a == b,
        "and": lambda *each: all(each),
        "or": lambda *each: any(each),
        "floor": math.floor,
    }
    return simple[head](*parts)


def trial() -> Kernel:
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.absolute(x / 2 - b.sqrt("2/3"))
    graph = b.graph({"y": b.select(2, x, gap * 3, -b.sqrt(x)) * "1/3", "same": x, "one": gap + 1})
    return kernel_of(graph, upper=10**9)


def module_of(kernel: Kernel) -> Module:
    return Module("trial", "A trial", "gainproof generate trial", "by hand", (kernel,))


def test_the_bits_are_those_of_the_kernel() -> None:
    kernel = trial()
    cores = read(fpcore(module_of(kernel), prove_all([kernel])))
    assert len(cores) == 2 * len(kernel.outputs)
    for number, core in enumerate(cores):
        head, arguments, *_ = core
        assert (head, arguments) == ("FPCore", ["x"])
        said = properties(core)
        kind = KINDS[said[":precision"]]
        points = np.geomspace(1e-20, 9e8, 200).astype(kind)
        want = function_of(kernel)(points)[number % len(kernel.outputs)]
        for point, wanted in zip(points, want, strict=True):
            assert value(said[":pre"], {"x": point}, kind)
            found = value(core[-1], {"x": point}, kind)
            assert type(found) is kind
            assert found == wanted
        assert not value(said[":pre"], {"x": kind(2e9)}, kind)


def test_a_start_of_a_cube_root_is_said_to_be_one() -> None:
    b = GraphBuilder()
    t3 = b.symbol("x")
    first = fixed_point(near_cbrt(t3), lambda y: b.sqrt(b.sqrt(t3 * y)), within="1/25")
    kernel = kernel_of(b.graph({"y": first}), lower="1e-3", upper="1e3")
    for core in read(fpcore(module_of(kernel), prove_all([kernel]))):
        said = properties(core)
        assert "starts t." in said[":gainproof-start"]
        assert "0.0325 of the cube root" in said[":gainproof-start"]
        assert any(line[1][0] == "cbrt" for line in core[-1][1])


def test_no_input_is_taken_for_a_step() -> None:
    b = GraphBuilder()
    names = ("t2", "t3")
    one, other = (b.symbol(name) for name in names)
    made = kernel_of(b.graph({"y": b.sqrt(one + 1) * b.sqrt(other + 2)}))
    inputs = tuple(closed(name, "an argument", "1e-3", "1e3") for name in names)
    kernel = replace(made, inputs=inputs)
    for core in read(fpcore(module_of(kernel), prove_all([kernel]))):
        kind = KINDS[properties(core)[":precision"]]
        assert value(core[-1], {"t2": kind(3.0), "t3": kind(7.0)}, kind) == 6.0


def test_what_is_required_of_inputs_together_is_a_precondition() -> None:
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    size = b.sqrt(x * x + z * z)
    kernel = replace(
        kernel_of(b.graph({"y": x / size, "root": size})),
        inputs=(signed("x", "an argument", 0, 10**6), signed("z", "an argument", 0, 10**6)),
        outputs=(Output("y", 'a "value"'),),
        requirements=(Requirement("root", "the root", "1e-6", "1e-3"),),
    )
    cores = read(fpcore(module_of(kernel), prove_all([kernel])))
    for core in cores:
        said = properties(core)
        kind = KINDS[said[":precision"]]
        assert said[":description"] == r'"a \"value\""'
        near = {"x": kind(3e-5), "z": kind(-4e-5)}
        assert value(said[":pre"], near, kind) == (kind is np.float64)
        far = {"x": kind(-3.0), "z": kind(4.0)}
        assert value(said[":pre"], far, kind)
        assert value(core[-1], far, kind) == pytest.approx(-0.6)
