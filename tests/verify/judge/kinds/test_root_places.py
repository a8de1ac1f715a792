"""Places of roots: stability by Hurwitz, reality by discriminants, lists of roots."""

from __future__ import annotations

import numpy as np
import pytest
from small_claims import check, judged

from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.kinds.location import located

GAINS = "z^2 - (2 - a - b) z + 1 - a"
CIRCLE, LEFT = "inside the unit circle", "left half plane"


@pytest.mark.parametrize(
    ("polynomial", "where", "domain", "wanted"),
    [
        ("z - a", CIRCLE, "-1 < a < 1", "proved"),
        ("z - a", CIRCLE, "-1 < a < 2", "conditional"),
        (GAINS, CIRCLE, "a > 0, b > 0, b < 4 - 2a", "proved"),
        (GAINS, CIRCLE, "a > 0, b > 0, b < 4 - a", "conditional"),
        ("z^3 - a", CIRCLE, "0 < a < 1", "proved"),
        ("z^3 - a", CIRCLE, "0 < a < 3", "conditional"),
        # a root on the circle itself is not inside
        ("z^3 - a", CIRCLE, r"0 < a \leq 1", "conditional"),
        ("z^4 - a", CIRCLE, "0 < a < 1", "proved"),
        ("-2 z^2 + a", CIRCLE, "0 < a < 2", "proved"),
        ("z^2 + a z + 1", "real", "a > 2", "proved"),
        ("z^2 + a z + 1", "complex", "0 < a < 2", "proved"),
        ("z^2 + a z + 1", "complex", "0 < a < 3", "conditional"),
        ("z^2 - 2 a z + a^2", "equal", "", "proved"),
        ("z^2 - 2 a z + b^2", "equal", "", "refuted"),
        ("(z - a)^3", "equal", "", "proved"),
        ("2 (z + a)^4", "equal", "", "proved"),
        ("(z - a)^2 (z - b)", "equal", "", "refuted"),
        ("z^2 + a z + b", LEFT, "a > 0, b > 0", "proved"),
        ("z^3 + a z^2 + b z + c", LEFT, "a > 0, b > 0, c > 0", "conditional"),
        ("z^6 + a", LEFT, "a > 0", "undecided"),
    ],
)
def test_place(polynomial: str, where: str, domain: str, wanted: str) -> None:
    fields = f"polynomial = '{polynomial}'\nvariable = 'z'\nwhere = '{where}'\ntext = 'in words'"
    check(judged("location", fields + (f"\ndomain = '{domain}'" if domain else "")), wanted)


@pytest.mark.parametrize(
    ("roots", "sign", "wanted"),
    [("u = a + b, w = a - b", "-", "proved"), ("u = a + b, w = a - b", "+", "refuted")],
)
def test_listed_roots_are_all_of_them(roots: str, sign: str, wanted: str) -> None:
    polynomial = f"z^2 - 2 a z + a^2 {sign} b^2"
    check(
        judged("location", f"latex = '{roots}'\npolynomial = '{polynomial}'\nvariable = 'z'"),
        wanted,
    )


def test_a_parameter_is_no_name_of_a_root() -> None:
    fields = "latex = 'a = 0'\npolynomial = 'z - a'\nvariable = 'z'"
    check(judged("location", fields), "refuted")


@pytest.mark.parametrize("where", [CIRCLE, LEFT])
def test_conditions_agree_with_numerical_roots(where: str) -> None:
    """NumPy's roots share nothing with the determinants; roots close to the border are left out."""
    source = np.random.default_rng(5)
    seen = {True: 0, False: 0}
    for _ in range(300):
        degree = int(source.integers(1, 6))
        spread = 4 if where == LEFT else 2
        coefficients = [int(c) for c in source.integers(-spread, 9, degree + 1)]
        if where == CIRCLE:
            coefficients[-1] *= 6
        if coefficients[-1] == 0:
            continue
        roots = np.roots(coefficients[::-1])
        distance = 1 - np.abs(roots) if where == CIRCLE else -roots.real
        if np.any(np.abs(distance) < 1e-6):
            continue
        relations = located([number(c) for c in coefficients], where)
        values = [constant_value(r.left) for r in relations]
        found = all(v is not None and v > 0 for v in values)
        assert found == bool(np.all(distance > 0)), coefficients
        seen[found] += 1
    assert min(seen.values()) > 20
