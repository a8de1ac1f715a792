"""Claim files made for a test: a head with a steady state's symbols, one setting, some claims."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.record import ClaimFile
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.verdict import ClaimVerdict

MODELS: tuple[dict[str, Any], ...] = tuple(
    {
        "name": name,
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": noise,
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
    for name, noise in (
        ("random-velocity", [["0", "0"], ["0", "1"]]),
        ("random-acceleration", [["1/4", "1/2"], ["1/2", "1"]]),
        ("continuous-white-acceleration", [["1/3", "1/2"], ["1/2", "1"]]),
    )
)
SOLVED: dict[Any, Environment] = {}
"""What was solved for one file serves the next."""
HEAD = """
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
"""
GAINS = """
[symbols]
'k' = { quantity = "sample_number", meaning = "sample" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'\\Lambda' = { quantity = "tracking_index", meaning = "index" }
'\\alpha' = { quantity = "filter_gain.1", meaning = "gain" }
'\\beta' = { quantity = "filter_gain.2", meaning = "gain" }
"""


def steady(model: str = "search", gain: str = "filter", more: str = "") -> str:
    """A setting `s` about a steady state, with the symbols of gains."""
    setting = f"title = 's'\nkind = 'steady_state'\nmodel = '{model}'\ngain = '{gain}'\n"
    return f"{GAINS}[settings.s]\n{setting}{more}\n"


def memory(degree: int, more: str = "") -> str:
    """A setting `s` about least squares over all samples."""
    setting = f"title = 's'\nkind = 'growing_memory'\ndegree = {degree}\ngain = 'filter'\n"
    return f"{GAINS}[settings.s]\n{setting}{more}\n"


def algebra(symbols: str) -> str:
    """A setting `s` without a model."""
    return f"[symbols]\n{symbols}\n[settings.s]\ntitle = 's'\nkind = 'algebra'\n"


def claim_file(setting: str, claims: Sequence[tuple[str, str]], more: str = "") -> ClaimFile:
    """Claims c0, c1, ... given as kind and LaTeX; `more` are further fields of each."""
    text = HEAD + setting
    for number, (kind, latex) in enumerate(claims):
        text += f"[[claims]]\nid = 'c{number}'\nplace = 'p'\nkind = '{kind}'\nsetting = 's'\n"
        text += f"latex = '{latex}'\n{more}\n"
    return read_claim_text(text)


def judged(
    setting: str, *claims: tuple[str, str], more: str = "", **options: Any
) -> list[ClaimVerdict]:
    """The verdicts on c0, c1, ..."""
    return list(judge_file(claim_file(setting, claims, more), MODELS, solved=SOLVED, **options))
