"""Least-squares gains: symbolic forms against exact fits computed sample by sample."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp

from gainproof.derive.derivation import PageError
from gainproof.derive.families.least_squares import PAGE, build
from gainproof.derive.growing_memory.fit import K, fit
from gainproof.derive.pages.derivation import FOLDER
from gainproof.verify.certificate import check_statement


def _fitted(degree: int, samples: list[Fraction]) -> list[Fraction]:
    """Value and derivatives at the newest sample of the least-squares polynomial, exactly."""
    newest = len(samples) - 1
    rows = [
        [Fraction(i - newest) ** m / math.factorial(m) for m in range(degree + 1)]
        for i in range(newest + 1)
    ]
    normal = sp.Matrix(degree + 1, degree + 1, lambda a, b: sum(r[a] * r[b] for r in rows))
    right = sp.Matrix(
        degree + 1, 1, lambda a, _: sum(r[a] * y for r, y in zip(rows, samples, strict=True))
    )
    return [Fraction(int(v.p), int(v.q)) for v in normal.LUsolve(right)]


@pytest.mark.parametrize("degree", [0, 1, 2])
def test_gain_is_the_weight_of_the_newest_sample(degree: int) -> None:
    gain = fit(degree).gain
    for number in range(degree, degree + 6):
        impulse = [Fraction(0)] * number + [Fraction(1)]
        exact = _fitted(degree, impulse)
        assert [Fraction(str(value.subs(K, number))) for value in gain] == exact


WRONG = [
    (1, "power-sum-2", "s2 = k (k + 1) (2 k + 1)/6", "s2 = k (k + 1) (2 k - 1)/6"),
    (2, "power-sum-4", "3 k^2 + 3 k - 1", "3 k^2 + 3 k + 1"),
    (0, "information-recursion", "back + seen", "back - seen"),
    (1, "kalman-gain", "gained = K (M11 + 1)", "gained = K (M11 - 1)"),
    (2, "kalman-update", "updated = M - K {M_row}", "updated = M + K {M_row}"),
    (2, "start", "A({first}) d = ", "A(1) d = "),
]


@pytest.mark.parametrize(("degree", "step", "right", "wrong"), WRONG)
def test_a_formula_of_the_page_that_is_not_true_is_rejected(
    tmp_path: Path, degree: int, step: str, right: str, wrong: str
) -> None:
    text = (FOLDER / f"{PAGE}.md").read_text(encoding="utf-8")
    assert text.count(right) == 1
    (tmp_path / f"{PAGE}.md").write_text(text.replace(right, wrong), encoding="utf-8")
    certificate = json.loads(json.dumps(build(degree, tmp_path).certificate()))
    assert check_statement(certificate, step).status == "rejected"
    (tmp_path / f"{PAGE}.md").write_text(text.replace("for any {d_names}", "for any d4"))
    with pytest.raises(PageError, match="'d4' is no quantity"):
        build(degree, tmp_path)
