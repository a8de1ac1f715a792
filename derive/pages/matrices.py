"""Matrices of every size on a page: their letters, formulas of them, and statements with evidence.

Evidence is found by rewriting with what stands behind `if` (`derive.words`). Where that is not
enough, a hint says what else is used: see `Letters.proved`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from operator import add, matmul
from types import MappingProxyType
from typing import Any

from gainproof.derive.pages.formula import Formula, FormulaError, nearest, read_formula
from gainproof.derive.pages.statement import Statement
from gainproof.derive.relation import Relation, definition
from gainproof.derive.words import hypotheses, statement
from gainproof.derive.words.expression import Expression, number, symbol, unit
from gainproof.derive.words.hypotheses import Hypothesis
from gainproof.derive.words.polynomial import ShapeError
from gainproof.derive.words.rewriting import UnprovedError
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.traces import prove_traces_equal

SUPPOSED = {
    "symmetric": hypotheses.symmetric,
    "definite": hypotheses.definite,
    "semidefinite": hypotheses.semidefinite,
    "invertible": hypotheses.invertible,
    "full rank": hypotheses.full_column_rank,
}

REGULAR = ("invertible", "definite")


@dataclass(frozen=True)
class Letters:
    """A setting of matrices, and what a page calls its letters."""

    setting: Setting
    names: Mapping[str, str]

    def define(self, name: str, meaning: Formula) -> Letters:
        """With what one more letter stands for. Raises FormulaError."""
        element = {self._known(name): self._fitting(meaning)}
        elements = {**self.setting.elements, **element}
        return replace(self, setting=replace(self.setting, elements=elements))

    def value(self, formula: Formula) -> Expression:
        """What a formula says. Raises FormulaError for what matrices of every size have not."""
        if formula.kind == "call" and formula.text == "unit" and len(formula.parts) == 1:
            return unit(formula.parts[0].text)
        parts = [self.value(part) for part in formula.parts]
        match formula.kind:
            case "number":
                return number(int(formula.text))
            case "name":
                return symbol(self._known(formula.text))
            case "neg":
                return -parts[0]
            case "add":
                return reduce(add, parts)
            case "mul":
                return reduce(matmul, parts)
            case "div":
                if formula.parts[1] == Formula("number", "0"):
                    raise FormulaError(f"{str(formula)!r} divides by 0")
                if all(part.kind == "number" for part in parts):
                    return number(Fraction(parts[0].value) / Fraction(parts[1].value))
                return parts[0] / parts[1]
            case "pow":
                return parts[0] ** int(formula.text)
            case "transpose":
                return parts[0].T
            case "inverse":
                if parts[0].value not in self.setting.inverses:
                    raise FormulaError(f"{str(formula)!r}: a letter 'with inverse' is wanted")
                return parts[0].inverse
        raise FormulaError(f"{str(formula)!r} is no formula of matrices of every size")

    def meaning(self, name: str) -> Relation:
        """The definition of a letter. Raises FormulaError for one that has none."""
        known = self._known(name)
        if known not in self.setting.elements:
            raise FormulaError(f"{name!r} stands for nothing in setting {self.setting.name}")
        return definition(symbol(known).graph, self.setting.elements[known].graph)

    def proved(
        self,
        name: str,
        said: Statement,
        hint: Mapping[str, Any],
        known: Mapping[str, statement.Statement],
    ) -> statement.Statement:
        """The statement of a line with its evidence.

        `known`: the statements above. Of the hint, formulas being text: `using`, `aside`, `heavy`,
        `rounds`, `numbers`, `multiples` and `taken` are those of `Search`; `squares` and `rank`
        make orders, `definite` with `side` or `above` with `below` an equation, `used` one of
        traces, and `because` or `left_inverse` an inverse. What is referred to is a statement by
        its id, a condition behind `if` by its number from 1, or a source as `Search` has it.
        Without `using` it is what is said above of the inverses that occur; `rounds` is 1 for
        `M' = M`, else 0.

        Raises FormulaError where nothing shows it, and for a condition that it does not need.
        """
        try:
            given = [self._supposed(condition) for condition in said.given]
            mine = self.setting.name
            here = {key: each for key, each in known.items() if each.setting.name == mine}
            found = self._found(name, said, _Hint(self, hint, given, here))
        except (FormulaError, ShapeError) as error:
            raise FormulaError(str(error)) from None
        except (UnprovedError, ValueError, KeyError) as error:
            raise FormulaError(f"nothing shows that this is so: {error}") from None
        if list(found.given) != given:
            needed = [each for each in range(len(given)) if given[each] in found.given]
            listed = ", ".join(str(said.given[each]) for each in needed)
            raise FormulaError(
                f"as conditions behind 'if' it needs {listed or 'none'}"
                + ", and more of what it uses" * (len(found.given) > len(needed))
            )
        return found

    def _found(self, name: str, said: Statement, hint: _Hint) -> statement.Statement:
        parts, reads = said.parts, hint.entries
        symmetric = said.form == "equal" and parts[0] == Formula("transpose", "", (parts[1],))
        search = hint.search(self._inverses(said), rounds=int(symmetric))
        if said.form == "invertible":
            because = self._read(reads["left_inverse"]) if "left_inverse" in reads else None
            because = because or hint.because(self._known(parts[0].text), search)
            return statement.prove_invertible(name, search, self._known(parts[0].text), because)
        if said.form not in ("equal", "order", "positive"):
            raise FormulaError("on matrices of every size: L = R, L >= R, L > R, M is invertible")
        left, right = map(self._side, parts)
        if all(part.kind == "call" and part.text == "trace" for part in parts):
            return prove_traces_equal(name, search, left, right, hint.products("used"))
        if said.form != "equal":
            rank = hint.source(reads["rank"]) if "rank" in reads else None
            strict = said.form == "positive" and rank is None
            return statement.prove_order(name, search, left, right, hint.squares(), strict, rank)
        if "definite" in reads:
            middle = hint.source(reads["definite"])
            return statement.prove_equal_by_definite(
                name, search, left, right, middle, reads["side"]
            )
        if "above" in reads:
            above, below = hint.source(reads["above"]), hint.source(reads["below"])
            return statement.prove_equal_by_orders(name, search, left, right, above, below)
        return statement.prove_equal(name, search, left, right)

    def _inverses(self, said: Statement) -> set[str]:
        """The letters whose inverse is in a statement or in what letters of it stand for."""
        found: set[str] = set()
        waiting = [self.setting.expand(part) for part in map(self._side, said.parts)]
        while waiting:
            names = {letter for word, _ in waiting.pop().terms for letter, _ in word} - found
            found |= names
            waiting += [self.setting.meanings[x] for x in names if x in self.setting.meanings]
        return {x for x in self.setting.inverses if f"{x}_inverse" in found}

    def _side(self, formula: Formula) -> Expression:
        trace = formula.kind == "call" and formula.text == "trace"
        return self.value(formula.parts[0] if trace else formula)

    def _supposed(self, condition: Statement) -> Hypothesis:
        if condition.form == "equal":
            return hypotheses.equation(*map(self.value, condition.parts))
        return SUPPOSED[condition.form](self._known(condition.parts[0].text))

    def _known(self, name: str) -> str:
        if name not in self.names:
            near = nearest(name, self.names)
            hint = f"; {near[0]!r} is one" if near else ""
            raise FormulaError(f"{name!r} is no letter of setting {self.setting.name}{hint}")
        return self.names[name]

    def _fitting(self, formula: Formula) -> Expression:
        value = self.value(formula)
        try:
            self.setting.expand(value)
        except ShapeError as error:
            raise FormulaError(str(error)) from None
        return value

    def _read(self, text: str) -> Expression:
        return self.value(read_formula(text))


@dataclass(frozen=True)
class _Hint:
    letters: Letters
    entries: Mapping[str, Any]
    given: Sequence[Hypothesis]
    known: Mapping[str, statement.Statement]

    def search(self, inverses: set[str], rounds: int) -> Search:
        names = self.entries.get("using")
        if names is None:
            names = [name for name, each in self.known.items() if _says_of(each, inverses)]
        listed = [self.known[name] for name in names]
        entries = self.entries
        apart = [self.known[name] for name in entries.get("aside", ())]
        return Search(
            self.letters.setting,
            self.given,
            [found for found in listed if found not in apart],
            tuple(self.letters.names[name] for name in entries.get("heavy", ())),
            entries.get("rounds", rounds),
            self.products("multiples"),
            self.products("taken"),
            [self.letters._read(text) for text in entries.get("numbers", ())],
            [*apart, *(found for found in self._referred() if found not in (*listed, *apart))],
        )

    def _referred(self) -> list[statement.Statement]:
        """The statements that the hint refers to."""
        entries = self.entries
        sources = [entries.get(key) for key in ("definite", "above", "below", "because")]
        for key in ("multiples", "taken", "used", "squares"):
            sources += [entry[1] for entry in entries.get(key, ())]
        names = [x[1] if isinstance(x, tuple) and x[0] == "inverse" else x for x in sources]
        return [self.known[x] for x in dict.fromkeys(names) if isinstance(x, str)]

    def source(self, known: Any) -> Any:
        """A condition, a statement or what `Search` takes as it is."""
        if isinstance(known, int):
            return self.given[known - 1]
        return self.known[known] if isinstance(known, str) else known

    def because(self, letter: str, search: Search) -> Any:
        """Why a letter is invertible: a condition says so, or the last statement that it is > 0."""
        for condition in self.given:
            if condition.get("matrix") == letter and condition["kind"] in REGULAR:
                return condition
        graph = symbol(letter).graph
        for found in reversed([*self.known.values()]):
            if found.claim.get("larger") == graph and found.claim["relation"] == ">":
                search.aside = [*search.aside, found]
                return found
        raise FormulaError(f"nothing above or behind 'if' says that {letter} is invertible")

    def products(self, key: str) -> list[tuple[Expression, Any, Expression]]:
        read = self.letters._read
        return [
            (read(before), self.source(known), read(after))
            for before, known, after in self.entries.get(key, ())
        ]

    def squares(self) -> list[statement.Square]:
        return [self._square(*entry) for entry in self.entries.get("squares", ())]

    def _square(
        self, factor: str, middle: Any, more: Mapping[str, Any] = MappingProxyType({})
    ) -> statement.Square:
        weight, inverse = (
            self.letters._read(more[key]) if key in more else None
            for key in ("weight", "left_inverse")
        )
        factored, known = self.letters._read(factor), self.source(middle)
        return statement.Square(factored, known, weight, inverse, "through" in more)


def _says_of(found: statement.Statement, inverses: set[str]) -> bool:
    """Whether it says that one of these letters is invertible, or its inverse symmetric."""
    if found.kind == "matrix_invertible":
        return found.claim["matrix"] in inverses
    sides = [found.claim.get("left"), found.claim.get("right")]
    return sides in [[symbol(x).inverse.T.graph, symbol(x).inverse.graph] for x in inverses]


def letters_of(name: str, listed: Sequence[tuple[str, str, str]]) -> Letters:
    """The setting of that name; `listed`: of each letter the page's name, that of certificates, and
    what it is: rows 'by' columns, 'positive', 'real', 'unit of' a size, 'blocks of' a size, or
    'with inverse'. Raises FormulaError.
    """
    names: dict[str, str] = {}
    found: dict[str, list[tuple[str, str]]] = {}
    for called, quantity, what in listed:
        first, _, last = what.rpartition(" ")
        kind = "by" if first.endswith(" by") else (first if first.endswith(" of") else what)
        declared = kind in ("blocks of", "with inverse")
        if declared is not (called in names):
            wanted = "has no shape above" if declared else "has a meaning already"
            raise FormulaError(f"{called!r} {wanted}")
        names.setdefault(called, quantity)
        shape = what.replace(" by ", " ") if kind == "by" else last
        found.setdefault(kind, []).append((names[called], shape))
    blocks: dict[str, tuple[str, ...]] = {}
    for letter, size in found.get("blocks of", ()):
        blocks[size] = (*blocks.get(size, ()), letter)
    setting = Setting(
        name,
        dict(found.get("by", ())),
        tuple(letter for letter, _ in found.get("positive", ())),
        tuple(letter for letter, _ in found.get("real", ())),
        dict(found.get("unit of", ())),
        blocks,
        inverses=tuple(letter for letter, _ in found.get("with inverse", ())),
    )
    return Letters(setting, names)
