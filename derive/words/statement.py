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

Reference = tuple[Any, ...]
"""A hypothesis (itself), a `Statement`, or ("unit", size): what is known to be definite."""


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


def _made(
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
    return _made(
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
    return _made(search, name, "matrix_equal", {"left": left, "right": right}, evidence)


@dataclass(frozen=True)
class Square:
    """weight F' D F; `middle`: what D is known by; `left_inverse`: for a strict order, L_k."""

    factor: Expression
    middle: Any
    weight: Expression | None = None
    left_inverse: Expression | None = None


def prove_order(
    name: str,
    search: Search,
    larger: Expression,
    smaller: Expression,
    squares: Sequence[Square],
    strict: bool = False,
) -> Statement:
    """larger >= smaller or, where left inverses of the squares' factors show it, >."""
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
            inverses.append([number, inverse.data()])
            unit = unit - inverse @ factor
    evidence: dict[str, Any] = {"squares": listed, "cofactors": search.vanishing(rest, name)}
    if strict:
        evidence["rank"] = {
            "left_inverses": inverses,
            "cofactors": search.vanishing(unit, name),
        }
    claim = {"larger": larger, "smaller": smaller, "relation": ">" if strict else ">="}
    return _made(search, name, "matrix_order", claim, evidence)


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
    return _made(search, name, "matrix_invertible", {"matrix": matrix}, evidence)


def prove_traces_equal(
    name: str,
    search: Search,
    left: Expression,
    right: Expression,
    used: Sequence[tuple[Expression, Any, Expression]],
) -> Statement:
    """tr left = tr right; `used`: left factor, equation (a hypothesis or statement), right factor
    of each product that is taken away.
    """
    entries = []
    for before, source, after in used:
        one, other = search.setting.expand(before), search.setting.expand(after)
        assert one.shape is not None
        cofactor = {
            "source": search.marked(source),
            "left": one.data(),
            "right": other.data(),
        }
        entries.append({"size": one.shape[0], "cofactors": [cofactor]})
    evidence = {"used": entries}
    return _made(search, name, "matrix_trace", {"left": left, "right": right}, evidence)
