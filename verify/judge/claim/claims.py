"""The claims of a claim file, in the order of the source."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from gainproof.verify.judge.claim.empty_domains import contradiction, relations_of
from gainproof.verify.judge.claim.errors import FileText
from gainproof.verify.judge.claim.fields import Fields, nearest_hint
from gainproof.verify.judge.claim.formulas import (
    Symbols,
    conditions_of,
    formula_of,
    plain_formula_of,
    token_in,
)
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim.settings import ReadSetting
from gainproof.verify.judge.claim.usual_meanings import ORIGINS, clash, means, whole_claims
from gainproof.verify.judge.claim_symbols import used
from gainproof.verify.judge.dimensions.declarations import domain_fault
from gainproof.verify.judge.formula import Formula, Reading
from gainproof.verify.judge.kinds.catalogue import KINDS, kind_named, kind_of
from gainproof.verify.judge.kinds.kind import OwnFields
from gainproof.verify.judge.matrices import claim_fields
from gainproof.verify.judge.matrices.letters import MatrixClaim
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.words import BRANCHES

MOST_CLAIMS = 2000
MOST_GIVEN = 20
MOST_IDENTIFIER = 80
UNDECIDABLE = "remark"
KIND_FIELDS = tuple(dict.fromkeys(name for kind in KINDS for name in kind.own))
"""Fields that only claims of one kind, or two, take."""
FOR_READERS = ("quoted", "origin")
FIELDS = (
    "id",
    "place",
    "kind",
    "setting",
    "latex",
    "plain",
    "branch",
    "text",
    "domain",
    "given",
    "held",
    *FOR_READERS,
    "note",
    *claim_fields.FIELDS,
    *KIND_FIELDS,
)
"""Fields of a claim."""


def read_claims(
    text: FileText, table: object, settings: Mapping[str, ReadSetting | None]
) -> tuple[tuple[Claim, ...], tuple[str, ...]]:
    """All claims that can be judged, and the ids of the others, with the line of one whose id is
    that of another claim, or `number 3` for one without; `table` is what TOML made of
    `[[claims]]`. Errors are noted.
    """
    if not isinstance(table, Sequence) or isinstance(table, str) or not table:
        raise text.error("claims", "at least one table [[claims]] is wanted")
    if len(table) > MOST_CLAIMS:
        raise text.error("claims", f"{len(table)} claims, but at most {MOST_CLAIMS} are read")
    if any(isinstance(one, str) for one in table) and len(settings) != 1:
        raise text.error("claims", "formulas alone are claims of one setting: say of which each is")
    places = _places(text, table)
    kinds = {name: one.setting.kind if one else "" for name, one in settings.items()}
    alone = {number for number, one in enumerate(table, start=1) if isinstance(one, str)}
    table = whole_claims(table, kinds)
    reading = {name: one.setting if one else None for name, one in settings.items()}
    judging = {name: one.judged if one else None for name, one in settings.items()}
    claims: list[Claim] = []
    unread: list[str] = []
    lines: dict[str, int] = {}
    meant: dict[str, dict[str, tuple[str, str]]] = {name: {} for name in settings}
    start = 1
    for number, content in enumerate(table, start=1):
        identifier = text.attempt(partial(_identifier, text, number, content), "")
        line = places.get(number) or text.line_of_identifier(identifier, start) or start
        if not identifier:
            unread.append(f"number {number}")
            continue
        if identifier in lines:
            problem = f"this id is already that of the claim of line {lines[identifier]}"
            text.note(text.error(f"claims.{identifier}.id", problem, line))
            unread.append(f"{identifier} (line {line})")
            start = line + 1
            continue
        lines[identifier] = line
        start = line + (number not in alone)
        claim = _read(text, content, identifier, line, reading, judging, claims, unread)
        read = settings.get(claim.setting) if claim else None
        if claim is not None and read is not None and read.usual:
            claim = text.attempt(partial(_unmixed, text, claim, read, meant[claim.setting]), None)
        if claim is None:
            unread.append(identifier)
        else:
            claims.append(claim)
    return tuple(claims), tuple(unread)


def _places(text: FileText, table: Sequence[object]) -> dict[int, int]:
    """The lines of claims that are formulas alone, by number."""
    found: dict[int, int] = {}
    line = text.line_of_key("claims") or 1
    for number, one in enumerate(table, start=1):
        place = text.place_of(one, line) if isinstance(one, str) else None
        if place is None and isinstance(one, str):
            break  # nor are the others looked for, each in all that is looked through
        if place is not None:
            found[number] = line = place[0]
    return found


def _unmixed(
    text: FileText, claim: Claim, read: ReadSetting, meant: dict[str, tuple[str, str]]
) -> Claim:
    """The claim, none of whose usual letters means what another symbol of the setting does; `meant`
    are those of the claims before, by meaning, each with the id of its claim. Raises
    ClaimFileError.
    """
    tokens = sorted(used(claim, read.setting).intersection(read.setting.symbols))
    before = {meaning: token for meaning, (token, _) in meant.items()}
    pair = clash(tokens, before, read.usual, read.setting)
    if pair is not None:
        one, other = pair
        meaning = means(read.setting.symbols[one])
        where = f" of claim {meant[meaning][1]}" if meaning in meant else ""
        entry = read.setting.symbols[one if one in read.usual else other]
        problem = (
            f"{one} and {other}{where} would both be the {entry.meaning}: declare what one of "
            "them is"
        )
        raise text.error(f"claims.{claim.id}", problem, claim.line)
    for token in tokens:
        if meaning := means(read.setting.symbols[token]):
            meant.setdefault(meaning, (token, claim.id))
    return claim


def _read(
    text: FileText,
    content: Mapping[str, object],
    identifier: str,
    line: int,
    reading: Mapping[str, Setting | None],
    judging: Mapping[str, Setting | None],
    before: Sequence[Claim],
    unread: Sequence[str],
) -> Claim | None:
    """One claim as it can be judged: read with all symbols of its setting first, so that its own
    errors are noted, then in the setting of those without errors. None for one with errors, or that
    rests on a symbol, setting or claim with some.
    """
    noted, name, using = text.noted, content.get("setting"), content.get("using")
    fields = Fields(text, f"claims.{identifier}", content, FIELDS, line)
    if isinstance(name, str) and name in reading and reading[name] is None:
        return None
    if isinstance(using, list) and any(other in unread for other in using):
        return None
    claim = text.attempt(partial(_claim, fields, reading, before), None)
    if claim is None or text.noted > noted:
        return None
    setting = judging[claim.setting]
    if setting is not reading[claim.setting]:
        claim = text.unsaid(partial(_claim, fields, judging, before))
    if setting is None or claim is None or claim.matrices is not None:
        return claim
    return text.attempt(partial(_checked, fields, claim, setting), None)


def _checked(fields: Fields, claim: Claim, setting: Setting) -> Claim:
    """The claim, whose domain is not empty and agrees in dimension."""
    _check_domain(fields, claim, setting)
    fault = domain_fault(claim, setting)
    if fault is not None:
        raise fields.fail("domain", f"dimensions: {fault}")
    return claim


def _identifier(text: FileText, number: int, content: object) -> str:
    # with an id, the other fields are checked where the id can name the claim
    known = (*content,) if isinstance(content, Mapping) and "id" in content else FIELDS
    fields = Fields(text, f"claims number {number}", content, known)
    identifier = fields.required_text("id")
    allowed = identifier.isascii() and all(c.isalnum() or c in "-_.()" for c in identifier)
    if not allowed or len(identifier) > MOST_IDENTIFIER:
        problem = f"letters, digits, - _ . ( ) are wanted, at most {MOST_IDENTIFIER}"
        raise fields.fail("id", problem)
    return identifier


def _claim(
    fields: Fields, settings: Mapping[str, Setting | None], before: Sequence[Claim]
) -> Claim:
    """The claim as its fields say it. Errors that leave others to be found are noted."""
    text = fields.text
    identifier = fields.required_text("id")
    written = fields.has("kind") and fields.take("kind") is None
    usual = "identity" if written else None
    names = tuple(kind.name for kind in KINDS)
    kind = text.attempt(lambda: fields.choice("kind", names, usual), UNDECIDABLE)
    place = text.attempt(lambda: fields.required_text("place"), "")
    setting = _setting(fields, settings)
    if setting.matrices is not None:
        return _of_matrices(fields, identifier, kind, place, setting, before)
    for name in claim_fields.FIELDS:
        if fields.has(name):
            raise fields.fail(name, f"claims of a setting of kind {setting.kind} do not take this")
    if kind_named(kind).settings == "matrices":
        raise fields.fail("kind", f"only settings of kind matrices have claims of kind {kind}")
    symbols, noted = setting.symbols, text.noted
    domain = fields.text_or_none("domain")
    _for_readers(fields)
    words = fields.text_or_none("text")
    none: tuple[str, str | None, Formula | None] = ("", None, None)
    latex, plain, formula = text.attempt(lambda: _formula(fields, kind, setting), none)
    kind = kind_of(formula) if written and formula is not None else kind
    needs_words = kind_named(kind).needs_text and text.noted == noted
    if formula is None and words is None and needs_words:
        raise fields.fail("text", "this field is missing: a claim in words is paraphrased here")
    claim = Claim(
        id=identifier,
        place=place,
        kind=kind,
        setting=setting.name,
        latex=latex,
        plain=plain,
        formula=formula,
        domain=text.attempt(lambda: conditions_of(fields, "domain", domain, symbols), ()),
        given=text.attempt(
            lambda: tuple(
                formula_of(fields, "given", given, symbols)
                for given in fields.texts("given", MOST_GIVEN)
            ),
            (),
        ),
        held=text.attempt(
            lambda: tuple(
                token_in(fields, "held", token, symbols)
                for token in fields.texts("held", MOST_GIVEN)
            ),
            (),
        ),
        text=words,
        note=fields.text_or_none("note"),
        line=fields.line or 1,
    )
    return claim if text.noted > noted else _with_own_fields(claim, fields, symbols)


def _with_own_fields(claim: Claim, fields: Fields, symbols: Symbols) -> Claim:
    """The claim with the fields of its kind, whose relations are such as the kind speaks of. Raises
    ClaimFileError.
    """
    kind = kind_named(claim.kind)
    for name in KIND_FIELDS:
        if fields.has(name) and name not in kind.own:
            raise fields.fail(name, f"a claim of kind {kind.name} does not take this field")
    table = OwnFields(fields, symbols, claim.formula is not None)
    read = {name: reading(table, name) for name, reading in kind.own.items()}
    if claim.formula is not None:
        _check_formula(fields, claim, claim.formula.readings[0])
    return replace(claim, own={name: own for name, own in read.items() if own is not None})


def _check_formula(fields: Fields, claim: Claim, reading: Reading) -> None:
    field = "latex" if claim.plain is None else "plain"
    kind = kind_named(claim.kind)
    for operator in (relation.operator for relation in reading.relations):
        if kind.operators is not None and operator not in kind.operators:
            having = [k for k in KINDS if k.operators and operator in k.operators]
            # those first that want no other field than this one has
            others = [k.name for k in sorted(having, key=lambda k: bool(k.own))]
            more = f"; kinds that have it: {', '.join(others)}" if others else ""
            problem = f"a claim of kind {kind.name} has no relation {operator}{more}"
            raise fields.fail(field, problem)
    lacking = kind.two_parts and not reading.conditions
    if wrong := "has two parts" if lacking else kind.form(reading):
        raise fields.fail(field, f"a claim of kind {kind.name} {wrong}")


def _for_readers(fields: Fields) -> None:
    """Fields that no verdict depends on; only their form is checked."""
    fields.text_or_none("quoted")
    if fields.has("origin"):
        fields.choice("origin", ORIGINS)


def _of_matrices(
    fields: Fields,
    identifier: str,
    kind: str,
    place: str,
    setting: Setting,
    before: Sequence[Claim],
) -> Claim:
    """A claim of a setting of matrices, which has a reader of its own."""
    letters = setting.matrices
    assert letters is not None
    allowed = ("id", "place", "kind", "setting", "latex", "text", "given", *FOR_READERS, "note")
    for field in fields.given():
        if field not in (*allowed, *claim_fields.FIELDS):
            raise fields.fail(field, "claims of a setting of matrices do not take this field")
    _for_readers(fields)
    is_remark = kind == "remark"
    latex = (fields.text_or_none("latex") or "") if is_remark else fields.required_text("latex")
    words = fields.required_text("text") if is_remark and not latex else fields.text_or_none("text")
    earlier: dict[str, MatrixClaim] = {
        claim.id: claim.matrices
        for claim in before
        if claim.setting == setting.name and claim.matrices
    }
    return Claim(
        id=identifier,
        place=place,
        kind=kind,
        setting=setting.name,
        latex=latex,
        formula=None,
        text=words,
        note=fields.text_or_none("note"),
        line=fields.line or 1,
        matrices=claim_fields.read_matrix_claim(
            fields, identifier, kind_named(kind), latex, letters, earlier
        ),
    )


def _check_domain(fields: Fields, claim: Claim, setting: Setting) -> None:
    """Domain, printed conditions and the domains of the symbols met must leave something."""
    stated = list(claim.domain)
    tokens: set[str] = set()
    if claim.formula is not None:
        reading = claim.formula.readings[0]
        stated += reading.conditions if reading.connective == "if" else ()
        tokens.update(claim.formula.symbols)
    if not stated:
        return
    tokens.update(
        node[1]
        for relation in stated
        for graph in (relation.left, relation.right)
        for node in graph["nodes"]
        if node[0] == "symbol"
    )
    fault = contradiction(
        [*relations_of(sorted(tokens), setting.symbols), *stated], setting.symbols
    )
    if fault is not None:
        field = "domain" if claim.domain else "latex" if claim.plain is None else "plain"
        raise fields.fail(field, f"the domain is empty: {fault}")


def _setting(fields: Fields, settings: Mapping[str, Setting | None]) -> Setting:
    name = fields.required_text("setting")
    setting = settings.get(name)
    if setting is None:
        hint = nearest_hint(name, list(settings))
        raise fields.fail("setting", f"there is no setting {name[:80]!r}{hint}")
    return setting


def _formula(fields: Fields, kind: str, setting: Setting) -> tuple[str, str | None, Formula | None]:
    """The formula as LaTeX, as plain text if it was typed so, and as read."""
    latex, plain = fields.text_or_none("latex"), fields.text_or_none("plain")
    if latex is not None and plain is not None:
        raise fields.fail("plain", "a formula is written either as `latex` or as `plain`")
    branch = fields.text_or_none("branch")
    if branch is not None and "\\pm" not in (latex or "") and "\\mp" not in (latex or ""):
        raise fields.fail("branch", "the formula in `latex` has no \\pm and no \\mp")
    if branch not in (None, *BRANCHES):
        raise fields.fail("branch", f"{branch!r} is none of {', '.join(BRANCHES)}")
    if latex is not None:
        return latex, None, formula_of(fields, "latex", latex, setting.symbols, branch)
    if plain is not None:
        formula = plain_formula_of(fields, "plain", plain, setting.symbols)
        return reading_to_latex(formula.readings[0]), plain, formula
    if kind_named(kind).needs_formula:
        raise fields.fail("latex", f"this field is missing: a claim of kind {kind} is a formula")
    return "", None, None
