"""A formula with what is said and guessed of its symbols, as the text of a claim file.

A guess is never silent: what was assumed is listed, each with how it can be said otherwise. Where
several filters may be meant, the text has a setting and a claim for each.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.claims.template import FORMAT_LINE
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim import usual_letters as letters
from gainproof.verify.judge.claim.settings import CONVENTIONS
from gainproof.verify.judge.claim.short_form import REAL, entry_of, is_plain, kind_of
from gainproof.verify.judge.claim.units import read_unit
from gainproof.verify.judge.claim.usual_letters import Meaning
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.reader.characters import meant_character
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.symbols_met import symbols_met

MOST_CHARACTERS = 20_000
"""Of a formula; the reader has limits of its own below that."""
DEFINITION = "definition"
SEARCHED = "process noise searched"
NO_FILTER = "none: about real numbers"
SEARCH, NONE, FIXED = "search", "none", "fixed"
FILTER = "filter"
"""What is assumed of no symbol."""
_NOISE_ORDERS: Mapping[str, tuple[str, int, str]] = MappingProxyType(
    {
        "random-velocity": ("deviation", 2, "m s^-1"),
        "random-acceleration": ("deviation", 4, "m s^-2"),
        "continuous-white-acceleration": ("density", 3, "m^2 s^-3"),
        "acceleration-increments": ("deviation", 4, "m s^-2"),
        "wiener-acceleration": ("deviation", 4, "m s^-2"),
        "random-jerk": ("deviation", 6, "m s^-3"),
        "continuous-white-jerk": ("density", 5, "m^2 s^-5"),
    }
)
"""Of the models of measured position: what their strength is, the power of T of the first entry of
Q in units of it (a deviation counts with its square), and its unit."""


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
    extra: tuple[str, ...] = ()


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
    asked, formula = formula.strip(), in_ascii(formula.strip())
    if not formula:
        raise BadInputError("a formula is wanted, got an empty one")
    if len(formula) > MOST_CHARACTERS:
        raise BadInputError(f"a formula of more than {MOST_CHARACTERS} characters")
    plain = is_plain(formula)
    for name, value in options.conventions.items():
        if name not in CONVENTIONS:
            raise unknown_name("convention", name, CONVENTIONS)
        if value not in CONVENTIONS[name]:
            raise unknown_name(f"value of the convention {name}", value, CONVENTIONS[name])
    said = _said(options)
    met = symbols_met(formula, plain=plain)
    products = _products(met.symbols, said) if plain else ()
    read = formula
    for word in products:
        read = re.sub(rf"(?<![A-Za-z_]){word}(?![A-Za-z_])", " ".join(word), read)
    met = symbols_met(read, plain=plain) if products else met
    if met.formula is None:
        raise BadInputError(f"not read: {met.problem}\n{met.caret}")
    conditions = _conditions(options, plain)
    tokens = [*dict.fromkeys((*met.symbols, *conditions))]
    unused = [token for token in said if token not in tokens]
    if unused:
        raise unknown_name("symbol of the formula", unused[0], tokens)
    for token in ("i", "j"):
        if token in tokens and token not in said and _in_exponent(met.formula, token):
            raise BadInputError(
                f"{token} in an exponent looks like the imaginary unit, and complex numbers are "
                f"not judged: if it is a number, say --symbol '{token}: 1'"
            )
    candidates = _candidates(tokens, said, options, models)
    text = _text(read, plain, met.formula, candidates, options)
    written = tuple(
        Assumed(word, f"product {' '.join(word)}", True, f"--symbol '{word}: ...'")
        for word in products
    )
    assumed = {
        str(number): (*written, *_assumed(candidate, said, options))
        for number, candidate in enumerate(candidates, 1)
    }
    return Question(asked, text, assumed)


def in_ascii(formula: str) -> str:
    """The formula with Greek letters, small digits and the minus sign as LaTeX has them. What looks
    like a Latin letter and is none stays, for the reader to refuse.
    """
    return "".join(map(_in_ascii, formula))


def _in_ascii(character: str) -> str:
    meant = None if character.isascii() else meant_character(character)
    if meant is None:
        return character
    if meant.startswith("\\") and "GREEK" in unicodedata.name(character, ""):
        return f"{meant} "
    return meant if meant[:1] in "^_-" and (meant == "-" or meant[1:].isdigit()) else character


def _products(tokens: Sequence[str], said: Mapping[str, Meaning]) -> tuple[str, ...]:
    """Words of plain text that are meant as products: nobody said what they are, and each of their
    letters stands elsewhere too, alone or in another such word. `ab` beside a and b, not `vel`.
    """
    words = [
        token
        for token in tokens
        if re.fullmatch("[A-Za-z]{2,4}", token)
        and token not in said
        and token not in letters.filter_meanings(tokens)
    ]
    return tuple(
        word
        for word in words
        if all(
            any(letter in other for other in (*tokens, *words) if other != word and len(other) < 5)
            for letter in word
        )
    )


def _in_exponent(formula: Formula, token: str) -> bool:
    """Whether a symbol stands in an exponent of e, alone or in a product."""

    def holds(nodes: Sequence[Sequence[object]], number: int) -> bool:
        node = nodes[number]
        if node[0] == "symbol":
            return node[1] == token
        return any(holds(nodes, part) for part in node[1:] if isinstance(part, int))

    return any(
        node[:2] == ["call", "exp"] and holds(graph["nodes"], node[2])
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in graph["nodes"]
    )


def _conditions(options: Options, plain: bool) -> list[str]:
    """The symbols of domain and hypotheses."""
    found: list[str] = []
    for name, condition in (
        ("domain", options.domain),
        *(("given", each) for each in options.given),
    ):
        if condition:
            met = symbols_met(condition, plain=plain)
            if met.formula is None:
                raise BadInputError(f"--{name}: not read: {met.problem}\n{met.caret}")
            found += met.symbols
    return found


def _said(options: Options) -> dict[str, Meaning]:
    """What the user says of symbols, by canonical token. Raises BadInputError."""
    found = {}
    for name, text in options.symbols.items():
        try:
            token = canonical_token(name)
        except ReaderError as error:
            raise BadInputError(f"--symbol {name!r}: {error.problem}") from None
        found[token] = meaning_of(token, text)
    return found


def meaning_of(token: str, text: str) -> Meaning:
    """What a user says of a symbol, as `Options.symbols` has it. Raises BadInputError."""
    text = text.strip()
    if text in quantity_names():
        return letters.quantity(text, quantity_names()[text].meaning)
    if text.startswith("="):
        return Meaning("free", f"short for {text[1:].strip()}", definition=text[1:].strip())
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
    words = "whole number" if found[1] else "number" if unit == "1" else f"number in {unit}"
    return Meaning("free", words, unit=unit, domain=domain, integer=bool(found[1]))


def _candidates(
    tokens: Sequence[str],
    said: Mapping[str, Meaning],
    options: Options,
    models: Sequence[Mapping[str, object]],
) -> list[Candidate]:
    """The ways to understand the formula, the likeliest first."""
    usual = letters.filter_meanings(tokens)
    known = {**usual, **said}
    about_filter = all(token in known for token in tokens) and any(
        letters.is_anchor(known[token]) for token in tokens
    )
    model = options.model or (SEARCH if about_filter else NONE)
    names = [str(each["name"]) for each in models]
    if model not in (SEARCH, NONE, FIXED, *names):
        raise unknown_name("model", model, [SEARCH, NONE, FIXED, *names])
    free = {token: Meaning("free", REAL) for token in tokens}
    if model == NONE:
        for token, meaning in said.items():
            if meaning.role != "free":
                said_to_be = f"{token} is said to be {meaning.quantity}, a quantity of a filter"
                raise BadInputError(f"{said_to_be}: --model none has none")
        algebra = ('kind = "algebra"',)
        return [Candidate(algebra, {**free, **said}, NO_FILTER)]
    meant = {**free, **known}
    orders = [
        int(each.quantity[-1]) for each in meant.values() if each.quantity.startswith("gain.")
    ]
    if model == FIXED:
        states = max(orders, default=2)
        fixed = ('kind = "fixed_gain"', f"states = {states}", *_conventions(options, meant))
        return [Candidate(fixed, meant, f"a filter of {states} states with any gains")]
    if any(map(letters.is_numbered, tokens)) and model == SEARCH:
        least = max(orders, default=1) - 1
        return [
            Candidate(
                ('kind = "growing_memory"', f"degree = {degree}", *_conventions(options, meant)),
                meant,
                f"least squares over all samples, polynomial of degree {degree}",
            )
            for degree in range(least, 3)
        ]
    strengths = [token for token in tokens if meant[token].role in ("deviation", "density")]
    if not strengths:
        words = SEARCHED if model == SEARCH else f"process noise {model}"
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
        and _NOISE_ORDERS.get(str(each["name"]), ("",))[0] == role
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


def _rows(model: Mapping[str, object], name: str) -> list[list[str]]:
    rows = model[name]
    assert isinstance(rows, list)
    return rows


def _with_strength(
    token: str, meant: Mapping[str, Meaning], model: Mapping[str, object], options: Options
) -> Candidate:
    """A model of the catalogue, written out with the symbols of its noises."""
    name = str(model["name"])
    role, power, unit = _NOISE_ORDERS[name]

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
    formula: str, plain: bool, read: Formula, candidates: Sequence[Candidate], options: Options
) -> str:
    lines = [FORMAT_LINE, "", "[source]", 'title = "A formula that was asked for"']
    for number, candidate in enumerate(candidates, 1):
        lines += ["", f"[settings.s{number}]", f"title = {quoted(candidate.title)}"]
        lines += [*candidate.lines, "", f"[settings.s{number}.symbols]"]
        lines += [_entry(token, meaning) for token, meaning in candidate.symbols.items()]
    for number, candidate in enumerate(candidates, 1):
        lines += ["", "[[claims]]", f'id = "{number}"', 'place = "as asked"']
        kind = DEFINITION if _only_defines(read, candidate) else kind_of(read)
        lines += [f'kind = "{kind}"', f'setting = "s{number}"']
        lines += [f"{'plain' if plain else 'latex'} = {quoted(formula)}"]
        lines += [f"domain = {quoted(options.domain)}"] if options.domain else []
        if options.given:
            lines += [f"given = [{', '.join(map(quoted, options.given))}]"]
    return "\n".join(lines) + "\n"


def _only_defines(formula: Formula, candidate: Candidate) -> bool:
    """Whether one side is a number of which nothing is known and that stands nowhere else: such a
    formula can say what the number is, and nothing else.
    """
    reading = formula.readings[0]
    if len(reading.relations) != 1 or reading.conditions or reading.relations[0].operator != "=":
        return False
    sides = reading.relations[0].left, reading.relations[0].right
    for one, other in (sides, sides[::-1]):
        node = one["nodes"][one["outputs"]["value"]]
        if node[0] == "symbol" and node not in other["nodes"]:
            meaning = candidate.symbols[node[1]]
            if meaning.role == "free" and meaning.meaning == REAL:
                return True
    return False


def _assumed(
    candidate: Candidate, said: Mapping[str, Meaning], options: Options
) -> tuple[Assumed, ...]:
    found = [
        Assumed(token, _in_words(meaning), token not in said, f"--symbol '{token}: ...'")
        for token, meaning in candidate.symbols.items()
    ]
    found.append(Assumed(FILTER, candidate.title, not options.model, "--model"))
    found += [Assumed("given", relation, False, "--given") for relation in options.given]
    return tuple(found)


def _in_words(meaning: Meaning) -> str:
    where = f", {meaning.domain}" if meaning.domain else ""
    unit = (
        f" in {meaning.unit}" if meaning.unit != "1" and meaning.unit not in meaning.meaning else ""
    )
    return f"{meaning.meaning}{unit}{where}"
