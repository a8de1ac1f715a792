"""Small claims of many kinds drawn at random: true, false, true on a part, without values."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from small_claims import SmallClaim

NAMES = ("x", "y", "z")
FUNCTIONS = (r"\sin", r"\cos", r"\exp", r"\ln", r"\arctan")
DOMAINS = (
    "-1 < {0} < 1",
    r"0 \leq {0} < 2",
    "{0} > 0",
    r"-2 \leq {0} \leq 2",
    "",
)
ORDERS = ("=", "=", "=", r"\leq", "<", r"\neq", ">", r"\geq")


def drawn_claims(seed: int, count: int) -> Iterator[SmallClaim]:
    """Claims in one to three symbols, of every kind that compares two sides."""
    chance = Random(seed)
    for _ in range(count):
        yield _claim(chance)


def _claim(chance: Random) -> SmallClaim:
    names = NAMES[: chance.choice((1, 1, 1, 2, 2, 3))]
    domains = [chance.choice(DOMAINS).format(name) for name in names]
    stated = ", ".join(d for d in domains if d)
    kind = chance.choice(("identity", "identity", "inequality", "equivalence", "implication"))
    if chance.random() < 0.1:
        subject, trend = _expression(chance, names, 1), chance.choice(("increasing", "decreasing"))
        fields = f"about = ['{subject}', '{names[0]}']\ntrend = '{trend}'\ntext = 'in words'"
        return SmallClaim("monotone", _with(fields, stated))
    first = _relation(chance, names)
    if kind in ("equivalence", "implication"):
        arrow = r"\iff" if kind == "equivalence" else r"\implies"
        second = _relation(chance, names) if chance.random() < 0.7 else _again(chance, first)
        return SmallClaim(kind, _with(f"latex = '{first} {arrow} {second}'", stated))
    is_equation = any(f" {order} " in first for order in ("=",))
    return SmallClaim(
        "identity" if is_equation else "inequality", _with(f"latex = '{first}'", stated)
    )


def _with(fields: str, stated: str) -> str:
    return f"{fields}\ndomain = '{stated}'" if stated else fields


def _relation(chance: Random, names: tuple[str, ...]) -> str:
    left = _expression(chance, names, chance.choice((1, 1, 2)))
    order = chance.choice(ORDERS)
    form = chance.random()
    if form < 0.35:
        right = _same(chance, left, names)
    elif form < 0.6:
        right = str(chance.choice((-1, 0, 1, 2)))
    else:
        right = _expression(chance, names, 1)
    return f"{left} {order} {right}"


def _again(chance: Random, relation: str) -> str:
    return relation if chance.random() < 0.5 else relation.replace("<", ">", 1)


def _same(chance: Random, of: str, names: tuple[str, ...]) -> str:
    """The same, or nearly, where a divisor or root that was put in has a value."""
    part = chance.choice((*names, _expression(chance, names, 0)))
    return chance.choice(
        (
            rf"\frac{{({of}) ({part})}}{{{part}}}",
            rf"{of} + 0 \cdot ({part})",
            rf"({of}) \cdot \frac{{\sqrt{{({part})^2}}}}{{\left|{part}\right|}}",
            rf"({of}) \cdot \frac{{\sqrt{{({part})^2}}}}{{{part}}}",
            rf"{of} + \sqrt{{{part}}} - \sqrt{{{part}}}",
        )
    )


def _expression(chance: Random, names: tuple[str, ...], depth: int) -> str:
    if depth == 0:
        first, second = chance.choice(names), chance.choice(names)
        return chance.choice(
            (first, first, f"{first} - {second}", f"{first}^2", f"1 + {first}", f"{first} {second}")
        )
    inner = [_expression(chance, names, depth - 1) for _ in range(2)]
    form = chance.randrange(9)
    if form == 0:
        return rf"\frac{{{inner[0]}}}{{{inner[1]}}}"
    if form == 1:
        return rf"\sqrt{{{inner[0]}}}"
    if form == 2:
        return rf"\left|{inner[0]}\right|"
    if form == 3:
        return rf"({inner[0]}) \cdot ({inner[1]})"
    if form == 4:
        return rf"{chance.choice(FUNCTIONS)}({inner[0]})"
    if form == 5:
        by = chance.choice(names)
        # in brackets of its own: a factor may follow
        return rf"(\frac{{\partial}}{{\partial {by}}} ({inner[0]} \cdot \left|{by}\right|))"
    if form == 6:
        return rf"\sum_{{j=1}}^{{3}} ({inner[0]})^{{j-1}}"
    return f"{inner[0]} + {inner[1]}" if form == 7 else f"({inner[0]})^{chance.choice((2, 3))}"
