"""Names of model quantities mean the model's quantities in every tower, not in `main` alone.

A limit or a trend is decided over the elements of its own tower. Were these not tied to the model
by a statement of the same certificate, a wrongly derived tower could prove a limit of something
else that bears the name.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from catalogue_subjects import certificate

from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, positive
from gainproof.verify.certificate import check

NAMES = [entry.name for entry in CATALOGUE]
MODEL_QUANTITY = re.compile(r"(predicted|updated|gain)_\d+|alpha|beta|gamma")
NOISE = re.compile(r"\w+_noise_\d+")
MATRIX = {"matrix_equal", "matrix_order", "matrix_invertible", "matrix_trace"}
SILENT = {"equal", "positive", "positive_definite", "definition", "cited", "sum", *MATRIX}
"""Kinds that claim no limit, trend, sign or program."""

ANOTHER_ROOT = {
    "with_root_of_3": "a number's root, for one place where a sign changes",
    "with_root_of_e": "a number's root, for the kernel that computes with it",
    "turning": "a number's root, for the places where signs change",
    "kernels": "a root that only the kernels name, where it has no equations of its own",
    "bending": "long fractions that only second derivatives need",
}
"""Towers that need no equation of their own, with the reason for which they are not `main`: they
are `main` with one more generator or more elements, which is shown below, letter for letter.
"""


@pytest.mark.parametrize("name", NAMES)
def test_names_of_the_model_are_tied_in_every_tower(name: str) -> None:
    data = certificate(name)
    with_model = any(entry["kind"] == "riccati" for entry in data["statements"])
    for tower, spoken in _spoken(data).items():
        if tower in ANOTHER_ROOT and not spoken <= _tied(data, tower):
            assert spoken <= _tied(data, "main")
            _check_another_root(data["towers"]["main"], data["towers"][tower], spoken)
        else:
            tied = _tied(data, tower) if with_model else _equated(data, tower)
            assert spoken <= tied, (tower, sorted(spoken - tied))


@pytest.mark.parametrize("name", NAMES)
def test_process_noises_are_tied_in_every_tower(name: str) -> None:
    """In the recursions: an equation between the named entries and the parameters alone."""
    data = certificate(name)
    for tower, content in data["towers"].items():
        noises = {element for element in content["elements"] if NOISE.fullmatch(element)}
        assert noises <= _over_parameters(data, tower, noises), tower


def test_there_are_such_towers() -> None:
    data = certificate("position-velocity")
    assert {"main", "ends", "fixed_velocity_index", "narrow"} <= set(_spoken(data))
    start = certificate("recursion-two-states")["towers"]["start"]
    assert sum(NOISE.fullmatch(element) is not None for element in start["elements"]) == 9


def test_a_wrongly_derived_side_tower_is_noticed() -> None:
    """U22 (1 + p) for U22 has the same limit as p vanishes; the filter's equations refuse it."""
    data = json.loads(json.dumps(certificate("position-velocity-random-acceleration")))
    tower = data["towers"]["narrow"]
    assert _symbols(tower)[0] == "p"
    wrong = tower["elements"]["updated_22"]
    powers = {tuple(exponents): Fraction(number) for number, exponents in wrong["num"]}
    for (first, *others), number in list(powers.items()):
        place = (first + 1, *others)
        powers[place] = powers.get(place, Fraction(0)) + number
    wrong["num"] = [[str(n), list(at)] for at, n in sorted(powers.items(), reverse=True) if n]
    found = {result.id: result.status for result in check(data).statements}
    assert found["small-narrow-updated-22"] == "proved"
    assert {name for name, status in found.items() if status == "rejected"} == {
        "narrow-riccati",
    }


@pytest.mark.parametrize("part", ["prediction", "gain", "update", "innovation", "stable"])
def test_each_equation_over_the_root_is_wanted(part: str) -> None:
    data = json.loads(json.dumps(certificate("random-jerk")))
    assert len(_tied(data, "kernels")) == 15
    data["statements"] = [
        entry for entry in data["statements"] if entry["id"] != f"over-the-root-{part}"
    ]
    assert _tied(data, "kernels") == set()


def _spoken(data: Mapping[str, Any]) -> dict[str, set[str]]:
    """By tower, the names of model quantities of which something is claimed."""
    found: dict[str, set[str]] = {}
    for entry in data["statements"]:
        if entry["kind"] in SILENT:
            continue
        texts = set(_texts(entry["claim"]))
        if entry["kind"] == "program":
            texts |= set(_texts(data["programs"][entry["claim"]["program"]]["inputs"]))
        names = {text for text in texts if MODEL_QUANTITY.fullmatch(text)}
        names &= set(data["towers"][entry["tower"]]["elements"])
        if names:
            found.setdefault(entry["tower"], set()).update(names)
    return found


def _tied(data: Mapping[str, Any], tower: str) -> set[str]:
    """The names of which a stable solution of the filter's equations is made in that tower."""
    here = {
        entry["kind"]: entry["claim"] for entry in data["statements"] if entry["tower"] == tower
    }
    if "riccati" not in here:
        return _tied_entry_by_entry(data, tower)
    if "stable" not in here:
        return set()
    assert here["riccati"]["gain"] == here["stable"]["gain"]
    return {
        name for key in ("predicted", "updated", "gain") for name in _texts(here["riccati"][key])
    }


def _tied_entry_by_entry(data: Mapping[str, Any], tower: str) -> set[str]:
    """As above where the equations of `main` stand in that tower too, as equations of matrices.

    They are made here once more from the model of the claim in `main`.
    """
    here = [entry for entry in data["statements"] if entry["tower"] == tower]
    whole = [entry["claim"] for entry in data["statements"] if entry["kind"] == "riccati"]
    main = next((claim for claim in whole if isinstance(claim["gain"][0], str)), None)
    if main is None:
        return set()
    before, after = (_matrix(main[key]) for key in ("predicted", "updated"))
    (gain,) = (_matrix([[name] for name in main["gain"]]),)
    transition, noise = (
        sp.ImmutableDenseMatrix(
            [[sp.Rational(entry) for entry in row] for row in main["model"][key]]
        )
        for key in ("transition", "process_noise")
    )
    column = before[:, 0]
    moved = sp.MatMul(transition, after, transition.T, evaluate=False)
    shaken = sp.ImmutableDenseMatrix(real(main["index"]) ** 2 * noise)
    wanted = [
        equal(before, sp.MatAdd(moved, shaken, evaluate=False)),
        equal(gain * (column[0] + 1), column),
        equal(after, before - gain * column.T),
        positive(column[0] + 1),
        Relation("stable", {"model": main["model"], "gain": main["gain"]}),
    ]
    claims = [(entry["kind"], entry["claim"]) for entry in here]
    if not all((relation.kind, relation.claim()) in claims for relation in wanted):
        return set()
    assert main["model"]["measurement"] == [["1", "0", "0"]]
    return {name for key in ("predicted", "updated", "gain") for name in _texts(main[key])}


def _matrix(rows: list[list[str]]) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([[real(name) for name in row] for row in rows])


def _equated(data: Mapping[str, Any], tower: str) -> set[str]:
    """The names in equations of that tower: what there is where no model has a steady state."""
    return {
        text
        for entry in data["statements"]
        if entry["tower"] == tower and entry["kind"] == "equal"
        for text in _texts(entry["claim"])
    }


def _over_parameters(data: Mapping[str, Any], tower: str, names: set[str]) -> set[str]:
    """Those of the names that an equation of the tower gives over its parameters alone."""
    elements, found = set(data["towers"][tower]["elements"]), set()
    for entry in data["statements"]:
        if entry["tower"] == tower and entry["kind"] == "equal":
            left, right = (elements & set(_texts(entry["claim"][s])) for s in ("left", "right"))
            if left <= names and not right:
                found |= left
    return found


def _check_another_root(main: Mapping[str, Any], tower: Mapping[str, Any], names: set[str]) -> None:
    """The tower has the parameters, the generators and these elements of `main`, and more roots."""
    one, other = _symbols(main), _symbols(tower)
    assert tower["parameters"] == main["parameters"]
    assert [symbol for symbol in other if symbol in one] == one
    roots = {entry["symbol"]: entry for entry in tower["generators"]}
    for entry in main["generators"]:
        same = roots[entry["symbol"]]
        assert same["power"] == entry["power"]
        assert _terms(same["radicand"], other) == _terms(entry["radicand"], one)
    for name in names:
        for part in ("num", "den"):
            mine, its = main["elements"][name][part], tower["elements"][name][part]
            assert _terms(its, other) == _terms(mine, one), name


def _symbols(tower: Mapping[str, Any]) -> list[str]:
    return [entry["symbol"] for entry in (*tower["parameters"], *tower["generators"])]


def _terms(polynomial: list[Any], symbols: list[str]) -> dict[frozenset[tuple[str, int]], str]:
    """The coefficients by the powers of the symbols, those of zero left out."""
    return {
        frozenset((s, power) for s, power in zip(symbols, powers, strict=False) if power): number
        for number, powers in polynomial
    }


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for entry in value.values():
            yield from _texts(entry)
    elif isinstance(value, (list, tuple)):
        for entry in value:
            yield from _texts(entry)
