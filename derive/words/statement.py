"""Matrix statements with their evidence, found by rewriting; refused where nothing is found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gainproof.derive.derivation import Step
from gainproof.derive.relation import Relation
from gainproof.derive.words.expression import Expression
from gainproof.derive.words.hypotheses import Hypothesis
from gainproof.derive.words.polynomial import Polynomial
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting


@dataclass(frozen=True)
class Statement:
    """One statement: what it claims, under the hypotheses that its proof needs, and the proof."""

    id: str
    setting: Setting
    kind: str
    claim: Mapping[str, Any]
    evidence: Mapping[str, Any]
    given: tuple[Hypothesis, ...]
    equations: tuple[tuple[Polynomial, tuple[Any, ...]], ...] = field(default=(), repr=False)
    difference: Polynomial | None = None

    def step(self, sentence: str, reason: str = "", heading: str = "", joins: bool = False) -> Step:
        """The step of a derivation."""
        relation = Relation(self.kind, {**self.claim, "given": self.given})
        return Step(
            self.id,
            sentence,
            relation,
            reason,
            self.setting.name,
            {"evidence": self.evidence},
            heading=heading,
            joins=joins,
        )


def made(
    search: Search, name: str, kind: str, claim: Mapping[str, Any], evidence: Mapping[str, Any]
) -> Statement:
    """The statement with the hypotheses that were needed, and numbered evidence."""
    equations: tuple[tuple[Polynomial, tuple[Any, ...]], ...] = ()
    if kind == "matrix_equal":
        left, right = search.setting.pair(claim["left"], claim["right"])
        equations = ((left - right, ("statement", name)),)
    if kind == "matrix_invertible":
        letter = search.setting.letter(claim["matrix"])
        unit = search.setting.unit(search.setting.shape(claim["matrix"])[0])
        if claim["matrix"] in search.setting.inverses:
            inverse = search.setting.letter(f"{claim['matrix']}_inverse")
            equations = (
                (letter @ inverse - unit, ("inverse", name, "right")),
                (inverse @ letter - unit, ("inverse", name, "left")),
            )
    difference = None
    if kind == "matrix_order":
        larger, smaller = search.setting.pair(claim["larger"], claim["smaller"])
        difference = larger - smaller
    shown = {
        key: value.graph if isinstance(value, Expression) else value for key, value in claim.items()
    }
    numbered = search.numbered(evidence)
    return Statement(
        name, search.setting, kind, shown, numbered, search.needed, equations, difference
    )


def prove_equal(name: str, search: Search, left: Expression, right: Expression) -> Statement:
    """left = right, as a combination of the equations of the search."""
    one, other = search.setting.pair(left, right)
    cofactors = search.vanishing(one - other, name)
    return made(
        search, name, "matrix_equal", {"left": left, "right": right}, {"cofactors": cofactors}
    )


def prove_equal_by_definite(
    name: str, search: Search, left: Expression, right: Expression, middle: Any, side: str
) -> Statement:
    """left = right since N' D N = 0 for N = left - right ("left") or its transpose ("right")."""
    one, other = search.setting.pair(left, right)
    factor = one - other if side == "left" else (one - other).T
    reference, matrix = search.definite(middle)
    evidence = {
        "cofactors": search.vanishing(factor.T @ matrix @ factor, name),
        "definite": reference,
        "side": side,
    }
    return made(search, name, "matrix_equal", {"left": left, "right": right}, evidence)


def prove_equal_by_orders(
    name: str, search: Search, left: Expression, right: Expression, above: Any, below: Any
) -> Statement:
    """left = right since left - right is >= 0, being what `above` says is, and so is minus it."""
    one, other = search.setting.pair(left, right)
    (reference, known), (opposite, minus) = (search.definite(entry) for entry in (above, below))
    evidence = {
        "above": reference,
        "below": opposite,
        "cofactors": search.vanishing(one - other - known, name),
        "opposite": search.vanishing(known + minus, name),
    }
    return made(search, name, "matrix_equal", {"left": left, "right": right}, evidence)


@dataclass(frozen=True)
class Square:
    """weight F' D F; `middle`: what D is known by; `left_inverse`: for a strict order, L_k, of
    F_k or, where `through`, of D_k F_k, D_k being semidefinite only.
    """

    factor: Expression
    middle: Any
    weight: Expression | None = None
    left_inverse: Expression | None = None
    through: bool = False


def prove_order(
    name: str,
    search: Search,
    larger: Expression,
    smaller: Expression,
    squares: Sequence[Square],
    strict: bool = False,
    rank: Hypothesis | None = None,
) -> Statement:
    """larger >= smaller or, where left inverses of the squares' factors show it, >; `rank`: the
    same where the factor of the only square is a letter of full column rank by this hypothesis.
    """
    one, other = search.setting.pair(larger, smaller)
    rest = one - other
    listed = []
    unit = None if rest.shape is None else search.setting.unit(rest.shape[0])
    assert unit is not None
    inverses = []
    for number, square in enumerate(squares):
        reference, matrix = search.definite(square.middle)
        factor = search.setting.expand(square.factor)
        turned = str(factor.data()[0][0]).startswith("-")
        factor = -factor if turned else factor
        weight = search.setting.expand(square.weight) if square.weight else search.one
        rest = rest - weight @ (factor.T @ matrix @ factor)
        listed.append({"weight": weight.data(), "factor": factor.data(), "definite": reference})
        if strict and square.left_inverse is not None:
            inverse = search.setting.expand(square.left_inverse)
            inverse = -inverse if turned else inverse
            through = ["middle"] if square.through else []
            inverses.append([number, inverse.data(), *through])
            unit = unit - inverse @ (matrix @ factor if square.through else factor)
    evidence: dict[str, Any] = {"squares": listed, "cofactors": search.vanishing(rest, name)}
    if rank is not None:
        number = search.marked(rank)[1]
        evidence["rank"] = {"square": 0, "given": sorted(search.used).index(number)}
    elif strict:
        evidence["rank"] = {
            "left_inverses": inverses,
            "cofactors": search.vanishing(unit, name),
        }
    relation = ">" if strict or rank is not None else ">="
    claim = {"larger": larger, "smaller": smaller, "relation": relation}
    return made(search, name, "matrix_order", claim, evidence)


def prove_invertible(name: str, search: Search, matrix: str, because: Any) -> Statement:
    """The letter is invertible: a hypothesis says so, or an order statement that it is > 0."""
    if isinstance(because, Expression):
        left = search.setting.expand(because)
        unit = search.setting.unit(search.setting.shape(matrix)[0])
        rest = unit - left @ search.setting.letter(matrix)
        evidence: dict[str, Any] = {
            "left_inverse": left.data(),
            "cofactors": search.vanishing(rest, name),
        }
    else:
        evidence = {"because": search.marked(because)}
    return made(search, name, "matrix_invertible", {"matrix": matrix}, evidence)
