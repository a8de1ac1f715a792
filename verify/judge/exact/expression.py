"""Expression trees: immutable, shared, equal exactly when they are written alike.

The constructors change nothing: `0 * (1/0)` stays as it is, so that a division by zero inside a
product with zero is still found.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from hashlib import blake2b

Value = Fraction | str | None


@dataclass(frozen=True, eq=False, slots=True)
class Expr:
    """One node: `kind` is number, symbol, add, mul, div, neg, pow, call, derivative or at; in a
    formula as read also matrix, transpose, inverse or kronecker.

    `value` is the number, the name of the symbol or function, the exponent of a power, the symbol
    of a derivative or substitution, or "rows columns" of a matrix. `key` is a digest of the whole
    tree: comparison takes constant time however much is shared.
    """

    kind: str
    value: Value
    parts: tuple[Expr, ...]
    key: bytes = field(init=False, repr=False)

    def __post_init__(self) -> None:
        # lengths are written, so that no name can imitate another node
        value, parts = str(self.value), self.parts
        text = f"{self.kind}|{len(value)}|{value}|{len(parts)}|".encode()
        whole = b"".join([text, *[part.key for part in parts]]) if parts else text
        object.__setattr__(self, "key", blake2b(whole, digest_size=32).digest())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Expr) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)

    def __add__(self, other: Expr | int) -> Expr:
        return add(self, as_expr(other))

    def __radd__(self, other: int) -> Expr:
        return add(number(other), self)

    def __sub__(self, other: Expr | int) -> Expr:
        return add(self, neg(as_expr(other)))

    def __rsub__(self, other: int) -> Expr:
        return add(number(other), neg(self))

    def __mul__(self, other: Expr | int | Fraction) -> Expr:
        return mul(self, as_expr(other))

    def __rmul__(self, other: int | Fraction) -> Expr:
        return mul(number(other), self)

    def __truediv__(self, other: Expr | int) -> Expr:
        return div(self, as_expr(other))

    def __rtruediv__(self, other: int) -> Expr:
        return div(number(other), self)

    def __neg__(self) -> Expr:
        return neg(self)

    def __pow__(self, exponent: int | Fraction) -> Expr:
        return power(self, exponent)

    @property
    def fraction(self) -> Fraction:
        """The number of a `number`, the exponent of a `pow`."""
        if not isinstance(self.value, Fraction):
            raise TypeError(f"a {self.kind} carries no number")
        return self.value

    @property
    def name(self) -> str:
        """The name of a symbol, function, or the symbol of a derivative."""
        if not isinstance(self.value, str):
            raise TypeError(f"a {self.kind} carries no name")
        return self.value


def as_expr(x: Expr | int | Fraction) -> Expr:
    """Numbers become expressions."""
    return x if isinstance(x, Expr) else number(x)


def number(value: int | Fraction | str) -> Expr:
    """A rational number."""
    return Expr("number", Fraction(value), ())


def symbol(name: str) -> Expr:
    """A symbol."""
    return Expr("symbol", name, ())


def add(*terms: Expr) -> Expr:
    """Sum of one term or more."""
    return terms[0] if len(terms) == 1 else Expr("add", None, terms)


def mul(*factors: Expr) -> Expr:
    """Product of one factor or more."""
    return factors[0] if len(factors) == 1 else Expr("mul", None, factors)


def div(numerator: Expr, denominator: Expr) -> Expr:
    """Quotient."""
    return Expr("div", None, (numerator, denominator))


def neg(x: Expr) -> Expr:
    """Opposite."""
    return Expr("neg", None, (x,))


def power(base: Expr, exponent: int | Fraction) -> Expr:
    """Rational power; 1/2 is the root that is not negative, 1/3 the real cube root."""
    return Expr("pow", Fraction(exponent), (base,))


def sqrt(x: Expr) -> Expr:
    """Square root that is not negative."""
    return power(x, Fraction(1, 2))


def absolute(x: Expr) -> Expr:
    """|x|."""
    return sqrt(power(x, 2))


def weighted(coefficients: Sequence[int | Fraction], terms: Sequence[Expr]) -> Expr:
    """Sum of coefficient * term; terms with coefficient zero and factors one are left out."""
    one = number(1)
    kept = []
    for c, t in zip(coefficients, terms, strict=True):
        if c != 0:
            factors = t.parts if t.kind == "mul" else (t,)
            size = number(c if c > 0 else -c)
            made = t if abs(c) == 1 else size if t == one else mul(size, *factors)
            kept.append(made if c > 0 else neg(made))
    return add(*kept) if kept else number(0)


def whole_power(base: Expr, exponent: int) -> Expr:
    """base^exponent for a base that has a value everywhere: exponents 0 and 1 are not written."""
    if exponent == 0:
        return number(1)
    return base if exponent == 1 else power(base, exponent)


def walk(*roots: Expr, known: Container[bytes] = ()) -> Iterator[Expr]:
    """Every distinct node below the roots, parts before wholes, without those whose keys are
    `known` and what is below these alone.
    """
    seen: set[bytes] = set()
    stack = list(reversed(roots))
    while stack:
        node = stack[-1]
        key = node.key
        if key not in seen and key not in known:
            if node.parts:
                first = [p for p in node.parts[::-1] if p.key not in seen and p.key not in known]
                if first:
                    stack += first
                    continue
            seen.add(key)
            yield node
        stack.pop()


def symbols_of(*roots: Expr) -> set[str]:
    """Names of all symbols below the roots."""
    found: set[str] = set()
    seen: set[bytes] = set()
    stack = list(roots)
    while stack:
        node = stack.pop()
        if node.kind == "symbol":
            found.add(node.name)
        elif node.parts and node.key not in seen:
            seen.add(node.key)
            stack += node.parts
    return found
