"""The error bounds that the kernels' docstrings print, read from their source."""

from __future__ import annotations

import ast
import re
from collections import Counter
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
    for kernel, output, text in _stated(source):
        words = _WORDS.search(text)
        if words:
            ends = Fraction(float(words[2])), Fraction(float(words[3]))
            yield PrintedBound(kernel, output, Fraction(words[1]), ends)


def other_bounds(source: str) -> Counter[str]:
    """How many bounds a module prints that are none of these, by what they are."""
    found: Counter[str] = Counter()
    for _, _, text in _stated(source):
        if not _WORDS.search(text):
            several = "proved for every input" in text
            found["kernels of several inputs" if several else "errors over a scale"] += 1
    return found


def _stated(source: str) -> Iterator[tuple[str, str, str]]:
    """Kernel, output and the words on it, of each output with a bound of float64."""
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef) and (text := ast.get_docstring(node, clean=False)):
            for found in _BOUND.finditer(text):
                words = " ".join(found["words"].split())
                if "* 2^-52 (float64)" in words:
                    yield node.name, found["output"], words
