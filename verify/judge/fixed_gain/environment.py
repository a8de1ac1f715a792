"""The environment of a filter with free gains, in the gains themselves and, where that helps, in
coordinates that run through exactly the stable filters.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, add, number, power, symbol, whole_power
from gainproof.verify.judge.exact.polynomial import Poly, fraction, terms
from gainproof.verify.judge.fixed_gain.closed_loop import Loop, closed_loop, steps_of_gains
from gainproof.verify.judge.fixed_gain.lag import MOST_ORDER, Lag, is_taylor, lag
from gainproof.verify.judge.fixed_gain.matrices import GainModel
from gainproof.verify.judge.fixed_gain.rational_system import lowest, numerator_and_denominator
from gainproof.verify.judge.fixed_gain.variance import (
    Covariance,
    from_measurement,
    from_process,
)
from gainproof.verify.judge.setting.environment import (
    ANY_REAL,
    DEVIATION,
    INDEX,
    INTERVAL,
    POSITIVE,
    SAMPLE,
    Environment,
    Fact,
    NotEstablished,
)
from gainproof.verify.judge.setting.matrices import Exprs, exprs, times
from gainproof.verify.judge.setting.quantities import (
    base_boxes,
    common_quantities,
    covariances_in_units,
    filter_states,
)
from gainproof.verify.judge.setting.stable_region import StableRegion

T = symbol(INTERVAL)
SAMPLES = Box(lower=number(0).fraction, lower_open=False, integer=True)
STEADY = ("predicted_covariance.", "updated_covariance.", "covariance.", "innovation_variance")
LAGS = ("predicted_lag.", "updated_lag.")
Change = Callable[[Expr], Expr]
HURWITZ = (
    (
        "a real polynomial with a positive leading coefficient has all roots in the left half "
        "plane exactly if its coefficients and Hurwitz determinants are positive"
    ),
    "F. R. Gantmacher, Applications of the Theory of Matrices, 1959, chapter V",
)
LYAPUNOV = (
    (
        "the Lyapunov equation of a stable matrix has one solution, to which the covariance tends "
        "whatever it starts from"
    ),
    "P. Lancaster, L. Rodman, Algebraic Riccati Equations, Oxford 1995, chapter 5",
)
METHOD = "identity of polynomials"


@dataclass(frozen=True)
class _Parts:
    """What was found, in units T = 1 and measurement noise 1; `driven` belong to entries of the
    process noise.
    """

    loop: Loop
    measured: Covariance
    driven: tuple[tuple[tuple[int, int], Covariance], ...]
    lags: Mapping[int, Lag]


def fixed_gain(model: GainModel) -> Environment:
    """All quantities of the filter for any gains; steady ones have a value where it is stable.
    Raises Undecided.
    """
    loop = closed_loop(model.transition, model.measurement)
    pairs = tuple(model.noise)
    parts = _Parts(
        loop,
        from_measurement(loop),
        tuple(zip(pairs, from_process(loop, pairs), strict=True)),
        {m: lag(loop, m) for m in range(MOST_ORDER + 1)} if is_taylor(loop.transition) else {},
    )
    facts = loop_facts()
    plain = _environment(parts, model, lambda expr: expr, loop.gains)
    charted = _environment(parts, model, _over_steps(loop), loop.steps)
    charted = replace(charted, facts=(*facts, *chart_facts(loop)))
    boxes = dict.fromkeys(loop.gains, ANY_REAL)
    region = StableRegion(
        loop.region, (*STEADY, *LAGS), loop.gains, loop.steps, steps_of_gains(loop), charted
    )
    return replace(plain, boxes={**plain.boxes, **boxes}, facts=facts, region=region)


def _over_steps(loop: Loop) -> Change:
    """Rational functions of the gains as those of the steps, in lowest terms."""

    def change(expr: Expr) -> Expr:
        return lowest(substituted(expr, dict(loop.chart)), loop.steps)

    return change


def _environment(
    parts: _Parts, model: GainModel, change: Change, names: Sequence[str]
) -> Environment:
    loop, size = parts.loop, parts.loop.size
    gains = tuple(change(symbol(name)) for name in loop.gains)
    seen: Exprs = (tuple(number(h) for h in loop.measurement),)
    transition = exprs(loop.transition)
    predictor = tuple(row[0] for row in times(transition, tuple((g,) for g in gains)))
    quantities = common_quantities()
    del quantities[INDEX]
    for i in range(size):
        quantities[f"filter_gain.{i + 1}"] = gains[i]
        quantities[f"predictor_gain.{i + 1}"] = predictor[i]
        quantities[f"gain.{i + 1}"] = gains[i]
    for j, c in enumerate(loop.coefficients):
        quantities[f"closed_loop_coefficient.{j}"] = change(c)
    quantities["closed_loop_coefficient." + str(size)] = number(1)
    quantities |= _covariances(parts, model, change)
    quantities |= _lags(parts, change)
    quantities |= filter_states(transition, gains, seen)
    quantities[SAMPLE] = symbol(SAMPLE)
    missing = {INDEX: "a filter with given gains has no tracking index"}
    if not parts.lags:
        text = "lags of a filter whose states are no position with its derivatives"
        quantities_of = [f"{which}{i}.{m}" for which in LAGS for i in (1, 2, 3) for m in range(4)]
        missing |= dict.fromkeys(quantities_of, text)
    boxes = {**base_boxes(size), **dict.fromkeys(names, POSITIVE), SAMPLE: SAMPLES}
    boxes |= {f"target_motion.{m}": ANY_REAL for m in range(MOST_ORDER + 1)}
    return Environment(
        "any gains", quantities, boxes, missing=missing, assigned=dict(model.assigned)
    )


def _covariances(parts: _Parts, model: GainModel, change: Change) -> dict[str, Expr]:
    found: dict[str, Expr] = {}
    for which in ("predicted", "updated"):
        measured: Exprs = getattr(parts.measured, which)
        own = covariances_in_units(
            which, tuple(tuple(change(entry) for entry in row) for row in measured)
        )
        for i in range(parts.loop.size):
            for j in range(parts.loop.size):
                name = f"{which}_covariance.{i + 1}.{j + 1}"
                terms = [own[name]]
                for pair, covariance in parts.driven:
                    factor = change(getattr(covariance, which)[i][j])
                    if factor != number(0):
                        terms.append(factor * model.noise[pair] * _scale(sum(pair) - i - j))
                found[name] = add(*terms)
    seen = parts.loop.measurement
    spread = [
        number(a * b) * found[f"predicted_covariance.{i + 1}.{j + 1}"] * _scale(i + j)
        for i, a in enumerate(seen)
        for j, b in enumerate(seen)
        if a and b
    ]
    found["innovation_variance"] = add(*spread, power(symbol(DEVIATION), 2))
    return found


def _lags(parts: _Parts, change: Change) -> dict[str, Expr]:
    found = {f"target_motion.{m}": symbol(f"target_motion.{m}") for m in range(MOST_ORDER + 1)}
    for m, known in parts.lags.items():
        for which in ("predicted", "updated"):
            for i, entry in enumerate(getattr(known, which)):
                value = _in_steps(entry, change)
                if value != number(0):
                    value = value * symbol(f"target_motion.{m}") * _scale(m - i)
                found[f"{which}_lag.{i + 1}.{m}"] = value
    return found


def _in_steps(entry: Expr, change: Change) -> Expr:
    """A polynomial in the sample number, its coefficients changed."""
    if entry.kind == "add":
        return add(*[_in_steps(part, change) for part in entry.parts])
    if entry.kind == "mul" and any(p == symbol(SAMPLE) or _is_power(p) for p in entry.parts):
        first, *rest = entry.parts
        found = change(first)
        for part in rest:
            found = found * part
        return found
    return change(entry)


def _is_power(expr: Expr) -> bool:
    return expr.kind == "pow" and expr.parts[0] == symbol(SAMPLE)


def _scale(exponent: int) -> Expr:
    return whole_power(T, exponent)


def loop_facts() -> tuple[Fact, ...]:
    """What holds for all gains; the equations are checked where they are solved."""
    return (
        Fact("covariances satisfy their Lyapunov equation for all gains", METHOD),
        Fact("lags satisfy the recursion of errors for all gains", METHOD),
        Fact(f"cited: {HURWITZ[0]}", HURWITZ[1]),
        Fact(f"cited: {LYAPUNOV[0]}", LYAPUNOV[1]),
    )


def chart_facts(loop: Loop) -> tuple[Fact, ...]:
    """That the steps reach stable filters only, and each of them. Raises NotEstablished."""
    for rel in loop.region:
        moved = substituted(rel.left, dict(loop.chart))
        top, bottom = numerator_and_denominator(moved, loop.steps)
        if not (_positive(top) and _positive(bottom)):
            raise NotEstablished("coordinates that leave the stable region")
    back = steps_of_gains(loop)
    for name, value in loop.chart.items():
        again = substituted(value, back) - symbol(name)
        if not numerator_and_denominator(again, loop.gains)[0].is_zero():
            raise NotEstablished("coordinates that miss a stable filter")
    return (
        Fact("positive steps give stable filters: polynomials without a negative term", METHOD),
        Fact("each stable filter has positive steps, found from its gains", METHOD),
    )


def _positive(p: Poly) -> bool:
    """Whether a polynomial has terms and none is negative: positive for positive variables."""
    return not p.is_zero() and all(fraction(c) > 0 for _, c in terms(p))
