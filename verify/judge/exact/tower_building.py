"""The tower of some expressions, built node by node."""

from __future__ import annotations

from collections.abc import Iterable

from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.polynomial import Poly, constant, ring, terms
from gainproof.verify.judge.exact.radicands import (
    Element,
    product_of_roots,
    simplified,
    split_off,
)
from gainproof.verify.judge.exact.rational_roots import number_root
from gainproof.verify.judge.exact.tower import Check, Root, Tower
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Limits, Undecided


def build_tower(
    exprs: Iterable[Expr],
    parameters: tuple[str, ...] | str | None,
    free: tuple[str, ...],
    positive: frozenset[str],
    limits: Limits = DEFAULT_LIMITS,
    nonnegative: frozenset[str] = frozenset(),
    *,
    formal: bool = False,
) -> Tower:
    """The tower of these expressions; all powers must be integer powers, square roots or cube
    roots.

    `free` symbols may not stand under a root except as powers of those in `positive`; in a `formal`
    tower, of which no branch is asked, all may. Raises Undecided, NeedsPower.
    """
    if not isinstance(parameters, tuple):
        parameters = () if parameters is None else (parameters,)
    nodes = list(walk(*exprs))
    slots = sum(1 for n in nodes if n.kind == "pow" and n.fraction.denominator != 1)
    if slots > limits.root_count:
        raise Undecided(f"more than {limits.root_count} different roots")
    tower = Tower(parameters, free, positive, limits, nonnegative=nonnegative, formal=formal)
    tower._slots = slots
    tops = tuple(f"t{k}" for k in range(slots, 0, -1))
    several = len(parameters) > 1
    bases = tuple(f"x{k}" for k in range(1, len(parameters) + 1)) if several else ("x",)
    lows = tuple(f"u{k}" for k in range(len(free))) + bases[: len(parameters)]
    tower.names = (*tops, *lows)
    tower.context = ring(tower.names or ("x",))
    for node in nodes:
        tower.elements[node.key] = _element(tower, node)
    return tower


def _element(tower: Tower, node: Expr) -> Element:
    one = constant(tower.context, 1)
    parts = [tower.elements[p.key] for p in node.parts]
    match node.kind:
        case "number":
            return Element(constant(tower.context, node.fraction), one)
        case "symbol":
            if node.name in tower.parameters:
                place = tower.parameter_indices[tower.parameters.index(node.name)]
                return Element(tower.context.gen(place), one)
            if node.name in tower.free:
                return Element(tower.context.gen(tower._slots + tower.free.index(node.name)), one)
            raise Undecided(f"the symbol {node.name} has no meaning here")
        case "add":
            total = parts[0]
            for other in parts[1:]:
                total = _sum(tower, total, other)
            return total
        case "mul":
            total = parts[0]
            for other in parts[1:]:
                total = _product(tower, total, other)
            return total
        case "neg":
            return Element(-parts[0].num, parts[0].den)
        case "div":
            tower.checks.append(Check(node, parts[1].num, None))
            return _product(tower, parts[0], _inverse(tower, parts[1]))
        case "pow":
            return _power(tower, node, parts[0])
        case _:
            raise Undecided(
                f"the function {node.value} is not covered" if node.kind == "call" else node.kind
            )


def _inverse(tower: Tower, x: Element) -> Element:
    if x.num.is_zero():
        # the check on this node fails everywhere, so the value is never used
        return Element(constant(tower.context, 0), constant(tower.context, 1))
    return Element(x.den, x.num)


def _sum(tower: Tower, x: Element, y: Element) -> Element:
    if x.den == y.den:
        return _tidy(tower, x.num + y.num, x.den)
    return _tidy(tower, x.num * y.den + y.num * x.den, x.den * y.den)


def _product(tower: Tower, x: Element, y: Element) -> Element:
    return _tidy(tower, x.num * y.num, x.den * y.den)


def _tidy(tower: Tower, num: Poly, den: Poly) -> Element:
    num, den = tower.reduce(num), tower.reduce(den)
    if den.is_zero():
        raise Undecided(
            "a product of two denominators vanishes identically on another branch of the roots"
        )
    if num.is_zero():
        return Element(num, constant(tower.context, 1))
    if not den.is_constant():
        # where the expression is defined den is not zero, so neither is a factor of it
        common = num.gcd(den)
        if not common.is_constant():
            num, den = divmod(num, common)[0], divmod(den, common)[0]
    lead = den.leading_coefficient()
    return Element(num / lead, den / lead)


def _power(tower: Tower, node: Expr, base: Element) -> Element:
    exponent = node.fraction
    if exponent.denominator != 1:
        return _root(tower, node, base, exponent.denominator)
    times = abs(exponent.numerator)
    if times > tower.limits.exponent:
        raise Undecided(f"an exponent beyond {tower.limits.exponent}")
    if exponent < 0:
        tower.checks.append(Check(node, base.num, None))
        base = _inverse(tower, base)
    result = Element(constant(tower.context, 1), constant(tower.context, 1))
    for _ in range(times):
        result = _product(tower, result, base)
    return result


def _root(tower: Tower, node: Expr, base: Element, order: int) -> Element:
    one = constant(tower.context, 1)
    variables = tower.variables
    num, den, outside = simplified(base, order, variables)
    if num.is_zero():
        return Element(num, one)
    for exponents, _ in [*terms(num), *terms(den)]:
        if not tower.formal and any(exponents[i] for i in tower.free_indices):
            raise Undecided("several parameters stand under one root")
    plain = number_root(num, den, order)
    if plain is not None:
        return _product(tower, outside, Element(constant(tower.context, plain), one))
    known = [(r.index, r.radicand) for r in tower.roots if r.order == order]
    while (split := split_off(num, order, known, variables)) is not None:
        num, outside = split[0], _product(tower, outside, split[1])
    product = product_of_roots(num, den, order, known, variables)
    if product is not None:
        return _product(tower, outside, product)
    root = next(
        (r for r in tower.roots if r.order == order and r.radicand == Element(num, den)), None
    )
    if root is None:
        index = tower._slots - 1 - len(tower.roots)
        relation = tower.context.gen(index) ** order - tower.reduce(num * den ** (order - 1))
        root = Root(index, order, Element(num, den), relation)
        tower.roots.append(root)
        if tower.degree > tower.limits.tower_degree:
            raise Undecided(f"a tower of roots of degree more than {tower.limits.tower_degree}")
    tower.checks.append(Check(node, root.sign_poly, root))
    return _product(tower, outside, Element(tower.context.gen(root.index), den))
