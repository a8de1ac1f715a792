"""Which filters a formula may be about, by what is said and guessed of its symbols: one with any
gains, one in its steady state, with a fading or growing memory, or none.

Where symbols are said to be densities a Kalman-Bucy filter is meant: that of a position and its
derivatives, each driven by one white noise at most. What does not fit into it is refused, so that
no letter of the model is left out without a word.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim import usual_letters
from gainproof.verify.judge.claim.units import read_unit
from gainproof.verify.judge.claim.usual_letters import REAL, Meaning
from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.setting.growing_memory import MOST_DEGREE

SEARCH, NONE, FIXED = "search", "none", "fixed"
WHOLE = "whole number"
SEARCHED = "process noise searched"
NO_FILTER = "none: about real numbers"
EULER = Meaning("free", "Euler's number", definition=r"\exp(1)")
"""Of a letter e that stands for itself; with an exponent the reader knows it."""
ANGLES = frozenset({"sin", "cos", "tan", "asin", "acos", "atan", "cot", "sec", "csc"})
NOISES = ("measured position", "white velocity", "white acceleration", "white jerk")
UNITS = ("m^2 s", "m^2 s^-1", "m^2 s^-3", "m^2 s^-5")
"""Of a density, by the order of the derivative that its noise drives; NOISES say what that is."""
CONTINUOUS = ("gain.", "continuous_gain.", "covariance.")
"""Beginnings of the quantities that a Kalman-Bucy filter has."""
BY_FILE = "write a claim file with a setting of kind kalman_bucy (docs/claim-files.md)"


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


def candidates(
    tokens: Sequence[str],
    said: Mapping[str, Meaning],
    options: Options,
    models: Sequence[Mapping[str, object]],
    formula: Formula,
    bounded: Collection[str],
    counted: Collection[str],
) -> list[Candidate]:
    """The ways to understand the formula, the likeliest first; the domain speaks of the `bounded`
    symbols, sums and products run over the `counted` ones. Raises BadInputError.
    """
    known = {**usual_letters.filter_meanings(tokens), **said}
    about_filter = (
        all(token in known for token in tokens)
        and usual_letters.is_sound([known[token] for token in tokens])
        and not _has_angles(formula)
    )
    told = any(meaning.role != "free" for meaning in said.values())
    model = options.model or (SEARCH if about_filter or told else NONE)
    names = [str(each["name"]) for each in models]
    if model not in (SEARCH, NONE, FIXED, *names):
        raise unknown_name("model", model, [SEARCH, NONE, FIXED, *names])
    free = {
        token: EULER
        if token == "e" and not _alone(formula, token)
        else Meaning("free", WHOLE, integer=True)
        if token in counted
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
    if (fading or any(map(usual_letters.is_numbered, tokens))) and model == SEARCH:
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
        if any(model == each["name"] and not _is_kinematic(each) for each in models):
            meant = {
                token: usual_letters.of_any_states(meaning) for token, meaning in meant.items()
            }
        named = (
            f"process noise {model}" if model in usual_letters.NOISE_ORDERS else f"model {model}"
        )
        words = named if model != SEARCH else SEARCHED + _searched(meant)
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
        and usual_letters.NOISE_ORDERS.get(str(each["name"]), ("",))[0] == role
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


def _has_angles(formula: Formula) -> bool:
    """Whether there are sines and their like, whose arguments are no gains."""
    return any(
        node[0] == "call" and node[1] in ANGLES
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in graph["nodes"]
    )


def _alone(formula: Formula, token: str) -> bool:
    """Whether a symbol is a whole side."""
    sides = (
        graph
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
    )
    return any(each["nodes"][each["outputs"]["value"]][:2] == ["symbol", token] for each in sides)


def _searched(meant: Mapping[str, Meaning]) -> str:
    """Among which models the judge searches: as many states as the highest component named."""
    states = _states(meant)
    return f" among models of {states} states" if states > 1 else ""


def _states(meant: Mapping[str, Meaning]) -> int:
    """The highest number of a component; 0 if there is none."""
    parts = (part for each in meant.values() for part in each.quantity.split(".") if part.isdigit())
    return max(map(int, parts), default=0)


def _rows(model: Mapping[str, object], name: str) -> list[list[str]]:
    rows = model[name]
    assert isinstance(rows, list)
    return rows


def _is_kinematic(model: Mapping[str, object]) -> bool:
    """Whether its states are a position and its rates, as far as its transition says."""
    rows = _rows(model, "transition")
    return rows == [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]] or (
        rows == [["1", "1"], ["0", "1"]]
    )


def _with_strength(
    token: str, meant: Mapping[str, Meaning], model: Mapping[str, object], options: Options
) -> Candidate:
    """A model of the catalogue, written out with the symbols of its noises."""
    name = str(model["name"])
    role, power, unit = usual_letters.NOISE_ORDERS[name]

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
        declared.setdefault(
            symbol, usual_letters.quantity(quantity, quantity_names()[quantity].meaning)
        )

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


@dataclass(frozen=True)
class Densities:
    """The symbol for the density of the measurement, and those for the noises by the order of the
    derivative that each drives.
    """

    measured: str
    driving: Mapping[int, str]

    @property
    def title(self) -> str:
        """The filter in words."""
        noises = [f"{token} of a {NOISES[order]}" for order, token in sorted(self.driving.items())]
        told = ", ".join([*noises, f"{self.measured} of the {NOISES[0]}"])
        return f"Kalman-Bucy filter in its steady state, densities {told}"

    def lines(self) -> tuple[str, ...]:
        """The fields of its setting: each component is the derivative of the one before."""
        size = range(max(self.driving))
        a = [[str(int(j == i + 1)) for j in size] for i in size]
        q = [[self.driving.get(i + 1, "0") if i == j else "0" for j in size] for i in size]
        h, r = [[str(int(j == 0)) for j in size]], [[self.measured]]
        matrices = {"transition": a, "process_noise": q, "measurement": h, "measurement_noise": r}
        texts = (
            f"{name} = [{', '.join('[' + ', '.join(map(quoted, row)) + ']' for row in rows)}]"
            for name, rows in matrices.items()
        )
        return ('kind = "kalman_bucy"', *texts)

    def symbols(
        self, meant: Mapping[str, Meaning], domain: str, of: Collection[str]
    ) -> dict[str, Meaning]:
        """What the symbols are there. The domain of the claim, which speaks `of` symbols, belongs
        to the model where it speaks of densities alone.
        """
        names = quantity_names()
        found = {
            token: usual_letters.quantity(f"continuous_{name}", names[f"continuous_{name}"].meaning)
            if (name := each.quantity).startswith("gain.")
            else each
            for token, each in meant.items()
        }
        if domain and {*of} <= {self.measured, *self.driving.values()}:
            own = found[self.measured]
            both = ", ".join(filter(None, (own.domain, domain.replace(r"\quad ", ""))))
            found[self.measured] = replace(own, domain=both)
        return found


def order_of(meaning: Meaning) -> int | None:
    """The order of the derivative that a noise of this density drives, 0 of the density of a
    measured position; None of anything else.
    """
    if meaning.role != "free" or meaning.definition:
        return None
    unit = read_unit(meaning.unit)
    return next((order for order, text in enumerate(UNITS) if unit == read_unit(text)), None)


def densities(meant: Mapping[str, Meaning]) -> Densities | None:
    """The densities among the symbols; None where no measurement in continuous time is spoken of.
    Raises BadInputError where they are no whole model, or something else stands beside them.
    """
    found: dict[int, str] = {}
    for token, each in meant.items():
        order = order_of(each)
        if order is None:
            continue
        if order in found:
            raise BadInputError(
                f"{found[order]} and {token} are both in {UNITS[order]}, as densities of a "
                f"{NOISES[order]} are: which stands where is not guessed; {BY_FILE}"
            )
        found[order] = token
    measured = found.pop(0, None)
    foreign = [
        token
        for token, each in meant.items()
        if each.role != "free" and not each.quantity.startswith(CONTINUOUS)
    ]
    if measured is None or (not found and any(meant[t].role != "density" for t in foreign)):
        return None
    discrete = "or --model with the name of a filter in discrete time"
    if not found:
        raise BadInputError(
            f"{measured} in m^2 s is taken for the density of a measurement in continuous time: "
            "say what the density of the process noise is, --symbol 'q: m^2 s^-3 > 0' for a white "
            f"acceleration, m^2 s^-1 for a white velocity; {discrete}"
        )
    if foreign:
        token = foreign[0]
        if meant[token].role == "density":
            raise BadInputError(
                f"{token} is taken for another density of process noise: say of which by its unit, "
                f"--symbol '{token}: {UNITS[2]} > 0' for a {NOISES[2]}, or what else it is"
            )
        raise BadInputError(
            f"{token} is taken for the {meant[token].meaning}, which a filter in continuous time "
            f"does not have, and {measured} in m^2 s makes it one: say --symbol '{token}: ...', "
            f"{discrete}"
        )
    _refuse_others(meant, max(found))
    return Densities(measured, found)


def _refuse_others(meant: Mapping[str, Meaning], highest: int) -> None:
    """Raises BadInputError for a rate, which a model with other matrices holds, and for a component
    beyond the last that is driven.
    """
    for token, each in meant.items():
        parts = [int(part) for part in each.quantity.split(".") if part.isdigit()]
        if max(parts, default=0) > highest:
            needed = max(parts)
            raise BadInputError(
                f"{token} is a component {needed}, and no noise is said that drives it: "
                f"--symbol 'q: {UNITS[min(needed, 3)]} > 0' is the density of a "
                f"{NOISES[min(needed, 3)]}"
            )
        other = each.role == "free" and not each.definition and order_of(each) is None
        if other and read_unit(each.unit).second:
            raise BadInputError(
                f"{token} in {each.unit} is no density, and the model that is guessed, derivatives "
                f"of a position, does not hold it: if your model does, {BY_FILE}; if it is short "
                f"for something, say --symbol '{token}: = ...'"
            )
