"""The Singer model of acceleration that fades, over any interval: the page `singer`, no kernels."""

from __future__ import annotations

from pathlib import Path

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.source import MATRICES, SINGER
from gainproof.derive.subject import Subject

NAME = "singer"


def build(folder: Path = FOLDER) -> Subject:
    """Derive the transition matrix and the process noise.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    page = written(NAME, Given(), folder)
    sources = (SINGER.key, MATRICES.key)
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, sources, page.latex),
        towers=page.towers,
        programs={},
        module=catalogue_module(NAME, page.title, ()),
        textbook=dict,
    )
