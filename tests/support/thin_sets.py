"""Random claims that have no value on a thin set of their domain, and the same with one everywhere.

A claim is made of a core, an expression of one to five symbols that is zero on a set of known
dimension and at a known point of the domain, and of a shape, a formula with that core under a
fraction, a root or a size. Claims of the other sort have a core that is nowhere zero, since a
positive number is added or the domain keeps away. What is true is known by construction; that the
core is zero at the point is computed anew in fractions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from small_claims import SmallClaim

Point = Mapping[str, Fraction]
LETTERS = ("a", "p", "s", "x", "y")
OTHERS = ("v", "w")
"""Symbols of the shapes, of which no core is made."""


@dataclass(frozen=True)
class Core:
    """An expression in LaTeX, its exact value at a rational point, a point where it is zero, and
    how many dimensions its zeros have; `signed` if it is negative somewhere.
    """

    latex: str
    value: Callable[[Point], Fraction]
    names: tuple[str, ...]
    zero: Point
    dimension: int
    signed: bool = False


def claims(seed: int, count: int, *, has_value: bool) -> Iterator[SmallClaim]:
    """So many claims, all kinds in turn; all of them true wherever they have a value."""
    random = Random(f"{seed}:{has_value}")
    for number in range(count):
        core = CORES[number % len(CORES)](random)
        yield _claim(core, SHAPES[random.randrange(len(SHAPES))], random, has_value)


def _claim(core: Core, shape: Shape, random: Random, has_value: bool) -> SmallClaim:
    while (shape.needs_sign and core.signed) or (has_value and core.signed):
        core = random.choice(CORES)(random)
    assert core.value(core.zero) == 0, core.latex
    text = core.latex
    if has_value:
        text = f"({text} + {random.choice(('1', '2', '0.5', '0.001'))})"
    domains = {name: _domain(name, core.zero[name], random) for name in core.names}
    for name in OTHERS:
        domains[name] = random.choice((f"domain = '-2 < {name} < 2', ", ""))
    dimension = f"dimension {core.dimension}"
    return made(shape, text, core.names, domains, dimension)


def made(
    shape: Shape, core: str, names: Sequence[str], domains: Mapping[str, str], sort: str
) -> SmallClaim:
    """The claim of that shape with a core in these symbols, of which the domains are lines of the
    declarations.
    """
    free: tuple[str, ...] = OTHERS if shape.setting == FILTER else ("t",)
    free += ("p_s", "p_k", "p_b") if shape.kind == "steady_state" else ()
    symbols = {
        name: f"{{ unit = '1', {domain}meaning = 'a number' }}"
        for name, domain in ({**domains, **dict.fromkeys(free, "")}).items()
    }
    symbols["j"] = "{ unit = '1', integer = true, meaning = 'an index' }"
    if shape.setting == FILTER:
        symbols["\\alpha"] = "{ quantity = 'filter_gain.1', meaning = 'gain' }"
    if shape.definition:
        symbols["g"] = f"{{ definition = '{shape.definition(core)}', meaning = 'short' }}"
    name = f"{shape.kind}, {len(names)} symbols, {sort}"
    return SmallClaim(shape.kind, shape.fields(core, names[0]), symbols, shape.setting, name)


def _domain(name: str, at: Fraction, random: Random) -> str:
    """A domain that holds the number, inside or at a closed end."""
    low, high = at - random.randint(1, 3), at + random.randint(1, 3)
    text = random.choice(
        (
            f"{low} < {name} < {high}",
            f"{low} \\leq {name} \\leq {high}",
            f"{name} > {low}",
            f"{name} \\leq {high}",
            f"{name} \\geq {at}",
            f"{at} \\leq {name} < {high}",
            f"{low} < {name} \\leq {at}",
        )
    )
    return f"domain = '{text}', "


# --- cores


def _names(random: Random, least: int, most: int = 5) -> tuple[str, ...]:
    return tuple(random.sample(LETTERS, random.randint(least, most)))


def _near(random: Random, names: Sequence[str]) -> dict[str, Fraction]:
    return {name: Fraction(random.randint(-2, 3), random.choice((1, 1, 2))) for name in names}


def _minus(name: str, value: Fraction) -> str:
    if value == 0:
        return name
    return f"{name} {'-' if value > 0 else '+'} {abs(value)}"


def squares_of_shifts(random: Random) -> Core:
    """A point: sum of c (x - a)^2 or c (x - a)^4."""
    names = _names(random, 1)
    zero = _near(random, names)
    weights = {n: random.randint(1, 3) for n in names}
    powers = {n: random.choice((2, 2, 2, 4)) for n in names}
    latex = " + ".join(f"{weights[n]} ({_minus(n, zero[n])})^{powers[n]}" for n in names)
    return Core(
        f"({latex})",
        lambda p: sum((weights[n] * (p[n] - zero[n]) ** powers[n] for n in names), Fraction(0)),
        names,
        zero,
        0,
    )


def expanded_squares(random: Random) -> Core:
    """The origin: x^2 + x y + y^2 + ..., with mixed terms."""
    names = _names(random, 2, 4)
    x, y, *rest = names
    latex = f"({x}^2 + {x} {y} + {y}^2" + "".join(f" + 2 {n}^2" for n in rest) + ")"

    def value(p: Point) -> Fraction:
        return p[x] ** 2 + p[x] * p[y] + p[y] ** 2 + sum(2 * p[n] ** 2 for n in rest)

    return Core(latex, value, names, dict.fromkeys(names, Fraction(0)), 0)


def squares_of_differences(random: Random) -> Core:
    """A subspace: sum of (x - y)^2 over some pairs."""
    names = _names(random, 2)
    count = random.randint(1, len(names) - 1)
    pairs = [(names[k], names[k + 1]) for k in range(count)]
    at = Fraction(random.randint(-1, 2))
    latex = " + ".join(f"({a} - {b})^2" for a, b in pairs)
    return Core(
        f"({latex})",
        lambda p: sum(((p[a] - p[b]) ** 2 for a, b in pairs), Fraction(0)),
        names[: count + 1],
        dict.fromkeys(names[: count + 1], at),
        1,
    )


def squares_of_forms(random: Random) -> Core:
    """A subspace: squares of fewer linear forms than symbols."""
    names = _names(random, 3, 4)
    zero = _near(random, names)
    x, y, *rest = names
    first, second = zero[x] - 2 * zero[y], zero[y] + zero[rest[-1]]
    latex = f"(({_minus(f'{x} - 2 {y}', first)})^2 + ({_minus(f'{y} + {rest[-1]}', second)})^2)"

    def value(p: Point) -> Fraction:
        return (p[x] - 2 * p[y] - first) ** 2 + (p[y] + p[rest[-1]] - second) ** 2

    used = (x, y, rest[-1])
    return Core(latex, value, used, {n: zero[n] for n in used}, 1)


def crossing_planes(random: Random) -> Core:
    """Two lines that cross: x^2 y^2 + z^2 + ..."""
    names = _names(random, 3, 4)
    x, y, *rest = names
    zero = _near(random, names) | {x: Fraction(0)} | dict.fromkeys(rest, Fraction(0))
    latex = f"({x}^2 {y}^2" + "".join(f" + {n}^2" for n in rest) + ")"

    def value(p: Point) -> Fraction:
        return p[x] ** 2 * p[y] ** 2 + sum(p[n] ** 2 for n in rest)

    return Core(latex, value, names, zero, 1)


def circles(random: Random) -> Core:
    """A circle, or a point on it: (x^2 + y^2 - 1)^2 + ..."""
    names = _names(random, 2, 3)
    x, y, *rest = names
    zero = _near(random, names) | {x: Fraction(3, 5), y: Fraction(4, 5)}
    latex = f"(({x}^2 + {y}^2 - 1)^2" + "".join(f" + ({_minus(n, zero[n])})^2" for n in rest) + ")"

    def value(p: Point) -> Fraction:
        return (p[x] ** 2 + p[y] ** 2 - 1) ** 2 + sum((p[n] - zero[n]) ** 2 for n in rest)

    return Core(latex, value, names, zero, 1)


def hyperplanes(random: Random) -> Core:
    """A hyperplane, or two that cross: x - y, (x - a) y."""
    names = _names(random, 1, 5)
    x, *rest = names
    zero = _near(random, names)
    if not rest:
        return Core(f"({_minus(x, zero[x])})", lambda p: p[x] - zero[x], names, zero, 0, True)
    if random.random() < 0.5:
        total = sum((zero[n] for n in names), Fraction(0))
        latex = f"({_minus(' + '.join(names), total)})"
        return Core(
            latex,
            lambda p: sum((p[n] for n in names), -total),
            names,
            zero,
            len(names) - 1,
            True,
        )
    latex = f"({_minus(x, zero[x])}) {rest[0]}"
    return Core(
        latex,
        lambda p: (p[x] - zero[x]) * p[rest[0]],
        (x, rest[0]),
        {n: zero[n] for n in (x, rest[0])},
        1,
        True,
    )


def sums_of_sizes(random: Random) -> Core:
    """A point: |x - a| + |y - b| + ..."""
    names = _names(random, 1, 3)
    zero = _near(random, names)
    latex = " + ".join(f"\\left| {_minus(n, zero[n])} \\right|" for n in names)
    return Core(
        f"({latex})",
        lambda p: sum((abs(p[n] - zero[n]) for n in names), Fraction(0)),
        names,
        zero,
        0,
    )


def norms(random: Random) -> Core:
    """A point: sqrt(x^2 + y^2 + ...)."""
    names = _names(random, 2, 4)
    zero = _near(random, names)
    latex = " + ".join(f"({_minus(n, zero[n])})^2" for n in names)

    def value(p: Point) -> Fraction:
        inside = sum(((p[n] - zero[n]) ** 2 for n in names), Fraction(0))
        return Fraction(0) if inside == 0 else Fraction(1)

    return Core(f"\\sqrt{{{latex}}}", value, names, zero, 0)


def sides_of_a_line(random: Random) -> Core:
    """A half line: sqrt(x^2 + y^2) - x."""
    names = _names(random, 2, 2)
    x, y = names
    zero = {x: Fraction(random.randint(0, 2)), y: Fraction(0)}

    def value(p: Point) -> Fraction:
        return Fraction(0) if p[y] == 0 and p[x] >= 0 else Fraction(1)

    return Core(f"(\\sqrt{{{x}^2 + {y}^2}} - {x})", value, names, zero, 1)


def cubics(random: Random) -> Core:
    """A point or a curve of higher degree: (x^3 - y)^2 + (y - 8)^2 + ..."""
    names = _names(random, 2, 3)
    x, y, *rest = names
    zero = _near(random, names) | {x: Fraction(2), y: Fraction(8)}
    more = random.random() < 0.5
    latex = f"(({x}^3 - {y})^2" + (f" + ({y} - 8)^2" if more else "")
    latex += "".join(f" + ({_minus(n, zero[n])})^2" for n in rest) + ")"

    def value(p: Point) -> Fraction:
        found = (p[x] ** 3 - p[y]) ** 2 + sum((p[n] - zero[n]) ** 2 for n in rest)
        return found + ((p[y] - 8) ** 2 if more else 0)

    return Core(latex, value, names, zero, 0 if more else 1)


CORES: tuple[Callable[[Random], Core], ...] = (
    squares_of_shifts,
    squares_of_differences,
    expanded_squares,
    squares_of_forms,
    crossing_planes,
    circles,
    hyperplanes,
    sums_of_sizes,
    norms,
    sides_of_a_line,
    cubics,
)

# --- shapes

ALGEBRA = "kind = 'algebra'"


@dataclass(frozen=True)
class Shape:
    """A formula around a core D, with a symbol x of it: true wherever D is not zero."""

    kind: str
    fields: Callable[[str, str], str]
    needs_sign: bool = False
    definition: Callable[[str], str] | None = None
    setting: str = ALGEBRA


FILTER = "kind = 'fixed_gain'\nstates = 2"
"""A filter with any gains, of which the shapes name the first."""


def _formula(
    kind: str, latex: str, *, needs_sign: bool = False, more: str = "", setting: str = ALGEBRA
) -> Shape:
    """A shape from LaTeX in which D is the core and X one of its symbols."""

    def fields(core: str, name: str) -> str:
        return f"latex = '{latex.replace('D', core).replace('X', name)}'{more}"

    return Shape(kind, fields, needs_sign, setting=setting)


def _trend(subject: str, *, needs_sign: bool = False) -> Shape:
    def fields(core: str, _: str) -> str:
        told = subject.replace("D", core)
        return f"about = ['{told}', 'v']\ntrend = 'increasing'\ntext = 'it rises'"

    return Shape("monotone", fields, needs_sign)


def _steady(core: str, _: str) -> str:
    return (
        f"latex = 'p_s = 2 \\frac{{{core}}}{{{core}}}'\n"
        f"recursion = 'p_k = \\frac{{p_b}}{{2}} + \\frac{{{core}}}{{{core}}}'\nprevious = 'p_b'"
    )


def _location(core: str, _: str) -> str:
    return (
        f"polynomial = 'z - \\frac{{{core}}}{{2 {core}}}'\nvariable = 'z'\n"
        "where = 'inside the unit circle'\ntext = 'a root'"
    )


SHAPES: tuple[Shape, ...] = (
    _formula("identity", r"\frac{X D}{D} = X"),
    _formula("identity", r"\frac{1}{D} + v = \frac{1 + v D}{D}"),
    _formula("identity", r"\frac{D^2}{D} = D"),
    _formula("identity", r"\sqrt{\frac{1}{D}} = \frac{1}{\sqrt{D}}", needs_sign=True),
    _formula("identity", r"\frac{\sqrt{D}}{\sqrt{D}} = 1", needs_sign=True),
    _formula("identity", r"\frac{\partial}{\partial v} \left( \frac{v X}{D} \right) = \frac{X}{D}"),
    _formula("identity", r"\frac{v D}{D} = v \quad (v > 0)"),
    _formula("identity", r"\frac{0}{D} = 0"),
    _formula("identity", r"\frac{1}{\frac{1}{D}} = D"),
    _formula("identity", r"\frac{1}{1 + \frac{1}{D}} = \frac{D}{D + 1}", needs_sign=True),
    _formula(
        "identity", r"\left| \frac{v}{D} \right| = \frac{\left| v \right|}{D}", needs_sign=True
    ),
    _formula("identity", r"\sum_{j=1}^{3} \frac{j D}{D} = 6"),
    _formula("identity", r"\int_{0}^{1} \frac{t D}{D} dt = \frac{1}{2}"),
    _formula(
        "identity",
        r"\frac{\partial^2}{\partial v^2} \left( \frac{v^2 X}{D} \right) = 2 \frac{X}{D}",
    ),
    _formula("identity", r"\frac{D v}{D w} w = v", more="\ngiven = ['w > 1']"),
    _formula("identity", r"\frac{D v}{D} = w", more="\ngiven = ['w = v']"),
    _formula("inequality", r"\sqrt{v^2 + \frac{D}{D}} \geq 1"),
    _formula("inequality", r"\frac{D}{D} > w", more="\ngiven = ['w < 1']"),
    _formula("inequality", r"0 < \frac{D}{D} \leq 1"),
    _formula("equivalence", r"\frac{1}{D} > 0 \Leftrightarrow D > 0", needs_sign=True),
    _formula("equivalence", r"\frac{D}{D} \leq 1 \Leftrightarrow v = v"),
    _formula("implication", r"\frac{D}{D} = v \Rightarrow v = 1"),
    _formula("identity", r"\alpha \frac{D}{D} = \alpha", setting=FILTER),
    _formula("inequality", r"\alpha^2 \frac{D}{D} \geq 0", setting=FILTER),
    _formula("equivalence", r"\frac{\alpha}{D} = 0 \Leftrightarrow \alpha = 0", setting=FILTER),
    _formula("inequality", r"\frac{1}{D} > 0", needs_sign=True),
    _formula("inequality", r"\frac{v^2}{D} \geq 0", needs_sign=True),
    _formula("inequality", r"\frac{D}{D} \leq 2"),
    _formula("inequality", r"\frac{D}{D} \geq 1"),
    _formula("inequality", r"\frac{D}{D} < 2"),
    _formula("inequality", r"\frac{D}{D} \neq 0"),
    _trend(r"v \frac{D}{D}"),
    _trend(r"\frac{v}{D}", needs_sign=True),
    _formula("equivalence", r"\frac{1}{D} \geq v \Leftrightarrow v D \leq 1", needs_sign=True),
    _formula("equivalence", r"\frac{v}{D} = 0 \Leftrightarrow v = 0"),
    _formula("equivalence", r"\frac{D}{D} = v \Leftrightarrow v = 1"),
    _formula("equivalence", r"v > w \Leftrightarrow v - w > \frac{0}{D}"),
    _formula("implication", r"v = 1 \Rightarrow \frac{D}{D} = v"),
    _formula("implication", r"\frac{v}{D} = 0 \Rightarrow v = 0"),
    _formula("implication", r"\frac{v}{D} > 0 \Rightarrow v > 0", needs_sign=True),
    _formula("limit", r"\frac{v D}{D} \to 0 \quad (v \to 0)"),
    _formula("limit", r"\frac{v + 1}{D} \to \frac{1}{D} \quad (v \to 0)"),
    _formula("asymptotics", r"\frac{v D}{D} = v + O(v^2) \quad (v \to 0)"),
    Shape("steady_state", _steady),
    Shape("identity", lambda *_: "latex = 'g = 1'", definition=lambda d: f"\\frac{{{d}}}{{{d}}}"),
    Shape("location", _location),
)
