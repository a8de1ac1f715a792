"""Certificates about growing and fading memories, which `gainproof.verify.check_memory` decides.

They hold no proof: the file decides equations of rational functions and roots by itself. What is
written here is the statement, and the sums of squares on which gain and covariance rest.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from gainproof.verify import check_memory
from gainproof.verify.judge.certificate_text import Said, Text
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.setting.environment import SAMPLE, WEIGHT


def memory_certificate(said: Said) -> dict[str, Any]:
    """The certificate of a proof. Raises ValueError and others."""
    writer = Writer(said)
    found = {"format": check_memory.FORMAT, "lines": writer.written()}
    check_memory.Certificate(found).decide()
    return found


class Writer(Text):
    """Lines as the file has read them."""

    def __init__(self, said: Said) -> None:
        super().__init__(said, {*"FHNVZKXPrnw", "sqrt"})
        self.checker = check_memory.Certificate({"format": check_memory.FORMAT})
        self.lines: list[list[str]] = []

    def say(self, title: str, text: str) -> None:
        self.checker.line(title, text)
        self.lines.append([title, text])

    def written(self) -> list[list[str]]:
        """All lines. Raises ValueError where something is not shown."""
        said, growing = self.said, "n" in self.said.model
        if any(rel.operator != "=" for rel in said.relations):
            raise Malformed("an order between quantities of a memory")
        base = SAMPLE if growing else WEIGHT
        token = said.labels.get(base, base)
        first = constant_value(said.model["first"][0][0]) if "first" in said.model else 0
        of_source = self.names[token]
        self.names[token] = "n" if growing else "w"
        for text in (said.typed, *said.functions):
            self.say("typed", " ".join(text.split()))
        if said.convention:
            self.say("convention", " ".join(said.convention.split()))
        for symbol, plain in self.names.items():
            if symbol != plain and not (first and symbol == token):
                self.say("name", f"{plain} for {' '.join(symbol.split())}")
        if first and token != of_source:
            self.say("name", f"{of_source} for {token}")
        for symbol in said.boxes:
            self.say("real", self.names[symbol])
        self.bounds(token, Fraction(first or 0))
        for name in "FHNVZ":
            if name in said.model:
                rows = [", ".join(self.text(e) for e in row) for row in said.model[name]]
                self.say("with", f"{name} = [{', '.join(f'[{row}]' for row in rows)}]")
        self.say("with", f"r = {self.text(said.model['r'][0][0])}")
        self.say("memory", check_memory.GROWING if growing else check_memory.FADING)
        if first:
            # the source's number of the sample is another one from here on
            self.names[token] = of_source
            self.texts.clear()
            self.say("with", f"{of_source} = n + {first}")
        for symbol, expr in said.letters.items():
            self.say("with", f"{self.names[symbol]} = {self.text(expr)}")
        for k, expr in enumerate(said.needed, 1):
            self.say("with", f"value{k}_ = {self.text(expr)}")
        for rel in said.relations:
            self.say("claim", self.relation(rel))
        return self.lines

    def bounds(self, sample: str, first: Fraction) -> None:
        """Of each variable the narrowest. Raises Malformed for other conditions."""
        low: dict[str, tuple[Fraction, bool]] = {}
        high: dict[str, Fraction] = {}
        for name, box in self.said.boxes.items():
            if box.lower is not None:
                low[name] = box.lower, box.lower_open
            if box.upper is not None:
                if not box.upper_open:
                    raise Malformed("a bound from above that is reached")
                high[name] = box.upper
        for rel in self.said.given:
            name = self.said.labels.get(str(rel.left.value), str(rel.left.value))
            end = constant_value(rel.right)
            if rel.left.kind != "symbol" or end is None or rel.operator not in (">", ">="):
                raise Malformed("a condition on more than one variable")
            low[name] = max(low.get(name, (end, False)), (end, rel.operator == ">"))
        for name, (end, is_open) in low.items():
            start = end - first if name == sample else end
            self.say("where", f"{self.names[name]} {'>' if is_open else '>='} {start}")
        for name, end in high.items():
            self.say("where", f"{end} > {self.names[name]}")
