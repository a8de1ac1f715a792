"""The pictures of a play: which a subject has, what they are called and what is seen in them."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.book.play.subjects import Subject


@dataclass(frozen=True)
class Picture:
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


def pictures(subject: Subject) -> tuple[Picture, ...]:
    """The pictures of a subject, in the order of the page."""
    kind = subject.kind
    locus = (("second", _LOCUS[kind]),) if kind in _LOCUS else ()
    filters = _FILTERS.get(kind.partition("-")[0])
    best = (("third", f"least of any {filters} filter at that lag"),) if filters else ()
    found = [
        Picture(
            "poles",
            "Poles",
            "Crosses are the poles of the filter, the shaded circle holds the stable ones."
            + (" Dots: where they lie at other indices." if locus else ""),
        ),
        Picture(
            "step",
            "Step response",
            "The updated position when the measured one jumps to 1.",
            (("first", "filter"), ("truth", "measured")),
        ),
        Picture(
            "noise",
            "Noise response",
            "The updated position when the target rests at 0 and each measurement has noise of "
            "deviation 1, the same noise at every setting.",
            (("first", "filter"), ("measured", "measured")),
        ),
        Picture("region", "Stability", _REGION[kind], _locus_of_gains(kind)),
        Picture(
            "tradeoff",
            "Variance against lag",
            "Variance of the predicted position under measurement noise alone, against its lag.",
            (*locus, *best),
        ),
    ]
    if kind in _GAINS:
        found.insert(0, Picture("gains", "Gains", "Over the tracking index.", _GAINS[kind]))
    return tuple(found)
