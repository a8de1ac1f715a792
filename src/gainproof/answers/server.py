"""`gainproof serve`: a server of the Model Context Protocol, by which programs ask.

Whatever a call brings is data: nothing of it is executed, no file is read or written but the cache,
and no model in Python is taken. What judges is another process, which a cancelled call ends.
"""

from __future__ import annotations

import asyncio
import inspect
import os
from collections.abc import Mapping
from importlib.util import find_spec
from typing import Any

from gainproof.answers.answer import FORMAT
from gainproof.bad_input import BadInputError
from gainproof.claims import judgements
from gainproof.claims.claim_proofs import checked
from gainproof.claims.time_limit import DEFAULT
from gainproof.jobs import workers
from gainproof.jobs.cache import default_folder
from gainproof.jobs.process import Process
from gainproof.jobs.workers import Job
from gainproof.pages import lecture
from gainproof.subjects import derivations
from gainproof.subjects.derived import derived_from
from gainproof.verdicts.explanation import explanation
from gainproof.verify.judge.claim.file import MOST_BYTES
from gainproof.version import VERSION

INSTRUCTIONS = """\
Says whether formulas of tracking filters, and identities, inequalities and limits of real numbers,
are right: proved, refuted with a point where they fail and the nearest true formula, or true on a
part only. `assumed` lists what was guessed of letters: say it with `symbols` and `model` where it
is not meant so. A verdict of proved rests on an exact argument; held, undecided are no proofs."""
MOST_SECONDS = 600.0
"""Processor time that a call may ask for, for one formula or claim."""

Words = dict[str, str] | None
ARGUMENTS = f"""

formula: LaTeX or plain text. symbols: by symbol a quantity (filter_gain.1), a unit with a condition
(m > 0), integer with a condition, a definition (= a + b), or a matrix (n x m, symmetric). model: a
name of list_models, search, fixed (any gains), none (real numbers) or matrices (of any size).
domain: conditions under which the formula is claimed. given: equations and inequalities that are
hypotheses. conventions: such as gain = predictor. seconds: processor time for
the formula, at most {MOST_SECONDS:g}."""


class JudgingProcess:
    """The process that judges, for one call after the other. It stays for the next call, unless one
    was cancelled or it failed.
    """

    def __init__(self) -> None:
        self._process: Process | None = None
        self._free = asyncio.Lock()

    async def answer(self, job: Job) -> Any:
        """What the job answers. Raises BadInputError, and JobError for a fault of the program."""
        async with self._free:
            if self._process is None:
                settings = {**os.environ, **workers.REPRODUCIBLE}
                self._process = await Process.started(workers.WORKER, settings)
            try:
                return await workers.asked(self._process, job)
            except BadInputError:
                raise
            except BaseException:
                await self.end()
                raise

    async def end(self) -> None:
        """End the process and what it has started."""
        if self._process is not None:
            process, self._process = self._process, None
            await process.end()


class Tools:
    """What can be asked, each as plain data or text."""

    def __init__(self) -> None:
        self._judging = JudgingProcess()

    async def check_formula(
        self,
        formula: str,
        symbols: Words = None,
        model: str | None = None,
        domain: str | None = None,
        given: list[str] | None = None,
        conventions: Words = None,
        seconds: float = DEFAULT,
    ) -> dict[str, Any]:
        """The verdict on one formula, with what was assumed, where it holds, a point where it
        fails, the nearest true formulas, and the certificate.
        """
        found = await self._asked(formula, symbols, model, domain, given, conventions, seconds)
        return {"format": FORMAT, **found["answer"]}

    async def explain(
        self,
        formula: str,
        symbols: Words = None,
        model: str | None = None,
        domain: str | None = None,
        given: list[str] | None = None,
        conventions: Words = None,
        seconds: float = DEFAULT,
    ) -> str:
        """The verdict on one formula with the whole proof or witness, as text for people."""
        found = await self._asked(formula, symbols, model, domain, given, conventions, seconds)
        return str(found["text"])

    async def check_file(
        self,
        text: str,
        claim: str | None = None,
        seconds: float = DEFAULT,
    ) -> dict[str, Any]:
        """Verdicts on all claims of a claim file (TOML) given as text; or on the one whose id is
        `claim`, with its explanation. `seconds` is processor time for each claim.
        """
        if len(text.encode("utf-8")) > MOST_BYTES:
            raise BadInputError(f"the text has more than {MOST_BYTES} bytes")
        arguments = {
            "path": "text",
            "text": text,
            "models": judgements.shipped_models(),
            "seconds": _limited(seconds),
            "only": claim,
        }
        also = {"processes": workers.processors(), "cache": str(default_folder().absolute())}
        judged = dict(await self._judging.answer(Job("text", "judge", arguments, also)))
        judged.pop("tasks", None)
        if claim is not None:
            (one,) = judged["claims"]
            judged["explanation"] = explanation(one, checked=checked(one)[1])
        return judged

    async def derivation(self, name: str) -> str:
        """The derivation of a model or subject of the catalogue as a page of text, each step with
        the checker's word. It takes seconds to half a minute.
        """
        derivations.require_names([name])
        settings = {**os.environ, **workers.REPRODUCIBLE}
        derived = derived_from(await workers.call(Job(name, "derive", {"name": name}), settings))
        report = await self._judging.answer(derivations.recheck_job(derived.certificate, derived))
        return lecture.page(derived, report)

    async def list_models(self) -> dict[str, Any]:
        """All subjects of the catalogue, those with a model first: names and titles."""
        found = sorted(derivations.outlines(), key=lambda entry: entry["model"] is None)
        kept = ("name", "title", "model")
        return {"subjects": [{field: entry[field] for field in kept} for entry in found]}

    async def steady_state(self, model: str, at: str = "") -> dict[str, Any]:
        """The Kalman filter's steady state for a linear model with any number of states and
        measurements: gains, covariances and poles as doubles with proved errors, and a certificate.
        `model` is the text of a model file (TOML: format = "gainproof model 1", title, transition,
        process_noise, measurement, measurement_noise as rows of numbers and formulas, states with
        units, symbols); `at` gives its symbols values: "T=1, q=1e-22".
        """
        arguments = {"text": model, "at": at}
        return dict(await self._judging.answer(Job("model", "steady", arguments)))

    async def end(self) -> None:
        """End the process that judges."""
        await self._judging.end()

    async def _asked(
        self,
        formula: str,
        symbols: Mapping[str, str] | None,
        model: str | None,
        domain: str | None,
        given: list[str] | None,
        conventions: Mapping[str, str] | None,
        seconds: float,
    ) -> Any:
        arguments = {
            "formula": formula,
            "said": {
                "symbols": symbols,
                "model": model,
                "domain": domain,
                "given": given or [],
                "conventions": conventions,
            },
            "seconds": _limited(seconds),
        }
        return await self._judging.answer(Job("formula", "ask", arguments))


def _limited(seconds: float) -> float:
    if not 0 < seconds <= MOST_SECONDS:
        raise BadInputError(f"seconds: more than 0 and at most {MOST_SECONDS:g}, got {seconds}")
    return seconds


def server(tools: Tools) -> Any:
    """The server with these tools. Raises BadInputError where the SDK is missing."""
    if find_spec("mcp") is None:
        raise BadInputError("the SDK of the protocol is missing: pip install 'gainproof[serve]'")
    from functools import wraps

    from mcp.server import MCPServer
    from mcp.server.mcpserver.exceptions import ToolError

    made = MCPServer("gainproof", instructions=INSTRUCTIONS, version=VERSION, log_level="WARNING")

    def told(tool: Any) -> Any:
        @wraps(tool)
        async def call(*arguments: Any, **named: Any) -> Any:
            try:
                return await tool(*arguments, **named)
            except BadInputError as error:
                raise ToolError(str(error)) from None

        return call

    for tool in (
        tools.check_formula,
        tools.explain,
        tools.check_file,
        tools.derivation,
        tools.list_models,
        tools.steady_state,
    ):
        words = inspect.getdoc(tool) or ""
        further = ARGUMENTS if "formula" in inspect.signature(tool).parameters else ""
        made.tool(description=words + further)(told(tool))
    return made


async def serve() -> None:
    """Serve over standard input and output until the former ends. Raises BadInputError."""
    tools = Tools()
    made = server(tools)
    try:
        await made.run_stdio_async()
    finally:
        await tools.end()
