"""The poles one by one: what is proved of them, and that altered forms are noticed."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from catalogue_subjects import certificate, derived
from one_of_each import cases

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.kernel import Input, Kernel, Output
from gainproof.derive.three_state import pole_tower
from gainproof.derive.three_state.kernel_poles import pole_graph
from gainproof.derive.three_state.spectrum import Spectrum
from gainproof.verify.certificate import check_statement

OVER_LEVEL = ("random-jerk", "continuous-white-jerk")
FAMILIES = ("acceleration-increments", "wiener-acceleration", *OVER_LEVEL)
ONE_OF_EACH = ("acceleration-increments", "random-jerk")
KERNEL = "kernel-closed-loop-poles"


def copied(name: str) -> dict[str, Any]:
    """A certificate that may be changed."""
    found: dict[str, Any] = json.loads(json.dumps(certificate(name)))
    return found


@pytest.mark.parametrize("name", cases(FAMILIES, lambda name: name in ONE_OF_EACH))
def test_each_altered_number_of_the_kernel_is_rejected(name: str) -> None:
    data = copied(name)
    assert check_statement(data, KERNEL).status == "proved"
    nodes = data["programs"]["closed_loop_poles"]["graph"]["nodes"]
    unknown = next(n for n, node in enumerate(nodes) if node[:2] == ["call", "unknown"])
    leading = {unknown}
    for number in range(unknown, -1, -1):  # of a start nothing matters
        if number in leading:
            leading.update(part for part in nodes[number][1:] if isinstance(part, int))
    others = [
        n
        for n, node in enumerate(nodes)
        if node[0] == "number" and n not in leading and node[1] != "0"
    ]
    assert len(others) > 5
    for number in others[:: max(1, len(others) // 6)]:
        kept = nodes[number][1]
        nodes[number][1] = str(Fraction(kept) * Fraction(17, 16))
        assert check_statement(data, KERNEL).status == "rejected", (number, kept)
        nodes[number][1] = kept


@pytest.mark.parametrize("name", cases(OVER_LEVEL, lambda name: name in ONE_OF_EACH))
def test_another_place_of_the_sign_is_rejected(name: str) -> None:
    data = copied(name)
    (entry,) = (x for x in data["statements"] if x["id"] == "sign-of-half-sum")
    assert check_statement(data, entry["id"]).status == "proved"
    eight = next(node for node in entry["claim"]["right"]["nodes"] if node == ["number", "8"])
    eight[1] = "9"
    assert check_statement(data, entry["id"]).status == "rejected"


def test_kernels_of_one_family_are_not_those_of_another() -> None:
    one, other = (copied(name) for name in OVER_LEVEL)
    one["programs"]["closed_loop_poles"] = other["programs"]["closed_loop_poles"]
    assert check_statement(one, KERNEL).status == "rejected"


@pytest.mark.parametrize("name", cases(OVER_LEVEL, lambda name: name in ONE_OF_EACH))
def test_the_tower_of_poles_is_tied_to_the_equations_of_the_steady_state(name: str) -> None:
    tower = pole_tower.NAME
    tied = {x["id"] for x in copied(name)["statements"] if x["tower"] == tower}
    wanted = {"factors-are-those", "gains-of-factors", "poles-one-by-one", "index-of-level"}
    assert wanted <= tied
    ids = [step.id for step in derived(name).steps]
    assert ids.index("level-range") < ids.index("factors-are-those")


@pytest.mark.parametrize(
    ("m1", "m2", "known"),
    [
        (Fraction(2, 3), Fraction(1, 9), True),
        (Fraction(1, 2), Fraction(0), True),
        (Fraction(1, 2), Fraction(1, 4), True),
        (Fraction(3, 2), Fraction(1, 9), False),
        (Fraction(1, 2), Fraction(1), False),
    ],
)
def test_noises_within_reach(m1: Fraction, m2: Fraction, known: bool) -> None:
    empty = sp.Integer(0)
    assert pole_tower.within_reach(Spectrum(empty, empty, m1, m2)) is known


@pytest.mark.parametrize(
    ("m1", "m2"), [(Fraction(1), Fraction(1, 10**9)), (Fraction(1), Fraction(99, 100))]
)
def test_noises_beside_those_of_the_catalogue_have_a_kernel_too(m1: Fraction, m2: Fraction) -> None:
    """Where G is the root of a number over many indices, and where it is nowhere."""
    empty = sp.Integer(0)
    graph = pole_graph(Spectrum(empty, empty, m1, m2))
    outputs = tuple(Output(name, name) for name in graph["outputs"])
    index = (Input("tracking_index", "an index"),)
    kernel = Kernel("poles", "Poles", "Poles.", ("none",), index, outputs, graph, "a test")
    for form in (FLOAT64, FLOAT32):
        for output in prove(kernel, form).outputs:
            ((low, high),) = output.domain
            assert output.bound < 60
            assert low == form.least
            assert high == form.largest or output.name == "real_pole"
