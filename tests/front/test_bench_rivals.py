"""What `gainproof bench` compares kernels with computes the same as they do."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gainproof.bench import machine, rivals
from gainproof.bench.arguments import sample
from gainproof.bench.subjects import Measured, measured_kernels

CASES = (
    ("random-acceleration", "gains"),
    ("random-acceleration", "predicted_covariance_derivatives"),
    ("polar-coordinates", "to_polar"),
    ("range-doppler", "range_doppler_in_plane"),
)


def the(subject: str, name: str) -> Measured:
    (found,) = [item for item in measured_kernels([subject]) if item.kernel.name == name]
    return found


@pytest.mark.parametrize("tool", ["numexpr", "numba", "jax"])
@pytest.mark.parametrize(("subject", "name"), CASES)
def test_the_textbook_form_by_other_means(
    tool: str, subject: str, name: str, tmp_path: Path
) -> None:
    pytest.importorskip(tool)
    item = the(subject, name)
    if item.textbook is None:
        pytest.skip("no textbook form")
    given = sample(item.signature, 100)
    asked: Any = getattr(rivals, f"with_{tool}")
    call = asked(item, given, tmp_path) if tool == "numba" else asked(item, given)
    # the textbook forms lose digits where they cancel
    for found, expected in zip(call(), item.function(*given), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-9 * np.abs(expected).max())


def test_what_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    def absent(name: str) -> Any:
        raise ImportError(name)

    monkeypatch.setattr("gainproof.bench.rivals.importlib.import_module", absent)
    with pytest.raises(rivals.UnfitError, match="not installed"):
        rivals.with_numexpr(the("random-acceleration", "gains"), [np.ones(3)])


def test_the_machine_is_told_without_names_and_paths() -> None:
    import platform

    facts = machine.facts()
    assert {"processor", "system", "Python", "numpy", "sympy"} <= set(facts)
    text = " ".join(facts.values())
    assert str(Path.home()) not in text
    assert "/bin" not in text
    assert platform.node() not in text.split()
