"""The value of a formula as read: node by node, with names bound where the formula binds them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from gainproof.verify.judge.dimensions.formula import OF_ANGLES
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    neg,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.functions import is_known
from gainproof.verify.judge.exact.work_limits import DEFAULT_LIMITS, Undecided
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.elementary_functions import elementary
from gainproof.verify.judge.meaning.square_matrices import (
    determinant,
    inverse,
    norm,
    raised,
    size_of,
    trace,
)
from gainproof.verify.judge.meaning.symbol_lookup import Marks, Names
from gainproof.verify.judge.meaning.value import (
    Value,
    added,
    divided,
    entries,
    kronecker,
    mapped,
    multiplied,
    negated,
    shape,
    shape_text,
    stacked,
    transposed,
)

SAME: Mapping[str, str] = MappingProxyType({"ln": "log", "arctan": "atan", "Tr": "trace"})
"""Names of one function."""
OF_MATRICES: Mapping[str, Callable[[Value], Value]] = MappingProxyType(
    {"det": determinant, "tr": trace, "trace": trace, "abs": size_of, "norm": norm}
)


def evaluated(tree: Expr, names: Names, bindings: Bindings) -> Value:
    """What a tree stands for under the bindings. Raises Undecided."""
    if tree.key not in bindings.trees:
        bindings.trees[tree.key] = _value(tree, names, bindings)
    return bindings.trees[tree.key]


def number_of(value: Value, what: str = "a number") -> Expr:
    """The value, which must be a number. Raises Undecided."""
    if not isinstance(value, Expr):
        raise Undecided(f"{shape_text(value)} stands where {what} is wanted")
    return value


def _value(node: Expr, names: Names, bindings: Bindings) -> Value:
    def part(place: int) -> Value:
        return evaluated(node.parts[place], names, bindings)

    match node.kind:
        case "number":
            return node
        case "symbol":
            return names.symbol(node.name, bindings)
        case "add":
            return added([evaluated(p, names, bindings) for p in node.parts])
        case "mul":
            return multiplied([evaluated(p, names, bindings) for p in node.parts])
        case "div":
            return divided(part(0), part(1))
        case "neg":
            return negated(part(0))
        case "pow":
            return _power(part(0), node)
        case "derivative":
            names.refuse_free_index(node.parts[0], node.name)
            return names.derivative(part(0), node.name, bindings)
        case "at":
            names.refuse_free_index(node.parts[0], node.name)
            _refuse_hidden(node, names, bindings)
            since = names.marks_alone(node.parts[0])
            # of free symbols alone nothing is kept for other parts of the formula
            inner = bindings if since is None else bindings.having({})
            body = evaluated(node.parts[0], names, inner)
            return _at(body, node.name, part(1), names, bindings, since)
        case "matrix":
            columns = int(node.name.split()[1])
            entries = [evaluated(p, names, bindings) for p in node.parts]
            starts = range(0, len(entries), columns)
            return stacked([entries[s : s + columns] for s in starts])
        case "transpose":
            return transposed(part(0))
        case "inverse":
            return inverse(part(0))
        case "kronecker":
            return kronecker(part(0), part(1))
        case "call":
            return _call(node, names, bindings)
        case _:
            raise Undecided(f"{node.kind} is not covered")


def _power(base: Value, node: Expr) -> Value:
    if isinstance(base, Expr):
        return Expr("pow", node.fraction, (base,))
    if node.fraction.denominator != 1:
        raise Undecided("a root of a matrix is not covered")
    return raised(base, int(node.fraction))


def _at(
    value: Value, token: str, place: Value, names: Names, bindings: Bindings, since: Marks | None
) -> Value:
    target = names.symbol(token, bindings)
    names.refuse_own_terms(value, token)
    replaced = entries(target)
    if any(entry.kind != "symbol" for entry in replaced) or len(set(replaced)) < len(replaced):
        raise Undecided(f"substitution for {token}, which is no free symbol")
    if any(names.is_shared(entry.name, *entries(value)) for entry in replaced):
        raise Undecided(f"substitution for {token}, with which the tracking index changes")
    if isinstance(target, Expr):
        number_of(place)
    elif shape(target) != shape(place):
        raise Undecided(f"{shape_text(place)} in place of {token}, {shape_text(target)}")
    put_in = {old.name: new for old, new in zip(replaced, entries(place), strict=True)}
    names.require_at(token, put_in, since)
    return mapped(value, lambda entry: substituted(entry, put_in))


def _refuse_hidden(node: Expr, names: Names, bindings: Bindings) -> None:
    """Raises Undecided if a value put in before holds, by its definition alone, what is replaced
    now: of values put in together none is meant to change another.
    """
    replaced = symbols_of(*entries(names.symbol(node.name, bindings)))
    before = node.parts[0]
    while before.kind == "at":
        value = before.parts[1]
        shown = any(part.value == node.name for part in walk(value))
        if not shown and replaced & symbols_of(*entries(evaluated(value, names, bindings))):
            raise Undecided("values put in that depend on what they replace")
        before = before.parts[0]


def _call(node: Expr, names: Names, bindings: Bindings) -> Value:
    name = node.name
    if names.is_declared(name):
        arguments = [evaluated(p, names, bindings) for p in node.parts]
        return names.function(name, arguments, bindings)
    if name in ("sum", "product", "integral"):
        return _bound(node, names, bindings)
    values = [evaluated(p, names, bindings) for p in node.parts]
    if name == "expectation" and len(values) == 1:
        return names.expectation(values[0], bindings)
    if name in OF_MATRICES and len(values) == 1:
        return OF_MATRICES[name](values[0])
    numbers = [number_of(v) for v in values]
    if name == "order" and len(numbers) == 1:
        return Expr("call", "order", tuple(numbers))
    if name == "power" and len(numbers) == 2:
        return general_power(*numbers)
    name = SAME.get(name, name)
    if name in OF_ANGLES and len(numbers) == 1:
        numbers = [names.angle(node.parts[0], numbers[0])]
    if (made := elementary(name, numbers)) is not None:
        return made
    if is_known(name, len(numbers)):
        return Expr("call", name, tuple(numbers))
    raise Undecided(f"the function {name} is not covered")


def general_power(base: Expr, exponent: Expr) -> Expr:
    """base^exponent: an algebraic power where the exponent is a number, else a call."""
    value = constant_value(exponent)
    if value is None:
        return Expr("call", "power", (base, exponent))
    if max(abs(value.numerator), value.denominator) > DEFAULT_LIMITS.exponent:
        raise Undecided(f"an exponent beyond {DEFAULT_LIMITS.exponent}")
    return power(base, value)


def _bound(node: Expr, names: Names, bindings: Bindings) -> Value:
    if len(node.parts) != 4 or node.parts[1].kind != "symbol":
        raise Undecided(f"a {node.name} needs a body, a variable and both bounds")
    token = node.parts[1].name
    low, high = (_edge(p, names, bindings) for p in node.parts[2:])
    return names.bound(node.name, node.parts[0], token, low, high, bindings)


def _edge(node: Expr, names: Names, bindings: Bindings) -> Value:
    if node.kind == "symbol" and node.name == "infinity":
        return symbol("infinity")
    if node.kind == "neg" and node.parts[0] == symbol("infinity"):
        return neg(symbol("infinity"))
    return evaluated(node, names, bindings)
