"""A derivation as a LaTeX document of class article; it needs amsmath and nothing of ours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.derived import Derived, DerivedStep
from gainproof.formula_latex import formula_latex
from gainproof.lecture import count, marks_of
from gainproof.relation_text import Writer, relation_lines

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
        formula_latex,
        words=lambda text: rf"\text{{{escaped(text)}}}",
        plain=lambda text: rf"\parbox{{0.85\linewidth}}{{\raggedright {escaped(text)}}}",
        tends=r"\to",
        infinity=r"\infty",
    )
    shown = [step for step in derived.steps if step.shown]
    tally = count(marks[step.id] for step in derived.steps)
    parts = [
        r"\documentclass{article}",
        r"\usepackage{amsmath}",
        r"\allowdisplaybreaks",
        rf"\title{{{escaped(derived.title)}}}",
        r"\author{}",
        r"\date{}",
        r"\begin{document}",
        r"\maketitle",
        escaped(derived.opening),
        *([_model(derived.model, derived.symbols)] if derived.model is not None else []),
        r"\begin{enumerate}",
        *(_step(step, writer, marks) for step in shown),
        r"\end{enumerate}",
        escaped(f"{len(derived.steps)} steps: {tally}."),
        r"\end{document}",
    ]
    return "\n".join(parts) + "\n"


def escaped(text: str) -> str:
    """Plain text with LaTeX's special characters made printable."""
    return "".join(_SPECIAL.get(character, character) for character in text)


def _step(step: DerivedStep, writer: Writer, marks: Mapping[str, str]) -> str:
    lines = relation_lines(step.kind, step.claim, writer)
    display = "\\\\\n".join(rf"&{line}" for line in lines)
    mark = escaped(marks[step.id])
    return (
        f"\\item {escaped(step.sentence)}\n"
        f"\\begin{{align*}}\n{display}\n\\end{{align*}}\n"
        f"{escaped(step.reason)} \\hfill [{mark}]"
    )


def _model(model: Mapping[str, Any], names: Mapping[str, str]) -> str:
    shown = ", \\quad ".join(
        f"{label} = {_matrix(model[field], names)}" for label, field in MODEL_FIELDS
    )
    unit = r"\sigma_v" if len(model["measurement"]) == 1 else r"\sigma_o"
    lead = rf"In units $T = 1$, ${unit} = 1$, with process noise $q Q_0$ and $q = \Lambda^2$:"
    return f"{lead}\n\\[\n{shown}\n\\]"


def _matrix(rows: Sequence[Sequence[Any]], names: Mapping[str, str]) -> str:
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
