"""What stays, where a model has two parameters: index and S as products of powers of T, of the
deviation of the measured position, and of two symbols that stay while these change.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbol, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import DEVIATION, INTERVAL, Environment
from gainproof.verify.judge.transcendental.monomials import monomials

OPEN = (
    "what stays does not fix the two parameters of the model, or does so in more than one way: "
    "say in the field held which two symbols stay"
)


@dataclass(frozen=True)
class Pair:
    """`tokens` stay. `powers` of a coordinate holds the exponents of T, of the deviation and of the
    tokens; `unfolded` is the coordinate in these, the tokens as free symbols.
    """

    tokens: tuple[str, ...]
    powers: Mapping[str, Mapping[str, Fraction]]
    unfolded: Mapping[str, Expr]

    def moves(self, name: str) -> bool:
        """Whether a coordinate changes with it."""
        return any(powers.get(name) for powers in self.powers.values())

    def rates(self, name: str, value: Expr) -> dict[str, Expr]:
        """The derivatives of the coordinates with respect to T, the deviation or a token, whose
        value is given, in base variables.
        """
        return {
            coordinate: number(powers[name]) * symbol(coordinate) / value
            for coordinate, powers in self.powers.items()
            if powers[name]
        }


def pair_of(held: Mapping[str, Expr], environment: Environment, wanted: str | None = None) -> Pair:
    """For the symbols that a claim says stay, in base variables that hold both coordinates; symbols
    of the source's own model fill up what is missing. `wanted` is one of these, which is said to
    change alone. Raises Undecided where that fixes the coordinates in no way, or in several.
    """
    own = set(environment.coordinates)
    known = {token: environment.assigned[token] for token in environment.fixing}
    said = {token: e for token, e in held.items() if own & symbols_of(e)}
    if wanted is not None:
        said.setdefault(wanted, known[wanted])
    rest = [token for token in known if token not in said]
    match list(said):
        case []:
            tried = [tuple(rest)] if len(rest) == 2 else []
        case [one]:
            tried = [(one, other) for other in rest]
        case several:
            tried = [tuple(several)]
    fitting = [pair for t in tried if (pair := _solved(t, {**known, **said}, environment))]
    if len(fitting) != 1:
        raise Undecided(OPEN)
    return fitting[0]


def _solved(
    tokens: tuple[str, ...], values: Mapping[str, Expr], environment: Environment
) -> Pair | None:
    """From value = rest * first^p * second^q of two symbols the coordinates; None where they do not
    fix these.
    """
    if len(tokens) != 2:
        return None
    first, second = environment.coordinates
    exponents = [_exponents(values[t]) for t in tokens]
    (p, q), (s, t) = ([e.get(name, 0) for name in (first, second)] for e in exponents)
    area = Fraction(p * t - q * s)
    if area == 0:
        return None
    shares = {first: (t / area, -q / area), second: (-s / area, p / area)}
    ones = {first: number(1), second: number(1)}
    powers, unfolded = {}, {}
    for name, share in shares.items():
        powers[name] = {
            base: -sum(
                (c * e.get(base, 0) for c, e in zip(share, exponents, strict=True)),
                start=Fraction(0),
            )
            for base in (INTERVAL, DEVIATION)
        } | dict(zip(tokens, share, strict=True))
        factors = [
            power(symbol(free_name(token)) / substituted(values[token], ones), c)
            for token, c in zip(tokens, share, strict=True)
            if c
        ]
        unfolded[name] = mul(*factors)
    return Pair(tokens, powers, unfolded)


def _exponents(expr: Expr) -> dict[str, int]:
    """Of the base variables in a product of powers. Raises Undecided for anything else."""
    terms = monomials(expr)
    if len(terms) != 1:
        raise Undecided("what stays is no product of powers")
    ((monomial, c),) = terms.items()
    found = {}
    for base, exponent in monomial:
        if base.kind == "symbol":
            found[base.name] = exponent
        elif symbols_of(base):
            raise Undecided("what stays is no product of powers")
    if c < 0:
        raise Undecided("what stays is negative")
    return found
