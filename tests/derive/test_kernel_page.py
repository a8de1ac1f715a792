"""Pages of sensors' kernels as text: space and plane, and formulas that are wrong."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from catalogue_subjects import certificate

from gainproof.derive.derivation import PageError
from gainproof.derive.pages.kernel_page import (
    KernelWords,
    kernel_words,
    page_graphs,
    page_module,
)
from gainproof.derive.printer.graph import Graph, GraphBuilder, symbols_of
from gainproof.derive.printer.kernel import Input, Module, Output, Requirement, signed
from gainproof.derive.sensors import converted_measurements, polar_coordinates, range_doppler
from gainproof.derive.sensors.algebraic_graphs import algebraic
from gainproof.verify.certificate import check_statement

PAGE = """
    near_kernel = [r, r_D_x, r_D_z]
    far_kernel = [twice]
    square = x^2 + z^2
    r = sqrt(square)
    r_D_x = x/r
    r_D_z = z/r
    twice = 2 r
## Where plane = 1
    flat_kernel = [r]
    z = 0
## Where far_kernel = 1
    square = x^2 + y^2
"""


def made(tmp_path: Path, text: str, named: str = "") -> dict[str, Graph]:
    page = tmp_path / "page.md"
    page.write_text(text)
    return page_graphs(page, lambda kernel: {name: f"{kernel}_{name}" for name in "zyx"}, named)


def test_a_row_is_a_kernel_in_space_and_in_the_plane(tmp_path: Path) -> None:
    graphs = made(tmp_path, PAGE)
    assert [*graphs] == ["near", "far", "near_in_plane", "far_in_plane", "flat_in_plane"]
    builder = GraphBuilder()
    z, x = builder.symbol("near_z"), builder.symbol("near_x")
    r = builder.sqrt(x * x + z * z)
    outputs = {"r": r, "r_D_x": x / r, "r_D_z": z / r}
    assert graphs["near"] == builder.graph(outputs, {"r": r})


def test_what_is_a_number_in_the_plane_is_neither_input_nor_output(tmp_path: Path) -> None:
    found = made(tmp_path, PAGE)["near_in_plane"]
    assert symbols_of(found) == ["near_x"]
    assert [*found["outputs"]] == ["r", "r_D_x"]


def test_a_row_below_the_name_of_another_kernel_is_refused(tmp_path: Path) -> None:
    page = f"{PAGE}### near\n    more_kernel = [x]\n"
    with pytest.raises(
        PageError, match=r"page\.md: more_kernel stands below another kernel's name"
    ):
        made(tmp_path, page)


def test_a_heading_may_be_of_one_kernel(tmp_path: Path) -> None:
    assert symbols_of(made(tmp_path, PAGE)["far"]) == ["far_y", "far_x"]


def test_what_is_named_besides_values_of_functions(tmp_path: Path) -> None:
    graph = made(tmp_path, PAGE, "square|r_D_[xy]")["near"]
    assert set(graph.get("names", {})) == {"r", "square", "r_D_x"}


SAID = """
## Inputs and outputs

| input | meaning | domain | in float32 |
|---|---|---|---|
| {x,z} | {east,up} of {here} | +-[1e-9, 2e3] | [1e-6, 1e3] |
| y | samples | whole [2, 9] | |

| output | meaning | error over | since |
|---|---|---|---|
| r | distance | r_scale | turns |
| r_D_{x,z} | slope by {x,z} | | |
| twice | two distances | terms | |
| more | more of them | measure | |

### near

The distance
from here.

r = |x|,
x = (x, z)

| output | meaning | error over | since |
|---|---|---|---|
| r | | itself | |

| required | meaning | at least | in float32 |
|---|---|---|---|
| r_D_z | a slope | 1e-20 | 1e-6 |

    near_kernel = [r]
## Where plane = 1

### far

Twice.

2 r

| input | meaning | domain | in float32 |
|---|---|---|---|
| y | | (0, infinity) | |
| z | | 0 or [2^-40, 2^3) | [1/2, 1) |

| output | meaning | error over | since |
|---|---|---|---|
| * | twice the * | | |
| twice | two of them | | |
"""


def said(tmp_path: Path, text: str = SAID) -> KernelWords:
    page = tmp_path / "page.md"
    page.write_text(text)
    return kernel_words(page, {"here": "home"})


def module_of(tmp_path: Path, text: str, graphs: dict[str, Graph]) -> Module:
    said(tmp_path, text)
    return page_module(tmp_path / "page.md", graphs, "a-name", "Title", {"here": "home"})


def test_what_is_said_of_kernels(tmp_path: Path) -> None:
    words = said(tmp_path)
    assert words.of("near").summary == "The distance from here."
    assert words.of("near").equations == ("r = |x|,", "x = (x, z)")
    assert words.of("near_in_plane").summary == "The distance from here in the plane."
    assert words.of("far_in_plane").equations == ("2 r",)
    with pytest.raises(PageError, match="wanted a heading `### flat`"):
        words.of("flat")
    assert [*words.inputs("near")] == ["x", "z", "y"]
    assert [*words.inputs("far")] == ["y", "z"]


def test_tables_make_kernels(tmp_path: Path) -> None:
    builder = GraphBuilder()
    x, y, z = (builder.symbol(name) for name in "xyz")
    near = builder.graph({"r": x - z, "r_D_z": z * x, "r_scale": x + z}, {"r_difference": x - z})
    far = builder.graph({"r": y - z, "r_D_x": z / y, "twice": z, "measure": z})
    module = module_of(tmp_path, SAID, {"near": near, "far_in_plane": far})
    first, second = module.kernels
    assert first.inputs == (
        signed("x", "east of home", "1e-9", "2e3", ("1e-6", "1e3")),
        signed("z", "up of home", "1e-9", "2e3", ("1e-6", "1e3")),
    )
    assert first.outputs == (Output("r", "distance"),)
    assert first.requirements == (Requirement("r_D_z", "a slope", "1e-20", "1e-6"),)
    assert first.cancellations == {"r_difference": "turns"}
    assert (first.result, first.source) == ("Near", "derivation a-name")
    assert second.inputs == (
        Input("y", "samples"),
        Input(
            "z", "up of home", Fraction(1, 2**40), 8, False, True, single=("1/2", "1"), zero=True
        ),
    )
    assert second.outputs == (
        Output("r", "twice the distance"),
        Output("r_D_x", "twice the slope by x"),
        Output("twice", "two of them", by_terms=True),
    )
    assert second.cancellations == {}


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        ("{here}", "{there}", "{there} is no slot here"),
        ("| output | meaning | error over | since |", "| output | words |", "none of kernels"),
        ("| y | samples | whole [2, 9] | |", "| y | samples |", "4 cells are wanted"),
        ("+-[1e-9, 2e3]", "1e-9 to 2e3", "input 'x': a domain such as"),
        ("| r_D_{x,z}", "| r_D_{x,y}", "far_in_plane: output 'r_D_z' has no row"),
        ("| {x,z} | {east,up}", "| {x,w} | {east,up}", "near: input 'z' has no row"),
        ("### far", "### fare", "wanted a heading `### far_in_plane`"),
    ],
)
def test_a_mistake_of_tables_is_told(right: str, wrong: str, message: str, tmp_path: Path) -> None:
    assert right in SAID
    builder = GraphBuilder()
    x, z = builder.symbol("x"), builder.symbol("z")
    graphs = {"near": builder.graph({"r": x * z}), "far_in_plane": builder.graph({"r_D_z": z})}
    text = SAID.replace(right, wrong, 1)
    with pytest.raises(PageError, match=f"page.md: .*{message}"):
        module_of(tmp_path, text, graphs)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("    r_D_z = w/r", "page.md: near: 'w' has no formula"),
        ("    far_kernel = [twice, thrice]", "page.md: far: 'thrice' has no formula"),
        (
            "    twice = r + again\n    again = twice",
            "far: .* has no formula, or one that needs itself",
        ),
        ("    twice = log(r)", "far: .*function that is known"),
        ("    r = (1 - 3) x", "near: no form without a subtraction: -2 stands with a node"),
        ("    r = x/(1 - 1)", "near: no form: x/.1 - 1. divides by 0"),
        ("    twice = z^2", "far_in_plane: a graph needs at least one output"),
        ("    twice = (r)", "page.md, line 8: read as"),
    ],
)
def test_what_has_no_formula_is_refused(line: str, message: str, tmp_path: Path) -> None:
    name = line.partition(" = ")[0]
    page = "\n".join(line if each.startswith(f"{name} = ") else each for each in PAGE.splitlines())
    with pytest.raises(PageError, match=message):
        made(tmp_path, page)


@pytest.mark.parametrize(
    ("subject", "module", "kernel", "right", "wrong"),
    [
        (
            "polar-coordinates",
            polar_coordinates,
            "to_cartesian",
            "x = level sin_b",
            "x = level cos_b",
        ),
        (
            "polar-coordinates",
            polar_coordinates,
            "straight_course_rates_in_plane",
            "crossing = north velocity_x - east",
            "crossing = north velocity_x + east",
        ),
        (
            "converted-measurements",
            converted_measurements,
            "debiased_conversion",
            "near = range_variance ((1 + kept)",
            "near = range_variance ((1 + lost)",
        ),
        (
            "converted-measurements",
            converted_measurements,
            "correlated_unbiased_conversion_in_plane",
            "beside = -together",
            "beside = together",
        ),
        (
            "range-doppler",
            range_doppler,
            "range_rate_jacobian",
            "turning_y = (velocity_y - range_rate unit_y)",
            "turning_y = (velocity_y + range_rate unit_y)",
        ),
        (
            "range-doppler",
            range_doppler,
            "range_doppler_difference_in_plane",
            "reach_y = place_y + other_place_y",
            "reach_y = place_y + place_y",
        ),
    ],
)
def test_a_wrong_formula_is_rejected(
    subject: str,
    module: Any,
    kernel: str,
    right: str,
    wrong: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The certificate says what the outputs are, whatever the page has."""
    text = module.FORMULAS.read_text(encoding="utf-8")
    assert text.count(f"    {right}") == 1
    page = tmp_path / "page.md"
    monkeypatch.setattr(module, "FORMULAS", page)
    seen = []
    for written in (text, text.replace(f"    {right}", f"    {wrong}")):
        page.write_text(written, encoding="utf-8")
        data = json.loads(json.dumps(certificate(subject)))
        graph = algebraic(module.graphs()[kernel])
        program = data["programs"][kernel]["graph"]
        program["nodes"], program["outputs"] = graph["nodes"], graph["outputs"]
        statements = [
            each["id"]
            for each in data["statements"]
            if each["kind"] == "program" and each["claim"]["program"] == kernel
        ]
        assert statements
        seen.append({check_statement(data, each).status for each in statements})
    assert seen == [{"proved"}, {"rejected"}]
