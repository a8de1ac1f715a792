"""LaTeX of calls, matrices and values at a place."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.reader.printed import ATOM, POWER, PRODUCT, Printed, case_texts
from gainproof.verify.judge.reader.words import BASED, FUNCTION_WORDS, OF_CASES, TRANSPOSE_MARKS

_COMMANDS = {
    "asin": "\\arcsin",
    "acos": "\\arccos",
    "atan": "\\arctan",
    **{name: f"\\{name}" for name in ("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh")},
    **{name: f"\\{name}" for name in ("tanh", "exp", "det", "max", "min")},
    "log": "\\ln",
    "trace": "\\operatorname{tr}",
    "block_diagonal": "\\operatorname{blkdiag}",
    "covariance": "\\operatorname{cov}",
    "variance": "\\operatorname{var}",
    "sign": "\\operatorname{sgn}",
    **{name: f"\\operatorname{{{name}}}" for name in ("atan2", "rank", "diag", "erf", "erfinv")},
    **{name: f"\\operatorname{{{name}}}" for name in ("floor", "ceil", "mod")},
}
assert _COMMANDS.keys() == set(FUNCTION_WORDS.values())


_OPERATORS = {"!=": "\\ne", "<=": "\\le", ">=": "\\ge"}


def call_text(name: str, arguments: Sequence[Printed]) -> Printed:
    """A function of its arguments, or what has signs of its own."""
    texts = [argument.text for argument in arguments]
    match name, len(arguments):
        case "pi", 0:
            return Printed("\\pi", ATOM)
        case "abs", 1:
            return Printed(f"\\left| {texts[0]} \\right|", ATOM)
        case "norm", 1:
            return Printed(f"\\left\\| {texts[0]} \\right\\|", ATOM)
        case (("sum" | "product"), 4):
            sign = "\\sum" if name == "sum" else "\\prod"
            bounds = f"_{{{texts[1]} = {texts[2]}}}^{{{texts[3]}}}"
            body = texts[0] if arguments[0].level >= PRODUCT else f"\\left( {texts[0]} \\right)"
            return Printed(f"{sign}{bounds} {body}", PRODUCT)
        case "integral", 4:
            bounds = f"_{{{texts[2]}}}^{{{texts[3]}}}"
            return Printed(f"\\int{bounds} {texts[0]} \\, \\mathrm{{d}} {texts[1]}", PRODUCT)
        case "family", 4:
            bounds = f"_{{{texts[1]} = {texts[2]}}}^{{{texts[3]}}}"
            return Printed(f"\\left( {texts[0]} \\right){bounds}", POWER)
        case "expectation", 1:
            return Printed(f"\\mathbb{{E}} \\left[ {texts[0]} \\right]", ATOM)
        case "order", 1:
            return Printed(f"\\mathcal{{O}} \\left( {texts[0]} \\right)", ATOM)
        case "power", 2:
            base = texts[0] if arguments[0].level >= ATOM else f"\\left( {texts[0]} \\right)"
            above = f"\\left( {texts[1]} \\right)" if texts[1] in TRANSPOSE_MARKS else texts[1]
            return Printed(f"{base}^{{{above}}}", POWER, digit=arguments[0].digit)
    if name.startswith(OF_CASES):
        lines = case_texts(name, texts, " & ", ", \\ ", _OPERATORS)
        lines[-1] += "" if " & " in lines[-1] else " & \\text{otherwise}"
        inner = " \\\\ ".join(lines)
        return Printed(f"\\begin{{cases}} {inner} \\end{{cases}}", ATOM)
    if name in ("floor", "ceil"):
        return Printed(f"\\left\\l{name} {texts[0]} \\right\\r{name}", ATOM)
    inner = ", ".join(texts)
    if name.startswith(BASED):
        base = name.removeprefix(BASED)
        return Printed(f"\\log_{{{base}}} \\left( {inner} \\right)", POWER)
    if name in _COMMANDS:
        return Printed(f"{_COMMANDS[name]} \\left( {inner} \\right)", POWER)
    return Printed(f"{name} \\left( {inner} \\right)", ATOM)


def matrix_text(columns: int, entries: Sequence[Printed]) -> Printed:
    """A matrix in round brackets, whose entries may be matrices."""
    texts = [entry.text for entry in entries]
    rows = [" & ".join(texts[n : n + columns]) for n in range(0, len(texts), columns)]
    inner = " \\\\ ".join(rows)
    return Printed(f"\\begin{{pmatrix}} {inner} \\end{{pmatrix}}", ATOM)


def evaluated_text(body: Printed, symbol: str, value: Printed) -> Printed:
    """A value at a place."""
    return Printed(f"\\left. {body.text} \\right|_{{{symbol} = {value.text}}}", ATOM)
