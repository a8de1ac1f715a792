"""Steady states with position and velocity measured: the closed form, and what establishes it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    sqrt,
    symbol,
    walk,
)
from gainproof.verify.judge.exact.rational_points import try_points
from gainproof.verify.judge.exact.simplification import expression_of
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.square_matrices import determinant
from gainproof.verify.judge.setting import plane_chart, quadrant_chart
from gainproof.verify.judge.setting.chart_decision import Plane
from gainproof.verify.judge.setting.chart_field import HIGH, LOW, ChartField, SignInside, field_over
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    POSITIVE,
    RATIO,
    Environment,
    Fact,
    NotEstablished,
)
from gainproof.verify.judge.setting.matrices import Exprs, minus, plus, times, transposed
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane
from gainproof.verify.judge.setting.steady_state_conditions import UNIQUENESS
from gainproof.verify.judge.setting.triangle_signs import sign_on_triangle
from gainproof.verify.judge.setting.two_measurements import (
    Entries,
    Noise,
    entries,
    exact_velocity,
)

T, SIGMA = symbol(INTERVAL), symbol(DEVIATION)
ONE, ZERO = number(1), number(0)
WHOLE = "zero and signs on a chart of all values of both parameters"


def position_velocity(noise: Noise, name: str) -> Environment:
    """The established steady state; base variables are the tracking index and the ratio
    S = sigma_d T / sigma_o. Raises Undecided, NotEstablished.
    """
    chosen = chart_of(noise)
    plane = Plane((INDEX, RATIO), chosen.sign_inside)
    index, ratio = symbol(INDEX), symbol(RATIO)
    closed = entries(index, ratio, ONE, noise)
    over = field_over({LOW, HIGH}, {}, chosen.sign_inside)
    charted = _charted(over, chosen.entries)
    ends = {
        "exact_velocity_covariance.1.1": entries(index, ZERO, ONE, noise).predicted[0],
        "no_velocity_covariance.1.1": entries(index, ONE, ZERO, noise).predicted[0],
    }
    facts = (
        *_facts(over, charted, closed, noise, chosen),
        _continuous(charted, ends, noise, chosen),
    )
    boxes = {INTERVAL: POSITIVE, DEVIATION: POSITIVE}
    chart = Environment(
        name,
        _quantities(charted, chosen.index, sqrt(chosen.ratio2)),
        # index and S are no base variables there; their boxes are for their labels
        {**boxes, **dict.fromkeys((LOW, HIGH, INDEX, RATIO), POSITIVE)},
        facts=facts,
        decide=plane.decide,
        charted={INDEX: chosen.index, RATIO: sqrt(chosen.ratio2)},
        squares={INDEX: chosen.index2, RATIO: chosen.ratio2},
    )
    quantities = _quantities(closed, index, ratio)
    ends["exact_velocity_covariance.1.1"] = exact_velocity(index, noise)
    quantities |= {key: value * power(SIGMA, 2) for key, value in ends.items()}
    return Environment(
        name,
        quantities,
        {**boxes, INDEX: POSITIVE, RATIO: POSITIVE},
        parameter=INDEX,
        facts=facts,
        coordinates=(INDEX, RATIO),
        chart=chart,
        decide=_outside,
    )


def _continuous(charted: Entries, ends: Mapping[str, Expr], noise: Noise, chosen: Chart) -> Fact:
    """That the closed form for S = 0, and the one in 1/S for 1/S = 0, are the limits: it is the
    same form in 1/S, and all its divisors and radicands are positive there. Raises NotEstablished.
    """
    sentence = "the closed form is continuous down to S = 0 and up to 1/S = 0"
    turned = entries(chosen.index, ONE, 1 / sqrt(chosen.ratio2), noise).predicted[0]
    same = Plane((INDEX, RATIO), chosen.sign_inside).decide(
        Statement((Rel("=", turned, charted.predicted[0]),)), {}, {}
    )
    below = [
        node.parts[1] if node.kind == "div" else node.parts[0]
        for node in walk(*ends.values())
        if node.kind == "div" or (node.kind == "pow" and node.fraction.denominator != 1)
    ]
    positive = [Rel(">", expr, ZERO) for expr in below if expr.kind != "number"]
    first = ends["exact_velocity_covariance.1.1"]
    plain = Rel("=", first, exact_velocity(symbol(INDEX), noise))
    found = decide(Statement((*positive, plain)), {INDEX: POSITIVE}, INDEX)
    if same.verdict != "proved" or found.verdict != "proved":
        raise NotEstablished(sentence)
    return Fact(sentence, found.method, found.certificate)


def _outside(
    statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Outcome | None:
    """Points alone for both parameters: their nested roots are too much for cells, and what can be
    proved is proved in the chart. Raises Undecided.
    """
    fixed = any(condition.operator == "=" for condition in statement.domain)
    if fixed or not {INDEX, RATIO} <= statement.symbols():
        return None
    found = try_points(statement, boxes, labels)
    if found is None:
        raise Undecided("nested roots of two parameters, which no chart covers")
    return found


def with_assigned(
    environment: Environment, assigned: Mapping[str, Expr], fixing: tuple[str, ...]
) -> Environment:
    """The environment that knows what symbols of the source its model fixes, in base variables;
    two of them, of the noises of process and velocity, fix the parameters.
    """
    chart = environment.chart
    if chart is not None:
        there = {token: substituted(expr, chart.charted) for token, expr in assigned.items()}
        chart = replace(chart, assigned=there, fixing=fixing)
    return replace(environment, assigned=assigned, chart=chart, fixing=fixing)


def _charted(over: ChartField, raw: Entries) -> Entries:
    """The entries as quotients of polynomials without common factor."""

    def short(expr: Expr) -> Expr:
        found = over.element(expr)
        names = (*over.ring.names()[:-2], LOW, HIGH)
        return expression_of(found.num, names) / expression_of(found.den, names)

    p, u = (tuple(short(e) for e in part) for part in (raw.predicted, raw.updated))
    return Entries((p[0], p[1], p[2]), (u[0], u[1], u[2]))


def _matrix(upper: Sequence[Expr]) -> Exprs:
    return ((upper[0], upper[1]), (upper[1], upper[2]))


def _gain(found: Entries, ratio2: Expr) -> Exprs:
    u11, u12, u22 = found.updated
    return ((u11, u12 / ratio2), (u12, u22 / ratio2))


def _quantities(found: Entries, index: Expr, ratio: Expr) -> dict[str, Expr]:
    quantities: dict[str, Expr] = {
        INTERVAL: T,
        DEVIATION: SIGMA,
        "measurement_noise_variance": power(SIGMA, 2),
        INDEX: index,
        RATIO: ratio,
    }
    gain = _gain(found, power(ratio, 2))
    for i in range(2):
        for j in range(2):
            scale = power(SIGMA, 2) / power(T, i + j) if i + j else power(SIGMA, 2)
            for which, upper in (("predicted", found.predicted), ("updated", found.updated)):
                quantities[f"{which}_covariance.{i + 1}.{j + 1}"] = _matrix(upper)[i][j] * scale
            factor = power(T, j - i) if i != j else ONE
            quantities[f"gain_matrix.{i + 1}.{j + 1}"] = gain[i][j] * factor
    return quantities


def _facts(
    over: ChartField, charted: Entries, closed: Entries, noise: Noise, chosen: Chart
) -> tuple[Fact, ...]:
    """What makes the entries the steady state, for all values of both parameters. Raises
    NotEstablished.
    """
    index2, ratio2 = chosen.index2, chosen.ratio2
    plane = Plane((INDEX, RATIO), chosen.sign_inside)

    def shown(sentence: str, relations: Sequence[Rel]) -> Fact:
        found = plane.decide(Statement(tuple(relations)), {}, {})
        if found.verdict != "proved":
            raise NotEstablished(f"{sentence}: {found.reason}")
        return Fact(sentence, WHOLE, found.certificate)

    p, u = _matrix(charted.predicted), _matrix(charted.updated)
    f: Exprs = ((ONE, ONE), (ZERO, ONE))
    q = _matrix([number(x) * index2 for x in (noise.position, noise.mixed, 1)])
    gain = _gain(charted, ratio2)
    residuals = [*minus(p, plus(times(times(f, u), transposed(f)), q))]
    # with K = U R^-1: U = P - K P, which is U^-1 = P^-1 + R^-1
    residuals += [*minus(u, minus(p, times(gain, p)))]
    loop = minus(f, times(f, gain))
    trace = loop[0][0] + loop[1][1]
    stable = left_half_plane(circle_moved([determinant(loop), -trace, ONE]))
    minors = [m for c in (p, u) for m in (c[0][0], determinant(c))]
    put_in = {INDEX: chosen.index, RATIO: sqrt(ratio2)}
    same = [
        Rel("=", substituted(a, put_in), b)
        for a, b in zip(
            (*closed.predicted, *closed.updated),
            (*charted.predicted, *charted.updated),
            strict=True,
        )
    ]
    return (
        Fact(
            "all positive pairs of index and S are met in the chart",
            WHOLE,
            chosen.onto(over),
        ),
        shown("index, S are positive in the chart", [Rel(">", e, ZERO) for e in (index2, ratio2)]),
        shown(
            "the Riccati equation holds identically: P = F U F' + Q, U = P - K P, K = U R^-1",
            [Rel("=", e, ZERO) for row in residuals for e in row],
        ),
        shown("the covariances are positive definite", [Rel(">", m, ZERO) for m in minors]),
        shown("the closed loop F - F K is stable (Hurwitz, unit circle moved)", stable),
        shown("the closed form in index and S is the same", same),
        Fact(f"cited: {UNIQUENESS[0]}", UNIQUENESS[1]),
    )


@dataclass(frozen=True)
class Chart:
    """Index, the squares of index and S, and the covariances in the base variables of a chart;
    `onto` shows that all positive pairs are met, `sign_inside` is what is known of signs there.
    """

    index: Expr
    index2: Expr
    ratio2: Expr
    entries: Entries
    onto: Callable[[ChartField], Mapping[str, str]]
    sign_inside: SignInside


def chart_of(noise: Noise) -> Chart:
    """Raises Undecided where there is none."""
    if noise == plane_chart.COVERED:
        index2, ratio2 = plane_chart.squares()
        found, onto = plane_chart.charted_entries(), plane_chart.refuse_unless_onto
        return Chart(sqrt(index2), index2, ratio2, found, onto, sign_on_triangle)
    if quadrant_chart.is_covered(noise):
        index, _ = quadrant_chart.coordinates(noise)
        index2, ratio2 = quadrant_chart.squares(noise)
        return Chart(
            index,
            index2,
            ratio2,
            quadrant_chart.charted_entries(noise),
            lambda field: quadrant_chart.refuse_unless_onto(field, noise),
            quadrant_chart.sign_on_quadrant,
        )
    raise Undecided("position and velocity measured, with a process noise that has no chart")
