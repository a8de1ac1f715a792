"""What the system does not give: memory, open files, processes; in words for people."""

from __future__ import annotations

from collections.abc import Iterator

MEMORY = "there is not enough memory for this (a limit as of `ulimit -v`?)"
FILES = "too many files are open for this (a limit as of `ulimit -n`?)"
PROCESSES = "the system starts no more processes or threads (a limit as of `ulimit -u` or `-v`?)"
SIGNS = {
    "MemoryError": MEMORY,
    "failed to map segment": MEMORY,
    "annot allocate memory": MEMORY,
    # compiled modules say no more where their first objects find no room
    "error return without exception set": MEMORY,
    "Too many open files": FILES,
    "the process ended with status -9": "the process was killed, as systems do for lack of memory",
    "Resource temporarily unavailable": PROCESSES,
    "can't start new thread": PROCESSES,
}
"""By what errors of Python and of compiled modules say."""


def lack(error: BaseException) -> str | None:
    """What an error comes from, if from a lack; the errors behind it count too."""
    for each in _chain(error):
        found = lack_in(f"{type(each).__name__}: {each}")
        if found is not None:
            return found
    return None


def lack_in(text: str) -> str | None:
    """The same of the last words of a process."""
    return next((words for sign, words in SIGNS.items() if sign in text), None)


def _chain(error: BaseException | None) -> Iterator[BaseException]:
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        yield error
        error = error.__cause__ or error.__context__
