"""The two real types of C, and numbers and names as its texts."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.emitter import unlike
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, Format
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.program import FUNCTIONS

KEYWORDS = frozenset(
    (
        *("auto", "break", "case", "char", "const", "continue", "default", "do", "double"),
        *("else", "enum", "extern", "float", "for", "goto", "if", "inline", "int", "long"),
        *("register", "restrict", "return", "short", "signed", "sizeof", "static", "struct"),
        *("switch", "typedef", "union", "unsigned", "void", "volatile", "while"),
        *("asm", "bool", "catch", "class", "decltype", "delete", "explicit", "export", "false"),
        *("friend", "mutable", "namespace", "new", "noexcept", "nullptr", "operator", "private"),
        *("protected", "public", "template", "this", "throw", "true", "try", "typeid"),
        *("typename", "using", "virtual", "wchar_t", "alignas", "alignof", "concept", "requires"),
        *("and", "or", "not", "xor", "bitand", "bitor", "compl", "and_eq", "or_eq", "not_eq"),
        *("constexpr", "static_assert", "thread_local", "fabs", "floor", "sqrt", *FUNCTIONS),
        *("fabsf", "floorf", "sqrtf", *(f"{name}f" for name in FUNCTIONS)),
        *("n", "i", "first", "fine", "values", "code", "size_t", "near_cbrt", "errno", "linux"),
        *(
            "unix",
            "main",
            "memcpy",
            "at",
            "ends",
            "expect",
            "place",
            "numbers",
            "wrong",
            "INFINITY",
            "NAN",
            "HUGE_VAL",
            "NULL",
        ),
    )
)
"""What an argument is not called: words of C and C++, and what the functions printed call."""


@dataclass(frozen=True)
class Flavour:
    """A format with its type, the ending of our functions, and that of literals and `math.h`."""

    form: Format
    type: str
    ending: str
    letter: str

    def number(self, value: float) -> str:
        """A number of the format as a literal that is read as just that number."""
        return f"{literal(value)}{self.letter}"


DOUBLE = Flavour(FLOAT64, "double", "", "")
SINGLE = Flavour(FLOAT32, "float", "_float", "f")
FLAVOURS = (DOUBLE, SINGLE)


def flavours(forms: Collection[str]) -> list[Flavour]:
    """Those of the formats named."""
    return [each for each in FLAVOURS if each.form.name in forms]


def arguments(kernel: Kernel) -> tuple[list[str], list[str]]:
    """Names of inputs and outputs, no two alike."""
    named = [each.name for each in kernel.inputs] + [each.name for each in kernel.outputs]
    found = unlike(named, KEYWORDS)
    count = len(kernel.inputs)
    return found[:count], found[count:]
