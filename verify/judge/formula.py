"""What the reader hands over: a formula as relations between expression graphs, one list of them
for each reading.

Plain data only. An expression graph is `{"nodes": [...], "outputs": {"value": number}}` with nodes

    ["number", "p/q"]  ["symbol", name]  ["add", i, j, ...]  ["mul", i, j, ...]
    ["div", i, j]  ["neg", i]  ["pow", i, "p/q"]  ["call", name, i, ...]
    ["derivative", i, symbol]  ["at", i, symbol, j]
    ["matrix", rows, columns, i, ...]  ["transpose", i]  ["inverse", i]  ["kronecker", i, j]

in which node numbers refer to earlier nodes and the name of a symbol is its canonical LaTeX token,
for example `\\dot{x}_{sk-1}`. Equal subexpressions share one node and nodes are numbered as they
are met from left to right, so two graphs are equal when they were read from formulas that differ in
spelling only. Factors keep their order, since they may be matrices; entries of a matrix may be
matrices.

Calls made by the reader: `abs(x)`, `sum(summand, index, lower, upper)`, `product` and
`integral(integrand, variable, lower, upper)` likewise, `expectation(x)`, `order(x)` for O(x),
`power(base, exponent)` where the exponent is no number, the named functions of `reader.words`, and
the functions that a claim file declares. `["symbol", "infinity"]` may be a bound or the value of an
`at`, `["call", "pi"]` is the number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

Graph = Mapping[str, Any]
Decimals = int | tuple[int, ...]
"""Decimals shown by a number, or by each entry of a matrix of numbers, row by row."""

INFINITY: Graph = {"nodes": [["symbol", "infinity"]], "outputs": {"value": 0}}
"""The right side of `k \\to \\infty`. No declared symbol can have this name."""

MINUS_INFINITY: Graph = {"nodes": [["symbol", "infinity"], ["neg", 0]], "outputs": {"value": 1}}


@dataclass(frozen=True)
class Relation:
    """`left operator right`; the operator is one of `=`, `!=`, `<`, `<=`, `>`, `>=`, `approx`,
    `sim` (asymptotically equal), `propto`, `->`.

    A chain `a = b = c` is given as `a = b` and `b = c`. Where a side is a number as printed, its
    count of decimals is kept: 2 for `0.50`, 5 for `3.0 \\times 10^{-4}`, 0 for `7`, -3 for
    `2 \\times 10^3`; of a matrix of such numbers the counts of its entries.
    """

    operator: str
    left: Graph
    right: Graph
    left_decimals: Decimals | None = None
    right_decimals: Decimals | None = None


@dataclass(frozen=True)
class Reading:
    """One way to read a formula: all of `relations` are said to hold where all of `conditions` do.

    `connective` is `if` for conditions in a trailing parenthesis or after a word such as `for`, and
    for the `x \\to a` of a `\\lim`; `iff` for `A \\Leftrightarrow B`
    and `implies` for `A \\Rightarrow B`; in the latter two `relations` is A and `conditions` is B.
    Without conditions it is `if`. `text` names the reading, and is None when the formula has only
    this one. `taken` says what else was read in one way and has others, `chains` what long chains
    say: words about the print, in which equal formulas may differ.
    """

    relations: tuple[Relation, ...]
    conditions: tuple[Relation, ...] = ()
    connective: str = "if"
    text: str | None = None
    taken: tuple[str, ...] = field(default=(), compare=False)
    chains: tuple[str, ...] = field(default=(), compare=False)


@dataclass(frozen=True)
class Formula:
    """A formula as printed and its readings: several only where a slash stands before juxtaposed
    factors, or a bar `|_{x=0}` behind several.

    `symbols` are the canonical tokens met, in order of appearance.
    """

    latex: str
    readings: tuple[Reading, ...]
    symbols: tuple[str, ...] = field(default=())
