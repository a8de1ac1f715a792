"""What is said of lost digits is never too little: against mpmath, at random expressions."""

from __future__ import annotations

import math
import random
import re
from fractions import Fraction
from typing import Any

import flint
import mpmath
import numpy as np
import pytest
import sympy as sp
from graph_kernels import function_of
from random_expressions import QUANTITIES, VALUE, W, X, Y, Z, cancelling
from samples import samples

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.graphs import graph_of_outputs
from gainproof.derive.own_expressions.parts import Parts
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.own_expressions.written_form import as_written
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.cancellation import cancelling as terms_at
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.lost_digits import with_losses
from gainproof.derive.printer.lost_digits_text import Loss, Part, loss_text, power
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.program import program
from gainproof.derive.printer.scaling import Group, groups
from gainproof.derive.printer.taylor import PRECISION, Enclosed, evaluated, monomials

DIGITS = 150


def computed(kernel: Kernel, places: list[dict[str, float]], form: Format) -> list[float]:
    """What the printed kernel computes."""
    kind = np.float32 if form is FLOAT32 else np.float64
    arrays = [np.array([place[each.name] for place in places], kind) for each in kernel.inputs]
    (found,) = function_of(kernel)(*arrays)
    assert found.dtype == kind
    return [float(x) for x in found]


def formed(given: ExpressionSet, searched: bool) -> tuple[Kernel, list[KernelBound]] | None:
    """The kernel and its bounds; None where nothing has a bound. `searched`: in any form."""
    try:
        made = derive_expressions(given).module.kernels if searched else None
        (kernel,) = made or (as_written(given.kernels[0]).kernel,)
        (bounds,) = prove_all([kernel])
    except ValueError:
        return None
    return kernel, list(with_losses(kernel, bounds))


def holds(part: Part, place: dict[str, float]) -> bool:
    """Whether a point lies in a part of the domain, as its text says."""
    sizes = {name: abs(x) for name, x in place.items()}
    return not part.empty and all(
        any(
            (low is None or value >= low * (1 - 1e-9))
            and (high is None or value <= high * (1 + 1e-9))
            for low, high in spans
        )
        for text, spans in part.ranges
        for value in [eval(text.replace("|", ""), {}, sizes)]  # noqa: S307 (our own text)
    )


def points(kernel: Kernel, bound: KernelBound, draw: random.Random) -> list[dict[str, float]]:
    """Ends of domains, numbers between, and numbers next to a few where terms are alike."""
    kind = np.float32 if bound.format is FLOAT32 else np.float64
    found = []
    for number in range(40):
        place: dict[str, float] = {}
        for (low, high), given in zip(bound.inputs, kernel.inputs, strict=True):
            low = low or high * 1e-12
            x = draw.choice(
                [low, high, math.exp(draw.uniform(math.log(low), math.log(high)))]
                if number < 30
                else [1.0, 2.0, 1 / 3, *place.values(), *(abs(x) * 1.001 for x in place.values())]
            )
            x = float(kind(min(max(abs(x), low), high)))
            x = min(max(x, low), high)
            place[given.name] = -x if given.signed and draw.random() < 0.4 else x
        found.append(place)
    return found


def check(given: ExpressionSet, seed: int) -> int:
    """How many outputs were told to lose digits; asserts that none loses more."""
    made = formed(given, searched=seed % 10 == 0)
    if made is None:
        return 0
    kernel, bounds = made
    expression = given.kernels[0].outputs[0].expression
    symbols = {each.quantity.name: each.quantity.symbol for each in given.kernels[0].inputs}
    exact = sp.lambdify(list(symbols.values()), expression, "mpmath")
    told = 0
    for bound in bounds:
        form, stated = bound.format, bound.outputs[0]
        told += stated.loss is not None
        places = points(kernel, bound, random.Random(seed))
        for place, value in zip(places, computed(kernel, places, form), strict=True):
            with mpmath.workdps(DIGITS):
                true = exact(*(mpmath.mpf(place[name]) for name in symbols))
                error = abs(mpmath.mpf(value) - true)
                below = stated.loss.below if stated.loss else 0.0
                if abs(true) <= max(below, 16 * form.least_normal):
                    continue
                lost = float(mpmath.log10(max(error / abs(true) / form.unit_roundoff, 1)))
            limit = most(stated.loss, float(stated.bound), form, place)
            assert lost <= limit + 1e-6, (seed, form.name, place, lost, stated)
    return told


def most(loss: Loss | None, bound: float, form: Format, place: dict[str, float]) -> float:
    """How many digits may be lost at a point by what is said."""
    if loss is None:
        return math.log10(2 * bound)
    half, quarter = (form.decimals * part for part in (0.5, 0.25))
    limit = math.inf if loss.digits == form.decimals else loss.digits
    if loss.halved is not None and not holds(loss.halved, place):
        limit = min(limit, half)
        if loss.halved.empty and loss.quartered is not None and not holds(loss.quartered, place):
            limit = min(limit, quarter)
    return limit


@pytest.mark.sampled
def test_no_output_loses_more_than_is_said() -> None:
    told = sum(check(cancelling(seed), seed) for seed in range(samples(12)))
    assert told >= samples(12) // 2


def told(expression: Any, *inputs: Argument) -> list[Loss]:
    """What is said of one expression, in both formats; nothing where nothing is lost."""
    kernel = ExpressionKernel("made", "A title", inputs, (Result(VALUE, expression),))
    bounds = prove_all([derived := as_written(kernel).kernel])[0]
    found = with_losses(derived, bounds)
    return [bound.outputs[0].loss for bound in found if bound.outputs[0].loss is not None]


def number(name: str, lower: str, upper: str, signed: bool = False) -> Argument:
    return Argument(QUANTITIES[name], lower, upper, signed=signed)


@pytest.mark.parametrize(
    ("expression", "rounded"),
    [
        # the bound in epsilons of the terms, which the docstring states: a function may err by 8 u
        (X + sp.exp(-X) - 1, 5.01),
        (X**2 / 2 - X + 1 - sp.exp(-X), 5.01),
        ((X - sp.sin(X)) / X**3, 6.01),
    ],
    ids=str,
)
def test_half_is_lost_up_to_where_mpmath_says(expression: Any, rounded: float) -> None:
    """The part ends where the bound over the value is told as half of the digits."""
    value = sp.lambdify([X], expression, "mpmath")
    for loss in told(expression, number("x", "1e-6", "3")):
        u = loss.form.unit_roundoff
        least = u * 10 ** (loss.form.decimals / 2 - 0.1)
        assert loss.half
        assert loss.halved is not None
        ((text, ((low, high),)),) = loss.halved.ranges
        assert (text, low) == ("x", None)
        assert high is not None
        with mpmath.workdps(60):
            sizes = [abs(part) for part in sp.Add.make_args(sp.fraction(expression)[0])]
            under = sp.fraction(expression)[1]
            terms = sp.lambdify([X], sum(sizes) / under, "mpmath")

            def excess(x: Any, u: float = u, least: float = least, terms: Any = terms) -> Any:
                return rounded * 2 * u * terms(x) / abs(value(x)) - least

            end = mpmath.findroot(excess, (high / 2, high * 1.1), solver="anderson")
        assert end <= high <= end * 1.25  # by the width of a box at most


def test_products_that_no_unit_changes_tell_the_part() -> None:
    """Of a variance over two inputs: t^3 and b t alone, whose third power is left of 1."""
    b, t = Y, X
    variance = (t - 2 * (1 - sp.exp(-b * t)) / b + (1 - sp.exp(-2 * b * t)) / (2 * b)) / b**2
    first, second = told(variance, number("x", "1e-3", "10"), number("y", "1e-5", "10"))
    assert first.halved is not None
    ((text, ((low, high),)),) = first.halved.ranges
    assert text in ("x*y", "y*x")
    # 107.1 eps (4/q)/(q^2/3) is the root of u at q = 0.031: the bound is somewhat larger
    assert low is None
    assert high is not None
    assert 0.01 < high < 0.1
    assert (first.digits, second.digits) == (16, 7)
    assert "exp" in first.terms


def test_differences_of_ranges_are_seen_through() -> None:
    """(r1 - r2) is 4 a x over r1 + r2: with y at most 1e5 a half is kept from x = 1000 a on."""
    x, y, a = W, Y, Z
    difference = sp.sqrt((x - a) ** 2 + y**2) - sp.sqrt((x + a) ** 2 + y**2)
    inputs = (
        number("w", "1e-1", "1e5", signed=True),
        number("y", "1", "1e5"),
        number("z", "1", "1e4"),
    )
    first, _ = told(difference, *inputs)
    assert first.halved is not None
    ((text, ((low, high),)),) = first.halved.ranges
    assert text == "|w|/z"
    assert low is None
    assert high is not None
    assert 50 < high < 1000
    assert first.terms.count("sqrt") == 2


def test_zeros_that_run_through_the_domain_are_told_by_a_share() -> None:
    """Two roundings u, of a product and of the sum: 2 u over the share is told as half."""
    inputs = (number(name, "1e-3", "1e3", signed=True) for name in "wxyz")
    for loss in told(W * X + Y * Z, *inputs):
        assert loss.half
        assert loss.halved is None
        assert loss.digits == loss.form.decimals
        assert loss.share == pytest.approx(2 * 10 ** (0.1 - loss.form.decimals / 2), rel=0.02)


def test_nothing_is_said_where_nothing_cancels() -> None:
    assert told(X * sp.exp(-X) + Y, number("x", "1", "2"), number("y", "1", "2")) == []
    # ranges that are apart: what is left is sure, and its bound relative to itself
    assert told(3 - sp.exp(-X), number("x", "1", "2")) == []
    (first, _) = told(3 * X - X * sp.exp(-X), number("x", "1/100", "10"))
    assert not first.half
    assert first.digits <= 2
    assert loss_text([first]).startswith("Digits that can be lost: up to ")


def test_scalings_are_found_from_the_program() -> None:
    b = GraphBuilder()
    x, y, z = b.symbol("x"), b.symbol("y"), b.symbol("z")
    graph = b.graph({"v": b.sqrt(x * x + y * y) - z * (x + y)})
    found, ones = groups(program(graph), [True, True, True])
    # x and y scale alike, z not at all; with x / y for both and z by itself
    assert ones == [1]
    assert [group.text(["x", "y", "z"]) for group in found] == ["x/y", "z"]
    graph = b.graph({"v": b.call("exp", -(x * y)) + 1})
    assert [g.text(["x", "y"], sized=True) for g in groups(program(graph), [True, True])[0]] == [
        "|x|*y"
    ]
    graph = b.graph({"v": x + 1})
    assert groups(program(graph), [True]) == ([Group(0, ())], [])


@pytest.mark.sampled
def test_values_lie_in_their_enclosures() -> None:
    draw = random.Random(3)
    for seed in range(samples(30)):
        given = cancelling(seed).kernels[0]
        parts = Parts()
        graph = graph_of_outputs({"v": parts.read(given.outputs[0].expression)}, parts)
        made, used = program(graph), monomials(len(given.inputs), 4)
        middle = [draw.uniform(0.5, 4.0) for _ in made.inputs]
        rooms = [draw.choice([0.001, 0.05, 0.2]) * x for x in middle]
        with flint.ctx.workprec(PRECISION):
            balls = [flint.arb(x, room) for x, room in zip(middle, rooms, strict=True)]
            jets = tuple(
                evaluated(
                    made, [used.variable(n, x) for n, x in enumerate(each)], used, made.outputs["v"]
                )
                for each in ([flint.arb(x) for x in middle], balls)
            )
            whole = Enclosed(made, used, (jets[0], jets[1]), [flint.arb(room) for room in rooms])
            ball, least = whole.ball(made.outputs["v"]), whole.least(made.outputs["v"])
        symbols = [sp.Symbol(name, real=True) for name in made.inputs]
        exact = sp.lambdify(symbols, given.outputs[0].expression, "mpmath")
        for _ in range(10):
            with mpmath.workdps(60):
                place = [
                    x + draw.choice([-1, 1, draw.uniform(-1, 1)]) * room * 0.999999
                    for x, room in zip(middle, rooms, strict=True)
                ]
                value = exact(*map(mpmath.mpf, place))
                text = mpmath.nstr(value, 55)
            with flint.ctx.workprec(PRECISION):
                assert not ball.is_finite() or ball.overlaps(flint.arb(text)), (seed, place)
                assert not least > abs(flint.arb(text)), (seed, place)


def test_what_cancels_is_told_in_names_that_are_explained() -> None:
    """Short sums whole; long ones by a name that is known, or by parts without inner names."""
    b = GraphBuilder()
    x, y = b.symbol("x"), b.symbol("y")
    long = x
    for _ in range(60):
        long = b.sqrt(long + y * x)
    inner, short = long * y, x - y
    graph = b.graph({"v": inner - x * y, "w": short}, {"inner": inner, "mine": inner - x * y})
    made = program(graph)
    place = [Fraction(2), Fraction(2)]

    def said(output: str, *known: str) -> str:
        end = made.outputs[output]
        return terms_at(made, end, {end}, place, FLOAT64, {"x", "y", *known})

    assert said("w") == "x - y"
    assert said("v") == ""
    assert said("v", "mine") == "the terms of mine"
    nameless = program(b.graph({"v": inner - x * y}, {"root": long}))
    end = nameless.outputs["v"]
    text = terms_at(nameless, end, {end}, place, FLOAT64, {"x", "y"})
    assert re.fullmatch(r"[-+*/() .xy]+|.*sqrt.*- x\*y", text)
    assert "root" not in text


def test_powers_are_the_nearest_floats_whatever_the_platform_s_are() -> None:
    draw = random.Random(3)
    for _ in range(300):
        base = math.exp(draw.uniform(-300, 300))
        exponent = Fraction(draw.choice([-3, -1, 1, 2, 39]), draw.choice([1, 2, 3, 10]))
        with mpmath.workdps(60):
            true = mpmath.mpf(base) ** (mpmath.mpf(exponent.numerator) / exponent.denominator)
            wanted = float(true)
        if 1e-300 < wanted < math.inf:
            assert power(base, exponent) == wanted
    assert power(1e300, Fraction(2)) == math.inf
