"""What a kind of claim is: one record, in the file that decides it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.claim.formulas import Symbols, graph_in, token_in
from gainproof.verify.judge.claim.record import Claim, OwnField
from gainproof.verify.judge.dimensions.symbol_dimensions import Names
from gainproof.verify.judge.formula import Graph, Reading
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.verdict import Finding

Judge = Callable[[Claim, Reading, Scope], Finding]
EQUATION = frozenset(("=",))
MOST_FIXED = 3


@dataclass(frozen=True)
class OwnFields:
    """The table of a claim while the fields of its kind are read; `has_formula` says whether it has
    one. What reads a field raises ClaimFileError; None is a field that may be missing.
    """

    fields: Fields
    symbols: Symbols
    has_formula: bool

    def token(self, name: str, text: str) -> str:
        """The canonical name of the declared symbol that a text of the field names."""
        return token_in(self.fields, name, text, self.symbols)

    def graph(self, name: str, text: str) -> Graph:
        """The expression that a text of the field is."""
        return graph_in(self.fields, name, text, self.symbols)


Read = Callable[[OwnFields, str], OwnField | None]
"""What reads the field of this name."""


def one_symbol(claim: OwnFields, name: str) -> OwnField:
    """A field that names a declared symbol."""
    return OwnField(symbols=(claim.token(name, claim.fields.required_text(name)),))


def expression(place: str) -> Read:
    """A field with one expression, which messages on dimensions call `place`."""

    def read(claim: OwnFields, name: str) -> OwnField:
        graph = claim.graph(name, claim.fields.required_text(name))
        return OwnField(expressions=(graph,), place=place)

    return read


def fixed(claim: OwnFields, name: str) -> OwnField:
    """A list of expressions that have the same value for all that are compared."""
    texts = claim.fields.texts(name, MOST_FIXED)
    if not texts:
        raise claim.fields.fail(name, "this field is missing: a list of what is the same")
    graphs = tuple(claim.graph(name, text) for text in texts)
    return OwnField(expressions=graphs, place="what is fixed")


def one_of(choices: Iterable[str], default: str | None = None) -> Read:
    """A field with one of a few words."""
    words = tuple(choices)
    return lambda claim, name: OwnField(word=claim.fields.choice(name, words, default))


@dataclass(frozen=True)
class Kind:
    """A kind of claim; `catalogue.KINDS` has all of them.

    `meaning` and `own_words` are its line in docs/claim-files.md: what it claims, and the fields
    `own` that claims of this kind alone have, each with what reads it. `judge` decides it; a kind
    that is `not_decided` says in these words why.

    Of the formula: its relations have one of `operators` (None: any), and `form` says what else is
    wrong with it, as words after "a claim of kind ..."; with `two_parts` it has an arrow or a
    trailing parenthesis. It may be missing where `needs_formula` is false, `needs_text` then wants
    words in its place. `units` are contradictions of dimensions between its own fields.

    `settings` that have it are of `matrices` of any size, or not (`numbers`), or `any`. With
    `of_setting` it speaks of the model even where its symbols do not.

    Repair: `repaired` says whether another formula may make it true; a `pointwise` one is what its
    relations say at each point of the domain; of a `rounded` one numbers are printed to their
    digits; of `strongest` ones no condition is offered that follows from another offer.
    """

    name: str
    meaning: str
    judge: Judge | None = None
    own: Mapping[str, Read] = field(default_factory=dict)
    own_words: str = ""
    operators: frozenset[str] | None = None
    form: Callable[[Reading], str | None] = lambda _: None
    units: Callable[[Claim, Names], Iterator[str]] = lambda *_: iter(())
    needs_formula: bool = True
    needs_text: bool = False
    not_decided: str = ""
    two_parts: bool = False
    settings: Literal["numbers", "matrices", "any"] = "numbers"
    of_setting: bool = False
    repaired: bool = True
    pointwise: bool = False
    rounded: bool = False
    strongest: bool = False
