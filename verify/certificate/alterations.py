"""Every way to alter one number or delete one field of a certificate."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.certificate.plain_data import Plain

Path = tuple[str | int, ...]

_NUMBER = re.compile(r"-?[0-9]+(?:/[1-9][0-9]*)?\Z")


@dataclass(frozen=True, slots=True)
class Alteration:
    """At ``path``: the value ``new`` in place of the old one, or None for its deletion."""

    path: Path
    how: str
    new: Plain | None

    def __str__(self) -> str:
        return f"{self.how} at {'.'.join(map(str, self.path))}"


def alterations(certificate: Plain) -> Iterator[Alteration]:
    """All alterations of one number or field.

    Numbers as text (coefficients, graph numbers, powers, model entries): plus one, sign, and the
    denominator plus one. Integers (exponents, powers, weights, node numbers): plus and minus one;
    inside a polynomial the terms are sorted again, so that not merely their order betrays the
    change. Every field of a record and every entry of a list is deleted in turn.
    """
    return _inside(certificate, (), None)


def _inside(
    value: Plain,
    path: Path,
    polynomial: tuple[Path, list[Plain]] | None,
) -> Iterator[Alteration]:
    if path:
        yield Alteration(path, "deleted", None)
    if isinstance(value, dict):
        for key, entry in value.items():
            yield from _inside(entry, (*path, key), None)
    elif isinstance(value, list):
        within = (path, value) if _is_polynomial(value) else polynomial
        for number, entry in enumerate(value):
            yield from _inside(entry, (*path, number), within)
    elif isinstance(value, int):
        for how, step in (("plus one", 1), ("minus one", -1)):
            yield _integer(path, how, value + step, polynomial)
    elif _NUMBER.match(value):
        number_ = Fraction(value)
        for how, new in (
            ("plus one", number_ + 1),
            ("sign", -number_),
            ("denominator", Fraction(number_.numerator, number_.denominator + 1)),
        ):
            if new != number_:
                yield Alteration(path, how, str(new))


def _integer(
    path: Path,
    how: str,
    new: int,
    polynomial: tuple[Path, list[Plain]] | None,
) -> Alteration:
    """An altered integer; an exponent takes its term to where the order of terms wants it."""
    if polynomial is None:
        return Alteration(path, how, new)
    place, terms = polynomial
    rest = path[len(place) :]
    if len(rest) != 3:
        return Alteration(path, how, new)
    altered = [
        replaced(term, rest[1:], new) if number == rest[0] else term
        for number, term in enumerate(terms)
    ]
    exponents = [term[1] for term in altered if isinstance(term, list)]
    ordered = sorted(zip(exponents, altered, strict=True), key=lambda pair: str(pair[0]))
    ordered.sort(key=lambda pair: pair[0] if isinstance(pair[0], list) else [], reverse=True)
    return Alteration(place, f"exponent {how}", [term for _, term in ordered])


def _is_polynomial(value: list[Plain]) -> bool:
    return bool(value) and all(
        isinstance(term, list)
        and len(term) == 2
        and isinstance(term[0], str)
        and isinstance(term[1], list)
        and all(isinstance(e, int) for e in term[1])
        for term in value
    )


def replaced(value: Plain, path: Path, new: Plain | None) -> Plain:
    """A copy with one value replaced or, for None, deleted; what is untouched is shared."""
    step, rest = path[0], path[1:]
    if isinstance(value, dict) and isinstance(step, str):
        if not rest and new is None:
            return {key: entry for key, entry in value.items() if key != step}
        return {
            key: (_deeper(entry, rest, new) if key == step else entry)
            for key, entry in value.items()
        }
    if isinstance(value, list) and isinstance(step, int):
        if not rest and new is None:
            return value[:step] + value[step + 1 :]
        return [
            _deeper(entry, rest, new) if number == step else entry
            for number, entry in enumerate(value)
        ]
    raise LookupError(f"there is no {step!r} here")


def _deeper(entry: Plain, rest: Path, new: Plain | None) -> Plain:
    if rest:
        return replaced(entry, rest, new)
    assert new is not None
    return new
