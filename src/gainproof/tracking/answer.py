"""The answer of `gainproof track`: options read, the file read, tracks told, written, drawn."""

from __future__ import annotations

import argparse
import json
import math
import re
from collections.abc import Callable
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.files import named_files, places
from gainproof.jobs.progress import Progress
from gainproof.plots import canvas
from gainproof.tables.cell_text import decimal
from gainproof.tracking.association import require_scipy
from gainproof.tracking.conversion import NoCovarianceError
from gainproof.tracking.example import FILE, write_example
from gainproof.tracking.files import FromFile, read_file
from gainproof.tracking.page import csv_text, page, plain
from gainproof.tracking.scans import LIMITS, Scans, wanted
from gainproof.tracking.settings import Settings
from gainproof.tracking.summary import courses
from gainproof.tracking.tracker import Followed, followed
from gainproof.tracking.tracks import Tracks

NUMBERS = {
    "acceleration": "acceleration",
    "gate": "gate",
    "max_speed": "most_speed",
    "nominal_range": "nominal_range",
}
ENDINGS = (".svg", ".png")
if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SIZE = (6.4, 6.0)
COLOURS = ("#1f4e79", "#b5482a", "#3d7a3d", "#6d4b8d", "#8a6d1f", "#2b7f86")
MOST_NAMED = 60
"""Numbers of more tracks would hide them."""


def answered(options: argparse.Namespace) -> int:
    """Status 0, or 1 where there is no track. Raises BadInputError."""
    for name in ("detections", "out", "plot", "example"):
        if "\0" in (getattr(options, name) or ""):
            raise BadInputError(f"{name} is the name of a file, got {getattr(options, name)!r}")
    if options.example is not None:
        return _example(options)
    if options.detections is None:
        raise BadInputError(
            "wanted: a file of detections; `gainproof track --example DIR` writes such a file"
        )
    if options.plot and Path(options.plot).suffix.lower() not in ENDINGS:
        raise BadInputError(f"--plot takes a name that ends in .svg or .png, got {options.plot!r}")
    named_files.require_apart(
        {"DETECTIONS": options.detections}, {"--out": options.out, "--plot": options.plot}
    )
    settings = _settings(options)
    require_scipy()
    sigmas = _sigma(options, "sigma_range"), _sigma(options, "sigma_bearing")
    given = read_file(Path(options.detections), sigmas)
    try:
        found = followed(given.scans, settings, _progress(len(given.scans.times)))
    except NoCovarianceError as error:
        raise given.error(error) from None
    except ValueError as error:
        # outside the domain of a kernel: an index beyond 1e12, say
        raise BadInputError(f"{given.table.file}: {error}") from None
    told = courses(given.scans, found)
    contents = _contents(options, given, settings, found)
    files = [places.shown(path) for path in contents]
    if options.json:
        data = plain(given, settings, found, told)
        text = json.dumps(
            {**data, **({"files": files} if files else {})}, indent=1, allow_nan=False
        )
    else:
        text = "\n".join([page(given, settings, found, told), *files])
    named_files.write(contents)
    print(text)
    return 0 if told else 1


def _example(options: argparse.Namespace) -> int:
    if options.detections is not None or options.json or options.plot or options.out:
        raise BadInputError("--example writes a file and tracks nothing: it takes DIR alone")
    print(places.shown(write_example(Path(options.example))))
    print(f"gainproof track {places.shown(Path(options.example) / FILE)}")
    return 0


def _progress(scans: int) -> Callable[[float, Tracks], None]:
    """On standard error, where it takes long: how many scans are done."""
    progress, done = Progress(), count(1)

    def at(_time: float, tracks: Tracks) -> None:
        progress.say_sometimes(
            f"{next(done)} of {scans} scans, {len(tracks)} tracks and beginnings"
        )

    return at


def _settings(options: argparse.Namespace) -> Settings:
    chosen: dict[str, Any] = {
        name: getattr(options, name)
        for name in ("filter", "conversion")
        if getattr(options, name) is not None
    }
    for option, name in NUMBERS.items():
        text = getattr(options, option)
        if text is not None:
            chosen[name] = _number(f"--{option.replace('_', '-')}", text)
    if options.confirm is not None:
        match = re.fullmatch(r"([0-9]{1,3})/([0-9]{1,3})", options.confirm)
        if match is None:
            raise BadInputError(f"--confirm takes M/N, as 3/4, got {options.confirm!r}")
        chosen["confirm"] = int(match[1]), int(match[2])
    if options.drop is not None:
        if not re.fullmatch(r"[0-9]{1,3}", options.drop):
            raise BadInputError(f"--drop takes a whole number, got {options.drop!r}")
        chosen["drop"] = int(options.drop)
    return Settings(**chosen)


def _sigma(options: argparse.Namespace, name: str) -> float | None:
    text = getattr(options, name)
    if text is None:
        return None
    option = f"--{name.replace('_', '-')}"
    value = _number(option, text)
    unit, size = ("m", 1.0) if name == "sigma_range" else ("degrees", math.radians(1))
    least, most, _ = LIMITS[name]
    if not least <= value * size <= most:
        raise BadInputError(f"{option} takes {wanted(name, unit, size)}, got {text}")
    return value * size


def _number(name: str, text: str) -> float:
    try:
        value = decimal(text)
    except ValueError:
        raise BadInputError(f"{name} takes a number, got {text!r}") from None
    if not math.isfinite(value):
        raise BadInputError(f"{name} takes a finite number, got {text!r}")
    return value


def _contents(
    options: argparse.Namespace, given: FromFile, settings: Settings, found: Followed
) -> dict[Path, bytes]:
    """The files that are asked for."""
    contents = {}
    if options.out:
        contents[Path(options.out)] = csv_text(given, found).encode()
    if options.plot:
        from gainproof.tracking.answer import plotted

        title = f"{settings.filter} filter, {settings.conversion} conversion"
        path = Path(options.plot)
        contents[path] = plotted(given.scans, found, title, path)
    return contents


def _draw(scans: Scans, found: Followed, title: str, sheet: Figure) -> None:
    """x east, y north, in km or m; the radar in the origin."""
    axes = sheet.add_subplot()
    far = float(scans.polar.range.max(initial=0.0))
    scale, unit = (1e3, "km") if far >= 2e3 else (1.0, "m")
    polar = scans.polar
    x = polar.range * np.sin(polar.bearing) / scale
    y = polar.range * np.cos(polar.bearing) / scale
    loose = found.track < 0
    axes.plot(x[~loose], y[~loose], ".", color="0.6", ms=3, label="detections of tracks")
    axes.plot(x[loose], y[loose], "x", color="0.6", ms=4, mew=0.8, label="unassigned")
    axes.plot(0, 0, "^", color="black", ms=7, label="radar")
    for number in found.tracks.tolist():
        own = np.flatnonzero(found.track == number)
        colour = COLOURS[number % len(COLOURS)]
        track = found.state[own] / scale
        axes.plot(track[:, 0], track[:, 2], color=colour, lw=1.3)
        axes.plot(track[-1, 0], track[-1, 2], "o", color=colour, ms=4)
        if len(found.tracks) <= MOST_NAMED:
            axes.annotate(
                str(number + 1),
                (track[-1, 0], track[-1, 2]),
                xytext=(6, 5),
                textcoords="offset points",
                color=colour,
            )
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.08)
    axes.grid(True)
    axes.set_xlabel(f"x, {unit} east")
    axes.set_ylabel(f"y, {unit} north")
    axes.set_title(title)
    sheet.legend(loc="outside lower center", ncols=3)


def plotted(scans: Scans, found: Followed, title: str, path: Path) -> bytes:
    """For a file of that name, which ends in .svg or .png. BadInputError without Matplotlib."""
    drawn = canvas.pictures(lambda sheet: _draw(scans, found, title, sheet), *_SIZE)
    return drawn[path.suffix.lower()[1:]]
