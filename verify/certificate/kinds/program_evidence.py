"""Claim and evidence of kernels as they are read: inputs, nodes, fractions, branches."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.case import Case, Program
from gainproof.verify.certificate.expression import Evaluation
from gainproof.verify.certificate.graph import Call, Graph, read_expression
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.ratio import Ratio
from gainproof.verify.certificate.rejection import MalformedError, RejectedError
from gainproof.verify.certificate.tower import Tower
from gainproof.verify.certificate.written import WrittenFraction

CHOICES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {"select": ("then", "else"), "abs": ("positive", "negative")}
)
"""The branches of functions that have some."""


def input_values(
    tower: Tower,
    evaluation: Evaluation,
    kernel: Program,
) -> dict[str, Ratio]:
    """The values of a program's symbols."""
    return {
        name: tower.value(meaning) if isinstance(meaning, str) else evaluation.scalar(meaning)
        for name, meaning in kernel.inputs.items()
    }


def nodes_claimed(
    case: Case, evaluation: Evaluation, claim: Mapping[str, Plain]
) -> dict[int, Ratio]:
    """What nodes are claimed to equal, as values; none if there is no such field."""
    if "nodes" not in claim:
        return {}
    place = f"{case.place}.claim.nodes"
    found = {
        schema.index(key, place): evaluation.scalar(read_expression(entry, f"{place}.{key}"))
        for key, entry in schema.table(claim["nodes"], place).items()
    }
    if not found:
        raise MalformedError(f"{place}: some are claimed or the field is left out")
    return found


def fractions(case: Case, value: Plain, field: str) -> dict[int, WrittenFraction]:
    """The fractions given for nodes."""
    place = f"{case.place}.evidence.{field}"
    return {
        schema.index(key, place): case.fraction(entry, f"{field}.{key}")
        for key, entry in schema.table(value, place).items()
    }


def branches_taken(case: Case, value: Plain, graph: Graph) -> dict[int, str]:
    """The branches taken at nodes that have some."""
    place = f"{case.place}.evidence.branches"
    chosen: dict[int, str] = {}
    for key, choice in schema.table(value, place).items():
        index = schema.index(key, place)
        node = graph.nodes[index] if index < len(graph.nodes) else None
        if not isinstance(node, Call) or node.function not in CHOICES:
            raise RejectedError(f"{place}: node {key} has no branches")
        if not isinstance(choice, str) or choice not in CHOICES[node.function]:
            raise RejectedError(f"{place}.{key}: one of {CHOICES[node.function]} is wanted")
        chosen[index] = choice
    return chosen
