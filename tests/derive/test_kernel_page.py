"""Pages of sensors' kernels as text: space and plane, and formulas that are wrong."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from catalogue_subjects import certificate

from gainproof.derive.derivation import PageError
from gainproof.derive.printer.graph import Graph, GraphBuilder, symbols_of
from gainproof.derive.sensors import converted_module, polar_module, range_doppler_module
from gainproof.derive.sensors.algebraic_graphs import algebraic
from gainproof.derive.sensors.kernel_page import kernel_words, page_graphs
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


def test_a_heading_may_be_of_one_kernel(tmp_path: Path) -> None:
    assert symbols_of(made(tmp_path, PAGE)["far"]) == ["far_y", "far_x"]


def test_what_is_named_besides_values_of_functions(tmp_path: Path) -> None:
    graph = made(tmp_path, PAGE, "square|r_D_[xy]")["near"]
    assert set(graph.get("names", {})) == {"r", "square", "r_D_x"}


def test_what_is_said_of_kernels(tmp_path: Path) -> None:
    page = tmp_path / "page.md"
    page.write_text(
        "### near\n\nThe distance\nfrom here.\n\nr = |x|,\nx = (x, z)\n\n    near_kernel = [r]\n"
        "## Where plane = 1\n\n### far\n\nTwice.\n\n2 r\n"
    )
    assert kernel_words(page, ["near"]) == {
        "near": ("The distance from here.", ("r = |x|,", "x = (x, z)")),
        "far": ("Twice.", ("2 r",)),
    }
    with pytest.raises(PageError, match="wanted a heading `### flat`"):
        kernel_words(page, ["near", "flat"])


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
        ("polar-coordinates", polar_module, "to_cartesian", "x = level sin_b", "x = level cos_b"),
        (
            "polar-coordinates",
            polar_module,
            "straight_course_rates_in_plane",
            "crossing = north velocity_x - east",
            "crossing = north velocity_x + east",
        ),
        (
            "converted-measurements",
            converted_module,
            "debiased_conversion",
            "near = range_variance ((1 + kept)",
            "near = range_variance ((1 + lost)",
        ),
        (
            "converted-measurements",
            converted_module,
            "correlated_unbiased_conversion_in_plane",
            "beside = -together",
            "beside = together",
        ),
        (
            "range-doppler",
            range_doppler_module,
            "range_rate_jacobian",
            "turning_y = (velocity_y - range_rate unit_y)",
            "turning_y = (velocity_y + range_rate unit_y)",
        ),
        (
            "range-doppler",
            range_doppler_module,
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
