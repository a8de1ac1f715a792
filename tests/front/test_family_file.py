"""A mistake in the file of a family, or in its line of the catalogue, is a line, no traceback."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

from gainproof.bad_input import BadInputError
from gainproof.derive.catalogue import Entry
from gainproof.subjects import deriving

FAMILY = """
import sympy as sp

from gainproof.derive.families.kinematic import position_velocity_model
from gainproof.derive.quantity import METRE, SECOND, Quantity
from gainproof.derive.steady_state.two_state import derive_two_state

STRENGTH = Quantity("shake", r"w", "deviation of the velocity's change", METRE / SECOND)


def build():
    w = STRENGTH.symbol
    noise = sp.ImmutableDenseMatrix([[0, 0], [0, w**2]])
    return derive_two_state(position_velocity_model("own", "Own", noise, STRENGTH), ())
"""


def built(
    folder: Path, text: str, monkeypatch: pytest.MonkeyPatch, entry: Entry | None = None
) -> object:
    (folder / "own_family.py").write_text(text, encoding="utf-8")
    monkeypatch.syspath_prepend(folder)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setattr(deriving, "CATALOGUE", (entry or Entry("own", "own_family"),))
    importlib.invalidate_caches()
    sys.modules.pop("own_family", None)
    return deriving.build("own")


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("[0, w**2]", "[0, w]", "own_family: model own: entry 2,2 of process_noise should have"),
        ("[0, w**2]", "[0, w**2/10.0]", "process_noise should hold rational numbers, its entry"),
        ("[[0, 0]", "[[0, w**2]", "process_noise should be symmetric, its entry 1,2 is"),
        ("METRE / SECOND)", "METRE)", "entry 2,2 of process_noise should have the unit"),
        ("sp.Imm", "sp.Im", "own_family.py, line 13: AttributeError: "),
        ("Quantity\n", "Mile\n", "own_family.py, line 5: ImportError: "),
        ("[0, w**2]", "[w**2]", "own_family.py, line 13: ValueError: "),
        ("def build():", "def build()", "own_family.py, line 11: SyntaxError: "),
        ("def build", "def make", "the catalogue's line on own: AttributeError: "),
    ],
)
def test_a_mistake_is_a_line(
    right: str, wrong: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = FAMILY.replace(right, wrong, 1)
    with pytest.raises(BadInputError) as caught:
        built(tmp_path, text, monkeypatch)
    assert said in str(caught.value)
    assert str(tmp_path.parent) not in str(caught.value)


def test_a_module_that_is_not_there_is_a_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    entry = Entry("own", "gainproof.derive.families.none")
    with pytest.raises(BadInputError, match="the catalogue's line on own: ModuleNotFoundError"):
        built(tmp_path, FAMILY, monkeypatch, entry)


def test_a_fault_of_the_program_keeps_its_traceback(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = FAMILY.replace('position_velocity_model("own", "Own", noise, STRENGTH)', "None")
    with pytest.raises(AttributeError):
        built(tmp_path, text, monkeypatch)
