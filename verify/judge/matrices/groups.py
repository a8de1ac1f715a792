"""Few of many polynomials whose sum is a given one, found by fingerprints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.verify.judge.matrices.polynomial import PRIME, Polynomial, modulo

SALT = 7919


def groups_with_sum(value: Polynomial, parts: Sequence[Polynomial]) -> Iterator[tuple[int, ...]]:
    """Places of one, of two and of three of the parts whose sum is the value.

    A fingerprint is the same sum with numbers in the place of words, so that only groups with that
    of the value, and by chance very few others, are added up.
    """
    prints = [fingerprint(part) for part in parts]
    places: dict[int, list[int]] = {}
    for at, own in enumerate(prints):
        places.setdefault(own, []).append(at)
    goal = fingerprint(value)
    for group in _groups(goal, prints, places):
        total = value
        for at in group:
            total = total - parts[at]
        if not total.terms:
            yield group


def _groups(
    goal: int, prints: Sequence[int], places: dict[int, list[int]]
) -> Iterator[tuple[int, ...]]:
    yield from ((at,) for at in places.get(goal, ()))
    for one, own in enumerate(prints):
        rest = (goal - own) % PRIME
        yield from ((one, at) for at in places.get(rest, ()) if at > one)
    for one, own in enumerate(prints):
        for two in range(one + 1, len(prints)):
            rest = (goal - own - prints[two]) % PRIME
            yield from ((one, two, at) for at in places.get(rest, ()) if at > two)


def fingerprint(value: Polynomial) -> int:
    """The polynomial with a number for each word, modulo a prime; additive."""
    return sum(modulo(c) * hash((SALT, *word)) for word, c in value.terms.items()) % PRIME
