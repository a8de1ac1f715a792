"""The answer of `gainproof locate`: options read, files read, the estimate told and drawn."""

from __future__ import annotations

import argparse
import json
import math
import sys
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.files import named_files, places
from gainproof.location.doppler import carrier_of
from gainproof.location.errors import LocationError
from gainproof.location.estimate import DEFAULT, FALSE_ALARM, locate
from gainproof.location.example import FILES, write_example
from gainproof.location.files import read_files
from gainproof.location.methods import CHOSEN, method_of
from gainproof.location.page import page, plain, plain_failure
from gainproof.location.result import Location
from gainproof.location.stations import MOST, Stations
from gainproof.tables.cell_text import decimal


def answered(options: argparse.Namespace) -> int:
    """Status 0, or 1 where there is no estimate. Raises BadInputError."""
    for name in ("observations", "stations", "covariance", "plot", "example"):
        if "\0" in (getattr(options, name) or ""):
            raise BadInputError(f"{name} is the name of a file, got {getattr(options, name)!r}")
    if options.example is not None:
        return _example(options)
    if options.observations is None or options.stations is None:
        raise BadInputError(
            "wanted: two files, observations and stations; `gainproof locate --example DIR` writes "
            "such files"
        )
    method = method_of(options.method or DEFAULT)
    false_alarm = _false_alarm(options)
    if options.plot:
        _require_ending(options.plot)
        inputs = {
            "OBSERVATIONS": options.observations,
            "STATIONS": options.stations,
            "--covariance": options.covariance,
        }
        named_files.require_apart(inputs, {"--plot": options.plot})
    given, observed = read_files(
        Path(options.observations),
        Path(options.stations),
        None if options.covariance is None else Path(options.covariance),
        None if options.carrier is None else carrier_of(options.carrier),
    )
    near = None if options.near is None else _near(options.near, given.dimension)
    try:
        found = locate(given, observed, method.name, false_alarm=false_alarm, near=near)
    except LocationError as error:
        print(f"gainproof: no estimate: {error}", file=sys.stderr)
        if options.json:
            print(json.dumps(plain_failure(error), indent=1, allow_nan=False))
        return 1
    contents = _drawn(options.plot, found, given)
    files = [places.shown(path) for path in contents]
    if options.json:
        data = {**plain(found), **({"files": files} if files else {})}
        text = json.dumps(data, indent=1, allow_nan=False)
    else:
        text = "\n".join([page(found), *files])
    named_files.write(contents)
    print(text)
    return 0


def _example(options: argparse.Namespace) -> int:
    if options.observations is not None or options.json or options.plot:
        raise BadInputError("--example writes files and locates nothing: it takes DIR alone")
    for path in write_example(Path(options.example)):
        print(places.shown(path))
    shown = " ".join(places.shown(Path(options.example) / name) for name in FILES)
    print(f"gainproof locate {shown}")
    return 0


def _false_alarm(options: argparse.Namespace) -> float:
    if options.false_alarm is None:
        return FALSE_ALARM
    if method_of(options.method or DEFAULT).bias != CHOSEN:
        raise BadInputError(f"--false-alarm belongs to {DEFAULT}, not to {options.method}")
    value = _number("--false-alarm", options.false_alarm)
    if not 1e-300 <= value < 1:
        raise BadInputError(f"--false-alarm is between 0 and 1, got {options.false_alarm}")
    return value


def _near(text: str, dimension: int) -> list[float]:
    found = [_number("--near", part) for part in text.split(",")]
    if len(found) != dimension:
        raise BadInputError(f"--near takes {dimension} numbers in m, with commas, got {text!r}")
    if not max(map(abs, found)) <= MOST:
        raise BadInputError(f"--near takes numbers up to {MOST:g} m, got {text!r}")
    return found


def _number(name: str, text: str) -> float:
    try:
        value = decimal(text)
    except ValueError:
        raise BadInputError(f"{name} takes numbers, got {text!r}") from None
    if not math.isfinite(value):
        raise BadInputError(f"{name} takes finite numbers, got {text!r}")
    return value


def _require_ending(name: str) -> None:
    from gainproof.location.drawing import ENDINGS

    if Path(name).suffix.lower() not in ENDINGS:
        raise BadInputError(f"--plot takes a name that ends in .svg or .png, got {name!r}")


def _drawn(name: str | None, found: Location, given: Stations) -> dict[Path, bytes]:
    if not name:
        return {}
    from gainproof.location.drawing import plotted

    return {Path(name): plotted(found, given, Path(name))}
