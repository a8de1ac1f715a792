"""Numbers and pictures of figures 8 and 9, errors along the paths, and of a comparison."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from gainproof.figures.lecture.look import framed
from gainproof.figures.patent_look import ENDS, LOOKS
from gainproof.figures.patent_runs import (
    NOMINAL_FILTERS,
    OTHERS,
    Errors,
    Interval,
    all_outcomes,
    ratio,
    rms,
    settled,
)
from gainproof.figures.patent_scene import (
    INTERVAL,
    NOMINAL,
    PATHS,
    RUNS,
    SAMPLES,
    SEED,
    SETTLED,
    seen,
)
from gainproof.plots.table import Column, Reals, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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


SIZE = (8.4, 10.4)
COMPARISON_SIZE = (8.4, 6.6)


def draw_figure_8(table: Table, sheet: Figure) -> None:
    """A row for every path, a column for every nominal point."""
    _draw(table, sheet, "rms_position_m", "RMS position error (m)")


def draw_figure_9(table: Table, sheet: Figure) -> None:
    """The same for the velocity."""
    _draw(table, sheet, "rms_velocity_m_s", "RMS velocity error (m/s)")


def _draw(table: Table, sheet: Figure, column: str, label: str) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator

    grid = sheet.subplots(len(PATHS), len(NOMINAL), sharex=True, sharey="row")
    paths, filters = (np.array(table.words(name)) for name in ("path", "filter"))
    for row, path in zip(grid, PATHS, strict=True):
        for axes, nominal in zip(row, NOMINAL, strict=True):
            framed(axes, "", "")
            axes.set_yscale("log")
            axes.yaxis.set_major_formatter(FuncFormatter(_plain))
            axes.yaxis.set_minor_locator(LogLocator(subs=(2.0, 5.0)))
            axes.yaxis.set_minor_formatter(FuncFormatter(_plain))
            axes.tick_params(axis="y", which="both", labelsize=7.5)
            for name, own in LOOKS.items():
                called = f"{name}, {nominal}" if name in NOMINAL_FILTERS else name
                here = (paths == path) & (filters == called)
                time = table["time_s"][here]
                ends = (table[f"{column}_{end}"][here] for end in ("lower", "upper"))
                axes.fill_between(time, *ends, color=own.colour, alpha=0.18, lw=0)
                axes.plot(time, table[column][here], **{**own.line, "linewidth": own.width * 0.75})
            axes.set_xlim(0, 300)
            if path == next(iter(PATHS)):
                axes.set_title(f"nominal point at {ENDS[nominal]}", fontsize=9)
        row[0].set_ylabel(path)
    for axes in grid[-1]:
        axes.set_xlabel("time (s)")
    handles, labels = grid[0, 0].get_legend_handles_labels()
    sheet.legend(handles, labels, loc="outside upper center", ncols=3)
    sheet.supylabel(label, fontsize=10)
    words = f"{RUNS} runs each; bands: intervals of 95 %. Paths and nominal points are ours."
    sheet.supxlabel(words, fontsize=8, color="0.25")


def draw_comparison(table: Table, sheet: Figure) -> None:
    """RMS over that of the Kalman filter: dots with intervals of 95 %."""
    grid = sheet.subplots(2, len(PATHS), sharey=True)
    names = [f"{name}, {nominal}" for nominal in NOMINAL for name in NOMINAL_FILTERS]
    names += [name for name in OTHERS if name != "kalman"]
    paths, filters = (np.array(table.words(name)) for name in ("path", "filter"))
    for row, kind in zip(grid, ("position", "velocity"), strict=True):
        for axes, path in zip(row, PATHS, strict=True):
            _dots(axes, table, f"{kind}_over_kalman", paths == path, filters, names)
            axes.set_title(f"{path}, {kind}", fontsize=9)
        row[0].set_yticks(range(len(names)), [_label(name) for name in names], fontsize=8)
    grid[0, 0].invert_yaxis()
    words = "RMS error over that of the Kalman filter; lines: intervals of 95 %, often hidden"
    sheet.supxlabel(words, fontsize=10)


def _dots(
    axes: Axes, table: Table, column: str, on_path: object, filters: object, names: list[str]
) -> None:
    framed(axes, "", "")
    axes.axvline(1.0, color="0.45", lw=1.0)
    for place, name in enumerate(names):
        (row,) = np.flatnonzero(np.asarray(on_path) & (np.asarray(filters) == name))
        own = LOOKS[name.partition(",")[0]]
        ends = [float(table[f"{column}_{end}"][row]) for end in ("lower", "upper")]
        axes.plot(ends, [place, place], color=own.colour, lw=1.6)
        axes.plot(table[column][row], place, "o", color=own.colour, ms=4)
    axes.set_xscale("log")
    axes.set_xticks([0.5, 1, 2, 4], ["0.5", "1", "2", "4"])
    axes.minorticks_off()
    axes.set_xlim(0.4, 4)


def _plain(value: float, _place: int | None = None) -> str:
    return f"{value:g}"


def _label(name: str) -> str:
    filter_name, _, nominal = name.partition(", ")
    words = LOOKS[filter_name].label
    return f"{words}, {ENDS[nominal]}" if nominal else words
