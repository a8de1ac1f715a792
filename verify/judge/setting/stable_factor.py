"""The stable factor of an innovation spectrum, in closed form for one, two and three states.

Of a filter in numbers with three states, z = (1 + s)/(1 - s) and u = -s^2, the spectrum times (1 -
s^2)^3 is A (1 + a1 u + a2 u^2 + a3 u^3) = A d(s) d(-s), with a Hurwitz polynomial d = 1 + d1 s +
d2 s^2 + d3 s^3: d1^2 = a1 + 2 d2, d2^2 = a2 + 2 d1 d3, d3^2 = a3. So d1 is a root of a polynomial
with rational coefficients, the one for which d1 d2 > d3 > 0, and all else is rational in it.

None of this is trusted: `steady_state` establishes what follows from it.
"""

from __future__ import annotations

from fractions import Fraction
from math import comb

import flint

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic, real_roots
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    sqrt,
    symbol,
    weighted,
    whole_power,
)
from gainproof.verify.judge.exact.polynomial import Ball, rational
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import INDEX
from gainproof.verify.judge.setting.matrices import Numbers
from gainproof.verify.judge.setting.spectral_factor import Factor, number_root
from gainproof.verify.judge.setting.spectrum import Laurent, at_point, spectrum
from gainproof.verify.judge.setting.three_states import three_states
from gainproof.verify.judge.transcendental.constant_folding import folded

ROOT = "root of the spectrum"
"""d1, where it is no rational number."""
BITS = 512
NO_STEADY_STATE = (
    "the model has no steady state: a mode on the unit circle is not driven by the process noise"
)


def stable_factor(
    f: Numbers, q: Numbers, h: Numbers, r: Fraction, squared_index: Fraction | None = None
) -> Factor:
    """c and S with all roots of c inside the unit circle, for all indices or for one. Raises
    Undecided.
    """
    rest, noise = spectrum(f, q, h, r)
    if squared_index is not None:
        return _in_numbers(len(f), rest, noise, squared_index)
    if len(f) == 1:
        return _one_state(rest, noise)
    if len(f) == 2:
        return _two_states(rest, noise)
    if len(f) == 3:
        return three_states(rest, noise)
    raise Undecided(f"a steady state with {len(f)} states is not covered")


def _in_numbers(size: int, rest: Laurent, noise: Laurent, squared_index: Fraction) -> Factor:
    """The factor of a filter whose index is a number: the same with a noise that is not scaled."""
    whole = {k: rest.get(k, Fraction(0)) + squared_index * noise.get(k, Fraction(0)) for k in rest}
    if any(at_point(whole, z) == 0 for z in (1, -1)):
        raise Undecided(NO_STEADY_STATE)
    if size == 3:
        return number_factor(whole, squared_index)
    if size > 3:
        raise Undecided(f"a steady state with {size} states is not covered")
    found = (_one_state if size == 1 else _two_states)(whole, {})
    return Factor(
        tuple(map(folded, found.coefficients)),
        folded(found.innovation),
        None,
        index=number_root(squared_index),
        squared_index=number(squared_index),
    )


def _one_state(rest: Laurent, noise: Laurent) -> Factor:
    """S (1 - p)^2 and S (1 + p)^2 are the values at 1 and -1."""
    plus, minus = _root_at(rest, noise, 1), _root_at(rest, noise, -1)
    total = plus + minus
    return Factor(((plus - minus) / total,), number(Fraction(1, 4)) * power(total, 2))


def _two_states(rest: Laurent, noise: Laurent) -> Factor:
    """S c(1)^2 and S c(-1)^2 are the values at 1 and -1, S c(0) the highest coefficient."""
    n2 = rest.get(2, Fraction(0))
    plus, minus = _root_at(rest, noise, 1), _root_at(rest, noise, -1)
    # S c(1) + S c(-1) = 2 S + 2 n2 and S c(+-1) = deviation * root: 2 deviation^2 - (plus + minus)
    # deviation + 2 n2 = 0;
    # the product of its roots is n2, the greater one is the deviation because |c(0)| < 1
    total = plus + minus
    if n2 == 0:  # the transition has no inverse: the deviation is half the sum
        return Factor((number(0), (plus - minus) / total), number(Fraction(1, 4)) * total * total)
    inside = folded(power(total, 2) - number(16 * n2))
    root = number_root(inside.fraction) if inside.kind == "number" else sqrt(inside)
    deviation = number(Fraction(1, 4)) * (total + root)
    other = number(Fraction(1, 4)) * (total - root)
    inverse = weighted([1 / n2], [other])
    return Factor(
        (
            weighted([1 / n2], [power(other, 2)]),
            number(Fraction(1, 2)) * (plus - minus) * inverse,
        ),
        power(deviation, 2),
    )


def _root_at(rest: Laurent, noise: Laurent, z: int) -> Expr:
    """The square root of the spectrum at 1 or -1."""
    index = symbol(INDEX)
    plain, driven = at_point(rest, z), at_point(noise, z)
    if plain == 0:
        return weighted([1], [index]) if driven == 1 else index * number_root(driven)
    if driven == 0:
        return number_root(plain)
    return sqrt(weighted([plain, driven], [number(1), power(index, 2)]))


def number_factor(spectrum: Laurent, squared_index: Fraction) -> Factor:
    """The factor of a spectrum in numbers, that of `squared_index`. Raises Undecided."""
    whole, *others = _moved(spectrum)
    if whole <= 0:
        raise Undecided(NO_STEADY_STATE)
    a1, a2, a3 = (a / whole for a in others)
    root = _first(a1, a2, a3)
    conditions: tuple[Rel, ...] = ()
    box, parameter = Box(), None
    d1: Expr = number(root.low)
    if not root.is_rational:
        d1, parameter, box = symbol(ROOT), ROOT, Box(root.low, root.high)
        powers = [whole_power(d1, k) for k in range(len(root.coefficients))]
        equation = weighted([Fraction(c) for c in root.coefficients], powers)
        conditions = (Rel("=", equation, number(0)),)
    d2 = folded((d1 * d1 - number(a1)) / 2)
    d3 = folded((d2 * d2 - number(a2)) / (2 * d1))
    total = folded(1 + d1 + d2 + d3)
    return Factor(
        (
            folded((1 - d1 + d2 - d3) / total),
            folded((3 - d1 - d2 + 3 * d3) / total),
            folded((3 + d1 - d2 - 3 * d3) / total),
        ),
        folded(number(whole / 64) * total * total),
        parameter,
        box,
        number_root(squared_index),
        number(squared_index),
        conditions=conditions,
    )


def _moved(spectrum: Laurent) -> list[Fraction]:
    """The coefficients of powers of u."""
    found = [Fraction(0)] * 4
    for k, value in spectrum.items():
        for up in range(4 + k):
            for down in range(up % 2, 4 - k, 2):
                half = (up + down) // 2
                found[half] += value * comb(3 + k, up) * comb(3 - k, down) * (-1) ** (down + half)
    return found


def _first(a1: Fraction, a2: Fraction, a3: Fraction) -> Algebraic:
    """d1 of the Hurwitz polynomial. Raises Undecided where there is none."""
    x, b = flint.fmpq_poly([0, 1]), [rational(a) for a in (a1, a2, a3)]
    equation = ((x * x - b[0]) ** 2 - 4 * b[1]) ** 2 - 64 * b[2] * x * x
    _, factors = flint.fmpz_poly(equation.numer()).factor()
    fitting = [
        root
        for factor, _ in factors
        for root in real_roots(factor)
        if _is_hurwitz(root.ball(BITS), flint.arb(b[0]), flint.arb(b[1]))
    ]
    if len(fitting) != 1:
        raise Undecided(NO_STEADY_STATE)
    return fitting[0].refined(Fraction(1, 1 << 20))


def _is_hurwitz(d1: Ball, a1: Ball, a2: Ball) -> bool:
    with flint.ctx.workprec(BITS):
        d2 = (d1 * d1 - a1) / 2
        d3 = (d2 * d2 - a2) / (2 * d1)
        return bool(d1 > 0 and d3 > 0 and d1 * d2 > d3)
