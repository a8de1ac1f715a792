"""A derivation as a LaTeX document of class article; it needs amsmath and nothing of ours."""

from __future__ import annotations

from collections.abc import Mapping
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
        *([_model(derived.model)] if derived.model is not None else []),
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


def _model(model: Mapping[str, object]) -> str:
    shown = ", \\quad ".join(f"{label} = {_matrix(model[field])}" for label, field in MODEL_FIELDS)
    lead = r"In units $T = 1$, $\sigma_v = 1$, with process noise $q Q_0$ and $q = \Lambda^2$:"
    return f"{lead}\n\\[\n{shown}\n\\]"


def _matrix(rows: object) -> str:
    graph_rows = rows if isinstance(rows, list) else []
    nodes: list[list[object]] = [["number", entry] for row in graph_rows for entry in row]
    nodes.append(["matrix", len(graph_rows), len(graph_rows[0]), *range(len(nodes))])
    return formula_latex({"nodes": nodes, "outputs": {"value": len(nodes) - 1}}, {})
