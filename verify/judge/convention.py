"""Conventions a setting may leave open, chosen once for all its claims: process-noise family,
what the source calls gain, noise and covariance, number of the first sample, readings of slashes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.convention_effect import (
    Chosen,
    choices,
    name_of,
    with_conventions,
    with_units,
)
from gainproof.verify.judge.definition_reading import with_one_reading
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.fixed_gain.environment import fixed_gain
from gainproof.verify.judge.fixed_gain.matrices import gain_model, gain_model_key
from gainproof.verify.judge.setting.environment import Environment, NotEstablished, algebra
from gainproof.verify.judge.setting.kalman_bucy import kalman_bucy
from gainproof.verify.judge.setting.own_matrices import model_key
from gainproof.verify.judge.setting.own_model import own_environment
from gainproof.verify.judge.setting.quantities import fading, memory, steady_state

Model = Mapping[str, Any]
MOST_CONVENTIONS = 400
READING = ", reading "


@dataclass(frozen=True)
class Convention:
    """One way to fill in what the setting leaves open; `open` says whether anything was.

    `setting` has the units of that convention and one reading of each definition, which `reading`
    names where there are several. `name` tells conventions of one setting apart: it says what is
    filled in, usual values included, and nothing of what the setting states.
    """

    environment: Environment
    setting: Setting
    open: bool
    chosen: Chosen
    reading: str | None = None

    @property
    def name(self) -> str:
        """The environment's name, and the reading of definitions."""
        return self.environment.name + (f"{READING}{self.reading}" if self.reading else "")


@dataclass(frozen=True)
class Unusable:
    """A model of the caller that the judge could not solve, and why."""

    name: str
    reason: str


def conventions(
    setting: Setting, models: Sequence[Model], solved: dict[Any, Environment]
) -> Iterator[Convention | Unusable]:
    """All conventions that the setting admits, the usual ones first; `solved` keeps environments
    for other settings. Raises Undecided if they are too many, or for an unknown kind of setting.
    """
    found = list(choices(setting))
    readings = list(with_one_reading(setting))
    bases = list(_bases(setting, models, solved))
    if len(found) * len(readings) * len(bases) > MOST_CONVENTIONS:
        raise Undecided(f"more than {MOST_CONVENTIONS} conventions: state some of them")
    is_open = len(found) * len(bases) > 1 or setting.model == "search"
    for base in bases:
        if isinstance(base, Unusable):
            yield base
            continue
        for chosen in found:
            environment = with_conventions(base, chosen)
            searched = base.name if setting.model == "search" else ""
            named = ", ".join(filter(None, (searched, name_of(chosen, setting))))
            environment = replace(environment, name=named or base.name)
            for one, words in readings:
                yield Convention(environment, with_units(one, chosen), is_open, chosen, words)


def _bases(
    setting: Setting, models: Sequence[Model], solved: dict[Any, Environment]
) -> Iterator[Environment | Unusable]:
    """The environments of the setting's models, gains those of the filter."""
    match setting.kind:
        case "algebra":
            yield algebra()
        case "growing_memory" | "fading_memory":
            key = (setting.kind, setting.degree)
            if key not in solved:
                fitted = memory if setting.kind == "growing_memory" else fading
                solved[key] = fitted(setting.degree if setting.degree is not None else -1)
            yield solved[key]
        case "fixed_gain":
            yield _free(setting, solved)
        case "kalman_bucy":
            yield _established(setting, solved, kalman_bucy)
        case "steady_state" if setting.own_model is not None:
            yield _established(setting, solved, own_environment)
        case "steady_state":
            for model in _models(setting, models):
                yield _steady(model, solved)
        case _:
            raise Undecided(f"settings of kind {setting.kind} are not covered")


def _models(setting: Setting, models: Sequence[Model]) -> Iterator[Model]:
    """Those that may be meant: a filter has as many gains as states, so that a source which speaks
    of a second component, and of no third, means two states. What is searched for is the process
    noise: of models in which more than the position is measured a source says so.
    """
    if setting.model != "search":
        found = [m for m in models if m.get("name") == setting.model]
        if not found:
            raise Undecided(f"the model {setting.model!r} is not known")
        yield from found
        return
    last = _last_component(setting)
    found = [
        m
        for m in models
        if len(m.get("measurement_noise", ())) == 1
        and (last < 2 or len(m.get("transition", ())) == last)
    ]
    if not found:
        raise Undecided(f"no model with {last} states is known")
    yield from found


def _last_component(setting: Setting) -> int:
    """The highest number of a component of state, gain or covariance; 0 if there is none."""
    quantities = [entry.quantity or "" for entry in setting.symbols.values()]
    return max(
        (int(part) for q in quantities for part in q.split(".") if part.isdigit()), default=0
    )


def _established(
    setting: Setting, solved: dict[Any, Environment], made: Callable[[Setting], Environment]
) -> Environment | Unusable:
    """The environment of matrices of the setting's own."""
    key = (setting.kind, model_key(setting))
    try:
        if key not in solved:
            solved[key] = made(setting)
    except (Undecided, Malformed, NotEstablished) as reason:
        return Unusable(setting.name, str(reason))
    return solved[key]


def _free(setting: Setting, solved: dict[Any, Environment]) -> Environment | Unusable:
    key = ("gains", gain_model_key(setting))
    try:
        if key not in solved:
            solved[key] = fixed_gain(gain_model(setting))
    except (Undecided, Malformed, NotEstablished) as reason:
        return Unusable(setting.name, str(reason))
    return solved[key]


def _steady(model: Model, solved: dict[Any, Environment]) -> Environment | Unusable:
    key = ("steady", repr(sorted(model.items(), key=lambda item: item[0])))
    try:
        if key not in solved:
            solved[key] = steady_state(model)
    except (Undecided, Malformed, NotEstablished) as reason:
        return Unusable(str(model.get("name", "model")), str(reason))
    return solved[key]
