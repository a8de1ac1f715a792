"""From a page to the steps and towers of a subject."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, NoValue, Parameter, Tower
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.pages.evaluation import Definition, Meanings
from gainproof.derive.pages.formula import NAME, Formula, FormulaError, nearest, read_formula
from gainproof.derive.pages.hints import read_hint
from gainproof.derive.pages.matrices import Letters, letters_of
from gainproof.derive.pages.page import (
    Block,
    Hint,
    Include,
    InWords,
    Item,
    Line,
    Made,
    Mark,
    Page,
    PageBlock,
    PageStep,
    Place,
    Prose,
    Theorem,
    read_page,
)
from gainproof.derive.pages.statement import Statement, relation_of
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import INFINITY, Relation, cited, described
from gainproof.derive.source import SOURCES
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import Statement as WordStatement

FOLDER = Path(__file__).parent
ENDS = {"0": End(), "infinity": End()}
"""Of a tower without roots."""
REFERENCE = re.compile(r"@([a-z0-9]+(?:-[a-z0-9]+)*)")
"""The number of another step, in sentences and reasons."""
STATED = (
    *("left", "right", "expression", "value", "from", "to", "variable"),
    *("matrix", "predicted", "updated", "gain", "index", "summand", "upper", "closed"),
)
"""The parts of relations that are made of quantities."""


@dataclass(frozen=True)
class Given:
    """What a page does not say.

    `towers`: settings that are not written on it. `models` by name. `slots`: values by group and
    slot, text (in formulas one in the names of the page), numbers or expressions; those of the page
    itself have the group "". `hints`: what evidence needs that no hint of the page says, by step
    (see `algebra.evidence`), formulas as text in the names of the page. `ends`: of towers with
    roots. `programs`: the graphs of kernels; `roots`: what their named roots are. `steps`: by name,
    that the program makes.
    """

    towers: tuple[Tower, ...] = ()
    models: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    slots: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    hints: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    ends: Mapping[str, Mapping[str, End]] = field(default_factory=dict)
    programs: Mapping[str, Graph] = field(default_factory=dict)
    roots: Mapping[str, str] = field(default_factory=dict)
    steps: Mapping[str, Sequence[Step]] = field(default_factory=dict)


@dataclass(frozen=True)
class Written:
    """A page made a derivation."""

    title: str
    opening: str
    steps: tuple[Step, ...]
    towers: Mapping[str, Tower]
    latex: Mapping[str, str]
    settings: Mapping[str, Setting] = field(default_factory=dict)
    """Of matrices."""


def written(name: str, given: Given, folder: Path = FOLDER) -> Written:
    """The derivation of the page of that name. Raises PageError with the line of a mistake."""
    page = page_of(name, folder)
    head = page.blocks[0] if page.blocks else None
    if not isinstance(head, Prose) or head.mark != "#":
        raise Place(page.file, 1).error("a page starts with '# Title'")
    making = _Making(given, folder)
    steps = tuple(making.steps(page))
    unknown = sorted(set(making.hints) - {step.id for step in steps})
    if unknown:
        raise Place(page.file, 1).error(f"hints for steps that are not there: {unknown}")
    shown = {step.id for step in steps if step.shown}
    for place, name in making.references:
        if name not in shown:
            hint = "".join(f"; near it: {near}" for near in nearest(name, shown))
            raise place.error(f"no step {name!r} is shown on this page{hint}")
    settings = {name: letters.setting for name, letters in making.letters.items()}
    return Written(head.head, head.text, steps, making.towers, making.latex, settings)


def page_of(name: str, folder: Path = FOLDER, primed: frozenset[str] = frozenset()) -> Page:
    """The page or part of that name. Raises PageError, OSError."""
    path = folder / f"{name}.md"
    shown = "/".join(path.parts[-3:])
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise Place(shown, 1).error("UTF-8 text is wanted") from None
    return read_page(text, shown, primed)


@dataclass
class _Making:
    given: Given
    folder: Path
    meanings: Meanings = field(default_factory=Meanings)
    towers: dict[str, Tower] = field(default_factory=dict)
    letters: dict[str, Letters] = field(default_factory=dict)
    proved: dict[str, WordStatement] = field(default_factory=dict)
    latex: dict[str, str] = field(default_factory=dict)
    heading: str = ""
    hints: dict[str, Mapping[str, Any]] = field(default_factory=dict)
    ids: set[str] = field(default_factory=set)
    references: list[tuple[Place, str]] = field(default_factory=list)

    def __post_init__(self) -> None:
        slots = self.given.slots.get("", {})
        self.meanings = replace(self.meanings, models=self.given.models, slots=slots)
        self.towers |= {tower.name: tower for tower in self.given.towers}
        self.hints |= self.given.hints

    def steps(self, page: Page) -> Iterator[Step]:
        for block in page.blocks:
            if isinstance(block, Hint):
                self._hinted(block)
        for block in page.blocks:
            try:
                yield from self._block(block)
            except FormulaError as error:
                raise block.place.error(str(error)) from None

    def _hinted(self, block: Hint) -> None:
        if block.id in self.hints:
            raise block.place.error(f"there is a hint for {block.id!r} already")
        try:
            self.hints[block.id] = read_hint(block.lines)
        except FormulaError as error:
            raise block.place.error(str(error)) from None

    def _block(self, block: PageBlock) -> Iterator[Step]:
        if isinstance(block, Hint):
            return
        if isinstance(block, PageStep):
            for step in self._step(block):
                found = REFERENCE.findall(f"{step.sentence} {step.reason}")
                self.references += [(block.place, name) for name in found]
                yield step
        elif isinstance(block, Include):
            yield from (
                self._included(block) if block.kind == "include" else self._made(block.part)
            )
        elif isinstance(block, Prose):
            self.heading = self._heading(block) if block.mark == "##" else ""
        elif block.kind == "kernel":
            yield self._kernel(block)
        elif block.kind == "setting":
            self.towers[block.name] = self._tower(block)
        elif block.kind == "matrices":
            self.letters[block.name] = self._letters(block)
        else:
            for line in block.lines:
                try:
                    self._names(line) if block.kind == "names" else self._let(line)
                except FormulaError as error:
                    raise line.place.error(str(error)) from None

    def _names(self, line: Line) -> None:
        if line.is_plain:
            for name in line.name.split(", "):
                self._quantity(name, name, name)
            return
        for value in line.values or ("",):
            name, quantity, printed = (
                text.removesuffix(line.variable) + value
                for text in (line.name, self._filled(str(line.meaning)), line.printed or line.name)
            )
            self._quantity(name, quantity, printed)

    def _quantity(self, name: str, quantity: str, printed: str) -> None:
        self.meanings.require_new(name)
        symbols = {**self.meanings.symbols, name: real(quantity)}
        self.meanings = replace(self.meanings, symbols=symbols)
        self._shown(quantity, printed)

    def _shown(self, quantity: str, printed: str) -> None:
        if shown := latex_of(printed):
            self.latex[quantity] = shown

    def _let(self, line: Line) -> None:
        assert isinstance(line.meaning, Formula)
        self.meanings = self.meanings.define(line.name, Definition(line.arguments, line.meaning))

    def _tower(self, block: Block) -> Tower:
        if not block.parameters and not block.lines:
            if block.name not in self.towers:
                names = ", ".join(tower.name for tower in self.given.towers)
                raise FormulaError(f"no setting {block.name!r} of the program; known: {names}")
            return self.towers.pop(block.name)
        parameters = tuple(
            Parameter(self.meanings.symbol(name).name, *((at,) if order == ">" else (None, at)))
            for name, order, at in block.parameters
        )
        generators: list[Generator] = []
        elements: dict[str, sp.Expr] = {}
        known = {parameter.symbol for parameter in parameters}
        for line in block.lines:
            assert isinstance(line.meaning, Formula)
            try:
                name = self.meanings.symbol(line.name).name
                root = (line.meaning.kind, line.meaning.text) == ("call", "sqrt")
                value = self.meanings.value(line.meaning.parts[0] if root else line.meaning)
                self._require_in(known, value, block.name)
                if root:
                    generators.append(Generator(name, value))
                else:
                    elements[name] = value
            except FormulaError as error:
                raise line.place.error(str(error)) from None
            known.add(name)
        try:
            return Tower(block.name, parameters, tuple(generators), elements)
        except (NoValue, ZeroDivisionError) as error:
            raise FormulaError(str(error)) from None

    def _letters(self, block: Block) -> Letters:
        listed: list[tuple[str, str, str]] = []
        found = letters_of(block.name, listed)
        for declared in block.letters:
            listed += [
                (name, quantity or name, declared.what) for name, quantity, _ in declared.letters
            ]
            try:
                found = letters_of(block.name, listed)
            except FormulaError as error:
                raise declared.place.error(str(error)) from None
            if not declared.what.startswith(("with inverse", "blocks of")):
                for name, quantity, printed in declared.letters:
                    self._shown(quantity or name, printed or name)
        for line in block.lines:
            assert isinstance(line.meaning, Formula)
            try:
                found = found.define(line.name, line.meaning)
            except FormulaError as error:
                raise line.place.error(str(error)) from None
        return found

    def _step(self, step: PageStep) -> Iterator[Step]:
        """Its statements; the first that is there has the sentence and the reason."""
        first = True
        for number, item in enumerate(step.items):
            mark, place = (item.mark, item.place) if number else (step.mark, step.place)
            if not self._is_there(mark, place):
                if number:
                    continue
                return
            mark = replace(mark, setting=mark.setting or step.mark.setting or "main")
            for each in self._statements(item, mark, place):
                yield self._opened(each, step) if first else replace(each, joins=True)
                first = False

    def _opened(self, each: Step, step: PageStep) -> Step:
        try:
            sentence, reason = self._filled(step.sentence), self._filled(step.reason)
        except FormulaError as error:
            raise step.place.error(str(error)) from None
        heading, self.heading = self.heading, ""
        return replace(each, sentence=sentence, reason=reason, heading=heading, joins=False)

    def _statements(self, item: Item, mark: Mark, place: Place) -> tuple[Step, ...]:
        try:
            if isinstance(item.said, Made):
                place = item.place
                return self._made(item.said.name)
            name, setting = self._id(mark.id), self._setting(mark.setting)
            made = Step(name, "", described(""), "", setting, shown=not mark.hidden)
            made, place = replace(made, essential=mark.essential), item.place
            if made.tower in self.letters and isinstance(item.said, Statement):
                return (self._of_matrices(made, item.said),)
            made = replace(made, relation=self._relation(item, made.tower))
            return (self._with_hint(made),)
        except FormulaError as error:
            raise place.error(str(error)) from None

    def _of_matrices(self, step: Step, said: Statement) -> Step:
        letters = self.letters[step.tower]
        if said.form == "where":
            return replace(step, relation=letters.meaning(said.parts[0].text))
        found = letters.proved(step.id, said, self.hints.get(step.id, {}), self.proved)
        self.proved[step.id] = found
        made = found.step("")
        return replace(step, relation=made.relation, hint=made.hint)

    def _is_there(self, mark: Mark, place: Place) -> bool:
        try:
            return not mark.condition or bool(self.meanings.slot(mark.condition))
        except FormulaError as error:
            raise place.error(str(error)) from None

    def _heading(self, block: Prose) -> str:
        match = re.fullmatch(rf"(.*) \(if ({NAME})\)", block.head)
        head, condition = match.groups() if match else (block.head, "")
        there = self._is_there(Mark(condition=condition), block.place)
        return self._filled(head) if there else ""

    def _setting(self, text: str) -> str:
        name = self._filled(text)
        known = (*self.towers, *self.letters)
        if name not in known:
            raise FormulaError(f"no setting {name!r} above; known: {', '.join(known)}")
        return name

    def _id(self, text: str) -> str:
        name = self._filled(text)
        if name in self.ids:
            raise FormulaError(f"there is a step {name!r} already")
        self.ids.add(name)
        return name

    def _relation(self, item: Item, setting: str) -> Relation:
        if isinstance(item.said, InWords):
            return described(self._filled(item.said.text))
        if isinstance(item.said, Theorem):
            return cited(self._filled(item.said.text), _source(item.said.source))
        assert isinstance(item.said, Statement)  # what the program makes has its relation
        relation = relation_of(item.said, self.meanings)
        self._require_known(relation, setting)
        return relation

    def _require_known(self, relation: Relation, setting: str) -> None:
        """Each quantity of a statement has to be one of its setting, or stand for any; in a
        definition there is nothing to decide.
        """
        if relation.kind == "definition":
            return
        tower, free = self.towers[setting], relation.parts.get("free", ())
        if relation.kind == "sum":
            free = (relation.parts["index"],)
        known = {*tower.variables, *tower.expressions}
        for quantity in free:
            if quantity in known:
                raise FormulaError(f"{self._name(quantity)!r} has a value in setting {setting}")
        for key in STATED:
            self._require_in({*known, *free}, relation.parts.get(key), setting)
        if "variable" in relation.parts:
            try:
                tower.parameter_of(relation.parts["variable"])
            except ValueError as error:
                raise FormulaError(str(error)) from None

    def _require_in(self, known: set[str], value: Any, setting: str) -> None:
        """Each quantity that a value is made of, or a list of names has, is one of these."""
        for quantity in sorted(_quantities(value)):
            if quantity not in known:
                raise FormulaError(f"{self._name(quantity)!r} has no value in setting {setting}")

    def _name(self, quantity: str) -> str:
        """What the page calls it."""
        names = (name for name, x in self.meanings.symbols.items() if x.name == quantity)
        return next(names, quantity)

    def _with_hint(self, step: Step) -> Step:
        found = dict(self.hints.get(step.id, {}))
        if step.relation.kind in ("limit", "increasing_onto"):
            found["ends"] = self.given.ends.get(step.tower, ENDS)
        return replace(step, hint={key: self._hint(value) for key, value in found.items()})

    def _hint(self, value: Any) -> Any:
        if isinstance(value, list):
            return [self._hint(each) for each in value]
        if not isinstance(value, str):
            return value
        try:
            return self.meanings.value(read_formula(value, self.meanings.primed))
        except FormulaError as error:
            raise FormulaError(f"its hint {value!r}: {error}") from None

    def _kernel(self, block: Block) -> Step:
        graph = self.given.programs.get(block.name)
        if graph is None:
            raise FormulaError(f"no kernel {block.name!r}; known: {', '.join(self.given.programs)}")
        tower = self.towers[self._setting(block.setting)]
        known, named = {*tower.variables, *tower.expressions}, graph.get("names", {})
        outputs: dict[str, Any] = {name: real(name) for name in graph["outputs"]}
        roots = {key: self._hint(x) for key, x in self.given.roots.items() if key in named}
        for line in block.lines:
            assert isinstance(line.meaning, Formula)
            try:
                if line.name not in (*outputs, *named):
                    listed = ", ".join([*outputs, *named])
                    raise FormulaError(f"no output or root {line.name!r}; known: {listed}")
                said = outputs if line.name in outputs else roots
                said[line.name] = self.meanings.value(line.meaning)
                self._require_in(known, said[line.name], tower.name)
            except FormulaError as error:
                raise line.place.error(str(error)) from None
        for value in outputs.values():
            self._require_in(known, value, tower.name)
        step = kernel_step(block.name, graph, outputs, block.setting, roots=roots)
        self._id(step.id)
        return step

    def _made(self, name: str) -> tuple[Step, ...]:
        if name not in self.given.steps:
            known = ", ".join(self.given.steps)
            raise FormulaError(f"no steps {name!r} of the program; known: {known}")
        found = tuple(self.given.steps[name])
        for step in found:
            self._id(step.id)
        return found

    def _included(self, block: Include) -> Iterator[Step]:
        if block.slots and block.slots not in self.given.slots:
            raise FormulaError(f"no slots {block.slots!r}; known: {', '.join(self.given.slots)}")
        name = self._filled(block.part)
        if not name:
            return
        path = self.folder / f"{name}.md"
        if not path.is_file():
            raise FormulaError(f"no file {path.name} beside this page")
        outside = self.meanings
        self.meanings = replace(outside, slots=self.given.slots.get(block.slots, {}))
        part = page_of(name, self.folder, outside.primed)
        for each in part.blocks:
            if isinstance(each, Include) or (isinstance(each, Prose) and each.mark == "#"):
                raise each.place.error("a part has no title and includes no other")
        yield from self.steps(part)
        self.meanings = outside

    def _filled(self, text: str) -> str:
        """With the values of its slots."""

        def value(match: re.Match[str]) -> str:
            found = self.meanings.slots.get(match[1])
            if not isinstance(found, (str, sp.Rational)):
                raise FormulaError(f"{match[0]!r} is no slot of words here")
            return str(found)

        return re.sub(r"\{([^}]*)\}", value, text)


def _quantities(value: Any) -> set[str]:
    if isinstance(value, str):
        return {value} - {INFINITY}
    if isinstance(value, list):
        return {name for part in value for name in _quantities(part)}
    return {symbol.name for symbol in getattr(value, "free_symbols", ())}


def latex_of(name: str) -> str:
    """How a name of a page is printed: Greek letters by their names, what follows _ below; nothing
    for a word.
    """
    match = re.fullmatch(r"([A-Za-z]+|1)(?:_([A-Za-z0-9_+|]+)|(\d+))?('?)", name)
    if match is None or (len(match[1]) > 1 and match[1] not in GREEK):
        return ""
    below = match[2] or match[3] or ""
    short = (len(below) == 1 and below.isalnum()) or below in GREEK
    subscript = f"_{_letter(below)}" if short else f"_{{{below}}}" * bool(below)
    return f"{_letter(match[1])}{subscript}{match[4]}"


GREEK = frozenset(
    re.findall(
        r"\w+",
        """
        alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi chi
        psi omega Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega
        """,
    )
)


def _letter(text: str) -> str:
    return f"\\{text}" if text in GREEK else text


def _source(key: str) -> str:
    for source in SOURCES:
        if source.key == key:
            return source.text()
    raise FormulaError(f"no source {key!r}; known: {', '.join(each.key for each in SOURCES)}")
