"""What a file defines, a model or a set of expressions, as one text: a key for what comes of it."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from fractions import Fraction
from typing import Any

import sympy as sp


def definition_text(value: Any) -> str:
    """All of a value that a file defines, as text: alike in all processes, different for whatever
    differs. Raises TypeError where code of the user's is a part of it, such as a class.
    """
    kind = f"{type(value).__module__}.{type(value).__qualname__}"
    if value is None or type(value) in (bool, int, float, str, Fraction):
        return f"{kind} {value!r}"
    if type(value) in (tuple, list):
        return f"{kind} ({', '.join(map(definition_text, value))})"
    if type(value) is dict:
        return f"{kind} {definition_text(list(value.items()))}"
    if isinstance(value, sp.MatrixBase) and kind.startswith("sympy."):
        return f"{kind} {value.shape} {definition_text(list(value.flat()))}"
    if isinstance(value, sp.Basic):
        for part in sp.preorder_traversal(value):
            if not str(type(part).__module__).startswith("sympy."):
                raise TypeError(f"{type(part).__qualname__} is no class of SymPy")
        return f"{kind} {sp.srepr(value)}"
    if is_dataclass(value) and kind.startswith("gainproof.derive."):
        parts = {each.name: getattr(value, each.name) for each in fields(value)}
        return f"{kind} {definition_text(parts)}"
    raise TypeError(f"{kind} is no plain data")
