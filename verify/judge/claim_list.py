"""The claims of a claim file, in the order of the source."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.verify.judge.claim_errors import FileText
from gainproof.verify.judge.claim_fields import Fields, nearest_hint
from gainproof.verify.judge.claim_record import CLAIM_KINDS, Claim, Setting
from gainproof.verify.judge.formula import Formula, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_conditions, read_formula

MOST_CLAIMS = 2000
MOST_GIVEN = 20
MOST_ABOUT = 20
MOST_IDENTIFIER = 80
WITHOUT_FORMULA = frozenset(("determines", "remark"))
"""Kinds of claims that the source makes in words."""

_OPERATORS = {
    "identity": frozenset(("=",)),
    "definition": frozenset(("=",)),
    "recursion": frozenset(("=",)),
    "inequality": frozenset(("<", "<=", ">", ">=", "!=")),
    "limit": frozenset(("->", "=")),
}


def read_claims(
    text: FileText, table: object, settings: Mapping[str, Setting]
) -> tuple[Claim, ...]:
    """All claims; `table` is what TOML made of `[[claims]]`."""
    if not isinstance(table, Sequence) or isinstance(table, str) or not table:
        raise text.error("claims", "at least one table [[claims]] is wanted")
    if len(table) > MOST_CLAIMS:
        raise text.error("claims", f"{len(table)} claims, but at most {MOST_CLAIMS} are read")
    claims: list[Claim] = []
    lines: dict[str, int] = {}
    start = 1
    for number, content in enumerate(table, start=1):
        identifier = _identifier(text, number, content)
        line = text.line_of_identifier(identifier, start) or start
        if identifier in lines:
            problem = f"this id is already that of the claim of line {lines[identifier]}"
            raise text.error(f"claims.{identifier}.id", problem, line)
        lines[identifier] = line
        start = line + 1
        claims.append(_claim(Fields(text, f"claims.{identifier}", content, line), settings))
    return tuple(claims)


def _identifier(text: FileText, number: int, content: object) -> str:
    fields = Fields(text, f"claims number {number}", content)
    identifier = fields.required_text("id")
    allowed = identifier.isascii() and all(c.isalnum() or c in "-_.()" for c in identifier)
    if not allowed or len(identifier) > MOST_IDENTIFIER:
        problem = f"letters, digits, - _ . ( ) are wanted, at most {MOST_IDENTIFIER}"
        raise fields.fail("id", problem)
    return identifier


def _claim(fields: Fields, settings: Mapping[str, Setting]) -> Claim:
    identifier = fields.required_text("id")
    kind = fields.choice("kind", CLAIM_KINDS)
    setting = _setting(fields, settings)
    latex = fields.text_or_none("latex")
    words = fields.text_or_none("text")
    if latex is None and kind not in WITHOUT_FORMULA:
        raise fields.fail("latex", f"this field is missing: a claim of kind {kind} is a formula")
    if latex is None and words is None:
        raise fields.fail("text", "this field is missing: a claim in words is paraphrased here")
    domain_text = fields.text_or_none("domain")
    claim = Claim(
        id=identifier,
        place=fields.required_text("place"),
        kind=kind,
        setting=setting.name,
        latex=latex or "",
        formula=_formula(fields, "latex", latex, setting) if latex else None,
        domain=_domain(fields, domain_text, setting),
        domain_text=domain_text,
        given=_given(fields, setting),
        about=_about(fields, kind, setting),
        text=words,
        note=fields.text_or_none("note"),
        line=fields.line or 1,
    )
    fields.finish()
    _check_kind(fields, claim)
    return claim


def _setting(fields: Fields, settings: Mapping[str, Setting]) -> Setting:
    name = fields.required_text("setting")
    if name not in settings:
        hint = nearest_hint(name, list(settings))
        raise fields.fail("setting", f"there is no setting {name[:80]!r}{hint}")
    return settings[name]


def _formula(fields: Fields, field: str, latex: str, setting: Setting) -> Formula:
    try:
        return read_formula(latex, setting.symbols)
    except ReaderError as error:
        where = f"{fields.where}.{field}"
        raise fields.text.formula_error(where, latex, error, fields.line) from error


def _domain(fields: Fields, domain: str | None, setting: Setting) -> tuple[Relation, ...]:
    if domain is None:
        return ()
    try:
        return read_conditions(domain, setting.symbols)
    except ReaderError as error:
        where = f"{fields.where}.domain"
        raise fields.text.formula_error(where, domain, error, fields.line) from error


def _given(fields: Fields, setting: Setting) -> tuple[Formula, ...]:
    return tuple(
        _formula(fields, "given", latex, setting) for latex in fields.texts("given", MOST_GIVEN)
    )


def _about(fields: Fields, kind: str, setting: Setting) -> tuple[str, ...]:
    names: list[str] = []
    for token in fields.texts("about", MOST_ABOUT):
        try:
            name = canonical_token(token)
        except ReaderError as error:
            raise fields.fail("about", f"not a symbol: {error.problem}") from error
        if name not in setting.symbols:
            hint = nearest_hint(name, list(setting.symbols))
            raise fields.fail("about", f"the symbol {name} is not declared{hint}")
        names.append(name)
    if kind == "determines" and len(set(names)) < 2:
        raise fields.fail("about", "two symbols or more are wanted, each of which fixes the rest")
    if kind != "determines" and names:
        raise fields.fail("about", f"a claim of kind {kind} does not take this field")
    return tuple(names)


def _check_kind(fields: Fields, claim: Claim) -> None:
    """The relations of the formula must be such as the kind speaks of."""
    if claim.formula is None:
        return
    reading = claim.formula.readings[0]
    for relation in reading.relations:
        wanted = _OPERATORS.get(claim.kind)
        if wanted is not None and relation.operator not in wanted:
            problem = f"a claim of kind {claim.kind} has no relation {relation.operator}"
            raise fields.fail("latex", problem)
    arrows = [relation for relation in reading.conditions if relation.operator == "->"]
    if claim.kind == "limit" and len(arrows) != 1:
        raise fields.fail("latex", "a limit says once where to, such as (k \\to \\infty)")
    if claim.kind in ("implication", "equivalence") and not reading.conditions:
        raise fields.fail("latex", f"a claim of kind {claim.kind} has two parts")
