"""A proof that stands alone: a setting and statements, each resting on those before it."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.decision import prove
from gainproof.verify.certificate.matrix_words.written_setting import read_setting
from gainproof.verify.certificate.plain_data import Plain, plain
from gainproof.verify.certificate.rejection import MalformedError, Meter, RejectedError

FIELDS = ("id", "kind", "claim", "evidence")


@dataclass(frozen=True)
class _Statement:
    id: str
    kind: str
    claim: Plain
    evidence: Plain


def rejected(proof: object) -> str | None:
    """Why a statement of {"setting", "statements"} is not accepted; None if all are, of which there
    has to be one. A statement is {"id", "kind", "claim", "evidence"}. What stands under "asked" is
    text for others and not read. Never raises.
    """
    try:
        if isinstance(proof, dict):
            proof = {name: part for name, part in proof.items() if name != "asked"}
        fields = schema.record(plain(proof), ("setting", "statements"), "proof")
        setting = read_setting(fields["setting"], Meter(), "setting")
        statements = [_read(entry) for entry in schema.items(fields["statements"], "statements")]
        if not statements:
            return "nothing is stated"
        if len({statement.id for statement in statements}) < len(statements):
            return "two statements have one id"
        for number, statement in enumerate(statements):
            prove(setting, statement, statements[:number])
    except RejectedError as rejection:
        return str(rejection)
    except (LookupError, TypeError, ValueError, AttributeError) as error:
        return f"malformed: {type(error).__name__}"
    return None


def _read(value: Plain) -> _Statement:
    entries = schema.record(value, FIELDS, "statement")
    kind = entries["kind"]
    if not isinstance(kind, str):
        raise MalformedError("statement.kind: text is wanted")
    return _Statement(
        schema.text(entries["id"], "statement.id"), kind, entries["claim"], entries["evidence"]
    )
