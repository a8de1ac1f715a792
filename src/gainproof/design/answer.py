"""The answer of `gainproof design`: options read, the sheet made, printed, drawn."""

from __future__ import annotations

import argparse
import json
import math
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.design import belonging
from gainproof.design.belonging import Belonging
from gainproof.design.page import page, plain
from gainproof.design.process_noise import (
    NOISES,
    page_of_filters,
    plain_filters,
    steady_filters,
)
from gainproof.design.sheet import Sheet, row_of, sheet
from gainproof.design.units import Units

MOTIONS = {2: "acceleration", 3: "jerk"}


def answered(options: argparse.Namespace) -> int:
    """Status 0, or 1 where none of the named filters exists. Raises BadInputError."""
    noise = next((name for name in NOISES if getattr(options, name) is not None), None)
    if noise is not None:
        return _answered_by_noise(options, noise)
    states = _states(options)
    units = _units(options, states)
    made, belongs = _made(options, states)
    told = plain(made, units, belongs)  # before a file is written: units may be refused
    drawn: dict[str, Any] = {}
    if options.plot:
        from gainproof.design.drawing import write_plot

        drawn["files"] = write_plot(made, options.plot)
    if options.json:
        print(json.dumps({**told, **drawn}, indent=1))
    else:
        print(page(made, units, belongs))
        for name in drawn.get("files", ()):
            print(name)
    return 0 if made.found else 1


def _answered_by_noise(options: argparse.Namespace, noise: str) -> int:
    """Status 0: the steady-state filters of a process noise. Raises BadInputError."""
    option = f"--{noise.replace('_', '-')}"
    missing = [name for name in ("interval", "deviation") if getattr(options, name) is None]
    if missing:
        raise BadInputError(f"{option} takes --{' and --'.join(missing)} beside it")
    if options.plot is not None:
        raise BadInputError(
            f"--plot belongs to the named filters, not to {option}; without --plot the tracking "
            "index is told, which --tracking-index takes"
        )
    interval, deviation, value = (
        _positive(f"--{name.replace('_', '-')}", getattr(options, name))
        for name in ("interval", "deviation", noise)
    )
    states = None if options.states is None else int(options.states)
    found = steady_filters(interval, deviation, noise, value, states)
    motion = _units(options, len(found[0].gain)).motion
    if options.json:
        print(json.dumps(plain_filters(found, interval, deviation, noise, value), indent=1))
    else:
        print(page_of_filters(found, interval, deviation, noise, value, motion))
    return 0


def _states(options: argparse.Namespace) -> int:
    if options.gains is None:
        return int(options.states or 2)
    count = len(options.gains)
    if count not in (2, 3):
        raise BadInputError(f"--gains takes alpha and beta, or alpha, beta and gamma, got {count}")
    if options.states is not None and int(options.states) != count:
        raise BadInputError(f"--states {options.states} has as many gains, got {count}")
    return count


def _made(options: argparse.Namespace, states: int) -> tuple[Sheet, tuple[Belonging, ...]]:
    for name, kind in (("lag", "lag"), ("tracking_index", "tracking index"), ("alpha", "alpha")):
        text = getattr(options, name)
        if text is not None:
            value = _positive(f"--{name.replace('_', '-')}", text)
            return sheet(states, kind, value), ()
    try:
        printed = tuple(belonging.printed(text) for text in options.gains)
        gains = tuple(each.value for each in printed)
        own = row_of("given", "gains given", gains)
        if not math.isfinite(own.lag):
            raise ValueError(f"the lag, one over {gains[-1]!s}, is beyond float64")
        beside = sheet(states, "lag", 1 / gains[-1])
        belongs = belonging.belonging(printed)
    except ValueError as error:
        raise BadInputError(f"--gains: {error}") from None
    return Sheet(states, "gains", gains, (own, *beside.rows)), belongs


def _units(options: argparse.Namespace, states: int) -> Units:
    other = MOTIONS[5 - states]
    if getattr(options, other) is not None:
        wanted = MOTIONS[states]
        raise BadInputError(
            f"--{other} belongs to {5 - states} states; lags of {states} states take --{wanted}"
        )
    names = ("interval", MOTIONS[states], "deviation")
    given = [getattr(options, name) for name in names]
    return Units(
        *(
            None if text is None else _positive(f"--{name}", text)
            for name, text in zip(names, given, strict=True)
        )
    )


def _positive(name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        raise BadInputError(f"{name} must be a number, got {text!r}") from None
    if not (math.isfinite(value) and value > 0):
        raise BadInputError(f"{name} must be above 0 and finite, got {text}")
    return value
