"""The table of `gainproof bench` in a terminal, at most 98 columns wide."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from gainproof.bench.columns import ERRORS, RATIOS, Row, explained, ratio_text, worst_output
from gainproof.bench.results import Results

WIDTH = 98
CELL = 6
ERROR = 7
SHOWN = tuple(column for column in RATIOS if column.short is not None)
NAME = WIDTH - CELL * len(SHOWN) - ERROR * len(ERRORS)


def opening(results: Results) -> Iterator[str]:
    """What is measured how, what the columns are, and their headings."""
    found = results.conditions
    settings = found["settings"]
    facts = found["machine"]
    yield from _filled(f"C: {facts['C']}" if "C" in facts else "no C compiler: ratios to C missing")
    speeds = ", ".join(f"{name} {value:.1f}" for name, value in results.bandwidth.items())
    yield from _filled(
        f"memory of one thread, GB/s: {speeds}; processes that want to run: {results.load}"
    )
    yield from _filled(
        f"{found['points']:,} points, outputs given but in `fresh`, guards in the kernel and the C "
        f"function, {settings['workers']} threads (t/Cg); each the best of up to "
        f"{found['rounds']} runs in turn, of fewer where they take more than "
        f"{found['seconds a call']:g} s; processor time of the thread, "
        "of the threads the time that passes"
    )
    yield ""
    for short, meaning in explained():
        yield from textwrap.wrap(f"{short:<7} {meaning}", WIDTH, subsequent_indent=" " * 8)
    yield ""
    headings = [f"{column.short:>{CELL}}" for column in SHOWN]
    headings += [f"{short:>{ERROR}}" for _, short, _ in ERRORS]
    yield f"{'kernel':<{NAME}}" + "".join(headings)


def line(row: Row) -> str:
    """One kernel; a long name stands in a line of its own."""
    worst = worst_output(row)
    cells = [f"{ratio_text(column.value(row)):>{CELL}}" for column in SHOWN]
    cells += [f"{float(worst[key]):{ERROR}.2f}" for key, *_ in ERRORS]
    name = f" {row['kernel']}"
    if len(name) >= NAME:
        name = f"{name}\n{'':<{NAME}}"
    mark = "  <-- OUTSIDE ITS BOUND" if worst["outside"] else ""
    return f"{name:<{NAME}}" + "".join(cells) + mark


def alarm(results: Results) -> str:
    """What to say where a kernel does not keep its bound; empty where all do."""
    if not results.outside:
        return ""
    named = "".join(f"\n  {kernel}: {output}" for kernel, output in results.outside)
    return (
        f"OUTSIDE THE PROVED BOUND (a fault of the kernel, its bound or this measurement):{named}"
    )


def _filled(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, break_on_hyphens=False, break_long_words=False)
