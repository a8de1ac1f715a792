"""Judged claim files that show themselves: the table as `gainproof check` prints it, or HTML."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.bad_input import unknown_name
from gainproof.notebook.markup import html_escaped
from gainproof.terminal_text import WIDTH
from gainproof.verdicts import verdict_text
from gainproof.verdicts.explanation import explanation
from gainproof.verdicts.verdict_reason import reason
from gainproof.verdicts.verdict_snapshot import Judgement


@dataclass(frozen=True, repr=False)
class JudgedClaim:
    """A claim with its verdict; `claim` is what `gainproof check --json` says of it."""

    claim: Mapping[str, Any]
    words: str = ""

    @property
    def verdict(self) -> str:
        """One of the verdicts of the README."""
        return str(self.claim["verdict"])

    def __repr__(self) -> str:
        return f"<claim {self.claim['id']}: {self.verdict}>"

    def __str__(self) -> str:
        return explanation(self.claim, words=self.words)

    def _repr_html_(self) -> str:
        """The formula is shown as it was typed: a claim file may come from anywhere, and what it
        holds is not given to a notebook to be set. For the same reason there is no `_repr_latex_`,
        which a notebook would prefer.
        """
        why = reason(self.claim)
        return (
            f"<p><b>{html_escaped(self.claim['id'])}</b>: {html_escaped(self.verdict)} "
            f"<code>{html_escaped(self.claim['latex'] or self.words)}</code>"
            f"{'<br>' if why else ''}{html_escaped(why)}</p>"
        )


@dataclass(frozen=True, repr=False)
class JudgedFile:
    """A claim file judged: claims by id."""

    judgement: Judgement
    words: Mapping[str, str]

    def __getitem__(self, id: str) -> JudgedClaim:  # noqa: A002
        """A claim by its id. Raises BadInputError for an id that there is not."""
        claims = {claim["id"]: claim for claim in self.judgement["claims"]}
        if id not in claims:
            raise unknown_name("claim", id, claims)
        return JudgedClaim(claims[id], self.words.get(id, ""))

    def __iter__(self) -> Iterator[JudgedClaim]:
        return (self[claim["id"]] for claim in self.judgement["claims"])

    def __len__(self) -> int:
        return len(self.judgement["claims"])

    def __repr__(self) -> str:
        told = verdict_text.counts([self.judgement])
        return f"<claims of {self.judgement['source']['key']}: {told}>"

    def __str__(self) -> str:
        return verdict_text.overview(self.judgement, WIDTH, self.words)

    def _repr_html_(self) -> str:
        title = html_escaped(self.judgement["source"]["title"])
        return "\n".join([f"<h3>{title}</h3>", *(each._repr_html_() for each in self)])
