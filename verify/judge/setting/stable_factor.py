"""The stable factor of an innovation spectrum, in closed form for one, two and three states.

None of this is trusted: `steady_state` establishes what follows from it.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol, weighted
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.folding import folded
from gainproof.verify.judge.setting.environment import INDEX
from gainproof.verify.judge.setting.factor import Factor, number_root
from gainproof.verify.judge.setting.matrix import Numbers
from gainproof.verify.judge.setting.number_factor import NO_STEADY_STATE, number_factor
from gainproof.verify.judge.setting.spectrum import Laurent, at_point, spectrum
from gainproof.verify.judge.setting.three_states import three_states


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
