"""Whatever stands in a model, it is derived, or refused in one line that names the reason."""

from __future__ import annotations

import pytest
from model_fuzz import drawn, outcome
from one_of_each import cases

from gainproof.derive.any_two_state import proved_module


@pytest.mark.parametrize("seed", cases(range(30, 70), lambda seed: seed < 45))
def test_models_with_odd_entries(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the bounds of kernels; `tests/campaigns/models.py` goes on, with them."""
    monkeypatch.setattr(proved_module, "prove", lambda *_: None)
    said = outcome(drawn(seed))
    assert "\n" not in said
    assert said == "derived" or said.startswith("model trial: ")
