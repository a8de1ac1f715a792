"""The judge inside a web page: one Python under WebAssembly, which can start no other process.

Nor can it end a task that takes too long. The page hears of each task that begins, and ends this
Python when its time is over; the next one is told what came of the tasks before.
"""

from __future__ import annotations

import gc
import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any
from xml.etree.ElementTree import Element

from gainproof.answers.judge import Judge
from gainproof.answers.possible_filters import Options
from gainproof.answers.question import FILTER, Assumed, Question
from gainproof.bad_input import BadInputError, harmless
from gainproof.claims.judgements import shipped_models
from gainproof.claims.judging import judge_text
from gainproof.formulas.mathml import mathml
from gainproof.verdicts.verdict_reason import repaired, repairs_of, verdict_of_repair
from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.known_answers import KnownTrials
from gainproof.verify.judge.task import Models, Solved, Task
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker import OnTrial
from gainproof.verify.judge.worker_answer import answer_bytes, read_answer
from gainproof.verify.judge.worker_process import COLLECTED, trial_of

Tell = Callable[[str], None]
LATE = "late"
"""Why a task was ended: its time was over. Any other reason says what ended this Python with it."""


class Here:
    """Runs task after task in this process, as `Workers` do in others. `tell` hears, as JSON,
    {"begins": key, "seconds": limit} and {"ends": key, "text": what is known of it or null}.

    `texts` are those of tasks that ended, by key; `lost` says why others were ended, by key.
    """

    def __init__(self, models: Models, tell: Tell) -> None:
        self.texts: dict[str, str] = {}
        self.lost: Mapping[str, str] = {}
        self.seconds = 0.0
        self.taken = self.judged = 0
        self._models, self._tell = models, tell
        self._solved: Solved = {}

    def load(self, module: str, key: str) -> str | None:  # noqa: ARG002 (one code, one page)
        """The text kept under a key, None if there is none."""
        return self.texts.get(key)

    def store(self, module: str, key: str, text: str) -> None:  # noqa: ARG002
        """Keep a text."""
        self.texts[key] = text

    def run(self, tasks: Sequence[Task], on_trial: OnTrial | None = None) -> dict[str, Trial]:
        """What the tasks came to, by id of the claim; `on_trial` hears of each as it ends."""
        known = KnownTrials(self, self._models)
        found = {}
        for task in tasks:
            trial = known.of(task)
            self.taken += trial is not None
            if trial is None:
                self.judged += 1
                trial = self._run(task, known)
            found[task.claim.id] = trial
            if on_trial is not None:
                on_trial(trial)
        return found

    def _run(self, task: Task, known: KnownTrials) -> Trial:
        key, limit = known.key(task), min(self.seconds, task.most)
        why = self.lost.get(key)
        if why == LATE:
            reason = f"stopped after {limit:g} seconds"
            return Trial(task.claim, {}, (), False, limit, reason, timed=True)
        if why is not None:
            return Trial(task.claim, {}, (), False, 0.0, why, accident=why)
        self._tell(json.dumps({"begins": key, "seconds": limit}))
        # through text, as what other processes say
        text = answer_bytes(trial_of(task, self._models, self._solved))
        trial = read_answer(text, task.claim)
        known.keep(task, trial)
        self._tell(json.dumps({"ends": key, "text": self.texts.get(key)}))
        return trial


class InPage:
    """Answers the page; what its tasks came to is told to `tell`, as `Here` says."""

    def __init__(self, tell: Tell) -> None:
        gc.set_threshold(COLLECTED)
        self._models = shipped_models()
        self._here = Here(self._models, tell)
        self._judge = Judge(judges=self._here)

    def answered(self, request: str) -> str:
        """The answer to a request, both as JSON: {"error": ...} for what cannot be read.

        A request has "do", "ask", "understand" or "check"; "formula" with what is "said" of it, as
        `Options` has it, or the "text" of a claim file; "seconds" for each task; and what `Here`
        has in "texts" and "lost".
        """
        asked = json.loads(request)
        self._here.texts |= asked.get("texts", {})
        self._here.lost = asked.get("lost", {})
        self._here.seconds = asked.get("seconds", 0.0)
        do = {"ask": self._ask, "understand": self._understand, "check": self._check}[asked["do"]]
        try:
            return json.dumps(do(asked))
        except BadInputError as error:
            message = str(error)
            for option in ("symbol", "model", "domain", "given", "convention"):
                message = message.replace(f"--{option}", option)
            return json.dumps({"error": harmless(message)})

    def _check(self, asked: Mapping[str, Any]) -> dict[str, Any]:
        return judge_text("text", asked["text"], self._models, self._here, lambda _: None)

    def _understand(self, asked: Mapping[str, Any]) -> dict[str, Any]:
        return self._understood(self._question(asked))

    def _ask(self, asked: Mapping[str, Any]) -> dict[str, Any]:
        question = self._question(asked)
        answer = self._judge.answer(question)
        return {
            **self._understood(question),
            "headline": answer.headline(),
            "verdict": answer.verdict,
            # repairs are set below them
            "facts": [fact for fact in answer.facts() if fact[1] not in repaired(answer.claim)],
            "repairs": [
                {
                    "set": _set(repair["latex"]),
                    "words": "; ".join([verdict_of_repair(repair), *repair["changes"]]),
                }
                for repair in repairs_of(answer.claim)
            ],
            "explanation": answer.explain(asked["columns"]),
            "answer": answer.plain(),
        }

    def _question(self, asked: Mapping[str, Any]) -> Question:
        return self._judge.question(asked["formula"], Options(**asked["said"]))

    def _understood(self, question: Question) -> dict[str, Any]:
        """The formula set, its symbols with their meanings, what filters it may be about, and the
        claim file that says the same.
        """
        try:
            names = tuple(str(model["name"]) for model in self._models)
            latex = read_claim_text(question.text, "formula", names).claims[0].latex
        except ClaimFileError:
            latex = ""  # what is wrong with it is told when it is asked for
        ways = question.assumed.values()
        symbols = [
            {"name": each.of, "set": _set(each.of), "means": _means(each)}
            for each in next(iter(ways))
            if each.option.startswith("--symbol")
        ]
        filters = [_means(each) for way in ways for each in way if each.of == FILTER]
        return {"set": _set(latex), "symbols": symbols, "filters": filters, "file": question.text}


def _means(assumed: Assumed) -> str:
    return f"{assumed.meaning} (guessed)" if assumed.guessed else assumed.meaning


def _set(latex: str) -> Any:
    """A formula as MathML, [element, attributes, parts]; as it is written where that fails."""
    root = mathml(" ".join(latex.split()), "inline") if latex else None
    return latex if root is None else _plain(root)


def _plain(element: Element) -> list[Any]:
    parts: list[Any] = [element.text] if element.text else []
    for inner in element:
        parts += [_plain(inner), *([inner.tail] if inner.tail else [])]
    return [element.tag, dict(element.attrib), parts]
