"""The derivation of polar coordinates, altered: what is false is refused."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from typing import Any

import pytest
from catalogue_subjects import certificate
from one_of_each import cases

from gainproof.derive.sensors.polar_coordinates import graphs
from gainproof.verify.certificate import check, check_statement
from gainproof.verify.certificate.checker import decide
from gainproof.verify.certificate.document import Document, read_document, read_statement
from gainproof.verify.certificate.expected_claims import Expectation
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import Meter

Plain = dict[str, Any]
Alteration = Callable[[Plain], None]


@pytest.fixture(scope="module")
def original() -> Plain:
    found: Plain = json.loads(json.dumps(certificate("polar-coordinates")))
    return found


@pytest.fixture
def document(read_once: tuple[Document, Meter]) -> Document:
    """The derivation as it was read, with all effort to spend."""
    found, meter = read_once
    meter.reset()
    return found


@pytest.fixture(scope="module")
def read_once(original: Plain) -> tuple[Document, Meter]:
    meter = Meter()
    return read_document(plain(original), meter), meter


def test_as_derived_everything_is_decided(original: Plain) -> None:
    report = check(original)
    assert report.accepted
    found = [result.status for result in report.statements]
    assert found.count("proved") >= 80
    assert set(found) == {"proved", "cited", "definition"}


def negated(poly: list[Any]) -> list[Any]:
    return [[text[1:] if text[0] == "-" else f"-{text}", powers] for text, powers in poly]


def swapped_circle(data: Plain) -> None:
    """Cosine and sine of the bearing change their places: north becomes east."""
    for tower in data["towers"].values():
        elements = tower["elements"]
        elements["cos_bearing"], elements["sin_bearing"] = (
            elements["sin_bearing"],
            elements["cos_bearing"],
        )


def mirrored_circle(data: Plain) -> None:
    """The bearing runs to the left."""
    for tower in data["towers"].values():
        sine = tower["elements"]["sin_bearing"]
        sine["num"] = negated(sine["num"])


def no_circle(data: Plain) -> None:
    """The sine of the elevation doubled: not on the circle any more."""
    for tower in data["towers"].values():
        if "sin_elevation" in tower["elements"]:
            sine = tower["elements"]["sin_elevation"]
            sine["num"] = [[f"{text}" + "0", powers] for text, powers in sine["num"]]


@pytest.mark.parametrize(
    ("alter", "noticed"),
    [
        (swapped_circle, {"bearing", "bearing-slopes", "map", "plane-bearing", "course-bearing"}),
        (mirrored_circle, {"bearing", "bearing-slopes", "map", "kernel-to-cartesian"}),
        (no_circle, {"elevation", "elevation-circle", "map", "elevation-slopes"}),
    ],
)
def test_an_altered_circle_is_noticed(
    alter: Alteration, noticed: set[str], original: Plain
) -> None:
    data = copy.deepcopy(original)
    alter(data)
    assert {check_statement(data, name).status for name in noticed} == {"rejected"}


def claimed(data: Plain, name: str) -> Plain:
    (found,) = [entry["claim"] for entry in data["statements"] if entry["id"] == name]
    claim: Plain = found
    return claim


SIGNED = (
    "elevation-slopes",
    "bearing-slopes",
    "jacobian",
    "determinant",
    "inverse-jacobian",
    "covariance",
    "axes",
    "mean",
    "bias",
    "curvature",
    "rates",
    "range-acceleration",
    "angle-accelerations",
    "second-rates",
    "uniform",
    "turning-along",
    "third",
    "closed-form",
    "plane-covariance",
    "plane-uniform-x",
    "course-rates",
)


@pytest.mark.parametrize("name", cases(SIGNED, SIGNED[::3].__contains__))
def test_an_altered_sign_is_noticed(name: str, original: Plain, document: Document) -> None:
    """The right side with its sign turned, or 1 where it is 0."""
    data = copy.deepcopy(original)
    right = claimed(data, name)["right"]
    nodes, end = right["nodes"], right["outputs"]["value"]
    if nodes[end][0] == "matrix":
        operation, rows, columns, *entries = nodes[end]
        nonzero = [at for at, entry in enumerate(entries) if nodes[entry] != ["number", "0"]]
        if nonzero:
            nodes.insert(end, ["neg", entries[nonzero[0]]])
            entries[nonzero[0]] = end
        else:
            nodes.insert(end, ["number", "1"])
            entries[0] = end
        nodes[end + 1] = [operation, rows, columns, *entries]
        right["outputs"]["value"] = end + 1
    elif nodes[end] == ["number", "0"]:
        nodes[end] = ["number", "1"]
    else:
        nodes.append(["neg", end])
        right["outputs"]["value"] = len(nodes) - 1
    (number,) = (n for n, entry in enumerate(data["statements"]) if entry["id"] == name)
    assert decided(document, number, original) == "proved"
    assert decided(document, number, data) == "rejected"


def decided(document: Document, number: int, data: Plain) -> str:
    """What becomes of a statement, whose towers and programs are read once for all."""
    statement = read_statement(plain(data["statements"][number]), document.towers, "statement")
    return decide(document, number, statement, Expectation(None, None, None, None)).status


KERNELS = sorted(graphs())


@pytest.mark.parametrize("step", [27, pytest.param(1, marks=pytest.mark.thorough)])
@pytest.mark.parametrize("name", cases(KERNELS, KERNELS[::2].__contains__))
def test_an_altered_node_of_a_kernel_is_noticed(name: str, step: int, original: Plain) -> None:
    """Each sum turned into a product, each product into a sum, quotients turned round, signs
    dropped: one at a time. Whatever can still be read is refused.
    """
    statement = f"kernel-{name.replace('_', '-')}"
    assert check_statement(original, statement).status == "proved"
    nodes, read = original["programs"][name]["graph"]["nodes"], 0
    for at, node in list(enumerate(nodes))[len(name) % step :: step]:
        changed = list(node)
        if node[0] in ("add", "mul"):
            changed[0] = "mul" if node[0] == "add" else "add"
        elif node[0] == "neg":
            changed = ["add", node[1], node[1]]
        elif node[0] == "div":
            changed[1:] = reversed(node[1:])
        else:
            continue
        program = copy.deepcopy(original["programs"][name])
        program["graph"]["nodes"][at] = changed
        data = {**original, "programs": {**original["programs"], name: program}}
        result = check_statement(data, statement)
        assert result.status == "rejected", (name, at, node)
        read += "node" in result.reason or "output" in result.reason or "root" in result.reason
    assert read or step > 1
