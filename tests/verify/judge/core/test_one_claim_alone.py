"""The verdict on one claim, made without the rest of its file, is the one that the file gets."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest
from claim_texts import GAINS, HEAD, MODELS

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.record import ClaimFile
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.repair.task import RepairTask
from gainproof.verify.judge.task import TrialTask

SETTINGS = r"""
[settings.open]
title = 'the noise is not said'
kind = 'steady_state'
model = 'search'
[settings.slip]
title = 'one definition is misprinted'
kind = 'algebra'
[settings.slip.symbols]
'x' = { unit = '1', meaning = 'x' }
'y' = { unit = '1', meaning = 'y' }
'w' = { definition = 'x - y', meaning = 'sum' }
[settings.unsaid]
title = 'one symbol is never said'
kind = 'algebra'
[settings.unsaid.symbols]
'x' = { unit = '1', meaning = 'x' }
'u' = { undefined = true, unit = '1', meaning = 'never said' }
"""
CLAIMS = [
    ("open", "identity", r"\alpha^2 = \beta (2 - \alpha)"),
    ("open", "identity", r"\alpha + \beta = \frac{2 \beta}{\alpha}"),
    ("open", "inequality", r"\beta < \alpha"),
    ("slip", "definition", r"w = x - y"),
    ("slip", "identity", r"w - x = y"),
    ("slip", "identity", r"w^2 = x^2 + 2 x y + y^2"),
    ("slip", "identity", r"2 x = x + x"),
    ("slip", "remark", ""),
    ("unsaid", "identity", r"u = 2 x"),
    ("unsaid", "identity", r"u + x = 3 x"),
]


@pytest.fixture(scope="module")
def file() -> ClaimFile:
    lines = [HEAD, GAINS, SETTINGS]
    for n, (setting, kind, latex) in enumerate(CLAIMS):
        said = f"latex = '{latex}'" if latex else "text = 'a remark'\nnote = 'an opinion'"
        head = f"[[claims]]\nid = 'c{n}'\nplace = 'p'\nsetting = '{setting}'\nkind = '{kind}'\n"
        lines.append(head + said + "\n")
    return read_claim_text("\n".join(lines), "whole.toml", [m["name"] for m in MODELS])


def test_each_claim_alone_is_judged_as_in_its_file(file: ClaimFile) -> None:
    whole = judge_file(file, MODELS)
    assert {"proved", "refuted", "definition", "remark"} <= {v.verdict for v in whole}
    assert any(v.convention for v in whole)
    assert any(v.undefined for v in whole)
    assert whole[3].repair is not None
    for verdict in whole:
        (alone,) = judge_file(file, MODELS, only=verdict.id)
        assert replace(alone, seconds=0.0) == replace(verdict, seconds=0.0)


def test_only_what_the_claim_needs_is_done(
    file: ClaimFile, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[tuple[str, str]] = []
    for kind in (TrialTask, RepairTask):
        before: Any = kind.run

        def run(self: Any, *arguments: Any, before: Any = before) -> Any:
            done.append((type(self).__name__, self.claim.id))
            return before(self, *arguments)

        monkeypatch.setattr(kind, "run", run)
    judge_file(file, MODELS, only="c6")
    assert done == [("TrialTask", f"c{n}") for n in (4, 5, 6)]
    done.clear()
    judge_file(file, MODELS, only="c4")
    assert {("RepairTask", "c4"), ("RepairTask", "c5")} <= set(done)
    assert {name for _, name in done} == {"c4", "c5", "c6"}
