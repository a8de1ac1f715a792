"""The sweep of float32 inputs: a seeded thousandth of them, and errors that it must not miss."""

from __future__ import annotations

import inspect
import random
import re
from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from graph_kernels import simple
from printed_kernels import printed_kernels

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import compiler
from gainproof.campaign import float32
from gainproof.campaign.campaign import Done, Report
from gainproof.campaign.float32 import kernels, sweep
from gainproof.campaign.float32.compiled import Compiled, Measure, measure, measure_of
from gainproof.campaign.float32.kernels import Swept, swept_kernels
from gainproof.campaign.float32.reference import Compared, Reference, reference
from gainproof.campaign.float32.report import Row, report
from gainproof.campaign.float32.stated import Stated, stated
from gainproof.campaign.float32.sweep import block
from gainproof.campaign.float32.tally import Tallied, joined
from gainproof.campaign.float32.traced import OURS
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT64

KERNELS = {kernel.id: kernel for kernel in swept_kernels()}
PIECES = 16
ONE_OF_EACH_KIND = (
    "random_velocity.gains",
    "random_acceleration.closed_loop_poles",  # errors over a modulus that is no output, a choice
    "least_squares_mean.gains",  # whole numbers
    "acceleration_increments.gains",  # a root by Newton's steps
)
SAME = simple(lambda _builder, x: x)
"""A kernel whose output is its input."""
OUTPUT = Compared("y", 0, 0, 1.0, 8.0)
PROMISE = Stated(None, 2.0, 2.0, 1.0, 8.0)
needs_compiler = pytest.mark.skipif(compiler() is None, reason="no C compiler")
WAYS = [pytest.param("C", marks=needs_compiler), "NumPy"]


def pieces(kernel: Swept, size: int) -> list[int]:
    """The bits where seeded pieces of the inputs begin, both ends among them."""
    inner = random.Random(kernel.id).sample(range(kernel.start, kernel.stop - size), PIECES - 2)
    return [kernel.start, *sorted(inner), kernel.stop - size]


def thousandth(kernel: Swept) -> Report:
    """What is reported of a thousandth of the inputs."""
    size = (kernel.stop - kernel.start) // (1000 * PIECES)
    arguments = (kernel.id, kernel.digest())
    starts = pieces(kernel, size)
    return float32.campaign([kernel.id]).report(
        [Done(arguments, block(*arguments, first, size), 0.0) for first in starts]
    )


@needs_compiler
@pytest.mark.parametrize("name", ONE_OF_EACH_KIND)
def test_a_thousandth_of_the_inputs(name: str) -> None:
    found = thousandth(KERNELS[name])
    assert found.passed, found.text


@needs_compiler
@pytest.mark.thorough
@pytest.mark.parametrize("module", sorted({kernel.module for kernel in KERNELS.values()}))
def test_a_thousandth_of_the_inputs_of_all(module: str) -> None:
    for kernel in KERNELS.values():
        if kernel.module == module:
            found = thousandth(kernel)
            assert found.passed, found.text


def test_the_kernels_are_those_of_one_input() -> None:
    """As another reader of the printed modules has them."""
    assert list(KERNELS) == [kernel.id for kernel in printed_kernels()]


def agree(kernel: Swept) -> None:
    """C and NumPy find the same, in whatever parts the inputs come."""
    wanted = reference(kernel)
    in_c, in_numpy = Compiled(measure(kernel), wanted.outputs), Tallied(wanted)
    for first in pieces(kernel, 1500):
        x = np.arange(first, first + 1500, dtype=np.int32).view(np.float32)
        x = x[x == np.floor(x)] if kernel.whole else x
        y = kernel.function(x)
        in_numpy.add(x, y)
        for part in (slice(0, 700), slice(700, None)):
            in_c.add(x[part], [each[part] for each in y])
    assert in_c.tallies() == in_numpy.tallies()


@needs_compiler
@pytest.mark.parametrize("name", ONE_OF_EACH_KIND)
def test_c_and_numpy_find_the_same(name: str) -> None:
    agree(KERNELS[name])


@needs_compiler
@pytest.mark.thorough
@pytest.mark.parametrize("module", sorted({kernel.module for kernel in KERNELS.values()}))
def test_c_and_numpy_find_the_same_of_all(module: str) -> None:
    for kernel in KERNELS.values():
        if kernel.module == module:
            agree(kernel)


def test_without_a_compiler_numpy_measures(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep, "compiler", lambda: None)
    kernel = KERNELS["least_squares_mean.gains"]
    assert isinstance(sweep.measured_by(kernel), Tallied)
    found = block(kernel.id, kernel.digest(), kernel.stop - 100, 100)
    assert found["inputs"] == 100
    assert 0 < found["outputs"]["alpha"]["worst"] < 1.01


def test_the_digest_is_of_what_determines_the_errors(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another step of the arithmetic, of what it calls, or of what is measured, another domain and
    range of a bound; not other words, other bounds or other guards.
    """
    kernel = KERNELS["acceleration_increments.gains"]
    digest, text = kernel.digest(), str(kernel.function.__doc__)

    def described(words: str) -> str:
        def function() -> None: ...

        function.__doc__ = words
        return replace(kernel, function=function).digest()

    def signed(**changed: Any) -> str:
        return replace(kernel, signature=kernel.signature._replace(**changed)).digest()

    assert described(text) == described(text + " More.") == digest
    assert described(re.sub(r"at most \S+ \*", "at most 9.99 *", text)) == digest
    assert described(text.replace("1e-45", "1e-44")) != digest
    assert (
        signed(block=KERNELS["acceleration_increments.predictor_gains"].signature.block) != digest
    )
    (domain,) = kernel.signature.inputs
    assert signed(inputs=(domain._replace(wanted="other words"),)) == digest
    assert signed(inputs=(domain._replace(single=(1.0, 2.0)),)) != digest

    def near_cbrt() -> None:
        """Of other code."""

    monkeypatch.setattr(kernels, "_bits", SimpleNamespace(near_cbrt=near_cbrt))
    assert kernel.digest() != digest
    monkeypatch.setattr(kernels, "measuring_code", lambda: b"other")
    assert KERNELS["random_velocity.gains"].digest() != described(text)


def harmed(kernel: Swept, old: str, new: str) -> str:
    """The digest with one place of the block's text changed."""
    block = kernel.signature.block
    text = inspect.getsource(block)
    assert text.count(old) == 1
    space = {**block.__globals__, "np": np}
    exec(compile(text.replace(old, new), "made.py", "exec"), space)  # noqa: S102
    changed = kernel.signature._replace(block=space[block.__name__])
    return replace(kernel, signature=changed).digest()


def test_the_digest_is_of_what_is_computed_and_not_of_where() -> None:
    kernel = KERNELS["random_acceleration.gains_with_derivatives"]
    text = inspect.getsource(kernel.signature.block)
    (last,) = re.findall(r"    multiply\((\w+), (\w+), (d_beta)\)", text)
    one, other, out = last
    place = f"multiply({one}, {other}, {out})"
    assert harmed(kernel, place, f"multiply({one}, {other}, out={out})") == kernel.digest()
    assert harmed(kernel, "w0, w1, w2 = work", "w1, w0, w2 = work") == kernel.digest()
    for other_text in (f"multiply({one}, {one}, {out})", f"add({one}, {other}, {out})"):
        assert harmed(kernel, place, other_text) != kernel.digest()
    # another number, a value that is overwritten before it is read, an output that is not filled
    assert harmed(kernel, "n2: float = 0.25", "n2: float = 0.75") != kernel.digest()
    scaled = "t8 = multiply(tracking_index, n2, w1)"
    assert harmed(kernel, scaled, scaled.replace("w1", "w0")) != kernel.digest()
    assert harmed(kernel, f"    {place}\n", "") != kernel.digest()
    # a value may be copied on the way; what is more than functions of one result is refused
    twice = f"multiply({one}, {other}, w0)\n    np.copyto({out}, w0)"
    assert harmed(kernel, place, twice) == kernel.digest()
    for refused in (
        f"np.copyto({out}, w0, where=less(w0, w1))",
        f"np.modf({one}, {out}, w0)",
        f"np.concatenate([w0, w1], out={out})",
    ):
        with pytest.raises(TypeError):
            harmed(kernel, place, refused)


def test_the_digest_refuses_what_looks_at_the_bits_of_the_other_type() -> None:
    kernel = KERNELS["acceleration_increments.gains"]
    text = inspect.getsource(kernel.signature.block)
    (call,) = re.findall(r"near_cbrt\(.*, single\)", text)
    with pytest.raises(TypeError, match="near_cbrt is called for the other type"):
        harmed(kernel, call, call.replace(", single)", ", not single)"))


def test_words_are_no_code() -> None:
    text = '"""A module."""\nX = 1\n"""A one."""\ndef f():\n    """It is."""\n    return X\n'
    assert kernels.without_words(text) == kernels.without_words("X=1#\ndef f():\n\n  return X")
    assert kernels.without_words(text) != kernels.without_words(text.replace("= 1", "= 2"))


def test_kernels_take_only_what_every_numpy_rounds_alike() -> None:
    """Why NumPy's version is no part of a digest."""
    rounded = {"add", "subtract", "multiply", "square", "divide", "sqrt"}
    exact = {"negative", "absolute", "less", "minimum", "copyto"}
    for kernel in KERNELS.values():
        called = set(re.findall(r"\b(\w+)\(", inspect.getsource(kernel.signature.block)))
        assert called - {f"_{kernel.name}_block", *OURS} <= rounded | exact, kernel.id


def test_what_is_stated_is_read_from_docstrings() -> None:
    for kernel in KERNELS.values():
        assert len(kernel.stated) == len(kernel.signature.outputs), kernel.id
        for each in kernel.stated:
            assert each.doubt < 2e-7 < 0.01 <= each.bound
    (found, *_) = KERNELS["random_acceleration.gains"].stated
    assert found.scale is None
    assert found.highest == np.finfo(np.float32).max
    poles = KERNELS["random_acceleration.closed_loop_poles"].stated
    assert {each.scale for each in poles} == {"first_modulus", "second_modulus"}
    text = "y: it. Relative error at most 1.5 * 2^-52 (float64), 2.5 * 2^-23 (float32), proved for "
    wide = stated(text + "1e-300 <= x <= 4.0 (float64) and 0.1 <= x <= 4.0 (float32).")
    assert wide == (Stated(None, 2.5, 1.5, float(np.float32(0.1)), 4.0),)
    with pytest.raises(ValueError, match=r"bounds hold for 1\.0 to 4\.0, in float32 0\.1"):
        stated(text + "1.0 <= x <= 4.0 (float64) and 0.1 <= x <= 4.0 (float32).")


@pytest.mark.thorough
def test_scales_are_computed_as_well_as_it_is_taken_for_granted() -> None:
    """Of `Stated.doubt`: each scale is off by less than 2^10 units of 2^-52."""
    for kernel in KERNELS.values():
        extra = {each.scale for each in kernel.stated} - {None, *kernel.signature.outputs}
        if extra:
            graph = reference(kernel).kernel
            rows = tuple(row for row in graph.outputs if row.name in extra)
            assert len(rows) == len(extra)
            found = prove(replace(graph, outputs=rows), FLOAT64)
            for each in found.outputs:
                assert each.bound < 2**10, (kernel.id, each.name)
                assert each.lowest <= min(promise.lowest for promise in kernel.stated)
                assert each.highest >= max(promise.highest for promise in kernel.stated)


def test_the_blocks_are_all_inputs() -> None:
    """Every float32 number above 0, once; gains first."""
    campaign = float32.campaign(["random_velocity"])
    assert campaign.blocks[0][0] == "random_velocity.gains"
    bits = [b[2:] for b in campaign.blocks if b[0] == "random_velocity.gains"]
    assert bits[0][0] == 1
    assert all(first + count == bits[i + 1][0] for i, (first, count) in enumerate(bits[:-1]))
    largest = int(np.finfo(np.float32).max.view(np.int32))
    assert sum(bits[-1]) - 1 == largest
    assert sum(count for _, count in bits) == 2**31 - 2**23 - 1


def test_the_same_arithmetic_is_swept_once() -> None:
    one = float32.campaign(["acceleration_increments.gains"])
    other = float32.campaign(["wiener_acceleration.gains"])
    both = float32.campaign(["acceleration_increments.gains", "wiener_acceleration.gains"])
    assert one.blocks == other.blocks == both.blocks
    assert {arguments[0] for arguments in one.blocks} == {"acceleration_increments.gains"}
    every = float32.campaign()
    assert len({arguments[1:] for arguments in every.blocks}) == len(every.blocks)
    named = {name for name, *_ in every.blocks}
    assert {KERNELS[name].digest() for name in named} == {k.digest() for k in KERNELS.values()}


def test_another_kernel_than_the_one_of_the_digest_is_refused() -> None:
    kernel = KERNELS["least_squares_mean.gains"]
    with pytest.raises(BadInputError, match="install the same gainproof"):
        block(kernel.id, "0" * 16, kernel.start, 10)


@cache
def measure_of_same() -> Measure:
    """Compiled once for all tests of a process."""
    return measure_of(SAME)


def measured(way: str, results: list[float], *parts: int, output: Compared = OUTPUT) -> Any:
    """The tally of results for the inputs 0.5, 1, 2, 4, ..., which they should be; the inputs come
    in parts that end where it is said.
    """
    x = np.ldexp(np.float32(0.5), np.arange(len(results)))
    y = np.array(results, np.float32)
    found = Reference(SAME, (output,))
    made = Compiled(measure_of_same(), found.outputs) if way == "C" else Tallied(found)
    for start, stop in zip((0, *parts), (*parts, x.size), strict=True):
        made.add(x[start:stop], (y[start:stop],))
    return made.tallies()["y"]


def reported(*tallies: Any) -> Report:
    """What is said of blocks of one kernel."""
    results = [{"inputs": 4, "outputs": {"y": each}} for each in tallies]
    done = [Done(("a.kernel", "0", block, 4), each, 0.0) for block, each in enumerate(results)]
    return report({"0": Row("a.kernel", (PROMISE,), 2)}, done)


@pytest.mark.parametrize("way", WAYS)
def test_errors_are_in_units_of_the_bound_and_in_the_last_place(way: str) -> None:
    unit = 2.0**-23
    odd = Compared("y", 0, 0, 0.75, 3.0)
    found = measured(way, [0.0, 1.0 + unit, 2.0 - 3 * unit, 4.0], output=odd)
    assert found == {"worst": 1.5, "at": 2.0, "ulp": 1.5, "outside": 2, "undocumented": 1}
    # an error over 1.5 is less than one over its power of two
    third = Reference(simple(lambda _builder, x: x / 2), (OUTPUT,))
    made = Compiled(measure_of(third.kernel), (OUTPUT,)) if way == "C" else Tallied(third)
    made.add(np.array([3.0], np.float32), [np.array([1.5 * (1 + unit)], np.float32)])
    (tally,) = made.tallies().values()
    assert tally["worst"] == 2 / 1.5
    assert tally["ulp"] == 2.0


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("wrong", [2 + 6 * 2.0**-23, float("nan"), float("inf"), -2.0, 0.0])
def test_a_wrong_result_is_above_its_bound(way: str, wrong: float) -> None:
    found = measured(way, [0.0, 1.0, wrong, 4.0], 2)
    assert found["at"] == 2.0
    assert found["worst"] > PROMISE.bound
    assert not reported(found).passed
    assert not reported(measured(way, [0.0, 1.0, 2.0, 4.0]), found).passed
    assert reported(measured(way, [0.0, 1.0, 2.0, 4.0])).passed


def test_what_the_reference_leaves_in_doubt_is_above_the_bound() -> None:
    close = measured("NumPy", [0.0, 1.0, 2 + 4 * 2.0**-23, 4.0])
    assert close["worst"] == 2.0 == PROMISE.bound
    assert not reported(close).passed
    assert reported({**close, "worst": 2.0 - PROMISE.doubt}).passed


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("wrong", [float("nan"), 1.0, -1e-30, 3e38])
def test_what_is_not_documented_outside_the_range_is_counted(way: str, wrong: float) -> None:
    narrow = replace(OUTPUT, highest=1.0)
    for place in (0, 2):
        results = [0.0, 1.0, 0.0]
        results[place] = wrong
        found = measured(way, results, output=narrow)
        assert (found["outside"], found["undocumented"], found["worst"]) == (2, 1, 0)
        assert not reported(found).passed
    for fine in (0.0, -1e-45, 2.0**-126, float("inf"), -float("inf")):
        assert not measured(way, [0.0, 1.0, fine], output=narrow)["undocumented"]


@pytest.mark.parametrize("way", WAYS)
def test_the_first_of_equal_errors_counts_however_parts_are_cut(way: str) -> None:
    """NaN and infinite are equal; of no input there is no error."""
    nan, inf = float("nan"), float("inf")
    for parts in ((), (1,), (2, 3), (1, 2, 3, 4)):
        for results, at in (
            ([0.0, 1.0, 2 + 2.0**-22, 4 + 2.0**-21, 8.0], 2.0),
            ([0.0, nan, inf, 4.0, 8.0], 1.0),
            ([0.0, 1.0, inf, nan, 8.0], 2.0),
            ([0.0, 1.0, 2.0, 4.0, 8.0], 1.0),
        ):
            found = measured(way, results, *parts)
            assert found["at"] == at
            assert found["outside"] == 1
            assert found["worst"] == found["ulp"] or not np.isfinite(found["worst"])
    empty = measured(way, [0.0, 5.0], output=replace(OUTPUT, lowest=16.0))
    assert (empty["worst"], empty["at"], empty["ulp"]) == (0.0, None, 0.0)
    assert joined([empty, measured(way, [0.0, 1.0])])["at"] == 1.0


def test_a_table_names_what_is_not_whole() -> None:
    fine = measured("NumPy", [0.0, 1.0, 2.0])
    assert "a.kernel `0`, 1 of 2 blocks |" in reported(fine).text
    assert "0 kernels whole, 4 inputs, outputs not as stated: 0" in reported(fine).text
    assert "1 kernels whole, 8 inputs, outputs not as stated: 0" in reported(fine, fine).text
