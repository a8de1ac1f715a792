"""A run of `gainproof bench`: measured kernel by kernel, printed and kept as it goes."""

from __future__ import annotations

import argparse
import math
import os
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.bench import results, table
from gainproof.bench.measure import Figures, Options, figures
from gainproof.bench.page import page
from gainproof.bench.results import Results
from gainproof.bench.subjects import Measured, measured_kernels, subject_names
from gainproof.files import named_files
from gainproof.pages.cancellations import Left, left

PAGE, DATA = "bench.html", "bench.json"


def run_table(options: argparse.Namespace) -> int:
    """Measure, print, and write what is asked for; 1 where a kernel is outside its bound.

    Raises BadInputError for places that cannot be written, before anything is measured.
    """
    if options.numbers > 1 and options.constant is None:
        raise BadInputError("--numbers wants to know of which inputs: --constant PREFIX")
    html, data = _places(options.html, options.json)
    if options.resume and data is None:
        raise BadInputError("--resume wants a file to continue from: --json FILE or --html DIR")
    how = Options(
        options.workers, options.constant, options.numbers, html is not None or data is not None
    )
    begun = results.begun(how, subject_names(options.subject), data if options.resume else None)
    _write(begun, html, data)
    print("\n".join(table.opening(begun)), flush=True)
    for kept in begun.rows:
        print(table.line(kept))
    _measure(begun, how, html, data)
    alarm = table.alarm(begun)
    if alarm:
        print(alarm, file=sys.stderr)
    return 1 if alarm else 0


def _measure(begun: Results, how: Options, html: Path | None, data: Path | None) -> None:
    left = _remaining()
    with tempfile.TemporaryDirectory() as folder:
        for subject in begun.chosen:
            if subject in begun.finished:
                continue
            print(subject, flush=True)
            done = {(each["subject"], each["kernel"]) for each in begun.rows}
            for item in measured_kernels([subject], done):
                begun.rows.append(row(item, figures(item, Path(folder), how), left))
                print(table.line(begun.rows[-1]), flush=True)
                _write(begun, None, data)
            begun.finished.append(subject)
            _write(begun, html, data)


def _write(begun: Results, html: Path | None, data: Path | None) -> None:
    """What is there so far; whole files, whenever a run is broken off."""
    contents = {}
    if html is not None:
        contents[html] = page(begun).encode()
    if data is not None:
        contents[data] = results.as_json(begun).encode()
    named_files.write(contents)


def _places(html: str | None, data: str | None) -> tuple[Path | None, Path | None]:
    """The page and the file of data; a folder takes both.

    What does not end in .html and is no file is a folder.
    """
    for name, text in (("--html", html), ("--json", data)):
        if text is not None and (not text or "\0" in text):
            raise BadInputError(f"{name} takes the name of a file, got {text!r}")
    if html is None:
        return None, None if data is None else Path(data)
    place = Path(html)
    is_page = place.suffix.lower() in (".html", ".htm")
    folder = os.path.isdir(place) or (not is_page and not os.path.exists(place))
    kept = Path(data) if data is not None else place / DATA if folder else None
    shown = place / PAGE if folder else place
    named_files.require_apart({}, {"--html": str(shown), "--json": str(kept) if kept else None})
    return shown, kept


def row(item: Measured, found: Figures, remaining: Mapping[str, Left]) -> dict[str, Any]:
    """One kernel: its names, domain, cancellations, seconds for a million points, and errors.

    Numbers that are infinite are written as text, since JSON has none.
    """
    module = item.function.__module__.rpartition(".")[2]
    return {
        "subject": item.subject,
        "kernel": item.kernel.name,
        "domain": _domain(item),
        "inputs": len(item.kernel.inputs),
        "outputs": len(item.kernel.outputs),
        "cancellations": _cancellations(remaining.get(f"{module}.{item.kernel.name}")),
        "seconds": {name: float(f"{seconds:.4g}") for name, seconds in found.seconds.items()},
        "missing": dict(found.missing),
        "errors": [
            {key: _plain(value) for key, value in asdict(each).items()} for each in found.errors
        ],
    }


def _remaining() -> dict[str, Left]:
    """The subtractions that are left, by module and function."""
    return {each.name: each for each in left()}


def _domain(item: Measured) -> list[str]:
    """The numbers of each input in double precision, what they must fulfil together, and where all
    outputs have their bounds if that is less.
    """
    signature, bounds = item.signature, item.bound.outputs
    lines = []
    for number, given in enumerate(signature.inputs):
        low, high = given.double
        name = f"|{given.name}|" if given.signed else given.name
        kind = " whole" if given.whole else ""
        zero = "0 or " if given.zero and low > 0 else ""
        lines.append(f"{name}{kind}: {zero}{low:.3g} to {high:.3g}")
        least = max(each.domain[number][0] for each in bounds)
        most = min(each.domain[number][1] for each in bounds)
        if not given.signed and (least > low or most < high):
            lines.append(f"bounds of all outputs: {least:.3g} to {most:.3g}")
    return lines + [required.wanted for required in signature.required]


def _cancellations(found: Left | None) -> list[str]:
    if found is None:
        return []
    named = [f"{name}, condition number {condition}" for name, condition, _ in found.differences]
    if found.by_terms:
        outputs = "1 output" if found.by_terms == 1 else f"{found.by_terms} outputs"
        named.append(f"{outputs} over the sum of terms")
    return named


def _plain(value: Any) -> Any:
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
