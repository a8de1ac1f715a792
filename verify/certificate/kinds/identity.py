"""Identities and signs: equal, positive, same_sign."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.graph import Graph, Symbol
from gainproof.verify.certificate.matrix import Matrix
from gainproof.verify.certificate.rejection import MAXIMUM_VARIABLES, RejectedError


def equal(case: Case) -> str:
    """left = right at every point of the tower; with free symbols, as rational functions of them.

    Claim: left, right (graphs, numbers or matrices of one shape), free (names).
    Evidence: nonzero.
    """
    claim = case.claims("left", "right", "free")
    evidence = case.evidences("nonzero")
    left = case.expression(claim["left"], "left")
    right = case.expression(claim["right"], "right")
    place = f"{case.place}.claim.free"
    free = tuple(schema.name(entry, place) for entry in schema.items(claim["free"], place))
    if len(free) > MAXIMUM_VARIABLES:
        raise RejectedError(f"{place}: more than {MAXIMUM_VARIABLES} free symbols")
    schema.unused(set(free) - _symbols(left) - _symbols(right), "free symbols", place)
    case = case.with_tower(case.tower.with_free(free))
    nonzero = case.nonzero(evidence["nonzero"])
    evaluation = case.evaluation(nonzero)
    first, second = evaluation.value(left), evaluation.value(right)
    if isinstance(first, Matrix) and isinstance(second, Matrix):
        if first.shape != second.shape:
            raise RejectedError(f"matrices of shapes {first.shape} and {second.shape} compared")
        pairs = list(zip(first.entries(), second.entries(), strict=True))
    elif isinstance(first, Matrix) or isinstance(second, Matrix):
        raise RejectedError("a matrix compared with a number")
    else:
        pairs = [(first, second)]
    for number, (one, other) in enumerate(pairs):
        if not one.equals(other):
            where = f" (entry {number + 1})" if len(pairs) > 1 else ""
            raise RejectedError(f"left and right are not shown equal{where}")
    case.finish(nonzero)
    return "proved"


def positive(case: Case) -> str:
    """The expression is positive at every point of the tower.

    Claim: expression. Evidence: value (a manifestly positive fraction equal to it), nonzero.
    """
    claim = case.claims("expression")
    evidence = case.evidences("value", "nonzero")
    nonzero = case.nonzero(evidence["nonzero"])
    value = case.fraction(evidence["value"], "value").positive(case.tower.field)
    expression = case.expression(claim["expression"], "expression")
    if not case.evaluation(nonzero).scalar(expression).equals(value):
        raise RejectedError("the expression does not equal the manifestly positive value")
    case.finish(nonzero)
    return "proved"


def same_sign(case: Case) -> str:
    """left and right have the same sign (positive, zero, negative) at every point of the tower.

    Claim: left, right. Evidence: factor (manifestly positive, left = factor * right), nonzero.
    """
    claim = case.claims("left", "right")
    evidence = case.evidences("factor", "nonzero")
    nonzero = case.nonzero(evidence["nonzero"])
    factor = case.fraction(evidence["factor"], "factor").positive(case.tower.field)
    evaluation = case.evaluation(nonzero)
    left = evaluation.scalar(case.expression(claim["left"], "left"))
    right = evaluation.scalar(case.expression(claim["right"], "right"))
    if not left.equals(factor * right):
        raise RejectedError("left does not equal the factor times right")
    if left.is_zero():
        raise RejectedError("both sides vanish everywhere: any factor would do")
    case.finish(nonzero)
    return "proved"


def _symbols(graph: Graph) -> set[str]:
    return {node.name for node in graph.nodes if isinstance(node, Symbol)}
