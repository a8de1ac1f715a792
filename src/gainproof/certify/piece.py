"""A kernel's roundings on one piece of its domain, as definitions of Gappa.

The input is x = z^m. The value of an operation is x^q g with the exact q of `sizes`, so that only
terms of a sum hold z: what is left of x where they are not of the same power. Each rounding is a
factor 1 + e. Of the output's logarithm the derivative by that of the value of operation n is `l`n,
formed backwards: a term of a sum has its share w, what divides counts negative, a root one half.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import lcm

from gainproof.certify.gappa import Enclosure, dyadic
from gainproof.certify.operations import Operation
from gainproof.certify.sizes import Size

UNIT = Fraction(1, 2**53)
"""The largest relative error of a rounding to nearest of a number that is not subnormal."""
BESIDE_FAINT = 1 + Fraction(1, 2**40)
"""Times the error of a sum, where a term of at most 2^-100 of it may be lost."""


@dataclass(frozen=True)
class Section:
    """Operations up to the one that is bounded, the last, with the number of the kernel's input.

    `given`: enclosures of x^-q times the values of other inputs, which are held fixed; `known`: the
    same of operations, known otherwise, with `factors` of what their errors are over roundings.
    """

    operations: tuple[Operation, ...]
    argument: int
    sizes: Mapping[int, Size]
    given: Mapping[int, Enclosure]
    known: Mapping[int, Enclosure]
    factors: dict[int, Fraction]

    @property
    def root(self) -> int:
        """The m with which all x^q are whole powers of z."""
        return lcm(*(self.sizes[each.number].power.denominator for each in self.operations))


class Piece:
    """The definitions; those of operations that are `faint` may be anything from 0 to twice exact.

    Faint values have to be terms of sums in which they are of no account: `ratios` names what is
    to be small, by the numbers of the sums; `misplaced`: they are elsewhere. `sizes` names the
    values before they are rounded. `factors`: how often the usual error the e of some operations
    may be, of results next to subnormal numbers and of what is no rounding alone.
    """

    def __init__(
        self, section: Section, faint: Collection[int], factors: Mapping[int, Fraction]
    ) -> None:
        self.section, self.faint = section, faint
        own = {each.number: each.off for each in section.operations if each.off != 1}
        self.factors = {n: value for n, value in own.items() if value} | dict(factors)
        self.lines: list[str] = []
        self.powers: set[int] = set()
        self.given: list[str] = []
        self.ratios: dict[int, str] = {}
        self.sizes: dict[int, str] = {}
        self.rounded: list[int] = []
        self.exact: set[int] = set()
        self.misplaced = section.operations[-1].number in faint
        self.weights: dict[int, list[str]] = {}
        for operation in section.operations:
            self._value(operation)
        self._backwards()

    def definitions(self) -> str:
        """All, and `S`: the sum of the sizes of all l, each times its factor if it has one."""
        terms = [self._size(number) for number in self.rounded if self.weights.get(number)]
        return "".join(f"{line}\n" for line in [*self.lines, f"S = {' + '.join(['0b0', *terms])};"])

    def _size(self, number: int) -> str:
        factor = self.factors.get(number)
        return f"|l{number}|" if factor is None else f"|l{number}| * {dyadic(factor)}"

    def ask(self, name: str, number: int, power: Fraction, over: str) -> None:
        """Defines the value of an operation over x^power times something."""
        own = self.section.sizes[number].power - power
        self._put(f"{name} = {self._times(f'g{number} / ({over})', own)};")

    def _put(self, line: str) -> None:
        self.lines.append(line)

    def _power(self, number: int) -> str:
        """A power of z with a positive exponent."""
        if number == 1:
            return "z"
        if number not in self.powers:
            self.powers.add(number)
            half = self._power(number // 2)
            more = " * z" if number % 2 else ""
            self._put(f"p{number} = {half} * {half}{more};")
        return f"p{number}"

    def _times(self, text: str, power: Fraction) -> str:
        whole = int(power * self.section.root)
        if not whole:
            return text
        return f"{text} {'*' if whole > 0 else '/'} {self._power(abs(whole))}"

    def _between(self, one: int, other: int) -> Fraction:
        return self.section.sizes[one].power - self.section.sizes[other].power

    def _value(self, operation: Operation) -> None:
        n, parts = operation.number, operation.parts
        names = [f"g{part}" for part in parts]
        if operation.kind == "input":
            self.exact.add(n)
            if n == self.section.argument:
                self._put(f"g{n} = 1b0;")
            else:
                low, high = self.section.given[n]
                self.given.append(f"g{n} in [{dyadic(low)},{dyadic(high)}]")
            return
        match operation.kind:
            case "constant":
                text = dyadic(operation.factor)
            case "scale":
                text = f"{names[0]} * {dyadic(operation.factor)}"
            case "neg":
                text = f"-{names[0]}"
            case "sqrt":
                text = f"sqrt({names[0]})"
            case "mul" | "div":
                sign, turn = ("*", 1) if operation.kind == "mul" else ("/", -1)
                a, b = (self.section.sizes[part].power for part in parts)
                own = a + turn * b - self.section.sizes[n].power
                text = self._times(f"{names[0]} {sign} {names[1]}", own)
            case _:
                text = self._sum(operation)
        self._put(f"v{n} = {text};")
        if operation.kind != "constant":
            self.sizes[n] = f"V{n}"
            self._put(f"V{n} = {self._times(f'v{n}', self.section.sizes[n].power)};")
        rounded = operation.rounded or n in self.factors
        off = rounded or n in self.faint
        self._put(f"g{n} = v{n} * (1 + e{n});" if off else f"g{n} = v{n};")
        if off:
            size = Fraction(1) if n in self.faint else self.factors.get(n, Fraction(1)) * UNIT
            self.given.append(f"e{n} in [{dyadic(-size)},{dyadic(size)}]")
        if rounded and n not in self.faint:
            self.rounded.append(n)
        elif all(part in self.exact for part in parts) and n not in self.faint:
            self.exact.add(n)
        if n in self.section.known:
            low, high = self.section.known[n]
            self.given.append(f"g{n} in [{dyadic(low)},{dyadic(high)}]")
        if operation.kind == "neg" and parts[0] in self.faint:
            self.misplaced = True  # of others the results are found to be faint by their sizes

    def _sum(self, operation: Operation) -> str:
        n, (a, b) = operation.number, operation.parts
        sign = "+" if operation.kind == "add" else "-"
        left = self._times(f"g{a}", self._between(a, n))
        right = self._times(f"g{b}", self._between(b, n))
        if a in self.faint and b in self.faint:
            self.misplaced = True
        elif a in self.faint or b in self.faint:
            lost, kept = (a, b) if a in self.faint else (b, a)
            self._put(f"q{n} = {self._times(f'g{lost} / g{kept}', self._between(lost, kept))};")
            self.ratios[n], self.factors[n] = f"q{n}", BESIDE_FAINT
        return f"{left} {sign} {right}"

    def _backwards(self) -> None:
        operations: Sequence[Operation] = self.section.operations
        self.weights[operations[-1].number] = ["1b0"]
        for operation in reversed(operations):
            n = operation.number
            terms = self.weights.get(n)
            if n in self.exact or n in self.faint or not terms:
                self.weights.pop(n, None)
                continue
            self._put(f"l{n} = {' + '.join(terms)};")
            for part, text in self._shares(operation):
                self.weights.setdefault(part, []).append(text)

    def _shares(self, operation: Operation) -> Iterator[tuple[int, str]]:
        """Operands and what they add to their weights."""
        n, parts, weight = operation.number, operation.parts, f"l{operation.number}"
        match operation.kind:
            case "scale" | "neg":
                yield parts[0], weight
            case "sqrt":
                yield parts[0], f"{weight} * 1b-1"
            case "mul" | "div":
                yield parts[0], weight
                yield parts[1], weight if operation.kind == "mul" else f"(-{weight})"
            case "add" | "sub" if not all(part in self.exact for part in parts):
                a, b = parts
                sign = "+" if operation.kind == "add" else "-"
                if b in self.faint:
                    yield a, weight  # its share is 1 but for 2^-99, which MARGIN covers
                elif a in self.faint:
                    yield b, weight
                else:
                    ratio = self._times(f"(g{b} / g{a})", self._between(b, a))
                    self._put(f"w{n} = 1 / (1 {sign} {ratio});")
                    yield a, f"{weight} * w{n}"
                    yield b, f"{weight} * (1 - w{n})"
