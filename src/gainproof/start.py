"""The first that runs: from here on an interrupt is one line and status 130, at any moment.

Little is imported before the signals are handled: an interrupt comes out of any import as a page of
Python. What has been loaded before, or is built in, takes no time.
"""

from __future__ import annotations

import os
import sys

INTERRUPTED = 130


def _say(words: str) -> None:
    """At once and whole, whatever Python's own streams are doing."""
    try:  # noqa: SIM105 - contextlib is not loaded yet
        os.write(2, f"gainproof: {words}\n".encode())
    except OSError:  # closed: the status says it
        pass


try:
    import signal

    from gainproof.ending_signals import SIGNALS
except KeyboardInterrupt:
    _say("interrupted")
    os._exit(INTERRUPTED)

TYPE_CHECKING = False
if TYPE_CHECKING:
    import threading
    from collections.abc import Callable
    from types import FrameType
    from typing import NoReturn

AGAIN = 0.01  # seconds


def main() -> int:
    """Run the command of sys.argv and return its exit status."""
    heard = _Heard()
    heard.then(heard.leave)
    import atexit

    # registered first it comes last
    atexit.register(heard.done)
    try:
        import threading

        from gainproof import cli

        threading.excepthook = _thread_ended
        sys.unraisablehook = _unraisable
        heard.then(heard.interrupt)
        status = cli.main(asked=lambda: heard.asked)
        # nothing is left to do but to take down the interpreter
        heard.then(heard.leave)
    except KeyboardInterrupt:
        heard.then(heard.leave)
        status = 0
    except Exception as error:
        from gainproof.jobs.resource_limits import lack

        if (lacks := lack(error)) is None:
            raise
        _say(lacks)
        return 2
    if heard.asked and status != INTERRUPTED:
        _say("interrupted")
        return INTERRUPTED
    return status


class _Heard:
    """What signals do. Ignored ones stay so, as in a background job and below nohup."""

    def __init__(self) -> None:
        numbers = [getattr(signal, name) for name in SIGNALS if hasattr(signal, name)]
        self._numbers = [each for each in numbers if signal.getsignal(each) != signal.SIG_IGN]
        self.asked = False

    def then(self, handler: Callable[[int, FrameType | None], NoReturn]) -> None:
        """From now on."""
        for number in self._numbers:
            signal.signal(number, handler)

    def done(self) -> None:
        """Nothing is left that could be broken off, and Python forgets its handlers now: those of
        ignored signals it leaves, in every thread.
        """
        for number in self._numbers:
            signal.signal(number, signal.SIG_IGN)

    def leave(self, _number: int, _frame: FrameType | None) -> NoReturn:
        """At once: nothing has been begun yet, or all is done."""
        if not self.asked:
            _say("interrupted")
        os._exit(INTERRUPTED)

    def interrupt(self, _number: int, _frame: FrameType | None) -> NoReturn:
        """For whoever has something to end; not told if it gets lost on its way."""
        self.asked = True
        raise KeyboardInterrupt


def _interrupt_main() -> None:
    import threading

    number = threading.main_thread().ident
    if number is not None and hasattr(signal, "pthread_kill"):
        signal.pthread_kill(number, signal.SIGINT)


def _thread_ended(what: threading.ExceptHookArgs) -> None:
    """A thread that ends for lack of something is one that somebody waits for: of an executor."""
    import threading

    from gainproof.jobs.resource_limits import lack

    if what.exc_value is not None and (lacks := lack(what.exc_value)):
        _say(lacks)
        os._exit(2)
    threading.__excepthook__(what)


def _unraisable(what: sys.UnraisableHookArgs) -> None:
    """An interrupt that came where Python cannot raise it, as in a callback, comes again."""
    if isinstance(what.exc_value, KeyboardInterrupt):
        import threading

        # not at once: here it would be lost too
        threading.Timer(AGAIN, _interrupt_main).start()
    else:
        sys.__unraisablehook__(what)
