"""What the page `measured-position-three-states` does not say: what differs between models, what is
long, and the forms that show signs.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError, ScaledModel
from gainproof.derive.pages.model_slots import model_slots, plain
from gainproof.derive.steady_state.spectrum import V
from gainproof.derive.three_state import (
    covariance_entries,
    kernel_tower,
    pole_tower,
    second_derivative_tower,
)
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    ETA,
    GAINS,
    HIDDEN,
    INDEX,
    NU,
    PREDICTED,
    TAU,
    XI,
    Z,
)
from gainproof.derive.three_state.page_hints import CONVEX
from gainproof.derive.three_state.pole_places import middle, turning

Slots = dict[str, Any]
Limits = Mapping[str, tuple[sp.Expr, sp.Expr]]
PARAMETER_ENDS = " As `p` tends to an end, so does the index."
ABOVE = ": `delta^2` is more than `{}` (step @above-e)"


def slots(c: Context, bent: Tower, twin: ScaledModel | None, signs: Collection[str]) -> Slots:
    """The page's slots by name.

    `bent`: the tower of second derivatives. `twin`: a model with the same gains. `signs`: the steps
    with signs of which it is known how to show them.
    """
    return {
        **{f"convex_{name}": f"convex-{name}".replace("_", "-") in signs for name in CONVEX},
        "turns_once": not c.spectrum.m2 or "turns-once-predicted-11" in signs,
        **_model(c),
        **_noise(c),
        **_constants(c),
        **_ends(c),
        **_bending_ends(c, bent),
        **_poles(c),
        "twin": twin.name if twin else "",
        "twin_noise": twin.process_noise if twin else None,
    }


def ends(c: Context) -> Mapping[str, Mapping[str, End]]:
    """Both ends of the towers, by name."""
    found = {"main": c.ends, "bending": c.ends}
    if not c.spectrum.rational_in_root:
        found[kernel_tower.NAME] = kernel_tower.ends(c)
    if poles_by_level(c):
        found[pole_tower.NAME] = pole_tower.ends(c)
    return found


def poles_by_level(c: Context) -> bool:
    """Whether the poles have a parameter of their own."""
    return not c.spectrum.rational_in_root and pole_tower.within_reach(c.spectrum)


def _model(c: Context) -> Slots:
    """The model in its own quantities, and its scaling."""
    texts = {q.symbol: sp.Symbol(plain(q.latex)) for q in c.original.quantities}

    def written(value: sp.Expr) -> str:
        return str(value.subs(texts)).replace("**", "^").replace("*", " ")

    units = map(written, c.model.state_scale)
    return {
        **model_slots(c.original, c.model),
        **dict(zip(("position_unit", "velocity_unit", "acceleration_unit"), units, strict=True)),
        "ratio_in_words": written(c.model.noise_ratio),
    }


def _noise(c: Context) -> Slots:
    """The noise of the scaled model and its spectrum, a polynomial in v."""
    noise = c.model.process_noise
    entries = {f"Q{i}{j}": noise[i - 1, j - 1] for i in (1, 2, 3) for j in (1, 2, 3) if i <= j}
    polynomial = c.spectrum.noise
    return {
        **entries,
        "noise_of_v": polynomial_text(polynomial),
        "noise_in_place": _in_place(polynomial, 2 - Z - 1 / Z),
    }


def _in_place(polynomial: sp.Expr, v: sp.Expr) -> sp.Expr:
    """A polynomial in v with v written out and not multiplied out."""
    terms = (
        sp.Mul(coefficient, sp.Pow(v, power, evaluate=False), evaluate=False)
        if power
        else coefficient
        for (power,), coefficient in sorted(sp.Poly(polynomial, V).terms())
    )
    return sp.Add(*terms, evaluate=False)


def polynomial_text(polynomial: sp.Expr) -> str:
    """A polynomial in v as text, lowest power first: `1 - v/4 + v^2/120`."""
    parts: list[str] = []
    for (power,), coefficient in sorted(sp.Poly(polynomial, V).terms()):
        top, below = abs(int(coefficient.p)), int(coefficient.q)
        name = "v" + f"^{power}" * (power > 1) if power else ""
        number = "" if top == 1 and name else str(top)
        text = " ".join(filter(None, (number, name))) + f"/{below}" * (below > 1)
        sign = "-" if coefficient < 0 else "+"
        parts.append(f" {sign} {text}" if parts else text if coefficient > 0 else f"-{text}")
    return "".join(parts)


def _constants(c: Context) -> Slots:
    """The numbers of the spectrum, and `xi` over the parameter."""
    a1, a2, e = c.numbers
    named = [x for x in c.constants.generators if not x.symbol.startswith("root_")]
    return {
        "m1": a1 - 1,
        "m2": e,
        "a1": a1,
        "a2": a2,
        "cubic": bool(e),
        "b": c.constants.b,
        "excess": "4/p^2" if e else "4/p",
        "nested": bool(named),
        "square_of_b": named[0].radicand if named else sp.Integer(0),
        "in_which_b": ", in which `b` is a number" if named else "",
        "index_to_a_power": "Lambda^2" if e else "Lambda",
        "index_of_xi": "64/(delta^2 - e)" if e else "8/delta",
        "and_the_index": ", and so is what `Lambda^2` is made of" if e else "",
        "running": "p" if e else "Lambda",
    }


def _ends(c: Context) -> Slots:
    """What gains and covariances tend to for a large index, and what they grow like.

    Raises ModelError where X22'' over eta tends to nothing.
    """
    k, whole = c.constants, c.constants.least + c.constants.c
    turns = not c.spectrum.rational_in_root
    found: Slots = {
        "as_the_parameter": PARAMETER_ENDS if c.spectrum.m2 else "",
        "end_of_rest": plain_number(16 / whole**2),
        "end_of_beta": plain_number(2 * k.least / whole),
        "end_of_gamma": plain_number(4 / whole),
        "as_delta_is_large": ABOVE.format(c.numbers[2]) if c.spectrum.e else "",
        "those_that_turn": "`M11`, `M12` and `X22`" if turns else "`M11` and `M12`",
        "rooted": turns,
    }
    if turns:
        if k.b + k.c == 0:
            raise ModelError(
                f"model {c.model.name}: a process noise is wanted whose spectrum has no double "
                "zero at z = -1, as a polynomial in v = 2 - z - 1/z"
            )
        found["far_bend_over_eta"] = plain_number(2 * over_square(c)["updated_22"] / (k.b + k.c))
    for name, value in over_square(c).items():
        whole_square = not c.tower.is_zero(value)
        found[f"growth_of_{_entry(name)}"] = INDEX**2 if whole_square else INDEX
        found[f"end_of_{_entry(name)}"] = plain_number(value) if whole_square else _linear(c, name)
    return found


def over_square(c: Context) -> dict[str, sp.Expr]:
    """The limits of the covariances' entries over the square of a large index."""
    k, noise = c.constants, c.model.process_noise
    known = {
        XI: k.least,
        ETA: k.b + k.c,
        NU: 2 * (k.least + k.c),
        TAU: k.least * (k.b + k.c) - k.c,
        INDEX: sp.Integer(1),
    }
    entries = {
        **covariance_entries.predicted(noise),
        **covariance_entries.updated(noise, c.numbers[0]),
    }
    return {name: sp.expand(entries[name].subs(known)) for name in (*PREDICTED, *HIDDEN)}


def _entry(name: str) -> str:
    """What the page calls it."""
    return name.replace("predicted", "M").replace("updated", "X")


def _linear(c: Context, name: str) -> sp.Expr:
    """The limit of an entry over the index, where it grows no faster than that."""
    value = c.tower.expression(c.tower.fraction(real(name) / INDEX))
    return sp.limit(value, sp.Symbol("p", real=True), sp.oo)


def _bending_ends(c: Context, bent: Tower) -> Slots:
    """What second derivatives times powers of the index tend to for a large index."""
    own = c.spectrum.rational_in_root
    found = _far_rational(bent) if own else _far(c)
    return {
        "setting_of_ends": second_derivative_tower.NAME if own else kernel_tower.NAME,
        **{f"power_of_{_entry(name)}": "" for name in ("alpha", *HIDDEN)},
        **{f"power_of_{_entry(name)}": power for name, (power, _) in found.items()},
        **{f"far_bend_of_{_entry(name)}": value for name, (_, value) in found.items()},
    }


def _far(c: Context) -> Limits:
    """Where e > 0 all approach their limits like 1/Lambda^2; where e = 0 like 1/Lambda.

    Nothing where b = 0: there they have other powers.
    """
    b, root_e, xi = c.constants.b, c.constants.c, c.constants.least
    if b == 0:
        return {}
    tau, nu = xi * (b + root_e) - root_e, 2 * (xi + root_e)
    rise = tau + xi + xi**2
    power = INDEX ** (4 if c.spectrum.e else 3)
    per = 192 / root_e if c.spectrum.e else sp.Integer(16)
    below = tau * nu**2
    found = {
        "alpha": (INDEX**4, -96 / (xi + root_e) ** 2),
        "beta": (power, -4 * per * xi * (rise - nu) / below),
        "gamma": (power, -8 * per * rise / below),
    }
    for name, value in over_square(c).items():
        if not c.tower.is_zero(value):
            found[name] = sp.Integer(1), 2 * value
    return {
        name: (scale, c.tower.expression(c.tower.fraction(plain_number(value))))
        for name, (scale, value) in found.items()
    }


def _far_rational(bent: Tower) -> Limits:
    """Where all is rational in the parameter, from the leading powers of it."""
    rate, size = _leading(bent.elements[INDEX.name])
    found = {}
    for name in (*GAINS, *PREDICTED, *HIDDEN):
        slope = bent.expression(derivative(bent, real(name), INDEX.name))
        power, factor = _leading(derivative(bent, slope, INDEX.name))
        whole = sp.Rational(power, rate)
        found[name] = INDEX ** (-whole), factor / size**whole
    return found


def _leading(value: Fraction) -> tuple[int, sp.Rational]:
    """The power of p that a fraction goes like for large p, and the factor."""
    above, below = value.num, value.den
    return above.degree() - below.degree(), sp.Rational(str(above.LC / below.LC))


def plain_number(value: sp.Expr) -> sp.Expr:
    """A number over named roots of integers, no root below the line and no square of a root.

    One that holds another generator, a root within a root, is left as it is.
    """
    names = {str(symbol): symbol for symbol in value.free_symbols}
    if not all(name.startswith("root_") for name in names):
        return value
    roots = {symbol: sp.sqrt(int(name.removeprefix("root_"))) for name, symbol in names.items()}
    found = sp.expand(sp.radsimp(value.subs(roots)))
    return found.subs({root: real(str(symbol)) for symbol, root in roots.items()})


def _poles(c: Context) -> Slots:
    """Where the poles turn real, and where half the sum of a pair vanishes."""
    found, by_level = turning(c), poles_by_level(c)
    slots: Slots = {
        "discriminant_of_cubic": found.quotient,
        "always_complex": found.value is None,
        "real_beyond": found.value,
        "setting_of_turn": found.tower.name,
        "rational": c.spectrum.rational_in_root,
        "poles_by_level": by_level,
    }
    if by_level:
        place = middle(c.spectrum)
        names = {x: sp.sqrt(int(str(x).removeprefix("root_"))) for x in place.square.free_symbols}
        slots["vanishing_index"] = str(sp.N(8 / sp.sqrt(place.square.subs(names)), 6))
        slots["square_of_k"] = place.square
    return slots
