"""Conventions a setting may leave open, chosen once for all its claims: process-noise family and
form of the gain.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.verify.judge.claim_record import OwnModel, Setting
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.setting.environment import Environment, NotEstablished, algebra
from gainproof.verify.judge.setting.quantities import memory, steady_state

Model = Mapping[str, Any]


@dataclass(frozen=True)
class Convention:
    """One way to fill in what the setting leaves open; `open` says whether anything was."""

    environment: Environment
    open: bool


@dataclass(frozen=True)
class Unusable:
    """A model of the caller that the judge could not solve, and why."""

    name: str
    reason: str


def conventions(
    setting: Setting, models: Sequence[Model], solved: dict[Any, Environment]
) -> Iterator[Convention | Unusable]:
    """All conventions that the setting admits; `solved` keeps environments for other settings."""
    forms = ("filter", "predictor") if setting.gain == "search" else (setting.gain,)
    match setting.kind:
        case "algebra":
            yield Convention(algebra(), False)
        case "growing_memory":
            for form in forms:
                key = ("memory", setting.degree, form)
                if key not in solved:
                    solved[key] = memory(setting.degree if setting.degree is not None else -1, form)
                yield Convention(solved[key], len(forms) > 1)
        case "steady_state":
            chosen = list(_models(setting, models))
            for form in forms:
                for model in chosen:
                    yield _steady(model, form, solved, len(forms) > 1 or setting.model == "search")
        case _:
            raise Undecided(f"settings of kind {setting.kind} are not covered")


def _models(setting: Setting, models: Sequence[Model]) -> Iterator[Model]:
    if setting.own_model is not None:
        yield own_model(setting.name, setting.own_model)
        return
    found = [m for m in models if setting.model in ("search", m.get("name"))]
    if not found:
        raise Undecided(f"the model {setting.model!r} is not known")
    yield from found


def _steady(
    model: Model, form: str, solved: dict[Any, Environment], is_open: bool
) -> Convention | Unusable:
    key = ("steady", repr(sorted(model.items(), key=lambda item: item[0])), form)
    try:
        if key not in solved:
            solved[key] = steady_state(model, form)
    except (Undecided, Malformed, NotEstablished) as reason:
        return Unusable(str(model.get("name", "model")), str(reason))
    return Convention(solved[key], is_open)


def own_model(name: str, model: OwnModel) -> Model:
    """A source's own model as model data; its entries must be numbers in units T = 1, noise
    variance 1.
    """

    def rows(matrix: tuple[tuple[Any, ...], ...]) -> list[list[str]]:
        made = []
        for row in matrix:
            values = [constant_value(read_graph(entry)) for entry in row]
            if any(v is None for v in values):
                raise Undecided(
                    "a model of the source's own with symbols in its matrices is not covered"
                )
            made.append([str(v) for v in values])
        return made

    return {
        "name": name,
        "transition": rows(model.transition),
        "process_noise": rows(model.process_noise),
        "measurement": rows(model.measurement),
        "measurement_noise": rows(model.measurement_noise),
    }
