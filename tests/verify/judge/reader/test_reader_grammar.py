"""The grammar is LALR(1) as it stands, and the reader needs nothing that could evaluate a text."""

from __future__ import annotations

import ast
import logging
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import lark
import pytest

import gainproof.verify.judge.reader
from gainproof.verify.judge.reader.grammar import GRAMMAR
from gainproof.verify.judge.reader.tokens import COMMANDS, MARKS, TAKES_ARGUMENTS

FOLDER = Path(gainproof.verify.judge.reader.__file__).parent


class NoLexer(lark.lexer.Lexer):
    """Only tables are built; nothing is read."""

    def __init__(self, lexer_conf: Any) -> None:
        del lexer_conf

    def lex(self, lexer_state: Any, parser_state: Any) -> Iterator[lark.Token]:
        raise AssertionError((lexer_state, parser_state))


def build(grammar: str) -> list[str]:
    """What lark says while it builds the tables: it settles conflicts silently otherwise."""
    said: list[str] = []
    handler = logging.Handler()
    handler.emit = lambda record: said.append(record.getMessage())  # type: ignore[method-assign]
    level = lark.logger.level
    lark.logger.addHandler(handler)
    lark.logger.setLevel(logging.DEBUG)
    try:
        starts = ["formula", "conditions", "single"]
        lark.Lark(grammar, parser="lalr", lexer=NoLexer, start=starts, debug=True)
    finally:
        lark.logger.removeHandler(handler)
        lark.logger.setLevel(level)
    return [message for message in said if "conflict" in message.lower()]


def test_no_conflicts() -> None:
    assert build(GRAMMAR) == []


def test_a_conflict_would_be_seen() -> None:
    assert build(GRAMMAR.replace("DOT_BEFORE_BIG big", "DOT big"))


@pytest.mark.parametrize(
    "kind", sorted({kind for kind, _ in (*COMMANDS.values(), *MARKS.values())})
)
def test_every_kind_of_token_is_in_the_grammar(kind: str) -> None:
    assert kind in GRAMMAR.replace("%declare", " ").split()


def test_commands_with_arguments_are_in_the_grammar() -> None:
    assert all(kind in GRAMMAR for kind in TAKES_ARGUMENTS)


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.py")), ids=lambda path: path.stem)
def test_nothing_evaluates(path: Path) -> None:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    assert not names & {"eval", "exec", "compile", "__import__", "sympify", "getattr", "globals"}
    imported = {
        alias.name.split(".")[0]
        for node in ast.walk(tree)
        if isinstance(node, ast.Import)
        for alias in node.names
    } | {
        (node.module or "").split(".")[0]
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
    }
    assert not imported & {"sympy", "re", "importlib", "pickle", "subprocess"}
