"""Every figure: its source, its name, its numbers, its drawing, and the size of its sheet."""

from __future__ import annotations

from gainproof.bad_input import unknown_name
from gainproof.figures import patent_figures, suzuki_figures
from gainproof.figures.doppler import figures as doppler_figures
from gainproof.figures.entry import Entry
from gainproof.figures.lecture import figures as lecture_figures

CATALOGUE: tuple[Entry, ...] = (
    *suzuki_figures.FIGURES,
    *lecture_figures.FIGURES,
    *patent_figures.FIGURES,
    *doppler_figures.FIGURES,
)


def of_source(source: str) -> tuple[Entry, ...]:
    """The figures of a source. Raises BadInputError for one that has none."""
    own = tuple(entry for entry in CATALOGUE if entry.source == source)
    if not own:
        sources = {entry.source for entry in CATALOGUE}
        raise unknown_name("source with figures", source, sources)
    return own


def find(source: str, name: str) -> Entry:
    """The figure of this name. Raises BadInputError for one there is not."""
    own = {entry.name: entry for entry in of_source(source)}
    if name not in own:
        raise unknown_name(f"figure of {source}", name, own)
    return own[name]
