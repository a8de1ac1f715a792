"""Expressions as polynomials over their inputs and over parts that are no polynomials.

A part is a root, a quotient's divisor or a function: `part_1` is the value of one, `over_1` is one
over a divisor. Each has arguments that are polynomials over inputs and parts before it. So the
whole is written as a list of polynomials, which a certificate can hold; what `sqrt` or `sin` is, it
need not know.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp

from gainproof.derive.expression import real

FUNCTIONS = {
    sp.sin: "sin",
    sp.cos: "cos",
    sp.exp: "exp",
    sp.atan2: "atan2",
    sp.Abs: "abs",
}
SQRT, OVER, PI = "sqrt", "over", "pi"


class NotReadError(ValueError):
    """An expression that a kernel cannot compute as it is written."""


@dataclass(frozen=True)
class Part:
    """`symbol` = `function` of the arguments."""

    symbol: sp.Symbol
    function: str
    arguments: tuple[sp.Expr, ...]

    def __str__(self) -> str:
        arguments = ", ".join(map(str, self.arguments))
        text = f"1/({arguments})" if self.function == OVER else f"{self.function}({arguments})"
        return f"{self.symbol} = {text}"


@dataclass
class Parts:
    """Reads expressions; equal parts are one. Powers of what is in `roots` are read as powers of
    its square root.
    """

    known: dict[tuple[str, tuple[sp.Expr, ...]], Part] = field(default_factory=dict)
    roots: frozenset[sp.Expr] = frozenset()

    def read(self, value: sp.Expr, roots: frozenset[sp.Expr] = frozenset()) -> sp.Expr:
        """The expression as a polynomial over inputs and parts; NotReadError names what is none
        of what a kernel can compute.
        """
        self.roots = roots
        return self._read(value)

    def _read(self, value: sp.Expr) -> sp.Expr:
        if isinstance(value, (sp.Rational, sp.Symbol)):
            return value
        if value is sp.pi:
            return self._part(PI)
        if isinstance(value, (sp.Add, sp.Mul)):
            return value.func(*map(self._read, value.args))
        if isinstance(value, sp.Pow) and isinstance(value.exp, sp.Rational):
            return self._power(value.base, value.exp)
        function = FUNCTIONS.get(value.func)
        if function is not None:
            return self._part(function, *map(self._read, value.args))
        known = ", ".join(sorted(FUNCTIONS.values()))
        raise NotReadError(
            f"+ - * /, whole powers, roots of order 2, 4, 8, ..., pi and {known} are what a kernel "
            f"computes, {value} came"
        )

    def _power(self, base: sp.Expr, exponent: sp.Rational) -> sp.Expr:
        if base in self.roots and exponent.q <= 2:
            root = self._part(SQRT, self._read(base))
            power = int(2 * exponent)
            return root**power if power > 0 else self._part(OVER, root) ** -power
        if exponent < 0:
            # one divisor at a time: a power of it is a power of one over it
            return self._part(OVER, self._power(base, -exponent))
        order = int(exponent.q)
        if order & (order - 1):
            raise NotReadError(f"a root of order 2, 4, 8, ... is wanted, {base**exponent} came")
        whole, rest = divmod(int(exponent.p), order)
        inner = self._read(base)
        root = inner
        while order > 1:
            root, order = self._part(SQRT, root), order // 2
        return inner**whole * root**rest

    def _part(self, function: str, *arguments: sp.Expr) -> sp.Symbol:
        key = function, arguments
        if key not in self.known:
            kind = OVER if function == OVER else "part"
            self.known[key] = Part(real(f"{kind}_{len(self.known) + 1}"), function, arguments)
        return self.known[key].symbol
