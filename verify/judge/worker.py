"""Claims judged in child processes that can be killed: a claim that hangs costs one claim.

Signals do not interrupt the arithmetic library, so a time limit needs a process of its own. A child
keeps the environments it solved and takes claim after claim; after a kill a new one is started.
Works with every start method, `spawn` included.
"""

from __future__ import annotations

import multiprocessing
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any

from gainproof.verify.judge.claim_record import Claim, Setting
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.trial import Trial, try_claim

MEMORY = 4 << 30
"""Bytes of address space that a child may take, where the system can limit it."""
START = 30.0
"""Seconds added for the first claim of a child, which has to be started first."""


@dataclass
class _Child:
    process: SpawnProcess
    pipe: Connection
    claim: Claim | None = None
    deadline: float = 0.0
    fresh: bool = True


def tried_apart(
    settings: Mapping[str, Setting],
    claims: Sequence[Claim],
    models: Sequence[Mapping[str, Any]],
    seconds: float,
    processes: int = 1,
) -> dict[str, Trial]:
    """Trials of all claims by id; one that takes longer, or whose child dies, has none but a
    reason.
    """
    waiting = list(reversed(claims))
    found: dict[str, Trial] = {}
    children: list[_Child] = []
    try:
        while waiting or any(child.claim for child in children):
            while waiting and len(children) < max(1, processes):
                children.append(_started(dict(settings), [dict(m) for m in models]))
            for child in children:
                if child.claim is None and waiting:
                    _give(child, waiting.pop(), seconds)
            _collect(children, found)
            for child in [c for c in children if c.claim and time.monotonic() > c.deadline]:
                _lost(child, found, f"stopped after {seconds:g} seconds")
                children.remove(child)
            children = [c for c in children if c.process.is_alive() or c.claim]
    finally:
        for child in children:
            _stop(child)
    return found


def _started(settings: dict[str, Setting], models: list[dict[str, Any]]) -> _Child:
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_serve, args=(theirs, settings, models), daemon=True)
    process.start()
    theirs.close()
    return _Child(process, ours)


def _give(child: _Child, claim: Claim, seconds: float) -> None:
    child.claim = claim
    child.deadline = time.monotonic() + seconds + (START if child.fresh else 0.0)
    child.fresh = False
    try:
        child.pipe.send(claim)
    except OSError:
        child.deadline = 0.0


def _collect(children: list[_Child], found: dict[str, Trial]) -> None:
    """Waits for answers until the next deadline, and takes those that came."""
    busy = [child for child in children if child.claim]
    left = min((child.deadline for child in busy), default=0.0) - time.monotonic()
    ready = wait([child.pipe for child in busy], timeout=max(0.0, left))
    for child in busy:
        if child.pipe not in ready or child.claim is None:
            continue
        try:
            found[child.claim.id] = child.pipe.recv()
            child.claim = None
        except (EOFError, OSError):
            _lost(child, found, "the process that judged it ended without an answer")
            child.claim = None


def _lost(child: _Child, found: dict[str, Trial], reason: str) -> None:
    if child.claim is not None:
        found[child.claim.id] = Trial(child.claim, {}, (), False, 0.0, reason)
    child.claim = None
    _stop(child)


def _stop(child: _Child) -> None:
    child.pipe.close()
    child.process.kill()
    child.process.join()


def _serve(
    pipe: Connection, settings: Mapping[str, Setting], models: Sequence[Mapping[str, Any]]
) -> None:
    """The child: a claim in, a trial out, until the pipe closes."""
    _limit_memory()
    solved: dict[Any, Environment] = {}
    while True:
        try:
            claim: Claim = pipe.recv()
        except (EOFError, OSError):
            return
        pipe.send(try_claim(claim, settings[claim.setting], models, solved))


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # not on this system
        return
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
