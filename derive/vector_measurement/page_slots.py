"""What the page `position-velocity` leaves open: the values of its slots in one family."""

from __future__ import annotations

import re
from typing import Any

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.model import Model, ScaledModel
from gainproof.derive.vector_measurement import poles, radicands
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.limit_towers import FAR, root_of_e
from gainproof.derive.vector_measurement.names import ETA, INDEX, RATIO, SPEED, Z
from gainproof.derive.vector_measurement.pole_kernels import turning_index
from gainproof.derive.vector_measurement.position_equation import VARIANCE, position_equation
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.spectrum import spectral_matrix
from gainproof.derive.vector_measurement.towers import rational, symbolic_noise

Slots = dict[str, Any]
MORE = sp.Rational(11, 10)
"""The factor that bounds the step."""


def page_slots(c: Context) -> Slots:
    """The slots of the page by name, without those of its steps on a source's own symbols."""
    noise = c.noise
    return {
        **_of_model(c.original, c.model),
        **_of_spectrum(c),
        **_of_noise(noise),
        **_of_ends(noise),
        **_of_poles(noise),
        **(_of_step(c) if noise.determinant else {}),
    }


def _of_model(original: Model, scaled: ScaledModel) -> Slots:
    """The model in its own quantities and what the scaling makes of it."""
    listed = ", ".join(f"`{_plain(q.latex)}` the {q.meaning}" for q in original.quantities)
    forward = sp.diag(*scaled.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in scaled.state_scale)).as_immutable()
    (ratio,) = scaled.ratios.values()
    values = {sp.Symbol(name, real=True): value for name, value in scaled.ratios.items()}

    def occurring(matrix: sp.MatrixBase) -> tuple[sp.Symbol, ...]:
        found = forward.free_symbols | matrix.free_symbols
        return tuple(q.symbol for q in original.quantities if q.symbol in found)

    return {
        "quantities_in_words": listed.replace("` the", "` is the", 1),
        "transition": original.transition,
        "process_noise": original.process_noise,
        "measurement": original.measurement,
        "measurement_noise": original.measurement_noise,
        "to_units": backward,
        "from_units": forward,
        "quantities_of_scale": occurring(original.transition),
        "quantities_of_process": occurring(original.process_noise),
        "quantities_of_measurement": occurring(original.measurement_noise),
        "scaled_process_noise": (scaled.noise_ratio * scaled.process_noise).as_immutable(),
        "scaled_measurement_noise": scaled.measurement_noise.subs(values).as_immutable(),
        "noise_ratio": scaled.noise_ratio,
        "velocity_ratio": ratio,
    }


def _plain(latex: str) -> str:
    """A quantity's symbol as it is written on a line of text."""
    return re.sub(r"[\\{} ]|tilde", "", latex)


def _of_spectrum(c: Context) -> Slots:
    """Determinants and squares; sums and products that the checker is to multiply out."""
    numbers, level = symbolic_noise(c.noise), c.level
    (a, b), (d, e) = spectral_matrix(c.model).tolist()
    determinant = sp.Add(
        sp.Mul(a, e, evaluate=False), -sp.Mul(b, d, evaluate=False), evaluate=False
    )
    coefficients = sp.Poly(c.closed_loop, Z).terms()
    eta = _over_square(radicands.eta_squared(numbers, INDEX, RATIO))
    delta = radicands.delta_squared(numbers, INDEX, RATIO, RATIO * level, RATIO * ETA)
    return {
        "determinant": determinant / c.model.measurement_noise.det(),
        "linear": c.spectrum.linear,
        "constant": c.spectrum.constant,
        "spectrum_at_minus_one": c.spectrum.at_minus_one,
        "closed_loop": sp.Add(*(sp.Mul(x, Z**n) for (n,), x in coefficients), evaluate=False),
        "eta_squared": sp.factor(eta) if c.noise.interval else eta,
        "delta_squared": _over_square(delta),
    }


def _over_square(form: sp.Expr) -> sp.Expr:
    """A form that is S^2 times a quantity, as this quantity over Lambda and t."""
    return sp.expand(sp.expand(form).subs(RATIO, INDEX / SPEED) * SPEED**2 / INDEX**2)


def _of_noise(noise: Noise) -> Slots:
    """The numbers of the process noise, and the sentences that depend on them."""
    d, level = noise.determinant, bool(noise.determinant)
    return {
        "e": str(noise.e),
        "n": str(noise.n),
        "first": str(noise.first),
        "d": str(d) if level else "",
        "d_t2": times_text(rational(d), "t^2"),
        "d_h2": times_text(rational(d), "h^2"),
        "level": "w" if level else "1",
        "one_end": "Lambda w" if level else "Lambda",
        "names_w": "; this names `w`" if level else "",
        "roots": "`w`, `eta` and `delta` (steps @level, @at-minus-one and @delta)"
        if level
        else "`eta` and `delta` (steps @at-minus-one and @delta)",
        "rest_solved": "`g = h (w (w + kappa) - 1)`, with `w^2` from step @level"
        if level
        else "`g = Lambda - h = h (1 + kappa) - h`",
        "second_column": " `Q0` is `c c'` with its second column `c`, and beyond that "
        f"{d} in entry 11: that adds the terms with {d}."
        if level
        else "",
        **(_ALL_THROUGH if noise.interval else _AT_SAMPLES),
    }


_ALL_THROUGH = {
    "eta_shape": "a product",
    "coupling": "eta/(4 + t^2)",
    "why_cancelled": "`eta^2` is a product (step @at-minus-one)",
    "velocity": "(S^2 g + Lambda^2/sigma)/delta",
    "velocity_steps": "@velocity-from-cross, @velocity-from-rest",
}
"""Where the noise acts all through each interval, and where it acts at the samples."""
_AT_SAMPLES = {
    "eta_shape": "a sum of positive terms",
    "coupling": "sigma",
    "why_cancelled": "`delta^2 = t^2 + Lambda m`",
    "velocity": "delta h",
    "velocity_steps": "@velocity-from-cross",
}


def _of_ends(noise: Noise) -> Slots:
    """The ends of both parameters and the corners of the domain."""
    e, level, turning = rational(noise.e), bool(noise.determinant), not noise.settles
    eta = f"`sqrt(16 + {times_text(e, 'Lambda^2')})`" if e else "4"
    corner = {"small_cross": "1/(half t_h^2)", "corner_gain": "4/(gamma + t_h)^2"}
    large = {"large_cross": "1/(1 + t_h^2)", "large_updated_cross": "1/(1 + t_h^2)"}
    if noise.interval:
        corner = {"small_cross": "gamma/(2 t_h^2)", "corner_gain": "gamma/(gamma + t_h)"}
        large = {"large_cross": "1/2", "large_updated_cross": "2"}
    if level:
        large = {
            "large_cross": "high (w_h + high)/(2 whole)",
            "large_updated_cross": "2 high/((w_h + high) whole)",
        }
    return {
        "w_absent": "`w` tends to 1, " if level else "",
        "eta_absent": eta,
        "eta_without": eta.strip("`"),
        "names_phi": f"; here `phi = sqrt(Lambda^2 + {16 / noise.e})`" if level else "",
        "phi_at_0": str(16 / noise.e) if level else "",
        "root_of_e": root_of_e(noise)[0],
        "known": "2 Lambda/(Lambda + phi)" if level else "0",
        "known_gain_12": 8 / (e * (INDEX + FAR) ** 2) if level else str(noise.n),
        "vanishing": "" if level else "yes",
        "left_of_position": "What is left of the position's variance comes from the motion within "
        "one interval that the velocities at its ends do not tell."
        if level
        else "The velocities at both ends of an interval tell all of the motion between: nothing "
        "is left of the updated position's variance.",
        "level_held": "w_h" if level else "1",
        **corner,
        **large,
        "large_power": "p^4" if turning else "p^2",
        "large_updated": "large" if turning else "4/gamma",
        "turning": "yes" if turning else "",
        "turning_end": "0" if turning else "2 S^2/(S + 2)^2",
        "turning_words": "again" if turning else "tends to a limit",
        "without_trend": "`K12` has no trend in `S` either."
        if turning
        else "Not everything has a trend: `K12` has none in `S`.",
        "position_bends": "" if turning else "yes",
    }


def _of_poles(noise: Noise) -> Slots:
    """Where the poles are real."""
    f, spread = poles.slope(noise), poles.spread(noise)
    return {
        "f": str(f) if f else "",
        "positive_sum": "" if f else "yes",
        "four_over_f": str(4 / f) if f else "",
        "centre": str(poles.centre(noise)),
        "spread": str(spread),
        "turning_root": "r" if spread else "1",
        "names_r": f"; here `r^2 = 1 + {times_text(rational(spread), 'Lambda^2')}`"
        if spread
        else "",
        "turning_index": str(turning_index(noise)) if f else "",
    }


def times_text(number: sp.Rational, text: str) -> str:
    """A product with a number that is not negative: t^2/12."""
    if number.p == 0:
        return "0"
    if number.p == 1:
        return text if number.q == 1 else f"{text}/{number.q}"
    return f"({number}) {text}"


def _of_step(c: Context) -> Slots:
    """From 1.1 times the accuracy with an exact velocity to that without it, over 1.1."""
    e, first = rational(c.noise.e), rational(c.noise.first)
    small = rational(c.noise.determinant) * (MORE**2 - 1)
    equation = position_equation(c.spectrum)
    terms = [entry * RATIO ** (2 * power) for power, entry in enumerate(equation)]
    return {
        "improvement_end": sp.expand(sp.radsimp(4 * first / (1 + sp.sqrt(e)) ** 2)),
        "start_small": str(small),
        "start_small_root": str(sp.sqrt(16 * small)),
        "start_small_number": f"{float(sp.sqrt(16 * small)):.6f}",
        "b_squared": times_text(e, "(1 + t^2/4)"),
        "position_equation": sp.Add(*terms).subs(VARIANCE, real("predicted_11")),
        "position_equation_near": equation[0].subs(VARIANCE, real("known_predicted_11")),
        "position_equation_far": equation[-1].subs(VARIANCE, real("only_predicted_11")),
        **_of_large_index("start", c.noise, start_level(c.noise)),
        **_of_large_index("end", c.noise, end_level(c.noise)),
    }


def start_level(noise: Noise) -> sp.Expr:
    """1.1 times P11/Lambda^2 for a large index with the velocity known."""
    return MORE * rational(noise.first)


def end_level(noise: Noise) -> sp.Expr:
    """P11/Lambda^2 for a large index without the velocity, over 1.1."""
    return (1 + sp.sqrt(rational(noise.e))) ** 2 / (4 * MORE)


def _of_large_index(key: str, noise: Noise, level: sp.Expr) -> Slots:
    """Where P11/Lambda^2 takes the level for a large index: w/b, and t^2."""
    e = rational(noise.e)
    share = level + (1 - e) / 4
    slope = _plain_number((share - (1 - e) / 2) / (share * e))
    place = _plain_number(4 / e * (1 - slope**2 * e) / (slope**2 - 1))
    crossing = 1 / sp.sqrt(place)
    return {
        f"{key}_level": in_tower(noise, level),
        f"{key}_slope": in_tower(noise, slope),
        f"{key}_slope_words": _written(slope),
        f"{key}_slope_squared": in_tower(noise, slope**2),
        f"{key}_factor": in_tower(noise, (slope**2 - 1) * e / 4),
        f"{key}_place": in_tower(noise, place),
        f"{key}_place_words": _written(place),
        f"{key}_crossing": f"{float(crossing):.6f}",
        f"{key}_crossing_by_r": f"{float(4 * crossing):.6f}",
    }


def _plain_number(number: sp.Expr) -> sp.Expr:
    return sp.expand(sp.radsimp(sp.expand(sp.radsimp(number))))


def in_tower(noise: Noise, number: sp.Expr) -> sp.Expr:
    """A number with the root of e over the tower's own root."""
    roots = {sp.sqrt(n): real(name) for name, n in root_of_e(noise)[1].items()}
    return sp.expand(number).subs(roots)


def _written(number: sp.Expr) -> str:
    """A number with a root in a sentence, its positive term first."""
    terms = sorted(sp.Add.make_args(number), key=lambda term: bool(term < 0))
    first, *others = (sp.sstr(abs(term)).replace("*", " ") for term in terms)
    signs = ("-" if term < 0 else "+" for term in terms[1:])
    return " ".join([first, *(f"{sign} {text}" for sign, text in zip(signs, others, strict=True))])
