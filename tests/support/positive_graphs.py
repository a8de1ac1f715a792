"""Random graphs without a subtraction, as kernels of two inputs."""

from __future__ import annotations

from graph_kernels import several_of
from hypothesis import strategies as st

from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.printer.kernel import Kernel

NUMBERS = ["1", "3", "1/3", "16", "1/1024", "1000003"]


@st.composite
def positive_graphs(draw: st.DrawFn) -> Kernel:
    """Sums, products, quotients and roots of two positive inputs, with shared nodes."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    nodes: list[Node] = [x, z, x + z, b.number(draw(st.sampled_from(NUMBERS)))]
    for _ in range(draw(st.integers(3, 12))):
        kind = draw(st.sampled_from("+++*//r"))
        first, second = (nodes[draw(st.integers(0, len(nodes) - 1))] for _ in range(2))
        match kind:
            case "+":
                nodes.append(first + second)
            case "*":
                nodes.append(first * second)
            case "/":
                nodes.append(first / second)
            case _:
                nodes.append(b.sqrt(first))
    graph = b.graph({"y": nodes[-1] * x / x, "w": nodes[-2] + z})
    return several_of(graph, *draw(st.sampled_from([("1/8", "8"), ("1e-4", "1e4")])))
