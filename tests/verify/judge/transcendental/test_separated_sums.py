"""Sums of terms in symbols of their own: least values by hand, and claims that rest on them."""

from __future__ import annotations

from fractions import Fraction

import pytest
from one_of_each import further
from small_claims import judged

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import add, mul, number, symbol
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.replay import replay
from gainproof.verify.judge.transcendental.separated_sums import by_sums

X, Y, Z, V = map(symbol, "xyzv")
ANY = Box()
TERMS = (
    (r"(e^{S} - 1)^2", r"-1 < S < 1", "0 < S < 1"),
    (r"2 (1 + \cos S)", r"0 < S \leq \pi", r"0 < S < \pi"),
    (r"(\ln S)^2", r"S \geq 1", "S > 1"),
    (r"3 (\arctan S)^2", r"S \leq 0", "S < 0"),
    (r"(S - 2)^2", r"S \geq 2", "S > 2"),
)
"""Each with a domain in which it is 0, and one in which it is not."""
NAMES = ("a", "p", "s", "x", "y")
SHAPES = (
    ("identity", r"latex = '\frac{v D}{D} = v'"),
    ("identity", r"latex = '\frac{1}{\frac{1}{D}} = D'"),
    ("inequality", r"latex = '\frac{v^2}{D} \geq 0'"),
    ("inequality", "latex = 'D > 0'"),
    ("identity", r"latex = '\frac{a D}{D} = a'"),
)


def verdict(kind: str, fields: str, count: int, away: int | None) -> tuple[str, str]:
    """Of a claim with a sum of so many terms, of which one is nowhere 0 if it is named."""
    terms = TERMS[:count]
    core = " + ".join(t.replace("S", n) for (t, _, _), n in zip(terms, NAMES, strict=False))
    symbols = {
        name: f"{{ unit = '1', domain = '{domains[k == away].replace('S', name)}', meaning = 'n' }}"
        for k, ((_, *domains), name) in enumerate(zip(terms, NAMES, strict=False))
    }
    symbols["v"] = "{ unit = '1', domain = '-2 < v < 2', meaning = 'n' }"
    found = judged(kind, fields.replace("D", f"({core})"), symbols)
    if found.certificate is not None:
        assert replay(found.certificate, found.verdict) is None
    return found.verdict, found.method or ""


@pytest.mark.alike
@pytest.mark.parametrize(("shape", "count"), list(zip(SHAPES, (5, 4, 3, 5, 4), strict=True)))
def test_zero_of_all_terms_together(shape: tuple[str, str], count: int) -> None:
    kind, fields = shape
    assert verdict(kind, fields, count, None)[0] in ("conditional", "refuted")
    found, method = verdict(kind, fields, count, count - 1)
    assert found == "proved"
    assert "symbols of their own" in method


def proved(rel: Rel, boxes: dict[str, Box], *given: Rel) -> bool | None:
    """None where sums do not tell; False where they show that it fails."""
    try:
        found = by_sums(Statement((rel,), given=given), boxes, None, {})
    except Undecided:
        return False
    return None if found is None else found.verdict == "proved"


def quotient(*terms: object) -> Rel:
    """v D / D = v."""
    total = add(*terms)  # type: ignore[arg-type]
    return Rel("=", mul(V, total) / total, V)


def test_least_values_by_hand() -> None:
    # x^2 - 2 x is least at 1, with -1; y^2 + y at -1/2, with -1/4; 1/(1 + z^2) nears 0
    terms = (X**2, mul(number(-2), X), Y**2, Y, 1 / (1 + Z**2))
    boxes = dict.fromkeys("xyzv", ANY)
    above = {
        extra: proved(Rel(">", add(*terms, number(extra)), number(0)), boxes) for extra in (1, 2)
    }
    assert above == {1: None, 2: True}
    assert proved(Rel(">", add(*terms, number(Fraction(5, 4))), number(0)), boxes) is True
    assert proved(quotient(*terms, number(Fraction(5, 4))), boxes) is True
    closed = {**boxes, "z": Box(Fraction(0), Fraction(1), lower_open=False, upper_open=False)}
    assert proved(quotient(*terms, number(Fraction(3, 4))), closed) is False
    half_open = {**closed, "z": Box(Fraction(0), Fraction(1), lower_open=False)}
    assert proved(quotient(*terms, number(Fraction(3, 4))), half_open) is True


def test_terms_with_a_symbol_in_common_are_one() -> None:
    # x^2 + (x - 1)^2 + y^2 is at least 1/2, though each square is 0 somewhere
    terms = (X**2, (X - 1) ** 2, Y**2)
    boxes = dict.fromkeys("xyzv", ANY)
    assert proved(quotient(*terms), boxes) is True
    assert proved(quotient(*terms, number(Fraction(-1, 2))), boxes) is False


def test_conditions_on_its_symbols_leave_a_zero_open() -> None:
    boxes = dict.fromkeys("xyzv", ANY)
    beside = Rel(">", X + Y, number(1))
    assert proved(quotient(X**2, Y**2), boxes, beside) is None
    assert proved(quotient(X**2, Y**2), boxes, Rel(">", Z, number(1))) is False


def test_terms_without_a_value_somewhere_are_left() -> None:
    # 1/x^2 + y^2 is positive, and has no value at x = 0
    boxes = dict.fromkeys("xyzv", ANY)
    assert proved(quotient(1 / X**2, Y**2), boxes) is None
    assert proved(quotient(0 * (1 / X), Y**2, Z**2, number(1)), boxes) is None
    unstated = dict.fromkeys("xyzv", Box(stated=False))
    assert proved(quotient(X**2, Y**2), unstated) is True
    assert proved(quotient(X**2, Y**2), {**unstated, "x": ANY}) is False
    assert proved(quotient(1 / X**2, Y**2), {**unstated, "y": ANY}) is None


@pytest.mark.parametrize(
    "term", [r"x^2", r"e^x", further(r"(\ln(1 + x^2))^2"), r"\frac{1}{1 + x^2}"]
)
@pytest.mark.parametrize("factor", [r"e^z", r"z", r"(1 + \cos z)"])
def test_terms_that_repeat_count_each_time(term: str, factor: str) -> None:
    # D + D + y^2 is D + y^2 only where D or the factor is 0
    twice = rf"{factor} ({term} + {term} + e^y)"
    assert judged("identity", rf"{twice} = {factor} ({term} + e^y)").verdict == "refuted"
    assert judged("identity", rf"{twice} = {factor} (2 {term} + e^y)").verdict == "proved"


@pytest.mark.parametrize(
    ("kind", "claim"),
    [
        ("identity", r"e^z (-x^2 - y^2) = -e^z (x^2 + y^2)"),
        ("identity", r"2 e^z (x^2 + y^2) = e^z (2 x^2 + 2 y^2)"),
        ("identity", r"e^z (x^2 + y^2) + e^z (x^2 - y^2) = 2 e^z x^2"),
        ("inequality", r"e^z (a^2 + b^2 + 1) (x^2 + y^2) < 8 e^z (a^2 + b^2 + 1)"),
    ],
)
def test_sums_in_common_symbols_are_not_free_of_each_other(kind: str, claim: str) -> None:
    # each is an identity of polynomials, or rests on x^2 + y^2 < 8: with u and v for the sums it
    # fails where u is least
    stated = {n: f"{{ unit = '1', domain = '-2 < {n} < 2', meaning = 'n' }}" for n in "abwxyz"}
    assert judged(kind, claim, stated).verdict == "proved"


def test_a_proof_names_its_sums_in_words() -> None:
    found = judged("inequality", r"e^z (x^2 + 2 \left|y\right| + w^2 + 1) > 0")
    assert found.verdict == "proved"
    assert found.certificate is not None
    assert "(x^2 + 2 sqrt(y^2) + w^2)" in found.certificate["statement"]["labels"].values()
    assert found.certificate["places"][0]["place"] == "(x^2 + 2 sqrt(y^2) + w^2) = 0"
