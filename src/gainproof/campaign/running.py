"""A campaign over an executor, block by block as they come."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from concurrent.futures import Executor, as_completed
from typing import Any

from gainproof.campaign.campaign import Arguments, Campaign, Done
from gainproof.jobs import interrupts


def run(
    campaign: Campaign,
    executor: Executor,
    numbers: Sequence[int],
    on_done: Callable[[int, Done], None],
) -> None:
    """The blocks of these numbers; `on_done` hears of each in this thread as it ends.

    The first error ends the campaign, an interrupt too: what no process has begun is not begun any
    more. Raises what `work` or the executor raises, with the block it was about.
    """
    with interrupts.held():
        blocks = {
            executor.submit(_timed, campaign.work, campaign.blocks[number]): number
            for number in numbers
        }
    number = -1
    try:
        for future in as_completed(blocks):
            number = blocks[future]
            result, seconds = future.result()
            on_done(number, Done(campaign.blocks[number], result, seconds))
    except Exception as error:
        error.add_note(f"in block {number} of {campaign.name}: {campaign.blocks[number]}")
        raise
    finally:
        for future in blocks:
            future.cancel()


def _timed(work: Callable[..., Any], arguments: Arguments) -> tuple[Any, float]:
    """A block where it is carried out, and its seconds of the processor."""
    start = time.thread_time()
    return work(*arguments), time.thread_time() - start
