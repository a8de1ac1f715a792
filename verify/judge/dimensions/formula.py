"""The dimension of a formula, node by node: the one place that decides what agrees."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting, Unit
from gainproof.verify.judge.dimensions.dimension import (
    ANY,
    ONE,
    Dimension,
    Dimensions,
    Mismatch,
    agreed,
    entries,
    mapped,
    times,
    without_dimension,
)
from gainproof.verify.judge.dimensions.matrix_dimensions import (
    determinant,
    inverse,
    kronecker,
    multiplied,
    raised,
    stacked,
    transposed,
)
from gainproof.verify.judge.dimensions.symbol_dimensions import Names, has_degrees
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.reader.latex_printer import graph_to_latex
from gainproof.verify.judge.reader.words import BASED, OF_CASES

MOST_CHARACTERS = 60
"""Terms of so many characters are named."""
OF_NUMBERS = frozenset(
    (
        *("asin", "acos", "atan"),
        *("sinh", "cosh", "tanh", "exp", "log", "ln", "arctan", "erf", "erfinv", "floor", "ceil"),
    )
)
"""Functions of numbers: a series of powers of a length adds lengths to areas."""
OF_ANGLES = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))
"""Functions of angles, in radians, which are numbers, or in degrees."""
DEGREE = Unit(degree=Fraction(1))
ONE_OVER_DEGREE = ONE / DEGREE
ALIKE = frozenset(("max", "min", "atan2", "mod"))
"""Functions whose arguments are compared with one another."""
NUMBERS = frozenset(("sign", "rank"))
"""Functions of anything whose value is a number."""


def reading_fault(reading: Reading, setting: Setting) -> str | None:
    """What is wrong with the dimensions of a reading, or None."""
    both = reading.relations if reading.connective != "if" else ()
    names = names_of(in_said_units((*both, *reading.conditions), setting))
    for relation in (*reading.relations, *reading.conditions):
        fault = relation_fault(relation, names)
        if fault is not None:
            return fault
    return None


def in_said_units(relations: Iterable[Relation], setting: Setting) -> Setting:
    """The setting where `T = 1` says in which units all is counted: what is measured in powers of
    one of them has no dimension of it left.
    """
    names = names_of(setting)
    gone: set[int] = set()
    for relation in relations:
        sides = [side["nodes"][-1] for side in (relation.left, relation.right)]
        kinds = [node[0] for node in sides]
        if relation.operator != "=" or sorted(kinds) != ["number", "symbol"]:
            continue
        (token,) = [str(node[1]) for node in sides if node[0] == "symbol"]
        try:
            unit = names.of(token)
        except Mismatch:
            continue
        if not isinstance(unit, Unit):
            continue
        bases = [place for place, power in enumerate(unit.powers) if power]
        # an angle of 1 degree is no unit of the others: a sine would take them for radians
        if len(bases) == 1 and not unit.degree and ["number", "0"] not in sides:
            gone |= set(bases)
    if not gone:
        return setting

    def left(unit: Unit) -> Unit:
        return Unit(*(Fraction(0) if k in gone else p for k, p in enumerate(unit.powers)))

    symbols = {
        token: entry if entry.unit is None else replace(entry, unit=left(entry.unit))
        for token, entry in setting.symbols.items()
    }
    return replace(setting, symbols=symbols)


def relation_fault(relation: Relation, names: Names) -> str | None:
    """What is wrong with the dimensions of a relation, or None."""
    return fault_of(lambda one: _compare(relation, one), names)


def _compare(relation: Relation, names: Names) -> None:
    sides = [read_tree(side) for side in (relation.left, relation.right)]
    found = [dimension(side, names) for side in sides]
    # bounds of an angle in degrees are numbers of degrees
    bounds = DEGREE in found and any(map(_is_of_digits, sides))
    if relation.operator != "propto" and not bounds:
        agreed(found, "the sides")


def _is_of_digits(side: Expr) -> bool:
    return all(node.kind not in ("symbol", "call") for node in walk(side))


def number_beside_degrees(sides: Sequence[Graph], names: Names) -> bool:
    """Whether a number without symbols, not zero, is added to or compared with what is counted in
    degrees, or put in its place: among the sides or within one.
    """
    trees = [read_tree(side) for side in sides]
    compared: list[Sequence[Expr]] = [trees]
    for node in (node for tree in trees for node in walk(tree)):
        if node.kind in ("add", "call"):
            compared.append(node.parts)
        elif node.kind == "at":
            compared.append((Expr("symbol", node.name, ()), node.parts[1]))
    return any(
        any(_is_a_number(part) for part in parts)
        and any(_in_degrees(part, names) for part in parts)
        for parts in compared
    )


def _is_a_number(part: Expr) -> bool:
    kinds = [(node.kind, node.value) for node in walk(part)]
    without = all(kind != "symbol" and (kind != "call" or name == "pi") for kind, name in kinds)
    return without and not (part.kind == "number" and part.fraction == 0)


def _in_degrees(part: Expr, names: Names) -> bool:
    """Whether it is counted in powers of degrees, or holds what is where dimensions are mixed."""
    try:
        found = dimension(part, names)
    except Mismatch:
        return any(_in_degrees(inner, names) for inner in part.parts)
    return any(isinstance(entry, Unit) and entry.degree != 0 for entry in entries(found))


def graph_fault(graph: Graph, names: Names) -> str | None:
    """What is wrong with the dimensions inside an expression, or None."""
    return fault_of(lambda one: dimension(read_tree(graph), one), names)


def fault_of(ask: Callable[[Names], object], names: Names) -> str | None:
    """The mismatch that is found by asking for dimensions, or None. Beside degrees the number pi
    may be a part of 180 of them in one radian: nothing is wrong if that makes all agree.
    """
    circles = [names.circle, ONE_OVER_DEGREE] if has_degrees(names.setting) else [names.circle]
    found: str | None = None
    for circle in circles:
        try:
            ask(names if circle == names.circle else names.with_circle(circle))
        except Mismatch as fault:
            found = found or str(fault)
        except Malformed:
            return None  # reported where it is judged
        else:
            return None
    return found


def dimension_of(graph: Graph, setting: Setting) -> Unit | None:
    """The dimension of a formula that is a number; None if it mixes dimensions or is not known."""
    try:
        found = dimension(read_tree(graph), names_of(setting))
    except (Mismatch, Malformed):
        return None
    return found if isinstance(found, Unit) else None


def names_of(setting: Setting) -> Names:
    """The dimensions of a setting's symbols."""
    return Names(setting, dimension)


def dimension(expr: Expr, names: Names) -> Dimensions:
    """The dimension of an expression over declared symbols. Raises Mismatch."""
    done: dict[bytes, Dimensions] = {}
    for node in walk(expr):
        done[node.key] = _node(node, [done[p.key] for p in node.parts], names)
    return done[expr.key]


def _node(node: Expr, parts: list[Dimensions], names: Names) -> Dimensions:
    match node.kind:
        case "number":
            return ANY if node.fraction == 0 else ONE
        case "symbol":
            return names.of(node.name)
        case "add":
            return _terms(node, parts)
        case "mul":
            total = parts[0]
            for part in parts[1:]:
                total = multiplied(total, part)
            return total
        case "div":
            return _over(parts[0], parts[1])
        case "neg":
            return parts[0]
        case "pow":
            return _raised(parts[0], node.fraction)
        case "derivative":
            return _over(parts[0], names.of(node.name))
        case "at":
            agreed([names.of(node.name), parts[1]], f"{node.name} and what replaces it")
            return parts[0]
        case "matrix":
            columns = int(node.name.split()[1])
            starts = range(0, len(parts), columns)
            return stacked([parts[start : start + columns] for start in starts])
        case "transpose":
            return transposed(parts[0])
        case "inverse":
            return inverse(parts[0])
        case "kronecker":
            return kronecker(parts[0], parts[1])
        case "call":
            return _call(node.name, parts, names)
        case _:
            return ANY


def _terms(node: Expr, parts: list[Dimensions]) -> Dimensions:
    """The dimensions of a sum. The term that is not like the others is named."""
    try:
        return agreed(parts, "the terms of a sum")
    except Mismatch as fault:
        known = [n for n, part in enumerate(parts) if isinstance(part, Unit)]
        if len(known) < 2 or any(isinstance(part, tuple) for part in parts):
            raise
        usual = max(known, key=lambda n: parts.count(parts[n]))
        odd = next(n for n in known if parts[n] != parts[usual])
        if odd < usual and parts.count(parts[odd]) == parts.count(parts[usual]):
            odd, usual = usual, odd
        named = [graph_to_latex(graph_of(node.parts[n])) for n in (usual, odd)]
        if max(map(len, named)) > MOST_CHARACTERS:
            raise
        raise Mismatch(f"{fault}: {named[1]} is not like {named[0]}") from None


def _over(above: Dimensions, below: Dimensions) -> Dimensions:
    if isinstance(below, tuple):
        return ANY
    return mapped(above, lambda entry: times(entry, below, -1))


def _raised(base: Dimensions, exponent: Fraction) -> Dimensions:
    if isinstance(base, tuple):
        return raised(base, int(exponent)) if exponent.denominator == 1 else ANY
    return times(ONE, base, exponent)


def _call(name: str, parts: list[Dimensions], names: Names) -> Dimensions:
    match name:
        case "sum" | "product" | "integral" if len(parts) == 4:
            return _bound(name, *parts)
        case "expectation":
            names.compare_variances()
            return parts[0]
        case "det":
            return determinant(parts[0])
        case "abs" if isinstance(parts[0], tuple) and len(parts[0]) == len(parts[0][0]):
            return determinant(parts[0])
        case "abs" | "norm":
            return agreed(list(entries(parts[0])), "the entries of what stands between bars")
        case "tr" | "trace" | "Tr":
            return _trace(parts[0])
        case "power" if len(parts) == 2:
            without_dimension(parts[1], "an exponent")
            return ONE if parts[0] == ONE else ANY
    if name in names.setting.symbols:
        return names.called(name, parts)
    if name == "pi" and not parts:
        return names.circle
    if name in OF_ANGLES and DEGREE in parts:
        return ONE
    if name in OF_NUMBERS | OF_ANGLES or name.startswith(BASED):
        without_dimension(parts[0], f"the argument of {name}")
        return ONE
    if name.startswith(OF_CASES):
        return _cases(name, parts)
    if name in ALIKE:
        common = agreed(parts, f"the arguments of {name}")
        return ONE if name == "atan2" else common
    return ONE if name in NUMBERS else ANY


def _cases(name: str, parts: list[Dimensions]) -> Dimensions:
    """Of cases: their values are alike, and the sides of each condition are."""
    rest = iter(parts)
    values = []
    for operators in name.split(" ")[1:]:
        values.append(next(rest))
        for _ in [] if operators == "-" else operators.split(","):
            agreed([next(rest), next(rest)], "the sides of a condition")
    return agreed(values, "the values of cases")


def _bound(
    name: str, body: Dimensions, index: Dimensions, low: Dimensions, high: Dimensions
) -> Dimensions:
    """A sum, a product or an integral: its bounds are compared with what runs between them."""
    agreed([index, low, high], f"the bounds of the {name} and what runs between them")
    if name == "sum":
        return body
    if name == "product":
        return ONE if body == ONE else ANY
    return multiplied(body, index)


def _trace(part: Dimensions) -> Dimension:
    if not isinstance(part, tuple):
        return entries(part)[0]
    if len(part) != len(part[0]):
        return ANY
    diagonal: Sequence[Dimensions] = [part[i][i] for i in range(len(part))]
    found = agreed(diagonal, "the terms of a trace")
    assert not isinstance(found, tuple)
    return found
