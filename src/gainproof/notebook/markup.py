"""Relations and sentences with LaTeX between dollar signs, as notebooks set it."""

from __future__ import annotations

import functools
import html
import re
from collections.abc import Callable, Mapping

from gainproof.formulas.formula_latex import formula_latex, indexed
from gainproof.formulas.prose import latex_math, pieces
from gainproof.formulas.relation_text import Writer, relation_lines
from gainproof.pages.lecture import count, model_sentence
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.pages.lecture_latex import MODEL_FIELDS, MODEL_SYMBOLS, matrix_latex
from gainproof.subjects.derived import Derived, DerivedStep

Marks = Mapping[str, str]
_IN_WORDS = "\0"
"""Before a line without formulas."""
_MARKDOWN = re.compile(r"([\\`*_<>\[\]$|#])")


def markdown_escaped(text: str) -> str:
    """Words that Markdown shows as they are."""
    return _MARKDOWN.sub(r"\\\1", text)


def html_escaped(text: str) -> str:
    """Words that HTML shows as they are; a dollar sign would begin a formula."""
    return html.escape(text).replace("$", "&#36;")


def sentence(
    text: str,
    symbols: Mapping[str, str],
    known: Mapping[str, int],
    escaped: Callable[[str], str],
) -> str:
    """A sentence with its formulas set and the numbers of the steps that it refers to."""
    found = []
    for kind, part in pieces(text):
        if kind == "formula":
            math = latex_math(part, symbols)
            # in HTML a sign such as < must not begin an element
            found.append(f"${html.escape(math, quote=False) if escaped is html_escaped else math}$")
        else:
            found.append(str(known.get(part, part)) if kind == "step" else escaped(part))
    return "".join(found)


def _writer(symbols: Mapping[str, str]) -> Writer:
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


def relation(step: DerivedStep, symbols: Mapping[str, str]) -> list[tuple[bool, str]]:
    """The lines of a step: LaTeX, or, where the first entry is true, words with formulas in
    backticks.
    """
    lines = relation_lines(step.kind, step.claim, _writer(symbols))
    return [(line.startswith(_IN_WORDS), line.removeprefix(_IN_WORDS)) for line in lines]


def step_latex(step: DerivedStep, symbols: Mapping[str, str]) -> str:
    """The formulas of a step as one display; words are set upright."""
    rows = [
        rf"\text{{{line.replace('`', '')}}}" if words else line
        for words, line in relation(step, symbols)
    ]
    return display(rows)


def display(rows: list[str]) -> str:
    """Formulas below each other, in dollar signs."""
    body = r" \\ ".join(rows)
    return f"$${body}$$" if len(rows) == 1 else rf"$$\begin{{gathered}}{body}\end{{gathered}}$$"


def lines_of(item: Item, symbols: Mapping[str, str], escaped: Callable[[str], str]) -> list[str]:
    """The formulas of an item, each on a line of its own, as a notebook sets it."""
    return [
        sentence(line, symbols, {}, escaped)
        if words
        else f"$${html.escape(line, quote=False) if escaped is html_escaped else line}$$"
        for step in item.steps
        for words, line in relation(step, symbols)
    ]


def model_lines(derived: Derived, escaped: Callable[[str], str]) -> list[str]:
    """What the matrices of the scaled model are, and then they; nothing without a model."""
    if derived.model is None:
        return []
    shown = [
        f"{label} = {matrix_latex(derived.model[field], derived.symbols)}"
        for label, field in MODEL_FIELDS
    ]
    lead = sentence(
        model_sentence(derived.model), {**MODEL_SYMBOLS, **derived.symbols}, {}, escaped
    )
    return [lead, "$$" + r", \quad ".join(shown) + "$$"]


def derived_html(derived: Derived, marks: Marks) -> str:
    """A derivation as HTML with LaTeX in it, each step with the checker's word."""
    found = items(derived.steps)
    known = numbers(found)
    parts = [
        f"<h2>{html_escaped(derived.title)}</h2>",
        f"<p>{sentence(derived.opening, derived.symbols, known, html_escaped)}</p>",
        *(f"<p>{line}</p>" for line in model_lines(derived, html_escaped)),
    ]
    for item in found:
        if item.first.heading:
            parts.append(f"<h3>{html_escaped(item.first.heading)}</h3>")
        said, why = (
            sentence(text, derived.symbols, known, html_escaped)
            for text in (item.first.sentence, item.first.reason)
        )
        formulas = "".join(
            f"<div>{line}</div>" for line in lines_of(item, derived.symbols, html_escaped)
        )
        mark = f" <em>[{html_escaped(item.mark(marks))}]</em>"
        parts.append(f"<p><b>{item.number}.</b> {said}</p>{formulas}<p>{why}{mark}</p>")
    tally = count(marks[step.id] for step in derived.steps)
    parts.append(f"<p>{len(derived.steps)} steps: {html_escaped(tally)}.</p>")
    return "\n".join(parts)


def derived_latex(derived: Derived) -> str:
    """The relations that are shown, below each other, without words."""
    rows = [
        line
        for step in derived.steps
        if step.shown and step.kind not in {"definition", "cited"}
        for words, line in relation(step, derived.symbols)
        if not words
    ]
    return display(rows) if rows else ""
