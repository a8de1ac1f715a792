"""What has to be decided of a claim about matrices: its directions, with fitted shapes."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.judge.matrices.letters import MatrixClaim
from gainproof.verify.judge.matrices.proof import Question
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.tree import REGULAR, Bound, Chain, Node


@dataclass(frozen=True)
class Case:
    """One direction of a claim, with what restricts the sizes."""

    question: Question
    bounds: tuple[Bound, ...]


def cases_of(claim: MatrixClaim, shapes: Shapes) -> list[Case]:
    """What has to be proved, with fitted shapes. Raises ShapeFault."""
    statement = claim.statement
    chains = tuple(shapes.chain(chain) for chain in statement.chains)
    after = tuple(shapes.chain(chain) for chain in statement.after)
    hypotheses = tuple(shapes.chain(c) for other in claim.given for c in other.chains)
    given = tuple(c for c in hypotheses if c.operators != (REGULAR,))
    regular = tuple(c.sides[0] for c in hypotheses if c.operators == (REGULAR,))
    inverted = (*regular, *(_square(node, shapes) for node in claim.invertible))
    hints = tuple(_filled(node, shapes) for node in claim.hints)
    premises = tuple(
        case.question for premise in claim.premises for case in cases_of(premise, shapes)
    )
    if claim.kind == "invertible":
        chains = tuple(Chain(chain.sides, (REGULAR,)) for chain in chains)
    pairs: list[tuple[tuple[Chain, ...], tuple[Chain, ...]]] = [((), chains)]
    if statement.connective:
        pairs = [(chains, after), (after, chains)]
    if statement.connective == "=>":
        pairs.pop()
    return [
        Case(
            Question(
                tuple(c for c in wanted if c.operators != (REGULAR,)),
                (*given, *(c for c in supposed if c.operators != (REGULAR,))),
                (*inverted, *(c.sides[0] for c in supposed if c.operators == (REGULAR,))),
                hints,
                tuple(c.sides[0] for c in wanted if c.operators == (REGULAR,)),
                premises,
                claim.id,
            ),
            tuple(b for other in (statement, *claim.given) for b in other.bounds),
        )
        for supposed, wanted in pairs
    ]


def _filled(node: Node, shapes: Shapes) -> Node:
    return shapes.filled(node, shapes.of(node))


def _square(node: Node, shapes: Shapes) -> Node:
    return shapes.chain(Chain((node,), (REGULAR,))).sides[0]


def wrong_shape(claim: MatrixClaim, shapes: Shapes) -> str | None:
    """Why the shape that is said is not the one that there is."""
    if claim.shape is None:
        return None
    chain = shapes.chain(claim.statement.chains[0])
    found = shapes.of(chain.sides[0])
    if found == claim.shape:
        return None
    return f"the shape is {shapes.said(found)}, not {shapes.said(claim.shape)}"
