"""Pictures of kernels: the truth that errors are measured against is known, or they are refused."""

from __future__ import annotations

from typing import Any

import pytest

from gainproof.bench.accuracy import ball_outputs
from gainproof.book import sampled_kernel
from gainproof.book.sampled_kernel import sampled
from gainproof.generated import random_velocity

NESTED: dict[str, Any] = {
    "nodes": [
        ["symbol", "c"],
        ["call", "unknown", 0, 0],
        ["mul", 0, 1],
        ["pow", 2, "1/2"],
        ["call", "fixed_point", 1, 3, 3],  # x = sqrt(c x): c
        ["call", "unknown", 4, 0],
        ["mul", 4, 4, 4, 4, 5],
        ["pow", 6, "1/2"],
        ["call", "fixed_point", 5, 7, 7],  # y = sqrt(x^4 y): c^4
    ],
    "outputs": {"y": 8},
}
SLOW: dict[str, Any] = {
    "nodes": [
        ["symbol", "c"],
        ["call", "unknown", 0, 0],
        ["mul", 1, 1, 1, 1, 1, 1, 1, 0],
        ["pow", 2, "1/2"],
        ["pow", 3, "1/2"],
        ["pow", 4, "1/2"],
        ["call", "fixed_point", 1, 5, 5],  # x = (c x^7)^(1/8): c, of slope 7/8 there
    ],
    "outputs": {"x": 6},
}


@pytest.mark.parametrize(("graph", "name"), [(NESTED, "y"), (SLOW, "x")])
@pytest.mark.parametrize("c", [3.0, 2.0**-30, 2.0**40])
def test_fixed_points_are_enclosed(graph: dict[str, Any], name: str, c: float) -> None:
    found = ball_outputs(graph, {"c": c})[name]
    assert found.contains(c**4 if name == "y" else c)
    assert found.rel_accuracy_bits() > 80


def test_a_truth_that_is_not_known_is_no_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    kernel = {
        "name": "gains",
        "outputs": [
            {"name": name, "relative_to": None, "by_terms": False} for name in ("alpha", "beta")
        ],
    }
    graph = {"nodes": [["symbol", "tracking_index"]], "outputs": {"alpha": 0, "beta": 0}}
    assert random_velocity.gains(1.0).alpha < 1
    assert sampled("random_velocity", kernel, graph)["inputs"] == 1

    def unknown(graph: Any, point: Any) -> dict[str, Any]:
        return {name: ball * float("nan") for name, ball in ball_outputs(graph, point).items()}

    monkeypatch.setattr(sampled_kernel, "ball_outputs", unknown)
    with pytest.raises(ArithmeticError, match=r"random_velocity.gains: alpha is not known at"):
        sampled("random_velocity", kernel, graph)
