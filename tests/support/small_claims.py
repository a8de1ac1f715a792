"""Single claims about free letters, judged without a search for repairs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_setting
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = """
format = "gainproof claims 1"
[source]
key = "trial"
title = "trial"
authors = ["A. Reader"]
publication = "unpublished"
[settings.s]
title = "trial"
"""
LETTERS = dict.fromkeys("abcghmpqrstuvwxyz", "{ unit = '1', meaning = 'a number' }")
LETTERS |= dict.fromkeys("ijkn", "{ unit = '1', integer = true, meaning = 'whole' }")
LETTERS |= dict.fromkeys((r"\theta", r"\phi"), "{ unit = '1', meaning = 'an angle' }")


SOLVED: dict[Any, Environment] = {}
"""What was solved for one claim serves the next, as it does within a file."""


def judged(
    kind: str,
    fields: str,
    symbols: Mapping[str, str] | None = None,
    setting: str = "kind = 'algebra'",
    models: Sequence[Mapping[str, Any]] = (),
) -> ClaimVerdict:
    """The verdict on one claim; `fields` is its formula, or lines of the claim's table.

    `symbols` are added to those of LETTERS that the claim may use, in a setting without a model.
    """
    # of most claims it takes a sixth of the time to read twenty letters that they do not use
    said = f"{fields} {symbols}"
    letters = {k: v for k, v in LETTERS.items() if k in said} if "algebra" in setting else {}
    table = "".join(f"'{k}' = {v}\n" for k, v in {**letters, **(symbols or {})}.items())
    lines = fields if " = '" in fields or " = [" in fields else f"latex = '{fields}'"
    claim = f"[[claims]]\nid = '1'\nplace = 'here'\nsetting = 's'\nkind = '{kind}'\n{lines}\n"
    file = read_claim_text(f"{HEAD}{setting}\n[settings.s.symbols]\n{table}{claim}", "trial.toml")
    (found,) = judge_setting(file.settings["s"], file.claims, models, SOLVED)
    return found


@dataclass(frozen=True)
class SmallClaim:
    """One claim, made by a test, as `judged` takes it; `name` says of which sort it is."""

    kind: str
    fields: str
    symbols: Mapping[str, str] = field(default_factory=dict)
    setting: str = "kind = 'algebra'"
    name: str = ""

    def judged(self) -> ClaimVerdict:
        """Its verdict."""
        return judged(self.kind, self.fields, self.symbols, self.setting)


def check(found: ClaimVerdict, wanted: str) -> None:
    """The verdict is the wanted one; a refutation shows an exact point or value."""
    assert found.verdict == wanted, found.reason
    if wanted in ("refuted", "conditional"):
        assert found.witness is not None, found.reason
