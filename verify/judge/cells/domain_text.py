"""Where a statement holds, in words, and whether that is the whole set."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from gainproof.verify.judge.cells.cell_statement import Budget, Task
from gainproof.verify.judge.cells.cell_truth import Part, Piece, all_pieces
from gainproof.verify.judge.cells.cells_and_borders import border_parts, parts
from gainproof.verify.judge.cells.coefficient_signs import keeps_sign
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.parameter_polynomials import as_expr
from gainproof.verify.judge.cells.sign_conditions import Literal, alternatives, separating
from gainproof.verify.judge.exact.box import bounds_text
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.region_text import region_text
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.truth import FALSE, SKIPPED, TRUE
from gainproof.verify.judge.exact.work_limits import Limits, Undecided

MOST_BORDERS = 60
WITH_VALUE = "wherever it has a value"
Chain = tuple[Expr, ...]
"""The polynomials that are zero on a border, a border of this, and so on."""


def domain_text(
    task: Task,
    found: Sequence[Part],
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[str, bool]:
    """The set of truth as text; False if it may hold on more than is named."""
    texts, exact = _texts(task, found, budget, stated, labels)
    if not texts:
        return "everywhere", exact
    first = "everywhere " if texts[0].startswith("except") else "for "
    return ("" if texts[0] == WITH_VALUE else first) + ", ".join(texts), exact


def _texts(
    task: Task,
    found: Sequence[Part],
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[list[str], bool]:
    texts = bounds_text(task.boxes, labels)
    if len(task.names) < 2:
        return _line(found[0], labels), True
    if all(p.truth == SKIPPED for p in found[0].pieces):
        return _on_borders(task, found, budget, stated, labels)
    literals = separating(found[0])
    if literals is None:
        if not budget.gaps and all(p.truth != FALSE for p in all_pieces(found)):
            return [*texts, WITH_VALUE], True
        cells = alternatives(found[0], labels)
        return [*texts, cells, *apart_from_borders(found[0], labels)], False
    gaps, inside, whole = list(budget.gaps), list(found), True
    if any(p.truth == FALSE for p in found[0].pieces):
        # the borders inside the region of truth were not looked at yet
        again = Budget(_less(budget.limits))
        try:
            inside = list(parts(_within(task, literals, ">"), again, stated))
        except Undecided:
            # each of these could be a border on which it fails
            question = CellQuestion(task, budget.limits)
            gaps += [(as_expr(p, task.names), "") for p in question.borders()]
        gaps += again.gaps
    if any(p.counted and p.truth != TRUE for p in found[0].pieces):
        whole = _nowhere_else(task, literals, budget, stated)
    for k in range(len(literals)):
        text, clear = _literal_text(task, literals, k, budget, stated, labels)
        texts.append(text)
        whole = whole and clear
    used = {as_expr(p, task.names) for p, _ in literals}
    left_out, exact = exclusions(
        inside, len(task.border), used, lambda t: _nowhere(t, budget, stated), labels
    )
    texts += left_out
    texts += [f"{labelled(expr, labels)} != 0" for expr, _ in gaps if symbols_of(expr)]
    return texts, whole and exact and not gaps


def _line(part: Part, labels: Mapping[str, str]) -> list[str]:
    """The set of truth of a task with one parameter."""
    name = next(iter(part.task.names), None)
    places = [p.place for p in part.pieces if p.truth == TRUE and isinstance(p.place, Place)]
    label = labels.get(name or "", name or "")
    text = region_text(places, label)
    return [] if name is None or text == f"all real {label}" else [text]


def _on_borders(
    task: Task,
    found: Sequence[Part],
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[list[str], bool]:
    """The set of truth where the conditions hold on borders only: border by border."""
    above = len(task.border)
    if all(p.truth in (TRUE, SKIPPED) for p in all_pieces(found)):
        return bounds_text(task.boxes, labels), True
    size = max(p.dimension for p in all_pieces(found) if p.truth != SKIPPED)
    choices: dict[str, None] = {}
    whole = True
    for k, part in enumerate(found):
        chain = part.task.border
        if not any(p.truth == TRUE and p.dimension == size for p in part.pieces):
            continue
        if part.sampled:
            zero = " and ".join(f"{labelled(expr, labels)} = 0" for expr in chain[above:])
            choices[f"a part of {zero}"] = None
            whole = False
            continue
        below = [p for p in found[k:] if p.task.border[: len(chain)] == chain]
        solved = [
            f"{labels.get(name, name)} = {labelled(value, labels)}"
            for name, value in part.task.solved[len(task.solved) :]
        ]
        inner, exact = _texts(part.task, below, budget, stated, labels)
        choices[", ".join([*solved, *inner])] = None
        whole = whole and exact and above == 0
    joined = list(choices)
    # what holds on smaller borders is not named
    exact = whole and not any(p.truth == TRUE and p.dimension < size for p in all_pieces(found))
    return [joined[0] if len(joined) == 1 else " or ".join(f"({text})" for text in joined)], exact


def _nowhere_else(
    task: Task, literals: Sequence[Literal], budget: Budget, stated: frozenset[str]
) -> bool:
    """Whether it is shown that the statement holds on no thin set outside the region either."""
    return all(_nowhere(_within(task, [(p, -sign)], ">"), budget, stated) for p, sign in literals)


def _nowhere(task: Task, budget: Budget, stated: frozenset[str]) -> bool:
    """Whether it is shown that the statement holds at no point of a task."""
    again = Budget(replace(_less(budget.limits), borders=MOST_BORDERS), thorough=True)
    try:
        found = list(parts(task, again, stated))
    except Undecided:
        return False
    return not again.gaps and all(piece.truth != TRUE for piece in all_pieces(found))


def _less(limits: Limits) -> Limits:
    """The words may not take longer than the verdict."""
    return replace(limits, seconds=limits.seconds / 5)


def _within(task: Task, literals: Sequence[Literal], above: str) -> Task:
    """The task where the polynomials have their signs; `above` is > or >=."""
    below = {">": "<", ">=": "<="}[above]
    more = tuple(
        Rel(above if sign > 0 else below, as_expr(p, task.names), number(0)) for p, sign in literals
    )
    given = (*task.statement.given, *more)
    return replace(task, statement=replace(task.statement, given=given))


def _literal_text(
    task: Task,
    literals: Sequence[Literal],
    k: int,
    budget: Budget,
    stated: frozenset[str],
    labels: Mapping[str, str],
) -> tuple[str, bool]:
    """The condition, with equality where the statement holds on the border too; False if it holds
    on a part of the border, or if that is not known.
    """
    p, sign = literals[k]
    others = [literal for j, literal in enumerate(literals) if j != k]
    again = Budget(_less(budget.limits), thorough=True)
    present = {TRUE, FALSE}
    try:
        question = CellQuestion(_within(task, others, ">="), budget.limits)
        below = all_pieces(list(border_parts(question, p, again, stated)))
        if not again.gaps:
            present = {piece.truth for piece in below} - {SKIPPED}
    except Undecided:
        pass
    equal = "=" if present == {TRUE} else ""
    strict = ">" if sign > 0 else "<"
    text = f"{labelled(as_expr(p, task.names), labels)} {strict}{equal} 0"
    return text, present == {TRUE} or TRUE not in present


def exclusions(
    found: Sequence[Part],
    above: int,
    used: set[Expr],
    elsewhere: Callable[[Task], bool],
    labels: Mapping[str, str],
) -> tuple[list[str], bool]:
    """What is left out of the set of truth; False if more is left out than need be, as far as
    `elsewhere` can tell for a border: whether it holds on no smaller border of it.

    `above` is the length of the chain of the task itself; borders in `used` are named elsewhere.
    """
    texts: dict[str, None] = {}
    exact = True
    gone: set[Chain] = set()

    def here(chain: Chain) -> list[Part]:
        return [p for p in found if p.task.border[above:] == chain]

    def below(chain: Chain) -> list[Piece]:
        return all_pieces([p for p in found if p.task.border[above:][: len(chain)] == chain])

    def of_lines(chain: Chain) -> bool:
        kept = any(p.truth == TRUE for p in below(chain))
        return kept and all(_is_small(p) for p in here(chain))

    chains = {p.task.border[above:]: None for p in found if len(p.task.border) > above}
    # what is left out as a whole comes first, and is not named again point by point
    for chain in sorted(chains, key=lambda chain: (len(chain), of_lines(chain))):
        if chain[0] in used or any(chain[:k] in gone for k in range(1, len(chain) + 1)):
            continue
        whole = {link[0] for link in gone if len(link) == 1}
        kept = [p for p in below(chain) if p.truth == TRUE]
        # where it has no point but on smaller borders, these are named unless it fails on them all
        pieces = all_pieces(here(chain)) if kept else below(chain)
        if all(_lies_on(p, whole) for p in _wrong(pieces)):
            continue
        if of_lines(chain):
            told = (t for part in here(chain) for t in _of_line(part, chain, whole, labels))
            texts |= dict.fromkeys(told)
            continue
        # on a border with cells of both kinds the borders of these were not all looked at
        parts = here(chain)
        exact = (
            exact
            and not kept
            and all(p.sampled or _is_small(p) or elsewhere(p.task) for p in parts)
        )
        gone.add(chain)
        texts[_whole(chain, labels)] = None
    return list(texts), exact


def _is_small(part: Part) -> bool:
    """Whether it is a line, with all its places."""
    return len(part.task.names) < 2


def _wrong(pieces: Sequence[Piece]) -> list[Piece]:
    return [p for p in pieces if p.truth not in (TRUE, SKIPPED)]


def _lies_on(piece: Piece, borders: Iterable[Expr]) -> bool:
    """Whether it is seen that a polynomial of these is zero on a piece."""
    values = list(piece.task.solved)
    at = piece.place.at
    if at is not None and at.is_rational:
        values += [(name, number(at.low)) for name in piece.task.names[:1]]
    for border in borders:
        moved = border
        for name, value in values:
            moved = substituted(moved, {name: value})
        if tidied(moved) == number(0):
            return True
    return False


def zeros(chain: Chain, labels: Mapping[str, str]) -> str:
    """The equations of a border."""
    return " and ".join(f"{labelled(expr, labels)} = 0" for expr in chain)


def _whole(chain: Chain, labels: Mapping[str, str]) -> str:
    if len(chain) == 1:
        return f"{labelled(chain[0], labels)} != 0"
    return f"except where {zeros(chain, labels)}"


def _of_line(
    part: Part, chain: Chain, whole: Iterable[Expr], labels: Mapping[str, str]
) -> list[str]:
    """What is left out of a border with one parameter, or of a point, and lies on none of the
    borders that are left out as a `whole`.
    """
    wrong = [p for p in _wrong(part.pieces) if not _lies_on(p, whole)]
    if not wrong:
        return []
    solved, value = part.task.solved[-1]
    where = f"{labels.get(solved, solved)} = {labelled(value, labels)}"
    before = f"{zeros(chain[:-1], labels)} and {where}" if len(chain) > 1 else where
    name = next(iter(part.task.names), None)
    if name is None or len(wrong) == len([p for p in part.pieces if p.truth != SKIPPED]):
        return [f"except where {before}"]
    places = [p.place for p in wrong if isinstance(p.place, Place)]
    return [f"except where {before} and ({region_text(places, labels.get(name, name))})"]


def apart_from_borders(part: Part, labels: Mapping[str, str]) -> list[str]:
    """That nothing is said about any border."""
    if part.question is None:
        return []
    boxes = [part.task.boxes[name] for name in part.task.names]
    met = [p for p in part.question.borders() if not keeps_sign(p, boxes, closed=True)]
    borders = [labelled(as_expr(p, part.task.names), labels) for p in met]
    return [f"and none of these zero: {'; '.join(borders)}"] if borders else []
