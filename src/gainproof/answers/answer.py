"""What `ask` answers: the verdict on a formula, with all that was assumed for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from math import prod
from typing import Any

from gainproof.answers.matrix_question import ANY_SIZE
from gainproof.answers.possible_filters import NO_FILTER, SEARCHED
from gainproof.answers.question import DEFINITION, FILTER, Assumed, Question
from gainproof.notebook.markup import html_escaped
from gainproof.terminal_text import WIDTH, filled
from gainproof.verdicts import witness_text
from gainproof.verdicts.explanation import explanation
from gainproof.verdicts.verdict_reason import is_contradicted, reasons
from gainproof.verify.judge.verdict_words import OTHERS

FORMAT = "gainproof answers 1"
BEST = ("proved", DEFINITION, "conditional")
"""Verdicts for which one way to understand a formula is preferred to others, the best first."""
OPEN = (SEARCHED, NO_FILTER, ANY_SIZE)
"""What the words on a filter that name none hold."""
ANY = {
    NO_FILTER: " as a statement about any numbers",
    ANY_SIZE: " as a statement about any matrices",
}
ONLY_DEFINES = (
    "nothing is known of the letter on one side, so that the formula only says what it is: say "
    "what it is meant to be (--symbol 'NAME: = ...', --given)"
)
FILTER_GAINS, PREDICTOR_GAINS = (
    "gains are those of the filter (K)",
    "gains are those of the predictor (F K)",
)
ANY_OF = "any of: "
"""How the judge begins where several conventions fit."""
_LABEL = 10


@dataclass(frozen=True, repr=False)
class Answer:
    """The verdict on one formula.

    Attributes
    ----------
    formula : str
        As it was asked for.
    claim : mapping
        What `gainproof check --json` says of it: verdict, domain, evidence, repairs and so on.
    assumed : tuple of Assumed
        What was taken for granted of symbols and filter, guesses marked.
    others : tuple of (str, str)
        Further ways to understand the formula that were tried: the filter, and the verdict.
    text : str
        The claim file that says the same.
    """

    formula: str
    claim: Mapping[str, Any]
    assumed: tuple[Assumed, ...]
    others: tuple[tuple[str, str], ...]
    text: str

    @property
    def verdict(self) -> str:
        """One of the verdicts of the README."""
        return str(self.claim["verdict"])

    @property
    def domain(self) -> str:
        """Where the verdict holds."""
        return str(self.claim["domain"] or "")

    @property
    def witness(self) -> Any:
        """The point at which the formula fails, with the values of both sides; None without one."""
        return self.claim["evidence"]["witness"]

    @property
    def repairs(self) -> Sequence[Mapping[str, Any]]:
        """The nearest true formulas, the likeliest first."""
        return tuple(self.claim["repairs"] or ())

    @property
    def reading(self) -> str:
        """How the formula was read where it has several readings."""
        return str(self.claim["reading"] or "")

    @property
    def certificate(self) -> Mapping[str, Any]:
        """Data that one file without the judge decides, `gainproof/verify/check_answer.py`; found
        anew at each use. Empty where there is none.
        """
        return self.certified()["certificate"] or {}

    def certified(self) -> dict[str, Any]:
        """The certificate, or None and why there is none, as `ask --json` has them."""
        # the exact arithmetic is not loaded for answers of which no certificate is wanted
        from gainproof.verify.judge.answer_certificate import NoCertificateError, answer_certificate

        try:
            found = answer_certificate(self.claim, self.formula)
            return {"certificate": found, "no_certificate": None}
        except NoCertificateError as reason:
            return {"certificate": None, "no_certificate": str(reason)}

    def explain(self, columns: int = WIDTH) -> str:
        """The whole proof or witness, as `gainproof explain` prints it."""
        return explanation({**self.claim, "id": "formula"}, columns)

    def plain(self) -> dict[str, Any]:
        """As plain data for JSON, as `answer.schema.json` describes it."""
        left_out = ("id", "place", "latex")
        said = {name: value for name, value in self.claim.items() if name not in left_out}
        return {
            "formula": self.formula,
            "verdict": self.verdict,
            "assumed": [asdict(each) for each in self.assumed],
            "others": [{"filter": filter_, "verdict": verdict} for filter_, verdict in self.others],
            **said,
        }

    def shown(self, columns: int = WIDTH) -> str:
        """Some lines for a terminal: formula, verdict with what it rests on, reasons, guesses."""
        lines = filled(self.formula, "", "  ", columns)
        lines += filled(self.headline(), "  ", "    ", columns)
        last = ""
        for label, value in self.facts():
            head = "" if label == last else f"{label}:"
            lines += filled(value, f"  {head:<{_LABEL}} ", " " * (_LABEL + 3), columns)
            last = label
        return "\n".join(lines) + "\n"

    def facts(self) -> list[tuple[str, str]]:
        """Where it holds, reasons, guesses, what was tried: labels, some twice, with words."""
        facts = [("where", self.domain)] if self.verdict == "proved" and self.domain else []
        facts += [("why", why) for why in reasons(self.claim)]
        facts += [("but", f"false where {FILTER_GAINS}: {why}") for why in self._of_the_filter()]
        facts += [("why", ONLY_DEFINES)] if self.verdict == DEFINITION else []
        for label, guessed in (("guessed", True), ("as said", False)):
            said = [f"{a.of}: {a.meaning}" for a in self.assumed if a.guessed == guessed]
            facts += [(label, "; ".join(said))] if said else []
        return facts + [("tried too", f"{filter_}: {verdict}") for filter_, verdict in self.others]

    def headline(self) -> str:
        """The verdict with the conventions and guesses that it rests on."""
        words = self.verdict
        if self.claim["convention"]:
            convention = _together(self.claim["convention"])
            words += (
                f": true for {convention}" if is_contradicted(self.claim) else f" for {convention}"
            )
        guessed = [each.of for each in self.assumed if each.guessed]
        kinds = [*(["symbols"] if guessed not in ([], [FILTER]) else [])]
        if FILTER in guessed:
            # where it was searched the conventions name it
            is_open = any(words in self._filter() for words in OPEN)
            kinds.append(FILTER if is_open else self._filter())
        if self.verdict == "refuted" and FILTER in guessed and self.claim["convention"] is None:
            words += ANY.get(self._filter(), f" for a {self._filter()}")
        return f"{words}; assumed: {' and '.join(kinds)}" if kinds else words

    def _of_the_filter(self) -> list[str]:
        """Where a formula that is true of the predictor's gains alone fails for the filter's."""
        convention = str(self.claim["convention"] or "")
        if self.verdict != "proved" or "convention" in {each.of for each in self.assumed}:
            return []
        others = (self.claim["evidence"]["certificate"] or {}).get(OTHERS, {})
        other = others.get(convention.replace(PREDICTOR_GAINS, FILTER_GAINS))
        if PREDICTOR_GAINS not in convention or not isinstance(other, Mapping):
            return []
        return [f"{witness_text.in_words(other)} (--convention gain=filter: what would be true)"]

    def _filter(self) -> str:
        return _filter(self.assumed)

    def __repr__(self) -> str:
        return f"<answer {self.formula!r}: {self.headline()}>"

    def __str__(self) -> str:
        return self.shown()

    def _repr_html_(self) -> str:
        """As typed: a formula may come from anywhere, and is not given to a notebook to be set."""
        first, *rest = self.shown().rstrip("\n").split("\n")
        below = "<br>".join(html_escaped(line.strip()) for line in rest)
        return f"<p><code>{html_escaped(first)}</code><br>{below}</p>"


def _together(convention: str) -> str:
    """Conventions in words. Several choices of them that are all combinations are told part by
    part: "process noise any of a, b, gains are those of the filter (K)".
    """
    if not convention.startswith(ANY_OF):
        return convention
    *named, last = convention.removeprefix(ANY_OF).split("; ")
    if last.startswith("and "):  # "and 12 more"
        choices = [choice.split(", ") for choice in named]
        common = [part for part in choices[0] if all(part in choice for choice in choices)]
        most = len(choices) + int(last.split()[1])
        return ", ".join([f"any of {most} choices of process noise and conventions", *common])
    choices = [choice.split(", ") for choice in (*named, last)]
    parts = [[*dict.fromkeys(column)] for column in zip(*choices, strict=False)]
    whole = {len(choice) for choice in choices} == {len(parts)}
    if not whole or prod(map(len, parts)) != len(choices):
        return convention
    return ", ".join(_one_of(part) for part in parts)


def _one_of(part: Sequence[str]) -> str:
    """What is alike in front of several words is told once."""
    if len(part) == 1:
        return part[0]
    front = "process noise "
    if all(each.startswith(front) for each in part):
        return f"{front}any of {', '.join(each.removeprefix(front) for each in part)}"
    return " or ".join(part)


def answer_of(asked: Question, claims: Sequence[Mapping[str, Any]]) -> Answer:
    """The answer from the verdicts on all ways to understand the formula: the best of them. Of a
    formula that is false in each the one in which it looks like a misprint.
    """

    def rank(claim: Mapping[str, Any]) -> int:
        return BEST.index(claim["verdict"]) if claim["verdict"] in BEST else len(BEST)

    best = min(claims, key=rank)
    if all(claim["verdict"] == "refuted" for claim in claims):
        best = next((claim for claim in claims if claim["repairs"]), best)
    others = tuple(
        (_filter(asked.assumed[claim["id"]]), claim["verdict"])
        for claim in claims
        if claim is not best
    )
    return Answer(asked.formula, best, asked.assumed[best["id"]], others, asked.text)


def _filter(assumed: Sequence[Assumed]) -> str:
    return next(each.meaning for each in assumed if each.of == FILTER)
