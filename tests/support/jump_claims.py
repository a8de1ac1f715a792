"""Random claims on functions that jump, with their truth by mpmath.

A claim is a law of such functions, or one with a number, a relation or a function changed; the
letters in it are replaced by sums and multiples of x and y. Its truth is looked for at points of
the axes, the diagonals, the borders of whole turns and elsewhere: each is a rational number plus a
rational multiple of pi, so that whole numbers are told from numbers near by. Nothing of the judge
is used.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from random import Random
from typing import Any

import mpmath

DIGITS = 60
NEAR = mpmath.mpf(10) ** -40

Tree = Any
"""A letter, a number, "pi", or a name with its parts."""

Point = Mapping[str, tuple[Fraction, Fraction]]

LAWS: tuple[Tree, ...] = (
    ("=", ("max", "a", "b"), ("/", ("+", ("+", "a", "b"), ("abs", ("-", "a", "b"))), 2)),
    ("=", ("min", "a", "b"), ("/", ("-", ("+", "a", "b"), ("abs", ("-", "a", "b"))), 2)),
    ("=", ("+", ("max", "a", "b"), ("min", "a", "b")), ("+", "a", "b")),
    ("=", ("*", ("sign", "a"), ("abs", "a")), "a"),
    ("=", ("max", "a", 0), ("cases", "a", (">", "a", 0), 0)),
    ("=", ("min", ("max", "a", -1), 1), ("cases", -1, ("<", "a", -1), 1, (">", "a", 1), "a")),
    ("<=", ("min", "a", "b"), ("max", "a", "b")),
    ("=", ("abs", "a"), ("cases", "a", (">=", "a", 0), ("-", 0, "a"))),
    ("<=", ("floor", "a"), "a"),
    ("<", "a", ("+", ("floor", "a"), 1)),
    ("=", ("ceil", "a"), ("-", 0, ("floor", ("-", 0, "a")))),
    ("=", ("floor", ("+", "a", 3)), ("+", ("floor", "a"), 3)),
    ("=", ("+", ("floor", "a"), ("floor", ("+", "a", "1/2"))), ("floor", ("*", 2, "a"))),
    ("<=", ("-", ("ceil", "a"), ("floor", "a")), 1),
    ("<", ("mod", "a", 3), 3),
    (">=", ("mod", "a", 3), 0),
    ("=", ("mod", ("+", "a", 6), 3), ("mod", "a", 3)),
    ("=", ("-", ("mod", ("+", "a", "pi"), ("*", 2, "pi")), "pi"), ("WRAP", "a")),
    ("=", ("-", "pi", ("mod", ("-", "pi", "a"), ("*", 2, "pi"))), ("TURN", "a")),
    ("=", ("sin", ("WRAP", "a")), ("sin", "a")),
    ("=", ("cos", ("WRAP", "a")), ("cos", "a")),
    ("=", ("WRAP", ("+", "a", ("*", 4, "pi"))), ("WRAP", "a")),
    ("=", ("WRAP", ("WRAP", "a")), ("WRAP", "a")),
    ("<", ("WRAP", "a"), "pi"),
    (">=", ("WRAP", "a"), ("-", 0, "pi")),
    (
        "=",
        ("cases", ("MOD", "a"), ("<=", ("MOD", "a"), "pi"), ("-", ("MOD", "a"), ("*", 2, "pi"))),
        ("TURN", "a"),
    ),
    ("<=", ("atan2", "a", "b"), "pi"),
    (">", ("atan2", "a", "b"), ("-", 0, "pi")),
    ("=", ("atan2", ("*", 3, "a"), ("*", 3, "b")), ("atan2", "a", "b")),
    ("=", ("atan2", "a", ("abs", "b")), ("atan", ("/", "a", ("abs", "b")))),
    ("=", ("sin", ("atan2", "a", "b")), ("/", "a", ("HYPOT", "a", "b"))),
    ("=", ("cos", ("atan2", "a", "b")), ("/", "b", ("HYPOT", "a", "b"))),
    ("=", ("atan2", "a", "b"), ("*", 2, ("atan", ("/", "a", ("+", ("HYPOT", "a", "b"), "b"))))),
    ("=", ("cos", ("-", ("atan2", "a", "b"), "b")), ("cos", ("-", "b", ("atan2", "a", "b")))),
    ("=", ("abs", ("atan2", "a", "b")), ("atan2", ("abs", "a"), "b")),
    (
        "=",
        ("sign", ("atan2", "a", "b")),
        ("cases", 1, (">", "a", 0), -1, ("<", "a", 0), 0, (">", "b", 0), 1),
    ),
)
"""All true, where both sides have a value, of whatever the letters are."""
HALF = (
    ("=", ("atan2", ("-", 0, "a"), "b"), ("-", 0, ("atan2", "a", "b"))),
    ("=", ("atan2", "a", "b"), ("atan", ("/", "a", "b"))),
    ("=", ("+", ("atan2", "a", "b"), ("atan2", "b", "a")), ("/", "pi", 2)),
    ("=", ("-", ("mod", ("+", "a", "pi"), ("*", 2, "pi")), "pi"), ("TURN", "a")),
    ("=", ("mod", ("-", 0, "a"), 3), ("-", 3, ("mod", "a", 3))),
    ("=", ("TURN", "a"), "a"),
)
"""True on a part only."""
DOMAINS = (
    ((">", "x", 0), (">", "y", 0)),
    ((">=", "x", 0), ("<=", "y", 0)),
    (("<", "x", 0), ("<=", "y", 2), (">", "y", -3)),
    ((">", "x", ("-", 0, "pi")), ("<=", "x", "pi"), (">=", "y", -1)),
    ((">=", "x", ("-", 0, "pi")), ("<", "x", "pi"), (">", "y", ("-", 0, "pi")), ("<=", "y", "pi")),
    ((">=", "x", -1), ("<=", "x", 1), (">=", "y", -1), ("<=", "y", 1)),
    ((">=", "x", -3), ("<", "x", 7), ("<", "y", 0)),
)
"""Of both letters: where a side has no value, a claim fails on them."""
SWAPPED = {
    "max": "min", "min": "max", "floor": "ceil", "ceil": "floor", "<": "<=", "<=": "<",
    ">": ">=", ">=": ">", "sin": "cos", "cos": "sin",
}  # fmt: skip
PLACES = ("x", "y", ("+", "x", "y"), ("-", "x", "y"), ("*", 2, "x"), ("-", "x", 1), ("/", "x", 2))
TURN = ("*", 2, "pi")
SHORT: Mapping[str, Any] = {
    "TURN": lambda a: ("atan2", ("sin", a), ("cos", a)),
    "WRAP": lambda a: ("-", a, ("*", TURN, ("floor", ("/", ("+", a, "pi"), TURN)))),
    "MOD": lambda a: ("mod", a, ("*", 2, "pi")),
    "HYPOT": lambda a, b: ("sqrt", ("+", ("*", a, a), ("*", b, b))),
}  # fmt: skip


@dataclass(frozen=True)
class JumpClaim:
    """A relation in plain text, and a point at which it is false, if one is known; `lacks` where a
    side has no value at some point.
    """

    kind: str
    text: str
    domain: str
    false_at: str | None
    lacks: bool
    seen: int


def claims(seed: int, count: int) -> Iterator[JumpClaim]:
    """As many random claims."""
    random = Random(seed)
    for _ in range(count):
        law = random.choice(LAWS if random.random() < 0.85 else HALF)
        law = _long(law)
        if random.random() < 0.5:
            law = _changed(law, random)
        letters = dict(zip("ab", random.sample(PLACES, 2), strict=True))
        if law == _put(law, {"b": "c"}):
            letters["a"] = random.choice(PLACES)
        tree = _put(law, letters)
        yield _claim(tree, random.choice(DOMAINS) if random.random() < 0.4 else None)


def _claim(tree: Tree, domain: tuple[Tree, ...] | None) -> JumpClaim:
    false, lacks, seen = None, False, 0
    with mpmath.workdps(DIGITS):
        for x in VALUES:
            for y in VALUES:
                point = {"x": x, "y": y}
                if not all(_holds(condition, point) for condition in domain or ()):
                    continue
                try:
                    holds = _holds(tree, point)
                    seen += 1
                except ZeroDivisionError:
                    lacks = True
                    continue
                if not holds and false is None:
                    false = f"x = {x}, y = {y}"
    kind = "identity" if tree[0] == "=" else "inequality"
    said = " and ".join(map(written, domain or ()))
    return JumpClaim(kind, written(tree), said, false, lacks, seen)


PLACED: tuple[tuple[int | str, int | str], ...] = (
        (0, 0), (1, 0), (-1, 0), (2, 0), (-2, 0), (3, 0), (-3, 0), ("1/2", 0), ("-1/2", 0),
        ("3/2", 0),
        ("-7/3", 0), ("22/7", 0), (0, 1), (0, -1), (0, "1/2"), (0, "-1/2"), (0, 2), (0, "3/2"),
        (1, 1), (-1, 1), (1, -1), ("31/5", 0), (7, 0), (-9, 0), ("1/10", -3), (1, 4), (0, 7),
    )  # fmt: skip
"""r and q of r + q pi."""
VALUES = [(Fraction(r), Fraction(q)) for r, q in PLACED]


def _long(tree: Tree) -> Tree:
    if not isinstance(tree, tuple):
        return tree
    name, *parts = tree
    parts = [_long(part) for part in parts]
    return SHORT[name](*parts) if name in SHORT else (name, *parts)


def _put(tree: Tree, letters: dict[str, Tree]) -> Tree:
    if isinstance(tree, tuple):
        return (tree[0], *[_put(part, letters) for part in tree[1:]])
    return letters.get(tree, tree) if isinstance(tree, str) else tree


def _changed(tree: Tree, random: Random) -> Tree:
    """With a number, a relation, a function or a sign changed somewhere."""
    places = list(_places(tree, ()))
    return _at(tree, random.choice(places), random) if places else tree


def _places(tree: Tree, path: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    if isinstance(tree, int) or tree == "pi":
        yield path
    if isinstance(tree, tuple):
        if tree[0] in SWAPPED or tree[0] in ("+", "-"):
            yield path
        for k, part in enumerate(tree[1:], start=1):
            yield from _places(part, (*path, k))


def _at(tree: Tree, path: tuple[int, ...], random: Random) -> Tree:
    if path:
        k, *rest = path
        return (*tree[:k], _at(tree[k], tuple(rest), random), *tree[k + 1 :])
    if tree == "pi":
        return ("*", 2, "pi")
    if isinstance(tree, int):
        return tree + random.choice((1, -1)) or 1
    if tree[0] in SWAPPED:
        return (SWAPPED[tree[0]], *tree[1:])
    return ({"+": "-", "-": "+"}[tree[0]], *tree[1:])


def written(tree: Tree) -> str:
    """Plain text."""
    if not isinstance(tree, tuple):
        return f"({tree})" if str(tree).startswith("-") or "/" in str(tree) else str(tree)
    name, *parts = tree
    if name == "cases":
        return f"cases({_cases(parts)})"
    texts = [written(part) for part in parts]
    if name in ("+", "-", "*", "/"):
        return f"({f' {name} '.join(texts)})" if tree[1] != 0 or name != "-" else f"(-{texts[1]})"
    if name in ("=", "<", "<=", ">", ">="):
        return f"{texts[0]} {name} {texts[1]}"
    return f"{name}({', '.join(texts)})"


def _cases(parts: list[Tree]) -> str:
    lines = [f"{written(v)}, {written(c)}" for v, c in zip(parts[::2], parts[1::2], strict=False)]
    return "; ".join([*lines, *([written(parts[-1])] if len(parts) % 2 else [])])


def _holds(tree: Tree, point: Point) -> bool:
    name, left, right = tree
    a, b = value(left, point), value(right, point)
    gap = 0 if abs(a - b) < NEAR else a - b
    return {"=": gap == 0, "<": gap < 0, "<=": gap <= 0, ">": gap > 0, ">=": gap >= 0}[name]


def value(tree: Tree, point: Point) -> Any:
    """The value at a point. Raises ZeroDivisionError where there is none."""
    if isinstance(tree, str) and tree in point:
        r, q = point[tree]
        return mpmath.mpf(r.numerator) / r.denominator + mpmath.pi * q.numerator / q.denominator
    if not isinstance(tree, tuple):
        number = mpmath.pi if tree == "pi" else Fraction(tree)
        return +number if tree == "pi" else mpmath.mpf(number.numerator) / number.denominator
    name, *parts = tree
    if name == "cases":
        return next(
            value(v, point)
            for v, c in zip(parts[::2], [*parts[1::2], None], strict=False)
            if c is None or _holds(c, point)
        )
    return _of(name, [value(part, point) for part in parts])


def _of(name: str, parts: list[Any]) -> Any:
    a = mpmath.mpf(0) if abs(parts[0]) < NEAR else parts[0]
    b = None if len(parts) < 2 else mpmath.mpf(0) if abs(parts[1]) < NEAR else parts[1]
    match name:
        case "+":
            return a + b
        case "-":
            return a - b
        case "*":
            return a * b
        case "/":
            return a / b
        case "abs":
            return abs(a)
        case "max" | "min":
            return {"max": max, "min": min}[name](a, b)
        case "sign":
            return mpmath.sign(a)
        case "floor" | "ceil":
            return _whole(a, name)
        case "mod":
            return a - b * _whole(a / b, "floor")
        case "sqrt" if a < 0:
            raise ZeroDivisionError
        case "atan2":
            if a == b == 0:
                raise ZeroDivisionError
            return mpmath.atan2(a, b)
    return getattr(mpmath, name)(a)


def _whole(a: Any, name: str) -> Any:
    near = mpmath.nint(a)
    return near if abs(a - near) < NEAR else getattr(mpmath, name)(a)
