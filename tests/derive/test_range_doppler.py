"""The derivation of range and Doppler, altered: what is false is refused."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from catalogue_subjects import certificate
from one_of_each import cases

from gainproof.derive.sensors.range_doppler import graphs
from gainproof.verify.certificate import check, check_statement

Plain = dict[str, Any]
KERNELS = sorted(graphs())
ONE_OF_A_KIND = {
    "range_rate_jacobian",
    "range_hessian",
    "doppler_shift_in_plane",
    "bistatic_range_doppler_in_plane",
    "range_doppler_difference_in_plane",
}


@pytest.fixture(scope="module")
def original() -> Plain:
    plain: Plain = json.loads(json.dumps(certificate("range-doppler")))
    return plain


@pytest.mark.thorough  # five seconds; `gainproof run` asks this too
def test_as_derived_everything_is_decided(original: Plain) -> None:
    report = check(original)
    assert report.accepted, report.reason
    found = [result.status for result in report.statements]
    assert found.count("proved") >= 110
    assert set(found) == {"proved", "cited", "definition"}


def status(data: Plain, name: str) -> str:
    """What becomes of a statement, read with those of its tower alone: the whole takes longer."""
    (tower,) = {entry["tower"] for entry in data["statements"] if entry["id"] == name}
    kind = {entry["kind"] for entry in data["statements"] if entry["id"] == name}
    kept = [
        entry
        for entry in data["statements"]
        if entry["tower"] == tower and (entry["id"] == name or kind != {"program"})
    ]
    programs = {e["claim"]["program"] for e in kept if e["kind"] == "program"}
    part = {
        **data,
        "towers": {tower: data["towers"][tower]},
        "programs": {each: data["programs"][each] for each in sorted(programs)},
        "statements": kept,
    }
    return check_statement(part, name).status


def negated(poly: list[Any]) -> list[Any]:
    return [[text[1:] if text[0] == "-" else f"-{text}", *rest] for text, *rest in poly]


def turned_about(data: Plain) -> None:
    """The unit vector from the target to the station."""
    elements = data["towers"]["sight"]["elements"]
    elements["unit"] = negated(elements["unit"])


def along_the_sight(data: Plain) -> None:
    """The velocity without its part along the line of sight taken out."""
    elements = data["towers"]["sight"]["elements"]
    elements["turning"] = elements["turning"][1:]


def no_projection(data: Plain) -> None:
    """I + u u' for I - u u'."""
    elements = data["towers"]["sight"]["elements"]
    elements["across"] = [elements["across"][0], *negated(elements["across"][1:])]


@pytest.mark.parametrize(
    ("alter", "noticed"),
    [
        (turned_about, {"rate", "range-convex", "range-remainder", "rate-remainder"}),
        (along_the_sight, {"across-sight", "parts-of-velocity", "rate-remainder"}),
        (no_projection, {"null-direction", "projection", "unit-remainder", "hessian-largest"}),
    ],
)
def test_an_altered_letter_is_noticed(
    alter: Callable[[Plain], None], noticed: set[str], original: Plain
) -> None:
    data = {**original, "towers": copy.deepcopy(original["towers"])}
    alter(data)
    assert data != original
    for name in noticed:
        assert status(original, name) == "proved"
        assert status(data, name) == "rejected", name


def mirrored(data: Plain) -> None:
    """West becomes east."""
    for name in ("plane", "above", "below"):
        sine = data["towers"][name]["elements"]["sin_bearing"]
        sine["num"] = negated(sine["num"])


def off_the_sphere(data: Plain) -> None:
    """The upward part of the unit vector ten times as large."""
    for name in ("above", "below"):
        upward = data["towers"][name]["elements"]["unit_z"]
        upward["num"] = [[f"{text}0", powers] for text, powers in upward["num"]]


def faster(data: Plain) -> None:
    """The relative velocity with the sign of the target's less the station's turned round."""
    for name in ("plane", "above", "below"):
        entry = data["towers"][name]["elements"]["velocity_x"]
        entry["num"] = negated(entry["num"])


@pytest.mark.parametrize(
    ("alter", "noticed"),
    [
        (mirrored, {"plane-bearing", "above-bearing"}),
        (off_the_sphere, {"above-sight", "below-sight", "below-range-chain"}),
        (faster, {"plane-sight", "above-sight", "below-parts", "plane-target"}),
    ],
)
def test_an_altered_component_is_noticed(
    alter: Callable[[Plain], None], noticed: set[str], original: Plain
) -> None:
    data = {**original, "towers": copy.deepcopy(original["towers"])}
    alter(data)
    assert {status(data, name) for name in noticed} == {"rejected"}


@pytest.mark.parametrize("step", [9, pytest.param(1, marks=pytest.mark.thorough)])
@pytest.mark.parametrize("name", cases(KERNELS, lambda name: name in ONE_OF_A_KIND))
def test_an_altered_node_of_a_kernel_is_noticed(name: str, step: int, original: Plain) -> None:
    """Each sum turned into a product, each product into a sum, quotients turned round, signs
    dropped: one at a time.
    """
    end = "" if name.endswith("_in_plane") else "-above"
    statement = f"kernel-{name.replace('_', '-')}{end}"
    assert status(original, statement) == "proved"
    nodes, tried = original["programs"][name]["graph"]["nodes"], 0
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
        # what is altered may be too long to be decided, and is not accepted either
        assert status(data, statement) in ("rejected", "given up"), (name, at, node)
        tried += 1
    assert tried or len(nodes) < 2 * step


def test_every_direction_is_in_a_tower() -> None:
    """Points of the sphere, the poles too, come out of one of the two towers' parameters."""
    generator = np.random.default_rng(3)
    points = [*generator.normal(0, 1, (200, 3)), *np.eye(3), *-np.eye(3)]
    for point in points:
        unit = point / np.linalg.norm(point)
        tilt = np.arctan2(np.hypot(unit[0], unit[1]), abs(unit[2]))  # from up, or from down
        bearing = np.arctan2(unit[0], unit[1])
        parts = max(bearing + np.pi, 0) / 2  # each below half a turn
        a, g = np.tan(tilt / 2), np.tan(parts / 2)
        assert a >= 0
        assert g >= 0
        cos_b = (4 * g * g - (1 - g * g) ** 2) / (1 + g * g) ** 2
        sin_b = -4 * g * (1 - g * g) / (1 + g * g) ** 2
        side = np.copysign(1, unit[2])
        sin_t, cos_t = 2 * a / (1 + a * a), side * (1 - a * a) / (1 + a * a)
        assert np.allclose([sin_t * sin_b, sin_t * cos_b, cos_t], unit, rtol=0, atol=1e-12)


@pytest.mark.parametrize("kernel", ["range_doppler", "range_rate_hessian"])
@pytest.mark.parametrize("name", ["range_rate", "turning_x"])
def test_a_node_that_is_not_what_is_claimed(kernel: str, name: str, original: Plain) -> None:
    """Claims put names for nodes: a name of something else there."""
    data = copy.deepcopy(original)
    statement = f"kernel-{kernel.replace('_', '-')}-above"
    (entry,) = [each for each in data["statements"] if each["id"] == statement]
    number = str(graphs()[kernel].get("names", {})[name])
    assert entry["claim"]["nodes"][number]["nodes"] == [["symbol", name]]
    entry["claim"]["nodes"][number]["nodes"] = [["symbol", "turning_y"]]
    result = check_statement(data, statement)
    assert result.status == "rejected"
    assert "not the value of the node" in result.reason
