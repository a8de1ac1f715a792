"""The meaning of each kind of statement, tried at sampled points."""

from __future__ import annotations

import random
from itertools import pairwise
from typing import Any

import mpmath as mp
from tests.verify.certificate.numeric_truth import DIGITS, Truth, agree, point

Data = dict[str, Any]


def seems_true(certificate: Data, statement: Data, seed: int, points: int = 4) -> bool:
    """Whether the statement holds at a few random points of its tower (divisions by 0: no)."""
    truth = Truth(certificate["towers"][statement["tower"]])
    generator = random.Random(seed)
    with mp.workdps(DIGITS):
        try:
            kind = _KINDS[statement["kind"]]
            return bool(kind(certificate, statement["claim"], truth, generator, points))
        except (ZeroDivisionError, AssertionError):
            return False


def _points(truth: Truth, generator: random.Random, points: int) -> list[Data]:
    return [point(truth.tower, generator) for _ in range(points)]


def _equal(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, points):
        place |= {name: mp.mpf(generator.uniform(-3, 3)) for name in claim["free"]}
        if not agree(
            truth.value(claim["left"], place), truth.value(claim["right"], place), mp.mpf(10) ** -15
        ):
            return False
    return True


def _positive(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    return all(
        truth.value(claim["expression"], place) > 0 for place in _points(truth, generator, points)
    )


def _same_sign(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    return all(
        mp.sign(truth.value(claim["left"], place)) == mp.sign(truth.value(claim["right"], place))
        for place in _points(truth, generator, points)
    )


def _tends(truth: Truth, expression: Data, wanted: Any, end: tuple[str, bool], place: Data) -> bool:
    """Close to the limit, at two distances from the end; the other parameters are held."""
    name, at_infinity = end
    (parameter,) = (p for p in truth.tower["parameters"] if p["symbol"] == name)
    lower = mp.mpf(parameter.get("from", "0"))
    seen = []
    # where another parameter is held far out the limit is reached later
    for power in (6, 9) if len(truth.tower["parameters"]) == 1 else (10, 14):
        distance = mp.mpf(10) ** (power if at_infinity else -power)
        seen.append(truth.value(expression, {**place, name: lower + distance}))
    if wanted == "infinity":
        return bool(seen[1] > seen[0] > 100)
    target = truth.value(wanted, {**place, name: lower + 1})
    return agree(seen[1], target, mp.mpf(10) ** -4)


def _limit(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    at_infinity = claim["point"] == "infinity"
    ends = {"nodes": [["symbol", claim["variable"]]], "outputs": {"value": 0}}
    zero = {"nodes": [["number", "0"]], "outputs": {"value": 0}}
    for place in _points(truth, generator, _places(truth, points)):
        end = truth.moving(claim["variable"], place), at_infinity
        reached = _tends(truth, ends, "infinity" if at_infinity else zero, end, place)
        if not reached or not _tends(truth, claim["expression"], claim["value"], end, place):
            return False
    return True


def _places(truth: Truth, points: int) -> int:
    """At how many points of the other parameters something is tried."""
    return points if len(truth.tower["parameters"]) > 1 else 1


def _ordered(
    claim: Data, truth: Truth, generator: random.Random, place: Data, points: int
) -> tuple[bool, str]:
    """Whether the expression grows with the variable, and the parameter that moves it."""
    symbol = truth.moving(claim["variable"], place)
    places = [{**place, symbol: p[symbol]} for p in _points(truth, generator, points + 2)]
    pairs = sorted(
        (truth.names(p)[claim["variable"]], truth.value(claim["expression"], p)) for p in places
    )
    return all(a[1] < b[1] for a, b in pairwise(pairs)), symbol


def _increasing(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, _places(truth, points)):
        ordered, symbol = _ordered(claim, truth, generator, place, points)
        if not (
            ordered
            and _tends(truth, claim["expression"], claim["from"], (symbol, False), place)
            and _tends(truth, claim["expression"], claim["to"], (symbol, True), place)
        ):
            return False
    return True


def _monotone(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, points):
        symbol = truth.moving(claim["variable"], place)
        near = {**place, symbol: place[symbol] * 2 + 1}
        first, second = truth.names(place), truth.names(near)
        run = second[claim["variable"]] - first[claim["variable"]]
        rise = truth.value(claim["expression"], near) - truth.value(claim["expression"], place)
        if not (rise * run > 0 if claim["trend"] == "increasing" else rise * run < 0):
            return False
    return True


def _matrix(rows: Any, names: Data | None = None) -> Any:
    def entry(text: str) -> Any:
        if names is not None:
            return names[text]
        above, _, below = text.partition("/")
        return mp.mpf(int(above)) / int(below or 1)

    return mp.matrix([[entry(text) for text in row] for row in rows])


def _model(claim: Data, truth: Truth, place: Data) -> list[Any]:
    """Transition, process noise, measurement and measurement noise at a point."""

    def entry(value: Any) -> Any:
        if isinstance(value, dict):
            return truth.value(value, place)
        above, _, below = value.partition("/")
        return mp.mpf(int(above)) / int(below or 1)

    fields = ("transition", "process_noise", "measurement", "measurement_noise")
    return [
        mp.matrix([[entry(value) for value in row] for row in claim["model"][field]])
        for field in fields
    ]


def _gain(claim: Data, names: Data) -> Any:
    return _matrix([[row] if isinstance(row, str) else row for row in claim["gain"]], names)


def _riccati(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, points):
        step, noise, seen, measured = _model(claim, truth, place)
        names = truth.names(place)
        before, after = _matrix(claim["predicted"], names), _matrix(claim["updated"], names)
        gain = _gain(claim, names)
        variance = seen * before * seen.T + measured
        tolerance = mp.mpf(10) ** -20 * (1 + mp.mnorm(before))
        if not (
            all(mp.det(variance[:n, :n]) > 0 for n in range(1, variance.rows + 1))
            and agree(measured, measured.T)
            and agree(gain, before * seen.T * variance**-1, tolerance)
            and agree(after, before - gain * seen * before, tolerance)
            and agree(before, step * after * step.T + names[claim["index"]] ** 2 * noise, tolerance)
        ):
            return False
    return True


def _stable(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, points):
        step, _noise, seen, _measured = _model(claim, truth, place)
        gain = _gain(claim, truth.names(place))
        loop = step * (mp.eye(step.rows) - gain * seen)
        # mpmath gives the eigenvalue of a 1 by 1 matrix another shape
        roots = [loop[0]] if loop.rows == 1 else mp.eig(loop, left=False, right=False)
        if not all(abs(root) < 1 for root in roots):
            return False
    return True


def _definite(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    for place in _points(truth, generator, points):
        matrix = _matrix(claim["matrix"], truth.names(place))
        if not agree(matrix, matrix.T) or not all(
            mp.det(matrix[:n, :n]) > 0 for n in range(1, matrix.rows + 1)
        ):
            return False
    return True


def _program(
    certificate: Data,
    claim: Data,
    truth: Truth,
    generator: random.Random,
    points: int,
) -> bool:
    program = certificate["programs"][claim["program"]]
    for place in _points(truth, generator, points):
        names = truth.names(place)
        inputs = {
            symbol: names[meaning] if isinstance(meaning, str) else truth.value(meaning, place)
            for symbol, meaning in program["inputs"].items()
        }
        kernel = Truth({"parameters": [], "generators": [], "elements": {}})
        for output, expression in claim["outputs"].items():
            found = kernel.value(program["graph"], inputs, output)
            if not agree(found, truth.value(expression, place), mp.mpf(10) ** -20):
                return False
    return True


def _sum(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    del generator
    start = int(claim["start"])
    total = mp.mpf(0)
    for upper in range(start, start + points + 2):
        inner = Truth({"parameters": [], "generators": [], "elements": {}})
        total += inner.value(claim["summand"], {claim["index"]: mp.mpf(upper)})
        if not agree(total, truth.value(claim["closed"], {claim["upper"]: mp.mpf(upper)})):
            return False
    return True


def _nothing(*_: Any) -> bool:
    return True


_KINDS: dict[str, Any] = {
    "equal": _equal,
    "positive": _positive,
    "same_sign": _same_sign,
    "limit": _limit,
    "increasing_onto": _increasing,
    "monotone": _monotone,
    "riccati": _riccati,
    "stable": _stable,
    "positive_definite": _definite,
    "program": _program,
    "sum": _sum,
    "definition": _nothing,
    "cited": _nothing,
}
