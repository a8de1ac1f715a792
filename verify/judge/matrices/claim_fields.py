"""Claims of a setting of matrices, from the fields of a claim file."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.kinds.kind import Kind
from gainproof.verify.judge.matrices.letters import MatrixClaim, MatrixSetting
from gainproof.verify.judge.matrices.reader import read_matrix, read_statement
from gainproof.verify.judge.matrices.shapes import ShapeFault, Shapes
from gainproof.verify.judge.matrices.size import Shape
from gainproof.verify.judge.matrices.size_text import read_size
from gainproof.verify.judge.matrices.tree import REGULAR, Chain, Node, Statement
from gainproof.verify.judge.reader.errors import ReaderError

FIELDS = ("shape", "invertible", "using", "hint")
"""Fields that only claims of these settings take."""
OF_MATRICES = (
    Kind(
        "dimension",
        "the matrix has this `shape`; this kind and the next three are for settings of kind "
        "`matrices` only",
        settings="matrices",
        repaired=False,
    ),
    Kind(
        "invertible",
        "the matrix of the formula, one expression, has an inverse",
        settings="matrices",
        repaired=False,
    ),
    Kind("unbiased", "the mean in the equation is what it says", settings="matrices"),
    Kind("covariance", "the mean of squares in the equation is what it says", settings="matrices"),
)
"""Kinds of claims that only these settings have; `decide` decides them, and the others."""
MOST_GIVEN = 12
MOST_USING = 12


def read_matrix_claim(
    fields: Fields,
    identifier: str,
    kind: Kind,
    latex: str,
    setting: MatrixSetting,
    earlier: Mapping[str, MatrixClaim],
) -> MatrixClaim | None:
    """What the claim says; None for a remark. `earlier`: those of the same setting."""
    if kind.settings == "numbers":
        raise fields.fail("kind", "a setting of matrices has no claims of this kind")
    if kind.name == "remark":
        return None
    statement = _statement(fields, "latex", latex, setting)
    _check(fields, kind.name, statement)
    using = fields.texts("using", MOST_USING)
    for name in using:
        if name not in earlier:
            raise fields.fail("using", f"{name[:80]!r} is no earlier claim of this setting")
    return MatrixClaim(
        id=identifier,
        kind=kind.name,
        statement=statement,
        shape=_shape(fields, kind.name, setting),
        given=tuple(_given(fields, t, setting) for t in fields.texts("given", MOST_GIVEN)),
        invertible=_matrices(fields, "invertible", setting),
        hints=_matrices(fields, "hint", setting),
        premises=tuple(earlier[name] for name in using),
    )


def _statement(fields: Fields, field: str, text: str, setting: MatrixSetting) -> Statement:
    try:
        return read_statement(text, setting.letters, setting.sizes)
    except ReaderError as error:
        where = f"{fields.where}.{field}"
        raise fields.text.formula_error(where, text, error, fields.line) from error


def _matrices(fields: Fields, field: str, setting: MatrixSetting) -> tuple[Node, ...]:
    """Their shapes are looked at: of a slip here the claim is not to be blamed."""
    found = list[Node]()
    for text in fields.texts(field, MOST_GIVEN):
        try:
            node = read_matrix(text, setting.letters, setting.sizes)
        except ReaderError as error:
            where = f"{fields.where}.{field}"
            raise fields.text.formula_error(where, text, error, fields.line) from error
        shapes = Shapes(setting.letters, setting.sizes)
        try:
            shapes.chain(Chain((node,), (REGULAR,))) if field == "invertible" else shapes.of(node)
        except ShapeFault as fault:
            raise fields.fail(field, f"{text[:80]!r}: {fault}") from fault
        found.append(node)
    return tuple(found)


def _given(fields: Fields, text: str, setting: MatrixSetting) -> Statement:
    found = _statement(fields, "given", text, setting)
    if found.connective or any(not chain.operators for chain in found.chains):
        raise fields.fail("given", f"relations are wanted: {text[:80]!r}")
    try:
        for chain in found.chains:
            Shapes(setting.letters, setting.sizes).chain(chain)
    except ShapeFault as fault:
        if not found.bounds:
            raise fields.fail("given", f"{text[:80]!r}: {fault}") from fault
    return found


def _shape(fields: Fields, kind: str, setting: MatrixSetting) -> Shape | None:
    texts = fields.texts("shape", 2)
    if not texts and kind != "dimension":
        return None
    if len(texts) != 2:
        raise fields.fail("shape", 'rows and columns are wanted, such as ["2n", "6+n"]')
    try:
        return read_size(texts[0], setting.sizes), read_size(texts[1], setting.sizes)
    except ReaderError as error:
        raise fields.fail("shape", error.problem) from error


def _check(fields: Fields, kind: str, statement: Statement) -> None:
    chains = (*statement.chains, *statement.after)
    operators = {operator for chain in chains for operator in chain.operators}
    alone = all(not chain.operators for chain in chains)
    if kind in ("dimension", "invertible"):
        if not alone or statement.connective or len(chains) > 1:
            raise fields.fail("latex", f"a claim of kind {kind} is one expression")
        return
    arrows = {"implication": "=>", "equivalence": "<=>"}
    if arrows.get(kind, "") != statement.connective:
        raise fields.fail("latex", f"a claim of kind {kind} has another form")
    if any(not chain.operators for chain in chains):
        raise fields.fail("latex", "a relation is wanted")
    if kind in ("identity", "definition", "unbiased", "covariance") and operators != {"="}:
        raise fields.fail("latex", f"a claim of kind {kind} is an equation")
    if kind == "inequality" and operators == {"="}:
        raise fields.fail("latex", "a claim of kind inequality has an order in it")
    has_mean = any(
        part.kind == "expectation" for chain in chains for s in chain.sides for part in s.walk()
    )
    if kind in ("unbiased", "covariance") and not has_mean:
        raise fields.fail("latex", f"a claim of kind {kind} has a mean E[...] in it")
