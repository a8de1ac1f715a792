"""A steady state as a page for people."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from math import ceil, floor, log10

from gainproof.steady.state import Enclosed, Sample, SteadyState
from gainproof.terminal_text import filled
from gainproof.terminal_text import width as columns
from gainproof.verify.enclosure.poles import Pole
from gainproof.verify.judge.claim.model_file import Component, ModelFile
from gainproof.verify.judge.claim.units import unit_text_of

MOST_DIGITS, LEAST_DIGITS = 16, 5
DECIDED = "decided by `python -m gainproof.verify.check_enclosure`, or a copy of it"


def page(
    model: ModelFile,
    values: Mapping[str, Fraction],
    found: SteadyState,
    written: str | None = None,
) -> str:
    """The whole page; `written` is the file of the certificate, if there is one."""
    width = columns()
    lines = [_title(model, values)]
    states = [_with_unit(c) for c in model.states]
    measured = [c.name for c in model.measurements]
    across = [c.name for c in model.states]
    for heading, matrix, head in (
        ("filter gain", found.filter_gain, measured),
        ("predictor gain", found.predictor_gain, measured),
        ("predicted covariance", found.predicted_covariance, across),
        ("updated covariance", found.updated_covariance, across),
    ):
        lines += ["", heading, *_table(matrix, states, head, width)]
    lines += ["", "poles", *(f"  {_pole(pole)}" for pole in found.poles), ""]
    size = len(json.dumps(found.certificate))
    said = f"written to {written}" if written else "written with --certificate FILE"
    lines += filled(
        "Proved: a true value differs from that shown here by no more than its row's last column; "
        "--json has all digits and errors. The certificate, "
        f"{size} bytes, is {said} and {DECIDED}.",
        columns=width,
    )
    return "\n".join(lines)


def samples_page(model: ModelFile, values: Mapping[str, Fraction], found: Sequence[Sample]) -> str:
    """The gains of the first samples, one a row."""
    one = len(model.measurements) == 1
    head = [
        x.name if one else f"{x.name}, {z.name}" for x in model.states for z in model.measurements
    ]
    gains = Enclosed(
        tuple(sum(each.filter_gain.values, ()) for each in found),
        tuple(sum(each.filter_gain.errors, ()) for each in found),
        (),
        (),
    )
    names = [str(k) for k in range(1, len(found) + 1)]
    lines = [_title(model, values), "", "filter gain, sample by sample"]
    return "\n".join([*lines, *_table(gains, names, head, columns())])


def _title(model: ModelFile, values: Mapping[str, Fraction]) -> str:
    said = ", ".join(f"{token} = {_short(x)}" for token, x in values.items())
    return f"{model.title}{f', at {said}' if said else ''}"


def _short(x: Fraction) -> str:
    exact = str(x)
    if len(exact) <= 8:
        return exact
    try:
        near = repr(float(x))
    except OverflowError:
        near = f"{(Decimal(x.numerator) / x.denominator).normalize():g}"
    return near if Fraction(near) == x else exact


def _with_unit(component: Component) -> str:
    unit = "" if component.unit is None else unit_text_of(component.unit)
    return component.name if unit in ("", "1") else f"{component.name} [{unit}]"


def _table(
    matrix: Enclosed, names: Sequence[str], head: Sequence[str], width: int
) -> Iterator[str]:
    """With as many digits as the width has room for, and in several pieces where it has none."""
    name = max(map(len, names))
    for digits in range(MOST_DIGITS, LEAST_DIGITS - 1, -1):
        cells = [[_cell(x, digits) for x in row] for row in matrix.values]
        errors = [_error(*row) for row in zip(cells, matrix.values, matrix.errors, strict=True)]
        wide = max(len(cell) for row in (*cells, list(head)) for cell in row) + 2
        room = (width - name - 2 - max(map(len, errors)) - 2) // wide
        if room >= len(head):
            break
    room = max(room, 1)
    for start in range(0, len(head), room):
        yield " " * (name + 2) + "".join(f"{x:>{wide}}" for x in head[start : start + room])
        for label, row, error in zip(names, cells, errors, strict=True):
            shown = "".join(f"{x:>{wide}}" for x in row[start : start + room])
            yield f"  {label:<{name}}{shown}  {error}"


def _error(cells: Sequence[str], values: Sequence[float], errors: Sequence[float]) -> str:
    """What true values differ by from the texts of a row, at most."""
    off = [
        abs(Fraction(cell) - Fraction(value)) + Fraction(error)
        for cell, value, error in zip(cells, values, errors, strict=True)
    ]
    return f"+- {_upwards(max(off))}" if any(off) else "exact"


def _cell(x: float, digits: int) -> str:
    return f"{x:.{digits}g}"


def _upwards(x: float | Fraction) -> str:
    """One digit, rounded up."""
    power = floor(log10(x))
    digit = ceil(Fraction(x) / Fraction(10) ** power)
    return f"{digit}e{power:+03d}" if digit < 10 else f"1e{power + 1:+03d}"


def _pole(pole: Pole) -> str:
    real, imaginary = pole.centre.real, pole.centre.imag
    cells = [_cell(real, MOST_DIGITS), _cell(abs(imaginary), MOST_DIGITS)]
    shown = cells[0]
    if imaginary:
        shown += f" {'+' if imaginary > 0 else '-'} {cells[1]}i"
    off = Fraction(pole.radius)
    for cell, value in zip(cells, (real, abs(imaginary)), strict=True):
        off += abs(Fraction(cell) - Fraction(value))
    if pole.count > 1:
        return f"{pole.count} within {_upwards(off)} of {shown}"
    return f"{shown}  +- {_upwards(off)}" if off else shown
