"""Functions that jump: angles of points, whole parts, remainders, signs and cases."""

from __future__ import annotations

import pytest
from jump_claims import claims
from small_claims import SmallClaim, check, judged

from gainproof.verify.judge.exact.expression import number, symbol
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.transcendental.domain_parts import ABOVE, WHOLE, plain

WRAPPED = "x - 2 pi floor((x + pi)/(2 pi))"
TURNED = "atan2(sin(x), cos(x))"
REMAINDER = "mod(x + pi, 2 pi) - pi"
LETTER = "{ unit = '1', meaning = 'a coordinate' }"
TWO_PI = "mod(x, 2 pi) - 2 pi"


def _plain(formula: str, domain: str = "", kind: str = "") -> SmallClaim:
    usual = "identity" if " = " in formula else "inequality"
    fields = f"plain = '{formula}'" + (f"\ndomain = '{domain}'" if domain else "")
    return SmallClaim(kind or usual, fields)


TRUE = [
    # angles of points
    _plain("atan2(y, x) = 2 atan(y/(sqrt(x^2 + y^2) + x))"),
    _plain("atan2(c y, c x) = atan2(y, x)", "c > 0"),
    _plain("sin(atan2(y, x)) = y/sqrt(x^2 + y^2)"),
    _plain("cos(2 atan2(y, x)) = (x^2 - y^2)/(x^2 + y^2)"),
    _plain("a sin(t) + b cos(t) = sqrt(a^2 + b^2) sin(t + atan2(b, a))"),
    _plain("atan2(y, x) = atan(y/x)", "x > 0"),
    _plain("atan2(-y, x) = -atan2(y, x)", "y > 0"),
    _plain("atan2(y, x) + atan2(x, y) = pi/2", "x > 0"),
    _plain("-pi < atan2(y, x) <= pi"),
    _plain("atan2(0, -1) = pi"),
    # wrapped angles
    _plain(f"{REMAINDER} = {WRAPPED}"),
    _plain(f"-pi <= {REMAINDER} < pi"),
    _plain(f"pi - mod(pi - x, 2 pi) = {TURNED}"),
    _plain(f"x + 2 pi floor((pi - x)/(2 pi)) = {TURNED}"),
    _plain(f"cases(mod(x, 2 pi), mod(x, 2 pi) <= pi; {TWO_PI}) = {TURNED}"),
    _plain(f"cos({WRAPPED}) = cos(x)"),
    _plain(f"{TURNED} = x", r"-\pi < x \leq \pi"),
    _plain(f"cases(x - 2 pi, x > pi; x) = {TURNED}", r"-\pi < x \leq 3 \pi"),
    _plain("mod(a - mod(b, 2 pi), 2 pi) = mod(a - b, 2 pi)"),
    _plain("sin(w) = sin(x) if w = mod(x + pi, 2 pi) - pi"),
    # whole parts and remainders
    _plain("floor(x) + floor(x + 1/2) = floor(2 x)"),
    _plain("ceil(x) = -floor(-x)"),
    _plain("0 <= mod(x, m) < m", "m > 0"),
    _plain("m < mod(x, m) <= 0", "m < 0"),
    _plain("mod(x + k m, m) = mod(x, m)", "m > 0"),
    _plain("floor(x + k) = floor(x) + k"),
    _plain("floor(x) = 2 <=> 2 <= x < 3", kind="equivalence"),
    _plain("floor(x) >= 0", "x >= 0"),
    _plain("ceil(x) > 0", "x > 0"),
    _plain("floor(x) = 0", "0 <= x < 1"),
    # signs, greater and smaller numbers, cases
    _plain("sign(x) abs(x) = x"),
    _plain("max(a, b) = (a + b + abs(a - b))/2"),
    _plain("min(max(x, -1), 1) = cases(-1, x < -1; 1, x > 1; x)"),
    _plain("cases(1/x, x != 0; 0) x = sign(x)^2"),
    # of cases that do not apply no value is asked
    _plain("cases(floor(1/x), x != 0; 0) = cases(floor(1/x), x != 0; 0)", "-1 < x < 1"),
    _plain("cases(0, x = 0; 1, 1/x > 0; 2) = cases(0, x = 0; 1, x > 0; 2)", "-1 < x < 1"),
    _plain("max(a, b) = cases(a, a > b; b)"),
]
FALSE = [
    ("conditional", _plain("atan2(-y, x) = -atan2(y, x)")),  # pi at y = 0, x < 0
    ("conditional", _plain("atan2(y, x) = atan(y/x)")),
    ("conditional", _plain("atan2(y, x) + atan2(x, y) = pi/2")),
    ("conditional", _plain("atan2(c y, c x) = atan2(y, x)")),
    ("conditional", _plain("-pi < atan2(y, x) < pi")),
    ("refuted", _plain("sin(atan2(y, x)) = x/sqrt(x^2 + y^2)")),
    ("conditional", _plain("atan2(y, x) = 0 <=> y = 0", kind="equivalence")),
    ("conditional", _plain(f"{REMAINDER} = {TURNED}")),  # -pi and pi at x = pi
    ("conditional", _plain(f"-pi < {REMAINDER} <= pi")),
    ("conditional", _plain(f"{TURNED} = x", r"-\pi \leq x \leq \pi")),
    ("conditional", _plain(f"{TURNED} = x")),
    ("conditional", _plain(f"cases(mod(x, 2 pi), mod(x, 2 pi) < pi; {TWO_PI}) = {TURNED}")),
    ("refuted", _plain(f"sin({WRAPPED}) = -sin(x)")),
    ("conditional", _plain("mod(-x, m) = m - mod(x, m)", "m > 0")),  # 0 and m where m divides x
    ("conditional", _plain("0 <= mod(x, m) < m")),
    ("conditional", _plain("floor(x) < x")),
    ("conditional", _plain("floor(x/2) < x/2", "x >= 0")),
    ("conditional", _plain("floor(x) > 0", "x > 0")),
    ("conditional", _plain("floor(x) = 0", "0 <= x <= 1")),
    ("conditional", _plain("ceil(x) = floor(x) + 1")),
    ("conditional", _plain("sign(x) = x/abs(x)", "-1 < x < 1")),  # no value at 0
    ("conditional", _plain("cases(1/x, x != 0; 0) x = 1", "-1 < x < 1")),
    ("conditional", _plain("min(max(x, -1), 1) = cases(-1, x < -1; x)")),
    # a condition, an argument without value leaves the whole without one
    ("conditional", _plain("cases(1, 1/x > 0; 0) = cases(1, x > 0; 0)", "-1 < x < 1")),
    ("conditional", _plain("floor(1/x) = floor(1/x)", "-1 < x < 1")),
    ("conditional", _plain("atan2(1/x, y) = atan2(1/x, y)", "-1 < x < 1")),
    ("conditional", _plain("atan2(y, x) = atan2(2 y, 2 x)", "-1 < x < 1")),  # the origin
    # what is said of whole numbers may hold for no one of them, and yet for others
    ("refuted", _plain("floor(1/x) = ceil(1/x)")),  # 1 and 2 at x = 2/3
    ("refuted", _plain("floor(x/y) = ceil(x/y)")),
    ("refuted", _plain("floor(x y z) = ceil(x y z)")),
    ("refuted", _plain("mod(x, y) = mod(x, -y)")),  # 1 and -1 at x = 1, y = 2
    ("refuted", _plain("mod(1/x, 1) + mod(-1/x, 1) = 0")),
    ("conditional", _plain("floor(x) > floor(y)", "x > y")),  # 0 and 0 at x = 1/2, y = 1/3
    ("conditional", _plain("floor(x/2) > floor(y/2)", "x > y")),
    ("conditional", _plain("floor(x) > floor(y) if x > y")),
    ("conditional", _plain("x > y => floor(x) > floor(y)", kind="implication")),
]  # fmt: skip
SLOPES = [
    ("proved", "diff(atan2(y, x), x) = -y/(x^2 + y^2)", ""),
    ("proved", "diff(atan2(y, x), y) = x/(x^2 + y^2)", ""),
    ("refuted", "diff(atan2(y, x), y) = -x/(x^2 + y^2)", ""),
    ("proved", "diff(diff(atan2(y, x), x), y) = (y^2 - x^2)/(x^2 + y^2)^2", ""),
    ("proved", "diff(atan2(y, x), y) = x/(x^2 + y^2)", "x > 0 and -1 < y < 1"),
    # along y = 0 the angle stays pi; across, it jumps
    ("proved", "diff(atan2(y, x), x) = -y/(x^2 + y^2)", "x < 0 and -1 < y < 1"),
    ("conditional", "diff(atan2(y, x), y) = x/(x^2 + y^2)", "x < 0 and -1 < y < 1"),
    ("conditional", "diff(atan2(y, x), y) = x/(x^2 + y^2)", "-1 < x < 1 and -1 < y < 1"),
    # from -pi to pi where it passes y = 0 with the slope 0
    ("undecided", "at(diff(atan2(t^3, -1), t), t, 0) = 0", ""),
    ("held", "at(diff(atan2(a t^3, b), t), t, 0) = 0", ""),  # has a value where b > 0 alone
    ("proved", "at(diff(atan2(t^3, 1), t), t, 0) = 0", ""),
]
LACKING = [
    "diff(atan2(t^3, -1), t) = -3 t^2/(t^6 + 1)",
    "diff(atan2(t^5, x), t) = 5 x t^4/(x^2 + t^10)",
    "diff(abs(x), x) = cases(1, x >= 0; -1)",
    "diff(max(x, 0), x) = cases(1, x > 0; 0)",
    "diff(min(x, 2), x) = cases(1, x < 2; 0)",
    "diff(abs(x y), x) = cases(abs(y), x > 0; -abs(y))",
]
SMOOTH = [
    "diff(atan2(t^3, 1), t) = 3 t^2/(t^6 + 1)",
    "diff(x abs(x), x) = cases(2 x, x > 0; -2 x)",
    "diff(max(x, 0)^2, x) = cases(2 x, x > 0; 0)",
]
"""Functions with jumps whose derivatives have none."""
BEYOND = [
    _plain("diff(floor(x), x) = 0"),
    _plain("diff(cases(x, x > 0; -x), x) = sign(x)"),
    _plain("integral(floor(t), t, 0, 2) = 1"),
    _plain("sum(floor(k/2), k, 0, n) = n"),
    _plain("floor(x) -> 1 if x -> 1", kind="limit"),
    _plain("atan2(x, -1) -> pi if x -> 0", kind="limit"),
]


@pytest.mark.alike
@pytest.mark.parametrize("claim", TRUE, ids=lambda claim: claim.fields)
def test_true(claim: SmallClaim) -> None:
    check(claim.judged(), "proved")


@pytest.mark.alike
@pytest.mark.parametrize(("wanted", "claim"), FALSE, ids=str)
def test_false(wanted: str, claim: SmallClaim) -> None:
    check(claim.judged(), wanted)


@pytest.mark.alike
@pytest.mark.parametrize(("wanted", "formula", "domain"), SLOPES)
def test_slopes_of_an_angle(wanted: str, formula: str, domain: str) -> None:
    check(_plain(formula, domain).judged(), wanted)


@pytest.mark.parametrize(
    ("formula", "domain"),
    [*((f, "where every part has a value") for f in LACKING), *((f, "everywhere") for f in SMOOTH)],
)
def test_points_without_a_derivative_are_left_out_of_the_domain(formula: str, domain: str) -> None:
    found = _plain(formula).judged()
    check(found, "proved")
    assert found.domain == domain


@pytest.mark.parametrize("claim", BEYOND, ids=lambda claim: claim.fields)
def test_what_is_beyond_reach_has_its_reason(claim: SmallClaim) -> None:
    found = claim.judged()
    assert found.verdict == "undecided"
    assert found.reason


def test_an_angle_that_jumps_has_no_trend() -> None:
    """Left of x = 0 it falls with y, and rises by a whole turn where y passes through 0."""
    symbols = {"b": r"{ definition = '\operatorname{atan2}(y, x)', meaning = 'bearing' }"}
    fields = "text = 'it falls'\nabout = ['b', 'y']\ntrend = 'decreasing'\ndomain = 'x < 0'"
    found = judged("monotone", fields, {**symbols, "x": LETTER, "y": LETTER})
    assert found.verdict == "undecided"


@pytest.mark.parametrize(
    ("formula", "shown"),
    [
        (f"{REMAINDER} = {TURNED}", "x/pi = "),
        ("atan2(-y, x) = -atan2(y, x)", "y = 0"),
        ("ceil(x) = floor(x) + 1", "x = "),
    ],
)
def test_a_border_is_shown_as_the_point(formula: str, shown: str) -> None:
    """In the letters of the formula, without those that replace them."""
    found = _plain(formula).judged()
    assert found.witness is not None
    point = ", ".join(f"{name} = {value}" for name, value in found.witness["point"].items())
    assert shown in point
    assert "floor" not in point


@pytest.mark.alike
@pytest.mark.parametrize("seed", range(4))
def test_random_claims(seed: int) -> None:
    """None that is false somewhere is proved, none that is true is refuted."""
    for claim in claims(seed, 8):
        said = f" if {claim.domain}" if claim.domain else ""
        found = judged(claim.kind, f"plain = '{claim.text}{said}'")
        is_false = claim.false_at is not None or (bool(claim.domain) and claim.lacks)
        wrong = ("proved",) if is_false else ("refuted", "conditional")
        assert found.verdict not in wrong, f"{claim.text}{said}: {found.verdict}, {found.reason}"


@pytest.mark.parametrize("letters", [(WHOLE + "x", "x"), (ABOVE + "x", "x")])
def test_a_symbol_is_not_taken_for_what_is_above_its_own_whole_part(
    letters: tuple[str, str],
) -> None:
    first, second = map(symbol, letters)
    sides, _ = plain(Rel(">=", first + second, number(3)))
    assert sides in [(total, number(3)) for total in (first + second, second + first)]
