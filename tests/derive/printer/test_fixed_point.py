"""Fixed points in kernels: bounds that hold, starts that are refused, the theorem at random."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import product
from pathlib import Path

import flint
import numpy as np
import pytest
from graph_kernels import KINDS, balls, function_of, kernel_of, several_of, worst_error
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples
from three_state_gains import FACTORS, Factor, gains_graph, gains_kernel

from gainproof.bench.accuracy import ball_outputs
from gainproof.bench.compiler import compiled, compiler
from gainproof.derive.printer import boxes
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.exact import enclosures
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.forward import Forward
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.newton import Convergence, slopes
from gainproof.derive.printer.program import program
from gainproof.derive.printer.step_ranges import PrintingError
from gainproof.derive.printer.unrolled_fixed_point import unrolled
from gainproof.verify.oracles.ball import enclose
from gainproof.verify.oracles.spectrum import spectrum
from gainproof.verify.oracles.state_space import state_space


def gains_of(factor: Factor) -> Callable[[float], Sequence[flint.arb]]:
    """The oracle's gains, which know nothing of fixed points."""
    found = spectrum(
        state_space(
            {
                "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
                "process_noise": [list(row) for row in factor.noise],
                "measurement": [["1", "0", "0"]],
                "measurement_noise": [["1"]],
            }
        )
    )
    return lambda index: [row[0] for row in enclose(found, index).state.gain]


def points_of(form: Format, count: int, seed: int) -> list[float]:
    """Over the whole domain, and where gains are neither small nor at their limits."""
    random = np.random.default_rng(seed)
    low, high = (-44, 36) if form is FLOAT32 else (-300, 300)
    exponents = [*random.uniform(low, high, count), *random.uniform(-6, 6, count)]
    near = [form.nearest(Fraction(10.0**exponent)) for exponent in exponents]
    return [form.least, form.nearest(Fraction(10**36)), *near]


@pytest.mark.parametrize(
    ("which", "name"),
    cases(
        product(FACTORS, KINDS),
        lambda case: case in (("increments", "float64"), ("held", "float32")),
    ),
)
def test_measured_error_is_within_the_bound(which: str, name: str) -> None:
    (form,) = (form for form in FORMATS if form.name == name)
    kernel, truth = gains_kernel(which), gains_of(FACTORS[which])
    bounds = prove(kernel, form).outputs
    points = points_of(form, 200, 3)
    computed = function_of(kernel)(np.array(points, KINDS[form.name]))
    worst = [Fraction(0) for _ in bounds]
    for place, x in enumerate(points):
        for row, exact in enumerate(truth(x)):
            if bounds[row].lowest <= x <= bounds[row].highest:
                with flint.ctx.workprec(400):
                    error = abs(flint.arb(float(computed[row][place])) / exact - 1)
                    size = Fraction(float(error.upper())) / Fraction(form.epsilon)
                worst[row] = max(worst[row], size)
    for size, bound in zip(worst, bounds, strict=True):
        assert bound.bound / 6 < size <= bound.bound, (bound.name, float(size))
        assert bound.bound < 7


@pytest.mark.parametrize("which", FACTORS)
def test_the_graph_means_the_steady_state(which: str) -> None:
    """Three readers of the graph, and an oracle: at the ends of the floats, too."""
    graph, truth = gains_graph(FACTORS[which]), gains_of(FACTORS[which])
    steps = program(graph)
    for x in (1e-300, 3e-5, 0.7, 20.5, 1e300):
        own = balls(graph, x)
        measured = ball_outputs(graph, {"tracking_index": x})
        printed = enclosures(steps, x, FLOAT64, 300)
        for name, exact in zip(("alpha", "beta", "gamma"), truth(x), strict=True):
            for found in (own[name], measured[name], printed[steps.outputs[name]]):
                with flint.ctx.workprec(300):
                    assert abs(found / exact - 1) < flint.arb("1e-38")


@pytest.mark.parametrize(
    ("within", "count"), [("1/16", 3), ("1/20", 3), ("1/2", 4), ("1/4000", 2), ("1/30000000", 1)]
)
def test_steps_follow_from_the_start(within: str, count: int) -> None:
    """As many as square the start's distance below the last place."""
    _, (cycle,) = unrolled(gains_graph(FACTORS["increments"], within))
    assert len(cycle.iterates) - 1 == count
    assert cycle.convergence == Convergence(Fraction(1, 4), Fraction(3, 16))


@pytest.mark.parametrize(("within", "push"), [("1/20", 1), ("1/16", "11/10"), ("1/16", "9/10")])
def test_a_start_too_far_away_is_refused(within: str, push: str) -> None:
    with pytest.raises(PrintingError, match="its start is not shown to lie within a factor"):
        prove(gains_kernel("increments", within, push), FLOAT64)


def test_a_rough_start_takes_a_step_more() -> None:
    """Its error is no larger for it."""
    rough = prove(gains_kernel("increments", "1/2", "4/3"), FLOAT64)
    near = prove(gains_kernel("increments"), FLOAT64)
    for one, other in zip(rough.outputs, near.outputs, strict=True):
        assert one.bound <= other.bound


def test_several_inputs() -> None:
    """sqrt(z + 2 sqrt(x y)) over two inputs: bounds from the shape, too."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    start = near_cbrt(4 * x + z * b.sqrt(z))
    root = fixed_point(start, lambda y: b.sqrt(z + 2 * b.sqrt(x * y)), within="1/2")
    kernel = several_of(b.graph({"y": root}), "1/2", 2)
    function = function_of(kernel)
    random = np.random.default_rng(2)
    for form in FORMATS:
        bound = prove(kernel, form).outputs[0].bound
        columns = [2.0 ** random.uniform(-1, 1, 60) for _ in "xz"]
        given_ = [column.astype(KINDS[form.name]) for column in columns]
        pairs = zip(*(column.tolist() for column in given_), strict=True)
        points = [{"x": float(u), "z": float(v)} for u, v in pairs]
        worst, _ = worst_error(kernel, function(*given_), 0, points)
        assert worst <= bound * Fraction(form.epsilon)
        assert bound < 6


def test_a_fixed_point_inside_the_start_of_another() -> None:
    """The cube root of x, and that of its own multiple."""
    b = GraphBuilder()
    x = b.symbol("x")
    first = fixed_point(near_cbrt(x), lambda y: b.sqrt(b.sqrt(x * y)), within="1/25")
    second = fixed_point(first * 3, lambda y: b.sqrt(b.sqrt(40 * first * first * first * y)))
    kernel = kernel_of(b.graph({"y": first, "z": second}), lower="1e-20", upper="1e20")
    with pytest.raises(PrintingError, match="start"):
        prove(kernel, FLOAT64)  # 40^(1/3) is 3.42, not within 1/16 of 3
    second = fixed_point(
        first * 3, lambda y: b.sqrt(b.sqrt(27 * first * first * first * y)), within="1/25"
    )
    kernel = kernel_of(b.graph({"y": first, "z": second}), lower="1e-20", upper="1e20")
    values = np.array([1e-18, 0.3, 8.0, 1e18])
    y, z = function_of(kernel)(values)
    assert np.all(abs(y / np.cbrt(values) - 1) < 1e-15)
    assert np.all(abs(z / np.cbrt(values) / 3 - 1) < 2e-15)


@pytest.mark.skipif(compiler() is None, reason="no C compiler")
@pytest.mark.parametrize("which", cases(FACTORS, lambda which: which == "increments"))
def test_c_computes_the_same_bits(which: str, tmp_path: Path) -> None:
    kernel = gains_kernel(which)
    x = np.array(points_of(FLOAT64, 2000, 5))
    loop = compiled(c_loop(kernel), kernel.name, tmp_path)
    found = [np.empty_like(x) for _ in kernel.outputs]
    loop([x], found)
    for own, other in zip(function_of(kernel)(x), found, strict=True):
        assert np.array_equal(own, other)


def refused(write: Callable[[GraphBuilder, Node], Node], match: str) -> None:
    """A graph that cannot be written out, and why."""
    b = GraphBuilder()
    graph = b.graph({"y": write(b, b.symbol("x"))})
    with pytest.raises(ValueError, match=match):
        unrolled(graph)


def test_maps_that_are_none() -> None:
    refused(lambda _, x: fixed_point(x, lambda y: x * y + 1), "between 0 and a bound below 1")
    refused(lambda b, x: fixed_point(x, lambda y: x / b.sqrt(y)), "divided by what does not")
    refused(lambda b, x: fixed_point(x, lambda y: b.sqrt(x - y)), "sums, products")
    refused(lambda b, x: fixed_point(x, lambda y: b.absolute(b.sqrt(y))), "sums, products")
    refused(lambda b, x: fixed_point(x, lambda _: b.sqrt(x)), "does not hold its unknown")
    refused(lambda b, x: fixed_point(x, lambda y: b.sqrt(x * y), within=0), "a positive number")
    refused(lambda _, x: near_cbrt(x), "stands in starts only")
    refused(lambda b, x: b.call("unknown", x, 1), "without a fixed point")
    refused(
        lambda b, x: fixed_point(x, lambda y: b.sqrt(x * y)) + b.call("unknown", x, "1/16"),
        "holds an unknown",
    )
    refused(
        lambda b, x: fixed_point(x, lambda y: b.sqrt(fixed_point(x + 1, lambda z: b.sqrt(y * z)))),
        "holds another unknown",
    )


def test_a_map_that_may_be_negative_is_refused() -> None:
    """sqrt(2 x - 1) meets x at 1 only by touching it."""
    b = GraphBuilder()
    x = b.symbol("x")
    graph = b.graph({"y": fixed_point(x, lambda y: b.sqrt(b.number(-1) + 2 * y))})
    with pytest.raises(PrintingError):
        prove(kernel_of(graph, lower="1/2", upper=2), FLOAT64)


@settings(max_examples=samples(60), deadline=None)
@given(
    st.floats(1e-6, 1e6), st.floats(1e-6, 1e6), st.floats(1e-6, 1e6), st.floats(0.001, 0.9),
    st.booleans(),
)  # fmt: skip
def test_newton_comes_as_close_as_is_proved(
    a: float, b: float, c: float, within: float, above: bool
) -> None:
    """sqrt(a + sqrt(b + c x)) in 200 bits: distances after a step, and that they are nearly met."""
    convergence = Convergence(Fraction(1, 4), Fraction(3, 16))
    with flint.ctx.workprec(200):
        root = flint.arb(1)
        for _ in range(110):
            root = flint.arb(_map(root, a, b, c)[0].mid())
        x = root * (1 + flint.arb(within)) if above else root / (1 + flint.arb(within))
        value, slope = _map(x, a, b, c)
        found = (value - x * slope) / (1 - slope) / root - 1
        bound = convergence.after_step(within)
        assert abs(found) <= flint.arb(bound) / (1 + flint.arb(bound)) + flint.arb("1e-40")


def _map(x: flint.arb, a: float, b: float, c: float) -> tuple[flint.arb, flint.arb]:
    """The map and its derivative."""
    inner = (flint.arb(b) + flint.arb(c) * x).sqrt()
    value = (flint.arb(a) + inner).sqrt()
    return value, flint.arb(c) / (4 * inner * value)


def test_the_bound_of_a_step_is_met() -> None:
    """Where the map is a power its curvature is the greatest: r^2/8 is not too large."""
    with flint.ctx.workprec(200):
        for within in (1e-3, 1e-2):
            x = flint.arb(1 + within)
            value = x.sqrt().sqrt()
            slope = value / x / 4
            found = float(((value - x * slope) / (1 - slope) - 1).mid())
            bound = Convergence(Fraction(1, 4), Fraction(3, 16)).after_step(within)
            assert 0.97 * bound < found < bound


def test_slopes_of_the_factor() -> None:
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    end = b.sqrt(2 + 2 * b.sqrt(1 + 2 * (y * x)))
    nodes = b.graph({"y": end})["nodes"]
    found = slopes(nodes, nodes.index(["symbol", "x"]), len(nodes) - 1)
    assert (found.least, found.most) == (Fraction(0), Fraction(1, 4))
    assert (found.turn_least, found.turn_most) == (Fraction(0), Fraction(3, 32))
    assert found.curvature == Fraction(3, 16)


@pytest.mark.parametrize("width", [1e-3, 0.3, 20.0, 1e6])
def test_the_fixed_point_and_its_slope_are_enclosed(width: float) -> None:
    """Over boxes narrow and wide: both ends, and the mean slope between them."""
    steps = program(gains_graph(FACTORS["white"], "1/2"))
    (cycle,) = steps.cycles
    root = cycle.iterates[-1]
    low = 10.0 ** np.random.default_rng(6).uniform(-20, 14, 40)
    grid = boxes.grid(low[None, :], (low * (1 + width))[None, :])
    with np.errstate(all="ignore"):
        found = Forward(steps, grid, FLOAT64).values[root]
    for box, (least, most) in enumerate(zip(grid.low[0], grid.high[0], strict=True)):
        ends = [enclosures(steps, float(x), FLOAT64, 300)[root] for x in (least, most)]
        logs = [float(end.log().mid()) for end in ends]
        mean = (logs[1] - logs[0]) / np.log(most / least)
        assert found.slope[0][0][box] - 1e-9 <= mean <= found.slope[1][0][box] + 1e-9
        for corner, end in enumerate(ends, 1):
            for row in (0, corner):
                size = [flint.arb(float(side[row][box])) for side in found.size]
                assert size[0] <= end <= size[1]
