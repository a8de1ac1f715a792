"""Formulas judged for programs: the tools by themselves, and through a client of the protocol."""

from __future__ import annotations

import asyncio
import importlib
import json
import os
import sys
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

import pytest

import gainproof
from gainproof.answers import server
from gainproof.answers.server import Tools
from gainproof.bad_input import BadInputError
from gainproof.cli import main
from gainproof.jobs.process import Process
from gainproof.verify.judge.claim.file import MOST_BYTES

SHORT = r"""format = "gainproof claims 1"
source = { title = "t" }
settings.s = { title = "numbers", kind = "algebra", symbols.x = { unit = "1", meaning = "any" } }
[[claims]]
id = "1"
place = "p"
kind = "inequality"
setting = "s"
plain = 'x^2 >= 0'
[[claims]]
id = "2"
place = "p"
kind = "inequality"
setting = "s"
plain = 'x^2 >= 1'
"""
MODEL = """
format = "gainproof model 1"
title = "a level"
transition = [[1]]
process_noise = [["q"]]
measurement = [[1]]
measurement_noise = [[1]]
symbols = { q = { unit = "1", meaning = "strength" } }
"""
SLOW = "((((9^64)^64)^64)^64)^64 = 1"
"""It takes all the time that it has."""


def asked(calls: Callable[[Tools], Awaitable[Any]]) -> Any:
    async def run() -> Any:
        tools = Tools()
        try:
            return await calls(tools)
        finally:
            await tools.end()

    return asyncio.run(run())


def test_tools_answer_as_the_commands_do(tmp_path: Path) -> None:
    formula = r"\beta = \frac{\alpha^2}{2 - \alpha}"

    async def calls(tools: Tools) -> list[Any]:
        return [
            await tools.check_formula(formula),
            await tools.check_formula(formula, model="random-acceleration"),
            await tools.explain("x^2 = y^2", symbols={"x": "1"}),
            await tools.check_file(SHORT),
            await tools.check_file(SHORT, "2"),
            await tools.list_models(),
            await tools.steady_state(MODEL, "q=1/2"),
        ]

    first, second, page, judged, one, listed, steady = asked(calls)
    assert {n: v for n, v in first.items() if n not in ("format", "seconds")} == {
        n: v for n, v in gainproof.ask(formula).plain().items() if n != "seconds"
    }
    assert (first["verdict"], second["verdict"]) == ("proved", "conditional")
    assert "as said:   x: number" in page
    file = tmp_path / "text.toml"
    file.write_text(SHORT)
    checked = gainproof.check(str(file))
    assert [c["verdict"] for c in judged["claims"]] == [c.verdict for c in checked]
    assert [c["id"] for c in one["claims"]] == ["2"]
    assert one["explanation"].startswith("2: conditional")
    assert json.dumps(judged)
    # P^2 = q (P + 1)
    (value,), (error,) = (steady["predicted_covariance"][x][0] for x in ("values", "errors"))
    assert 1 - error <= value <= 1 + error
    assert {"random-velocity", "least-squares-line"} <= {s["name"] for s in listed["subjects"]}


@pytest.mark.alike
@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda tools: tools.check_formula("x +"), "ends too early"),
        (lambda tools: tools.check_formula("x = x", seconds=0), "seconds: more than 0"),
        (lambda tools: tools.check_formula("x = x", seconds=float("nan")), "seconds: more than 0"),
        (lambda tools: tools.check_file("nothing"), "not TOML"),
        (lambda tools: tools.check_file("#" * (MOST_BYTES + 1)), "more than"),
        (lambda tools: tools.check_file(SHORT, "3"), "no claim of text is called '3'"),
        (lambda tools: tools.derivation("random-velocty"), "random-velocity"),
        (lambda tools: tools.derivation("own.py"), "no derivation is called"),
        (lambda tools: tools.steady_state(MODEL), "q has no value"),
        (lambda tools: tools.steady_state(MODEL, "q=0"), "not driven"),
        (lambda tools: tools.steady_state("title = 1"), "format: this field is missing"),
        (lambda tools: tools.check_formula("x = x", model="own.py"), "no model is called 'own.py'"),
    ],
)
def test_bad_input_is_told_and_the_next_call_is_answered(
    call: Callable[[Tools], Awaitable[Any]], message: str
) -> None:
    async def calls(tools: Tools) -> Any:
        with pytest.raises(BadInputError, match=message):
            await call(tools)
        return await tools.check_formula("x = x")

    assert asked(calls)["verdict"] == "proved"


def test_a_cancelled_call_ends_its_process_and_no_other(monkeypatch: pytest.MonkeyPatch) -> None:
    ended: list[int] = []
    end = Process.end

    async def noted(self: Process) -> None:
        ended.append(1)
        await end(self)

    monkeypatch.setattr("gainproof.jobs.workers.Process", Process)
    monkeypatch.setattr(server, "Process", Process)
    monkeypatch.setattr(Process, "end", noted)

    async def calls(tools: Tools) -> Any:
        slow = asyncio.ensure_future(tools.check_formula(SLOW))
        waiting = asyncio.ensure_future(tools.check_formula("x = x"))
        await asyncio.sleep(2)
        slow.cancel()
        with pytest.raises(asyncio.CancelledError):
            await slow
        assert ended == [1]
        return await waiting

    assert asked(calls)["verdict"] == "proved"


def test_without_the_sdk_it_says_what_is_missing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(server, "find_spec", lambda _: None)
    assert main(["serve"]) == 2
    assert "pip install 'gainproof[serve]'" in capsys.readouterr().err


@pytest.mark.thorough
def test_a_client_of_the_protocol_asks() -> None:
    mcp = pytest.importorskip("mcp")
    stdio = importlib.import_module("mcp.client.stdio")
    command = stdio.StdioServerParameters(
        command=sys.executable, args=["-m", "gainproof", "serve"], env=dict(os.environ)
    )

    async def asks() -> None:
        async with mcp.Client(command) as client:
            tools = {tool.name: tool for tool in (await client.list_tools()).tools}
            assert set(tools) == {
                *("check_formula", "explain", "check_file", "derivation", "list_models"),
                "steady_state",
            }
            assert tools["check_formula"].input_schema["required"] == ["formula"]
            assert "assumed" in tools["check_formula"].description
            found = await client.call_tool("check_formula", {"formula": "x^2 >= 0"})
            assert found.structured_content["verdict"] == "proved"
            wrong = await client.call_tool("check_formula", {"formula": "x +"})
            assert wrong.is_error
            assert "ends too early" in wrong.content[0].text
            with pytest.raises(Exception, match=r"(?i)timed? ?out"):
                await client.call_tool("check_formula", {"formula": SLOW}, 2.0)
            page = await client.call_tool("derivation", {"name": "least-squares-mean"})
            assert page.content[0].text.startswith("Least-squares mean")

    asyncio.run(asks())
