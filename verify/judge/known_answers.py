"""Answers of tasks that are known from before, each by all that it depends on.

What a task says depends on its own content, on the models and on the code: never on a limit of
time, on the machine or on what else was judged. What a chance had a part in is not kept.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from fractions import Fraction
from typing import Any, Protocol

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.task import Models, Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker_answer import BadAnswer, answer_bytes, read_answer

NOT_READ = frozenset({(Claim, "line")})
"""Fields that no task reads: a line put in above a claim leaves what is known of it."""


class Known(Protocol):
    """Keeps texts by key. What a key does not say is the code on which the answer depends: that of
    the module of the task, and the versions of what it imports.
    """

    def load(self, module: str, key: str) -> str | None:
        """The text that was stored, None if there is none."""
        ...

    def store(self, module: str, key: str, text: str) -> None:
        """Keep a text."""
        ...


class KnownTrials:
    """What was said of tasks under these models."""

    def __init__(self, known: Known, models: Models) -> None:
        self._known, self._digests = known, Digests()
        self._about = json.dumps([dict(model) for model in models], sort_keys=True)

    def of(self, task: Task) -> Trial | None:
        """The trial that the task would come to; None if it is not known."""
        text = self._known.load(type(task).__module__, self.key(task))
        if text is None:
            return None
        try:
            return read_answer(text.encode(), task.claim)
        except BadAnswer:
            return None

    def keep(self, task: Task, trial: Trial) -> None:
        """Remember the trial, unless another time or another machine may come to another."""
        if trial.accident is None and not trial.timed:
            text = answer_bytes(trial).decode()
            self._known.store(type(task).__module__, self.key(task), text)

    def key(self, task: Task) -> str:
        """A digest of all of a task and of the models."""
        parts = (self._about, self._digests.of(task))
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()


class Digests:
    """Digests of plain content: alike in all processes, different for whatever differs. Those of
    records are remembered, since tasks share settings and claims.
    """

    def __init__(self) -> None:
        self._of: dict[int, tuple[object, str]] = {}

    def of(self, value: object) -> str:
        """Of a record, a number, a text, or a collection of such. Raises TypeError."""
        return hashlib.sha256(self._text(value).encode()).hexdigest()

    def _text(self, value: object) -> str:
        if is_dataclass(value) and not isinstance(value, type):
            # the record itself is kept too, or another one could get its place in memory
            if id(value) not in self._of:
                self._of[id(value)] = (value, self._of_record(value))
            return self._of[id(value)][1]
        match value:
            case None | bool() | int() | float() | str() | Fraction():
                return f"{type(value).__name__} {value!r}"
            case Mapping():
                entries = [f"{self._text(k)}: {self._text(v)}" for k, v in value.items()]
                return f"{{{', '.join(entries)}}}"
            case tuple() | list():
                return f"({', '.join(map(self._text, value))})"
            case set() | frozenset():
                return f"<{', '.join(sorted(map(self._text, value)))}>"
        raise TypeError(f"no digest of {type(value).__name__}")

    def _of_record(self, value: Any) -> str:
        kind = type(value)
        parts = [f"{kind.__module__}.{kind.__qualname__}"]
        parts += [
            f"{each.name} {self._text(getattr(value, each.name))}"
            for each in fields(value)
            if (kind, each.name) not in NOT_READ
        ]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()
