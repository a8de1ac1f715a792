"""Statements on filters with matrix gains, held against matrices that fulfil their hypotheses.

That shows no statement for every size: the checker does. It shows that what is claimed is what is
meant, and that no statement has hypotheses that nothing fulfils.
"""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from interacting_values import KINDS, matrices, row_matrices, update_matrices
from word_values import completed, holds, true

import gainproof.generated
from gainproof.verify.certificate import check
from gainproof.verify.certificate.document import read_document, read_statement
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import Meter, RejectedError

MATRIX = ("matrix_equal", "matrix_order", "matrix_invertible", "matrix_trace")
SIZES = (1, 2, 3)


@cache
def certificate() -> Mapping[str, Any]:
    """As shipped; `gainproof run` and the tests of drift hold it against the derivation."""
    path = Path(gainproof.generated.__file__).with_name("interacting_gains.json")
    found: Mapping[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


@cache
def instances(tower: str) -> tuple[Mapping[str, Any], ...]:
    """Sets of matrices for one setting."""
    setting = certificate()["towers"][tower]
    if tower == "update":
        drawn = [update_matrices(seed, best) for seed in range(2) for best in (False, True)]
    elif tower == "rows":
        drawn = [row_matrices(seed, chained) for seed in range(2) for chained in (False, True)]
    else:
        drawn = [matrices(kind, 0, size) for kind in KINDS for size in SIZES]
    return tuple(completed(setting, values) for values in drawn)


def statements() -> Iterator[Mapping[str, Any]]:
    """Those on matrices of every size."""
    yield from (s for s in certificate()["statements"] if s["kind"] in MATRIX)


def test_the_shipped_certificate_is_accepted() -> None:
    report = check(certificate())
    assert report.accepted, report.reason
    assert report.count("rejected") == 0


def test_every_statement_is_true_where_its_hypotheses_are() -> None:
    for statement in statements():
        setting = certificate()["towers"][statement["tower"]]
        fulfilled = [
            values
            for values in instances(statement["tower"])
            if all(holds(setting, entry, values) for entry in statement["claim"]["given"])
        ]
        assert fulfilled, f"{statement['id']}: nothing fulfils its hypotheses"
        for values in fulfilled:
            assert true(setting, statement["kind"], statement["claim"], values), statement["id"]


WEAKER = {
    "definite": ("semidefinite", "symmetric", "invertible"),
    "semidefinite": ("symmetric",),
    "invertible": ("full_column_rank",),
}


def test_no_hypothesis_may_be_left_out_or_weakened() -> None:
    """Each implication says what its proof needs and no more."""
    document = read_document(plain(certificate()), Meter())
    for statement in statements():
        for number, hypothesis in enumerate(statement["claim"]["given"]):
            kinds = (None, *WEAKER.get(hypothesis["kind"], ()))
            for kind in kinds:
                altered = copy.deepcopy(dict(statement))
                given = altered["claim"]["given"]
                given[number : number + 1] = [] if kind is None else [{**hypothesis, "kind": kind}]
                with pytest.raises(RejectedError):
                    document.decide(read_statement(plain(altered), document.towers, "altered"))


@pytest.mark.parametrize("size", SIZES)
def test_a_long_run_falls_behind_as_said(size: int) -> None:
    """The filter itself, run without noise after a target of constant acceleration."""
    values = completed(certificate()["towers"]["blocks"], matrices("any", 1, size))
    step, acceleration = float(values["t"]), np.asarray(values["acceleration"])
    k1, k2 = np.asarray(values["K1"]), np.asarray(values["K2"])
    position = velocity = np.zeros((size, 1))
    for k in range(1, 3999):
        innovation = acceleration * (k * step) ** 2 / 2 - position
        velocity = velocity + k2 @ innovation
        position = position + k1 @ innovation + step * velocity
    behind = step * np.linalg.solve(k2, acceleration)
    seen = acceleration * (3999 * step) ** 2 / 2
    assert np.allclose(seen - position, behind, rtol=1e-5, atol=1e-5)
    velocity_behind = acceleration * 3999 * step - velocity
    wanted = k1 @ behind / step + step / 2 * acceleration
    assert np.allclose(velocity_behind, wanted, rtol=1e-5, atol=1e-5)


def test_one_coordinate_is_the_alpha_beta_filter() -> None:
    """The variance that the lecture prints for one dimension."""
    values = completed(certificate()["towers"]["blocks"], matrices("diagonal", 3, 1))
    a, b = float(values["alpha"]), float(values["beta"])
    variance = (2 * a * a + 2 * b + a * b) / (a * (4 - 2 * a - b)) * np.asarray(values["B"])
    assert np.allclose(np.asarray(values["W"])[:1, :1], variance, rtol=1e-9)


def test_the_example_beats_every_diagonal_gain() -> None:
    """The example of the derivation by SciPy, and diagonal gains on a grid."""
    from scipy.linalg import solve_discrete_lyapunov

    def first(gain: Any) -> float:
        unit = np.eye(2)
        loop = np.block([[unit - gain - unit, unit], [-unit, unit]])
        assert max(abs(np.linalg.eigvals(loop))) < 1
        column = np.vstack([gain + unit, unit])
        return float(solve_discrete_lyapunov(loop, column @ column.T)[0, 0])

    example = first(np.array([[1 / 2, 1 / 16], [1, 1 / 2]]))
    grid = min(first(np.diag([alpha, 0.5])) for alpha in np.linspace(0.05, 1.45, 57))
    assert abs(example - 133 / 45) < 1e-9
    assert grid >= 3 - 1e-9


def test_what_may_grow_is_no_zero_matrix() -> None:
    """At T K2 = 2 I the updated position stays known while the covariance does not fade."""
    setting = certificate()["towers"]["blocks"]
    (statement,) = (s for s in statements() if s["id"] == "grown-turns")
    values = completed(setting, matrices("grown", 0, 2))
    assert all(holds(setting, entry, values) for entry in statement["claim"]["given"])
    assert np.linalg.norm(np.asarray(values["limit22"])) > 0.1


@pytest.mark.parametrize(("kappa", "attained"), [(0.5, True), (1.9, True), (2.0, False)])
def test_the_trace_of_the_update_is_least_inside_or_at_the_border(
    kappa: float, attained: bool
) -> None:
    """One coordinate, over the stable gains of the position."""
    from scipy.linalg import solve_discrete_lyapunov

    def variance(alpha: float) -> float:
        loop = np.array([[1 - alpha, 1 - alpha], [-kappa, 1 - kappa]])
        gain = np.array([[alpha], [kappa]])
        return float(solve_discrete_lyapunov(loop, gain @ gain.T)[0, 0])

    end = 2 - kappa / 2
    values = [variance(alpha) for alpha in end * np.linspace(0.002, 0.998, 250)]
    assert (int(np.argmin(values)) < 249) is attained
