"""The statements of derivations before the judge, whole or a sample spread over their kinds."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from catalogue_subjects import certificate, derived
from judged_derivations.relation import judge_statement
from judged_derivations.surroundings import Surroundings, surroundings

from gainproof.derive.catalogue import CATALOGUE, Entry
from gainproof.verify.judge.setting.quantities import steady_state

DEGREES = {"least-squares-mean": 0, "least-squares-line": 1, "least-squares-parabola": 2}

# the judge reads relations over one index; those over several parameters, and those of matrices of
# any size, have the checker alone
SEVERAL = (
    *("position-velocity", "recursion", "interacting", "polar", "alpha-beta", "filter-step"),
    *("range-doppler", "bearings-only", "multipath-location", "converted-measurements"),
    "updated-gains",
)
OF_ONE_INDEX: tuple[Entry, ...] = tuple(
    entry for entry in CATALOGUE if not entry.name.startswith(SEVERAL)
)
# what the judge searches for and gives up, after tens of seconds, kernels that hold a fixed point
# over an index that holds roots, and a slope that it cannot tell from 0: the checker alone
GIVEN_UP = {
    ("continuous-white-jerk", "discriminant"): "undecided",
    ("continuous-white-jerk", "kernel-closed-loop-poles"): "undecided",
    ("random-jerk", "kernel-closed-loop-poles"): "undecided",
    ("random-jerk", "turns-once-updated-22"): "held",
}
# whole they take more than five seconds: a campaign
SAMPLED = ("random-jerk", "continuous-white-jerk")
OF_A_KIND = 2
SLOW_OF_SAMPLED = ("concave",)  # seconds each in the sampled families


def sample(name: str, seed: int) -> list[int]:
    """Numbers of statements: up to `OF_A_KIND` of every kind, none of those known to take long
    or to have the checker alone.
    """
    chooser = random.Random(f"{name} {seed}")
    kinds: dict[str, list[int]] = {}
    for number, statement in enumerate(certificate(name)["statements"]):
        kind, known = statement["kind"], statement["id"]
        if not (
            _of_a_pair(name, statement)
            or (name, known) in GIVEN_UP
            or known.startswith(SLOW_OF_SAMPLED)
        ):
            kinds.setdefault(kind, []).append(number)
    return sorted(
        number
        for numbers in kinds.values()
        for number in chooser.sample(numbers, min(OF_A_KIND, len(numbers)))
    )


def _of_a_pair(name: str, statement: Mapping[str, Any]) -> bool:
    """Whether a tower holds a coupled pair, which the judge does not read: the checker alone."""
    tower = certificate(name)["towers"][statement["tower"]]
    return any("coupled" in generator for generator in tower["generators"])


def unjudged(name: str) -> list[str]:
    """Ids of the statements of towers with a coupled pair: `judged` leaves them out."""
    statements = certificate(name)["statements"]
    return [statement["id"] for statement in statements if _of_a_pair(name, statement)]


def undecided(name: str) -> list[str]:
    """Ids of statements that are judged and, as is known, not proved."""
    return sorted(statement for family, statement in GIVEN_UP if family == name)


def judged(name: str, numbers: Sequence[int] | None = None) -> Iterator[tuple[str, str]]:
    """The id of each chosen statement that is judged and what is wrong with its verdict, or
    nothing. Of those in `unjudged` there is none.
    """
    written = certificate(name)
    degree = DEGREES.get(name)
    model = derived(name).model if degree is None else None

    environment = steady_state(model) if model is not None else None

    @cache
    def around(tower: str) -> Surroundings:
        return surroundings(model, degree, written["towers"][tower], environment)

    statements: list[dict[str, Any]] = written["statements"]
    for number in range(len(statements)) if numbers is None else numbers:
        statement = statements[number]
        kind, known = statement["kind"], (name, statement["id"])
        if _of_a_pair(name, statement):
            continue
        finding = judge_statement(
            kind,
            statement["claim"],
            programs=written["programs"],
            around=around(statement["tower"]),
        )
        expected = {"definition": "definition", "cited": "remark"}.get(kind, "proved")
        expected = GIVEN_UP.get(known, expected)
        wrong = "" if finding.verdict == expected else f"{finding.verdict}: {finding.reason}"
        yield statement["id"], wrong
