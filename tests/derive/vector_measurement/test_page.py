"""The page on position and velocity measured: edited, and for noises that no family has."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

from gainproof.derive.derivation import PageError
from gainproof.derive.families.position_velocity import STRENGTH
from gainproof.derive.families.position_velocity import build as build_white
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.quantity import SAMPLING_INTERVAL
from gainproof.derive.subject import Subject
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.position_velocity import NAME, derive_position_velocity
from gainproof.verify.certificate import check, check_statement

TEXT = (FOLDER / f"{NAME}.md").read_text(encoding="utf-8")
T = SAMPLING_INTERVAL.symbol


def with_noise(first: str, folder: Path = FOLDER) -> Subject:
    """Of a process noise Q12 = Q22/2 with Q11/Q22 = first, T = 1."""
    shape = [[sp.Rational(first) * T**4, T**3 / 2], [T**3 / 2, T**2]]
    noise = sp.ImmutableDenseMatrix(STRENGTH.symbol**2 * sp.ImmutableDenseMatrix(shape))
    return derive_position_velocity(
        measured_model("own", "Own", noise, STRENGTH), (), folder=folder
    )


def edited(folder: Path, right: str, wrong: str) -> Subject:
    """The subject of the page with one place changed; e = 1/4, so that it has no root."""
    assert TEXT.count(right) == 1
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, folder)
    (folder / f"{NAME}.md").write_text(TEXT.replace(right, wrong), encoding="utf-8")
    return with_noise("5/16", folder)


def status(subject: Subject, *steps: str) -> list[str]:
    """What the checker says of statements."""
    found: dict[str, Any] = json.loads(json.dumps(subject.certificate()))
    return [check_statement(found, step).status for step in steps]


NOISES = ("3/8", "5/12", "7/16", "11/36", "5/16")
"""Q11/Q22, where e = 4 Q11/Q22 - 1 is 1/2, 2/3, 3/4, 2/9, 1/4: its root is over that of 2, 6, 3, 2
and 1.
"""
OF_THE_ROOT = ("riccati", "stable", "level", "rest-solved", "kernel-gains")


@pytest.mark.parametrize("first", NOISES[:1])
def test_a_noise_whose_root_is_another_one_is_derived(first: str) -> None:
    assert status(with_noise(first), *OF_THE_ROOT) == ["proved"] * len(OF_THE_ROOT)


@pytest.mark.thorough
@pytest.mark.parametrize("first", NOISES)
def test_all_of_its_statements_are_proved(first: str) -> None:
    report = check(json.loads(json.dumps(with_noise(first).certificate())))
    assert report.accepted, report.reason
    assert len(report.statements) == 162


WRONG = [
    ("prediction", "U12 + U22 + {n} Lambda^2, U22", "U12 - U22 + {n} Lambda^2, U22"),
    ("level", "w^2 = 1 + {d} t^2", "w^2 = 1 - {d} t^2"),
    ("rest-solved", "h ({d_t2} + {level} kappa)", "h ({d_t2} + kappa)"),
    ("width-start-small", "1/t_h^2 - {start_small}\n", "1/t_h^2 + {start_small}\n"),
]


@pytest.mark.parametrize(("step", "right", "wrong"), WRONG)
def test_a_formula_that_is_not_true_is_rejected(
    tmp_path: Path, step: str, right: str, wrong: str
) -> None:
    assert status(edited(tmp_path, right, wrong), step) == ["rejected"]


MISTAKES = [
    ("h ({d_t2} + {level} kappa)", "h ({d_t2} + {leve} kappa)", "no slot 'leve'; near it: level"),
    ("### level (if d)", "### ratio (if d)", "there is a step 'ratio' already"),
    ("### pole-sum (if positive_sum)", "### pole-sum (if f)", "there is a step 'pole-sum' already"),
    ("### level (if d)", "### level (in side, if d)", "no setting 'side' above"),
    ("    S = velocity_ratio\n", "    S = velocity\n", "'S' has no value in setting main"),
]


@pytest.mark.parametrize(("right", "wrong", "said"), MISTAKES)
def test_a_mistake_is_told_with_its_line(tmp_path: Path, right: str, wrong: str, said: str) -> None:
    with pytest.raises(PageError) as caught:
        edited(tmp_path, right, wrong)
    assert f"{NAME}.md, line " in str(caught.value)
    assert said in str(caught.value)


def test_what_a_source_prints_is_on_the_page_of_its_own_family_alone() -> None:
    own, white = with_noise("1/3"), build_white()
    ids = {step.id for step in own.derivation.steps}
    more = [step.id for step in white.derivation.steps if step.id not in ids]
    assert len(more) == 11
    assert all(step.startswith("printed-") for step in more)
    assert {own.derivation.latex.get(name) for name in ("source_b", "source_c")} == {None}
    assert white.derivation.latex["source_b"] == "B"
