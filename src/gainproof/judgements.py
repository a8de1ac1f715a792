"""Judgements of claim files, from worker processes or the cache."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gainproof import derivations, places, workers
from gainproof.bad_input import BadInputError, unknown_name
from gainproof.workshop import Workshop


def judge(files: Sequence[Path], shop: Workshop) -> list[dict[str, Any]]:
    """{"source", "claims"} of every file. Raises BadInputError for a file that cannot be used."""
    texts = {}
    for file in files:
        try:
            texts[file] = file.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise BadInputError(f"{places.shown(file)}: cannot be read: {error}") from None
    models = [entry["model"] for entry in derivations.overview(shop) if entry["model"]]
    jobs = [
        workers.Job(
            file.stem, "judge", {"path": places.shown(file), "text": text, "models": models}
        )
        for file, text in texts.items()
    ]
    return shop.results("judged", jobs)


def find(name: str) -> Path:
    """A claim file by its path, or one of gainproof's own by its key."""
    own = {path.stem: path for path in places.claim_files()}
    if name in own:
        return own[name]
    if Path(name).exists() or name.endswith(".toml") or Path(name).name != name:
        return Path(name)
    raise unknown_name("claim file", name, own)
