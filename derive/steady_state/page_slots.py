"""What the page `measured-position-two-states` does not say: what differs between models, what is
long, and the forms that show signs.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.pages.model_slots import model_slots, plain
from gainproof.derive.steady_state import inverses
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.gain_towers import LIMIT, WIDE
from gainproof.derive.steady_state.kernels import symbolic_forms
from gainproof.derive.steady_state.names import (
    ALPHA,
    BETA,
    DEVIATION,
    GROWTH,
    INDEX,
    KAPPA,
    PREDICTED,
    RHO,
    ROOT,
    ROOT_3,
)
from gainproof.derive.steady_state.pole_towers import (
    SIDE,
    G,
    X,
    complex_ends,
    half_width,
    real_ends,
)
from gainproof.derive.steady_state.towers import ROOT_S, rational, root_of_16, surd

Slots = dict[str, Any]
TURN_TOWER = "with_root_of_3"


def slots(c: Context) -> Slots:
    """The page's slots by name."""
    return {
        **model_slots(c.original, c.model),
        **_units(c),
        **_spectrum(c),
        **_forms(c),
        **_ends(c),
        **_turn(c.e),
        **_inverse(c),
        "e_is_0": c.e == 0,
        "e_is_1": c.e == 1,
        "e_is_between": 0 < c.e < 1,
        "e_above_0": c.e > 0,
        "e_below_1": c.e < 1,
        "eta": "eta" if c.e else "4",
        "roots": "`eta` and `s` (steps @eta and @root-s)" if c.e else "`s` (step @root-s)",
        "updated_22_of_rho": _updated_22_of_rho(c.n),
        "pole_limit": pole_limit(c.e),
        "switch": LIMIT,
    }


def hints(c: Context) -> Mapping[str, Mapping[str, Any]]:
    """Forms without the differences that hide a sign, by step."""
    found: Slots = {
        "parameter-range": "2 p",
        "discriminant": _discriminant(c),
        **{f"increasing-{name}": form for name, form in _slopes(c).items()},
        **_bends(c),
        "one-turn": _share_of_turn(c.e),
        "turn": _turn_form(c),
        "alpha-range": _slopes(c)["alpha"],
        "beta-range": _slopes(c)["beta"],
    }
    if c.e:
        found |= {"below-switch-range": 2 * LIMIT * X / WIDE**2, "above-switch-range": "1"}
    if (limit := pole_limit(c.e)) is not None:
        found |= {"complex-range": 2 * limit * X / SIDE**2, "real-range": 2 * G}
    return {name.replace("_", "-"): {"form": form} for name, form in found.items()}


def ends(c: Context) -> Mapping[str, Mapping[str, End]]:
    """Both ends of the towers, by name."""
    if c.e == 1:
        return {"main": c.ends}
    return {"main": c.ends, "complex_poles": complex_ends(c.e), "real_poles": real_ends(c.e)}


def _units(c: Context) -> Slots:
    signs = {q.symbol: sp.Symbol(plain(q.latex)) for q in c.original.quantities}
    first, second = (str(entry.subs(signs)) for entry in c.model.state_scale)
    return {"first_unit": first, "second_unit": second}


def _spectrum(c: Context) -> Slots:
    relation = sp.Poly(c.spectrum.relation, ALPHA, BETA)
    return {
        "e": rational(c.e),
        "n": rational(c.n),
        "noise_of_v": _noise_of_v(c.e),
        "first_weight": relation.coeff_monomial(ALPHA**2),
        "last_weight": relation.coeff_monomial(BETA**2),
    }


def _noise_of_v(e: Fraction) -> str:
    """The noise's numerator 1 - (1 - e) v/4 with its number written out."""
    slope = (1 - e) / 4
    top = "v" if slope.numerator == 1 else f"{slope.numerator} v"
    return f"1 - {top}/{slope.denominator}" if slope else "1"


def _forms(c: Context) -> Slots:
    """What kernels compute of covariances and derivatives."""
    return {
        **symbolic_forms(c.e, c.n, (*PREDICTED, "updated_22")),
        **{f"slope_of_{name}": form for name, form in _slopes(c).items()},
        "bend_of_updated_22": _second(c, "updated_22"),
    }


def _slopes(c: Context) -> Slots:
    own = {name: f"d_{name}" for name in ("alpha", "beta", *PREDICTED, "updated_22")}
    own["predictor_position"] = "d_position"
    found = symbolic_forms(c.e, c.n, own.values())
    return {name: found[formula] for name, formula in own.items()}


def _second(c: Context, name: str) -> sp.Expr:
    """The second derivative of an output of kernels."""
    return symbolic_forms(c.e, c.n, (f"dd_{name}",))[f"dd_{name}"]


def _bends(c: Context) -> Slots:
    """What second derivatives are, for their signs."""
    own = {
        **{f"concave-{name}": f"fall_{name}" for name in ("alpha", "beta")},
        "concave-predictor-position": "fall_position",
        **{f"convex-{name}": f"dd_{name}" for name in ("predicted_12", "predicted_22")},
        "convex-updated-22": "dd_updated_22",
        "growth-grows": "unbent",
    }
    found = symbolic_forms(c.e, c.n, own.values())
    return {step: found[name] for step, name in own.items()}


def _updated_22_of_rho(n: Fraction) -> str:
    """X22 in a sentence; n = Q12/Q22."""
    if n == 0:
        return "`X22 = Lambda^2 rho`"
    half = "`rho - 1/2 = (rho^2 - 1/4)/(rho + 1/2)`"
    if n == Fraction(1, 2):
        return f"`X22 = Lambda^2 (rho - 1/2)`, where {half}"
    return (
        f"`X22 = Lambda^2 (rho - {n})`, where `rho - {n} = {1 - 2 * n} rho + {2 * n} (rho - 1/2)` "
        f"and {half}"
    )


def pole_limit(e: Fraction) -> sp.Rational | None:
    """The index from which the poles are real, if there is one."""
    return None if e == 1 else rational(8 / (1 - e))


def _discriminant(c: Context) -> sp.Expr:
    """That of c(z) over what shows its sign."""
    limit = pole_limit(c.e)
    if limit is None:
        return 4 * half_width(c.e, c.n) ** 2
    return (1 - rational(c.e)) ** 2 * (INDEX + limit) / (16 * (RHO * DEVIATION) ** 2)


def turn_towers(c: Context) -> tuple[Tower, ...]:
    """Where e = 0: the main tower with sqrt(3), in which the turn of M11 lies."""
    if c.e:
        return ()
    roots = (Generator("root_3", sp.Integer(3)), *c.tower.generators)
    return (Tower(TURN_TOWER, c.tower.parameters, roots, c.tower.expressions),)


def _turn(number: Fraction) -> Slots:
    if number == 0:
        return {"end_of_turn": "infinity", "share_of_turn": "kappa/(2 rho^2)"}
    root = sp.sqrt(rational(number))
    polynomial, _ = _turn_polynomial(number)
    return {
        "end_of_turn": sp.radsimp((1 + root) ** 3 / root),
        "share_of_turn": f"kappa^2/(2 rho^2 (kappa + {number / 2}))",
        "turning_polynomial": polynomial,
        "turning_index": _turning_index(number, polynomial),
    }


def _share_of_turn(number: Fraction) -> sp.Expr:
    """M11'' over the function that has its sign."""
    e = rational(number)
    return DEVIATION**2 * GROWTH * KAPPA**2 / (2 * (INDEX * RHO) ** 2 * (KAPPA + e / 2))


def _turn_form(c: Context) -> sp.Expr:
    """M11'' over what has its sign in closed form or as a polynomial."""
    if c.e == 0:
        return _second(c, "predicted_11") / (INDEX - 4 / (2 * ROOT_3 + 3))
    _, rest = _turn_polynomial(c.e)
    return _share_of_turn(c.e) * rest / KAPPA**4


def _sign(number: Fraction) -> sp.Expr:
    """2 rho^2 (kappa + e/2)/kappa^2 times psi - chi."""
    e = rational(number)
    rising = 2 * RHO * (1 + e / (2 * KAPPA)) ** 2 / KAPPA
    falling = (1 / (2 * KAPPA), e / (4 * KAPPA**2), 3 * e**2 / (8 * KAPPA**3))
    return rising - 1 - sp.Add(*falling) - (1 + e) * e**2 / (16 * KAPPA**4)


def _turn_polynomial(number: Fraction) -> tuple[sp.Expr, sp.Expr]:
    """The factor of that difference, as a polynomial in rho, that changes its sign; the others."""
    e = rational(number)
    whole = sp.Poly(sp.expand(_sign(number) * KAPPA**4).subs(KAPPA, RHO**2 - (1 + e) / 4), RHO)
    least = sp.Rational(int(500_000 * (1 + float(number) ** 0.5)), 1_000_000)
    factors = (part for part, _ in whole.factor_list()[1])
    (factor,) = (part for part in factors if part.count_roots(inf=least))
    factor = factor if factor.LC() < 0 else -factor
    return factor.as_expr(), sp.factor(whole.quo(factor).as_expr())


def _turning_index(number: Fraction, polynomial: sp.Expr) -> str:
    """The index at which M11 turns, to six digits."""
    ratio = max(map(sp.re, sp.Poly(polynomial, RHO).nroots(30)))
    e = rational(number)
    kappa = ratio**2 - (1 + e) / 4
    return str(sp.N(2 / sp.sqrt(kappa**2 - e / 4), 6))


def _ends(c: Context) -> Slots:
    """Both ends of the index: `end` is the limit of s/p."""
    root = sp.sqrt(rational(c.e))
    end = sp.radsimp((1 + root) / 2)
    found = {
        "near": "`eta` tends to 4, `s` to `sqrt(2)`" if c.e else "`s` tends to `sqrt(2)`",
        "far": _far(c.e),
        "end": end,
        "square_of_end": sp.expand(end**2),
        "end_of_rest": sp.radsimp(4 / (1 + root) ** 2),
        "end_of_beta": sp.radsimp(2 / (1 + root)),
        "end_of_second_alpha": sp.radsimp(-24 / (1 + root) ** 2),
    }
    if c.e:
        found["end_of_second_beta"] = sp.radsimp(-48 * (2 + root) / (root * (1 + root) ** 3))
    return found


def _far(e: Fraction) -> str:
    """What the roots do as the index grows without bound, in a sentence."""
    if e == 0:
        return "`s/p` and `sigma/Lambda` tend to `1/2`"
    if e == 1:
        return "`eta/Lambda`, `s/p` and `sigma/Lambda` tend to 1"
    return (
        f"`eta/Lambda` tends to `sqrt({e})`, and `s/p` and `sigma/Lambda` tend to "
        f"`(1 + sqrt({e}))/2`"
    )


def _inverse(c: Context) -> Slots:
    """From a gain back to the index."""
    share = "" if c.e in (0, 1) else f"({c.e}) "
    values = inverse_roots(c)
    return {
        "alpha_root": f"(eta + {share}Lambda)/(2 sigma)" if c.e else "2/sigma",
        "alpha_radicand": "4 (1 - alpha)" + (f" + {share}alpha^2" if c.e else ""),
        "rest_of_beta": inverses.rest_from_beta(
            BETA, c.e, values["beta_radical"], values["root_of_e"]
        ),
        "setting_of_index_from_beta": inverse_tower(c).name,
    }


def inverse_tower(c: Context) -> Tower:
    """The main tower, with sqrt(e) as a further generator where it is irrational."""
    names = surd(c.e)[1] if c.e else {}
    if not names:
        return c.tower
    roots = tuple(Generator(name, sp.Integer(number)) for name, number in names.items())
    return Tower(
        "with_root_of_e", c.tower.parameters, (*roots, *c.tower.generators), c.tower.expressions
    )


def inverse_roots(c: Context) -> dict[str, sp.Expr]:
    """Tower values of the radicals in `inverses`."""
    ratio = rational(c.e)
    from_beta = (2 * ROOT * ROOT_S + INDEX) / DEVIATION
    return {
        "alpha_radical": (ratio * INDEX + root_of_16(c.e)) / (2 * DEVIATION),
        "beta_radical": from_beta,
        "scaled_beta_radical": inverses.SCALE * from_beta,
        "root_of_rest": 1 / DEVIATION,
        "root_of_e": surd(c.e)[0] if c.e else sp.Integer(0),
    }
