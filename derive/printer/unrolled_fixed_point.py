"""A graph whose fixed points are written out: a start, Newton's steps, and the map once more.

The calls of `fixed_point` become others, which mean numbers near the fixed point X:
``["call", "start", s]``, ``["call", "iterate", n]`` and ``["call", "root", n]`` are the numbers of
node s or n, which is a start or a Newton step, and stand for X; ``["call", "less", a, b]`` is a - b
where b/a is at X at most the greatest slope of the map. What holds the unknown is written for each
iterate anew; what does not hold it comes first and is computed once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.derive.printer.derivative import Sum, Term, derivative, over_one
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.graph import Graph, GraphNode, fraction_text, operands
from gainproof.derive.printer.nested_roots import known_factor
from gainproof.derive.printer.newton import Convergence, slopes

CALLS = ("unknown", "fixed_point", "near_cbrt")


@dataclass(frozen=True)
class Cycle:
    """One fixed point: numbers of its iterates, start first and root last, and of the map there.

    The start lies within a factor 1 + `within` of the fixed point; `known`: without its roundings
    within this factor for all inputs, by the shape of the graph.
    """

    iterates: tuple[int, ...]
    map_value: int
    within: Fraction
    convergence: Convergence
    known: Fraction | None = None

    def at(self, place: Mapping[int, int]) -> Cycle:
        """The same with other numbers."""
        iterates = tuple(place[number] for number in self.iterates)
        return replace(self, iterates=iterates, map_value=place[self.map_value])


def unrolled(graph: Graph) -> tuple[Graph, tuple[Cycle, ...]]:
    """The graph without calls of `fixed_point`, and its fixed points; itself if it has none.

    ValueError names a node that is not as `fixed_point` describes it.
    """
    if not any(node[0] == "call" and node[1] in CALLS for node in graph["nodes"]):
        return graph, ()
    return _Unrolling(graph).run()


class _Unrolling:
    def __init__(self, graph: Graph) -> None:
        self.graph, self.old = graph, graph["nodes"]
        self.nodes: list[GraphNode] = []
        self.known: dict[tuple[str | int, ...], int] = {}
        self.place: dict[int, int] = {}
        self.cycles: dict[int, Cycle] = {}
        self.maps = self._maps()
        self.free = self._unknowns()

    def run(self) -> tuple[Graph, tuple[Cycle, ...]]:
        for number in range(len(self.old)):
            self._placed(number)
        self._require_values()
        outputs = {name: self.place[end] for name, end in self.graph["outputs"].items()}
        graph: Graph = {"nodes": self.nodes, "outputs": outputs}
        if "names" in self.graph:
            graph["names"] = {name: self.place[end] for name, end in self.graph["names"].items()}
        found = [replace(c, map_value=self.place[self.maps[u]]) for u, c in self.cycles.items()]
        return graph, tuple(found)

    def _is(self, number: int, name: str) -> bool:
        return self.old[number][:2] == ["call", name]

    def _maps(self) -> dict[int, int]:
        """The map of each unknown."""
        found: dict[int, int] = {}
        for number, node in enumerate(self.old):
            if self._is(number, "fixed_point"):
                unknown, value, _ = operands(node)
                if not self._is(unknown, "unknown") or found.setdefault(unknown, value) != value:
                    raise ValueError(f"node {number}: one unknown is wanted, and one map of it")
        return found

    def _unknowns(self) -> list[frozenset[int]]:
        """The unknowns that each node holds and no fixed point binds."""
        found: list[frozenset[int]] = []
        for number, node in enumerate(self.old):
            held = frozenset[int]().union(*(found[part] for part in operands(node)))
            if self._is(number, "unknown"):
                if held or number not in self.maps:
                    raise ValueError(f"node {number}: an unknown without a fixed point of its own")
                held = frozenset((number,))
            elif self._is(number, "fixed_point"):
                held -= {operands(node)[0]}
                if held:
                    raise ValueError(f"node {number}: a fixed point that holds another unknown")
            found.append(held)
        return found

    def _require_values(self) -> None:
        """ValueError for outputs whose meaning rests on a start."""
        wanted = set(self.graph["outputs"].values())
        for number in range(len(self.old) - 1, -1, -1):
            if number in wanted and not self._is(number, "unknown"):
                wanted.update(operands(self.old[number]))
        for number in sorted(wanted):
            if self._is(number, "near_cbrt"):
                raise ValueError(f"node {number}: near_cbrt stands in starts only")
        for name, end in self.graph["outputs"].items():
            if self.free[end]:
                raise ValueError(f"output {name} holds an unknown that no fixed point binds")

    def _put(self, *entry: str | int) -> int:
        number = self.known.setdefault(entry, len(self.nodes))
        if number == len(self.nodes):
            self.nodes.append(list(entry))
        return number

    def _number(self, value: Fraction) -> int:
        return self._put("number", fraction_text(value))

    def _placed(self, number: int) -> int:
        if number not in self.place:
            if self._is(number, "unknown"):
                self.place[number] = self._root(number)
            elif self._is(number, "fixed_point"):
                self.place[number] = self._placed(operands(self.old[number])[2])
            else:
                self.place[number] = self._copied(number, self.place)
        return self.place[number]

    def _copied(self, number: int, place: Mapping[int, int]) -> int:
        entries = (
            (place[entry] if entry in place else self._placed(entry))
            if isinstance(entry, int)
            else entry
            for entry in self.old[number]
        )
        return self._put(*entries)

    def _root(self, unknown: int) -> int:
        """The start and Newton's steps, as many as the start demands in float64."""
        end = self.maps[unknown]
        shape = slopes(self.old, unknown, end)
        if not shape.contracts:
            raise ValueError(
                f"node {end}: the logarithmic slope of a map with a fixed point lies between 0 and "
                f"a bound below 1, here between {shape.least} and {shape.most}"
            )
        convergence = Convergence(shape.most, shape.curvature)
        start, quality = operands(self.old[unknown])
        within = Fraction(str(self.old[quality][1])) if self.old[quality][0] == "number" else None
        if within is None or within <= 0:
            raise ValueError(f"node {unknown}: a start is within a positive number")
        chain = self._chain(unknown, end)
        for number in chain:
            for part in operands(self.old[number]):
                if not self.free[part]:
                    self._placed(part)
        iterates = [self._put("call", "start", self._placed(start))]
        count = max(1, convergence.steps(float(within), FLOAT64.unit_roundoff))
        for step in range(count):
            value = self._newton(unknown, chain, iterates[-1])
            iterates.append(self._put("call", "root" if step == count - 1 else "iterate", value))
        known = known_factor(self.old, unknown, start, end)
        self.cycles[unknown] = Cycle(tuple(iterates), -1, within, convergence, known)
        return iterates[-1]

    def _chain(self, unknown: int, end: int) -> list[int]:
        """The nodes of the map that hold the unknown, in order."""
        wanted = {end}
        for number in range(end, unknown, -1):
            if number in wanted:
                wanted.update(operands(self.old[number]))
        return [n for n in sorted(wanted) if n > unknown and unknown in self.free[n]]

    def _newton(self, unknown: int, chain: Sequence[int], x: int) -> int:
        """(g - x g')/(1 - g') with the derivative as a quotient n/d: (g d - x n)/(d - n)."""
        place: dict[int, int] = {**self.place, unknown: x}
        known: dict[int, Sum] = {unknown: (Term(Fraction(1)),)}
        for number in chain:
            place[number] = self._copied(number, place)
            known[number] = derivative(self.old, number, known)
        terms, divisor = over_one(known[chain[-1]])
        above = self._sum([self._product(term, place) for term in terms])
        below = self._product(Term(Fraction(1), divisor), place)
        image = self._put("mul", place[chain[-1]], below)
        over = self._put("call", "less", image, self._put("mul", above, x))
        return self._put("div", over, self._put("call", "less", below, above))

    def _sum(self, terms: Sequence[int]) -> int:
        return terms[0] if len(terms) == 1 else self._put("add", *terms)

    def _product(self, term: Term, place: Mapping[int, int]) -> int:
        factors = [place[factor] for factor in term.above]
        if term.coefficient != 1 or not factors:
            factors.append(self._number(term.coefficient))
        return factors[0] if len(factors) == 1 else self._put("mul", *factors)
