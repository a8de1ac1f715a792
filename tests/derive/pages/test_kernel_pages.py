"""The pages of formulas of kernels: what they have, and what a false formula does."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from mpmath import mp, mpf

from gainproof.derive.families import acceleration_increments, random_acceleration
from gainproof.derive.families import continuous_white_acceleration as white_acceleration
from gainproof.derive.pages.formula import Formula
from gainproof.derive.pages.kernel_formulas import (
    SCALE,
    TURN,
    formula_of,
    read_sections,
)
from gainproof.derive.steady_state import kernels as two
from gainproof.derive.steady_state.names import INDEX, KAPPA, PREDICTED, RHO, ROOT_3
from gainproof.derive.subject import Subject
from gainproof.derive.three_state import kernels as three
from gainproof.derive.three_state.three_state import derive_three_state
from gainproof.verify.certificate import check

FORMS_OF_STEPS = ("psi", "chi", "unbent", "fall_alpha", "fall_beta", "fall_position")
POLES = ("centre", "half_width", "inverse_sigma")
AT_ONCE = [f"{two.AT_ONCE}{name}" for name in two.KERNELS["gains_with_derivatives"]]


def names_in(formula: Formula) -> set[str]:
    own = {formula.text} if formula.kind == "name" else set()
    return own.union(*map(names_in, formula.parts))


def text_of(page: Any) -> str:
    found: str = page.FORMULAS.read_text(encoding="utf-8")
    return found


def outputs_of(page: Any) -> set[str]:
    return {formula_of(kernel, name) for kernel, own in page.KERNELS.items() for name in own}


PAGES: dict[str, tuple[Any, set[str]]] = {
    # the predictor gains of two states are in `gain_kernels`
    "two": (two, outputs_of(two) - {*two.PREDICTOR} | {*FORMS_OF_STEPS, *POLES, *AT_ONCE}),
    "three": (three, outputs_of(three)),
}


@pytest.mark.parametrize(("page", "wanted"), PAGES.values(), ids=PAGES)
def test_every_output_has_a_formula_and_every_formula_a_use(page: Any, wanted: set[str]) -> None:
    sections = read_sections(text_of(page))
    assert wanted <= set(sections[0].formulas)
    used = {name for each in sections for line in each.formulas.values() for name in names_in(line)}
    plain = {name for each in sections for name in each.formulas}
    plain = {name for name in plain if not name.endswith((SCALE, TURN))}
    assert plain <= used | wanted


@pytest.mark.parametrize("page", [two, three], ids=list(PAGES))
def test_a_section_with_conditions_replaces_what_is_general(page: Any) -> None:
    general, *others = read_sections(text_of(page))
    assert all(each.conditions for each in others)
    assert all(set(each.formulas) & set(general.formulas) for each in others)


def rejected(
    page: Any, line: str, false: str, build: Any, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> list[str]:
    """What the check of a certificate rejects where a line of a page is false."""
    text = text_of(page)
    assert text.count(f"    {line}\n") == 1
    changed = folder / "kernels.md"
    changed.write_text(text.replace(f"    {line}\n", f"    {false}\n"), encoding="utf-8")
    monkeypatch.setattr(page, "FORMULAS", changed)
    subject: Subject = build()
    report = check(
        subject.certificate(),
        claims=subject.claims(),
        model=subject.model_data,
        domain=subject.domains(),
    )
    assert not report.accepted
    return [each.id for each in report.statements if each.status == "rejected"]


def three_states() -> Subject:
    return derive_three_state(acceleration_increments.model(), ())


@pytest.mark.parametrize(
    ("line", "false"),
    [
        ("gamma = p/N", "gamma = (1000001/1000000) (p/N)"),
        (
            "d_updated_33 = (x/r) Lambda ((bow + 4)/broad)",
            "d_updated_33 = (x/r) Lambda ((2 bow + 4)/broad)",
        ),
        ("omega = 2 (((x/e)/(e t))/r)", "omega = 3 (((x/e)/(e t))/r)"),
    ],
)
def test_a_false_formula_of_three_states_is_no_proof(
    line: str, false: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = rejected(three, line, false, three_states, tmp_path, monkeypatch)
    assert found
    assert all(name.startswith("kernel-") for name in found)


@pytest.mark.parametrize(
    ("line", "false", "build", "step"),
    [
        (
            "at_once_d_beta = both (low/r + 1)",
            "at_once_d_beta = both (low/r + 2)",
            random_acceleration.build,
            "kernel-gains-with-derivatives",
        ),
        (
            "cube = kappa/(middle + rho/2)",
            "cube = kappa/(middle + rho/3)",
            random_acceleration.build,
            "kernel-updated-covariance-second-derivatives",
        ),
        (
            "raised = kappa + (e/2) unit",
            "raised = kappa + (e/3) unit",
            white_acceleration.build,
            "derivative-alpha",
        ),
        (
            "alpha = (2/total) rho",
            "alpha = (1000001/1000000) (2/total) rho",
            white_acceleration.build,
            "kernel-updated-covariance",
        ),
    ],
)
def test_a_false_formula_of_two_states_is_no_proof(
    line: str, false: str, build: Any, step: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert step in rejected(two, line, false, build, tmp_path, monkeypatch)


WANTED = ("alpha", "beta", *PREDICTED, "updated_22")


@pytest.mark.parametrize("e", ["0", "1/1000", "1/3", "1"])
@pytest.mark.parametrize("n", ["0", "1/4", "1/2"])
def test_two_states_are_what_textbooks_say_and_derivatives_those_of_differences(
    e: str, n: str
) -> None:
    formulas = [f"{order}{name}" for order in ("", "d_", "dd_") for name in WANTED]
    forms = two.symbolic_forms(Fraction(e), Fraction(n), formulas)
    known = (INDEX, KAPPA, RHO, ROOT_3)
    compute = sp.lambdify(known, [forms[name] for name in formulas], "mpmath")
    with mp.workdps(50):
        step = mpf(10) ** -12
        for at in (mpf(1) / 50, mpf(3) / 2, mpf(40)):
            root = mp.sqrt(4 / at**2 + number(e) / 4)
            ratio = mp.sqrt(root + (1 + number(e)) / 4)
            found = dict(zip(formulas, compute(at, root, ratio, mp.sqrt(3)), strict=True))
            below, here, above = (textbook(e, n, at + sign * step) for sign in (-1, 0, 1))
            for name in WANTED:
                first = (above[name] - below[name]) / (2 * step)
                second = (above[name] - 2 * here[name] + below[name]) / step**2
                assert abs(found[name] / here[name] - 1) < 1e-40
                assert abs(found[f"d_{name}"] / first - 1) < 1e-15
                assert abs(found[f"dd_{name}"] / second - 1) < 1e-15


def number(text: str) -> mpf:
    top, _, below = text.partition("/")
    return mpf(top) / mpf(below or 1)


def textbook(e: str, n: str, index: mpf) -> dict[str, mpf]:
    """Gains by the quadratic of sigma, covariances by the gains."""
    half = (index + mp.sqrt(16 + number(e) * index**2)) / 4
    sigma = half + mp.sqrt(half**2 - 1)
    alpha, beta = 1 - 1 / sigma**2, index / sigma
    rest, share = 1 - alpha, number(n)
    predicted = (alpha, beta, beta * (alpha + (1 - share) * beta))
    updated = beta * (alpha - share * beta) / rest
    entries = (alpha, beta, *(entry / rest for entry in predicted), updated)
    return dict(zip(WANTED, entries, strict=True))
