"""What letters usually mean in the field: gains, noises, times, entries of covariances."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType
from typing import Any


@dataclass(frozen=True)
class Meaning:
    """What a symbol stands for: a quantity of a filter (a name of `quantity_names`), the deviation
    or the spectral density of its process noise, or a free number.

    Attributes
    ----------
    role : str
        "quantity", "deviation", "density" or "free".
    meaning : str
        In words.
    quantity : str
        Name of the quantity; empty for other roles.
    unit, domain : str
        Of a free number: its unit, "1" without one, and where it lies, as a condition on it.
    definition : str
        A formula that the symbol is short for.
    integer : bool
        Whether a free number is a whole one.
    """

    role: str
    meaning: str
    quantity: str = ""
    unit: str = "1"
    domain: str = ""
    definition: str = ""
    integer: bool = False


REAL = "real number"
"""The meaning of a letter of which nothing is known."""
_ORDINALS = ("position", "velocity", "acceleration")
_STATES = {"the measured position": "the measurement"} | {
    f"the {word}": f"state {number}" for number, word in enumerate(_ORDINALS, 1)
}
_GAIN_LETTERS = {r"\alpha": 1, r"\beta": 2, r"\gamma": 3}
_NAMED_GAINS = (("g", 1), ("h", 2), ("k", 3))
"""Of a g-h or g-h-k filter: only where no other letters but those of a filter stand beside them."""
NOISE_ORDERS: Mapping[str, tuple[str, int, str]] = MappingProxyType(
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
_INDEX = (r"\Lambda", r"\lambda", r"\Gamma")
_INTERVALS = ("T", "dt", r"\Delta t", r"\Delta T", "T_s", "t_s", r"\tau")
_MEASUREMENT_DEVIATIONS = tuple(rf"\sigma_{x}" for x in ("v", "n", "m", "z", "o", "x", "r"))
_PROCESS_DEVIATIONS = (r"\sigma_w", r"\sigma_a", r"\sigma_q", r"\sigma_u")
_DENSITIES = ("q", r"\tildeq", "q_c")
"""Without braces, as `bare` writes them."""
_SAMPLES = ("k", "n", "N")
_COVARIANCES = {
    "P": ("covariance", "covariance, predicted or updated"),
    "M": ("predicted_covariance", "predicted covariance"),
    r"\tildeP": ("predicted_covariance", "predicted covariance"),
    "X": ("updated_covariance", "updated covariance"),
    r"\hatP": ("updated_covariance", "updated covariance"),
}
SAMPLE_WORDS = "number of the sample, the first being 0"
_LETTERS = (
    *_GAIN_LETTERS,
    *(f"K_{n}" for n in (1, 2, 3)),
    *(f"{letter}_{k}" for letter in _GAIN_LETTERS for k in _SAMPLES),
    *_SAMPLES,
    *_INDEX,
    *_INTERVALS,
    *_MEASUREMENT_DEVIATIONS,
    *_PROCESS_DEVIATIONS,
    *("q", r"\tilde{q}", "q_c", "R", "S"),
    *(
        f"{letter}_{{{i}{j}}}"
        for letter in ("P", "M", r"\tilde{P}", "X", r"\hat{P}")
        for i in (1, 2, 3)
        for j in (1, 2, 3)
    ),
)
"""All letters with a meaning of their own, as the reader writes them."""
_NOT_IN: Mapping[str, frozenset[str]] = MappingProxyType(
    {
        "steady_state": frozenset(),
        "growing_memory": frozenset(("tracking_index",)),
        "fading_memory": frozenset(("tracking_index",)),
        "fixed_gain": frozenset(("tracking_index",)),
    }
)
"""The kinds of settings with a filter, and quantities that it does not have."""
_ENTRIES = ("covariance.", "predicted_covariance.", "updated_covariance.")
_ENTRY = re.compile(r"(.+)_([123])([123])")
_GAIN = re.compile(r"K_([123])")
_NUMBERED = re.compile(r"(\\alpha|\\beta|\\gamma)_([knN])")


def bare(token: str) -> str:
    """A symbol without braces: P_11 of `P_{11}`."""
    return token.replace("{", "").replace("}", "")


def quantity(name: str, meaning: str) -> Meaning:
    """A quantity of a filter."""
    return Meaning("quantity", meaning, quantity=name)


def filter_meanings(tokens: Sequence[str]) -> Mapping[str, Meaning]:
    """What those of the symbols usually mean that have a meaning in a filter, by symbol."""
    found: dict[str, Meaning] = {}
    plain = {token: bare(token) for token in tokens}
    for token, name in plain.items():
        meaning = _meaning(name)
        if meaning is not None:
            found[token] = meaning
    named = [(token, order) for token, order in _NAMED_GAINS if token in tokens]
    if {"g", "h"} <= set(tokens) and set(tokens) <= {*found, "g", "h", "k"}:
        found |= {token: _gain(order) for token, order in named}
    numbers = {match[2] for name in plain.values() if (match := _NUMBERED.fullmatch(name))}
    for token in tokens:
        if token in numbers or (token in _SAMPLES and numbers):
            found[token] = quantity("sample_number", SAMPLE_WORDS)
    return MappingProxyType(found)


def of_any_states(meaning: Meaning) -> Meaning:
    """Of a model whose states are no position and its rates: its words by the number of a state."""
    words = meaning.meaning
    for position, state in _STATES.items():
        words = words.replace(position, state)
    return replace(meaning, meaning=words)


def is_anchor(meaning: Meaning) -> bool:
    """Whether a formula that holds this is about a filter: times and noises alone are not."""
    gains = ("gain.", "filter_gain.", "predictor_gain.", "continuous_gain.")
    return meaning.quantity.startswith((*gains, *_ENTRIES))


def is_sound(meanings: Collection[Meaning]) -> bool:
    """Whether these are of quantities of a filter, no two of one, with a gain or an entry of a
    covariance among them: K_2 beside beta is another thing than beta.
    """
    quantities = [each.quantity for each in meanings if each.quantity]
    return len(set(quantities)) == len(quantities) and any(map(is_anchor, meanings))


def is_numbered(token: str) -> bool:
    """Whether it is a gain of sample k: alpha_k."""
    return _NUMBERED.fullmatch(bare(token)) is not None


@lru_cache(maxsize=64)
def usual_letters(kind: str, model: str | None) -> Mapping[str, Meaning]:
    """What each letter of the table means in a setting of this kind with this model of the
    catalogue, whatever formulas there are: none of a kind without a filter, the strength of a
    process noise only where the model says what that is.
    """
    if kind not in _NOT_IN:
        return MappingProxyType({})
    strength = NOISE_ORDERS.get(model or "", ("", 0, ""))[0]
    found = {}
    for token in _LETTERS:
        meaning = _meaning(bare(token))
        if token in _SAMPLES:
            meaning = quantity("sample_number", SAMPLE_WORDS)
        assert meaning is not None
        is_noise = meaning.role in ("deviation", "density")
        numbered = is_numbered(token) or token in _SAMPLES
        if (is_noise and meaning.role != strength) or (numbered and kind != "growing_memory"):
            continue
        if meaning.quantity not in _NOT_IN[kind]:
            found[token] = meaning
    return MappingProxyType(found)


def _gain(order: int) -> Meaning:
    return quantity(f"gain.{order}", f"gain of the {_ORDINALS[order - 1]}")


def _meaning(name: str) -> Meaning | None:
    if name in _GAIN_LETTERS:
        return _gain(_GAIN_LETTERS[name])
    if match := _NUMBERED.fullmatch(name):
        return _gain(_GAIN_LETTERS[match[1]])
    if match := _GAIN.fullmatch(name):
        return _gain(int(match[1]))
    if name in _INDEX:
        return quantity("tracking_index", "tracking index")
    if name in _INTERVALS:
        return quantity("sampling_interval", "time between samples")
    if name == "R":
        return quantity("measurement_noise_variance", "variance of the measured position")
    if name == "S":
        return quantity("innovation_variance", "variance of the innovation")
    if name in _MEASUREMENT_DEVIATIONS:
        return quantity("measurement_noise_deviation", "deviation of the measured position")
    if name in _PROCESS_DEVIATIONS:
        return Meaning("deviation", "deviation of the process noise")
    if name in _DENSITIES:
        return Meaning("density", "spectral density of the process noise")
    match = _ENTRY.fullmatch(name)
    if match and match[1] in _COVARIANCES:
        kind, words = _COVARIANCES[match[1]]
        row, column = sorted((int(match[2]), int(match[3])))
        return quantity(f"{kind}.{row}.{column}", f"entry {row} {column} of the {words}")
    return None


def entry_of(meaning: Meaning) -> dict[str, Any]:
    """The declaration of a symbol with this meaning."""
    entry: dict[str, Any] = {"meaning": meaning.meaning}
    if meaning.definition:
        return entry | {"definition": meaning.definition}
    if meaning.role == "quantity":
        return entry | {"quantity": meaning.quantity}
    entry["unit"] = meaning.unit
    if meaning.domain:
        entry["domain"] = meaning.domain
    return entry | ({"integer": True} if meaning.integer else {})
