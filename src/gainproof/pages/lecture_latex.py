"""A derivation as a LaTeX document of class article; it needs amsmath and nothing of ours."""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.formulas.formula_latex import formula_latex, indexed
from gainproof.formulas.latex_display import aligned
from gainproof.formulas.prose import latex_math, latex_prose, numbered
from gainproof.formulas.relation_text import Writer, relation_lines
from gainproof.pages.lecture import count, marks_of, model_sentence
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.subjects.derived import Derived

_SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "^": r"\^{}",
    "~": r"\~{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
}
MODEL_SYMBOLS = {"lambda": r"\Lambda", "v": r"\sigma_v", "o": r"\sigma_o"}
MODEL_FIELDS = (
    ("F", "transition"),
    ("Q_0", "process_noise"),
    ("H", "measurement"),
    ("R", "measurement_noise"),
)


def document(derived: Derived, report: Mapping[str, Any]) -> str:
    """The whole document. `report`: what the checker says of the subject's certificate."""
    marks = marks_of(report)
    writer = Writer(
        derived.symbols,
        functools.partial(formula_latex, at=indexed),
        words=lambda text: rf"\text{{{escaped(text)}}}",
        plain=lambda text: (
            r"\parbox{0.85\linewidth}{\raggedright "
            f"{latex_prose(text, derived.symbols, escaped)}}}"
        ),
        math=lambda text: latex_math(text, derived.symbols),
        tends=r"\to",
        infinity=r"\infty",
        at_least=r"\geq",
    )
    found = items(derived.steps)
    tally = count(marks[step.id] for step in derived.steps)
    parts = [
        r"\documentclass{article}",
        r"\usepackage{amsmath}",
        r"\usepackage[margin=25mm]{geometry}",
        # names with hyphens leave few places to break a line: gaps may become wide instead
        r"\setlength{\emergencystretch}{4em}",
        r"\allowdisplaybreaks",
        rf"\title{{{escaped(derived.title)}}}",
        r"\author{}",
        r"\date{}",
        r"\begin{document}",
        r"\maketitle",
        latex_prose(derived.opening, derived.symbols, escaped) + "\n",
        *([_model(derived.model, derived.symbols)] if derived.model is not None else []),
        *(_item(item, numbers(found), writer, derived.symbols, marks) for item in found),
        r"\end{enumerate}",
        escaped(f"{len(derived.steps)} steps: {tally}."),
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def escaped(text: str) -> str:
    """Plain text with LaTeX's special characters made printable."""
    return "".join(_SPECIAL.get(character, character) for character in text)


def _item(
    item: Item,
    known: Mapping[str, int],
    writer: Writer,
    symbols: Mapping[str, str],
    marks: Mapping[str, str],
) -> str:
    lines = [line for s in item.steps for line in relation_lines(s.kind, s.claim, writer)]
    sentence, reason = (
        latex_prose(numbered(text, known), symbols, escaped)
        for text in (item.first.sentence, item.first.reason)
    )
    return (
        f"{_opening(item)}\\item {sentence}\n"
        f"\\begin{{align*}}\n{aligned(lines)}\n\\end{{align*}}\n"
        f"{reason} \\hfill [{escaped(item.mark(marks))}]"
    )


def _opening(item: Item) -> str:
    """Before a new part: its title, between two lists whose numbers go on."""
    if item.number > 1 and not item.first.heading:
        return ""
    ending = "\\end{enumerate}\n" if item.number > 1 else ""
    title = rf"\section*{{{escaped(item.first.heading)}}}" if item.first.heading else ""
    return f"{ending}{title}\n\\begin{{enumerate}}\\setcounter{{enumi}}{{{item.number - 1}}}\n"


def _model(model: Mapping[str, Any], names: Mapping[str, str]) -> str:
    shown = ", \\quad ".join(
        f"{label} = {matrix_latex(model[field], names)}" for label, field in MODEL_FIELDS
    )
    lead = latex_prose(model_sentence(model), {**MODEL_SYMBOLS, **names}, escaped)
    return f"{lead}\n\\[\n{shown}\n\\]"


def matrix_latex(rows: Sequence[Sequence[Any]], names: Mapping[str, str]) -> str:
    """Numbers as they are, expressions over the model's parameters as formulas."""
    texts = [
        [
            formula_latex(
                {"nodes": [["number", entry]], "outputs": {"value": 0}}
                if isinstance(entry, str)
                else entry,
                names,
            )
            for entry in row
        ]
        for row in rows
    ]
    body = r" \\ ".join(" & ".join(row) for row in texts)
    return rf"\begin{{pmatrix}}{body}\end{{pmatrix}}"
