"""What conventions make of a setting's quantities and of the units of its symbols."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from itertools import product

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    SAMPLE,
    Environment,
)

STATES = range(1, 5)
PREDICTOR = "predictor (F K)"


@dataclass(frozen=True)
class Chosen:
    """One value for each convention; the fields of `Setting` say what they mean."""

    gain: str = "filter"
    third_gain: str = "1"
    power_of_T: str = "1"
    noise: str = "deviation"
    index_origin: str = "0"
    covariance: str = "predicted"


VALUES: Mapping[str, tuple[str, ...]] = {
    "gain": ("filter", "predictor"),
    "third_gain": ("1", "1/2", "2"),
    "power_of_T": ("1", "0", "2"),
    "noise": ("deviation", "variance", "ratio"),
    "index_origin": ("0", "1"),
    "covariance": ("predicted", "updated"),
}
"""All conventions with their values, the usual one first."""
REACHED: Mapping[str, tuple[str, ...]] = {
    "gain": ("gain.",),
    "third_gain": ("gain.3",),
    "power_of_T": ("gain.2",),
    "noise": (INDEX, DEVIATION),
    "index_origin": (SAMPLE,),
    "covariance": ("covariance.",),
}
"""Beginnings of the quantities that a convention acts on."""


def reaches(name: str, setting: Setting) -> bool:
    """Whether a convention acts on a symbol of the setting."""
    quantities = [entry.quantity for entry in setting.symbols.values() if entry.quantity]
    return any(quantity.startswith(start) for quantity in quantities for start in REACHED[name])


def is_open(name: str, setting: Setting) -> bool:
    """Whether the setting leaves a convention open that acts on a symbol of it."""
    return getattr(setting, name) == "search" and reaches(name, setting)


def in_words(name: str, value: str, setting: Setting) -> str:
    """One value of a convention, the usual one too, in the symbols of the setting."""
    match name:
        case "gain":
            return f"gains are those of the {'filter (K)' if value == 'filter' else PREDICTOR}"
        case "third_gain":
            token = _token("gain.3", setting, "k_3")
            below = {"1": "{}/{}^2", "1/2": "2 {}/{}^2", "2": "{}/(2 {}^2)"}[value]
            return "the third gain K_3 = " + below.format(token, _token(INTERVAL, setting, "T"))
        case "power_of_T":
            token, interval = _token("gain.2", setting, "k_2"), _token(INTERVAL, setting, "T")
            divisor = {"0": "", "1": f"/{interval}"}.get(value, f"/{interval}^{value}")
            return f"the second gain K_2 = {token}{divisor}"
        case "noise":
            return f"noise is given as a {value}"
        case "index_origin":
            return f"the first sample has number {value}"
        case _:
            return f"the covariance is the {value} one"


def _token(quantity: str, setting: Setting, otherwise: str) -> str:
    found = (token for token, e in setting.symbols.items() if e.quantity == quantity)
    return next(found, otherwise)


def choices(setting: Setting) -> Iterator[Chosen]:
    """Every way to fill in what the setting leaves open and what acts on a symbol of it."""
    options = []
    for field in fields(Chosen):
        stated = getattr(setting, field.name)
        searched = VALUES[field.name] if stated == "search" else (stated,)
        options.append(searched if reaches(field.name, setting) else VALUES[field.name][:1])
    for values in product(*options):
        yield Chosen(*values)


def name_of(chosen: Chosen, setting: Setting) -> str:
    """What fills in that which the setting leaves open; empty if nothing is."""
    words = [in_words(n, getattr(chosen, n), setting) for n in VALUES if is_open(n, setting)]
    return ", ".join(words)


def with_conventions(environment: Environment, chosen: Chosen) -> Environment:
    """The quantities as the source counts and names them."""
    quantities = dict(environment.quantities)
    _name_gains(quantities, chosen)
    for name, value in list(quantities.items()):
        if name.startswith(f"{chosen.covariance}_covariance."):
            quantities[name.removeprefix(f"{chosen.covariance}_")] = value
    boxes, continued = dict(environment.boxes), dict(environment.continued)
    model = environment.model
    if chosen.index_origin == "1" and SAMPLE in boxes:
        boxes[SAMPLE] = _later(boxes[SAMPLE])
        before = {SAMPLE: symbol(SAMPLE) - 1}
        quantities = _replaced(quantities, before) | {SAMPLE: symbol(SAMPLE)}
        continued = _replaced(continued, before)
        model = {**model, "first": ((number(1),),)} if model else model
    if chosen.noise == "ratio":
        quantities = _replaced(quantities, {DEVIATION: number(1)})
        model = {
            name: tuple(tuple(substituted(e, {DEVIATION: number(1)}) for e in row) for row in rows)
            for name, rows in model.items()
        }
    if chosen.noise != "deviation":
        for name in (INDEX, DEVIATION):
            if name in quantities:
                quantities[name] = power(quantities[name], 2)
    chart = None if environment.chart is None else with_conventions(environment.chart, chosen)
    region = environment.region
    if region is not None:
        region = replace(region, charted=with_conventions(region.charted, chosen))
    return replace(
        environment,
        quantities=quantities,
        boxes=boxes,
        continued=continued,
        chart=chart,
        region=region,
        model=model,
    )


def _name_gains(quantities: dict[str, Expr], chosen: Chosen) -> None:
    """`gain.i` from the gains of filter or predictor, scaled."""
    interval = symbol(INTERVAL)
    for i in STATES:
        gain = quantities.get(f"{chosen.gain}_gain.{i}")
        if gain is None:
            continue
        if i == 2 and chosen.power_of_T != "1":
            exponent = int(chosen.power_of_T) - 1
            gain = gain * interval if exponent == 1 else gain / interval
        if i == 3 and chosen.third_gain != "1":
            gain = number(Fraction(chosen.third_gain)) * gain
        quantities[f"gain.{i}"] = gain


def _replaced(quantities: Mapping[str, Expr], values: Mapping[str, Expr]) -> dict[str, Expr]:
    return {name: substituted(expr, values) for name, expr in quantities.items()}


def _later(box: Box) -> Box:
    """The same samples with numbers greater by one."""
    lower = None if box.lower is None else box.lower + 1
    upper = None if box.upper is None else box.upper + 1
    return replace(box, lower=lower, upper=upper)


def with_units(setting: Setting, chosen: Chosen) -> Setting:
    """The setting with the units that symbols have under the conventions."""
    if chosen.noise == "deviation" and chosen.power_of_T == "1":
        return setting
    symbols = {token: _with_unit(entry, chosen) for token, entry in setting.symbols.items()}
    return replace(setting, symbols=symbols)


def _with_unit(entry: SymbolEntry, chosen: Chosen) -> SymbolEntry:
    if entry.quantity is None or entry.unit is None:
        return entry
    unit = entry.unit
    if entry.quantity == "gain.2":
        unit = replace(unit, second=unit.second + int(chosen.power_of_T) - 1)
    if entry.quantity == DEVIATION and chosen.noise == "variance":
        unit = unit**2
    if chosen.noise == "ratio":
        unit = replace(unit, metre=Fraction(0))
    return replace(entry, unit=unit)
