"""The numbers of the source's figures 8 and 9, errors along the paths, and of a comparison."""

from __future__ import annotations

import numpy as np

from gainproof.figures.patent_runs import (
    Errors,
    Interval,
    all_outcomes,
    ratio,
    rms,
    settled,
)
from gainproof.figures.patent_scene import INTERVAL, RUNS, SAMPLES, SEED, SETTLED, seen
from gainproof.plots.table import Column, Reals, Table, Words

PLOTTED = 2
"""The first sample that is filtered."""
NOTES = (
    "The source gives sigma_w = 0.98 m/s^2, 50 m, 1 degree and 5 s; it gives no path, no nominal",
    "point and no number of runs. Ours: a target at 250 m/s, radial from 80 to 5 km; crossing",
    "10 km north of the radar; turning with 0.3 g; manoeuvring as the filters take it (radial at",
    "first, then white accelerations of 0.98 m/s^2 in x and y); nominal points at 80, 40, 10 km.",
    "Two-point start, then gains of the least-squares line until they fall below a filter's own.",
    f"{RUNS} runs, seed {SEED}, the same noise for every filter; intervals of 95 % of the RMS.",
)


def figure_8() -> Table:
    """RMS position error of every filter along every path."""
    return _along("position", "m")


def figure_9() -> Table:
    """RMS velocity error of every filter along every path."""
    return _along("velocity", "m/s")


def comparison() -> Table:
    """RMS over all samples but the first ten, beside that of the fixed gains of the same nominal
    point and that of the Kalman filter, with intervals.
    """
    words: list[tuple[str, str]] = []
    numbers: list[list[float]] = []
    for path, found in all_outcomes().items():
        for name, errors in found.items():
            words.append((path, name))
            fixed = f"fixed, {name.partition(', ')[2]}"
            row: list[float] = []
            for kind in ("position", "velocity"):
                own, best = (settled(_of(each, kind)) for each in (errors, found["kalman"]))
                row += _numbers(rms(own))
                has_fixed = fixed in found and fixed != name
                row += (
                    _numbers(ratio(own, settled(_of(found[fixed], kind))))
                    if has_fixed
                    else ([np.nan] * 3)
                )
                row += _numbers(ratio(own, best)) if name != "kalman" else [np.nan] * 3
            numbers.append(row)
    columns: list[Column | Words] = [
        Words("path", "of the target", tuple(path for path, _ in words)),
        Words("filter", "filter, nominal point", tuple(name for _, name in words)),
    ]
    values = np.array(numbers).T
    for k, (kind, unit) in enumerate((("position", "m"), ("velocity", "m_s"))):
        told = (f"rms_{kind}_{unit}", f"{kind}_over_fixed", f"{kind}_over_kalman")
        for j, what in enumerate(told):
            for i, end in enumerate(("", "_lower", "_upper")):
                meaning = f"{what.replace('_', ' ')}{end.replace('_', ', ')}"
                columns.append(Column(f"{what}{end}", meaning, values[9 * k + 3 * j + i]))
    return Table(
        f"RMS errors of all filters after the first {SETTLED} samples", tuple(columns), {}, NOTES
    )


def _along(kind: str, unit: str) -> Table:
    words: list[tuple[str, str]] = []
    ranges: list[Reals] = []
    curves: list[Interval] = []
    numbers: dict[str, object] = {}
    for path, found in all_outcomes().items():
        far = seen(path).range[PLOTTED:]
        for name, errors in found.items():
            words += [(path, name)] * far.size
            ranges.append(far)
            curves.append(rms(_of(errors, kind)[PLOTTED:]))
        numbers[f"RMS {kind} error ({unit}) after {SETTLED} samples, {path}"] = {
            name: float(rms(settled(_of(errors, kind))).middle) for name, errors in found.items()
        }
    count = len(curves)
    times = np.tile(INTERVAL * np.arange(float(PLOTTED), float(SAMPLES)), count)
    column = f"rms_{kind}_{unit.replace('/', '_')}"
    together: list[Reals] = [
        np.concatenate([getattr(curve, end) for curve in curves])
        for end in ("middle", "lower", "upper")
    ]
    return Table(
        f"RMS {kind} error along four paths",
        (
            Words("path", "of the target", tuple(path for path, _ in words)),
            Words("filter", "filter, nominal point", tuple(name for _, name in words)),
            Column("time_s", "s since the first detection", times),
            Column("range_m", "root mean square of the true range, m", np.concatenate(ranges)),
            Column(column, f"RMS {kind} error, {unit}", together[0]),
            Column(f"{column}_lower", "lower end of its interval of 95 %", together[1]),
            Column(f"{column}_upper", "upper end", together[2]),
        ),
        numbers,
        NOTES,
    )


def _of(errors: Errors, kind: str) -> Reals:
    return errors.position if kind == "position" else errors.velocity


def _numbers(interval: Interval) -> list[float]:
    return [float(interval.middle), float(interval.lower), float(interval.upper)]
