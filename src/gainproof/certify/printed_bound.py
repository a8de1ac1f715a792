"""The error bounds that the kernels' docstrings print, read from their source."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

_BOUND = re.compile(r"^    (?P<output>\w+): (?P<words>(?:(?!^    \S).*\n)*)", re.MULTILINE)
_WORDS = re.compile(
    r"Relative error at most ([0-9.]+) \* 2\^-52 \(float64\).*?"
    r"proved for (\S+) <= \w+ <= (\S+) \(float64\)"
)


@dataclass(frozen=True)
class PrintedBound:
    """The relative error of an output of a kernel is at most `bound` * 2^-52 on the `domain`."""

    kernel: str
    output: str
    bound: Fraction
    domain: tuple[Fraction, Fraction]

    @property
    def name(self) -> str:
        """Of kernel and output."""
        return f"{self.kernel}.{self.output}"


def printed_bounds(source: str) -> Iterator[PrintedBound]:
    """The relative bounds of one input that a kernel module prints."""
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef) and (text := ast.get_docstring(node, clean=False)):
            for found in _BOUND.finditer(text):
                words = _WORDS.search(" ".join(found["words"].split()))
                if words:
                    ends = Fraction(float(words[2])), Fraction(float(words[3]))
                    yield PrintedBound(node.name, found["output"], Fraction(words[1]), ends)
