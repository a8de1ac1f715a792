"""A claim and its setting with every symbol under another name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.reader.printed_names import canonical_token

NAMED = ("latex", "arguments", "about", "variable", "previous")
"""Fields of symbols and claims that hold tokens."""


def renamed(claim: Claim, setting: Setting) -> tuple[Claim, Setting]:
    """Both, with new names for all declared symbols."""
    names = {
        token: canonical_token(rf"\zeta_{{{number}}}")
        for number, token in enumerate(setting.symbols, start=1)
    }
    return _with(claim, names), _with(setting, names)


def _with(value: Any, names: Mapping[str, str]) -> Any:
    if isinstance(value, Mapping):
        if "nodes" in value:
            return {**value, "nodes": [_node(node, names) for node in value["nodes"]]}
        return {names.get(key, key): _with(inner, names) for key, inner in value.items()}
    if isinstance(value, tuple):
        return tuple(_with(inner, names) for inner in value)
    if not is_dataclass(value) or isinstance(value, type):
        return value
    changed = {}
    for one in fields(value):
        inner = getattr(value, one.name)
        if one.name not in NAMED:
            changed[one.name] = _with(inner, names)
        elif isinstance(inner, tuple):
            changed[one.name] = tuple(names.get(name, name) for name in inner)
        else:
            changed[one.name] = names.get(inner, inner)
    return replace(value, **changed)


def _node(node: Any, names: Mapping[str, str]) -> list[Any]:
    kind, *rest = node
    place = {"symbol": 0, "call": 0, "derivative": 1, "at": 1}.get(kind)
    if place is not None:
        rest[place] = names.get(rest[place], rest[place])
    return [kind, *rest]
