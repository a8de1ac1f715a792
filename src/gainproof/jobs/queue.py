"""Jobs that wait for somebody who does them, and jobs that follow from what is done."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Generic, TypeVar

Item = TypeVar("Item")


class JobQueue(Generic[Item]):
    """A queue that ends when nothing waits and nothing is being done, from which more could follow.

    Items have numbers in the order in which they came; `found` has what each of them came to.
    """

    def __init__(self, items: Iterable[Item]) -> None:
        self.found: dict[int, Any] = {}
        self._waiting = deque(enumerate(items))
        self._came = len(self._waiting)
        self._busy = 0
        self._changed = asyncio.Condition()

    async def following(
        self, suits: Callable[[Item], bool] = lambda _: True
    ) -> tuple[int, Item] | None:
        """The first that suits, or the first if none does, and its number, which has to be `done`
        some time; None if all are.
        """
        async with self._changed:
            await self._changed.wait_for(lambda: self._waiting or not self._busy)
            if not self._waiting:
                return None
            self._busy += 1
            chosen = next((each for each in self._waiting if suits(each[1])), self._waiting[0])
            self._waiting.remove(chosen)
            return chosen

    async def done(self, number: int, result: Any, further: Sequence[Item] = ()) -> None:
        """What an item came to, and what follows from it: before all that waits."""
        async with self._changed:
            self.found[number] = result
            self._busy -= 1
            self._waiting.extendleft(reversed(list(enumerate(further, self._came))))
            self._came += len(further)
            self._changed.notify_all()
