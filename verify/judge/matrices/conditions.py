"""Hypotheses that a claim may lack, from a short list."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.verify.judge.matrices.instance import Instance, NoValueError
from gainproof.verify.judge.matrices.letter import UNIT, MatrixSetting
from gainproof.verify.judge.matrices.opened import inverted
from gainproof.verify.judge.matrices.prove import Question
from gainproof.verify.judge.matrices.tree import Chain, Node

MOST_CONDITIONS = 12


def possible_conditions(
    question: Question, setting: MatrixSetting, instance: Instance, missing: bool
) -> Iterator[tuple[str, Question]]:
    """Each condition in words, and the question with it: that what is inverted has an inverse;
    else that one matrix that stands in the claim is symmetric, positive definite, has an inverse.
    """
    if missing:
        singular = _singular(question, setting, instance)
        said = " and ".join(f"{shown(node)} has an inverse" for node in singular)
        yield said, replace(question, invertible=(*question.invertible, *singular))
        return
    count = 0
    for name in _names(question):
        rows, columns = setting.letters[name].shape
        if rows != columns or setting.letters[name].variance is not None:
            continue
        node = Node("name", name=name)
        zero = Node("zero", shape=(rows, columns))
        symmetric = Chain((node, Node("transpose", (node,))), ("=",))
        definite = Chain((node, zero), (">",))
        for said, chain in ((f"{name} is symmetric", symmetric), (f"{name} > 0", definite)):
            if chain in question.chains:
                continue
            count += 1
            if count <= MOST_CONDITIONS:
                yield said, replace(question, given=(*question.given, chain))


def _names(question: Question) -> list[str]:
    sides = [side for chain in question.chains for side in chain.sides]
    nodes = [part for side in (*sides, *question.existing) for part in side.walk()]
    return list(dict.fromkeys(node.name for node in nodes if node.kind == "name"))


def _singular(question: Question, setting: MatrixSetting, instance: Instance) -> list[Node]:
    """What is inverted in the claim, or in a definition that it uses, and has no inverse there."""
    sides = [side for chain in question.chains for side in chain.sides]
    found = list[Node]()
    for node in inverted(sides, setting):
        try:
            if instance.of(node).det() == 0:
                found.append(node)
        except NoValueError:
            continue
    return found


def shown(node: Node) -> str:
    """A formula as text."""
    inner = [shown(part) for part in node.parts]
    match node.kind:
        case "name":
            return node.name.partition(UNIT)[0]
        case "number":
            return str(node.number)
        case "unit":
            return f"I_{{{node.shape[0] if node.shape else ''}}}"
        case "zero":
            return "0"
        case "sum":
            return " + ".join(inner).replace("+ -", "- ")
        case "product":
            parts = zip(node.parts, inner, strict=True)
            return " ".join(f"({t})" if p.kind in ("sum", "negative") else t for p, t in parts)
        case "negative":
            return f"-({inner[0]})" if node.parts[0].kind == "sum" else f"-{inner[0]}"
        case "transpose" | "inverse":
            power = "^T" if node.kind == "transpose" else "^{-1}"
            return (inner[0] if node.parts[0].kind in ("name", "unit") else f"({inner[0]})") + power
        case "matrix":
            width = node.size[1]
            rows = [" & ".join(inner[i : i + width]) for i in range(0, len(inner), width)]
            return "\\begin{pmatrix} " + " \\\\ ".join(rows) + " \\end{pmatrix}"
        case _:
            return f"E[{inner[0]}]"
