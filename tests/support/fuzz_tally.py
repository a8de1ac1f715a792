"""What came of many random inputs, the worst time and memory of one among them."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from gainproof.verify.judge.claim.file import ClaimFileError
from gainproof.verify.judge.reader.errors import ReaderError

Symbols = Mapping[str, Any]


class Refused(Exception):
    """The reader's own error, which `check_input` has looked at."""


@dataclass
class Tally:
    """What came of many inputs. `crashes` are texts with what came out of the reader besides its
    own error.
    """

    inputs: int = 0
    read: int = 0
    crashes: list[tuple[str, str]] = field(default_factory=list)
    seconds: float = 0.0
    slowest: str = ""
    kilobytes: int = 0
    largest: str = ""

    def joined(self, other: Tally) -> Tally:
        """Both together, the worst of each."""
        slow = max(self, other, key=lambda tally: tally.seconds)
        large = max(self, other, key=lambda tally: tally.kilobytes)
        return Tally(
            self.inputs + other.inputs,
            self.read + other.read,
            [*self.crashes, *other.crashes],
            slow.seconds,
            slow.slowest,
            large.kilobytes,
            large.largest,
        )


def tallied(
    count: int,
    make: Callable[[], tuple[str, Symbols]],
    attempt: Callable[[str, Symbols], object],
) -> Tally:
    """What came of `count` inputs of `make`, given to `attempt`."""
    tally = Tally()
    before = _peak()
    for _ in range(count):
        text, symbols = make()
        start = time.perf_counter()
        try:
            attempt(text, symbols)
            tally.read += 1
        except Refused:
            pass
        except (ReaderError, ClaimFileError) as error:
            # the message has to be sayable: a lone surrogate cannot be written
            if any(0xD800 <= ord(character) < 0xE000 for character in str(error)):
                tally.crashes.append((text, "a message that cannot be written"))
        except Exception as error:  # noqa: BLE001 - that is what is looked for
            tally.crashes.append((text, f"{type(error).__name__}: {error}"))
        spent = time.perf_counter() - start
        after = _peak()
        tally.inputs += 1
        if spent > tally.seconds:
            tally.seconds, tally.slowest = spent, text
        if after - before > tally.kilobytes:
            tally.kilobytes, tally.largest = after - before, text
        before = after
    return tally


def _peak() -> int:
    """The most memory that this process ever had, in kilobytes; 0 where that is not known."""
    if sys.platform == "win32":
        return 0
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
