"""What the hypotheses of a question say, and whether it is false under them at a glance."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from gainproof.verify.judge.matrices.instance import NoValueError, Unsupported
from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.prove import Question
from gainproof.verify.judge.matrices.sample import holds, instances
from gainproof.verify.judge.matrices.shapes import Shapes
from gainproof.verify.judge.matrices.tree import Chain, Node

FEW_TRIES, FEW_INSTANCES = 9, 2
"""To see that what is left of a claim, definitions closed, is false."""


def supposes_no_more(premise: Question, question: Question) -> bool:
    """Whether all that one question supposes is supposed by the other."""
    return set(premise.given) <= set(question.given) and (
        set(premise.invertible) <= set(question.invertible)
    )


def fails(question: Question, setting: MatrixSetting) -> bool:
    """Whether a closed question is false at one of few instances: no proof is looked for then."""
    if any(part.kind == "expectation" for node in question.nodes() for part in node.walk()):
        return False  # means take longer than the proof
    tried = instances(setting, question.given, question.invertible, tries=FEW_TRIES)
    try:
        for instance in islice(tried, FEW_INSTANCES):
            if not all(holds(chain, instance) for chain in question.chains):
                return True
            if not all(instance.of(node).det() != 0 for node in question.existing):
                return True
    except (Unsupported, NoValueError):
        return False
    return False


def is_given(definite: Chain, given: Sequence[Chain]) -> bool:
    """Whether X > 0 is among the hypotheses, also as 0 < X."""
    return definite in given or Chain(definite.sides[::-1], ("<",)) in given


def positive(node: Node, setting: MatrixSetting) -> Chain:
    """The matrix is positive definite."""
    shape = Shapes(setting.letters, setting.sizes).of(node)
    return Chain((node, Node("zero", shape=shape)), (">",))
