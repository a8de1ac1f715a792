"""A formula about matrices of any size as the text of a claim file.

What letters usually mean in a filter gives the sizes their names, n for the state and m for the
measurement, and says which letters are covariances; where P, H and R stand beside it, K is the gain
of a Kalman filter, and the formula is tried for any K too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from gainproof.answers.matrix_reading import (
    NUMBERED,
    MatrixReader,
    transposed_greek,
    with_mark_below,
)
from gainproof.answers.matrix_shapes import (
    NUMBER,
    ONE,
    SYMMETRIC,
    Said,
    Shapes,
    Sizes,
    base_letter,
    is_small,
    said_of,
)
from gainproof.answers.typed import Typed
from gainproof.bad_input import BadInputError
from gainproof.claims.template import FORMAT_LINE
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.kinds.catalogue import kind_of
from gainproof.verify.judge.matrices.printed_names import canonical
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex_printer import graph_to_latex, relations_to_latex

MATRICES = "matrices"
"""What `--model` says where a formula without a transpose is about matrices."""
DEFINITE, SEMIDEFINITE = "positive definite", "positive semidefinite"
ANY_SIZE = "none: about matrices of any size"
ZERO = [["number", "0"]]
_SIZES = {
    **dict.fromkeys(("P", r"\Sigma", "F", "A", r"\Phi"), ("n", "n")),
    **dict.fromkeys(("R", "S"), ("m", "m")),
    "K": ("n", "m"),
    **dict.fromkeys(("H", "C"), ("m", "n")),
    **dict.fromkeys(("G", "B", r"\Gamma"), ("n", "l")),
    "Q": ("n", "n"),
}
"""Usual names of rows and columns, the surest letters first."""
_OTHERS = "nmlpqrstuvw"
_POSTERIOR = re.compile(r"\\hat|\+|posterior|([a-z])\|\1(?![-+])")
"""Marks of an updated covariance, which is none of the Kalman gain's formula."""


@dataclass(frozen=True)
class MatrixQuestion:
    """The text of a claim file, and of each claim by id what is assumed: letter or `filter`, words,
    whether it is a guess.
    """

    text: str
    assumed: Mapping[str, tuple[tuple[str, str, bool], ...]]


def matrix_question(
    formula: str, symbols: Mapping[str, str], given: Sequence[str]
) -> MatrixQuestion:
    """The claim file that asks whether a formula holds of matrices of any size; `symbols` is what
    is said of letters, `given` are hypotheses. Raises BadInputError.
    """
    said = {
        with_mark_below(token): said_of(token, " ".join(text.split()))
        for token, text in symbols.items()
    }
    reader = MatrixReader(said, transposed_greek((formula, *given)))
    asked = reader.read(formula)
    conditions = [reader.read(each) for each in given]
    definitions = {t: reader.read(f"0 = {s.definition}") for t, s in said.items() if s.definition}
    whole = _Parts(asked, conditions, definitions, reader)
    for token in whole.tokens:
        try:
            canonical(token)
        except ReaderError as error:
            raise BadInputError(f"{token} in a formula about matrices: {error.problem}") from None
    for token in said:
        if token not in whole.tokens:
            known = ", ".join(t for t in whole.tokens if not NUMBERED.fullmatch(t)) or "none"
            raise BadInputError(f"--symbol: the formula has no {token}; its symbols: {known}")
    if all(NUMBERED.fullmatch(token) for token in whole.tokens):
        raise BadInputError("a formula about matrices needs a letter beside the identity")
    ways = [_way(whole, {})]
    filter_ = _kalman_filter(whole.tokens, said)
    if filter_:
        more = {token: reader.read(f"0 = {text}") for token, text in filter_.items()}
        try:
            way = _way(_Parts(asked, conditions, {**more, **definitions}, reader), filter_)
        except BadInputError:
            pass  # shapes do not fit: K is another gain
        else:
            ways.insert(0, way)
    return _written(ways, "definition" if _defines(whole, filter_) else kind_of(asked.formula))


@dataclass(frozen=True)
class _Parts:
    """A formula with its hypotheses and the definitions of letters, as they were read."""

    asked: Typed
    conditions: Sequence[Typed]
    definitions: Mapping[str, Typed]
    reader: MatrixReader

    @cached_property
    def tokens(self) -> list[str]:
        """All letters, in order of appearance; identity matrices are letters of their own."""
        parts = (self.asked, *self.conditions, *self.definitions.values())
        return [*dict.fromkeys(token for each in parts for token in each.symbols)]


@dataclass(frozen=True)
class _Way:
    """One way to understand a formula.

    Attributes
    ----------
    entries : mapping
        By letter its fields in a claim file, what it is in words, whether that is a guess.
    inverses : sequence of str
        What is supposed to have an inverse.
    sizes : sequence of str
        Names of sizes.
    formula, given : str, sequence of str
        The formula and its hypotheses in LaTeX, identity matrices with their sizes.
    title : str
        Of the filter, if there is one.
    identity : bool
        Whether there are identity matrices.
    """

    entries: Mapping[str, tuple[str, str, bool]]
    inverses: Sequence[str]
    sizes: Sequence[str]
    formula: str
    given: Sequence[str]
    title: str
    identity: bool


def _way(parts: _Parts, filter_: Mapping[str, str]) -> _Way:
    """The formula with the letters of a Kalman `filter_`, by their formulas; without any if it is
    empty. Raises BadInputError where shapes do not fit.
    """
    shapes = _shapes(parts)
    names = _named(shapes, parts.tokens)

    def size(number: int) -> str:
        return names[shapes.sizes.root(number)]

    def with_sizes(text: str) -> str:
        def identity(found: re.Match[str]) -> str:
            token = next(t for t in (f"I_{found[1] or found[2]}", found[0]) if t in shapes.letters)
            return f"I_{{{size(shapes.letters[token][0])}}}"

        return NUMBERED.sub(identity, text)

    def latex(each: Typed) -> str:
        relations = each.formula.readings[0].relations
        return with_sizes(relations_to_latex(relations) if each.plain else each.text)

    spoken_of = _spoken_of(parts.asked, parts.conditions, shapes.numbers)
    entries: dict[str, tuple[str, str, bool]] = {}
    for token, (rows, columns) in shapes.letters.items():
        if NUMBERED.fullmatch(token):
            continue
        own = parts.reader.said.get(token, Said())
        if token in parts.definitions:
            inner = latex(parts.definitions[token]).split("=", 1)[1].strip()
            words = filter_.get(token) or f"short for {own.definition}"
            entries[token] = f"definition = {quoted(inner)}", words, token in filter_
            continue
        square = size(rows) == size(columns)
        is_guess = token not in parts.reader.said
        usual = SYMMETRIC.get(base_letter(token), "") if square and is_guess else ""
        if token in spoken_of:
            usual = ""  # the hypothesis may be weaker, and the formula is not shown by a guess
        properties = own.properties or ((usual,) if usual else ())
        shape = f"shape = [{quoted(size(rows))}, {quoted(size(columns))}]"
        stated = f", is = [{', '.join(map(quoted, properties))}]" if properties else ""
        words = ", ".join((f"{size(rows)} x {size(columns)}", *properties))
        entries[token] = shape + stated, words, is_guess
    for token in sorted(shapes.numbers):
        entries[token] = 'shape = ["1", "1"]', NUMBER, token not in parts.reader.said
    everything = (parts.asked, *parts.conditions, *parts.definitions.values())
    known = sorted({each for each in names.values() if not each.isdigit()})
    for name in known:
        if name in entries:
            raise BadInputError(f"--symbol: {name} is a size and a letter of the formula")
    return _Way(
        entries,
        _inverses(everything, entries, with_sizes),
        known,
        latex(parts.asked),
        [latex(each) for each in parts.conditions],
        f"Kalman filter with {', '.join(f'{t} = {text}' for t, text in filter_.items())}"
        if filter_
        else ANY_SIZE,
        any(map(NUMBERED.fullmatch, shapes.letters)),
    )


def _spoken_of(asked: Typed, conditions: Sequence[Typed], numbers: Container[str]) -> set[str]:
    """Letters that a formula compares with zero, and those that a hypothesis is about alone, or
    beside identity matrices and numbers.
    """
    relations = [r for each in (asked, *conditions) for r in each.formula.readings[0].relations]
    sides = [pair for r in relations for pair in ((r.left, r.right), (r.right, r.left))]
    ends = [one["nodes"] for one, other in sides if other["nodes"] == ZERO]
    compared = {str(nodes[0][1]) for nodes in ends if len(nodes) == 1 and nodes[0][0] == "symbol"}
    alone = [
        {t for t in each.symbols if not NUMBERED.fullmatch(t) and t not in numbers}
        for each in conditions
    ]
    return compared.union(*(tokens for tokens in alone if len(tokens) == 1))


def _shapes(parts: _Parts) -> Shapes:
    """The shapes of all letters; small ones are columns where that makes no other letter smaller.
    Raises BadInputError.
    """

    def found(columns: frozenset[str]) -> Shapes:
        numbers = frozenset(filter(parts.reader.is_number, parts.tokens))
        shapes = Shapes(Sizes(), parts.reader, numbers, columns)
        for _ in range(2):  # what is a number is known at the end of the first
            for token, each in parts.definitions.items():
                inner = shapes.of(each.formula.readings[0].relations[0].right)
                shapes.alike([shapes.letter(token), inner], f"the definition of {token}")
            for each in (parts.asked, *parts.conditions):
                for relation in each.formula.readings[0].relations:
                    sides = [g for g in (relation.left, relation.right) if g["nodes"] != ZERO]
                    shape = shapes.alike([shapes.of(g) for g in sides], "both sides")
                    if relation.operator in ("<", "<=", ">", ">="):
                        shapes.square(shape, "both sides of an order")
        return shapes

    any_shapes = found(frozenset())
    small = frozenset(filter(is_small, parts.tokens))
    try:
        with_columns = found(small)
    except BadInputError:
        return any_shapes

    def of_one(shapes: Shapes) -> list[tuple[str, int]]:
        one = shapes.sizes.root(shapes.sizes.named(ONE))
        return [
            (token, place)
            for token, shape in shapes.letters.items()
            for place, number in enumerate(shape)
            if token not in small and shapes.sizes.root(number) == one
        ]

    return with_columns if of_one(with_columns) == of_one(any_shapes) else any_shapes


def _named(shapes: Shapes, tokens: Sequence[str]) -> dict[int, str]:
    """A name for each size, those that letters usually have first. Raises BadInputError."""
    sizes = shapes.sizes
    names = {sizes.root(number): name for number, name in sizes.names.items()}
    taken = {*names.values(), *tokens}

    def name(number: int, wanted: str) -> None:
        root = sizes.root(number)
        if root in names:
            return
        free = [each for each in (wanted, *_OTHERS) if each not in taken]
        if not free:
            raise BadInputError(f"more than {len(_OTHERS)} sizes in a formula about matrices")
        names[root] = free[0]
        taken.add(free[0])

    for letter, usual in _SIZES.items():
        for token in tokens:
            if token in shapes.letters and base_letter(token) == letter:
                for number, wanted in zip(shapes.letters[token], usual, strict=True):
                    name(number, wanted)
    for rows, columns in shapes.letters.values():
        name(rows, "n")
        name(columns, "m")
    return names


def _written(ways: Sequence[_Way], kind: str) -> MatrixQuestion:
    """The claim file: a setting and a claim for each way."""
    lines = [FORMAT_LINE, "", "[source]", 'title = "A formula that was asked for"']
    claims: list[str] = []
    assumed: dict[str, tuple[tuple[str, str, bool], ...]] = {}
    for number, way in enumerate(ways, 1):
        lines += ["", f"[settings.s{number}]", 'title = "matrices of any size"']
        lines += [f'kind = "{MATRICES}"', f"sizes = [{', '.join(map(quoted, way.sizes))}]"]
        lines += ["", f"[settings.s{number}.symbols]"]
        lines += [
            f"{quoted(token)} = {{ {text}, meaning = {quoted(words)} }}"
            for token, (text, words, _) in way.entries.items()
        ]
        claims += ["", "[[claims]]", f'id = "{number}"', 'place = "as asked"']
        claims += [f'kind = "{kind}"', f'setting = "s{number}"', f"latex = {quoted(way.formula)}"]
        for name, values in (("invertible", way.inverses), ("given", way.given)):
            claims += [f"{name} = [{', '.join(map(quoted, values))}]"] * bool(values)
        assumed[str(number)] = (
            *((token, words, guess) for token, (_, words, guess) in way.entries.items()),
            *([("I", "identity matrix", True)] if way.identity else []),
            *(("inverse", f"that of {each} exists", True) for each in way.inverses),
            ("filter", way.title, True),
        )
    return MatrixQuestion("\n".join([*lines, *claims]) + "\n", assumed)


def _kalman_filter(tokens: Sequence[str], said: Mapping[str, Said]) -> dict[str, str]:
    """K, or W, as the gain of a Kalman filter, S as the covariance of its innovation, by their
    formulas, where one letter each for P, H and R or S stands there and nobody said what K is;
    beside these a P that is marked as updated.
    """
    by_base: dict[str, list[str]] = {}
    posterior: list[str] = []
    for token in tokens:
        is_posterior = base_letter(token) == "P" and _POSTERIOR.search(token)
        (posterior if is_posterior else by_base.setdefault(base_letter(token), [])).append(token)
    single = {
        letter: found[0]
        for letter, found in by_base.items()
        if len(found) == 1 and (letter not in ("K", "W", "S") or found[0] not in said)
    }
    measurement = single.get("H") or single.get("C")
    covariance, noise, innovation = (single.get(letter) for letter in "PRS")
    gain = single.get("W" if "K" not in by_base else "K")
    if {"F", "Q"} & by_base.keys():
        innovation = None if gain is None else innovation
    if measurement is None or covariance is None or by_base.keys() >= {"H", "C"}:
        return {}
    found: dict[str, str] = {}
    seen = f"{measurement} {covariance} {measurement}^T"
    if innovation and noise:
        found[innovation] = f"{seen} + {noise}"
    if innovation or noise:
        inverse = f"{innovation}^{{-1}}" if innovation else f"({seen} + {noise})^{{-1}}"
        formula = f"{covariance} {measurement}^T {inverse}"
        if gain:
            found[gain] = formula
        if len(posterior) == 1 and posterior[0] not in said:
            found[posterior[0]] = f"{covariance} - {gain or formula} {measurement} {covariance}"
    return found


def _defines(parts: _Parts, filter_: Mapping[str, str]) -> bool:
    """Whether one side is a letter of which nothing else is said, so that it is only defined."""
    (relation, *more) = parts.asked.formula.readings[0].relations
    if more or relation.operator != "=":
        return False
    stated = {token for each in parts.conditions for token in each.symbols}
    stated |= {token for each in parts.definitions.values() for token in each.symbols}
    stated |= {*parts.definitions, *filter_}
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        node = side["nodes"][side["outputs"]["value"]]
        is_letter = node[0] == "symbol" and not NUMBERED.fullmatch(node[1])
        if is_letter and node[1] not in stated and node not in other["nodes"]:
            return True
    return False


def _inverses(
    formulas: Sequence[Typed],
    entries: Mapping[str, tuple[str, str, bool]],
    with_sizes: Callable[[str], str],
) -> list[str]:
    """What has to have an inverse so that the formulas have a value, but for what is definite by
    its form: the claim is made where these exist.
    """
    found: dict[str, None] = {}
    for each in formulas:
        for relation in each.formula.readings[0].relations:
            for graph in (relation.left, relation.right):
                nodes = graph["nodes"]
                for node in nodes:
                    if node[0] == "inverse" and _sign(nodes, node[1], entries) != DEFINITE:
                        inner: Graph = {"nodes": nodes, "outputs": {"value": node[1]}}
                        found[with_sizes(graph_to_latex(inner))] = None
    return [*found]


def _sign(
    nodes: Sequence[Sequence[Any]], number: int, entries: Mapping[str, tuple[str, str, bool]]
) -> str:
    """DEFINITE or SEMIDEFINITE where the form of a part shows it, else nothing."""
    node = nodes[number]
    match node[0]:
        case "symbol" if NUMBERED.fullmatch(node[1]):
            return DEFINITE
        case "symbol":
            text = entries[node[1]][0]
            return next((each for each in (DEFINITE, SEMIDEFINITE) if each in text), "")
        case "inverse" | "transpose":
            inner = _sign(nodes, node[1], entries)
            return inner if node[0] == "transpose" or inner == DEFINITE else ""
        case "add":
            signs = {_sign(nodes, part, entries) for part in node[1:]}
            return "" if "" in signs else DEFINITE if DEFINITE in signs else SEMIDEFINITE
        case "mul":
            return SEMIDEFINITE if _is_square(nodes, list(node[1:]), entries) else ""
    return ""


def _is_square(
    nodes: Sequence[Sequence[Any]], parts: list[int], entries: Mapping[str, tuple[str, str, bool]]
) -> bool:
    """Whether a product is X S X^T with a definite or semidefinite S, or X X^T."""
    while len(parts) > 1:
        first, last = parts[0], parts[-1]
        if ["transpose", last] != nodes[first] and ["transpose", first] != nodes[last]:
            return False
        parts = parts[1:-1]
    return not parts or _sign(nodes, parts[0], entries) != ""
