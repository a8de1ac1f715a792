"""What the commands work with: the cache, where progress goes, and the digest of our code."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof import code_digest, workers
from gainproof.cache import Cache, default_folder, key_of
from gainproof.progress import Progress

Then = Callable[[workers.Job], Sequence[workers.Job]]


@dataclass(frozen=True)
class Workshop:
    """Runs jobs in worker processes, or takes what they would answer from the cache."""

    cache: Cache
    progress: Progress
    code: str
    known: dict[str, Any] = field(default_factory=dict)
    """Answers of `ahead`, by key."""

    def results(
        self, work: str, jobs: Sequence[workers.Job], *depends: bytes, at_once: int | None = None
    ) -> list[Any]:
        """What the jobs answer, in their order; `work` is for people, and nothing is said without.
        So many run `at_once`, or one for each processor.

        A result is known if the job, all code and versions, and whatever else it `depends` on are
        the same. Raises BadInputError or JobError of the first job that fails.
        """
        keys = [self._key(job, *depends) for job in jobs]
        found = [self._found(job, key) for job, key in zip(jobs, keys, strict=True)]
        unchanged = sum(
            result is not None and key not in self.known
            for key, result in zip(keys, found, strict=True)
        )
        missing = [i for i, result in enumerate(found) if result is None]

        def done(job: workers.Job, seconds: float) -> None:
            if work:
                self.progress.say(f"{work} {job.label} ({seconds:.1f} s)")

        def told(job: workers.Job, text: str) -> None:
            if work:
                self.progress.say_sometimes(f"{job.label}: {text}")

        if missing:
            chosen = [jobs[i] for i in missing]
            fresh = workers.run(chosen, on_done=done, on_told=told, limit=at_once)
            for i, result in zip(missing, fresh, strict=True):
                found[i] = result
                if jobs[i].kept:
                    self.cache.store(keys[i], result)
            self.cache.drop_old()
        if work and unchanged:
            self.progress.say(f"{work}: {unchanged} unchanged")
        return found

    def answered(self, job: workers.Job) -> Any | None:
        """What the job answers, if that is known; None if it would have to be done."""
        return self._found(job, self._key(job))

    def ahead(
        self, jobs: Sequence[workers.Job], then: Then, done: Mapping[str, str] | None = None
    ) -> None:
        """Have jobs done that will be asked for, and those that `then` says can be done once a job
        is known, as many at once as there are processors. `done` has the words for people by task;
        nothing is said of other tasks.

        Raises BadInputError or JobError of the first job that fails.
        """
        words = done or {}

        def missing(job: workers.Job) -> list[workers.Job]:
            if any(self.answered(part) is None for part in job.answers or (job,)):
                return [job]
            return [other for further in then(job) for other in missing(further)]

        def found(job: workers.Job, result: Any) -> list[workers.Job]:
            results = zip(job.answers, result, strict=True) if job.answers else [(job, result)]
            for part, one in results:
                key = self._key(part)
                self.known[key] = one
                if part.kept:
                    self.cache.store(key, one)
            return [other for further in then(job) for other in missing(further)]

        def said(job: workers.Job, seconds: float) -> None:
            if job.task in words:
                self.progress.say(f"{words[job.task]} {job.label} ({seconds:.1f} s)")

        def told(job: workers.Job, text: str) -> None:
            self.progress.say_sometimes(f"{job.label}: {text}")

        first = [other for job in jobs for other in missing(job)]
        workers.run(first, on_done=said, on_told=told, on_result=found)
        if first:
            self.cache.drop_old()

    def _found(self, job: workers.Job, key: str) -> Any | None:
        if key in self.known or not job.kept:
            return self.known.get(key)
        return self.cache.load(key)

    def _key(self, job: workers.Job, *depends: bytes) -> str:
        return key_of(job.task, self.code, job.text, *depends)


def open_workshop(
    *, fresh: bool = False, quiet: bool = False, only_terminal: bool = False
) -> Workshop:
    """The workshop of this user. `fresh`: nothing is taken from the cache. Progress is not shown if
    `quiet`, and with `only_terminal` not unless somebody can be looking on.
    """
    quiet = quiet or (only_terminal and not sys.stderr.isatty())
    return Workshop(Cache(default_folder(), fresh), Progress(quiet), code_digest.of_everything())
