"""Numbers of a model over its tower's parameters, and what makes polynomials of them."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from gainproof.derive.algebra.leading_terms import prime_powers
from gainproof.derive.any_two_state.domain import FreeNumbers


def over_parameters(numbers: FreeNumbers) -> Callable[[sp.Expr], sp.Expr]:
    """Expressions over the tower's parameters."""
    known = {sp.Symbol(name, real=True): value for name, value in numbers.elements.items()}
    return lambda entry: sp.cancel(sp.sympify(entry).subs(known))


def common_denominator(
    numbers: FreeNumbers, whole: tuple[sp.Expr, ...], squared: tuple[sp.Expr, ...]
) -> sp.Expr:
    """The least e with e f and e^2 n polynomials with whole coefficients."""
    powers: dict[sp.Expr, int] = {}
    for entries, share in ((whole, 1), (squared, 2)):
        for entry in entries:
            number, factors = sp.factor_list(sp.denom(sp.together(over_parameters(numbers)(entry))))
            primes = prime_powers(number).items()
            for factor, power in (*factors, *((sp.Integer(p), n) for p, n in primes)):
                powers[factor] = max(powers.get(factor, 0), -(-power // share))
    return sp.Mul(*(factor**power for factor, power in powers.items()))
