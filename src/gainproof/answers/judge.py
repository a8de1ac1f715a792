"""A judge that stays for many formulas: its process starts once and keeps what it has solved."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from types import TracebackType
from typing import Any

from gainproof.answers.answer import Answer, answer_of
from gainproof.answers.possible_filters import Options
from gainproof.answers.question import Question, question
from gainproof.bad_input import BadInputError
from gainproof.claims.judgements import shipped_models
from gainproof.claims.judging import KeptTrials, judge_text
from gainproof.claims.time_limit import DEFAULT, MOST
from gainproof.jobs.cache import Cache, default_folder
from gainproof.jobs.worker_state import WorkerState
from gainproof.verify.judge.worker import Judges, Workers


class Judge:
    """Answers formulas one after the other, also to several threads. To be used in a `with`, at
    whose end its process ends; a formula that hangs costs the process, and the next one gets
    another.

    Parameters
    ----------
    seconds : float
        Processor time for a formula, for each way to understand it that is tried; it is undecided
        after that.
    fresh : bool
        Take nothing of what was found before.
    models : sequence of mapping
        Models beside those that are shipped, as `generated/catalogue.json` has them.
    judges : Judges
        Who judges in place of a process of its own, without what was found before.
    """

    def __init__(
        self,
        *,
        seconds: float = DEFAULT,
        fresh: bool = False,
        models: Sequence[Mapping[str, Any]] = (),
        judges: Judges | None = None,
    ) -> None:
        if not (isinstance(seconds, int | float) and 0 < seconds <= MOST):
            raise BadInputError(f"seconds: a number above 0 and up to {MOST:g}, got {seconds!r}")
        self._models = [*shipped_models(), *map(dict, models)]
        # the process answers one formula after the other
        self._one_by_one = threading.Lock()
        known = KeptTrials(Cache(default_folder(), fresh))
        self._workers = judges or Workers(self._models, seconds, 1, known)

    def __enter__(self) -> Judge:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if isinstance(self._workers, Workers):
            self._workers.__exit__(kind, error, trace)

    def question(self, formula: str, options: Options) -> Question:
        """How a formula is understood, without a verdict. Raises BadInputError."""
        return question(formula, options, self._models)

    def ask(
        self,
        formula: str,
        *,
        symbols: Mapping[str, str] | None = None,
        model: str | None = None,
        domain: str | None = None,
        given: str | Sequence[str] = (),
        conventions: Mapping[str, str] | None = None,
    ) -> Answer:
        """The verdict on a formula, as `gainproof.ask` says. Raises BadInputError."""
        given = (given,) if isinstance(given, str) else tuple(given)
        options = Options(symbols or {}, model or "", domain or "", given, conventions or {})
        for text in (formula, options.model, options.domain, *given):
            if not isinstance(text, str):
                raise BadInputError(f"a text is wanted, got {type(text).__name__}")
        return self.answer(self.question(formula, options))

    def answer(self, asked: Question) -> Answer:
        """The verdict on a formula that is understood. Raises BadInputError."""
        try:
            with self._one_by_one:
                judged = judge_text("formula", asked.text, self._models, self._workers, _silent)
        except BadInputError as error:
            raise _as_asked(error) from None
        return answer_of(asked, judged["claims"])


def asked(
    state: WorkerState, formula: str, said: Mapping[str, Any], seconds: float
) -> dict[str, Any]:
    """{"answer", "text"}: the answer to a formula as plain data, and as text with its explanation;
    `said` are further arguments of `Judge.ask`. Raises BadInputError.
    """
    judge = state.opened(("asked", seconds), lambda: Judge(seconds=seconds))
    answer = judge.ask(formula, **said)
    return {"answer": answer.plain(), "text": f"{answer.shown()}\n{answer.explain()}"}


def _silent(_: str) -> None:
    """Nobody is told how far it is."""


def _as_asked(error: BadInputError) -> BadInputError:
    """The errors of the claim file that a formula became, without its lines: by what was asked."""
    said = []
    for each in error.errors:
        table, _, further = str(each["where"]).partition(".")
        _, _, mark = str(each["text"]).partition("\n")
        place = "formula"
        if table == "settings":
            place = (
                "--symbol"
                if ".symbols" in further or "domains" in str(each["message"])
                else "--model"
            )
        elif further.endswith((".domain", ".given")):
            place = f"--{further.rpartition('.')[2]}"
        said.append("\n".join([f"{place}: {each['message']}", *([mark] if mark else [])]))
    return BadInputError("\n".join(dict.fromkeys(said)) or str(error), error.errors)
