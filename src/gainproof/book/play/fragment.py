"""A play as a fragment of a page: sliders with number fields, pictures, a table of numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

from gainproof.book.play.subjects import Slider, Subject

_STEADY = (
    "Gains, poles, variances and lags come from kernels that are printed from the same expression "
    "graphs as the NumPy kernels, the responses from the filter itself, run in the page."
)
_FIXED = (
    "Poles, variances and lags come from kernels that are printed from the same expression graphs "
    "as the NumPy kernels as far as these take the gains, beyond them from plain formulas; the "
    "responses come from the filter itself, run in the page."
)
_MEASURED = (
    "Gains, poles and Kalman variances come from kernels that are printed from the same expression "
    "graphs as the NumPy kernels; lag, variance under noise alone and the responses are computed "
    "in the page from the gains."
)
_COMPUTED = {
    "two-states": _STEADY,
    "three-states": _STEADY,
    "both-measured": _MEASURED,
    "two-gains": _FIXED,
    "three-gains": _FIXED,
}
_UNITS = "The interval between samples and the variance of a position measurement are 1."
_KALMAN = (
    "A Kalman variance is that of the error under the model's process noise; the variance under "
    "noise alone is what the measurements' noise makes of it where the target moves as predicted."
)


@dataclass(frozen=True)
class _Picture:
    """`panel` is one of `play.panels.js`; `legend` are (look, words), looks of `play.css`."""

    panel: str
    title: str
    words: str
    legend: tuple[tuple[str, str], ...] = ()


_GAINS = {
    "two-states": (("first", "α"), ("second", "β")),
    "three-states": (("first", "α"), ("second", "β"), ("third", "γ")),
    "both-measured": (
        ("first", "position on position"),
        ("second", "position on velocity"),
        ("third", "velocity on position"),
        ("fourth", "velocity on velocity"),
    ),
}
_LOCUS = {
    "two-states": "all tracking indices",
    "three-states": "all tracking indices",
    "both-measured": "all tracking indices at this S",
}
_FILTERS = {"two": "α-β", "three": "α-β-γ"}
_REGION = {
    "two-states": "Stable gains: the triangle 0 < α, 0 < β < 4 − 2α.",
    "two-gains": "Stable gains: the triangle 0 < α, 0 < β < 4 − 2α.",
    "three-states": "Stable gains at this γ: β < 4 − 2α, γ (1 − α/2) < αβ.",
    "three-gains": "Stable gains at this γ: β < 4 − 2α, γ (1 − α/2) < αβ.",
    "both-measured": "Stable filters: both poles inside the unit circle.",
}


def _locus_of_gains(kind: str) -> tuple[tuple[str, str], ...]:
    if kind == "three-states":
        return (("second", "all tracking indices, each with a γ of its own"),)
    return (("second", _LOCUS[kind]),) if kind in _LOCUS else ()


def _pictures(subject: Subject) -> tuple[_Picture, ...]:
    """The pictures of a subject, in the order of the page."""
    kind = subject.kind
    locus = (("second", _LOCUS[kind]),) if kind in _LOCUS else ()
    filters = _FILTERS.get(kind.partition("-")[0])
    best = (("third", f"least of any {filters} filter at that lag"),) if filters else ()
    found = [
        _Picture(
            "poles",
            "Poles",
            "Crosses are the poles of the filter, the shaded circle holds the stable ones."
            + (" Dots: where they lie at other indices." if locus else ""),
        ),
        _Picture(
            "step",
            "Step response",
            "The updated position when the measured one jumps to 1.",
            (("first", "filter"), ("truth", "measured")),
        ),
        _Picture(
            "noise",
            "Noise response",
            "The updated position when the target rests at 0 and each measurement has noise of "
            "deviation 1, the same noise at every setting.",
            (("first", "filter"), ("measured", "measured")),
        ),
        _Picture("region", "Stability", _REGION[kind], _locus_of_gains(kind)),
        _Picture(
            "tradeoff",
            "Variance against lag",
            "Variance of the predicted position under measurement noise alone, against its lag.",
            (*locus, *best),
        ),
    ]
    if kind in _GAINS:
        found.insert(0, _Picture("gains", "Gains", "Over the tracking index.", _GAINS[kind]))
    return tuple(found)


def fragment(subject: Subject) -> str:
    """The section of a subject. Its table and pictures are filled by the scripts."""
    return "\n".join(_lines(subject))


def _lines(subject: Subject) -> Iterator[str]:
    data = f'data-kind="{subject.kind}" data-subject="{subject.name}" data-swept="{subject.swept}"'
    yield f'<section class="play" id="play" aria-labelledby="play-title" {data}>'
    yield '<h2 id="play-title">Play</h2>'
    yield f"<p>Move a slider or type a number. {_COMPUTED[subject.kind]} {_UNITS}</p>"
    yield '<p class="play-without">This part needs JavaScript.</p>'
    yield '<form class="play-form" aria-label="What is moved">'
    for slider in subject.sliders:
        yield from _input(slider)
    yield '<p class="play-changing" aria-live="polite"></p>'
    yield '<p class="play-refusal" role="alert"></p>'
    yield "</form>"
    yield '<div class="play-pictures">'
    for picture in _pictures(subject):
        yield from _figure(picture)
    yield "</div>"
    yield '<div class="play-numbers"><table>'
    told = f" {_KALMAN}" if subject.swept else ""
    yield f"<caption>The same in numbers.{told}</caption>"
    yield "<tbody></tbody>"
    yield "</table></div>"
    yield "</section>"


def _input(slider: Slider) -> Iterator[str]:
    scale = math.log10 if slider.logarithmic else float
    least, most, begins = (scale(x) for x in (slider.least, slider.most, slider.begins))
    kind = "logarithmic" if slider.logarithmic else "linear"
    step = "0.01" if slider.logarithmic else "0.005"
    name = f"play-{slider.argument}"
    label = escape(slider.label)
    ends = f'min="{least:g}" max="{most:g}" step="{step}" value="{begins:g}"'
    yield f'<div class="play-input" data-input="{slider.argument}" data-scale="{kind}">'
    yield f'<label for="{name}">{label}</label>'
    yield f'<input type="range" id="{name}" {ends}/>'
    yield (
        f'<input type="number" id="{name}-number" step="any" value="{slider.begins:g}" '
        f'aria-label="{label}, as a number"/>'
    )
    yield "</div>"


def _figure(picture: _Picture) -> Iterator[str]:
    name = f"play-{picture.panel}-title"
    yield "<figure>"
    yield f'<h3 id="{name}">{picture.title}</h3>'
    yield f'<svg data-panel="{picture.panel}" role="img" aria-labelledby="{name}"></svg>'
    yield f"<figcaption>{escape(picture.words)}"
    if picture.legend:
        yield '<ul class="play-legend">'
        for look, words in picture.legend:
            sample = (
                '<circle class="measured" cx="13" cy="4" r="2"/>'
                if look == "measured"
                else f'<path class="curve {look}" d="M0 4H26"/>'
            )
            drawn = f'<svg viewBox="0 0 26 8" aria-hidden="true">{sample}</svg>'
            yield f"<li>{drawn} {escape(words)}</li>"
        yield "</ul>"
    yield "</figcaption>"
    yield "</figure>"
