"""Each part of the projection is needed: without it a false statement comes out as proved."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest

from gainproof.verify.judge.cells import cells_and_borders as pieces_module
from gainproof.verify.judge.cells import projection as projection_module
from gainproof.verify.judge.cells.critical_polynomials import CellQuestion
from gainproof.verify.judge.cells.decision import decide_in_cells
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import number, power, sqrt, symbol
from gainproof.verify.judge.exact.polynomial import constant
from gainproof.verify.judge.exact.statement import Rel, Statement

x, y = symbol("x"), symbol("y")
zero = number(0)


def box(lower: int, upper: int | None = None) -> Box:
    return Box(lower=Fraction(lower), upper=None if upper is None else Fraction(upper))


def nothing(*_: Any) -> list[Any]:
    return []


def always(*_: Any, **__: Any) -> bool:
    return True


def one(p: Any, _: int) -> Any:
    return constant(p.context(), 1)


FROM_ZERO = Box(lower=Fraction(0), lower_open=False)
CASES: tuple[tuple[str, Any, str, Callable[..., Any], Rel, dict[str, Box]], ...] = (
    # the parabola leaves the box through its upper face, above the sample x = 1
    ("faces", projection_module, "face_values", nothing,
     Rel("<=", y, power(x, 2)), {"x": box(0, 2), "y": box(0, 1)}),
    # two lines cross beside the sample y = 1, where their product has a double zero
    ("resultants", projection_module, "resultants", nothing,
     Rel("<=", (y - x) * (y + x - 2), zero), {"x": Box(), "y": box(0, 3)}),
    # a small disc beside the sample y = 1
    ("discriminants", projection_module, "discriminants", nothing,
     Rel(">=", power(x, 2) + power(y - 2, 2), number(Fraction(1, 100))),
     {"x": Box(), "y": box(0, 3)}),
    # a hyperbola that comes from infinity at the sample y = 0
    ("leading coefficients", projection_module, "leading", one,
     Rel("<=", x * y, number(1)), {"x": box(0), "y": box(-3, 1)}),
    # equality on a line that no cell touches
    ("borders", CellQuestion, "borders", nothing,
     Rel("<", zero, power(x - y, 2)), {"x": box(0), "y": box(0)}),
    # a border that is met only on closed faces
    ("closed faces", pieces_module, "keeps_sign", always,
     Rel("<", zero, x + y), {"x": FROM_ZERO, "y": FROM_ZERO}),
    # where the radicand is negative there is no value
    ("radicands", CellQuestion, "of_checks", nothing,
     Rel("=", power(sqrt(x - y), 2), x - y), {"x": box(1), "y": box(0)}),
)  # fmt: skip


@pytest.mark.parametrize(
    ("target", "name", "broken", "rel", "boxes"), [c[1:] for c in CASES], ids=[c[0] for c in CASES]
)
def test_without_it_a_false_statement_is_proved(
    target: Any,
    name: str,
    broken: Callable[..., Any],
    rel: Rel,
    boxes: dict[str, Box],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert decide_in_cells(Statement((rel,)), boxes).verdict == "conditional"
    monkeypatch.setattr(target, name, broken)
    assert decide_in_cells(Statement((rel,)), boxes).verdict == "proved"
