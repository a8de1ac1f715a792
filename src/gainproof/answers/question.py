"""A formula with what is said and guessed of its symbols, as the text of a claim file.

A guess is never silent: what was assumed is listed, each with how it can be said otherwise. Where
several filters may be meant, the text has a setting and a claim for each.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.answers.matrix_question import MATRICES, matrix_question
from gainproof.answers.matrix_reading import transposes
from gainproof.answers.matrix_shapes import says_matrix
from gainproof.answers.possible_filters import WHOLE, Candidate, Options, candidates, order_of
from gainproof.answers.typed import Typed, condition, definition, symbol_name, typed
from gainproof.bad_input import BadInputError, unknown_name
from gainproof.claims.template import FORMAT_LINE
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim import usual_letters
from gainproof.verify.judge.claim.settings import CONVENTIONS
from gainproof.verify.judge.claim.units import read_unit
from gainproof.verify.judge.claim.usual_letters import REAL, Meaning, entry_of
from gainproof.verify.judge.formula import Formula, Graph
from gainproof.verify.judge.kinds.catalogue import kind_of
from gainproof.verify.judge.quantity_names import quantity_names

DEFINITION = "definition"
MOST_SAID = 1000
"""Characters of what is said of a symbol."""
FILTER = "filter"
"""What is assumed of no symbol."""
_DELIMITERS = re.compile(r"(?s)^(?:\$\$?|\\\[|\\\()((?:(?!\$).)*?)(?:\$\$?|\\\]|\\\))$")
"""What LaTeX puts round a formula."""


@dataclass(frozen=True)
class Assumed:
    """What was taken for granted of a symbol, or of the `filter`: in words, whether it is a guess,
    and the option that says it otherwise.
    """

    of: str
    meaning: str
    guessed: bool
    option: str


@dataclass(frozen=True)
class Question:
    """The text of a claim file whose claims, by id, are the ways to understand the formula; what
    was assumed in each.
    """

    formula: str
    text: str
    assumed: Mapping[str, tuple[Assumed, ...]]


def question(formula: str, options: Options, models: Sequence[Mapping[str, object]]) -> Question:
    """What is to be judged. Raises BadInputError, with a mark under the place, for a formula that
    cannot be read and for options that do not fit.
    """
    for name, value in options.conventions.items():
        if name not in CONVENTIONS:
            raise unknown_name("convention", name, CONVENTIONS)
        if value not in CONVENTIONS[name]:
            raise unknown_name(f"value of the convention {name}", value, CONVENTIONS[name])
    formula = _DELIMITERS.sub(r"\1", formula.strip())
    names = {symbol_name(name): text for name, text in options.symbols.items()}
    open_ = not (options.model or options.conventions or options.domain)
    said_so = options.model == MATRICES or any(map(says_matrix, names.values()))
    if said_so or (open_ and any(map(transposes, (formula, *options.given)))):
        return _about_matrices(formula, names, options)
    read = typed(formula, names)
    said = {token: _meaning_of(token, text, names, read) for token, text in names.items()}
    domain = condition(options.domain, "domain", said, read) if options.domain else None
    given = [condition(each, "given", said, read) for each in options.given]
    conditions = [*([domain] if domain else []), *given]
    stated = {token for each in conditions for token in each.symbols}
    tokens = [*dict.fromkeys((*read.symbols, *(t for each in conditions for t in each.symbols)))]
    orders = {token: order_of(meaning) for token, meaning in said.items()}
    if 0 in orders.values():  # a filter in continuous time, whose noises no formula needs to name
        tokens += [t for t, order in orders.items() if order is not None and t not in tokens]
    for token in said:
        if token not in tokens:
            known = ", ".join(tokens) or "none"
            raise BadInputError(f"--symbol: the formula has no {token}; its symbols: {known}")
    taken = dict([*read.taken, *(part for each in conditions for part in each.taken)])
    for meaning in said.values():
        if meaning.definition:  # which may hold symbols of its own
            inner = definition(meaning.definition, "symbol", said, read)
            tokens += [token for token in inner.symbols if token not in tokens]
            taken |= dict(inner.taken)
            stated |= {*inner.symbols}
    for token in ("i", "j"):
        if (
            token in tokens
            and token not in {*said, *_counted(read.formula)}
            and _in_exponent(read.formula, token)
        ):
            raise BadInputError(
                f"{token} in an exponent looks like the imaginary unit, and complex numbers are "
                f"not judged: if it is a number, say --symbol '{token}: 1'"
            )
    options = replace(
        options, domain=domain.text if domain else "", given=tuple(each.text for each in given)
    )
    bounded = domain.symbols if domain else ()
    counted = _counted(read.formula)
    ways = candidates(tokens, said, options, models, read.formula, bounded, counted)
    text = _text(read, ways, options, stated)
    parts = [Assumed(part, how, True, f"--symbol '{part}: ...'") for part, how in taken.items()]
    assumed = {
        str(number): (*parts, *_assumed(candidate, said, options))
        for number, candidate in enumerate(ways, 1)
    }
    return Question(formula.strip(), text, assumed)


def _about_matrices(formula: str, names: Mapping[str, str], options: Options) -> Question:
    """The question where letters are matrices of any size. Raises BadInputError."""
    for option, stated in (("domain", options.domain), ("convention", options.conventions)):
        if stated:
            raise BadInputError(f"--{option}: a formula about matrices has none; say --given")
    if options.model not in ("", MATRICES):
        raise BadInputError(f"--model {options.model}: letters that are matrices have none")
    found = matrix_question(formula, names, options.given)
    options_of = {FILTER: "--model", "inverse": "--given"}
    assumed = {
        number: tuple(
            Assumed(
                of,
                meaning,
                guessed,
                options_of.get(of, f"--symbol '{of}: ...'"),
            )
            for of, meaning, guessed in each
        )
        + tuple(Assumed("given", relation, False, "--given") for relation in options.given)
        for number, each in found.assumed.items()
    }
    return Question(formula.strip(), found.text, assumed)


def _in_exponent(formula: Formula, token: str) -> bool:
    """Whether a symbol stands in an exponent of e, alone or in a product."""

    def holds(nodes: Sequence[Sequence[object]], number: int) -> bool:
        node = nodes[number]
        if node[0] == "symbol":
            return node[1] == token
        return any(holds(nodes, part) for part in _parts(node))

    return any(
        node[:2] == ["call", "exp"] and holds(graph["nodes"], node[2])
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in graph["nodes"]
    )


def _meaning_of(token: str, text: str, names: Collection[str], read: Typed) -> Meaning:
    """What a user says of a symbol, as `Options.symbols` has it. Raises BadInputError."""
    text = " ".join(text.split())
    if len(text) > MOST_SAID:
        raise BadInputError(f"--symbol {token}: more than {MOST_SAID} characters")
    if text in quantity_names():
        return usual_letters.quantity(text, quantity_names()[text].meaning)
    if text.startswith("="):
        inner = definition(text[1:], "symbol", names, read).text
        return Meaning("free", f"short for {text[1:].strip()}", definition=inner)
    found = re.fullmatch(r"(integer\b)?\s*([^<>]*?)\s*((?:<|>|\\leq|\\geq).*)?", text)
    unit = (found[2] if found else "") or "1"
    try:
        if found is None:
            raise ValueError("no condition behind a unit")
        read_unit(unit)
    except ValueError as error:
        nearest = unknown_name("quantity", text, quantity_names())
        raise BadInputError(
            f"--symbol '{token}: {text}': wanted is a quantity, a unit with a condition such as "
            f"'m > 0', or a definition '= ...': {error}; {nearest}"
        ) from None
    domain = f"{token} {found[3]}" if found[3] else ""
    words = WHOLE if found[1] else "number" if unit == "1" else f"number in {unit}"
    return Meaning("free", words, unit=unit, domain=domain, integer=bool(found[1]))


def _entry(token: str, meaning: Meaning) -> str:
    parts = [
        f"{name} = {'true' if value is True else quoted(value)}"
        for name, value in entry_of(meaning).items()
    ]
    return f"{quoted(token)} = {{ {', '.join(parts)} }}"


def _text(
    read: Typed, candidates: Sequence[Candidate], options: Options, stated: Collection[str]
) -> str:
    lines = [FORMAT_LINE, "", "[source]", 'title = "A formula that was asked for"']
    for number, candidate in enumerate(candidates, 1):
        lines += ["", f"[settings.s{number}]", f"title = {quoted(candidate.title)}"]
        lines += [*candidate.lines, "", f"[settings.s{number}.symbols]"]
        lines += [_entry(token, meaning) for token, meaning in candidate.symbols.items()]
    for number, candidate in enumerate(candidates, 1):
        defines = _only_defines(read.formula, candidate, stated)
        kind = DEFINITION if defines else kind_of(read.formula)
        lines += ["", "[[claims]]", f'id = "{number}"', 'place = "as asked"']
        lines += [f'kind = "{kind}"', f'setting = "s{number}"']
        lines += [f"{'plain' if read.plain else 'latex'} = {quoted(read.text)}"]
        lines += [f"domain = {quoted(options.domain)}"] if options.domain else []
        if options.given:
            lines += [f"given = [{', '.join(map(quoted, options.given))}]"]
    return "\n".join(lines) + "\n"


def _only_defines(formula: Formula, candidate: Candidate, stated: Collection[str]) -> bool:
    """Whether each relation has something on one side of which nothing is known and which stands
    nowhere else, as `_named` has it: it can say what that is, and no more.
    `stated` are the symbols of which conditions say something.
    """
    reading = formula.readings[0]
    if reading.conditions or any(each.operator != "=" for each in reading.relations):
        return False
    sides = [(each.left, each.right) for each in reading.relations]
    places = [token for pair in sides for side in pair for token in {*_symbols(side)}]

    def defines(one: Graph, other: Graph) -> bool:
        tokens = _named(one)
        if not tokens or other["nodes"][other["outputs"]["value"]][0] == "matrix":
            return False
        meanings = [candidate.symbols[token] for token in tokens]
        free = all(each.role == "free" and each.meaning == REAL for each in meanings)
        return free and all(t not in stated and places.count(t) == 1 for t in tokens)

    return all(defines(left, right) or defines(right, left) for left, right in sides)


def _named(graph: Graph) -> set[str]:
    """The symbols of a side that can be any number whatever the other side is: a symbol, a product
    of symbols such as VRR, a multiple of a logarithm, the deviation whose square it is; else none.
    """
    nodes = graph["nodes"]

    def factors(number: int) -> list[Sequence[Any]]:
        node = nodes[number]
        if node[0] in ("mul", "neg"):
            return [each for part in _parts(node) for each in factors(part)]
        return [] if node[0] == "number" else [node]

    found = factors(graph["outputs"]["value"])
    if len(found) == 1 and found[0][:2] == ["call", "log"]:
        found = factors(found[0][2])
    powers = [each for each in found if each[0] == "pow" and nodes[each[1]][0] == "symbol"]
    named = [str(nodes[each[1]][1]) for each in powers]
    if found == powers and len(powers) == 1 and powers[0][2] == "2":
        return {token for token in named if token.startswith("\\sigma")}
    names = [str(each[1]) for each in found if each[0] == "symbol"]
    # a letter that stands there once takes any sign and size
    once = any(names.count(name) == 1 and name not in named for name in names)
    return {*names, *named} if once and len(names) + len(powers) == len(found) else set()


def _parts(node: Sequence[Any]) -> list[int]:
    """The numbers of the nodes that a node is made of; a matrix has its size in front."""
    return [part for part in node[3 if node[0] == "matrix" else 1 :] if type(part) is int]


def _symbols(graph: Mapping[str, Any]) -> Iterator[str]:
    return (node[1] for node in graph["nodes"] if node[0] == "symbol" and node[1] != "infinity")


def _counted(formula: Formula) -> set[str]:
    """The symbols of indices of sums and products and of their bounds."""
    found: set[str] = set()

    def gather(nodes: Sequence[Sequence[Any]], number: int) -> None:
        node = nodes[number]
        found.update({node[1]} if node[0] == "symbol" and node[1] != "infinity" else ())
        for part in _parts(node):
            gather(nodes, part)

    for relation in formula.readings[0].relations:
        for graph in (relation.left, relation.right):
            for node in graph["nodes"]:
                if node[0] == "call" and node[1] in ("sum", "product"):
                    for part in node[3:]:
                        gather(graph["nodes"], part)
    return found


def _assumed(
    candidate: Candidate, said: Mapping[str, Meaning], options: Options
) -> tuple[Assumed, ...]:
    found = [
        Assumed(token, _in_words(meaning), token not in said, f"--symbol '{token}: ...'")
        for token, meaning in candidate.symbols.items()
    ]
    found.append(Assumed(FILTER, candidate.title, not options.model, "--model"))
    found += [
        Assumed("convention", f"{name} = {value}", False, "--convention")
        for name, value in options.conventions.items()
    ]
    found += [Assumed("domain", options.domain, False, "--domain")] if options.domain else []
    found += [Assumed("given", relation, False, "--given") for relation in options.given]
    return tuple(found)


def _in_words(meaning: Meaning) -> str:
    where = f", {meaning.domain}" if meaning.domain else ""
    unit = (
        f" in {meaning.unit}" if meaning.unit != "1" and meaning.unit not in meaning.meaning else ""
    )
    return f"{meaning.meaning}{unit}{where}"
