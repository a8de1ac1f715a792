"""The campaign: every number altered, every field deleted, and each time a rejection.

A certificate that could be changed without notice would hold something on which nothing depends.
The original's own claims, towers and programs are what is expected of each altered certificate.
Only what an alteration can affect is decided again; whatever then seems accepted is confirmed by
a complete check before it is counted so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.alterations import Alteration, alterations, replaced
from gainproof.verify.certificate.checker import check
from gainproof.verify.certificate.document import (
    Document,
    Statement,
    read_document,
    read_place,
    read_programs,
    read_statement,
)
from gainproof.verify.certificate.plain_data import Plain, plain
from gainproof.verify.certificate.rejection import MalformedError, Meter, RejectedError


@dataclass(frozen=True, slots=True)
class Tally:
    """What became of the alterations of one certificate.

    ``malformed`` counts those that break the format, ``refuted`` those that leave it whole and are
    rejected by the mathematics alone, ``unexpected`` those where another true statement is left and
    only the comparison with what was expected tells; those ``accepted`` are listed.
    """

    malformed: int
    refuted: int
    unexpected: int
    accepted: tuple[Alteration, ...]

    @property
    def total(self) -> int:
        """How many alterations were tried."""
        return self.malformed + self.refuted + self.unexpected + len(self.accepted)


class Campaign:
    """Tries alterations of one accepted certificate."""

    def __init__(self, certificate: Mapping[str, Any]) -> None:
        """Raises ValueError unless the certificate is accepted as it stands."""
        self._original = plain(certificate)
        report = check(certificate)
        if not report.accepted:
            raise ValueError(f"the certificate is not accepted as it stands: {report.reason}")
        self._meter = Meter()
        self._document = read_document(self._original, self._meter)
        self._expected = _expected(self._original)

    def alterations(self) -> list[Alteration]:
        """Every alteration there is."""
        return list(alterations(self._original))

    def run(
        self,
        chosen: Iterable[Alteration] | None = None,
        progress: Callable[[int, int], None] | None = None,
    ) -> Tally:
        """Try the chosen alterations, or all; ``progress`` is told how many of how many."""
        listed = self.alterations() if chosen is None else list(chosen)
        accepted: list[Alteration] = []
        counts = {"malformed": 0, "refuted": 0, "unexpected": 0}
        for number, alteration in enumerate(listed, 1):
            outcome = self.outcome(alteration)
            if outcome == "accepted":
                accepted.append(alteration)
            else:
                counts[outcome] += 1
            if progress is not None:
                progress(number, len(listed))
        return Tally(**counts, accepted=tuple(accepted))

    def outcome(self, alteration: Alteration) -> str:
        """ "malformed", "refuted", "unexpected" or "accepted"."""
        altered = schema.table(replaced(self._original, alteration.path, alteration.new), "")
        self._meter.reset()
        try:
            self._decide_affected(altered, alteration)
        except (MalformedError, LookupError, TypeError):
            return "malformed"
        except RejectedError:
            return "refuted"
        if not check(altered).accepted:
            return "refuted"
        return "accepted" if check(altered, **self._expected).accepted else "unexpected"

    def _decide_affected(self, altered: dict[str, Plain], alteration: Alteration) -> None:
        """Decide the statements that depend on what is altered; nothing is expected of them."""
        path = alteration.path
        if len(path) < 3:
            read_document(altered, self._meter)
            return
        part, place = path[0], path[1]
        if part == "statements" and isinstance(place, int):
            entry = schema.items(altered["statements"], "statements")[place]
            self._document.decide(read_statement(entry, self._document.towers, "statement"))
        elif part == "towers":
            entry = schema.table(altered["towers"], "towers")[str(place)]
            tower = read_place(entry, self._meter, "tower")
            document = replace(self._document, towers={**self._document.towers, str(place): tower})
            _decide(document, lambda s: s.tower == place)
        else:
            document = replace(self._document, programs=read_programs(altered["programs"]))
            _decide(
                document,
                lambda s: s.kind == "program" and schema.table(s.claim, "")["program"] == place,
            )


def _decide(document: Document, affected: Callable[[Statement], bool]) -> None:
    for statement in document.statements:
        if affected(statement):
            document.decide(statement)


def _expected(certificate: Plain) -> dict[str, Any]:
    fields = schema.table(certificate, "certificate")
    towers = schema.table(fields["towers"], "towers")
    claims = [
        {key: schema.table(s, "statement")[key] for key in ("id", "kind", "tower", "claim")}
        for s in schema.items(fields["statements"], "statements")
    ]
    domain = {name: schema.table(tower, name)["parameters"] for name, tower in towers.items()}
    return {"claims": claims, "domain": domain, "programs": fields["programs"], "towers": towers}
