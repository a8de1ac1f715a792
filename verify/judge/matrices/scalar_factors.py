"""Factors of one row and one column in a word: each is its own transpose, and neighbours commute.

    f = f',   f g = (f g)' = g' f' = g f

Such a factor begins and ends where a word has one row or column; letters of other sizes are never
moved: what is between n by n matrices stays there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from gainproof.verify.judge.matrices.polynomial import Word, turned
from gainproof.verify.judge.matrices.size import ONE, Shape


def factors(word: Word, shapes: Sequence[Shape]) -> list[int]:
    """The places at which factors of one row and column begin, and where the last one ends."""
    cuts = [
        at
        for at, letter in enumerate(word)
        if shapes[letter >> 1][letter & 1] == ONE  # rows of a letter, columns of its transpose
    ]
    if word and shapes[word[-1] >> 1][1 - (word[-1] & 1)] == ONE:
        cuts.append(len(word))
    return cuts


def without_transposes(word: Word, symmetric: set[int]) -> Word:
    """The word with symmetric letters as they are."""
    return tuple(n - 1 if n & 1 and n >> 1 in symmetric else n for n in word)


def rank(word: Word, base: Mapping[int, int]) -> tuple[tuple[int, ...], Word]:
    """What neighbours are sorted by: a letter stands beside its inverse."""
    return tuple(base.get(n >> 1, n >> 1) for n in word), word


def settled(
    word: Word, cuts: Sequence[int], symmetric: set[int], base: Mapping[int, int]
) -> list[Word]:
    """The factors, each or its transpose, sorted."""
    pieces = [word[i:j] for i, j in pairwise(cuts)]
    best = [min(p, without_transposes(turned(p), symmetric)) for p in pieces]
    return sorted(best, key=lambda piece: rank(piece, base))


def side_by_side(word: Word, one: int, other: int, shapes: Sequence[Shape]) -> Word | None:
    """The same word, factors moved and transposed, with a column at one place followed by its
    transpose, or that of another column, at the other place: (p v) (q w) = p v w' q'. None if they
    cannot be brought together.
    """
    cuts = factors(word, shapes)
    if len(cuts) < 2:
        return None
    head, tail = word[: cuts[0]], word[cuts[-1] :]
    pieces = [word[i:j] for i, j in pairwise(cuts)]
    where = [
        next((n for n, (i, j) in enumerate(pairwise(cuts)) if i <= at < j), None)
        for at in (one, other)
    ]
    rest = [n for at, piece in enumerate(pieces) if at not in where for n in piece]
    if where[0] is None and where[1] is not None and one == cuts[0] - 1:
        return (*head, *_begun(pieces[where[1]], word[other]), *rest, *tail)
    if where[1] is None and where[0] is not None and other == cuts[-1]:
        return (*head, *rest, *turned(_begun(pieces[where[0]], word[one])), *tail)
    if where[0] is None or where[1] is None or where[0] == where[1]:
        return None
    first = turned(_begun(pieces[where[0]], word[one]))
    return (*head, *rest, *first, *_begun(pieces[where[1]], word[other]), *tail)


def _begun(piece: Word, letter: int) -> Word:
    """The factor or its transpose, so that it begins with the transpose of a column."""
    return piece if piece[0] == letter and letter & 1 else turned(piece)
