"""Which models a judge is given."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from gainproof.claims import judgements
from gainproof.jobs.cache import Cache
from gainproof.subjects import derivations


def test_a_model_on_which_several_subjects_rest_is_given_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Twice it would be judged twice, and a claim about it would name it as the one chosen."""
    one, other = ({"name": name, "process_noise": [[name]]} for name in ("one", "other"))
    entries: list[dict[str, Any]] = [{"model": m} for m in (one, None, other, dict(one))]
    monkeypatch.setattr(derivations, "outlines", lambda: entries)
    file = tmp_path / "x.toml"
    file.write_text("")
    (job,) = judgements.jobs([file], Cache(tmp_path)).values()
    assert job.arguments["models"] == [one, other]
