"""What the commands work with: the cache, where progress goes, and what is known already."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.jobs import code_digest, workers
from gainproof.jobs.cache import Cache, default_folder, key_of
from gainproof.jobs.progress import Progress
from gainproof.jobs.tasks import code_of, is_as_read

Then = Callable[[workers.Job], Sequence[workers.Job]]


@dataclass(frozen=True)
class Session:
    """Runs jobs in worker processes, or takes what they would answer from the cache.

    An answer is known if the job is the same, the code that it runs (`code`: a digest of it, by
    task and arguments), and the versions. What was done while the code was edited is not kept.
    """

    cache: Cache
    progress: Progress
    code: Callable[[str, Mapping[str, Any]], str] = code_of
    is_as_read: Callable[[str, Mapping[str, Any]], bool] = is_as_read
    known: dict[str, Any] = field(default_factory=dict)
    """Answers by key, of this session's life."""
    taken: dict[str, str] = field(default_factory=dict)
    """Tasks by key of what came from the cache."""
    done: dict[str, str] = field(default_factory=dict)
    """Tasks by key of what was worked for."""

    def results(
        self, work: str, jobs: Sequence[workers.Job], *, at_once: int | None = None
    ) -> list[Any]:
        """What the jobs answer, in their order; `work` is for people, and nothing is said without.
        So many run `at_once`, or one for each processor.

        Raises BadInputError or JobError of the first job that fails.
        """
        keys = [self._key(job) for job in jobs]
        found = [self._answer(job, key) for job, key in zip(jobs, keys, strict=True)]
        missing = [i for i, result in enumerate(found) if result is None]

        def done(job: workers.Job, seconds: float) -> None:
            if work:
                self.progress.say(f"{work} {job.label} ({seconds:.1f} s)")

        def told(job: workers.Job, text: str) -> None:
            if work:
                self.progress.say_sometimes(f"{job.label}: {text}")

        if missing:
            chosen = [jobs[i] for i in missing]
            fresh = workers.run(chosen, on_done=done, on_progress=told, limit=at_once)
            for i, result in zip(missing, fresh, strict=True):
                found[i] = result
                self._keep(jobs[i], keys[i], result)
            self.cache.drop_old()
        same = sum(key in self.taken for key in keys)
        if work and same:
            self.progress.say(f"{work}: {same} unchanged")
        return found

    def answered(self, job: workers.Job) -> Any | None:
        """What the job answers, if that is known; None if it would have to be done."""
        return self._answer(job, self._key(job))

    def was_done(self, job: workers.Job) -> bool:
        """Whether the job was worked for, and its answer not taken from the cache."""
        return self._key(job) in self.done

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
                if self.answered(part) is None:  # of several answers some may be known
                    self._keep(part, self._key(part), one)
            return [other for further in then(job) for other in missing(further)]

        def said(job: workers.Job, seconds: float) -> None:
            if job.task in words:
                self.progress.say(f"{words[job.task]} {job.label} ({seconds:.1f} s)")

        def told(job: workers.Job, text: str) -> None:
            self.progress.say_sometimes(f"{job.label}: {text}")

        first = [other for job in jobs for other in missing(job)]
        workers.run(first, on_done=said, on_progress=told, on_result=found)
        if first:
            self.cache.drop_old()

    def _key(self, job: workers.Job) -> str:
        versions = json.dumps(code_digest.versions())
        return key_of(job.task, self.code(job.task, job.arguments), versions, job.text)

    def _answer(self, job: workers.Job, key: str) -> Any | None:
        """What is known under the key of the job."""
        if key in self.known or not job.kept:
            return self.known.get(key)
        found = self.cache.load(key)
        if found is not None:
            self.known[key] = found
            self.taken[key] = job.task
        return found

    def _keep(self, job: workers.Job, key: str, result: Any) -> None:
        self.known[key] = result
        if job.kept and self.is_as_read(job.task, job.arguments):
            self.cache.store(key, result)
        self.done[key] = job.task


def open_session(
    *, fresh: bool = False, quiet: bool = False, only_terminal: bool = False
) -> Session:
    """The session of this user. `fresh`: nothing is taken from the cache. Progress is not shown if
    `quiet`, and with `only_terminal` not unless somebody can be looking on.
    """
    quiet = quiet or (only_terminal and not sys.stderr.isatty())
    return Session(Cache(default_folder(), fresh), Progress(quiet))
