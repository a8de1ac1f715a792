"""Derivatives, and what stays while T or the deviation of the measurement noise changes.

The tracking index is made of both and of the intensity of the process noise, so that nothing which
depends on it has a derivative with respect to one of them alone until it is said what stays: the
intensity (a model of the source's own has it, and it is what stays there), the index, or anything
else that fixes the index.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.expression import Expr, add, neg, number, symbol, symbols_of
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import Environment

VARIABLE = symbol("variable of a derivative")
"""No base variable is called like that."""


@dataclass(frozen=True)
class Slope:
    """A derivative as it stands in a statement: `formal`, by the rules, is the slope of `function`
    in VARIABLE at `place`, and may lack a value where the function has a slope.
    """

    function: Expr
    place: Expr
    formal: Expr

    def put_in(self, values: Mapping[str, Expr]) -> Slope:
        """The same with symbols replaced."""
        return Slope(*[substituted(e, values) for e in (self.function, self.place, self.formal)])


def slope_of(function: Expr, along: Expr, formal: Expr) -> Slope:
    """The derivative of a function with respect to a symbol."""
    return Slope(substituted(function, {along.name: VARIABLE}), along, formal)


def rate_of_parameter(held: Mapping[str, Expr], environment: Environment, name: str) -> Expr:
    """The derivative of the model's parameter with respect to the base variable `name`.

    `held` are the symbols that a claim says stay. Raises Undecided where they do not tell.
    """
    if environment.hidden:
        raise Undecided("how gains of a model with free numbers change with one of these")
    along = environment.parameter
    own = environment.own_variables()
    fixing = {token: e for token, e in held.items() if not own.isdisjoint(symbols_of(e))}
    moving = [t for t, e in held.items() if t not in fixing and name in symbols_of(e)]
    if moving:
        raise Undecided(f"{moving[0]} is said to be held, and changes with the variable")
    if not fixing and environment.intensity is not None:
        fixing = {environment.intensity: environment.assigned[environment.intensity]}
    if along is None or own != {along} or len(fixing) != 1:
        raise Undecided(
            "the tracking index changes with the sampling interval and with the measurement noise: "
            "say in the field held what stays, the intensity of the process noise or the index"
        )
    (stays,) = fixing.values()
    if name not in symbols_of(stays):
        return number(0)
    return neg(differentiated(stays, name) / differentiated(stays, along))


def total_derivative(entry: Expr, name: str, own: str, rate: Expr) -> Expr:
    """The derivative with respect to a base variable with which the parameter changes at a rate."""
    alone = differentiated(entry, name)
    return alone if rate == number(0) else alone + differentiated(entry, own) * rate


def along_pair(
    entry: Expr, own: str | None, rates: Mapping[str, Expr], environment: Environment
) -> Expr:
    """The derivative with respect to a base variable, or to anything else, with which two
    parameters change at these rates, given in the parameters.
    """
    known = {name: environment.coordinate(name) for name in environment.pair}
    terms = [environment.change(entry, n) * substituted(rate, known) for n, rate in rates.items()]
    return add(*terms) if own is None else add(differentiated(entry, own), *terms)


def partial_derivative(entry: Expr, target: Expr, token: str, environment: Environment) -> Expr:
    """The derivative with respect to what a token stands for: a base variable, a coordinate, or an
    expression of one variable, by the quotient of two derivatives. Raises Undecided.
    """
    if environment.is_coordinate(target):
        return environment.slope(entry, target)
    if target.kind == "symbol":
        return differentiated(entry, target.name)
    plain = tidied(target)
    variables = symbols_of(plain)
    # a coordinate changes alone: everything else in the entry stays
    alone = variables <= set(environment.coordinates)
    if len(variables) != 1 or not (alone or symbols_of(entry) <= variables):
        raise Undecided(f"a derivative with respect to {token}, which depends on several variables")
    name = next(iter(variables))
    return differentiated(entry, name) / differentiated(plain, name)
