"""What `gainproof bench` measures of a kernel, by a small kernel of two inputs."""

from __future__ import annotations

import math
import pkgutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from graph_kernels import module_of, several_of

import gainproof.generated
from gainproof.bad_input import BadInputError
from gainproof.bench import against, errors, measure, one_number, rivals
from gainproof.bench.accuracy import terms
from gainproof.bench.arguments import sample, with_constants
from gainproof.bench.compiler import compiled, compiler
from gainproof.bench.solver import matrix, solver_seconds
from gainproof.bench.subjects import Measured, measured_kernels
from gainproof.cli import main
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.filter_step import subject
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.c_language.module import c_function
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Input, Output, closed
from gainproof.generated import filter_step
from gainproof.generated._blocks import BLOCK, Span
from gainproof.generated._runtime import Call, run
from gainproof.generated._signature import Signature

NAMES = ("tracking_index", "velocity_ratio")
SQUARE = {"nodes": [["symbol", "velocity_ratio"], ["mul", 0, 0]], "outputs": {"value": 1}}
MODEL: dict[str, Any] = {
    "transition": [["1", "1"], ["0", "1"]],
    "process_noise": [["1/3", "1/2"], ["1/2", "1"]],
    "measurement": [["1", "0"], ["0", "1"]],
    "measurement_noise": [["1", "0"], ["0", SQUARE]],
}


def item() -> Measured:
    """sqrt(x^2 + z) and its quotient by z, not symmetric in the inputs."""
    b = GraphBuilder()
    x, z = (b.symbol(name) for name in NAMES)
    root = b.sqrt(x * x + z)
    graph = b.graph({"root": root, "share": root / z})
    inputs = tuple(closed(name, "an argument", "1e-9", "1e9") for name in NAMES)
    kernel = replace(several_of(graph, 1, 2), inputs=inputs)
    space = module_of(kernel)
    index, ratio = sp.symbols(NAMES)
    plain = sp.sqrt(index**2 + ratio)
    return Measured(
        "made",
        kernel,
        space["kernel"],
        space["_KERNEL"],
        prove(kernel, FLOAT64),
        {"root": plain, "share": plain / ratio},
        MODEL,
    )


def test_a_kernel_of_two_inputs_is_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(measure, "SIZE", 2 * BLOCK)
    found = measure.figures(item(), tmp_path, measure.Options())
    wanted = {"kernel", "shared", "fresh", "passes", "memory", "lambdify", "SciPy"}
    wanted |= {"one number", "formula", "thousand"}
    in_c = {*measure.COMPILED, *measure.IN_C} if compiler() else set()
    assert set(found.seconds) == wanted | in_c
    assert all(0 < seconds < math.inf for seconds in found.seconds.values()), found.seconds
    assert ("C" in found.missing) == (compiler() is None)
    assert found.ratio("kernel", "kernel") == 1
    assert found.ratio("kernel", "numexpr") is None
    assert [each.name for each in found.errors] == ["root", "share"]
    assert all(0.4 < each.worst <= each.proved for each in found.errors)
    assert all(each.worst <= each.ulps <= 2 * each.worst for each in found.errors)
    assert not found.outside


def test_time_against_length_and_number_of_points(monkeypatch: pytest.MonkeyPatch) -> None:
    """Every block length fills every output; one number beside arrays stays one."""
    seen: dict[str, list[Any]] = {}

    def once(
        calls: Mapping[str, Callable[[], Any]], rounds: int, threaded: Sequence[str] = ()
    ) -> dict[str, float]:
        assert list(threaded) == [name for name in calls if "threads" in name]
        for name, call in calls.items():
            seen[name] = call()
        return dict.fromkeys(calls, 1e-9 * rounds)

    monkeypatch.setattr(against, "SIZE", 1000)
    monkeypatch.setattr(against, "POINTS", 4000)
    assert BLOCK in against.LENGTHS  # it is marked
    monkeypatch.setattr(against, "LENGTHS", (64, 999))
    monkeypatch.setattr(against, "SIZES", (100, 2000))
    monkeypatch.setattr(against, "best_times", once)
    filled: list[Any] = []

    def watched(call: Call, shares: list[list[Span]]) -> None:
        run(call, shares)
        filled.append((call, shares))

    monkeypatch.setattr(against, "run", watched)
    made = item()
    expected = made.function(*sample(made.signature, 1000))
    assert against.lengths(made) == {64: pytest.approx(4e-3), 999: pytest.approx(4e-3)}
    assert [[len(spans) for spans in shares] for _, shares in filled] == [[16], [2]]
    assert [shares[0][-1][1] for _, shares in filled] == [1000, 1000]
    for call, _ in filled:
        np.testing.assert_array_equal(call.results, expected)
    rows = dict(against.sizes(made, 3, "velocity"))
    assert list(rows) == ["given", "fresh", "3 threads"]
    assert rows["given"] == [pytest.approx(0.4), pytest.approx(2.5e-3)]
    index, ratio = sample(made.signature, 1000)
    expected = made.function(np.tile(index, 2), ratio[0])
    for found in seen.values():
        if found is not None:
            np.testing.assert_array_equal(found, expected)


def test_numbers_in_place_of_arrays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "SIZE", 2 * BLOCK)
    monkeypatch.setattr(errors, "POINTS", 3)
    made = replace(item(), model=None)
    given = with_constants(made.signature, sample(made.signature, 5), "track")
    assert [np.shape(each) for each in given] == [(), (5,)]
    found = measure.figures(made, tmp_path, measure.Options(constant="track"))
    assert {"C", "C function"} <= set(found.missing), "C reads arrays"
    assert {"lambdify", "fresh"} <= set(found.seconds)


def test_a_few_numbers_each_with_each(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(measure, "SIZE", 2 * BLOCK)
    monkeypatch.setattr(errors, "POINTS", 3)
    made = replace(item(), model=None)
    columns = sample(made.signature, 8)
    given = with_constants(made.signature, columns, "track", 2)
    assert [each.shape for each in map(np.asarray, given)] == [(2,), (4, 1)]
    expected = made.function(*given)
    answers = [rivals.lambdified(made)(*given)]
    if find_spec("numba"):
        answers.append(rivals.with_numba(made, given, tmp_path)())
    for found in answers:
        for mine, reference in zip(found, expected, strict=True):
            np.testing.assert_allclose(np.reshape(mine, (4, 2)), reference, rtol=1e-6)
    timed = measure.figures(made, tmp_path, measure.Options(constant="track", numbers=2))
    assert {"lambdify", "fresh", "passes"} <= set(timed.seconds)


def test_numbers_of_no_input_are_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "random-velocity", "--numbers", "4"]) == 2
    assert "--constant PREFIX" in capsys.readouterr().err
    options = ["--numbers", "4", "--constant", "track", "--against", "size"]
    assert main(["bench", "random-velocity", *options]) == 2
    assert "leave" in capsys.readouterr().err


@pytest.mark.parametrize(
    "options",
    [["--workers", "0"], ["--workers", "two"], ["--against", "x"], ["--numbers", "3"]],
)
def test_options_that_are_none(options: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["bench", "random-velocity", *options])
    assert ended.value.code == 2
    assert options[1] in capsys.readouterr().err


def test_what_is_compared_computes_the_same(tmp_path: Path) -> None:
    made = item()
    given = [np.array([3.0, 0.5, 7.0]), np.array([16.0, 2.0, 1e-3])]
    expected = made.function(*given)
    for found, reference in zip(rivals.lambdified(made)(*given), expected, strict=True):
        np.testing.assert_allclose(found, reference, rtol=1e-15)
    if compiler() is not None:
        outputs = [np.empty(3) for _ in expected]
        compiled(c_loop(made.kernel), "kernel", tmp_path)(given, outputs)
        for found, reference in zip(outputs, expected, strict=True):
            np.testing.assert_array_equal(found, reference)
            found.fill(np.nan)
        guarded = compiled(*c_function(made.kernel, made.bound), tmp_path, guarded=True)
        guarded(given, outputs)
        for found, reference in zip(outputs, expected, strict=True):
            np.testing.assert_array_equal(found, reference)
            found.fill(np.nan)
        with pytest.raises(ValueError, match="refuses"):
            guarded([given[0], np.array([16.0, 2.0, -1.0])], outputs)
        assert np.isnan(outputs).all(), "nothing is written"


def test_the_plain_formula_of_a_graph(tmp_path: Path) -> None:
    """What a kernel of single numbers is measured beside: the graph by `math`, nothing else."""
    plain = one_number.formula(item().kernel, tmp_path / "made")
    assert plain(3.0, 16.0) == (5.0, 5.0 / 16.0)
    builder = GraphBuilder()
    x, exp = builder.symbol("x"), builder.symbol("exp")
    ends = {name: builder.call(name, x) for name in ("sin", "expm1")}
    chosen = builder.select(x, 2, Fraction(1, 10), -x)
    ends |= {"atan2": builder.call("atan2", x, exp), "chosen": chosen * exp}
    outputs = tuple(Output(name, "a number") for name in ends)
    kernel = replace(item().kernel, graph=builder.graph(ends), outputs=outputs)
    kernel = replace(kernel, inputs=tuple(Input(name, "a number") for name in ("x", "exp")))
    plain = one_number.formula(kernel, tmp_path)
    assert plain(1.0, 4.0) == (math.sin(1.0), math.expm1(1.0), math.atan2(1.0, 4.0), 0.1 * 4.0)
    assert plain(3.0, 4.0)[-1] == -12.0
    source = one_number.formula_source(kernel)
    assert "form" not in source.replace("formula", "")


def test_a_wrong_value_is_seen() -> None:
    made = item()
    assert not any(each.outside for each in errors.worst_errors(made))
    function: Any = made.function
    spoiled = replace(made, function=lambda *xs: [y * (1 + 2.0**-50) for y in function(*xs)])
    assert all(each.outside > 300 for each in errors.worst_errors(spoiled))


def test_nan_and_one_output_among_others_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """The other output has the greater error, inside its bound."""
    monkeypatch.setattr(errors, "POINTS", 20)
    function: Any = item().function

    def spoiled(*xs: Any) -> list[Any]:
        root, share = (y.copy() for y in function(*xs))
        root[7] = np.nan
        return [root, share]

    root, share = errors.worst_errors(replace(item(), function=spoiled))
    assert (root.outside, root.worst, share.outside) == (1, np.inf, 0)


def test_the_solver_gets_the_model_at_the_point() -> None:
    assert matrix(MODEL["measurement_noise"], {"velocity_ratio": 3.0}).tolist() == [[1, 0], [0, 9]]
    assert solver_seconds(MODEL, ("alpha",)) is None
    assert solver_seconds(MODEL, ("tracking_index",)) is None, "the ratio has no value"
    seconds = solver_seconds(MODEL, NAMES)
    assert seconds is not None
    assert seconds > 0


def test_a_kernel_of_signed_inputs_is_measured_over_its_terms(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A filter step: arguments of either sign inside the domain, errors over what may cancel."""
    monkeypatch.setattr(measure, "SIZE", 2 * BLOCK)
    monkeypatch.setattr(errors, "POINTS", 20)
    step = subject.build().module.kernels[0]
    measured = Measured(
        "filter-step",
        step,
        filter_step.step_two_states,
        filter_step._STEP_TWO_STATES,
        prove(step, FLOAT64),
        None,
        None,
    )
    given = sample(measured.signature, 100)
    assert {bool((x < 0).any()) for x in given} == {True, False}
    found = measure.figures(measured, tmp_path, measure.Options())
    assert all(0 < each.worst <= each.proved for each in found.errors)
    assert ("C" in found.seconds) == (compiler() is not None)


def test_terms_are_taken_positive() -> None:
    builder = GraphBuilder()
    x, y = builder.symbol("x"), builder.symbol("y")
    graph = builder.graph({"z": x * y - x})
    assert float(terms(graph, {"x": -2.0, "y": 3.0})["z"]) == 8.0


def test_what_a_sum_is_divided_by_is_no_sum_of_terms() -> None:
    """x (p - q)/sqrt((p - q)^2 + x^2): differences of inputs are exact, roots what they are."""
    builder = GraphBuilder()
    x, p, q = (builder.symbol(name) for name in "xpq")
    apart = p - q
    root = builder.sqrt(apart * apart + x * x)
    graph = builder.graph({"z": x * apart / root - x})
    found = terms(graph, {"x": -4.0, "p": 2.0, "q": 5.0})["z"]
    assert float(found) == 4.0 * 3.0 / 5.0 + 4.0


@pytest.mark.parametrize(
    ("subject_name", "kernel"),
    [("polar-coordinates", "to_polar"), ("range-doppler", "range_doppler_in_plane")],
)
def test_kernels_of_a_library_and_of_two_points_are_measured(
    subject_name: str, kernel: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Sine, cosine and atan2 in balls; points that fall together are left out."""
    monkeypatch.setattr(errors, "POINTS", 20)
    (found,) = [each for each in measured_kernels([subject_name]) if each.kernel.name == kernel]
    met = errors.worst_errors(found)
    assert max(each.worst for each in met) > 0.3
    assert not any(each.outside for each in met)
    if found.textbook is None:
        return
    given = sample(found.signature, 50)
    for plain, value in zip(rivals.lambdified(found)(*given), found.function(*given), strict=True):
        np.testing.assert_allclose(plain, value, rtol=1e-9, atol=1e-9 * np.abs(value).max())


def test_every_kernel_takes_the_arguments_that_it_is_timed_at() -> None:
    for found in pkgutil.iter_modules(gainproof.generated.__path__, "gainproof.generated."):
        module = import_module(found.name)
        for signature in vars(module).values():
            if not isinstance(signature, Signature):
                continue
            function = getattr(module, signature.name)
            assert np.isfinite(function(*sample(signature, 200))).all(), signature.name


def test_an_unknown_subject() -> None:
    with pytest.raises(BadInputError, match="no subject is called 'random-jerks'; nearest: random"):
        next(measured_kernels(["random-jerks"]))


@pytest.mark.thorough
@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_every_kernel_is_measured(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(measure, "SIZE", 2 * BLOCK)
    monkeypatch.setattr(errors, "POINTS", 3)
    for item in measured_kernels([name]):
        found = measure.figures(item, tmp_path, measure.Options())
        assert not found.outside, item.kernel.name


def test_where_the_truth_is_0_nothing_else_is_within_the_bound(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Target and station level with each other: no share of 0 is an error, and any number is."""
    monkeypatch.setattr(errors, "POINTS", 20)
    name = "range_jacobian_in_plane"
    (made,) = [each for each in measured_kernels(["range-doppler"]) if each.kernel.name == name]
    met = errors.worst_errors(made)
    assert all(each.worst <= each.proved and not each.outside for each in met)
    function: Any = made.function

    def spoiled(*xs: Any) -> list[Any]:
        return [np.where(y == 0, 1e-300, y) for y in function(*xs)]

    found = errors.worst_errors(replace(made, function=spoiled))
    assert any(each.outside and each.worst == np.inf for each in found)
