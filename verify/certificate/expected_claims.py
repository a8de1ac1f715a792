"""What the caller expects a certificate to claim, compared with what it claims.

A certificate that is right about something else is worthless: about another family's model, on a
smaller domain, of another kernel, of other quantities under the same names: the model fixes the
steady state of one tower, and what the names mean in the others is nothing that a statement shows.
So whoever asks for a check says what is to be proved.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.document import Statement
from gainproof.verify.certificate.plain_data import Plain, difference, plain
from gainproof.verify.certificate.rejection import RejectedError


@dataclass(frozen=True, slots=True)
class Expectation:
    """Plain copies of what is expected; None where nothing is."""

    claims: tuple[dict[str, Plain], ...] | None
    model: Plain | None
    domain: dict[str, Plain] | None
    programs: Plain | None
    towers: Plain | None = None

    def of_document(self, certificate: Plain) -> str | None:
        """The first disagreement outside the statements, as a sentence."""
        fields = schema.table(certificate, "certificate")
        if self.programs is not None:
            found = difference(fields["programs"], self.programs, "programs")
            if found is not None:
                return found
        towers = schema.table(fields["towers"], "towers")
        if self.domain is not None:
            parameters: Plain = {
                name: schema.table(tower, name)["parameters"] for name, tower in towers.items()
            }
            found = difference(parameters, self.domain, "domain")
            if found is not None:
                return found
        if self.towers is not None:
            found = difference(fields["towers"], self.towers, "towers")
            if found is not None:
                return found
        statements = schema.items(fields["statements"], "statements")
        if self.claims is not None and len(self.claims) != len(statements):
            return f"{len(self.claims)} statements are expected, {len(statements)} found"
        if self.model is not None and not any(
            "model" in schema.table(schema.table(s, "statement")["claim"], "claim")
            for s in statements
        ):
            return "a model is expected, and no statement speaks about one"
        return None

    def of_statement(self, number: int, statement: Statement) -> str | None:
        """The first disagreement with one statement, as a sentence."""
        if self.claims is not None:
            wanted = self.claims[number]
            found: Plain = {
                "id": statement.id,
                "kind": statement.kind,
                "tower": statement.tower,
                "claim": statement.claim,
            }
            disagreement = difference(found, wanted, "statement")
            if disagreement is not None:
                return disagreement
        claim = statement.claim
        if self.model is not None and isinstance(claim, dict) and "model" in claim:
            return difference(claim["model"], self.model, "model")
        return None


def read_expectation(
    claims: Sequence[Mapping[str, Any]] | None,
    model: Mapping[str, Any] | None,
    domain: Mapping[str, Any] | None,
    programs: Mapping[str, Any] | None,
    towers: Mapping[str, Any] | None = None,
) -> Expectation:
    """Copy what is expected into plain data. Raises RejectedError where that is malformed."""
    return Expectation(
        None if claims is None else tuple(_claim(plain(entry)) for entry in claims),
        None if model is None else plain(model),
        None if domain is None else schema.table(plain(domain), "domain"),
        None if programs is None else plain(programs),
        None if towers is None else plain(towers),
    )


def _claim(value: Plain) -> dict[str, Plain]:
    """{"id", "kind", "claim"} and possibly "tower", which is "main" where it is not given."""
    fields = {"tower": "main", **schema.table(value, "an expected claim")}
    try:
        return schema.record(fields, ("id", "kind", "tower", "claim"), "an expected claim")
    except RejectedError as rejection:
        raise RejectedError(f"the expectation itself is malformed: {rejection}") from None
