"""Nodes of sums, integrals, derivatives and values at a place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gainproof.verify.judge.reader.constant import constant_value
from gainproof.verify.judge.reader.formula_limits import MOST_ORDER
from gainproof.verify.judge.reader.syntax_tree import Branch, children, sole, tokens

if TYPE_CHECKING:
    from gainproof.verify.judge.reader.graph_building import Builder


def long_sum(builder: Builder, tree: Branch) -> int:
    """A sum or a product over an index from a lower to an upper bound. It ends before the next one
    over the same index; whether a product goes on over one with another index, nobody can tell,
    unless that holds the index of the product.
    """
    kind = str(tokens(tree, "SUM")[0])
    index_range, upper, summand = _in_order(tree)
    name = str(tokens(index_range, "SYMBOL")[0])
    further = children(summand)[-1] if summand.data == "times_big" else None
    behind = None
    if further is not None and further.data in _SERIES:
        if _index(further) == name:
            summand, behind = children(summand)[0], further
        elif kind == "product" and not _is_free(name, further):
            problem = "what the product goes over is not clear: write brackets round its factors"
            raise builder.error(problem, tree)
    index = builder.nodes.add("symbol", name)
    lower = builder.value(children(index_range)[0])
    ends = index, lower, builder.value(upper)
    number = builder.nodes.add("call", kind, builder.value(summand), *ends)
    return number if behind is None else builder.many("mul", [number, builder.value(behind)])


_SERIES = ("big_sum", "big_sum_from_above")


def _in_order(tree: Branch) -> tuple[Branch, Branch, Branch]:
    """Index and lower bound, upper bound, and what stands behind."""
    first, second, summand = children(tree)
    return (first, second, summand) if tree.data == "big_sum" else (second, first, summand)


def _index(tree: Branch) -> str:
    return str(tokens(_in_order(tree)[0], "SYMBOL")[0])


def _is_free(name: str, tree: Branch) -> bool:
    """Whether a symbol stands there, but not as the index of another sum or product."""
    parts = children(tree)
    if tree.data in _SERIES:
        index_range, upper, summand = _in_order(tree)
        parts = [*children(index_range), upper, *([] if _index(tree) == name else [summand])]
    return name in map(str, tokens(tree, "SYMBOL")) or any(_is_free(name, part) for part in parts)


def family(builder: Builder, tree: Branch) -> int:
    """`(b_i)_{i=1}^n`: a row of as many entries."""
    entry, index_range, upper = children(tree)
    index = builder.nodes.add("symbol", str(tokens(index_range, "SYMBOL")[0]))
    lower = builder.value(children(index_range)[0])
    return builder.nodes.add(
        "call", "family", builder.value(entry), index, lower, builder.value(upper)
    )


def integral(builder: Builder, tree: Branch) -> int:
    """An integral over a variable between two bounds."""
    lower, upper, integrand = children(tree)
    if tree.data == "integral_from_above":
        lower, upper = upper, lower
    variable = builder.nodes.add("symbol", str(tokens(tree, "SYMBOL")[0]))
    return builder.nodes.add(
        "call",
        "integral",
        builder.value(integrand),
        variable,
        builder.value(lower),
        builder.value(upper),
    )


def derivative(builder: Builder, tree: Branch) -> int:
    """A derivative of any small order, partial or not: whether other symbols depend on the variable
    is for the definitions to say.
    """
    parts = children(tree)
    above = [child for child in parts if child.data == "order"]
    below = next(child for child in parts if child.data == "below")
    inner = next(child for child in parts if child.data not in ("order", "below"))
    if tree.data == "derivative_operator" and _has_bar(inner):
        problem = "a bar behind a derivative: write \\left. ... \\right|_{x=...} round both"
        raise builder.error(problem, inner)
    if tree.data == "derivative_operator" and _goes_on_behind_bracket(inner):
        problem = (
            "what the derivative is of is not clear: write brackets round all of it, or what it "
            "does not act on before it"
        )
        raise builder.error(problem, inner)
    symbols = _variables(builder, below, above, tree)
    return _differentiated(builder, builder.value(inner), symbols)


def derivative_there(builder: Builder, tree: Branch) -> int:
    """`\\frac{\\partial f}{\\partial x}(a)`: the derivative of a declared function of its own
    arguments, with a in their place.
    """
    parts = children(tree)
    above = [child for child in parts if child.data == "order"]
    below, places = parts[-2:]
    name = str(tokens(tree, "FUNCTION")[0])
    arguments = builder.vocabulary.symbols[name].arguments
    values = [builder.value(place) for place in children(places)]
    if len(values) != len(arguments):
        problem = f"{name} has {len(arguments)} arguments, not {len(values)}"
        raise builder.error(problem, places)
    own = [builder.nodes.add("symbol", argument) for argument in arguments]
    symbols = _variables(builder, below, above, tree)
    number = _differentiated(builder, builder.nodes.add("call", name, *own), symbols)
    moved = [item for item in zip(arguments, own, values, strict=True) if item[1] != item[2]]
    for argument, _, value in moved:
        if builder.nodes.symbols_in(value) & set(arguments):
            raise builder.error("values that depend on what they replace", places)
        number = builder.nodes.add("at", number, argument, value)
    return number


def _variables(builder: Builder, below: Branch, above: list[Branch], tree: Branch) -> list[str]:
    """The symbols of a derivative, each as often as its order."""
    symbols: list[str] = []
    for part in children(below):
        symbols += [str(tokens(part, "SYMBOL")[0])] * _order(builder, children(part))
    if _order(builder, above) != len(symbols):
        raise builder.error("orders above and below that differ", tree)
    return symbols


def _differentiated(builder: Builder, number: int, symbols: list[str]) -> int:
    for symbol in reversed(symbols):
        number = builder.nodes.add("derivative", number, symbol)
    return number


def _order(builder: Builder, orders: list[Branch]) -> int:
    """The number in `^2`, 1 without it."""
    if not orders:
        return 1
    value = constant_value(children(orders[0])[0])
    if value is None or value.denominator != 1 or not 1 <= value <= MOST_ORDER:
        problem = f"the order of a derivative must be a number up to {MOST_ORDER}"
        raise builder.error(problem, orders[0])
    return int(value)


def _has_bar(tree: Branch) -> bool:
    """Whether a bar stands in the outermost product of a term."""
    return tree.data == "product" and any(child.data == "evaluated" for child in children(tree))


def _goes_on_behind_bracket(term: Branch) -> bool:
    """Whether a term begins with a bracket, of which alone some would take the derivative, and has
    further factors.
    """
    further = term.data in ("times_big", "modulo")
    product = children(term)[0] if further else term
    if product.data != "product":
        return False
    first, *others = children(product)
    while first.data in ("raised", "transposed", "braced"):
        first = children(first)[0]
    return first.data == "group" and bool(further or others)


def evaluated(builder: Builder, number: int, statements: Branch) -> int:
    """A node with values put in: `x = 0, y = 1`."""
    found: list[tuple[str, int]] = []
    for chain in children(statements):
        sides = children(chain)
        name = _symbol_name(sides[0])
        if len(sides) != 2 or name is None or not (tokens(chain, "EQUAL") or _is_arrow(chain)):
            raise builder.error("after a bar a symbol = value is wanted", chain)
        (inner,) = children(sides[1])
        if inner.data == "limit" or len(sides[1].children) > 1:
            raise builder.error("after a bar a symbol = value is wanted", chain)
        found.append((name, builder.value(inner)))
    names = {name for name, _ in found}
    if len(found) > 1:
        for _, value in found:
            if builder.nodes.symbols_in(value) & names:
                raise builder.error("values that depend on what they replace", statements)
    for name, value in found:
        number = builder.nodes.add("at", number, name, value)
    return number


def _is_arrow(chain: Branch) -> bool:
    return [str(token) for token in tokens(chain, "RELATION")] == ["->"]


def _symbol_name(side: Branch) -> str | None:
    (inner,) = children(side) if len(side.children) == 1 else (side,)
    found = sole(inner)
    return str(found.children[0]) if found.data == "symbol" else None
