"""The arithmetic of a kernel as C statements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from gainproof.derive.printer import emitter
from gainproof.derive.printer.c_language.real_types import DOUBLE, Flavour
from gainproof.derive.printer.cube_root_start import added_bits
from gainproof.derive.printer.emitter import Body, Language, named
from gainproof.derive.printer.kernel import Kernel

SIXTEENTHS = (4, 8, 16, 32)


@dataclass(frozen=True)
class _C(Language):
    flavour: Flavour = DOUBLE

    def number(self, value: float) -> str:
        return self.flavour.number(value)

    def call(self, name: str, parts: Sequence[str]) -> str:
        if name == "near_cbrt":
            return f"near_cbrt{self.flavour.ending}({parts[0]})"
        called = "fabs" if name == "abs" else name
        return super().call(called if name == "neg" else f"{called}{self.flavour.letter}", parts)

    def statement(self, name: str, text: str) -> str:
        return f"const {self.flavour.type} {name} = {text};"

    def remark(self, label: str) -> str:
        return f" /* {label} */"


def body(kernel: Kernel, flavour: Flavour, names: Mapping[str, str]) -> Body:
    """The steps that a kernel's outputs need; `names` of inputs are texts of their values."""
    return emitter.body(kernel, _C(flavour.form, flavour), named(names))


def required(kernel: Kernel, flavour: Flavour, names: Mapping[str, str]) -> list[tuple[Body, str]]:
    """The steps of what is required of inputs together, and the condition on it."""
    found = emitter.required(kernel, _C(flavour.form, flavour), named(names))
    return [(made, f"({made.outputs[0]} >= {least})") for made, least in found]


def near_cbrt(flavour: Flavour) -> list[str]:
    """A function that starts cube roots from a third of a number's bits.

    Of 64 bits the third comes by shifts, as no vector unit divides such integers.
    """
    kind, wide = flavour.type, 64 if flavour.type == "double" else 32
    third = ["q = b / 3u;"]
    if wide == 64:
        sums = ["(b >> 2) + (b >> 4)", *(f"q + (q >> {count})" for count in SIXTEENTHS)]
        third = [
            *(f"q = {each};" for each in sums),
            "b -= q + (q << 1);",
            "q += (b + (b << 1) + (b << 3)) >> 5;",
        ]
    return [
        f"static inline {kind} near_cbrt{flavour.ending}({kind} x)",
        "{",
        f"    uint{wide}_t b, q;",
        "    memcpy(&b, &x, sizeof b);",
        *(f"    {line}" for line in third),
        f"    q += {added_bits(flavour.form)}u;",
        "    memcpy(&x, &q, sizeof x);",
        "    return x;",
        "}",
        "",
    ]
