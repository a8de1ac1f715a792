"""Dimensions of what a file declares itself: domains, variances, units beside definitions, domains
of claims, matrices of a model of its own.

These are the file's words and not the source's, so that a contradiction is an error in the file.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry, Unit
from gainproof.verify.judge.convention_effect import choices, with_units
from gainproof.verify.judge.dimensions.dimension import Dimensions, agreed, times
from gainproof.verify.judge.dimensions.formula import (
    dimension,
    dimension_of,
    fault_of,
    in_said_units,
    names_of,
    relation_fault,
)
from gainproof.verify.judge.dimensions.symbol_dimensions import Names
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import symbols_of
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.meaning.definition_names import names_in

NOISES = ("process_noise", "measurement_noise")
ONE = Fraction(1)
CONTINUOUS = "kalman_bucy"
SECOND = Unit(second=ONE)
PER_TIME = {
    "transition": SECOND,
    "process_noise": SECOND,
    "measurement_noise": Unit() / SECOND,
}
"""What makes a matrix in continuous time, or a density, one of a transition or a covariance."""
Rows = Sequence[Sequence[Graph]]


@dataclass(frozen=True)
class Fault:
    """What is wrong with the dimensions in a field of the symbol `token`, or of the setting."""

    token: str | None
    field: str
    problem: str


def setting_fault(setting: Setting, own: Collection[str]) -> Fault | None:
    """The first contradiction in what a setting declares of its `own` symbols and of its model;
    None where some convention that it admits makes everything agree.
    """
    found: Fault | None = None
    for one in _with_units(setting):
        fault = next(_faults(one, own), None)
        if fault is None:
            return None
        found = found or fault
    return found


def says_units(setting: Setting) -> bool:
    """Whether a model of the setting's own says what its quantities count: the variance of its
    measurement is in square metres and, of several states, the interval is among its symbols.
    Numbers may count anything, so that no dimension of a gain or covariance can be wrong there.
    """
    own = setting.own_model
    if own is None:
        return True
    if setting.kind == CONTINUOUS:
        return _counts_positions(setting)
    if _unit(own.measurement_noise[0][0], setting) != Unit(metre=Fraction(2)):
        return False
    matrices = (own.transition, own.process_noise, own.measurement)
    trees = [read_tree(entry) for rows in matrices for row in rows for entry in row]
    names = {name for tree in trees for name in names_in(tree)}
    times = [e for t, e in setting.symbols.items() if t in names and e.unit == SECOND]
    return len(own.transition) == 1 or bool(times)


def _counts_positions(setting: Setting) -> bool:
    """Whether the entries of a model in continuous time are those of a position with its
    derivatives: a symbol of each noise has the unit of its density, all else fits.
    """
    said = set()
    for name, i, j, entry in _entries(setting):
        unit = _unit(entry, setting)
        metres = Fraction(2 if name in NOISES else 0)
        # of i - j derivatives in F, of i + j in Q
        seconds = {"transition": j - i, "process_noise": -i - j, "measurement": j}.get(name, 0)
        wanted = Unit(metre=metres, second=Fraction(seconds)) / PER_TIME.get(name, Unit())
        if _unit(entry, setting, numbers=True) not in (None, wanted):
            return False
        said |= {name} if unit is not None else set()
    return said >= set(NOISES)


def numbers_count(setting: Setting) -> bool:
    """Whether numbers in a model in continuous time count what symbols beside them have units of,
    as the rate 2 does in an A of -2: nothing can be compared with them then.
    """
    if setting.kind != CONTINUOUS or any(_model_faults(setting)):
        return False
    entries = [e for *_, e in _entries(setting) if symbols_of(read_tree(e))]
    mixed = any(dimension_of(entry, setting) is None for entry in entries)
    return mixed or any(_model_faults(setting, numbers=True))


def shared_fault(symbols: Mapping[str, SymbolEntry]) -> Fault | None:
    """The same of the symbols of the whole file, whatever the conventions of its settings are."""
    any_setting = Setting("", "algebra", "", symbols, noise="search", power_of_T="search")
    return setting_fault(any_setting, symbols)


def _with_units(setting: Setting) -> Iterator[Setting]:
    """The setting with the units of each convention that it admits, those that are alike once."""
    seen = set()
    for chosen in choices(setting):
        if (chosen.noise, chosen.power_of_T) not in seen:
            seen.add((chosen.noise, chosen.power_of_T))
            yield with_units(setting, chosen)


def domain_fault(claim: Claim, setting: Setting) -> str | None:
    """What is wrong in the domain of a claim under every convention, or None."""
    found: str | None = None
    for one in _with_units(setting) if claim.domain else ():
        names = names_of(in_said_units(claim.domain, one))
        faults = [f for r in claim.domain if (f := relation_fault(r, names)) is not None]
        if not faults:
            return None
        found = found or faults[0]
    return found


def _faults(setting: Setting, own: Collection[str]) -> Iterator[Fault]:
    names = names_of(setting)
    for token in own:
        entry = setting.symbols[token]
        for relation in entry.domain:
            if (problem := relation_fault(relation, names)) is not None:
                yield Fault(token, "domain", problem)
        yield from _definition_faults(token, entry, names)
        if entry.variance is not None and entry.unit is not None:
            wanted = times(entry.unit, entry.unit)
            what = f"the square of {token} and its variance"
            if (problem := _differs(entry.variance, wanted, what, names)) is not None:
                yield Fault(token, "variance", problem)
    yield from _model_faults(setting)


def _definition_faults(token: str, entry: SymbolEntry, names: Names) -> Iterator[Fault]:
    """A unit beside a definition: one reading must have it."""
    if entry.definition is None or entry.unit is None or entry.quantity is not None:
        return
    what = "the unit and the definition"
    problems = [
        _differs(reading.relations[0].right, names.of(token), what, names)
        for reading in entry.definition.readings
    ]
    if all(problem is not None for problem in problems):
        yield Fault(token, "definition", problems[0] or "")


def _differs(graph: Graph, wanted: Dimensions, what: str, names: Names) -> str | None:
    return fault_of(lambda one: agreed([wanted, dimension(read_tree(graph), one)], what), names)


def _model_faults(setting: Setting, *, numbers: bool = False) -> Iterator[Fault]:
    """Entries of F, Q, H and R from which no units of states and measurements follow; `numbers`
    have none.
    """
    solver = _Solver()
    continuous = setting.kind == CONTINUOUS
    if continuous and all(_unit(e, setting) in (None, Unit()) for *_, e in _entries(setting)):
        return  # all of it, times too, is counted in units of its own
    for name, i, j, entry in _entries(setting):
        unit = _unit(entry, setting, numbers=numbers)
        if unit is not None and continuous:
            unit = unit * PER_TIME.get(name, Unit())
        if unit is not None and not solver.agrees(_equation(name, i, j), unit):
            problem = f"the entry in row {i + 1}, column {j + 1} has a unit that fits no state"
            yield Fault(None, name, problem)


def _entries(setting: Setting) -> Iterator[tuple[str, int, int, Graph]]:
    """The matrices of the setting, entry by entry, with the place."""
    matrices: dict[str, Rows] = dict(setting.gain_matrices)
    if setting.own_model is not None:
        own = setting.own_model
        matrices = {
            "measurement_noise": own.measurement_noise,
            "measurement": own.measurement,
            "transition": own.transition,
            "process_noise": own.process_noise,
        }
    for name, rows in matrices.items():
        for i, row in enumerate(rows):
            for j, entry in enumerate(row):
                yield name, i, j, entry


def _unit(entry: Graph, setting: Setting, *, numbers: bool = False) -> Unit | None:
    """The unit of an entry; None of a number, which may be one in units of T or of a noise, unless
    `numbers` have none: 0 alone may be of any.
    """
    try:
        tree = read_tree(entry)
    except Malformed:
        return None
    if symbols_of(tree):
        return dimension_of(entry, setting)
    return Unit() if numbers and constant_value(tree) != 0 else None


def _equation(name: str, i: int, j: int) -> Mapping[str, int]:
    """How often the units of states and measurements stand in that of an entry."""
    row, column = ("z", "z") if name == "measurement_noise" else ("x", "x")
    if name == "measurement":
        row = "z"
    sign = 1 if name in NOISES else -1
    found = {f"{row}{i}": 1}
    found[f"{column}{j}"] = found.get(f"{column}{j}", 0) + sign
    return {unknown: count for unknown, count in found.items() if count}


class _Solver:
    """Linear equations between exponents of units, reduced as they come."""

    def __init__(self) -> None:
        self.rows: list[tuple[str, dict[str, Fraction], Unit]] = []

    def agrees(self, equation: Mapping[str, int], unit: Unit) -> bool:
        """Whether an equation contradicts none before; it is kept then."""
        left = {name: Fraction(count) for name, count in equation.items()}
        for pivot, row, value in self.rows:
            factor = left.get(pivot, Fraction(0))
            if factor:
                left = {
                    n: left.get(n, Fraction(0)) - factor * row.get(n, Fraction(0))
                    for n in {*left, *row}
                }
                unit = unit / value**factor
        left = {name: count for name, count in left.items() if count}
        if not left:
            return unit == Unit()
        pivot, count = next(iter(left.items()))
        scaled = unit ** (1 / count)
        self.rows.append((pivot, {n: c / count for n, c in left.items()}, scaled))
        return True
