"""A derivation as a lecture page: model, then numbered steps with formula, reason and mark."""

from __future__ import annotations

import functools
import textwrap
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from typing import Any

from gainproof.derived import Derived, DerivedStep
from gainproof.formula_block import marked_matrix, matrix_rows, set_formula
from gainproof.formula_text import formula_text, plain_name
from gainproof.page import WIDTH
from gainproof.relation_text import Writer, relation_lines

INDENT = "     "


def page(
    derived: Derived, report: Mapping[str, Any], *, with_steps: bool = True, columns: int = WIDTH
) -> str:
    """The page as text, its lines of at most `columns` where a formula allows it. `report`: what
    the checker says of the subject's certificate.
    """
    marks = marks_of(report)
    names = {name: plain_name(latex) for name, latex in derived.symbols.items()}
    writer = Writer(names, functools.partial(formula_text, matrix=marked_matrix))
    parts = [heading(derived.title)]
    if derived.opening:
        parts.append(textwrap.fill(derived.opening, columns))
    if derived.model is not None:
        parts.append(model_text(derived.model, names))
    shown = [step for step in derived.steps if step.shown]
    if with_steps:
        parts += [step_text(i, step, writer, marks, columns) for i, step in enumerate(shown, 1)]
    else:
        parts.append(results(derived, writer, marks, columns))
    parts.append(textwrap.fill(closing(derived, report), columns))
    return "\n\n".join(parts) + "\n"


def heading(title: str) -> str:
    """A title underlined."""
    return f"{title}\n{'=' * len(title)}"


def model_text(model: Mapping[str, Any], names: Mapping[str, str]) -> str:
    """The matrices of a scaled model side by side with their names.

    The deviation that is 1 is called as sources call it: sigma_v of the only measurement, sigma_o
    of the position where other entries are measured too.
    """
    unit = "sigma_v" if len(model["measurement"]) == 1 else "sigma_o"
    lines = [f"In units T = 1 and {unit} = 1, with process noise q Q0 and q = Lambda^2:", ""]
    for label, field in (
        ("F", "transition"),
        ("Q0", "process_noise"),
        ("H", "measurement"),
        ("R", "measurement_noise"),
    ):
        rows = matrix_rows([[_entry(entry, names) for entry in row] for row in model[field]])
        for i, row in enumerate(rows):
            lines.append(f"{INDENT}{label + ' =' if i == 0 else '':>4} {row}")
    return "\n".join(lines)


def _entry(entry: Any, names: Mapping[str, str]) -> str:
    """A number as it is, an expression over the model's parameters as a formula."""
    return entry if isinstance(entry, str) else formula_text(entry, names)


def step_text(
    number: int, step: DerivedStep, writer: Writer, marks: Mapping[str, str], columns: int
) -> str:
    """One numbered step: the sentence, the formula, the reason, and how it is known."""
    mark = marks[step.id]
    first = f"{number:>3}. "
    lines = [textwrap.fill(step.sentence, columns, initial_indent=first, subsequent_indent=INDENT)]
    lines.append("")
    for formula in relation_lines(step.kind, step.claim, writer):
        lines += display(formula, columns)
    lines += ["", *reason_lines(step.reason, f"[{mark}]", columns)]
    return "\n".join(lines)


def reason_lines(reason: str, mark: str, columns: int) -> list[str]:
    """The reason, and the mark at the right edge of its last line."""
    lines = textwrap.wrap(reason, columns - len(INDENT)) or [""]
    room = columns - len(INDENT) - len(mark)
    if len(lines[-1]) + 2 > room:
        lines.append("")
    lines[-1] = f"{lines[-1]:<{room}}{mark}"
    return [INDENT + line for line in lines]


def display(formula: str, columns: int) -> list[str]:
    """A formula set in from the margin."""
    indent = INDENT + "   "
    return [indent + line for line in set_formula(formula, columns - len(indent))]


def results(derived: Derived, writer: Writer, marks: Mapping[str, str], columns: int) -> str:
    """The relations alone, without sentences."""
    lines = []
    for step in derived.steps:
        if step.shown and step.kind not in {"definition", "cited"}:
            lines.append(f"{step.id}  [{marks.get(step.id, 'not checked')}]")
            for formula in relation_lines(step.kind, step.claim, writer):
                lines += display(formula, columns)
    return "\n".join(lines)


def marks_of(report: Mapping[str, Any]) -> Mapping[str, str]:
    """The checker's word on each step by id; `not checked` for all it was not asked about."""
    marks = {entry["id"]: entry["status"] for entry in report["statements"]}
    return defaultdict(lambda: "not checked", marks)


def closing(derived: Derived, report: Mapping[str, Any]) -> str:
    """How many steps are known in which way, the hidden ones included."""
    marks = marks_of(report)
    tally = count(marks[step.id] for step in derived.steps)
    hidden = sum(not step.shown for step in derived.steps)
    more = f" ({hidden} of them not shown)" if hidden else ""
    lines = [
        f"{len(derived.steps)} steps{more}: {tally}, by the checker that uses no computer algebra."
    ]
    if not report["accepted"]:
        lines.append(f"The certificate is REJECTED: {report['reason']}.")
    if derived.sources:
        lines.append(f"`gainproof cite {derived.name}` names the works this rests on.")
    return " ".join(lines)


def count(words: Iterable[str]) -> str:
    """`12 proved, 1 cited`, the most frequent first."""
    ordered = sorted(Counter(words).items(), key=lambda item: (-item[1], item[0]))
    return ", ".join(f"{number} {word}" for word, number in ordered)
