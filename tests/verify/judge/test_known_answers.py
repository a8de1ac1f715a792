"""Keys of what is known: alike in every process, another one for whatever differs."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from claim_texts import MODELS
from matrix_claims import claim, text_of

from gainproof.claims.judging import KeptTrials
from gainproof.files import places
from gainproof.jobs import code_digest
from gainproof.jobs.cache import Cache
from gainproof.jobs.code_digest import modules_below
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.known_answers import NOT_READ, Digests, KnownTrials
from gainproof.verify.judge.repair.definition import DefinitionTask
from gainproof.verify.judge.repair.suspects import Suspect
from gainproof.verify.judge.repair.task import RepairTask
from gainproof.verify.judge.task import Task, TrialTask
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker import Workers

OUTSIDE = ("labbe-filterpy-gh-2022", "luli-notes-2023", "stonesoup-transition-2026")
TASKS = (
    "gainproof.verify.judge.task",
    "gainproof.verify.judge.contradicted_convention",
    "gainproof.verify.judge.matrices.repair",
    "gainproof.verify.judge.repair.definition",
    "gainproof.verify.judge.repair.task",
    "gainproof.verify.judge.undefined.task",
    "gainproof.verify.judge.noise_strength",
)
DECIDE = {
    "gainproof.verify.judge.claim_decision",
    "gainproof.verify.judge.convention",
    "gainproof.verify.judge.cells.decision",
    "gainproof.verify.judge.exact.tower",
    "gainproof.verify.judge.worker_answer",
    "gainproof.verify.judge.worker_process",
}
DECIDE_MATRICES = {
    "gainproof.verify.judge.matrices.decision",
    "gainproof.verify.judge.matrices.misprints",
    "gainproof.verify.judge.worker_answer",
    "gainproof.verify.judge.worker_process",
}


@cache
def tasks() -> list[Task]:
    """One of each kind for every claim of some files, whether the judge would ask it or not."""
    found: list[Task] = []
    files = {path.stem: path for path in places.claim_files()}
    texts = [files[name].read_text(encoding="utf-8") for name in OUTSIDE]
    matrices = text_of(claim("A B = A C", more="given = ['B = C']"))
    for text in (*texts, matrices):
        file = read_claim_text(text)
        for one in file.claims:
            setting = file.settings[one.setting]
            found.append(TrialTask(one, setting))
            found.append(RepairTask(one, setting, file.claims, ("a", "b")))
            suspect = Suspect("x", (one,), file.claims, frozenset({"a", "b", "c", "d"}))
            found.append(DefinitionTask(one, setting, (suspect,), ("a",)))
    return found


class Nothing:
    """Knows nothing."""

    def load(self, module: str, key: str) -> str | None:  # noqa: ARG002
        return None

    def store(self, module: str, key: str, text: str) -> None:
        """Forgets it."""


def keys(models: Any = MODELS) -> list[str]:
    known = KnownTrials(Nothing(), models)
    return [known.key(task) for task in tasks()]


def test_keys_are_those_of_other_processes() -> None:
    script = f"import {Path(__file__).stem} as here; print(*here.keys())"
    where = (Path(__file__).parent, Path(__file__).parents[2] / "support")
    path = os.pathsep.join(map(str, where))
    expected = keys()
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": path}
        printed = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, check=True
        )
        assert printed.stdout.decode().split() == expected
    assert len(set(expected)) == len(expected)


def test_other_models_have_other_keys() -> None:
    assert not set(keys()) & set(keys(MODELS[:2]))


def _changed(value: Any, seen: set[tuple[type, str]]) -> Iterator[tuple[str, Any]]:
    """The value with one thing changed, once for each field of each kind of record in it."""
    if is_dataclass(value) and not isinstance(value, type):
        for each in fields(value):
            old, place = getattr(value, each.name), (type(value), each.name)
            if place not in seen:
                seen.add(place)
                yield f"{type(value).__name__}.{each.name}", replace(value, **{each.name: "other"})
            for what, new in _changed(old, seen):
                yield what, replace(value, **{each.name: new})
    elif isinstance(value, Mapping):
        for key, old in value.items():
            yield from ((what, {**value, key: new}) for what, new in _changed(old, seen))
    elif isinstance(value, tuple):
        for n, old in enumerate(value):
            for what, new in _changed(old, seen):
                yield what, (*value[:n], new, *value[n + 1 :])


def test_each_field_of_what_a_task_holds_is_in_its_key() -> None:
    digests, places_seen, unread = Digests(), set[tuple[type, str]](), set()
    for task in tasks():
        before = digests.of(task)
        for what, other in _changed(task, places_seen):
            if digests.of(other) == before:
                unread.add(what)
    assert unread == {f"{kind.__name__}.{name}" for kind, name in NOT_READ}
    assert {"Claim", "Setting", "SymbolEntry", "Formula", "Relation", "MatrixSetting"} <= {
        kind.__name__ for kind, _ in places_seen
    }


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (1, True),
        (1, "1"),
        (0, None),
        (Fraction(1), 1),
        (("a", "b"), ("ab",)),
        (("a", ("b",)), (("a",), "b")),
        ({"a": 1, "b": 2}, {"b": 2, "a": 1}),
        ({"a": 1}, {"a": "1"}),
        (frozenset({"a", "b"}), ("a", "b")),
        ("a', 'b", ("a", "b")),
    ],
)
def test_what_differs_has_another_digest(one: object, other: object) -> None:
    assert Digests().of(one) != Digests().of(other)


def test_what_is_no_plain_content_has_none() -> None:
    with pytest.raises(TypeError, match="no digest of object"):
        Digests().of(object())


def test_a_line_put_in_above_changes_no_key() -> None:
    (task, *_) = tasks()
    lower = TrialTask(replace(task.claim, line=task.claim.line + 1), task.setting)  # type: ignore[attr-defined]
    assert Digests().of(lower) == Digests().of(task)


def test_no_task_reads_the_line_of_a_claim() -> None:
    """The readers count lines of their own."""
    below = {name for name in modules_below(*TASKS) if ".judge." in name}
    of_files = {name for name in below if ".claim." in name or name.endswith(".claim_fields")}
    found = {name for name in below - of_files if re.search(r"\.line\b", _text(name))}
    assert found == {"gainproof.verify.judge.reader.errors"}


def test_all_kinds_of_tasks_are_known_here() -> None:
    named = {name for name in TASKS if re.search(r"class \w*Task\b", _text(name))}
    assert named == set(TASKS)
    others = [
        name
        for name in modules_below("gainproof.verify.judge.judge")
        if name not in TASKS and re.search(r"def run\(self, models: Models", _text(name))
    ]
    assert others == []


def _text(name: str) -> str:
    return modules_below(name)[name].read_text(encoding="utf-8")


CLAIMS = """
format = "gainproof claims 1"
[source]
key = "own"
title = "own"
authors = ["nobody"]
publication = "nowhere"
[symbols]
'x' = { unit = "1", meaning = "a number" }
[settings.s]
title = "numbers"
kind = "algebra"
[[claims]]
id = "1"
place = "p"
kind = "identity"
setting = "s"
latex = 'x + x = 3x'
"""


def test_what_other_code_said_is_not_taken(tmp_path: Path) -> None:
    """Neither other code of the judge nor that of another kind of task."""
    asked: set[tuple[str, ...]] = set()

    def code(words: str) -> Any:
        def digest(*names: str) -> str:
            asked.add(names)
            return f"{words} {names}"

        return digest

    counts = []
    for words in ("old", "old", "new"):
        with Workers((), 60.0, 1, KeptTrials(Cache(tmp_path), code(words))) as workers:
            judge_file(read_claim_text(CLAIMS), (), workers=workers)
            counts.append((workers.taken, workers.judged))
    assert counts == [(0, 2), (2, 0), (0, 2)]
    child = "gainproof.verify.judge.worker_process"
    assert asked == {(TASKS[0], child), (TASKS[4], child)}


@pytest.mark.parametrize("module", TASKS)
def test_the_code_of_a_task_holds_what_decides_it(module: str, tmp_path: Path) -> None:
    """The digest by which answers are kept is that of the modules below a task."""
    below = modules_below(module, "gainproof.verify.judge.worker_process")
    wanted = DECIDE_MATRICES if module == TASKS[2] else DECIDE
    assert below.keys() >= wanted
    kept = KeptTrials(Cache(tmp_path))
    kept.store(module, "key", "text")
    assert kept.load(module, "key") == "text"
    others = [name for name in TASKS if name != module]
    assert [kept.load(name, "key") for name in others] == [None] * len(others)
    assert kept.load(module, "other key") is None
    assert KeptTrials(Cache(tmp_path, fresh=True)).load(module, "key") is None


def test_a_trial_is_not_kept_whose_code_was_edited(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A child that starts after the edit runs other code than that of the digest."""
    kept = KeptTrials(Cache(tmp_path))
    monkeypatch.setattr(code_digest, "is_as_read", lambda *_: False)
    kept.store(TASKS[0], "key", "text")
    assert kept.load(TASKS[0], "key") is None
    monkeypatch.undo()
    kept.store(TASKS[0], "key", "text")
    assert kept.load(TASKS[0], "key") == "text"


@pytest.mark.parametrize("text", ["", "{}", "[]", "no answer", '{"findings": 1}'])
def test_what_cannot_be_read_is_not_known(text: str) -> None:
    class Odd(Nothing):
        def load(self, module: str, key: str) -> str | None:  # noqa: ARG002
            return text

    (task, *_) = tasks()
    assert KnownTrials(Odd(), ()).of(task) is None


def test_what_an_accident_or_a_limit_broke_off_is_not_kept() -> None:
    stored: list[str] = []

    class Noting(Nothing):
        def store(self, module: str, key: str, text: str) -> None:  # noqa: ARG002
            stored.append(text)

    (task, *_) = tasks()
    known = KnownTrials(Noting(), ())
    trial = Trial(task.claim, {}, (), False, 0.0, "why")
    known.keep(task, replace(trial, accident="killed"))
    known.keep(task, replace(trial, timed=True))
    assert stored == []
    known.keep(task, trial)
    assert len(stored) == 1
