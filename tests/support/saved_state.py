"""The state file of a campaign."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def save(path: Path, state: Mapping[str, Any]) -> None:
    """Written beside and moved, so that an interrupt leaves the old state whole."""
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".part")
    beside.write_text(json.dumps(state), encoding="utf-8")
    os.replace(beside, path)
