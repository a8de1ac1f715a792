"""A page for each derivation: every step with formula, sentence, reason and the checker's word."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from gainproof.book import play
from gainproof.book.mathematics import displayed
from gainproof.book.page import Finding, Page
from gainproof.book.prose_html import prose
from gainproof.formulas.formula_latex import formula_latex, indexed
from gainproof.formulas.prose import latex_math, plain_prose
from gainproof.formulas.relation_text import Writer, relation_lines
from gainproof.pages.lecture import count, marks_of, model_sentence
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.pages.lecture_latex import MODEL_FIELDS, MODEL_SYMBOLS, matrix_latex
from gainproof.subjects.derived import Derived, DerivedStep

_IN_WORDS = "\0"
"""Before a line without formulas, so that it is not taken for LaTeX."""


@dataclass(frozen=True)
class ShownStep:
    """One step: its id, its formulas or words, the checker's word and how it was decided."""

    id: str
    formulas: tuple[Markup, ...]
    status: str
    how: str


@dataclass(frozen=True)
class Mark:
    """The checker's word on some steps, and how they were decided."""

    status: str
    how: str
    ids: tuple[str, ...]


@dataclass(frozen=True)
class ShownItem:
    """One number of the page, and the title of the part that it opens, if it does."""

    number: int
    heading: str
    sentence: Markup
    reason: Markup
    steps: tuple[ShownStep, ...]
    marks: tuple[Mark, ...]


def address(name: str) -> str:
    """Where the page of a derivation lies."""
    return f"derivations/{name}.html"


def derivation_page(derived: Derived, report: Mapping[str, Any], kernels: Sequence[Any]) -> Page:
    """The page. `report`: what the checker says of the committed certificate; `kernels`: (name,
    summary, path of the page) of each.
    """
    marks = marks_of(report)
    writer = writer_of(derived.symbols)
    found = items(derived.steps)
    known = numbers(found)
    shown = [_item(item, known, derived, writer, marks) for item in found]
    hidden = [_step(step, writer, marks) for step in derived.steps if not step.shown]
    game = play.section(derived)
    return Page(
        path=address(derived.name),
        title=derived.title,
        kind="derivation",
        template="derivation.html",
        data={
            "derived": derived,
            "opening": prose(derived.opening, derived.symbols),
            "model": _model(derived),
            "items": shown,
            "hidden": hidden,
            "tally": count(marks[step.id] for step in derived.steps),
            "steps": len(derived.steps),
            "accepted": bool(report["accepted"]),
            "reason": report["reason"],
            "seconds": sum(entry["seconds"] for entry in report["statements"]),
            "kernels": kernels,
            "play": game.html if game is not None else None,
        },
        findings=(
            Finding(derived.title, f"{derived.name} {plain_prose(derived.opening)}"),
            *(
                Finding(
                    f"{derived.title}, step {item.number}",
                    plain_prose(f"{item.first.heading} {item.first.sentence} {item.first.reason}"),
                    f"step-{item.first.id}",
                )
                for item in found
            ),
        ),
        scripts=tuple(name for name, _ in game.scripts) if game is not None else (),
    )


def writer_of(symbols: Mapping[str, str]) -> Writer:
    """Formulas as LaTeX and words as text in it."""
    return Writer(
        symbols,
        functools.partial(formula_latex, at=indexed),
        words=lambda text: rf"\text{{{text}}}",
        plain=lambda text: f"{_IN_WORDS}{text}",
        math=lambda text: latex_math(text, symbols),
        tends=r"\to",
        infinity=r"\infty",
        at_least=r"\geq",
    )


def _item(
    item: Item,
    known: Mapping[str, int],
    derived: Derived,
    writer: Writer,
    marks: Mapping[str, str],
) -> ShownItem:
    steps = tuple(_step(step, writer, marks) for step in item.steps)
    return ShownItem(
        item.number,
        item.first.heading,
        prose(item.first.sentence, derived.symbols, known),
        prose(item.first.reason, derived.symbols, known),
        steps,
        _marks(steps),
    )


def _marks(steps: Sequence[ShownStep]) -> tuple[Mark, ...]:
    """One for all steps that are known in the same way."""
    ids: dict[tuple[str, str], list[str]] = {}
    for step in steps:
        ids.setdefault((step.status, step.how), []).append(step.id)
    return tuple(Mark(status, how, tuple(names)) for (status, how), names in ids.items())


def _step(step: DerivedStep, writer: Writer, marks: Mapping[str, str]) -> ShownStep:
    return ShownStep(step.id, tuple(formulas_of(step, writer)), marks[step.id], _how(step.kind))


def formulas_of(step: DerivedStep, writer: Writer) -> list[Markup]:
    """Formulas set; what is words stays words."""
    return [
        prose(line.removeprefix(_IN_WORDS), writer.names)
        if line.startswith(_IN_WORDS)
        else displayed(line)
        for line in relation_lines(step.kind, step.claim, writer)
    ]


def _model(derived: Derived) -> Mapping[str, Any] | None:
    if derived.model is None:
        return None
    names = {**MODEL_SYMBOLS, **derived.symbols}
    return {
        "sentence": prose(model_sentence(derived.model), names),
        "matrices": [
            displayed(f"{label} = {matrix_latex(derived.model[field], derived.symbols)}")
            for label, field in MODEL_FIELDS
        ],
    }


_BY_COMBINATION = (
    "each entry is expanded as a polynomial and is the combination of the defining equations that "
    "the certificate holds"
)
_WORDS_IN_LETTERS = "words in letters that do not commute, for every size of the matrices"
_HOW: Mapping[str, str] = {
    "equal": "both sides are the same element of the tower of radicals, in exact arithmetic",
    "positive": "numerator and denominator are polynomials whose coefficients show their sign",
    "same_sign": "the quotient of both sides is positive, by polynomials that show their sign",
    "limit": "leading terms at the end of the domain, exactly",
    "increasing_onto": "the derivative is positive, and the limits at both ends are exact",
    "monotone": "the sign of the derivative, exactly",
    "riccati": f"the Riccati equation and the gain: {_BY_COMBINATION}",
    "stable": "the rows of Schur and Cohn of the characteristic polynomial are positive",
    "positive_definite": "every leading minor is positive",
    "program": "the graph that the kernel is printed from has these values, in exact arithmetic",
    "sum": "induction: first term, and the step from k to k + 1, as polynomials",
    "definition": "nothing to decide: it says what a name means",
    "cited": "a published theorem, used and not proved here",
    "matrix_equal": _WORDS_IN_LETTERS,
    "matrix_order": f"a sum of squares with cofactors: {_WORDS_IN_LETTERS}",
    "matrix_invertible": f"an inverse from one side, or definiteness: {_WORDS_IN_LETTERS}",
    "matrix_trace": f"factors of a trace turned in a circle: {_WORDS_IN_LETTERS}",
}


def _how(kind: str) -> str:
    """The sentence, or the name of a kind that has none."""
    return _HOW.get(kind, kind.replace("_", " "))
