"""Towers for both ends of S: the velocity known exactly, and the velocity not measured.

The second is the steady state with measured position alone, whose own derivation is
`derive.steady_state`; its quantities bear the prefix `only_` here, those of the first `known_`.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state import towers as position_only
from gainproof.derive.vector_measurement.names import INDEX, RATIO, ROOT
from gainproof.derive.vector_measurement.process_noise import Noise
from gainproof.derive.vector_measurement.towers import (
    rational,
    steady_elements,
    steady_generators,
)

FAR = real("far")


def root_of_e(noise: Noise) -> tuple[sp.Expr, Mapping[str, int]]:
    """sqrt(e), over at most one root of an integer, with that root's name."""
    return position_only.surd(noise.e) if noise.e else (sp.Integer(0), {})


def eta_without_velocity(noise: Noise) -> sp.Expr:
    """sqrt(16 + e Lambda^2), what eta becomes for large S; over `far` where e > 0."""
    return root_of_e(noise)[0] * FAR if noise.e else sp.Integer(4)


def end_generators(noise: Noise) -> tuple[Generator, ...]:
    """sqrt(e)'s root, far = sqrt(Lambda^2 + 16/e) and s = delta/p for large S."""
    _, roots = root_of_e(noise)
    generators = [Generator(name, sp.Integer(number)) for name, number in roots.items()]
    if noise.e:
        generators.append(Generator("far", ROOT**4 + 16 / rational(noise.e)))
    high = eta_without_velocity(noise)
    inside = ((1 + rational(noise.e)) * ROOT**2 + 2 * high) / 4
    return (*generators, Generator("s", sp.expand(inside)))


def only_elements(noise: Noise) -> dict[str, sp.Expr]:
    """The steady state with measured position alone, its names prefixed."""
    found = position_only.steady_elements(noise.e, noise.n, ROOT**2)
    renamed = {real(name): real(f"only_{name}") for name in found if name != "tracking_index"}
    high = {real("H"): eta_without_velocity(noise)}
    return {
        f"only_{name}": expression.subs(high).subs(renamed)
        for name, expression in found.items()
        if name != "tracking_index"
    }


def known_updated(noise: Noise) -> sp.Expr:
    """U11 when the velocity is known exactly: 2 Lambda/(Lambda + far), or 0 for d = 0."""
    return 2 * INDEX / (INDEX + FAR) if noise.determinant else sp.Integer(0)


def end_elements(noise: Noise) -> dict[str, sp.Expr]:
    """Both ends: what is left without the velocity, and with the velocity known."""
    known = known_updated(noise)
    return {
        **only_elements(noise),
        "known_updated_11": known,
        "known_predicted_11": known + rational(noise.first) * INDEX**2,
    }


def ends_tower(noise: Noise) -> Tower:
    """The main tower after the roots of both ends."""
    return Tower(
        "ends",
        (Parameter("p"), Parameter("velocity_ratio")),
        (*end_generators(noise), *steady_generators(noise)),
        {**steady_elements(noise), **end_elements(noise)},
    )


def index_tower(noise: Noise) -> Tower:
    """Both ends alone, over the index."""
    elements = {"tracking_index": ROOT**2, **end_elements(noise)}
    if noise.determinant:
        elements["improvement"] = real("known_predicted_11") / real("only_predicted_11")
    return Tower("without_ratio", (Parameter("p"),), end_generators(noise), elements)


def ratio_ends(noise: Noise) -> Mapping[str, End]:
    """The tower `ends` where S falls to 0 and where it grows without bound, Lambda held."""
    generators = end_generators(noise)
    names = {entry.symbol: real(f"{entry.symbol}_held") for entry in generators}
    swap = {real(name): symbol for name, symbol in names.items()}
    constants = {str(names[g.symbol]): sp.sympify(g.radicand).subs(swap) for g in generators}
    held = dict(names)
    high = eta_without_velocity(noise).subs(swap)
    root = root_of_e(noise)[0].subs(swap)
    near = {"eta_scaled": high * ROOT**2 / 2} if noise.interval else {"eta_scaled": 2 * ROOT**2}
    near["delta_scaled"] = ROOT * (high + root * ROOT**2) / 4 if noise.interval else ROOT
    far = {"eta_scaled": high, "delta_scaled": names["s"]}
    if noise.determinant:
        near = {"level_scaled": root * ROOT**2 / 2, **near}
        far = {"level_scaled": sp.Integer(1), **far}
    weights = dict.fromkeys(far, 1)
    return {
        "0": End(constants=constants, boundary={**held, **near}),
        "infinity": End(weights=weights, constants=constants, boundary={**held, **far}),
    }


def index_ends(noise: Noise) -> dict[str, End]:
    """The main tower at both ends of the index, S held."""
    root, names = root_of_e(noise)
    near = {"eta_scaled": 4 * RATIO, "delta_scaled": RATIO * real("root_2")}
    constants: dict[str, int | sp.Expr] = {}
    if not noise.interval:
        constants["wide"] = RATIO**2 + 4
        wide = real("wide")
        far = {"eta_scaled": wide, "delta_scaled": (RATIO + wide) / 2}
        weights = {"eta_scaled": 2, "delta_scaled": 1}
    elif not noise.e:
        far = {"eta_scaled": sp.Integer(2), "delta_scaled": RATIO / 2 + 1}
        weights = {"eta_scaled": 2, "delta_scaled": 1}
    else:
        constants |= {f"{name}_held": number for name, number in names.items()}
        half = root.subs({real(name): real(f"{name}_held") for name in names}) / 2
        far = {"eta_scaled": half, "delta_scaled": half}
        weights = {"eta_scaled": 4, "delta_scaled": 3}
        if noise.determinant:
            near["level_scaled"], far["level_scaled"], weights["level_scaled"] = RATIO, half, 2
    return {
        "0": End(constants={"root_2": 2}, boundary=near),
        "infinity": End(weights=weights, constants=constants, boundary=far),
    }


def improvement_ends(noise: Noise) -> dict[str, End]:
    """The tower `without_ratio` at both ends of the index."""
    root, names = root_of_e(noise)
    held = {name: real(f"{name}_held") for name in names}
    constants = {f"{name}_held": number for name, number in names.items()}
    swap = {real(name): symbol for name, symbol in held.items()}
    inverse = sp.expand(4 * root.subs(swap) / rational(noise.e))
    # one root of 2, whether e has it or not: of two the checker does not know that they are one
    root_two = held.get("root_2", real("root_2"))
    near = {**held, "far": inverse, "s": root_two}
    far = {**held, "far": sp.Integer(1), "s": (1 + root.subs(swap)) / 2}
    return {
        "0": End(constants={**constants, str(root_two): 2}, boundary=near),
        "infinity": End(weights={"far": 2, "s": 1}, constants=constants, boundary=far),
    }
