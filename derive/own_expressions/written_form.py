"""A kernel in the order of operations in which its author writes it, or with outputs in others.

That what is printed equals what was given is an identity of polynomials over parts. Of a part
over_k = 1/d is known that 1 - over_k d is 0, of part_k = sqrt(a) that part_k^2 - a is, of part_k =
|a| that part_k^2 - a^2 is; of two parts of equal arguments that their difference is. A difference
that is a sum of multiples of these is 0; that it is such a sum holds in all symbols, whatever they
stand for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

from gainproof.derive.algebra.plain_data import tower_data
from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.own_expressions.certificate_programs import arguments_of, held
from gainproof.derive.own_expressions.certified_kernel import Formed, Ready, first_step
from gainproof.derive.own_expressions.conditions import asked
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.own_expressions.graphs import graph_of_outputs
from gainproof.derive.own_expressions.kernels import kernel_of
from gainproof.derive.own_expressions.other_forms import Form
from gainproof.derive.own_expressions.parts import OVER, SQRT, NotReadError, Part, Parts
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.relation import Relation, equal
from gainproof.derive.subject import Program

NO_EVIDENCE: Mapping[str, Any] = {"roots": {}, "branches": {}, "gaps": {}, "nonzero": []}
"""Polynomials are expanded and compared: nothing else is needed."""


def as_written(given: ExpressionKernel, forms: Mapping[str, Form] | None = None) -> Formed:
    """The kernel, and that the arguments of its parts and its outputs are these polynomials; of
    outputs with another form, that this is equal to what its author writes.

    NotReadError for what a kernel cannot compute or another form that is not shown to be equal,
    PrintingError where it has no bound.
    """
    parts, chosen = Parts(), forms or {}
    required = asked(given.conditions)
    conditions = {each.required.name: parts.read(each.value) for each in required}
    positive = [conditions[each.required.name] for each in required if each.positive]
    outputs = {each.quantity.name: each.expression for each in given.outputs}
    printed = {name: chosen.get(name, Form(value)) for name, value in outputs.items()}
    meant = {name: parts.read(form.value, form.roots) for name, form in printed.items()}
    in_pairs = [name for name, form in printed.items() if form.in_pairs]
    graph = graph_of_outputs(meant | conditions, parts, in_pairs)
    kept, used = held(graph), list(parts.known.values())
    changed = {name: meant[name] for name, form in printed.items() if form != Form(outputs[name])}
    same = list(_same(given, parts, changed))
    require_values(used, list(parts.known.values()), positive)
    symbols = symbols_of(kept)
    sides = [side for each in same for side in each.relation.parts.values() if side]
    more = sorted({str(symbol) for side in sides for symbol in side.free_symbols})
    names = dict.fromkeys([*symbols, *more])
    tower = Tower(f"kernel_{given.name}", tuple(map(Parameter, names)), (), {})
    arguments = {
        name: argument
        for part in parts.known.values()
        for name, argument in zip(
            arguments_of(part.symbol.name, len(part.arguments)), part.arguments, strict=True
        )
        if name in kept["outputs"]
    }
    step = Step(
        f"kernel-{given.name.replace('_', '-')}",
        "The kernel computes this. Each root, divisor and function is a part with a name; its "
        "arguments, and the outputs, are polynomials over the inputs and other parts.",
        Relation(
            "program", {"program": given.name, "outputs": {**arguments, **meant, **conditions}}
        ),
        "Expand the polynomials on both sides.",
        tower=tower.name,
        hint={"evidence": NO_EVIDENCE},
    )
    return Formed(
        kernel_of(given, graph, stepwise=forms is not None),
        {tower.name: Ready(tower_data(tower))},
        {given.name: Program({name: name for name in symbols}, kept)},
        (first_step(given, tower.name), step, *(replace(each, tower=tower.name) for each in same)),
        lambda kernel: {kernel.name: held(kernel.graph)},
    )


def _same(given: ExpressionKernel, parts: Parts, meant: Mapping[str, sp.Expr]) -> Iterator[Step]:
    """That what is printed of these outputs is what was given."""
    for output in given.outputs:
        name = output.quantity.name
        if name not in meant:
            continue
        value = parts.read(output.expression)
        known = list(parts.known.values())
        start = f"form-{given.name}-{name}".replace("_", "-")
        yield Step(
            start,
            f"What is given of {name} less what is printed is a sum of multiples of what is 0, as "
            f"{'; '.join(map(str, known))}.",
            equal(value - meant[name], difference(value - meant[name], known)),
            "Expand the polynomials on both sides.",
            hint={"evidence": {"nonzero": []}},
        )
        for number, pair in enumerate(same_arguments(known), 1):
            hint = {"evidence": {"nonzero": list[str]()}}
            yield joined(f"{start}-{number}", equal(*pair), hint=hint)


MOST = 2000
"""Terms of a polynomial on the way: a guard."""


def difference(value: sp.Expr, parts: Sequence[Part]) -> sp.Expr:
    """A polynomial over inputs and parts as a sum of multiples of what is 0; `parts` in the order
    in which they were read, each over those before it. NotReadError where it is none.
    """
    symbols = sorted({value, *(a for part in parts for a in part.arguments)}, key=str)
    names = sorted(
        {s for each in symbols for s in each.free_symbols} | {p.symbol for p in parts}, key=str
    )
    ring = PolyRing(names, sp.QQ, sp.lex)
    left, times, found = ring.from_expr(value), ring.one, list[sp.Expr]()
    alike = _alike(parts)
    for part in reversed(parts):
        if not left:
            break
        place = names.index(part.symbol)
        if part.symbol in alike:
            other = names.index(alike[part.symbol])
            left, factor = _renamed(left, place, other)
            power, zero = 0, part.symbol - alike[part.symbol]
        elif part.function == OVER:
            divisor = ring.from_expr(part.arguments[0])
            left, factor, power = _over(left, place, divisor)
            zero = 1 - part.symbol * part.arguments[0]
        elif part.function in (SQRT, "abs"):
            (argument,) = part.arguments
            square = argument if part.function == SQRT else argument**2
            left, factor = _squared(left, place, ring.from_expr(square))
            power, zero = 0, part.symbol**2 - square
        else:
            continue
        if factor:
            found.append((times * factor).as_expr() * zero)
        times = times * ring.gens[place] ** power
        if len(left) > MOST or len(times) > MOST:
            raise NotReadError("forms too long to be compared")
    if left:
        raise NotReadError("forms that are not shown to be equal")
    return sp.Add(*(_real(each) for each in found))


def same_arguments(parts: Sequence[Part]) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Arguments that are equal polynomials, of parts that are therefore one number."""
    by_symbol = {part.symbol: part for part in parts}
    alike = _alike(parts)
    for symbol, first in alike.items():
        pairs = zip(by_symbol[symbol].arguments, by_symbol[first].arguments, strict=True)
        for one, other in pairs:
            if one.xreplace(alike) != other.xreplace(alike):
                yield one.xreplace(alike), other.xreplace(alike)


def require_values(
    printed: Sequence[Part], every: Sequence[Part], positive: Sequence[sp.Expr]
) -> None:
    """NotReadError for a divisor among `every` part that may be 0 where no `printed` one is, and
    for a root of what may be negative that is not printed: what was given has no value there, and
    what is printed would have one. `positive`: what inputs are asked to make so.
    """
    alike = _alike(every)
    fine = {factor for value in positive for factor in _factors(value, alike)}
    for part in printed:
        fine |= _factors(part.arguments[0], alike) if part.function == OVER else set()
    for part in reversed(every):  # of a root that is not 0 its argument is not
        if part.function == SQRT and part.symbol.xreplace(alike) in fine:
            fine |= _factors(part.arguments[0], alike)
    for part in every:
        left_out = part not in printed and part.symbol not in alike
        if part.function == "atan2" and left_out:
            raise NotReadError(f"{part}, where it has no value, is left out")
        if part.function == SQRT and left_out and not _never_negative(part.arguments[0]):
            raise NotReadError(
                f"{part.arguments[0]} may be negative, and no root is taken any more"
            )
        if part.function == SQRT and _factors(part.arguments[0], alike) <= fine:
            fine.add(part.symbol)
        if part.function == OVER and not _factors(part.arguments[0], alike) <= fine:
            raise NotReadError(f"{part.arguments[0]} may be 0, and is not divided by any more")


def _never_negative(value: sp.Expr) -> bool:
    """Whether a polynomial shows it: even powers with positive factors."""
    terms = sp.Poly(value, *sorted(value.free_symbols, key=str)).terms()
    return all(c > 0 and all(power % 2 == 0 for power in powers) for powers, c in terms)


def _factors(value: sp.Expr, alike: Mapping[sp.Symbol, sp.Symbol]) -> set[sp.Expr]:
    """The factors of a polynomial that are no numbers, each made monic."""
    _, factors = sp.factor_list(value.xreplace(dict(alike)))
    return {
        sp.Poly(factor, *sorted(factor.free_symbols, key=str)).monic().as_expr()
        for factor, _ in factors
    }


def _alike(parts: Sequence[Part]) -> dict[sp.Symbol, sp.Symbol]:
    """Parts that are another one before them, since their arguments are equal polynomials."""
    known: dict[tuple[object, ...], sp.Symbol] = {}
    found: dict[sp.Symbol, sp.Symbol] = {}
    for part in parts:
        arguments = (sp.expand(each.xreplace(found)) for each in part.arguments)
        first = known.setdefault((part.function, *arguments), part.symbol)
        if first != part.symbol:
            found[part.symbol] = first
    return found


def _renamed(poly: PolyElement, place: int, other: int) -> tuple[PolyElement, PolyElement]:
    """With s and t the symbols: poly = (s - t) factor + the same with t for s."""
    symbol, first = poly.ring.gens[place], poly.ring.gens[other]
    rest, factor = poly.ring.zero, poly.ring.zero
    for degree, coefficient in _by_power(poly, place).items():
        rest += coefficient * first**degree
        powers = (symbol**k * first ** (degree - 1 - k) for k in range(degree))
        factor += coefficient * sum(powers, poly.ring.zero)
    return rest, factor


def _over(
    poly: PolyElement, place: int, divisor: PolyElement
) -> tuple[PolyElement, PolyElement, int]:
    """With o the symbol of the part and d its divisor: poly = (1 - o d) factor + o^power rest."""
    by_power = _by_power(poly, place)
    power = max(by_power, default=0)
    one, symbol = poly.ring.one, poly.ring.gens[place]
    rest, factor, unit = poly.ring.zero, poly.ring.zero, symbol * divisor
    for degree, coefficient in by_power.items():
        rest += coefficient * divisor ** (power - degree)
        total = sum((unit**k for k in range(power - degree)), poly.ring.zero)
        factor += coefficient * symbol**degree * total
    return rest, factor * one, power


def _squared(poly: PolyElement, place: int, square: PolyElement) -> tuple[PolyElement, PolyElement]:
    """With s the symbol of the part: poly = (s^2 - square) factor + rest, at most linear in s."""
    symbol, factor = poly.ring.gens[place], poly.ring.zero
    while poly.degree(place) > 1:
        high = sum(
            (c * symbol ** (n - 2) for n, c in _by_power(poly, place).items() if n > 1),
            poly.ring.zero,
        )
        factor += high
        poly = poly - high * (symbol**2 - square)
    return poly, factor


def _by_power(poly: PolyElement, place: int) -> dict[int, PolyElement]:
    """Coefficients of the powers of one symbol."""
    found: dict[int, dict[tuple[int, ...], sp.Rational]] = {}
    for term, value in poly.terms():
        found.setdefault(term[place], {})[(*term[:place], 0, *term[place + 1 :])] = value
    return {power: poly.ring.from_dict(terms) for power, terms in found.items()}


def _real(value: sp.Expr) -> sp.Expr:
    """With the real symbols of expressions, not those of rings."""
    return value.xreplace({symbol: real(symbol.name) for symbol in value.free_symbols})
