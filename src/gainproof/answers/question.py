"""A formula with what is said and guessed of its symbols, as the text of a claim file.

A guess is never silent: what was assumed is listed, each with how it can be said otherwise. Where
several filters may be meant, the text has a setting and a claim for each.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from gainproof.answers.densities import densities, order_of
from gainproof.answers.matrix_question import MATRICES, matrix_question
from gainproof.answers.matrix_reading import transposes
from gainproof.answers.matrix_shapes import says_matrix
from gainproof.answers.typed import Typed, condition, definition, symbol_name, typed
from gainproof.bad_input import BadInputError, unknown_name
from gainproof.claims.template import FORMAT_LINE
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim import letters
from gainproof.verify.judge.claim.kinds import kind_of
from gainproof.verify.judge.claim.letters import REAL, Meaning, entry_of
from gainproof.verify.judge.claim.settings import CONVENTIONS
from gainproof.verify.judge.claim.units import read_unit
from gainproof.verify.judge.formula import Formula, Graph
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.setting.growing_memory import MOST_DEGREE

DEFINITION = "definition"
WHOLE = "whole number"
SEARCHED = "process noise searched"
NO_FILTER = "none: about real numbers"
EULER = Meaning("free", "Euler's number", definition=r"\exp(1)")
"""Of a letter e that stands for itself; with an exponent the reader knows it."""
MOST_SAID = 1000
"""Characters of what is said of a symbol."""
ANGLES = frozenset({"sin", "cos", "tan", "asin", "acos", "atan", "cot", "sec", "csc"})
SEARCH, NONE, FIXED = "search", "none", "fixed"
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
class Options:
    """What a user says of a formula; all may be left out.

    Attributes
    ----------
    symbols : mapping
        By symbol as written: a quantity ("filter_gain.1"), a unit with a condition ("m > 0",
        "m^2/s"), "integer" with a condition, or a definition ("= a + b").
    model : str
        A name of `gainproof list`, "search", "none" (no filter), "fixed" (any gains); empty: what
        the letters suggest.
    domain : str
        Conditions under which the formula is claimed.
    given : sequence of str
        Equations and inequalities that are hypotheses.
    conventions : mapping
        By name: gain, third_gain, power_of_T, covariance, noise, index_origin.
    """

    symbols: Mapping[str, str] = field(default_factory=dict)
    model: str = ""
    domain: str = ""
    given: Sequence[str] = ()
    conventions: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Candidate:
    """One way to understand a formula: lines of a setting, and what they assume of the filter."""

    lines: tuple[str, ...]
    symbols: Mapping[str, Meaning]
    title: str


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
    if said_so or (open_ and transposes(formula)):
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
    candidates = _candidates(tokens, said, options, models, read.formula, bounded)
    text = _text(read, candidates, options, stated)
    parts = [Assumed(part, how, True, f"--symbol '{part}: ...'") for part, how in taken.items()]
    assumed = {
        str(number): (*parts, *_assumed(candidate, said, options))
        for number, candidate in enumerate(candidates, 1)
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


def _has_angles(formula: Formula) -> bool:
    """Whether there are sines and their like, whose arguments are no gains."""
    return any(
        node[0] == "call" and node[1] in ANGLES
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in graph["nodes"]
    )


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
        return letters.quantity(text, quantity_names()[text].meaning)
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


def _candidates(
    tokens: Sequence[str],
    said: Mapping[str, Meaning],
    options: Options,
    models: Sequence[Mapping[str, object]],
    formula: Formula,
    bounded: Collection[str],
) -> list[Candidate]:
    """The ways to understand the formula, the likeliest first; the domain speaks of the `bounded`
    symbols.
    """
    known = {**letters.filter_meanings(tokens), **said}
    about_filter = (
        all(token in known for token in tokens)
        and letters.is_sound([known[token] for token in tokens])
        and not _has_angles(formula)
    )
    told = any(meaning.role != "free" for meaning in said.values())
    model = options.model or (SEARCH if about_filter or told else NONE)
    names = [str(each["name"]) for each in models]
    if model not in (SEARCH, NONE, FIXED, *names):
        raise unknown_name("model", model, [SEARCH, NONE, FIXED, *names])
    whole = _counted(formula)
    free = {
        token: EULER
        if token == "e" and not _alone(formula, token)
        else Meaning("free", WHOLE, integer=True)
        if token in whole
        else Meaning("free", REAL)
        for token in tokens
    }
    if model == NONE:
        for token, meaning in said.items():
            if meaning.role != "free":
                said_to_be = f"{token} is said to be {meaning.quantity}, a quantity of a filter"
                raise BadInputError(f"{said_to_be}: --model none has none")
        if options.conventions:
            raise BadInputError(
                f"--convention {next(iter(options.conventions))}: the formula is understood as one "
                "about real numbers, which has none; say --model search, or what its symbols are"
            )
        algebra = ('kind = "algebra"',)
        return [Candidate(algebra, {**free, **said}, NO_FILTER)]
    meant = {**free, **known}
    orders = [
        int(each.quantity[-1]) for each in meant.values() if each.quantity.startswith("gain.")
    ]
    if model == FIXED:
        states = max([2, *orders])
        fixed = ('kind = "fixed_gain"', f"states = {states}", *_conventions(options, meant))
        return [Candidate(fixed, meant, f"a filter of {states} states with any gains")]
    said_densities = densities(meant) if model == SEARCH else None
    if said_densities is not None:
        if options.conventions:
            name = next(iter(options.conventions))
            raise BadInputError(f"--convention {name}: a Kalman-Bucy filter has none")
        declared = said_densities.symbols(meant, options.domain, bounded)
        return [Candidate(said_densities.lines(), declared, said_densities.title)]
    fading = any(each.quantity == "forgetting_factor" for each in meant.values())
    if (fading or any(map(letters.is_numbered, tokens))) and model == SEARCH:
        kind = "fading_memory" if fading else "growing_memory"
        words = "fading-memory filter" if fading else "least squares over all samples"
        least = max(1, _states(meant)) - 1
        return [
            Candidate(
                (f'kind = "{kind}"', f"degree = {degree}", *_conventions(options, meant)),
                meant,
                f"{words}, polynomial of degree {degree}",
            )
            for degree in range(least, MOST_DEGREE + 1)
        ]
    strengths = [token for token in tokens if meant[token].role in ("deviation", "density")]
    if not strengths:
        words = f"process noise {model}" if model != SEARCH else SEARCHED + _searched(meant)
        steady = ('kind = "steady_state"', f'model = "{model}"', *_conventions(options, meant))
        return [Candidate(steady, meant, f"Kalman filter in its steady state, {words}")]
    if len(strengths) > 1:
        raise BadInputError(
            f"{' and '.join(strengths)} both look like the strength of the process noise: say what "
            "one of them is with --symbol"
        )
    role = meant[strengths[0]].role
    suited = [
        each
        for each in models
        if model in (SEARCH, each["name"])
        and letters.NOISE_ORDERS.get(str(each["name"]), ("",))[0] == role
        and len(_rows(each, "transition")) >= max(orders, default=2)
    ]
    fewest = min((len(_rows(each, "transition")) for each in suited), default=0)
    found = [
        _with_strength(strengths[0], meant, each, options)
        for each in suited
        if len(_rows(each, "transition")) == fewest
    ]
    if not found:
        raise BadInputError(
            f"{strengths[0]} is taken for the {meant[strengths[0]].meaning}, which model {model} "
            f"does not have: say what it is with --symbol '{strengths[0]}: ...'"
        )
    return found


def _searched(meant: Mapping[str, Meaning]) -> str:
    """Among which models the judge searches: as many states as the highest component named."""
    states = _states(meant)
    return f" among models of {states} states" if states > 1 else ""


def _states(meant: Mapping[str, Meaning]) -> int:
    """The highest number of a component; 0 if there is none."""
    parts = (part for each in meant.values() for part in each.quantity.split(".") if part.isdigit())
    return max(map(int, parts), default=0)


def _alone(formula: Formula, token: str) -> bool:
    """Whether a symbol is a whole side."""
    sides = (
        graph
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
    )
    return any(each["nodes"][each["outputs"]["value"]][:2] == ["symbol", token] for each in sides)


def _rows(model: Mapping[str, object], name: str) -> list[list[str]]:
    rows = model[name]
    assert isinstance(rows, list)
    return rows


def _with_strength(
    token: str, meant: Mapping[str, Meaning], model: Mapping[str, object], options: Options
) -> Candidate:
    """A model of the catalogue, written out with the symbols of its noises."""
    name = str(model["name"])
    role, power, unit = letters.NOISE_ORDERS[name]

    def symbol_of(quantity: str, usual: str) -> str:
        return next((t for t, m in meant.items() if m.quantity == quantity), usual)

    interval = symbol_of("sampling_interval", "T")
    variance = symbol_of("measurement_noise_variance", "")
    deviation = symbol_of("measurement_noise_deviation", r"\sigma_v")
    noise = variance or rf"{deviation}^2"
    strength = rf"{token}^2" if role == "deviation" else token
    declared = {
        **meant,
        token: Meaning("free", meant[token].meaning, unit=unit, domain=f"{token} > 0"),
    }
    for symbol, quantity in (
        (interval, "sampling_interval"),
        *([] if variance else [(deviation, "measurement_noise_deviation")]),
    ):
        declared.setdefault(symbol, letters.quantity(quantity, quantity_names()[quantity].meaning))

    def matrix(field_name: str, factor: str, power_at: Callable[[int, int], int]) -> str:
        rows = [
            [_times(str(value), factor, interval, power_at(i, j)) for j, value in enumerate(row)]
            for i, row in enumerate(_rows(model, field_name))
        ]
        return f"{field_name} = [{', '.join('[' + ', '.join(map(quoted, r)) + ']' for r in rows)}]"

    lines = (
        'kind = "steady_state"',
        matrix("transition", "", lambda i, j: j - i),
        matrix("process_noise", strength, lambda i, j: power - i - j),
        matrix("measurement", "", lambda i, j: 0),  # noqa: ARG005 (a table of no powers)
        matrix("measurement_noise", noise, lambda i, j: 0),  # noqa: ARG005
        *_conventions(options, meant),
    )
    return Candidate(lines, declared, f"Kalman filter in its steady state, process noise {name}")


def _times(value: str, factor: str, interval: str, power: int) -> str:
    """An entry of a model in units, from its number: that times a factor and a power of T."""
    if value == "0":
        return value
    number = re.sub(r"^(-?\d+)/(\d+)$", r"\\frac{\1}{\2}", value)
    time = interval if power == 1 else f"{interval}^{power}" if power else ""
    parts = [part for part in (number if number != "1" else "", factor, time) if part]
    return " ".join(parts) or "1"


def _conventions(options: Options, meant: Mapping[str, Meaning]) -> list[str]:
    """Those that the user states, and a search for those that the symbols leave open."""
    lines = [f'{name} = "{value}"' for name, value in options.conventions.items()]
    if any(each.quantity == "gain.3" for each in meant.values()):
        lines += [] if "third_gain" in options.conventions else ['third_gain = "search"']
    return lines


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
