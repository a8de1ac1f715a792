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


def _tends(truth: Truth, expression: Data, wanted: Any, at_infinity: bool) -> bool:
    """Close to the limit, at two distances from the end."""
    (parameter,) = truth.tower["parameters"]
    lower = mp.mpf(parameter.get("from", "0"))
    seen = []
    for power in (6, 9):
        distance = mp.mpf(10) ** (power if at_infinity else -power)
        seen.append(truth.value(expression, {parameter["symbol"]: lower + distance}))
    if wanted == "infinity":
        return bool(seen[1] > seen[0] > 100)
    target = truth.value(wanted, {parameter["symbol"]: lower + 1})
    return agree(seen[1], target, mp.mpf(10) ** -4)


def _limit(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    del generator, points
    at_infinity = claim["point"] == "infinity"
    ends = {"nodes": [["symbol", claim["variable"]]], "outputs": {"value": 0}}
    zero = {"nodes": [["number", "0"]], "outputs": {"value": 0}}
    return _tends(truth, ends, "infinity" if at_infinity else zero, at_infinity) and _tends(
        truth, claim["expression"], claim["value"], at_infinity
    )


def _increasing(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    symbol = truth.tower["parameters"][0]["symbol"]
    places = sorted(_points(truth, generator, points + 2), key=lambda place: place[symbol])
    values = [truth.value(claim["expression"], place) for place in places]
    variable = [truth.names(place)[claim["variable"]] for place in places]
    ordered = all(a < b for found in (values, variable) for a, b in pairwise(found))
    return (
        ordered
        and _tends(truth, claim["expression"], claim["from"], False)
        and _tends(truth, claim["expression"], claim["to"], True)
    )


def _matrix(rows: Any, names: Data | None = None) -> Any:
    def entry(text: str) -> Any:
        if names is not None:
            return names[text]
        above, _, below = text.partition("/")
        return mp.mpf(int(above)) / int(below or 1)

    return mp.matrix([[entry(text) for text in row] for row in rows])


def _riccati(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    step, noise, seen, measured = (
        _matrix(claim["model"][field])
        for field in ("transition", "process_noise", "measurement", "measurement_noise")
    )
    for place in _points(truth, generator, points):
        names = truth.names(place)
        before, after = _matrix(claim["predicted"], names), _matrix(claim["updated"], names)
        gain = _matrix([[name] for name in claim["gain"]], names)
        variance = (seen * before * seen.T + measured)[0]
        tolerance = mp.mpf(10) ** -20 * (1 + mp.mnorm(before))
        if not (
            variance > 0
            and agree(gain, before * seen.T / variance, tolerance)
            and agree(after, before - gain * seen * before, tolerance)
            and agree(before, step * after * step.T + names[claim["index"]] ** 2 * noise, tolerance)
        ):
            return False
    return True


def _stable(_: Data, claim: Data, truth: Truth, generator: random.Random, points: int) -> bool:
    step, seen = _matrix(claim["model"]["transition"]), _matrix(claim["model"]["measurement"])
    for place in _points(truth, generator, points):
        gain = _matrix([[name] for name in claim["gain"]], truth.names(place))
        loop = step * (mp.eye(step.rows) - gain * seen)
        if not all(abs(root) < 1 for root in mp.eig(loop, left=False, right=False)):
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
    "riccati": _riccati,
    "stable": _stable,
    "positive_definite": _definite,
    "program": _program,
    "sum": _sum,
    "definition": _nothing,
    "cited": _nothing,
}
