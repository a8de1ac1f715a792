"""The derivation of filter steps: accepted, refused when broken, and what its towers stand for."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from catalogue_subjects import certificate

from gainproof.derive.filter_step.forms import AXES
from gainproof.derive.filter_step.kernels import KERNELS, inputs
from gainproof.derive.filter_step.subject import build
from gainproof.derive.pages.derivation import FOLDER
from gainproof.verify.certificate import check, check_statement

NAME = "filter-step"


def statuses(data: Mapping[str, Any]) -> dict[str, str]:
    return {result.id: result.status for result in check(data).statements}


def test_every_statement_is_proved() -> None:
    found = statuses(certificate(NAME))
    assert {status for name, status in found.items() if name != "model"} == {"proved"}
    for axis in AXES:
        assert f"kernel-step-interacting-along-{axis}" in found


def test_each_output_of_each_kernel_is_claimed() -> None:
    data = certificate(NAME)
    claimed: dict[str, set[str]] = {name: set() for name in KERNELS}
    for entry in data["statements"]:
        if entry["kind"] == "program":
            claimed[entry["claim"]["program"]] |= set(entry["claim"]["outputs"])
    for name in KERNELS:
        assert claimed[name] == set(data["programs"][name]["graph"]["outputs"])


@pytest.mark.parametrize("kernel", KERNELS)
def test_an_altered_kernel_is_refused(kernel: str) -> None:
    """One operation of the graph turned into another: whatever depends on it is not the filter."""
    data = json.loads(json.dumps(certificate(NAME)))
    nodes = data["programs"][kernel]["graph"]["nodes"]
    place = next(n for n, node in enumerate(nodes) if node[0] == "mul")
    nodes[place] = ["add", *nodes[place][1:]]
    found = statuses(data)
    broken = {name for name, status in found.items() if status == "rejected"}
    assert broken
    assert all(name.startswith(f"kernel-{kernel.replace('_', '-')}") for name in broken)


def test_what_is_0_in_a_tower_is_used_by_no_output_claimed_there() -> None:
    """Rows of K1 and K2 that correct other coordinates: no way leads from them to the outputs."""
    data = certificate(NAME)
    graph = data["programs"]["step_interacting"]["graph"]
    zeros = {
        name: {each for each, value in tower["elements"].items() if not value["num"]}
        for name, tower in data["towers"].items()
    }
    assert {name: len(each) for name, each in zeros.items()} == {
        "main": 0,
        **{f"along_{axis}": 12 for axis in AXES},
    }
    for entry in data["statements"]:
        if entry["kind"] == "program" and entry["claim"]["program"] == "step_interacting":
            used = set()
            for output in entry["claim"]["outputs"]:
                used |= symbols(graph["nodes"], graph["outputs"][output])
            assert not used & zeros[entry["tower"]]
            assert len(used) == 16


def test_a_certificate_on_fixed_numbers_is_refused() -> None:
    """Where a name stands for 0 instead of any number, all kernels would still be what they say."""
    data = json.loads(json.dumps(certificate(NAME)))
    tower = data["towers"]["along_y"]["elements"]
    tower["y_position"] = tower["position_gain_11"]
    found = statuses(data)
    assert {name for name, status in found.items() if status == "rejected"} == {"signs-along-y"}


def symbols(nodes: list[list[Any]], end: int) -> set[str]:
    """Names of the symbols that a node depends on."""
    waiting, found = [end], set()
    while waiting:
        node = nodes[waiting.pop()]
        if node[0] == "symbol":
            found.add(str(node[1]))
        waiting += [part for part in node[1:] if isinstance(part, int)]
    return found


def test_the_arguments_of_a_kernel_are_its_symbols() -> None:
    data = certificate(NAME)
    for name in KERNELS:
        graph = data["programs"][name]["graph"]
        assert {node[1] for node in graph["nodes"] if node[0] == "symbol"} == set(inputs(name))


WRONG = [
    ("step-two", "v + beta r(x, v, z)/t]", "v - beta r(x, v, z)/t]"),
    ("step-three", "mean + t a/2 + beta e/t", "mean + t a + beta e/t"),
    ("missed-3", "    mean = v + t a/2\n", "    mean = v + t a\n"),
    ("step-interacting-y", "v_2 + row(B21, B22, B23)", "v_2 + row(B22, B21, B23)"),
    ("non-interacting-z", "A33, t B33)\n", "A33, B33)\n"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), WRONG)
def test_a_formula_of_the_page_that_is_not_true_is_rejected(
    tmp_path: Path, step: str, right: str, wrong: str
) -> None:
    for part in FOLDER.glob("*.md"):
        text = part.read_text(encoding="utf-8")
        if part.stem == NAME:
            assert text.count(right) == 1
            text = text.replace(right, wrong)
        (tmp_path / part.name).write_text(text, encoding="utf-8")
    found = json.loads(json.dumps(build(tmp_path).certificate()))
    assert check_statement(found, step).status == "rejected"
