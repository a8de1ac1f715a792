"""Proofs on matrices of every size as lines that a reader can follow.

Letters of a certificate are shortened: E1, E2 are blocks of unit matrices, C1, C2 stand for what
is inverted, X^-1 is the inverse of X.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from gainproof.formulas.formula_text import formula_text
from gainproof.formulas.relation_text import Writer, relation_lines

Plain = Mapping[str, Any]
LONGEST = 400
"""Characters of a side that is written out."""


def proof_lines(proof: Plain) -> list[str]:
    """What the letters stand for, and each statement with the earlier ones that it rests on."""
    names = _names(proof["setting"])
    lines = [meaning for _, meaning in _meanings(proof["setting"], names)]
    numbers = {entry["id"]: n for n, entry in enumerate(proof["statements"], 1)}
    for number, entry in enumerate(proof["statements"], 1):
        used = sorted({numbers[name] for name in _used(entry["evidence"]) if name in numbers})
        from_ = f" (from {_listed([str(n) for n in used])})" if used else ""
        lines.append(f"{number}. {_said(entry, names)}{from_}")
    return lines


def result_lines(proof: Plain) -> list[str]:
    """What was proved: the last statement, and others on which nothing rests, that an inverse
    exists left out; and what their letters stand for.
    """
    names, statements = _names(proof["setting"]), proof["statements"]
    used = {name for entry in statements for name in _used(entry["evidence"])}
    kept = [e for e in statements[:-1] if e["kind"] != "matrix_invertible" and e["id"] not in used]
    lines = [_said(entry, names) for entry in (*kept, statements[-1])]
    for letters, meaning in reversed(_meanings(proof["setting"], names)):
        if not letters.isdisjoint(re.findall(r"\w+", " ".join(lines))):
            lines.insert(0, meaning)
    return lines


def _said(entry: Plain, names: Mapping[str, str]) -> str:
    found = "".join(relation_lines(entry["kind"], entry["claim"], Writer(names, _side)))
    return " ".join(found.split())


def _meanings(setting: Plain, names: Mapping[str, str]) -> list[tuple[set[str], str]]:
    """Sets of letters with a line on what they stand for, which may speak of those before."""
    found = []
    for rows, blocks in setting["blocks"].items():
        short = [names[block] for block in blocks]
        widths = _listed([_size(setting["matrices"][block][1]) for block in blocks])
        said = f"the blocks of the unit matrix of {_size(rows)} rows, {widths} wide"
        found.append((set(short), f"{_listed(short)}: {said}"))
    for name, value in setting["elements"].items():
        found.append(({names[name]}, f"{names[name]} = {_polynomial(value, names)}"))
    return found


def _names(setting: Plain) -> dict[str, str]:
    blocks = [name for each in setting["blocks"].values() for name in each]
    short = {name: f"E{n}" for n, name in enumerate(blocks, 1)}
    short |= {name: f"C{n}" for n, name in enumerate(setting["elements"], 1)}
    short |= dict.fromkeys(setting["units"], "I")
    for name in setting["matrices"]:
        short.setdefault(name, name.removeprefix("underline_"))
    return short | {name: f"{short[base]}^-1" for name, base in setting["inverses"].items()}


def _side(graph: Plain, names: Mapping[str, str], output: str = "value") -> str:
    """One side of a statement; of a long sum how many words it has."""
    nodes = graph["nodes"]
    top = nodes[graph["outputs"][output]]
    if top[0] == "mul" and any(nodes[n] == ["number", "0"] for n in top[1:]):
        return "0"
    text = formula_text(graph, names, output)
    return text if len(text) <= LONGEST else _too_long(len(top) - 1 if top[0] == "add" else 1)


def _polynomial(terms: list[Any], names: Mapping[str, str]) -> str:
    text = ""
    for factor, parameters, word in terms:
        number = Fraction(factor)
        letters = " ".join([*parameters, *(_letter(name, names) for name in word)])
        size = "" if abs(number) == 1 and letters else f"{abs(number)} "
        text += f" {'-' if number < 0 else '+'} {size}{letters}"
    text = text.strip().removeprefix("+ ") or "0"
    return text if len(text) <= LONGEST else _too_long(len(terms))


def _letter(name: str, names: Mapping[str, str]) -> str:
    return names[name.removesuffix("'")] + ("'" if name.endswith("'") else "")


def _too_long(words: int) -> str:
    return f"(a sum of {words} products)" if words > 1 else "(a long product)"


def _size(name: str) -> str:
    """A size as people write it: size_m_6_plus_n_minus_n_b is 6 + n - n_b."""
    text = re.sub(r"^size_(m_(?=\d))?", "", name)
    text = text.replace("_plus_", " + ").replace("_minus_", " - ")
    return re.sub(r"(\d)_(?=[A-Za-z])", r"\1", text)


def _used(value: Any) -> Iterator[str]:
    """The ids in all that reads ["statement", id] or ["inverse", id, side]."""
    if isinstance(value, Mapping):
        for each in value.values():
            yield from _used(each)
    elif isinstance(value, list):
        if value[:1] in (["statement"], ["inverse"]):
            yield str(value[1])
        for each in value:
            yield from _used(each)


def _listed(words: list[str]) -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
