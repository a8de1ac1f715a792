"""Problems of numerical methods that lose digits as written, and the forms found for them.

The problems are of the kind that Hamming (Numerical Methods for Scientists and Engineers, chapter
3) collects and FPBench names; the statements, domains and limits are ours. The value of what is
given comes from mpmath, that of the form from python-flint.
"""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass
from fractions import Fraction

import flint
import numpy as np
import pytest
import sympy as sp
from mpmath import mp
from signed_graphs import with_terms

from gainproof.derive.expression import real
from gainproof.derive.printer.kernel import Input, Limit, closed
from gainproof.derive.stable_form import NoReading, StableForm, stable
from gainproof.derive.stable_form.function_atoms import RULES
from gainproof.verify.certificate import check

A, B, E, X, Z = map(real, "abexz")
Ends = tuple[Limit, Limit]


@dataclass(frozen=True)
class Problem:
    """An expression over closed domains; `most`: epsilons of the bound that has to be proved."""

    expression: sp.Expr
    ends: dict[str, Ends]
    most: float

    @property
    def inputs(self) -> tuple[Input, ...]:
        return tuple(closed(name, "a number", *ends) for name, ends in self.ends.items())


WIDE: dict[str, Ends] = {"x": ("1e-8", "1e8")}
SMALL: dict[str, Ends] = {"x": ("1e-8", "3")}
PROBLEMS = {
    "2sqrt": Problem(sp.sqrt(X + 1) - sp.sqrt(X), WIDE, 2),
    "2isqrt": Problem(1 / sp.sqrt(X) - 1 / sp.sqrt(X + 1), WIDE, 4.5),
    "2frac": Problem(1 / (X + 1) - 1 / X, WIDE, 2),
    "3frac": Problem(1 / (X + 1) - 2 / X + 1 / (X - 1), {"x": ("2", "1e8")}, 3),
    "quadp": Problem(
        (sp.sqrt(B**2 + 4 * A * Z) - B) / (2 * A), dict.fromkeys("abz", WIDE["x"]), 2.5
    ),
    "hypotenuse": Problem(sp.sqrt(X**2 + 1) - 1, WIDE, 2.5),
    "expm1": Problem(sp.exp(X) - 1, {"x": ("1e-30", "100")}, 4.1),
    "decay": Problem(1 - sp.exp(-X), {"x": ("1e-30", "100")}, 4.1),
    "exp2": Problem(sp.exp(X) - 2 + sp.exp(-X), {"x": ("1e-9", "100")}, 10),
    "expq2": Problem(sp.exp(X) / (sp.exp(X) - 1), {"x": ("1e-9", "100")}, 5.1),
    "expq3": Problem(
        E * (sp.exp((A + B) * E) - 1) / ((sp.exp(A * E) - 1) * (sp.exp(B * E) - 1)),
        {"a": ("1e-3", "10"), "b": ("1e-3", "10"), "e": ("1e-9", "1")},
        50,
    ),
    "sqrtexp": Problem(sp.sqrt((sp.exp(2 * X) - 1) / (sp.exp(X) - 1)), {"x": ("1e-9", "100")}, 3),
    "tanh": Problem(sp.tanh(X), {"x": ("1e-8", "100")}, 11),
    "2log": Problem(sp.log(X + 1) - sp.log(X), WIDE, 5),
    "qlog": Problem(sp.log(1 - X) / sp.log(1 + X), {"x": ("1e-9", "1/2")}, 10),
    "asinh": Problem(sp.log(X + sp.sqrt(X**2 + 1)), WIDE, 8.5),
    "acosh": Problem(sp.log(X + sp.sqrt(X**2 - 1)), {"x": ("3/2", "1e8")}, 7),
    "acoth": Problem(sp.log((X + 1) / (X - 1)) / 2, {"x": ("2", "1e8")}, 5.5),
    "2atan": Problem(sp.atan(X + 1) - sp.atan(X), WIDE, 6),
    "tanhf": Problem((1 - sp.cos(X)) / sp.sin(X), SMALL, 9),
    "cos2": Problem((1 - sp.cos(X)) / X**2, SMALL, 10),
}


def found(name: str) -> StableForm:
    problem = PROBLEMS[name]
    return stable({"y": problem.expression}, problem.inputs)


@pytest.mark.alike
@pytest.mark.parametrize("name", PROBLEMS)
def test_the_form_is_bounded_proved_and_the_same_number(name: str) -> None:
    problem, form = PROBLEMS[name], found(name)
    bound = form.bounds["y"]
    assert not form.cancellations
    assert bound is not None, form.refusals
    assert bound.bound <= problem.most
    report = check(form.certificate, claims=form.claims)
    assert report.accepted, report.reason
    generator = np.random.default_rng(5)
    for _ in range(5):
        point = {
            given.name: float(np.exp(generator.uniform(np.log(low), np.log(high))))
            for given, (low, high) in zip(problem.inputs, bound.domain, strict=True)
        }
        value = with_terms(form.graph, point)["y"][0]
        with mp.workdps(100):
            exact = sp.lambdify(list(point), problem.expression, "mpmath")(
                *(mp.mpf(x) for x in point.values())
            )
            text = value.str(70, radius=False)
            assert abs(mp.mpf(text) / exact - 1) < mp.mpf(10) ** -50, point


@pytest.mark.parametrize(
    "expression",
    [
        sp.log(X),
        sp.cos(4 * X) - 1,
        (X + 1) * sp.log(X + 1) - X * sp.log(X) - 1,
        sp.Function("f")(X),
    ],
)
def test_what_no_rule_replaces_is_refused(expression: sp.Expr) -> None:
    """A sign that changes, an angle above pi, factors that differ."""
    with pytest.raises(NoReading):
        stable({"y": expression}, (closed("x", "a number", "1/8", "2"),))


@pytest.mark.parametrize(
    "expression",
    [
        sp.log(X - 2) + sp.log(X - 3) - sp.log(6),
        2 * sp.log(X - 2),
        sp.log(X - 2) - sp.log(X - 3),
        sp.sqrt(sp.cosh(X) + sp.sinh(X) - 3) * sp.sqrt(sp.exp(X) - 3),
        sp.exp(sp.sqrt(X - 2) * sp.sqrt(X - 3)),
        sp.tan(2 * X) * sp.cos(2 * X) + sp.exp(X),
        sp.coth(X - sp.Rational(3, 4)) * sp.sinh(X - sp.Rational(3, 4)) + sp.exp(X),
    ],
)
def test_what_is_no_real_number_everywhere_is_refused(expression: sp.Expr) -> None:
    """Also where it is one again after logarithms are joined, or after roots or poles cancel."""
    with pytest.raises(NoReading):
        stable({"y": expression}, (closed("x", "a number", "1/2", "1"),))


def test_what_a_rule_rests_on_is_a_statement_of_its_own() -> None:
    form = stable(
        {"y": sp.log(X - 2) + sp.log(X - 3), "z": sp.atan(X + 1) - sp.atan(X) + sp.cos(X / 4)},
        (closed("x", "a number", "5", "10"),),
    )
    assert check(form.certificate, claims=form.claims).accepted
    given = {name: form.certificate["programs"][f"given_{name}"]["graph"] for name in form.positive}
    found = {float(with_terms(graph, {"x": 8.0})[name][0]) for name, graph in given.items()}
    assert found >= {8 - 2, 8 - 3, 1 + 8 * 9, 3 - 2}
    for name in form.positive:
        less = dict(deepcopy(form.certificate))
        kept = [each for each in less["statements"] if each["id"] != f"positive_{name}"]
        less["statements"] = kept
        assert not check(less, claims=form.claims).accepted
        # its negative in its place
        spoilt = deepcopy(form.certificate)
        value = spoilt["towers"][name]["elements"]["value"]
        value["num"] = [[str(-Fraction(term[0])), *term[1:]] for term in value["num"]]
        assert not check(spoilt, claims=form.claims).accepted


def test_rules_hold_as_they_are_stated() -> None:
    """At 60 digits: exp, cos and sin, log on both sides of 1, arctan."""
    assert set(RULES) == {"decay", "growth", "half_angle", "logarithm", "arctangent"}
    with flint.ctx.workprec(240):
        for u, y in ((flint.arb("0.3"), flint.arb("0.1")), (flint.arb(2.5), flint.arb("0.7"))):
            half = (u / 2).sin() ** 2
            for left, right in (
                (u.exp(), 1 / (1 + (-u).expm1())),
                (u.exp(), 1 + u.expm1()),
                (u.cos(), 1 - 2 * half),
                (u.sin(), 2 * (half * (1 - half)).sqrt()),
                ((1 + u).log(), u.log1p()),
                ((1 / (1 + u)).log(), -(u.log1p())),
                (u.atan() - y.atan(), ((u - y) / (1 + u * y)).atan() if u > y else None),
            ):
                assert right is None or abs(left - right) < flint.arb(10) ** -60
