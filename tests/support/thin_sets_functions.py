"""Random claims with functions that have no value on a thin set of their domain, and the same with
one everywhere: the shapes of `thin_sets` round other cores.

A core is a sum of terms, each of a symbol of its own, that are nowhere below 0 and vanish at one
place of a stated domain: 1 + cos a at a = pi. The core vanishes where all its terms do. Claims of
the other sort have a core to which a positive number is added.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random

from mpmath import atan, cos, e, exp, log, mpf, pi, sin, tan
from small_claims import SmallClaim
from thin_sets import FILTER, LETTERS, OTHERS, SHAPES, Shape, made

Number = Callable[[mpf], mpf]


@dataclass(frozen=True)
class Term:
    """In LaTeX and as a function of the symbol X, 0 at `zero` in each of the domains."""

    latex: str
    value: Number
    zero: mpf
    domains: tuple[str, ...]


NEAR_0 = ("-1 < X < 1", r"0 \leq X < 1", r"X \leq 0", "-X < 1")
NEAR_PI = ("3 < X < 4", "-1 < X < 4", r"0 \leq X \leq \pi", r"\frac{\pi}{2} < X < 5")
RIGHT = ("1 < X < 2", r"0 < X \leq \frac{\pi}{2}", r"0 \leq X < \pi")
TERMS: tuple[Term, ...] = (
    Term(r"(1 + \cos X)", lambda x: 1 + cos(x), pi, NEAR_PI),
    Term(r"(1 - \cos X)", lambda x: 1 - cos(x), mpf(0), NEAR_0[:2]),
    Term(r"(1 - \sin X)", lambda x: 1 - sin(x), pi / 2, RIGHT),
    Term(r"(1 + \cos 2 X)", lambda x: 1 + cos(2 * x), pi / 2, RIGHT),
    Term(r"\sin^2 X", lambda x: sin(x) ** 2, pi, NEAR_PI[:1]),
    Term(r"\cos^2 X", lambda x: cos(x) ** 2, pi / 2, RIGHT),
    Term(r"\tan^2 X", lambda x: tan(x) ** 2, mpf(0), NEAR_0[:2]),
    Term(r"(\ln X)^2", lambda x: log(x) ** 2, mpf(1), ("X > 0", "0 < X < 3", r"X \geq 1")),
    Term(r"(1 - \ln X)^2", lambda x: (1 - log(x)) ** 2, +e, ("X > 0", "2 < X < 3")),
    Term(r"(e^X - 1)^2", lambda x: (exp(x) - 1) ** 2, mpf(0), NEAR_0),
    Term(r"(e^X - 3)^2", lambda x: (exp(x) - 3) ** 2, log(3), ("X > 0", "1 < X < 2")),
    Term(r"\left| e^X - 2 \right|", lambda x: abs(exp(x) - 2), log(2), ("X > 0", "0 < X < 1")),
    Term(r"(\arctan X)^2", lambda x: atan(x) ** 2, mpf(0), NEAR_0),
)
"""Each of a function, 0 as said by hand."""
PLAIN: tuple[Term, ...] = (
    Term("X^2", lambda x: x**2, mpf(0), NEAR_0),
    Term("(X - 2)^2", lambda x: (x - 2) ** 2, mpf(2), ("1 < X < 3", r"X \geq 2")),
    Term(r"\left| X \right|", abs, mpf(0), NEAR_0),
)


def _lines(kind: str, latex: str) -> Shape:
    return Shape(kind, lambda core, _: f"latex = '{latex.replace('D', core)}'", needs_sign=True)


FURTHER: tuple[Shape, ...] = (
    _lines("inequality", "D > 0"),
    _lines("inequality", r"D \neq 0"),
    _lines("identity", r"\ln \frac{1}{D} = -\ln D"),
    _lines("identity", r"\ln D - \ln D = 0"),
    _lines("identity", r"\frac{1}{\sqrt{D}} \sqrt{D} = 1"),
    _lines("inequality", r"\left( \ln D \right)^2 \geq 0"),
)
"""True wherever the core is above 0, too."""


def claims(seed: int, count: int, *, has_value: bool, most: int = 5) -> Iterator[SmallClaim]:
    """So many claims, with at most so many symbols in a core; all of them true wherever they have a
    value and the core is not 0.
    """
    random = Random(f"functions {seed}:{has_value}")
    for _ in range(count):
        shape = random.choice((*SHAPES, *FURTHER, *FURTHER))
        size = min(most, random.choice((1, 1, 2, 2, 3, 4, 5)))
        yield _claim(shape, size, random, has_value)


def _claim(shape: Shape, size: int, random: Random, has_value: bool) -> SmallClaim:
    names = random.sample(LETTERS, size)
    terms = [random.choice(TERMS), *random.choices((*TERMS, *PLAIN), k=len(names) - 1)]
    core = " + ".join(
        random.choice(("", "", "2 ", "3 ")) + term.latex.replace("X", name)
        for term, name in zip(terms, names, strict=True)
    )
    core = f"({core} + {random.choice(('1', '2', '0.5'))})" if has_value else f"({core})"
    domains = {
        name: f"domain = '{random.choice(term.domains).replace('X', name)}', "
        for term, name in zip(terms, names, strict=True)
    }
    for name in OTHERS if shape.setting != FILTER else ():
        domains[name] = random.choice((f"domain = '-2 < {name} < 2', ", ""))
    return made(shape, core, names, domains, "with functions")
