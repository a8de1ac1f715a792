"""Executors by name: processes of this machine, threads, or the workers of a Dask cluster."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from multiprocessing import get_context, parent_process
from types import FrameType

from gainproof.bad_input import BadInputError
from gainproof.campaign.options import EXECUTORS
from gainproof.jobs import interrupts
from gainproof.jobs.workers import processors


@contextmanager
def opened(name: str, jobs: int | None = None) -> Iterator[Executor]:
    """The executor of a name, shut down at the end; `jobs` processes or threads of this machine,
    one for each processor if it is not given.

    Raises BadInputError for a name that is none, a cluster that does not answer, and where Dask is
    not installed.
    """
    if name == "processes":
        # new interpreters: what is forked may hold locks of other threads
        with ProcessPoolExecutor(
            jobs or processors(), mp_context=get_context("spawn"), initializer=_begin
        ) as pool:
            yield pool
    elif name == "threads":
        with ThreadPoolExecutor(jobs or processors()) as pool:
            yield pool
    elif "://" in name:
        with _cluster(name) as executor:
            yield executor
    else:
        raise BadInputError(f"no executor is called {name!r}; wanted: {EXECUTORS}")


def _begin() -> None:
    """What is to end all processes of a terminal or a job reaches each: the first alone decides,
    and the others end with it, however it ends.
    """
    for number in interrupts.numbers():
        # not SIG_IGN, which processes that a block starts would inherit
        signal.signal(number, _pass)
    interrupts.release()
    threading.Thread(target=_end_with_the_first, daemon=True).start()


def _pass(_number: int, _frame: FrameType | None) -> None:
    """Nothing."""


def _end_with_the_first() -> None:
    first = parent_process()
    if first is not None:
        first.join()
        os._exit(1)


@contextmanager
def _cluster(address: str) -> Iterator[Executor]:
    try:
        distributed = import_module("distributed")
    except ImportError:
        raise BadInputError(
            "an address needs Dask, which is not installed: pip install 'gainproof[dask]'"
        ) from None
    _refuse_bad(address)
    try:
        client = distributed.Client(address, set_as_default=False)
    except (OSError, ValueError) as error:
        raise BadInputError(f"no Dask scheduler answers at {address}: {error}") from None
    with client:
        # every block is carried out anew: what a scheduler still holds may be of other code
        yield client.get_executor(pure=False)


def _refuse_bad(address: str) -> None:
    """A client finds such errors in its thread, and waits a minute for it."""
    scheme = address.partition("://")[0]
    registry = import_module("distributed.comm.registry")
    addressing = import_module("distributed.comm.addressing")
    try:
        registry.get_backend(scheme)
    except ValueError:
        known = ", ".join(sorted(registry.backends))
        raise BadInputError(f"{address}: Dask knows no scheme {scheme!r}, but {known}") from None
    try:
        host, port = addressing.get_address_host_port(address, strict=True)
    except ValueError as error:
        raise BadInputError(f"{address}: wanted is {scheme}://HOST:PORT; {error}") from None
    if not host or not 0 < port < 1 << 16:
        raise BadInputError(
            f"{address}: wanted is {scheme}://HOST:PORT, got host {host!r} and port {port}"
        )
