"""A formula about matrices of any size as the text of a claim file.

What letters usually mean in a filter gives the sizes their names, n for the state and m for the
measurement, and says which letters are covariances.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

from gainproof.answers.matrix_shapes import (
    IDENTITY,
    NUMBER,
    ONE,
    SYMMETRIC,
    Said,
    Shapes,
    Sizes,
    base_letter,
    said_of,
)
from gainproof.answers.typed import Typed, typed
from gainproof.bad_input import BadInputError
from gainproof.claims.template import FORMAT_LINE
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim.kinds import kind_of
from gainproof.verify.judge.claim.notation import is_plain
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.latex import graph_to_latex, relations_to_latex

MATRICES = "matrices"
"""What `--model` says where a formula without a transpose is about matrices."""
DEFINITE, SEMIDEFINITE = "positive definite", "positive semidefinite"
ANY_SIZE = "none: about matrices of any size"
_NUMBERS = re.compile(
    r"\\(?:alpha|beta|gamma|delta|(?:var)?epsilon|eta|theta|kappa|lambda|mu|omega|rho|sigma|tau)\b"
)
"""Greek letters that are numbers before a matrix unless they are transposed or said to be none."""
_PRIME = re.compile(r"(?<=[\w)\]])(?:'|\.T\b)")
_NUMBERED = re.compile(r"\bI_(?:\{(\d+)\}|(\d+))")
"""An identity matrix while its size is not known yet."""
_SIZES = {
    **dict.fromkeys(("P", "M", "X", r"\Sigma", "F", "A", r"\Phi"), ("n", "n")),
    **dict.fromkeys(("R", "S", "V"), ("m", "m")),
    "K": ("n", "m"),
    **dict.fromkeys(("H", "C"), ("m", "n")),
    **dict.fromkeys(("G", "B", r"\Gamma"), ("n", "l")),
    "Q": ("n", "n"),
}
"""Usual names of rows and columns, the surest letters first."""
_OTHERS = "nmlpqrstuvw"
_COLUMN = re.compile("[a-z]")
"""A letter whose matrix is a column where nothing says how many columns it has."""


def transposes(formula: str) -> bool:
    """Whether there is a transpose as MATLAB or NumPy writes it."""
    return is_plain(formula) and _PRIME.search(formula) is not None


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
    number = count(1)

    def read(text: str) -> Typed:
        text = IDENTITY.sub(lambda _: f"I_{{{next(number)}}}", text)
        if is_plain(text):
            text = _PRIME.sub("^T", text)
        return typed(text, symbols, numbers)

    said = {token: said_of(token, " ".join(text.split())) for token, text in symbols.items()}
    numbers = _number_letters(said)
    asked = read(formula)
    conditions = [read(each) for each in given]
    definitions = {t: read(f"0 = {s.definition}") for t, s in said.items() if s.definition}
    everything = [asked, *conditions, *definitions.values()]
    tokens = [*dict.fromkeys(token for each in everything for token in each.symbols)]
    for token in said:
        if token not in tokens:
            known = ", ".join(t for t in tokens if not IDENTITY.fullmatch(t)) or "none"
            raise BadInputError(f"--symbol: the formula has no {token}; its symbols: {known}")
    shapes = Shapes(Sizes(), said, frozenset(filter(numbers, tokens)))
    for _ in range(2):  # what is a number is known at the end of the first
        for token, each in definitions.items():
            inner = shapes.of(each.formula.readings[0].relations[0].right)
            shapes.alike([shapes.letter(token), inner], f"--symbol {token}")
        for each in (asked, *conditions):
            for relation in each.formula.readings[0].relations:
                sides = [
                    g for g in (relation.left, relation.right) if g["nodes"] != [["number", "0"]]
                ]
                shapes.alike([shapes.of(g) for g in sides], "both sides")
    names = _named(shapes, tokens)
    return _written(asked, conditions, definitions, shapes, names, said)


def _number_letters(said: Mapping[str, Said]) -> Callable[[str], bool]:
    """Which letters are numbers: those said to be, and small Greek ones that nobody mentions."""
    return lambda token: said[token].number if token in said else _NUMBERS.match(token) is not None


def _named(shapes: Shapes, tokens: Sequence[str]) -> dict[int, str]:
    """A name for each size, those that letters usually have first; columns of small letters that
    nothing else says are 1.
    """
    sizes = shapes.sizes
    names = {sizes.root(number): name for number, name in sizes.names.items()}
    taken = {*names.values(), *tokens}

    def name(number: int, wanted: str) -> None:
        root = sizes.root(number)
        if root in names:
            return
        names[root] = next(each for each in (wanted, *_OTHERS) if each not in taken or each == ONE)
        taken.add(names[root])

    for letter, usual in _SIZES.items():
        for token in tokens:
            if token in shapes.letters and base_letter(token) == letter:
                for number, wanted in zip(shapes.letters[token], usual, strict=True):
                    name(number, wanted)
    for token, (rows, columns) in shapes.letters.items():
        name(rows, "n")
        name(columns, ONE if _COLUMN.fullmatch(base_letter(token)) else "m")
    return names


def _written(
    asked: Typed,
    conditions: Sequence[Typed],
    definitions: Mapping[str, Typed],
    shapes: Shapes,
    names: Mapping[int, str],
    said: Mapping[str, Said],
) -> MatrixQuestion:
    """The claim file: letters free, and, where P, H, R and K stand in it, K the Kalman gain."""

    def size(number: int) -> str:
        return names[shapes.sizes.root(number)]

    identities = {
        found[1] or found[2]: size(rows)
        for token, (rows, _) in shapes.letters.items()
        if (found := _NUMBERED.fullmatch(token))
    }

    def with_sizes(text: str) -> str:
        return _NUMBERED.sub(lambda found: f"I_{{{identities[found[1] or found[2]]}}}", text)

    def latex(each: Typed) -> str:
        relations = each.formula.readings[0].relations
        return with_sizes(relations_to_latex(relations) if each.plain else each.text)

    entries: dict[str, tuple[str, str, bool]] = {}
    for token, (rows, columns) in shapes.letters.items():
        if IDENTITY.fullmatch(token):
            continue
        own = said.get(token, Said())
        shape = f"{size(rows)} x {size(columns)}"
        if token in definitions:
            inner = latex(definitions[token]).split("=", 1)[1].strip()
            entries[token] = f"definition = {quoted(inner)}", f"short for {own.definition}", False
            continue
        square = size(rows) == size(columns)
        usual = SYMMETRIC.get(base_letter(token), "") if square and token not in said else ""
        properties = own.properties or ((usual,) if usual else ())
        words = ", ".join((shape, *properties))
        stated = f", is = [{', '.join(map(quoted, properties))}]" if properties else ""
        both = f"[{quoted(size(rows))}, {quoted(size(columns))}]"
        entries[token] = f"shape = {both}{stated}", words, token not in said
    for token in shapes.numbers:
        entries[token] = 'shape = ["1", "1"]', NUMBER, token not in said
    ways = [*_gains(entries, shapes), {}]
    inverses = _inverses([asked, *conditions, *definitions.values()], entries, with_sizes)
    known = sorted({each for each in names.values() if not each.isdigit()})
    kind = "definition" if _defines(asked, conditions, definitions) else kind_of(asked.formula)
    lines = [FORMAT_LINE, "", "[source]", 'title = "A formula that was asked for"']
    claims: list[str] = []
    assumed: dict[str, tuple[tuple[str, str, bool], ...]] = {}
    for number, way in enumerate(ways, 1):
        lines += ["", f"[settings.s{number}]", 'title = "matrices of any size"']
        lines += [f'kind = "{MATRICES}"', f"sizes = [{', '.join(map(quoted, known))}]"]
        lines += ["", f"[settings.s{number}.symbols]"]
        entry = {**entries, **{t: (f"definition = {quoted(f)}", f, True) for t, f in way.items()}}
        lines += [
            f"{quoted(token)} = {{ {text}, meaning = {quoted(words)} }}"
            for token, (text, words, _) in entry.items()
        ]
        claims += ["", "[[claims]]", f'id = "{number}"', 'place = "as asked"']
        claims += [f'kind = "{kind}"', f'setting = "s{number}"', f"latex = {quoted(latex(asked))}"]
        claims += [f"invertible = [{', '.join(map(quoted, inverses))}]"] * bool(inverses)
        claims += [f"given = [{', '.join(quoted(latex(c)) for c in conditions)}]"] * bool(
            conditions
        )
        guessed = [(token, words, guess) for token, (_, words, guess) in entry.items()]
        optimal = ", ".join(f"{token} = {text}" for token, text in way.items())
        assumed[str(number)] = (
            *guessed,
            *(("inverse", f"that of {each} exists", True) for each in inverses),
            ("filter", f"Kalman filter with {optimal}" if way else ANY_SIZE, True),
        )
    return MatrixQuestion("\n".join([*lines, *claims]) + "\n", assumed)


def _gains(entries: Mapping[str, tuple[str, str, bool]], shapes: Shapes) -> list[dict[str, str]]:
    """K as the gain of a Kalman filter and S as the covariance of its innovation, where one letter
    each for K, P, H and R or S stands in the formula and nobody said what K is.
    """
    by_base: dict[str, list[str]] = {}
    for token in shapes.letters:
        by_base.setdefault(base_letter(token), []).append(token)
    single = {
        letter: tokens[0]
        for letter, tokens in by_base.items()
        if len(tokens) == 1 and (letter not in ("K", "S") or entries[tokens[0]][2])
    }
    measurement = single.get("H") or single.get("C")
    covariance, noise, innovation = (single.get(letter) for letter in "PRS")
    if measurement is None or covariance is None or by_base.keys() >= {"H", "C"}:
        return []
    found: dict[str, str] = {}
    seen = f"{measurement} {covariance} {measurement}^T"
    if innovation and noise:
        found[innovation] = f"{seen} + {noise}"
    if "K" in single and (innovation or noise):
        inverse = f"{innovation}^{{-1}}" if innovation else f"({seen} + {noise})^{{-1}}"
        found[single["K"]] = f"{covariance} {measurement}^T {inverse}"
    return [found] if found else []


def _defines(asked: Typed, conditions: Sequence[Typed], definitions: Mapping[str, Typed]) -> bool:
    """Whether one side is a letter of which nothing else is said: the formula can only define it.
    Gains and covariances of innovations are known.
    """
    (relation, *more) = asked.formula.readings[0].relations
    if more or relation.operator != "=":
        return False
    stated = {token for each in (*conditions, *definitions.values()) for token in each.symbols}
    stated |= set(definitions)
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        node = side["nodes"][side["outputs"]["value"]]
        if node[0] == "symbol" and base_letter(node[1]) not in ("K", "S") and node[1] not in stated:
            return node not in other["nodes"]
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
        case "symbol" if IDENTITY.fullmatch(node[1]):
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
