"""The page of formulas of kernels: what it has, and what a false formula does."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof.derive.families import acceleration_increments
from gainproof.derive.pages.formula import Formula
from gainproof.derive.pages.kernel_formulas import SCALE, formula_of, read_sections
from gainproof.derive.three_state import kernels
from gainproof.derive.three_state.three_state import derive_three_state
from gainproof.verify.certificate import check

TEXT = kernels.FORMULAS.read_text(encoding="utf-8")


def names_in(formula: Formula) -> set[str]:
    own = {formula.text} if formula.kind == "name" else set()
    return own.union(*map(names_in, formula.parts))


def test_every_output_has_a_formula_and_every_formula_a_use() -> None:
    sections = read_sections(TEXT)
    wanted = {formula_of(kernel, name) for kernel, own in kernels.KERNELS.items() for name in own}
    assert wanted <= set(sections[0].formulas)
    used = {name for each in sections for line in each.formulas.values() for name in names_in(line)}
    plain = {name for each in sections for name in each.formulas if not name.endswith(SCALE)}
    assert plain <= used | wanted


def test_a_section_with_conditions_replaces_what_is_general() -> None:
    general, *others = read_sections(TEXT)
    assert all(each.conditions for each in others)
    assert all(set(each.formulas) & set(general.formulas) for each in others)


@pytest.mark.parametrize(
    ("line", "false"),
    [
        ("    gamma = p/N", "    gamma = (1000001/1000000) (p/N)"),
        ("    d_updated_33 = (x/r) Lambda ((bow", "    d_updated_33 = (x/r) Lambda ((2 bow"),
        ("    omega = 2 (((x/e)/(e t))/r)", "    omega = 3 (((x/e)/(e t))/r)"),
    ],
)
def test_a_false_formula_is_no_proof(
    line: str, false: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert line in TEXT
    changed = tmp_path / "kernels.md"
    changed.write_text(TEXT.replace(line, false), encoding="utf-8")
    monkeypatch.setattr(kernels, "FORMULAS", changed)
    subject = derive_three_state(acceleration_increments.model(), ())
    report = check(
        subject.certificate(),
        claims=subject.claims(),
        model=subject.model_data,
        domain=subject.domains(),
    )
    assert not report.accepted
    rejected = [each for each in report.statements if each.status == "rejected"]
    assert rejected
    assert all(each.id.startswith("kernel-") for each in rejected)
