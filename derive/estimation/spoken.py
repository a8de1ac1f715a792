"""How steps on matrices are put together: meanings of letters, words, and statements that join."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import definition, described
from gainproof.derive.words.expression import Expression, symbol
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import Statement, prove_equal, prove_invertible

REGULAR = "matrix_invertible"
ON_THE_WAY = ("-transposed", "-spread", "-columns-1", "-columns-2")


def meanings(setting: Setting, names: str) -> list[Step]:
    """Definitions shown with the step before them: what letters of the setting stand for."""
    made = []
    for name in names.split():
        relation = definition(symbol(name).graph, setting.elements[name].graph)
        identifier = f"{setting.name}-{name.replace('_', '-').lower()}"
        made.append(joined(identifier, relation, setting.name))
    return made


def _on_the_way(step: Step) -> bool:
    """That what has an inverse has one, and the parts of an equation that is shown."""
    parts = step.relation.parts
    if step.relation.kind == REGULAR:
        return bool(parts["given"] == ({"kind": "invertible", "matrix": parts["matrix"]},))
    return step.id.endswith(ON_THE_WAY)


def said(
    setting: Setting, name: str, sentence: str, text: str, reason: str, heading: str = ""
) -> Step:
    """A definition in words."""
    return Step(name, sentence, described(text), reason, setting.name, heading=heading)


def together(statements: Sequence[Statement]) -> list[Step]:
    """Statements shown with the step before them, but for what is only on the way."""
    steps = [statement.step("", joins=True) for statement in statements]
    return [replace(step, shown=not _on_the_way(step)) for step in steps]


def by_columns(
    name: str, search: Search, left: Expression, right: Expression, size: str
) -> list[Statement]:
    """left = right, shown for the columns of each block of that size, then put together."""
    setting = search.setting
    blocks = setting.blocks[size]
    columns = [
        prove_equal(
            f"{name}-columns-{number}", fresh(search), left @ symbol(block), right @ symbol(block)
        )
        for number, block in enumerate(blocks, 1)
    ]
    one = setting.expand(left).shape
    assert one is not None
    unit = Expression("unit", one[0])
    taken = [
        (-(left - right), ("blocks", size), Expression("unit", size)),
        *((unit, column, symbol(block).T) for column, block in zip(columns, blocks, strict=True)),
    ]
    whole = prove_equal(name, Search(setting, aside=columns, taken=taken), left, right)
    return [*columns, whole]


def fresh(search: Search) -> Search:
    """The same search for another statement: what was needed is not shared."""
    return replace(search, used=set())


def known_inverse(
    name: str, letter: Expression, value: Expression, product: Statement
) -> list[Statement]:
    """The letter is invertible and its inverse is the value, as value letter = 1, the `product`."""
    setting = product.setting
    unit = Expression("unit", setting.shape(letter.value)[0])
    regular = prove_invertible(
        f"{name}-regular",
        Search(setting, aside=[product], taken=[(-unit, product, unit)]),
        letter.value,
        value,
    )
    same = prove_equal(
        name,
        Search(
            setting,
            aside=[product, regular],
            taken=[
                (-unit, product, letter.inverse),
                (value, ("inverse", regular.id, "right"), unit),
            ],
        ),
        letter.inverse,
        value,
    )
    return [regular, same]


def inverse_symmetric(
    name: str, matrix: Expression, regular: Statement, search: Search, sources: Sequence[Any]
) -> list[Statement]:
    """The inverse of A is symmetric, A' - A being the sum of these equations of the search."""
    setting = search.setting
    size = setting.shape(matrix.value)[0]
    unit, inverse = Expression("unit", size), matrix.inverse
    turned = prove_equal(
        f"{name}-transposed",
        Search(setting, using=[regular]),
        matrix.T @ inverse.T,
        unit_of(setting, size),
    )
    taken = [
        (-unit, ("inverse", regular.id, "left"), inverse.T),
        *((-inverse, source, inverse.T) for source in sources),
        (inverse, turned, unit),
    ]
    whole = replace(search, aside=[*search.aside, regular, turned], taken=taken, used=set())
    return [turned, prove_equal(name, whole, inverse.T, inverse)]


def unit_of(setting: Setting, size: str) -> Expression:
    """The unit matrix of that size by its name."""
    return next(symbol(name) for name, other in setting.units.items() if other == size)
