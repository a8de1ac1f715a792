"""A campaign over two Dask workers of which one is killed: nothing is lost."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from argparse import ArgumentParser
from pathlib import Path

import pytest
from small_campaign import campaign, carried_out, process_of

from gainproof.bad_input import BadInputError
from gainproof.campaign import executors
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options

NUMBERS, FATAL = range(14, 38), 20


@pytest.mark.thorough
def test_a_worker_is_killed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    distributed = pytest.importorskip("distributed")
    notes, file = tmp_path / "notes", tmp_path / "state"
    small = campaign(len(NUMBERS), notes, 0.1, NUMBERS.start)

    def kill() -> None:
        while (process := process_of(FATAL, notes)) is None:
            time.sleep(0.01)
        os.kill(process, signal.SIGKILL)

    settings = {"n_workers": 2, "threads_per_worker": 1, "dashboard_address": None}
    with distributed.LocalCluster(**settings) as cluster:
        killer = threading.Thread(target=kill)
        killer.start()
        parser = ArgumentParser()
        add_options(parser)
        words = ["--executor", cluster.scheduler_address, "--state", str(file)]
        assert carry_out(small, parser.parse_args(words)) == 1  # its sum is above 999
        killer.join()
    begun = carried_out(notes)
    count, total = len(NUMBERS), sum(number * number for number in NUMBERS)
    order = ",".join(map(str, NUMBERS))
    shown = capsys.readouterr().out
    assert f"sum {total} of {order}\nsquares: {count} of {count} blocks done" in shown
    assert len(file.read_text(encoding="utf-8").splitlines()) == count
    # what the killed worker was at is repeated, and what it had done and not yet handed over
    assert set(begun) == set(NUMBERS)
    assert begun.count(FATAL) == 2
    sys.stdout.write(f"{count} blocks done, lost 0, repeated {len(begun) - count}\n")


@pytest.mark.thorough
def test_no_scheduler_there() -> None:
    dask = pytest.importorskip("dask")
    with (
        dask.config.set({"distributed.comm.timeouts.connect": "1s"}),
        pytest.raises(BadInputError, match=r"no Dask scheduler answers at tcp://127\.0\.0\.1:1"),
        executors.opened("tcp://127.0.0.1:1"),
    ):
        pass


@pytest.mark.parametrize(
    ("address", "message"),
    [
        ("foo://host:1", "foo://host:1: Dask knows no scheme 'foo', but .*tcp"),
        ("://host:1", "Dask knows no scheme ''"),
        ("tcp://", "wanted is tcp://HOST:PORT; missing port number"),
        ("tcp://host", "wanted is tcp://HOST:PORT; missing port number"),
        ("tcp://host:port", "wanted is tcp://HOST:PORT; invalid literal"),
        ("tcp://host:99999", "got host 'host' and port 99999"),
        ("tcp://:8786", "got host '' and port 8786"),
        ("inproc://here", "wanted is inproc://HOST:PORT; don't know"),
    ],
)
def test_an_address_that_is_none_is_refused_at_once(
    monkeypatch: pytest.MonkeyPatch, address: str, message: str
) -> None:
    distributed = pytest.importorskip("distributed")
    monkeypatch.setattr(distributed, "Client", None)  # which would wait for an answer
    with pytest.raises(BadInputError, match=message), executors.opened(address):
        pass


def test_without_dask(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with (
        pytest.raises(BadInputError, match="pip install 'gainproof\\[dask\\]'"),
        executors.opened("tcp://127.0.0.1:1"),
    ):
        pass
