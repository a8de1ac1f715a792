"""Variances and lags of filters with any gains: formulas that are true, neighbours that are not,
and the judge's own expressions against eigenvalues, Kronecker products and long runs.
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from free_gains import lags, predicted_covariance, radius, verdict
from one_of_each import further
from small_claims import check, judged

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import number
from gainproof.verify.judge.fixed_gain.environment import fixed_gain
from gainproof.verify.judge.fixed_gain.matrices import GainModel

GAINS = (
    (Fraction(1, 2), Fraction(1, 3)),
    (Fraction(5, 4), Fraction(1, 5)),
    further((Fraction(1, 5), Fraction(3))),
    (Fraction(1, 2), Fraction(1, 3), Fraction(1, 10)),
    further((Fraction(6, 5), Fraction(1), Fraction(1, 4))),
    (Fraction(3, 4), Fraction(2), Fraction(2)),
)


STEPS = tuple(tuple(map(Fraction, text.split())) for text in ("1 1 1", "1/50 30 1/9", "40 1/7 3"))


def kinematic(size: int) -> GainModel:
    """The model of position and its derivatives."""
    rows = {1: ("1",), 2: ("1 1", "0 1"), 3: ("1 1 1/2", "0 1 1", "0 0 1")}[size]
    transition = tuple(tuple(Fraction(x) for x in row.split()) for row in rows)
    return GainModel(transition, tuple(Fraction(int(i == 0)) for i in range(size)))


@pytest.mark.parametrize("gains", GAINS)
def test_quantities_are_those_of_plain_numbers(gains: tuple[Fraction, ...]) -> None:
    assert radius([float(g) for g in gains]) < 1
    size = len(gains)
    environment = fixed_gain(kinematic(size))
    values = {f"filter_gain.{i + 1}": number(g) for i, g in enumerate(gains)}
    values |= {"sampling_interval": number(1), "measurement_noise_deviation": number(1)}
    values |= {f"target_motion.{m}": number(1) for m in range(4)} | {"sample_number": number(4000)}

    def value(name: str) -> float:
        found = constant_value(substituted(environment.quantities[name], values))
        assert found is not None
        return float(found)

    wanted = predicted_covariance([float(g) for g in gains])
    runs = [lags([float(g) for g in gains], m) for m in range(4)]
    for i in range(size):
        for j in range(size):
            assert value(f"predicted_covariance.{i + 1}.{j + 1}") == pytest.approx(
                wanted[i, j], rel=1e-9
            )
        for m in range(4):
            # the run rounds numbers of the size of the position
            scale = 4000.0**m * 1e-11 + 1e-12
            for which, run in zip(("predicted", "updated"), runs[m], strict=True):
                assert value(f"{which}_lag.{i + 1}.{m}") == pytest.approx(run[i], abs=scale)


def test_the_region_over_its_steps_is_stable_and_reached() -> None:
    region = fixed_gain(kinematic(3)).region
    assert region is not None
    for steps in STEPS:
        put_in = {n: number(s) for n, s in zip(region.steps, steps, strict=True)}
        values = {
            g: constant_value(substituted(region.charted.quantities[g], put_in))
            for g in region.gains
        }
        assert radius([float(v) for v in values.values() if v is not None]) < 1
        back = {g: number(v) for g, v in values.items() if v is not None}
        again = [constant_value(substituted(region.back[n], back)) for n in region.steps]
        assert again == list(steps)


P = r"p_{11} = \frac{2\alpha^2 + 2\beta + \alpha\beta}{\alpha(4 - 2\alpha - \beta)} B"
G = r"\frac{8\beta^2}{(2-\alpha)\{2\alpha\beta - \gamma(2-\alpha)\}(4-2\alpha-\beta)} B"


@pytest.mark.parametrize(
    ("latex", "states", "wanted"),
    [
        (P, 2, "proved"),
        (P.replace("2\\beta +", "3\\beta +"), 2, "refuted"),
        (P.replace("4 -", "4 +"), 2, "refuted"),
        (P.replace(" + \\alpha\\beta", " - \\alpha\\beta"), 2, "refuted"),
        (P.replace("p_{11}", "s_{11}"), 2, "refuted"),
        (P.replace("+ \\alpha\\beta", "- 3\\alpha\\beta").replace("p_", "s_"), 2, "proved"),
        (P, 3, "refuted"),
        (f"p_{{11}} = {G} + \\frac{{\\alpha}}{{2-\\alpha}} B", 3, "proved"),
        further(f"p_{{11}} = {G} + \\frac{{\\alpha}}{{2+\\alpha}} B", 3, "refuted"),
        further(f"p_{{11}} = {G} - \\frac{{\\alpha}}{{2-\\alpha}} B", 3, "refuted"),
        further(r"p_{22} = \frac{2\beta^2}{\alpha(4 - 2\alpha - \beta) T^2} B", 2, "proved"),
        further(r"p_{22} = \frac{\beta^2}{\alpha(4 - 2\alpha - \beta) T^2} B", 2, "refuted"),
        further(r"e_{10} = 0", 2, "proved"),
        further(r"e_{11} = 0", 2, "proved"),
        (r"e_{12} = \frac{a_c}{\beta} T^2", 2, "proved"),
        (r"e_{12} = -\frac{a_c}{\beta} T^2", 2, "refuted"),
        (r"e_{12} = \frac{a_c}{\alpha} T^2", 2, "refuted"),
        further(r"e_{12} = 0", 2, "refuted"),
        (r"f_{12} = (1 - \alpha) \frac{a_c}{\beta} T^2", 2, "proved"),
        further(r"f_{12} = \frac{a_c}{\beta} T^2", 2, "refuted"),
        # growing without bound, hence no value that stays
        (r"e_{13} = \frac{j_c}{\beta} T^3", 2, "refuted"),
        (r"e_{12} = 0", 3, "proved"),
        further(r"e_{13} = \frac{j_c T^3}{\gamma}", 3, "proved"),
        further(r"e_{13} = \frac{j_c T^3}{2\gamma}", 3, "refuted"),
    ],
)
def test_identities(latex: str, states: int, wanted: str) -> None:
    check(verdict("identity", latex, states), wanted)


def test_what_has_no_value_without_stability_is_told_of_stable_filters() -> None:
    found = verdict("identity", P)
    assert found.domain == "wherever the filter is stable"
    check(verdict("inequality", "p_{11} > 0"), "proved")
    check(verdict("inequality", "p_{11} > B"), "conditional")


def test_what_needs_no_stability_is_about_all_gains() -> None:
    check(verdict("inequality", r"\alpha < 2"), "conditional")
    check(verdict("implication", r"p_{11} < B \Rightarrow \alpha < 2"), "proved")


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"e_{13} \to \infty \quad (k \to \infty)", "proved"),
        (r"e_{13} \to 0 \quad (k \to \infty)", "refuted"),
        (r"\frac{e_{13}}{k} \to \frac{j_c T^3}{\beta} \quad (k \to \infty)", "proved"),
        (r"\frac{e_{13}}{k} \to \frac{j_c T^3}{\alpha} \quad (k \to \infty)", "refuted"),
        (r"e_{12} \to \infty \quad (k \to \infty)", "refuted"),
    ],
)
def test_lags_that_grow(latex: str, wanted: str) -> None:
    found = verdict("limit", f"latex = '{latex}'\ndomain = 'j_c > 0, a_c > 0'")
    assert found.verdict == wanted, found.reason


def test_process_noise_of_ones_own() -> None:
    own = r"""kind = 'fixed_gain'
transition = [["1", "T"], ["0", "1"]]
measurement = [["1", "0"]]
process_noise = [["0", "0"], ["0", "q"]]
"""
    symbols = {
        r"\alpha": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
        r"\beta": "{ quantity = 'filter_gain.2', meaning = 'gain' }",
        "T": "{ quantity = 'sampling_interval', meaning = 'interval' }",
        "B": "{ quantity = 'measurement_noise_variance', meaning = 'noise' }",
        "q": "{ unit = 'm^2 s^-2', domain = 'q > 0', meaning = 'noise of the velocity' }",
        "p": "{ quantity = 'predicted_covariance.1.1', meaning = 'variance' }",
    }
    noise = r"\frac{2\alpha^2 + 2\beta + \alpha\beta}{\alpha(4 - 2\alpha - \beta)} B"
    # of the velocity alone: by a Kronecker product at one point
    gains = (0.5, 0.25)
    driven = predicted_covariance(gains, np.diag([0.0, 1.0])) - predicted_covariance(gains)
    assert driven[0, 0] == pytest.approx((2 - 0.5) / (0.5 * 0.25 * (4 - 2 * 0.5 - 0.25)), rel=1e-12)
    more = r"\frac{(2 - \alpha) q T^2}{\alpha\beta(4 - 2\alpha - \beta)}"
    check(judged("identity", f"p = {noise} + {more}", symbols, own), "proved")
    check(judged("identity", f"p = {noise} + 2 {more}", symbols, own), "refuted")
    check(judged("identity", f"p = {noise}", symbols, own), "refuted")


ONE = {
    r"\alpha": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
    "B": "{ quantity = 'measurement_noise_variance', meaning = 'variance of the noise' }",
    "P": "{ quantity = 'predicted_covariance.1.1', meaning = 'entry' }",
    "q": "{ unit = 'm^2', meaning = 'process noise', domain = 'q > 0' }",
}
DRIVEN = "kind = 'fixed_gain'\nstates = 1\nprocess_noise = [['q']]"


@pytest.mark.parametrize(
    ("kind", "latex", "wanted"),
    [
        ("inequality", "P > 0", "proved"),
        ("inequality", r"P > \frac{\alpha}{2-\alpha}B", "proved"),
        ("inequality", r"P > \frac{2\alpha}{2-\alpha}B", "conditional"),
        # the premise holds for q = 0 alone
        ("implication", r"P = \frac{\alpha}{2-\alpha}B \Rightarrow \alpha = 1", "undecided"),
    ],
)
def test_the_domain_of_a_noise_holds_where_no_formula_names_it(
    kind: str, latex: str, wanted: str
) -> None:
    check(judged(kind, f"latex = '{latex}'", ONE, DRIVEN), wanted)


def test_the_domain_of_a_gain_holds_where_no_condition_names_it() -> None:
    symbols = {
        r"\alpha": r"{ quantity = 'filter_gain.1', meaning = 'gain', domain = '0 < \alpha < 1' }",
        r"\beta": "{ quantity = 'filter_gain.2', meaning = 'gain' }",
    }
    fields = r"latex = '0 < \beta < 2'" + "\nsense = 'sufficient'"
    setting = "kind = 'fixed_gain'\nstates = 2"
    check(judged("stability", fields, symbols, setting), "proved")
    wider = symbols | {r"\alpha": symbols[r"\alpha"].replace("< 1", "< 2")}
    check(judged("stability", fields, wider, setting), "conditional")
