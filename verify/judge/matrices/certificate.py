"""Proofs as certificates of `gainproof.verify.certificate.matrix_words`, which decides them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from gainproof.verify.certificate.matrix_words.proof import rejected
from gainproof.verify.judge.matrices.known_equations import Book

__all__ = ["accepted", "rejected", "written"]


def accepted(book: Book, rests: bool = False) -> tuple[dict[str, Any], str | None]:
    """The proof with what it was asked for, and why the checker does not accept it if so; `rests`:
    whether it supposes what other proofs show, or leaves out a definition.
    """
    certificate = written(book)
    fault = rejected(certificate)
    asked = book.asked and {**book.asked, "rests": rests, "sizes": book.alphabet.sizes_named()}
    return {**certificate, "asked": asked}, fault


def written(book: Book) -> dict[str, Any]:
    """Setting and statements as plain data: those that were asked for, that each inverse which is
    spoken of exists, and what these rest on.
    """
    wanted = set(book.goals)
    kept: list[Mapping[str, Any]] = []
    for statement in reversed(book.statements):
        if statement["id"] in wanted or statement["kind"] == "matrix_invertible":
            wanted |= set(_texts(statement["evidence"]))
            kept.append(statement)
    kept.reverse()
    return {"setting": _setting(book, kept), "statements": kept}


def _setting(book: Book, statements: list[Mapping[str, Any]]) -> dict[str, Any]:
    """The letters that are spoken of, and those that they are made of."""
    alphabet = book.alphabet
    names = {name: number for number, name in enumerate(alphabet.names)}
    spoken = {
        names[text.removesuffix("'")]
        for text in _texts(statements)
        if text.removesuffix("'") in names
    }
    waiting = list(spoken)
    while waiting:
        number = waiting.pop()
        more = {alphabet.base[number]} if number in alphabet.base else set()
        if number in alphabet.elements:
            more |= {each // 2 for word in alphabet.elements[number].terms for each in word}
        if number in alphabet.place:
            more |= set(alphabet.blocks[alphabet.place[number][0]])
        waiting += more - spoken
        spoken |= more
    size = alphabet.size_name
    units = {text for text in _texts(statements) if text.startswith("unit_")}
    return {
        "parameters": [],
        "matrices": {
            alphabet.names[n]: [size(alphabet.shapes[n][0]), size(alphabet.shapes[n][1])]
            for n in sorted(spoken)
        },
        "units": {name: name.removeprefix("unit_") for name in sorted(units)},
        "blocks": {
            size(whole): [alphabet.names[n] for n in numbers]
            for whole, numbers in alphabet.blocks.items()
            if numbers[0] in spoken
        },
        "elements": {
            alphabet.names[n]: book.data(value)
            for n, value in alphabet.elements.items()
            if n in spoken
        },
        "inverses": {
            alphabet.names[n]: alphabet.names[base]
            for n, base in alphabet.base.items()
            if n in spoken
        },
    }


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for inner in value.values():
            yield from _texts(inner)
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from _texts(inner)
