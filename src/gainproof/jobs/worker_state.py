"""What a worker process keeps from one job to the next, and how it reports progress."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from contextlib import AbstractContextManager, ExitStack
from types import TracebackType
from typing import Any, TypeVar

Made = TypeVar("Made")


class WorkerState:
    """For the jobs of one process, one after the other. To be used in a `with`, at whose end
    everything closes that was opened.

    What is kept depends on its key alone: a job that finds something kept answers what it would
    answer anyway.
    """

    def __init__(self, report: Callable[[str], None] = lambda _: None) -> None:
        self.report = report
        self._kept: dict[Hashable, Any] = {}
        self._open = ExitStack()

    def __enter__(self) -> WorkerState:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._open.__exit__(kind, error, trace)

    def kept(self, key: Hashable, make: Callable[[], Made]) -> Made:
        """What was made under this key, or is made now."""
        if key not in self._kept:
            self._kept[key] = make()
        found: Made = self._kept[key]
        return found

    def opened(self, key: Hashable, make: Callable[[], AbstractContextManager[Made]]) -> Made:
        """The same for what has to be closed in the end."""
        return self.kept(key, lambda: self._open.enter_context(make()))
