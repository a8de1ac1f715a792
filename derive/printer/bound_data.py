"""Proved bounds as plain data and back, bit for bit; and on what the bounds of a kernel rest.

Numbers of a format stand as JSON writes them, with the shortest text that comes back as the same
float; a bound is a decimal fraction, which is exact since bounds are hundredths of epsilon.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.bound import DIGITS, Bounds, KernelBound, OutputBound
from gainproof.derive.printer.formats import FORMATS, Format
from gainproof.derive.printer.graph import fraction_text
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.lost_digits_text import Loss, Part
from gainproof.derive.printer.step_ranges import Box

Plain = dict[str, Any]

PROSE = ("name", "result", "summary", "source")
DOUBLE_WORDS = ("accurate", "accurate_graph", "refinement")
"""Of a kernel what no bound rests on: words, and what is bounded when it is printed. Equations say
by which names lost digits may be explained.
"""


def identity(group: Sequence[Kernel]) -> str:
    """A digest of all that the bounds of kernels proved together rest on, but for the code: of
    each the graph, the inputs with their domains, what outputs are relative to, cancellations and
    requirements.
    """
    told = json.dumps([_told(kernel) for kernel in group], sort_keys=True, default=str)
    return hashlib.sha256(told.encode()).hexdigest()


def _told(kernel: Kernel) -> Plain:
    # a field that is new counts until somebody says that it is prose
    left_out = {*PROSE, *DOUBLE_WORDS}
    found = {name: value for name, value in asdict(kernel).items() if name not in left_out}
    found["cancellations"] = list(kernel.cancellations)
    for part in (*found["inputs"], *found["outputs"], *found["requirements"]):
        part.pop("meaning")
        part.pop("scale_meaning", None)
        part.pop("accepted", None)
    return found


def plain(bounds: Bounds) -> Plain:
    """By format {"inputs", "boxes", "outputs"}; an output's domain where it is not that of the
    inputs, and what is 0 or none, is left out.
    """
    return {bound.format.name: _kernel(bound) for bound in bounds}


def _kernel(bound: KernelBound) -> Plain:
    return {
        "inputs": bound.inputs,
        "boxes": bound.boxes,
        "outputs": {each.name: _output(each, bound.inputs) for each in bound.outputs},
    }


def _output(found: OutputBound, inputs: Box) -> Plain:
    entry: Plain = {"bound": bound_text(found.bound)}
    if found.domain != inputs:
        entry["domain"] = found.domain
    if found.amplification:
        entry["amplification"] = found.amplification
    if found.beside:
        entry["beside"] = found.beside
    if found.loss is not None:
        entry["loss"] = _loss(found.loss)
    return entry


def bound_text(bound: Fraction) -> str:
    """A number of hundredths as a decimal fraction, any other as a fraction."""
    hundredths = bound * DIGITS
    if hundredths.denominator != 1:
        return fraction_text(bound)
    whole, rest = divmod(hundredths.numerator, DIGITS)
    return f"{whole}.{rest:02d}"


def _loss(loss: Loss) -> Plain:
    parts = {"halved": _part(loss.halved), "quartered": _part(loss.quartered)}
    return {name: value for name, value in vars(loss).items() if name != "form"} | parts


def _part(part: Part | None) -> Plain | None:
    if part is None:
        return None
    return {"ranges": part.ranges, "empty": part.empty}


def bounds_from(kernel: Kernel, data: Mapping[str, Any]) -> Bounds:
    """The bounds of a kernel in all formats. KeyError, TypeError or ValueError for data that
    `plain` did not make of this kernel's bounds.
    """
    return tuple(_bound_from(kernel, form, data[form.name]) for form in FORMATS)


def _bound_from(kernel: Kernel, form: Format, data: Mapping[str, Any]) -> KernelBound:
    inputs = _box(data["inputs"])
    names = [output.name for output in kernel.outputs]
    if list(data["outputs"]) != names or len(inputs) != len(kernel.inputs):
        raise ValueError(f"{kernel.name}: bounds of other outputs or inputs")
    outputs = tuple(_output_from(name, form, inputs, data["outputs"][name]) for name in names)
    return KernelBound(form, inputs, outputs, int(data["boxes"]))


def _output_from(name: str, form: Format, inputs: Box, data: Mapping[str, Any]) -> OutputBound:
    loss = data.get("loss")
    return OutputBound(
        name,
        Fraction(data["bound"]),
        _box(data["domain"]) if "domain" in data else inputs,
        {key: float(value) for key, value in data.get("amplification", {}).items()},
        float(data.get("beside", 0.0)),
        None if loss is None else _loss_from(form, loss),
    )


def _loss_from(form: Format, data: Mapping[str, Any]) -> Loss:
    parts = {name: _part_from(data[name]) for name in ("halved", "quartered")}
    return Loss(**{**data, **parts, "form": form})


def _part_from(data: Mapping[str, Any] | None) -> Part | None:
    if data is None:
        return None
    ranges = tuple(
        (text, tuple((low, high) for low, high in spans)) for text, spans in data["ranges"]
    )
    return Part(ranges, bool(data["empty"]))


def _box(ends: Sequence[Sequence[float]]) -> Box:
    return tuple((float(low), float(high)) for low, high in ends)
