"""Fixed points of programs: what binds an unknown, and why there is one value only.

A map y of x > 0 made of positive terms by sums, products, quotients and powers is positive, and its
logarithmic slope s(x) = x y'/y is read off its shape: that of x is 1, of a term without x 0, of a
product the sum, of a quotient the difference, of a power the multiple, and of a sum the mean of
those of its terms, weighed by the terms, hence between the least and the greatest of them. If
s <= S < 1 everywhere, log x - log y(x) as a function of log x has a slope of at least 1 - S > 0: it
takes the value 0 exactly once. So y has one positive fixed point, and whatever positive x has
y(x) = x is it. Nothing is differentiated.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.verify.certificate.graph import Call, Graph, Node, Operation, Power
from gainproof.verify.certificate.matrix import Matrix
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import GivenUpError, MalformedError, RejectedError

Range = tuple[Fraction, Fraction]

_NONE: Range = (Fraction(0), Fraction(0))

# Slopes as long as this come of no map that anybody writes, and cost time.
_MAXIMUM_BITS = 256


def require_bound(graph: Graph, place: str) -> None:
    """Reject an unknown that no fixed point binds, and a fixed point that binds no unknown.

    An unknown stands for a number where a fixed point reads it, and for nothing anywhere else. Its
    own arguments, a number near it and how near, are left to the printer.
    """
    maps: dict[int, int] = {}
    held: list[int] = []  # a bit for each unknown: wide sums of many stay quick
    for index, node in enumerate(graph.nodes):
        found = 0
        for argument in node.arguments:
            found |= held[argument]
        if isinstance(node, Call) and node.function == "unknown":
            found = 1 << index
        elif isinstance(node, Call) and node.function == "fixed_point":
            unknown, image, _ = node.arguments
            bound = graph.nodes[unknown]
            if not isinstance(bound, Call) or bound.function != "unknown":
                raise MalformedError(f"{place}: node {index}: node {unknown} is not an unknown")
            if maps.setdefault(unknown, image) != image:
                raise MalformedError(f"{place}: the unknown of node {unknown} has two maps")
            if found & ~(1 << unknown):
                raise MalformedError(f"{place}: node {index} holds another unknown")
            found = 0
        held.append(found)
    for name, end in graph.outputs.items():
        if held[end]:
            raise MalformedError(f"{place}: the output {name!r} holds an unknown")


def effort(graph: Graph) -> int:
    """The work of deciding one fixed point at most, in products of two terms."""
    return len(graph.nodes) + sum(len(node.arguments) for node in graph.nodes)


def require_one_fixed_point(
    graph: Graph, unknown: int, image: int, positive: Mapping[int, bool]
) -> None:
    """Reject unless the map's logarithmic slope is below 1 at every positive value of the unknown.

    ``positive`` says of the nodes without the unknown whether they are shown positive.
    """
    slopes = _slopes(graph, unknown, image, positive)
    if image not in slopes:
        raise RejectedError("the map does not hold its unknown")
    if not slopes[image][1] < 1:
        raise RejectedError(
            f"the logarithmic slope of the map is not shown to be below 1, only at most "
            f"{slopes[image][1]}"
        )


def shown_positive(node: Node, value: Ratio | Matrix, known: Mapping[int, bool]) -> bool:
    """Whether a value is manifestly positive, or made without differences of what is, as known."""
    if not isinstance(value, Matrix) and value.field.positive(value.numerator):
        return True
    if isinstance(node, Operation) and node.operator == "neg":
        return False
    made = isinstance(node, Operation | Power)
    return made and all(known[argument] for argument in node.arguments)


def _slopes(
    graph: Graph, unknown: int, image: int, positive: Mapping[int, bool]
) -> Mapping[int, Range]:
    """Of the nodes that hold the unknown and that the map needs."""
    slopes: dict[int, Range] = {unknown: (Fraction(1), Fraction(1))}
    for index in graph.reachable((image,), {unknown: (0, 1)}):
        node = graph.nodes[index]
        if index == unknown or not any(a in slopes for a in node.arguments):
            continue
        for argument in node.arguments:
            if argument not in slopes and not positive.get(argument, False):
                raise RejectedError(f"node {argument} of the map is not shown to be positive")
        terms = [slopes.get(a, _NONE) for a in node.arguments]
        match node:
            case Operation("add"):
                slopes[index] = min(low for low, _ in terms), max(high for _, high in terms)
            case Operation("mul"):
                slopes[index] = _sum(terms)
            case Operation("div"):
                over, (low, high) = terms
                slopes[index] = _sum([over, (-high, -low)])
            case Power(exponent):
                ends = [exponent * end for end in terms[0]]
                slopes[index] = min(ends), max(ends)
            case _:
                raise RejectedError(
                    f"node {index}: a map with a fixed point is made of sums, products, quotients "
                    "and powers"
                )
        if max(_bits(end) for end in slopes[index]) > _MAXIMUM_BITS:
            raise GivenUpError(f"given up: a slope of more than {_MAXIMUM_BITS} bits")
    return slopes


def _bits(value: Fraction) -> int:
    return max(abs(value.numerator), value.denominator).bit_length()


def _sum(terms: list[Range]) -> Range:
    zero = Fraction(0)
    return sum((low for low, _ in terms), zero), sum((high for _, high in terms), zero)
