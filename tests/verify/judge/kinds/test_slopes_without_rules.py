"""Derivatives at points where the rules of differentiation give no value.

Expected verdicts are by hand; those of drawn functions from difference quotients in mpmath, from
both sides, which know nothing of rules or expansions.
"""

from __future__ import annotations

import random

import mpmath
import pytest
from one_of_each import further
from samples import samples
from small_claims import check, judged

from gainproof.verify.judge.replay import replay_json

INSIDE, END = "-1 < y < 1", r"0 \leq y < 1"
TWO = f"{INSIDE}, -1 < x < 1"
SIZE, ROOT = r"\left|y\right|", r"\sqrt{y}"


def slope(of: str, by: str = "y") -> str:
    """The derivative in print."""
    return rf"\frac{{\partial}}{{\partial {by}}} ({of})"


def at(of: str, place: str) -> str:
    """The derivative at a place."""
    return rf"\left. {slope(of)} \right|_{{y={place}}}"


def at_zero(of: str) -> str:
    """The derivative at 0."""
    return at(of, "0")


CASES = [
    # there is a slope at 0
    (slope(r"\sqrt{y^4}") + "= 2 y", INSIDE, "identity", "proved"),
    (slope(r"y \sqrt[3]{y^2}") + r"= \frac{5}{3} \sqrt[3]{y^2}", INSIDE, "identity", "proved"),
    (slope(r"y \sqrt{y}") + r"= \frac{3}{2} \sqrt{y}", END, "identity", "proved"),
    (slope(r"(y^2)^{3/4}") + r"\leq 2", INSIDE, "inequality", "proved"),
    (slope(r"(y^2)^{3/4}") + r"< 3/2", INSIDE, "inequality", "proved"),
    (slope(r"(y^2)^{3/4} y") + r"= \frac{5}{2} (y^2)^{3/4}", INSIDE, "identity", "proved"),
    (r"\sqrt{1+y^2}" + slope(r"\sqrt{y^4+y^6}") + "= 2 y + 3 y^3", INSIDE, "identity", "proved"),
    (slope(r"\sqrt{y^3+y^4}") + r"\geq 0", END, "inequality", "proved"),
    (slope(rf"{SIZE} \sin y") + r"\leq 2", INSIDE, "inequality", "proved"),
    (at_zero(r"\sqrt{y^4}") + "= 0", INSIDE, "identity", "proved"),
    (at_zero(r"\sqrt{y^4+y^6} + 3 y") + "= 3", INSIDE, "identity", "proved"),
    (at_zero(r"x \sqrt{y^4+y^6} + x y") + "= x", INSIDE, "identity", "proved"),
    (slope(slope(r"\sqrt{y^4+y^6}")) + r"\leq 30", INSIDE, "inequality", "proved"),
    further(
        slope(r"\sqrt{(y^2-2)^4 + (y^2-2)^6}") + r"\leq 100", "1 < y < 2", "inequality", "proved"
    ),
    (slope(rf"{SIZE} - {SIZE}") + "= 0", INSIDE, "identity", "proved"),
    # what is asked for at a point has to have a value there, and not all over the domain
    (at(ROOT, "1/4") + "= 1", INSIDE, "identity", "proved"),
    (at(ROOT, "1/4") + "= 2", INSIDE, "identity", "refuted"),
    (at(ROOT, "-1/4") + "= 1", INSIDE, "identity", "refuted"),
    (r"\left. \sum_{j=0}^{\infty} y^j \right|_{y=1/2} = 2", "0 < y < 3", "identity", "proved"),
    (r"\left. \sum_{j=0}^{\infty} y^j \right|_{y=2} = -1", "0 < y < 3", "identity", "undecided"),
    # in several symbols: on a line, at a point, on two lines
    (
        r"\sqrt{x^2+y^2}" + slope(r"\sqrt{x^2 y^4+y^6}") + "= 2 x^2 y + 3 y^3",
        TWO,
        "identity",
        "proved",
    ),
    (slope("(x^2+y^2)^{3/4}") + r"\leq 3", TWO, "inequality", "proved"),
    (slope(r"\sqrt{x^4 y^4+x^6 y^6}") + r"\leq 300", TWO, "inequality", "proved"),
    (
        r"\begin{pmatrix} "
        + slope("x (y^2)^{3/4}", "x")
        + "&"
        + slope("x (y^2)^{3/4}")
        + r"\end{pmatrix} = \begin{pmatrix} (y^2)^{3/4} & \frac{3}{2} x \sqrt[3]{y \sqrt{"
        + SIZE
        + r"}} \end{pmatrix}",
        INSIDE,
        "identity",
        "proved",
    ),
    # a slope there, and the claim is false or lacks a value for another reason
    (slope(r"(y^2)^{3/4}") + r"\neq 0", INSIDE, "inequality", "conditional"),
    (slope(r"(y^2)^{3/4}") + r"\neq 0", "", "inequality", "conditional"),
    (slope(r"(y^2)^{3/4}") + r"= \frac{3 y}{2 (y^2)^{1/4}}", INSIDE, "identity", "conditional"),
    (at_zero(r"\sqrt{y^4+y^6} + 3 y") + "= 2", INSIDE, "identity", "refuted"),
    (slope(r"\sqrt{y^4+y^6}") + "= 2 y", INSIDE, "identity", "refuted"),
    # no slope
    (slope(SIZE) + rf"= \frac{{y}}{{{SIZE}}}", INSIDE, "identity", "conditional"),
    (slope(SIZE) + r"\leq 1", INSIDE, "inequality", "conditional"),
    (slope(SIZE) + "= 1", END, "identity", "conditional"),
    (at_zero(SIZE) + "= 1", INSIDE, "identity", "refuted"),
    (slope(r"\sqrt{y}") + r"= \frac{1}{2 \sqrt{y}}", END, "identity", "conditional"),
    (slope(r"\sqrt{y}") + r"\geq 0", END, "inequality", "conditional"),
    (slope(r"\sqrt[3]{y}") + r"\geq 0", INSIDE, "inequality", "conditional"),
    (slope(r"\left|\sin y\right|") + r"\leq 1", INSIDE, "inequality", "conditional"),
    (slope(r"\sqrt{(y^2-2)^2}") + r"\leq 100", "1 < y < 2", "inequality", "conditional"),
    (slope(slope(rf"y {SIZE}")) + r"\leq 2", INSIDE, "inequality", "conditional"),
    (slope(slope(r"\sqrt{y^2+y^4}")) + r"\leq 100", INSIDE, "inequality", "conditional"),
    (slope(r"\left|x y\right|") + r"\leq 300", TWO, "inequality", "conditional"),
    (slope(r"\sqrt{x^2+y^2}") + r"\leq 1", TWO, "inequality", "conditional"),
    further(slope(r"\sqrt{x^4 y^2 + y^6}") + r"\leq 9", TWO, "inequality", "conditional"),
    # the function itself has no value at 0, or none about 0
    (slope(rf"\frac{{y^3}}{{{SIZE}}}") + r"\leq 3", INSIDE, "inequality", "conditional"),
    (at_zero(rf"\frac{{y^3}}{{{SIZE}}}") + "= 0", INSIDE, "identity", "refuted"),
    (slope(r"\sqrt{y-1} \sqrt{1-y}") + "= 0", r"0 \leq y < 2", "identity", "refuted"),
    (at_zero(rf"\frac{{y^3}}{{{SIZE}}}") + "= 0.0", "", "value", "refuted"),
    (at_zero(r"\sqrt{y^4+y^6}") + "= 0.0", "", "value", "proved"),
    (at_zero(SIZE) + "= 0.0", "", "value", "refuted"),
    # slopes on both sides of an arrow
    (slope("(y^2)^{3/4}") + r"\geq 0 \iff y \geq 0", INSIDE, "equivalence", "proved"),
    (slope("(y^2)^{3/4}") + r"> 0 \iff y > 0", INSIDE, "equivalence", "proved"),
    (slope("(y^2)^{3/4}") + r"> 0 \iff y \geq 0", INSIDE, "equivalence", "conditional"),
    (slope("(y^2)^{3/4}") + r"\geq 0 \implies y \geq 0", INSIDE, "implication", "proved"),
    (slope("(y^2)^{3/4}") + r"\geq 0 \implies y > 0", INSIDE, "implication", "conditional"),
    # at 0 there is no slope that could be supposed
    (slope(SIZE) + r"\geq 0 \implies y > 0", INSIDE, "implication", "conditional"),
]


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "domain", "kind", "wanted"), CASES)
def test_verdicts(latex: str, domain: str, kind: str, wanted: str) -> None:
    fields = f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")
    check(judged(kind, fields), wanted)


def test_what_is_not_shown_is_undecided() -> None:
    """A point of values that the function does not go through has no slope, and no other either."""
    found = judged("identity", f"latex = '{at_zero('(-y^2)^{3/2}')} = 0'")
    check(found, "undecided")


def test_a_witness_says_what_is_missing() -> None:
    found = judged("inequality", f"latex = '{slope(SIZE)} \\leq 1'\ndomain = '{INSIDE}'")
    assert found.witness is not None
    assert found.witness["point"] == {"y": "0"}
    assert found.witness["left"] == {"undefined": "there is no derivative"}


PIECES = (
    ("y", lambda y: y),
    ("y^2", lambda y: y**2),
    ("y^3", lambda y: y**3),
    (SIZE, abs),
    (r"\sqrt{y^2}", abs),
    (r"\sqrt[3]{y}", lambda y: mpmath.sign(y) * mpmath.cbrt(abs(y))),
    (r"\sqrt{y^4+y^6}", lambda y: mpmath.sqrt(y**4 + y**6)),
    ("(y^2)^{3/4}", lambda y: abs(y) ** 1.5),
    (r"\sqrt{y^2+y^4}", lambda y: mpmath.sqrt(y**2 + y**4)),
    (r"\sqrt{1+y}", lambda y: mpmath.sqrt(1 + y)),
    ("(1+y^2)^{1/3}", lambda y: mpmath.cbrt(1 + y**2)),
    (r"\frac{1}{2+y}", lambda y: 1 / (2 + y)),
    ("2", lambda _: mpmath.mpf(2)),
)
STEP = mpmath.mpf(10) ** -30


def _drawn(chance: random.Random) -> tuple[str, float | None]:
    """A sum of products, and its slope at 0; None if it has none there."""
    with mpmath.workdps(120):
        terms = []
        for _ in range(chance.choice((1, 1, 2, 3))):
            factors = [chance.choice(PIECES) for _ in range(chance.choice((1, 2, 2)))]
            terms.append((chance.choice((1, -1, 1)), factors))

        def value(y: mpmath.mpf) -> mpmath.mpf:
            return sum(sign * mpmath.fprod(f(y) for _, f in fs) for sign, fs in terms)

        start = value(mpmath.mpf(0))
        right, left = ((value(h) - start) / h for h in (STEP, -STEP))
        # next to 0 the quotient goes with h^0, h^(1/6) or more, or with h^(-1/3) or less
        exists = abs(right - left) < mpmath.mpf(10) ** -4 and abs(right) < 1000
        text = " ".join(
            ("+" if sign > 0 else "-") + r" \cdot ".join(name for name, _ in fs)
            for sign, fs in terms
        )
        return text.removeprefix("+"), float(right) if exists else None


@pytest.mark.sampled
def test_drawn_functions_against_difference_quotients() -> None:
    chance = random.Random(37)
    tally: dict[str, int] = {}
    for _ in range(samples(16)):
        function, found = _drawn(chance)
        right = 0 if found is None else round(found * 4) / 4
        is_true = found is not None and abs(found - right) < 1e-3
        said = judged("identity", f"latex = '{at_zero(function)} = {right}'\ndomain = '{INSIDE}'")
        wide = judged(
            "inequality", f"latex = '{slope(function)} \\leq 50'\ndomain = '-1/2 < y < 1/2'"
        )
        if is_true:
            assert said.verdict not in ("refuted", "conditional"), (function, said.reason)
        else:
            assert said.verdict != "proved", (function, right)
        if found is None:
            assert wide.verdict != "proved", function
        else:
            assert wide.verdict not in ("refuted", "conditional"), (function, wide.reason)
        for each in (said, wide):
            tally[each.verdict] = tally.get(each.verdict, 0) + 1
    assert tally["proved"] > sum(tally.values()) / 4, tally
    assert tally.get("undecided", 0) < sum(tally.values()) / 4, tally


@pytest.mark.parametrize(
    ("formula", "kind", "names"),
    [
        (r"SLOPE \leq \frac{9}{BELOW}", "inequality", "xy"),
        further(r"SLOPE \leq \frac{9}{BELOW}", "inequality", "xyz"),
        (r"SLOPE = \frac{2 x^3 BELOW}{ROOT BELOW}", "identity", "xy"),
        further(r"SLOPE = \frac{2 x^3 BELOW}{ROOT BELOW}", "identity", "xyz"),
        (r"x < 1 \implies SLOPE \leq \frac{9}{BELOW}", "implication", "xy"),
        further(r"x < 1 \implies SLOPE \leq \frac{9}{BELOW}", "implication", "xyz"),
    ],
)
def test_a_place_where_something_else_has_no_value_is_left_out(
    formula: str, kind: str, names: str
) -> None:
    """At the origin the slope is 0, but the right side has no value."""
    root = rf"\sqrt{{{' + '.join(f'{name}^4' for name in names)}}}"
    below = " + ".join(f"{name}^2" for name in names)
    latex = formula.replace("SLOPE", rf"\frac{{\partial {root}}}{{\partial x}}")
    latex = latex.replace("ROOT", root).replace("BELOW", f"({below})")
    symbols = {n: f"{{ unit = '1', domain = '-1 < {n} < 1', meaning = 'a number' }}" for n in names}
    found = judged(kind, latex, symbols)
    assert found.verdict in ("conditional", "refuted", "undecided")
    if found.verdict == "conditional":
        assert "!= 0" in (found.domain or "") or "except where" in (found.domain or "")
    assert replay_json(found.to_json()) is None


OPEN_UNIT = "{ unit = '1', domain = '-1 < %s < 1', meaning = 'a number' }"


@pytest.mark.parametrize(
    ("latex", "but"),
    [
        # at z = 0 both sides are 2 y^3/y^2 = 2 y, but for y = 0; elsewhere there are no divisors 0
        (r"\sqrt{y^4 + z^4}}{\partial y} = \frac{2 y^3}{\sqrt{y^4 + z^4}}",
         "except where z = 0 and y = 0"),
        (r"(y^2 \sqrt{y^2 + z^2})}{\partial y} = \frac{3 y^3 + 2 y z^2}{\sqrt{y^2 + z^2}}",
         "except where z = 0 and y = 0"),
        # at z = 0 the slope is 0 for every y, and 0/y is 0 for y != 0: no other point is left out
        (r"(\lvert y \rvert z)}{\partial y} = \frac{\lvert y \rvert z}{y}", "y != 0"),
        # the right side is 0/0 on both axes
        (r"\sqrt{y^2 z^2}}{\partial y} = \frac{y z^2}{\sqrt{y^2 z^2}}", "y != 0, z != 0"),
    ],
)  # fmt: skip
def test_no_more_is_left_out_than_has_no_value(latex: str, but: str) -> None:
    symbols = {name: OPEN_UNIT % name for name in ("y", "z")}
    found = judged("identity", rf"\frac{{\partial {latex}", symbols)
    check(found, "conditional")
    assert found.domain == f"for -1 < y < 1, -1 < z < 1, {but}"
    assert found.reason.endswith(f" {found.domain}"), found.reason
