"""Range and range rate between two moving points: what such bounds are for, on another kernel."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from graph_kernels import module_of
from signed_graphs import with_terms

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel, Output, Requirement, signed
from gainproof.derive.printer.requirements import first_leg

AXES = ("x", "y", "z")
PLACES = tuple(f"{who}_{axis}" for who in ("target", "station") for axis in AXES)
SPEEDS = tuple(f"{name}_speed" for name in PLACES)


def sight() -> Kernel:
    """Places and velocities of both; differences of inputs are exact but for one rounding."""
    b = GraphBuilder()
    apart = [b.symbol(f"target_{axis}") - b.symbol(f"station_{axis}") for axis in AXES]
    moving = [b.symbol(f"target_{a}_speed") - b.symbol(f"station_{a}_speed") for a in AXES]
    squares = [each * each for each in apart]
    distance = b.sqrt((squares[0] + squares[1]) + squares[2])
    terms = [(each / distance) * speed for each, speed in zip(apart, moving, strict=True)]
    graph = b.graph({"distance": distance, "rate": (terms[0] + terms[1]) + terms[2]})
    place, speed = ("1e-30", "1e30", ("1e-9", "1e15")), ("1e-20", "1e20", ("1e-9", "1e9"))
    return Kernel(
        "sight",
        "Sight",
        "Range and range rate.",
        ("R = |d|, R' = d v/R",),
        (
            *(signed(name, "a coordinate, m", *place) for name in PLACES),
            *(signed(name, "a velocity, m/s", *speed) for name in SPEEDS),
        ),
        (Output("distance", "range, m"), Output("rate", "range rate, m/s", by_terms=True)),
        graph,
        "this test",
        requirements=(Requirement("distance", "distance of the two", "1e-30", "1e-6"),),
    )


@pytest.mark.parametrize("form", [FLOAT64, FLOAT32], ids=lambda form: form.name)
def test_bounds_are_small_and_need_no_assumption(form: object) -> None:
    made = sight()
    found = prove(made, FLOAT64 if form is FLOAT64 else FLOAT32)
    distance, rate = found.outputs
    assert distance.bound <= Fraction(301, 100)
    assert rate.bound <= Fraction(651, 100)
    assert distance.beside == 0


def test_far_away_in_single_precision_and_nearly_radial() -> None:
    """Stations a billion metres off, and places that agree in most digits."""
    made = sight()
    run = module_of(made)["sight"]
    generator = np.random.default_rng(4)
    for dtype, epsilon in (("float64", 2.0**-52), ("float32", 2.0**-23)):
        form = FLOAT64 if dtype == "float64" else FLOAT32
        distance, rate = prove(made, form).outputs
        far = generator.uniform(-1e9, 1e9, (6, 60))
        far[3:, :30] = far[:3, :30] * (1 + generator.integers(1, 9, (3, 30)) * epsilon)
        given = np.concatenate([far, generator.normal(0, 300, (6, 60))]).astype(dtype)
        values = run(*given)
        for at in range(60):
            names = [each.name for each in made.inputs]
            place = dict(zip(names, map(float, given[:, at]), strict=True))
            exact = with_terms(made.graph, place)
            for value, stated, name in zip(values, (distance, rate), exact, strict=True):
                true, terms = exact[name]
                room = terms * float(stated.bound) * epsilon + stated.beside
                assert abs(float(value[at]) - true) <= room * (1 + 1e-9), (name, place)


def test_a_target_on_a_station_is_refused() -> None:
    run = module_of(sight())["sight"]
    with pytest.raises(ValueError, match=r"distance of the two must be at least 1e-30.* got 0\.0"):
        run(*([5.0] * 3 + [5.0] * 3 + [1.0] * 6))


def test_a_leg_that_is_long_enough_is_all_that_is_computed() -> None:
    """Where the first difference is 0 or next to it the whole distance decides, place by place."""
    module = module_of(sight())
    (required,) = module["_SIGHT"].required
    assert required.leg == (0, 3)
    run = module["sight"]
    given = np.ones((12, 5))
    given[:3] = np.array([[4, 1, 1, 1, 1], [1, 5, 1, 1, 1], [1, 1, 1 + 1e-9, 1, 9]])
    with pytest.raises(ValueError, match=r"distance of the two must be .* got 0\.0 at index 3$"):
        run(*given)
    assert np.allclose(run(*np.delete(given, 3, 1)).distance, [3, 4, 1e-9, 8], rtol=1e-7)
    for bad in (np.nan, np.inf):
        given[0, 1] = bad
        with pytest.raises(ValueError, match=f"target_x must be .* got {bad} at index 1"):
            run(*given)


def test_roots_without_a_leg_of_two_inputs_have_none() -> None:
    b = GraphBuilder()
    x, y, z = (b.symbol(name) for name in "xyz")
    apart = x - y
    squares = {
        "plain": b.sqrt(x * x + y * y),
        "leg": b.sqrt(apart * apart + z * z),
        "last": b.sqrt(z * z + apart * apart),
        "other": b.sqrt(apart * apart + z),
        "product": b.sqrt(apart * apart + x * y),
        "added": b.sqrt((x + y) * (x + y)),
        "beside a number": b.sqrt((x - 1) * (x - 1)),
        "three": b.sqrt((apart - z) * (apart - z)),
        "sum": x + y,
    }
    graph = b.graph(squares)
    found = {name: first_leg(graph, name) for name in squares}
    assert found.pop("leg") == ("x", "y")
    assert set(found.values()) == {()}
