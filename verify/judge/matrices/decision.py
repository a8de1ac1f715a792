"""Verdicts on claims about matrices of every size."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.matrices.claim_directions import Case, cases_of, wrong_shape
from gainproof.verify.judge.matrices.exact_instance import Instance, NoValueError, Unsupported
from gainproof.verify.judge.matrices.ideal_membership import Budget, UnprovedError
from gainproof.verify.judge.matrices.layered_proof import Proof, Proofs, proof_in
from gainproof.verify.judge.matrices.letters import UNIT, MatrixClaim, MatrixSetting
from gainproof.verify.judge.matrices.proof import Question
from gainproof.verify.judge.matrices.random_instances import holds, instances
from gainproof.verify.judge.matrices.shapes import ShapeFault, Shapes, UnsaidShapeError
from gainproof.verify.judge.matrices.tree import REGULAR, Chain, Node
from gainproof.verify.judge.matrices.used_definitions import inverted, is_random, within
from gainproof.verify.judge.matrices.witness import witness_of
from gainproof.verify.judge.verdict import Finding

TRIED = 3
"""Instances before a proof is looked for."""
MORE_TRIED = 60
"""Instances where no proof was found."""
METHOD = "words"
SHAPES = "the shapes of the letters give this one"
TOO_DEEP = "definitions stand too deep inside one another"
EMPTY_ONLY = (
    "no exact instance of the hypotheses was found but of matrices without entries, "
    "of which everything is true"
)
MOST_CONDITIONS = 12


def decide(claim: MatrixClaim, setting: MatrixSetting, proofs: Proofs | None = None) -> Finding:
    """The verdict; nothing is raised for what cannot be decided. `proofs` keeps those of claims
    for others that use them.
    """
    try:
        return _found(claim, setting, {} if proofs is None else proofs)
    except RecursionError:  # definitions of definitions: each formula for itself is short
        return Finding("undecided", TOO_DEEP)


def _found(claim: MatrixClaim, setting: MatrixSetting, proofs: Proofs) -> Finding:
    shapes = Shapes(setting.letters, setting.sizes)
    try:
        cases = cases_of(claim, shapes)
    except UnsaidShapeError as reason:
        return Finding("undecided", f"shapes: {reason}")
    except ShapeFault as reason:
        if any(bound for other in (claim.statement, *claim.given) for bound in other.bounds):
            return Finding("undecided", f"shapes are not read with conditions on sizes: {reason}")
        return Finding("refuted", f"shapes do not fit: {reason}", method="shapes")
    setting = shapes.with_added(setting)
    fault = wrong_shape(claim, shapes)
    if fault is not None:
        return Finding("refuted", fault, method="shapes")
    if claim.kind == "dimension":
        return Finding("proved", SHAPES, method="shapes")
    if claim.kind == "definition":
        return _definition(cases, setting, proofs)
    findings = [_decided(case, setting, proofs) for case in cases]
    return _together(findings)


def _definition(cases: list[Case], setting: MatrixSetting, proofs: Proofs) -> Finding:
    """Refuted if it is not what its letter stands for in all other claims."""
    left, *right = cases[0].question.chains[0].sides if cases[0].question.chains else (None,)
    letter = setting.letters.get(left.name) if left is not None and left.kind == "name" else None
    if letter is None or letter.definition is None:
        return Finding("definition", SHAPES, method="shapes")
    equal = f"equal to what {letter.name} stands for"
    if right == [letter.definition]:
        return Finding("definition", SHAPES, method=equal)
    found = _together([_decided(case, setting, proofs) for case in cases])
    if found.verdict in ("refuted", "conditional"):
        reason = f"not what {letter.name} stands for in this setting: {found.reason}"
        return replace(found, verdict="refuted", reason=reason)
    return Finding("definition", SHAPES, method=equal if found.verdict == "proved" else "shapes")


def _decided(case: Case, setting: MatrixSetting, proofs: Proofs) -> Finding:
    setting = within(case.question.nodes(), setting)
    if _conditions_chance(case.question, setting):
        reason = "a mean, under a hypothesis about what is random: a conditional mean is not read"
        return Finding("undecided", reason)
    found, failed = _tried(case, setting)
    if not found:
        return Finding("undecided", _why_none(case, setting))
    if failed is None:
        finding = _proved(case, setting, proofs, found)
        if finding.verdict == "proved":
            return finding
        failed = _tried(case, setting, MORE_TRIED, 2)[1]
        if failed is None:
            return finding
    instance, missing = failed
    budget = Budget()
    for said, question in possible_conditions(case.question, setting, instance, missing):
        more = replace(case, question=question)
        found, again = _tried(more, setting)
        if found and again is None:
            finding = _proved(more, setting, proofs, found, budget)
            if finding.verdict == "proved":
                reason = f"not true as stated; true where {said}"
                witness = witness_of(case.question, setting, instance)
                return replace(
                    finding, verdict="conditional", reason=reason, domain=said, witness=witness
                )
    witness = witness_of(case.question, setting, instance)
    if missing:
        reason = "an inverse in it does not always exist, and with it no proof was found"
        return Finding("undecided", reason, witness=witness)
    return Finding("refuted", "an exact counterexample", method="instance", witness=witness)


def _conditions_chance(question: Question, setting: MatrixSetting) -> bool:
    """Whether there is a mean, and a hypothesis about a random vector outside of means."""
    nodes = question.nodes()
    if not any(part.kind == "expectation" for node in nodes for part in node.walk()):
        return False
    supposed = [side for chain in question.given for side in chain.sides]
    waiting = [*supposed, *question.invertible]
    while waiting:
        node = waiting.pop()
        if node.kind == "name" and is_random(node.name, setting):
            return True
        waiting += [] if node.kind == "expectation" else node.parts
    return False


def _why_none(case: Case, setting: MatrixSetting) -> str:
    """What is not evaluated in the claim, if it is that."""
    question = case.question
    tried = instances(setting, question.given, question.invertible, case.bounds)
    for instance in itertools.islice(tried, 1):
        try:
            all(holds(chain, instance) for chain in question.chains)
        except (Unsupported, NoValueError) as reason:
            return f"not decided: {reason}"
    return "no exact instance of the hypotheses was found"


def _tried(
    case: Case, setting: MatrixSetting, most: int = TRIED, seed: int = 1
) -> tuple[list[Instance], tuple[Instance, bool] | None]:
    """Instances of the hypotheses, and the first at which the claim fails or has no value."""
    question, found = case.question, list[Instance]()
    wanted = (*question.chains, *(Chain((n,), (REGULAR,)) for n in question.existing))
    missing = None
    for instance in itertools.islice(
        instances(setting, question.given, question.invertible, case.bounds, seed), most
    ):
        found.append(instance)
        try:
            if not all(holds(chain, instance) for chain in wanted):
                return found, (instance, False)
        except NoValueError:
            missing = missing or (instance, True)
        except Unsupported:
            found.pop()
    return found, missing


def _is_met(case: Case, setting: MatrixSetting, found: Iterable[Instance]) -> bool:
    """Whether there is an instance in which every hypothesis speaks of entries: `P = 0` of a
    definite P of no rows contradicts nothing, of any other size it does. `found` are tried first.
    """
    question = case.question
    sides = [*(side for chain in question.given for side in chain.sides), *question.invertible]
    others = instances(setting, question.given, question.invertible, case.bounds)
    return not sides or any(
        all(value.nrows() and value.ncols() for value in map(instance.of, sides))
        for instance in itertools.chain(found, others)
    )


def _proved(
    case: Case,
    setting: MatrixSetting,
    proofs: Proofs,
    found: Iterable[Instance],
    budget: Budget | None = None,
) -> Finding:
    if not _is_met(case, setting, found):
        return Finding("undecided", EMPTY_ONLY)
    try:
        parts = proof_in(setting, case.question, proofs, budget).certificates
    except UnprovedError as reason:
        if case.question.hints:
            # an inverse in a hint may not exist: no verdict rests on one
            bare = replace(case, question=replace(case.question, hints=()))
            finding = _proved(bare, setting, proofs, found, budget)
            if finding.verdict == "proved":
                return finding
            return replace(finding, reason=f"{finding.reason}, with the hint or without")
        return Finding("undecided", f"true at {TRIED + MORE_TRIED} exact instances; {reason}")
    words = _each_once(parts)
    owners: dict[int, str] = {}
    for proof in proofs.values():  # those that others use come first
        if isinstance(proof, Proof):
            for part in proof.certificates:
                owners.setdefault(id(part), proof.claim)
    certificate = {"words": words, "claims": [owners[id(part)] for part in words]}
    return Finding("proved", "for every size", method=METHOD, certificate=certificate)


def _each_once(parts: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """A lemma that several steps use stands where it is used first."""
    return list({id(part): part for part in parts}.values())


def _together(findings: list[Finding]) -> Finding:
    """Both directions of an equivalence: the worse one."""
    order = ("refuted", "undecided", "conditional", "proved")
    worst = min(findings, key=lambda finding: order.index(finding.verdict))
    if worst.verdict != "proved":
        return worst
    parts = {str(n): dict(f.certificate) for n, f in enumerate(findings, start=1)}
    certificate = parts if len(findings) > 1 else findings[0].certificate
    return replace(findings[0], certificate=certificate)


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
