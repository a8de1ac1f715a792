"""Which names the definitions of a table of symbols use, directly or through others."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.work_limits import Undecided


class Reach:
    """Answers what a token's definition uses; each is worked out once."""

    def __init__(self, symbols: Mapping[str, SymbolEntry]) -> None:
        self._symbols = symbols
        self._direct: dict[str, frozenset[str]] = {}
        self._whole: dict[str, frozenset[str]] = {}

    def meets(self, token: str, names: Iterable[str]) -> bool:
        """Whether a token's definition uses one of the names."""
        return not self.of(token).isdisjoint(names)

    def of(self, token: str) -> frozenset[str]:
        """All names that a token's definition uses, itself left out."""
        if token not in self._whole:
            found: set[str] = set()
            pending = [token]
            while pending:
                for name in self._directly(pending.pop()):
                    if name not in found:
                        found.add(name)
                        pending.append(name)
            self._whole[token] = frozenset(found)
        return self._whole[token]

    def _directly(self, token: str) -> frozenset[str]:
        if token not in self._direct:
            entry = self._symbols.get(token)
            definition = None if entry is None else entry.definition
            readings = () if definition is None else definition.readings
            graphs = [reading.relations[0].right for reading in readings]
            if entry is not None and entry.variance is not None:
                # an expectation of a noise is made of its variance
                graphs.append(entry.variance)
            self._direct[token] = frozenset(
                name for graph in graphs for name in names_in(read_tree(graph))
            )
        return self._direct[token]

    def refuse_indexed(self, body: Expr, index: str, known: Collection[str]) -> None:
        """Raises Undecided if a symbol below, not among the known ones, has the bound name as its
        index.
        """
        for name in set(names_in(body)):
            for each in {name, *self.of(name)} - set(known):
                if each != index and index in indices_of(each):
                    raise Undecided(f"a sum over {index} of {each}, a symbol with that index")

    def refuse_free_index(self, body: Expr, index: str) -> None:
        """Raises Undecided if a free symbol below has a whole number as its index: with i the
        symbol x_i changes too, and nobody says how.
        """
        entry = self._symbols.get(index)
        if entry is None or not entry.integer:
            return
        for name in set(names_in(body)):
            for each in {name, *self.of(name)}:
                other = self._symbols.get(each)
                if other is not None and other.role == "free" and index in indices_of(each):
                    raise Undecided(f"{each} has the index {index}, which changes here")


def names_in(tree: Expr) -> Iterator[str]:
    """Names of symbols, functions and variables of derivatives."""
    for node in walk(tree):
        if node.kind in ("symbol", "call", "derivative", "at"):
            yield node.name


def indices_of(token: str) -> set[str]:
    """Letters and commands in the subscript of a token: those of `x_{sk-1}` are s and k."""
    found: set[str] = set()
    _, mark, rest = token.partition("_")
    while mark and rest:
        letter, rest = rest[0], rest[1:]
        if letter == "\\":
            size = next((k for k, c in enumerate(rest) if not c.isalpha()), len(rest))
            found.add(letter + rest[:size])
            rest = rest[size:]
        elif letter.isalpha():
            found.add(letter)
    return found
