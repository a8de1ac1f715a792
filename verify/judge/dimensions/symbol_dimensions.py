"""Dimensions of symbols and of calls of declared functions; those of definitions follow from their
formulas.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.dimensions.dimension import (
    ANY,
    ONE,
    Dimension,
    Dimensions,
    Mismatch,
    agreed,
    times,
)
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.formula import Formula

MOST_CALLS = 500
"""Calls of functions looked into: inside one another they double with every definition. What is
beyond has an unknown dimension.
"""
IN_DEFINITION = "in the definition of "
VARIANCES = "the variances of noises"
Asked = Callable[[Expr, "Names"], Dimensions]
"""What says the dimension of an expression over names."""


def has_degrees(setting: Setting) -> bool:
    """Whether a symbol is declared in degrees, or powers of them."""
    return any(entry.unit and entry.unit.degree for entry in setting.symbols.values())


class Names:
    """Dimensions of the symbols of a setting, and of the number pi, `circle`; `local` are those of
    arguments of functions.
    """

    def __init__(
        self,
        setting: Setting,
        asked: Asked,
        local: Mapping[str, Dimensions] | None = None,
        circle: Dimension = ONE,
    ) -> None:
        self.circle = circle
        self.setting = setting
        self.asked = asked
        self.local = dict(local or {})
        self.known: dict[str, Dimensions] = {"infinity": ANY}
        self.open: set[str] = set()
        self.calls: dict[tuple[str, tuple[Dimensions, ...]], Dimensions] = {}

    def with_circle(self, circle: Dimension) -> Names:
        """The same where the number pi has another dimension."""
        return Names(self.setting, self.asked, self.local, circle)

    def of(self, token: str) -> Dimensions:
        """The dimension of a symbol. Raises Mismatch where its definition mixes dimensions."""
        if token in self.local:
            return self.local[token]
        if token not in self.known:
            if token in self.open:
                return ANY
            self.open.add(token)
            try:
                entry = self.setting.symbols.get(token)
                self.known[token] = ANY if entry is None else self._of_entry(entry)
            finally:
                self.open.discard(token)
        return self.known[token]

    def _of_entry(self, entry: SymbolEntry) -> Dimensions:
        if entry.unit is not None:
            rows, columns = entry.shape or (1, 1)
            if rows == columns == 1:
                return entry.unit
            return ((entry.unit,) * columns,) * rows
        if entry.definition is None or entry.arguments:
            return ANY
        return self._body(entry.latex, entry.definition)

    def _body(self, token: str, definition: Formula) -> Dimensions:
        """By the first reading that agrees with itself. Raises Mismatch if none does."""
        fault: Mismatch | None = None
        for reading in definition.readings:
            try:
                return self.asked(read_tree(reading.relations[0].right), self)
            except Mismatch as found:
                fault = fault or found
        text = str(fault)
        raise Mismatch(text if text.startswith(IN_DEFINITION) else f"{IN_DEFINITION}{token} {text}")

    def called(self, token: str, arguments: Sequence[Dimensions]) -> Dimensions:
        """The value of a declared function of arguments with these dimensions. Raises Mismatch
        where they are not those of the symbols that stand for them in its declaration.
        """
        entry = self.setting.symbols.get(token)
        if entry is None or entry.definition is None or token in self.open:
            return ANY
        if len(arguments) != len(entry.arguments):
            return ANY
        given = {
            name: agreed(
                [self._declared(name), part], f"the argument {name} of {token} and its value"
            )
            for name, part in zip(entry.arguments, arguments, strict=True)
        }
        call = (token, tuple(given.values()))
        if call in self.calls:
            return self.calls[call]
        if len(self.calls) > MOST_CALLS:
            return ANY
        self.calls[call] = ANY
        self.open.add(token)
        try:
            inner = Names(self.setting, self.asked, given, self.circle)
            inner.open, inner.calls = self.open, self.calls
            self.calls[call] = inner._body(token, entry.definition)
        finally:
            self.open.discard(token)
        return self.calls[call]

    def _declared(self, token: str) -> Dimensions:
        """As the table of symbols has it, whatever an outer function put in its place."""
        entry = self.setting.symbols.get(token)
        return ANY if entry is None or entry.unit is None else self._of_entry(entry)

    def compare_variances(self) -> None:
        """Raises Mismatch if the variance of a noise has not the dimension of its square."""
        if VARIANCES in self.open:
            return  # a variance that is an expectation, which is refused where it is evaluated
        self.open.add(VARIANCES)
        try:
            for token, entry in self.setting.symbols.items():
                if entry.variance is not None and entry.unit is not None:
                    variance = self.asked(read_tree(entry.variance), self)
                    square = times(entry.unit, entry.unit)
                    agreed([square, variance], f"the square of {token} and its variance")
        finally:
            self.open.discard(VARIANCES)
