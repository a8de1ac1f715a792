"""The records of a claim file: source, symbols, settings, claims. `file` makes them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.formula import Formula, Graph, Reading, Relation
from gainproof.verify.judge.matrices.letters import MatrixClaim, MatrixSetting


@dataclass(frozen=True)
class SourceRecord:
    """Bibliographic record; `key` is the short name by which the source is cited. Source code is
    found by `repository` and `commit`. `logarithm` is the base of `\\log` where none is printed,
    None for the natural one.
    """

    key: str
    title: str
    authors: tuple[str, ...]
    publication: str
    year: int | None = None
    url: str | None = None
    doi: str | None = None
    repository: str | None = None
    commit: str | None = None
    note: str | None = None
    logarithm: int | None = None


@dataclass(frozen=True)
class Unit:
    """Powers of base units. An angle in radians is of dimension one, one in degrees is not."""

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)
    kilogram: Fraction = Fraction(0)
    kelvin: Fraction = Fraction(0)
    ampere: Fraction = Fraction(0)
    degree: Fraction = Fraction(0)

    @property
    def powers(self) -> tuple[Fraction, ...]:
        """In the order of the fields."""
        of_masses = self.kilogram, self.kelvin, self.ampere
        return self.metre, self.second, *of_masses, self.degree

    def __mul__(self, other: Unit) -> Unit:
        return Unit(*(a + b for a, b in zip(self.powers, other.powers, strict=True)))

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1

    def __pow__(self, exponent: int | Fraction) -> Unit:
        return Unit(*(power * exponent for power in self.powers))


@dataclass(frozen=True)
class SymbolEntry:
    """One declared symbol.

    `latex` is the canonical token and the name of the symbol in expression graphs. `role` is

    * `quantity`: the quantity of the setting's model that `quantity` names (see `quantity_names`);
    * `free`: any real number of `unit` for which `domain` holds;
    * `definition`: short for `definition` (one reading or more; each reading has one relation,
      `token = formula`); with `arguments` it is a function, called in graphs as `["call", latex,
      ...]`;
    * `undefined`: printed by the source and never defined by it.

    `shape` is (rows, columns) for a matrix, None for a number. With a `variance` a free symbol is a
    noise with mean zero, independent of all other noises; `normal` says that it is Gaussian.
    """

    latex: str
    meaning: str
    role: str
    quantity: str | None = None
    unit: Unit | None = None
    domain: tuple[Relation, ...] = ()
    definition: Formula | None = None
    arguments: tuple[str, ...] = ()
    integer: bool = False
    shape: tuple[int, int] | None = None
    variance: Graph | None = None
    normal: bool = False


@dataclass(frozen=True)
class OwnModel:
    """Matrices of a user's model, each entry a graph over declared symbols: F, Q, H, R."""

    transition: tuple[tuple[Graph, ...], ...]
    process_noise: tuple[tuple[Graph, ...], ...]
    measurement: tuple[tuple[Graph, ...], ...]
    measurement_noise: tuple[tuple[Graph, ...], ...]


@dataclass(frozen=True)
class Setting:
    """What claims are about.

    `kind` is `steady_state` (`model` is a catalogue name, `search`, or None with `own_model`),
    `growing_memory` (least squares over all samples with a polynomial of `degree`), `fading_memory`
    (the same with weights that fall with the age of a sample, in the steady state), `kalman_bucy`
    (the steady state in continuous time: `own_model` holds A and densities), `fixed_gain`
    (a filter with any gains: of `states`, position with its derivatives, or of `gain_matrices`),
    `algebra` (no model: identities that follow from the definitions), or `matrices` (letters that
    are matrices of any size: these are in `matrices`, and `symbols` is empty). `symbols` holds
    every symbol of the file with this setting's own declarations put over the file's.

    `filters` are named filters with free gains, each with the equations between its gains.

    Conventions, each of which may be `search` where the source does not say; they act on the
    quantities `gain.i` and `covariance.i.j` and on noise symbols, and on nothing else:

    * `gain`: the gain is that of the `filter`, K, or of the `predictor`, F K;
    * `third_gain`: `gain.3` is this number times T^2 times the gain of the acceleration;
    * `power_of_T`: `gain.2` is this power of T times the gain of the velocity;
    * `noise`: what the source calls noise is its `deviation`, its `variance`, or the `ratio` of
      process noise to measurement noise;
    * `index_origin`: the number of the first sample;
    * `covariance`: `covariance.i.j` is that of the `predicted` or of the `updated` state.
    """

    name: str
    kind: str
    title: str
    symbols: Mapping[str, SymbolEntry]
    model: str | None = None
    own_model: OwnModel | None = None
    degree: int | None = None
    states: int | None = None
    gain_matrices: Mapping[str, tuple[tuple[Graph, ...], ...]] = field(default_factory=dict)
    filters: Mapping[str, tuple[Formula, ...]] = field(default_factory=dict)
    gain: str = "search"
    third_gain: str = "1"
    power_of_T: str = "1"
    noise: str = "deviation"
    index_origin: str = "0"
    covariance: str = "search"
    note: str | None = None
    matrices: MatrixSetting | None = None


@dataclass(frozen=True)
class OwnField:
    """What one of the fields says that only claims of one kind have: declared symbols, expressions
    and formulas, which messages on dimensions call `place`, names of filters, a word, a number.
    """

    symbols: tuple[str, ...] = ()
    expressions: tuple[Graph, ...] = ()
    formulas: tuple[Formula, ...] = ()
    place: str = ""
    filters: tuple[str, ...] = ()
    word: str = ""
    number: int = 0

    @property
    def symbol(self) -> str:
        """The symbol of a field that has one."""
        (found,) = self.symbols
        return found

    @property
    def expression(self) -> Graph:
        """The expression of a field that has one."""
        (found,) = self.expressions
        return found


@dataclass(frozen=True)
class Claim:
    """One claim in the order of the source.

    `formula` is None for a claim in words, which `text` paraphrases (`latex` is then empty).
    `plain` is the formula as typed where it was not given in LaTeX; `latex` is then printed from
    it. `domain` holds the relations of the field `domain` (conditions printed in the formula itself
    stay with the readings). `given` are relations taken as hypotheses, `held` the symbols that stay
    while T or the deviation of the measurement noise changes. `line` is the line of the
    claim's id in the file, 1 for the first.

    `own` are the fields that only claims of its kind have (see `kinds`), those that are there.
    `matrices` is what a claim of a setting of matrices says; `formula` is then None.
    """

    id: str
    place: str
    kind: str
    setting: str
    latex: str
    formula: Formula | None
    domain: tuple[Relation, ...] = ()
    given: tuple[Formula, ...] = ()
    held: tuple[str, ...] = ()
    own: Mapping[str, OwnField] = field(default_factory=dict)
    text: str | None = None
    note: str | None = None
    line: int = 1
    plain: str | None = None
    matrices: MatrixClaim | None = None


@dataclass(frozen=True)
class ClaimFile:
    """A whole claim file, checked. One that was read in spite of `errors` has only what is not
    touched by them; the claims `unread` have errors, or rest on what has some.
    """

    path: str
    source: SourceRecord
    symbols: Mapping[str, SymbolEntry]
    settings: Mapping[str, Setting]
    claims: tuple[Claim, ...]
    errors: tuple[ClaimFileError, ...] = ()
    unread: tuple[str, ...] = ()


__all__ = [
    "Claim",
    "ClaimFile",
    "Formula",
    "Graph",
    "OwnField",
    "OwnModel",
    "Reading",
    "Relation",
    "Setting",
    "SourceRecord",
    "SymbolEntry",
    "Unit",
]
