"""Plans of registers: no step is overwritten before its last reader, and which plan is taken."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.output_registers import apart
from gainproof.derive.printer.program import Program, program
from gainproof.derive.printer.register_plan import SLOW, Plan
from gainproof.derive.printer.registers import _Planner, plan


@st.composite
def programs(draw: st.DrawFn) -> tuple[Program, list[int]]:
    """Of three inputs: sums, differences, products, quotients, roots and choices of them."""
    b = GraphBuilder()
    nodes = [b.symbol(name) for name in "xyz"]
    for _ in range(draw(st.integers(1, 14))):
        one, other, third = (draw(st.sampled_from(nodes)) for _ in range(3))
        made = [one + other, one - other, one * other, one / other, b.sqrt(one), one * 3, 2 / one]
        nodes.append(draw(st.sampled_from([*made, b.select(one, other, third, one)])))
    ends = draw(st.lists(st.sampled_from(nodes), min_size=1, max_size=5))
    steps = program(b.graph({f"out{place}": end for place, end in enumerate(ends)}))
    return steps, [steps.outputs[f"out{place}"] for place in range(len(ends))]


def loses(steps: Program, outputs: Sequence[int], chosen: Plan) -> str:
    """What a plan would overwrite or leave out; nothing if it is right."""
    held: dict[int, int] = {}
    for step in chosen.order:
        for part in steps.steps[step].operands:
            plain = steps.steps[part].operation in ("input", "constant")
            if not plain and held.get(chosen.register[part]) != part:
                return f"step {step} reads {part}, where {held.get(chosen.register[part])} is"
        held[chosen.register[step]] = step
    for output, step in enumerate(outputs):
        copied = (output, step) in chosen.copies
        plain = steps.steps[step].operation in ("input", "constant")
        if not (copied and plain) and held.get(chosen.register[step]) != step:
            return f"output {output} is overwritten"
        if not copied and chosen.register[step] != output:
            return f"output {output} is elsewhere"
    beyond = max([*chosen.register.values(), -1]) + 1 - len(outputs)
    return "" if chosen.work == max(beyond, 0) else f"{beyond} buffers"


@settings(max_examples=samples(150), deadline=None)
@given(given_=programs())
def test_no_plan_loses_what_is_read_later(given_: tuple[Program, list[int]]) -> None:
    steps, outputs = given_
    usual, straight = (_Planner(steps, outputs, way).run() for way in (False, True))
    for chosen in (usual, straight, apart(steps, outputs), plan(steps, outputs)):
        assert not loses(steps, outputs, chosen)


def test_a_plan_that_overwrites_is_told() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    root = b.sqrt(x + 1)
    steps = program(b.graph({"y": (root + x) / root}))
    outputs = [steps.outputs["y"]]
    right = plan(steps, outputs)
    assert not loses(steps, outputs, right)
    assert "reads" in loses(steps, outputs, Plan(right.order, dict.fromkeys(right.order, 0), 0, ()))
    assert "buffers" in loses(steps, outputs, Plan(right.order, right.register, 9, right.copies))


def test_outputs_are_lent_to_roots_alone_and_sums_are_in_buffers() -> None:
    """Two roots that several steps read, and outputs of which one is a sum's quotient."""
    b = GraphBuilder()
    x = b.symbol("x")
    p, h = b.sqrt(x), b.sqrt(1 / x + x)
    total = p + h
    share = 1 / (total * total * p)
    graph = b.graph({"a": p / total, "b": h / total, "c": share * (p / h + 2), "d": share * h})
    steps = program(graph)
    outputs = [steps.outputs[name] for name in "abcd"]
    chosen = apart(steps, outputs)
    assert not loses(steps, outputs, chosen)
    first: dict[int, int] = {}
    for step in chosen.order:
        first.setdefault(chosen.register[step], step)
        operation, at = steps.steps[step].operation, chosen.register[step]
        if at < 4 and step not in outputs:
            in_place = at in [chosen.register.get(part) for part in steps.steps[step].operands]
            assert operation in SLOW or in_place, step
    assert sum(steps.steps[first[at]].operation in SLOW for at in range(4)) >= 3
