"""Cofactors of one equation put together, so that a certificate has few of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gainproof.derive.words.polynomial import Polynomial
from gainproof.derive.words.rewriting import Cofactor, Words


def gathered(cofactors: Sequence[Cofactor], words: Words) -> list[Cofactor]:
    """Cofactors of one source with one right factor are one."""
    by_right: dict[tuple[Any, ...], Cofactor] = {}
    for cofactor in cofactors:
        for (word, powers), coefficient in cofactor.right.terms.items():
            key = (cofactor.source, cofactor.flipped, word)
            scale = Polynomial({((), powers): coefficient}, None)
            single = words(word, cofactor.right.shape or ("", ""))
            left = scale @ cofactor.left
            if key in by_right:
                left = left + by_right[key].left
            by_right[key] = Cofactor(cofactor.source, cofactor.flipped, left, single)
    return _by_left(list(by_right.values()))


def _by_left(cofactors: Sequence[Cofactor]) -> list[Cofactor]:
    """Cofactors of one source with one left factor are one."""
    by_left: dict[tuple[Any, ...], Cofactor] = {}
    for cofactor in cofactors:
        if cofactor.left.terms:
            key = (cofactor.source, cofactor.flipped, str(cofactor.left.data()))
            right = cofactor.right
            if key in by_left:
                right = right + by_left[key].right
            by_left[key] = Cofactor(cofactor.source, cofactor.flipped, cofactor.left, right)
    return list(by_left.values())
