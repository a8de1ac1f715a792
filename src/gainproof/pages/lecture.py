"""A derivation as a lecture page: model, then numbered steps with formula, reason and mark."""

from __future__ import annotations

import functools
import textwrap
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from typing import Any

from gainproof.formulas.formula_block import marked_matrix, matrix_rows, set_formula
from gainproof.formulas.formula_text import formula_text, indexed, plain_name
from gainproof.formulas.prose import numbered, plain_prose, wrapped
from gainproof.formulas.relation_text import Writer, relation_lines
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.subjects.derived import Derived
from gainproof.terminal_text import WIDTH

INDENT = "     "


def page(
    derived: Derived, report: Mapping[str, Any], *, with_steps: bool = True, columns: int = WIDTH
) -> str:
    """The page as text, its lines of at most `columns` where a formula allows it. `report`: what
    the checker says of the subject's certificate.
    """
    marks = marks_of(report)
    names = {name: plain_name(latex) for name, latex in derived.symbols.items()}
    writer = Writer(
        names, functools.partial(formula_text, matrix=marked_matrix, at=indexed), plain=plain_prose
    )
    parts = [heading(derived.title)]
    if derived.opening:
        parts.append(textwrap.fill(derived.opening, columns))
    if derived.model is not None:
        parts.append(model_text(derived.model, names, columns))
        parts += [
            strength_text(item, writer, columns)
            for item in items(derived.steps)
            if item.first.id == "index"
        ]
    if with_steps:
        found = items(derived.steps)
        for item in found:
            if item.first.heading:
                parts.append(heading(item.first.heading, "-"))
            parts.append(item_text(item, numbers(found), writer, marks, columns))
    else:
        parts.append(results(derived, writer, marks, columns))
    parts.append(textwrap.fill(closing(derived, report), columns))
    return "\n\n".join(parts) + "\n"


def heading(title: str, line: str = "=") -> str:
    """A title underlined."""
    return f"{title}\n{line * len(title)}"


def model_sentence(model: Mapping[str, Any]) -> str:
    """What the matrices of a scaled model are.

    The deviation that is 1 is called as sources call it: sigma_v of the only measurement, sigma_o
    of the position where other entries are measured too.
    """
    unit = "sigma_v" if len(model["measurement"]) == 1 else "sigma_o"
    return (
        "The model, with the sampling interval and the standard deviation of the measured position "
        f"as units (`T = 1`, `{unit} = 1`): transition `F`, measurement matrix `H`, measurement "
        "noise of covariance `R`, and process noise of covariance `Lambda^2 Q0`, where `Lambda` is "
        "the tracking index."
    )


def model_text(model: Mapping[str, Any], names: Mapping[str, str], columns: int) -> str:
    """The matrices of a scaled model below each other, with their names."""
    lines = [*wrapped(model_sentence(model), columns), ""]
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


def strength_text(item: Item, writer: Writer, columns: int) -> str:
    """What the tracking index is: the root of the strength that the model is written with."""
    lead = "The square of the tracking index is the strength of the process noise in these units:"
    return "\n".join([*wrapped(lead, columns), "", *formula_lines(item, writer, columns)])


def _entry(entry: Any, names: Mapping[str, str]) -> str:
    """A number as it is, an expression over the model's parameters as a formula."""
    return entry if isinstance(entry, str) else formula_text(entry, names)


def item_text(
    item: Item,
    known: Mapping[str, int],
    writer: Writer,
    marks: Mapping[str, str],
    columns: int,
) -> str:
    """One numbered item: the sentence, the formulas, the reason, and how they are known. `known`:
    the numbers of steps by id.
    """
    sentence = numbered(item.first.sentence, known)
    lines = [*wrapped(sentence, columns, f"{item.number:>3}. ", INDENT), ""]
    lines += formula_lines(item, writer, columns)
    reason = numbered(item.first.reason, known)
    lines += ["", *reason_lines(reason, f"[{item.mark(marks)}]", columns)]
    return "\n".join(lines)


def formula_lines(item: Item, writer: Writer, columns: int) -> list[str]:
    """The formulas of an item, with a blank line beside those that take several lines."""
    lines: list[str] = []
    before = 0
    for step in item.steps:
        for formula in relation_lines(step.kind, step.claim, writer):
            words = step.kind == "cited"
            shown = (quoted if words else display)(formula, columns)
            if before and before + len(shown) > 2 and not words:
                lines.append("")
            lines += shown
            before = len(shown)
    return lines


def reason_lines(reason: str, mark: str, columns: int) -> list[str]:
    """The reason, and the mark at the right edge of its last line."""
    lines = wrapped(reason, columns - len(INDENT)) or [""]
    marked = textwrap.wrap(mark, columns - len(INDENT))
    room = columns - len(INDENT) - len(marked[0])
    if len(marked) > 1 or len(lines[-1]) + 2 > room:
        lines.append("")
    lines[-1] = f"{lines[-1]:<{room}}{marked[0]}"
    return [INDENT + line for line in [*lines, *marked[1:]]]


def display(formula: str, columns: int) -> list[str]:
    """A formula set in from the margin."""
    indent = INDENT + "   "
    return [indent + line for line in set_formula(formula, columns - len(indent))]


def quoted(text: str, columns: int) -> list[str]:
    """Words set in from the margin like a formula."""
    indent = INDENT + "   "
    return textwrap.wrap(text, columns, initial_indent=indent, subsequent_indent=indent + "    ")


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
    held = "the certificate that `gainproof generate` writes holds all"
    more = f" ({hidden} of them not shown; {held})" if hidden else ""
    lines = [
        f"{len(derived.steps)} steps{more}: {tally}, by the checker that uses no computer algebra."
    ]
    if not report["accepted"]:
        lines.append(
            f"The certificate is too long for the checker, {report['reason']}: write the numbers "
            "of the model with fewer digits."
            if report["given_up"]
            else f"The certificate is REJECTED: {report['reason']}."
        )
    if derived.sources:
        lines.append(f"`gainproof cite {derived.name}` names the works this rests on.")
    return " ".join(lines)


def count(words: Iterable[str]) -> str:
    """`12 proved, 1 cited`, the most frequent first."""
    ordered = sorted(Counter(words).items(), key=lambda item: (-item[1], item[0]))
    return ", ".join(f"{number} {word}" for word, number in ordered)
