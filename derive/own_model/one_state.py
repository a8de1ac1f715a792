"""An own model of one state that is measured: steady state, first derivative, kernels.

The derivation is the page `one-state` of `derive/pages`; here is what it does not say. The roots d0
and d2 are those of the spectrum at z = 1 and z = -1, as of two states.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import sympy as sp

from gainproof.derive.algebra.leading_elements import Edge, NoLeadingTerm, edge
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.any_two_state.basis import Basis
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.denominators import common_denominator, over_parameters
from gainproof.derive.any_two_state.domain import FreeNumbers
from gainproof.derive.any_two_state.free_numbers import free_number_steps
from gainproof.derive.any_two_state.kernel_numbers import Numbers
from gainproof.derive.any_two_state.kernels import Made, graph_end_root, symbolic_basis
from gainproof.derive.any_two_state.model_numbers import Shape, require_first_measured
from gainproof.derive.any_two_state.names import D0, D2, INDEX, LATEX
from gainproof.derive.any_two_state.programs import kernel_steps
from gainproof.derive.any_two_state.proved_module import (
    Wording,
    linear,
    measured_subject,
    printed,
    require_kernels,
)
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.any_two_state.towers import end_root
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.model_slots import model_slots
from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.subject import Subject

SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "predicted_covariance": "Variance of the predicted state, in its units.",
    "updated_covariance": "Variance of the updated state, in its units.",
    "gain_derivatives": "First derivative of the filter gain with respect to the tracking index.",
}
MEANINGS = {
    "alpha": "gain of the state",
    "predicted_11": "variance of the predicted state",
    "updated_11": "variance of the updated state",
}


class OneState(Shape):
    """The numbers of one state: f0 = 1 - f, f2 = 1 + f; there is no f1, and n0 = n1."""

    @property
    def transition(self) -> sp.Expr:
        """f."""
        return self.entry(1, 1)

    @property
    def open_loop(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        return self.readable(1 - self.transition), sp.Integer(0), self.readable(1 + self.transition)

    @property
    def noise_ends(self) -> tuple[sp.Expr, sp.Expr]:
        return (self.readable(self.noise(1, 1)),) * 2


def derive_one_state(model: Model) -> Subject:
    """Derive the steady state of a model of one state that is measured.

    Raises ModelError, naming the reason, for a model outside the method's reach.
    """
    scaled = scale_free(model)
    require_first_measured(model, scaled)
    c = Context(model, OneState(scaled, FreeNumbers(model.parameters)))
    graphs = {name: partial(_made, c.shape, name) for name in SUMMARIES}
    found = printed(model, scaled, graphs, Wording(SUMMARIES, _meaning, _equations(c.shape)))
    require_kernels(found, model)
    tower, roots = _tower(c.shape)
    page = written("one-state", _given(c, tower, kernel_steps(roots, found)))
    return measured_subject(c, found, page, {**LATEX, **page.latex})


def _outputs(x: Basis) -> dict[str, dict[str, Any]]:
    """What each kernel computes, over the index and the roots, as sums of positive terms."""
    near, _, far = x.roots
    f0, _, f2 = x.shape.open_loop
    noise = x.number(x.shape.noise_ends[0])
    sigma = (near + far) / 2
    variance = sigma * sigma
    excess = _above(x, near, f0) + _above(x, far, f2)
    beyond = x.signed(_size(x.shape, f0) + _size(x.shape, f2) - 2).plus
    if beyond is not None:
        excess = excess + beyond
    predicted = excess * (near + far + 2) / 4
    alpha = predicted / variance
    return {
        "gains": {"alpha": alpha},
        "predicted_covariance": {"predicted_11": predicted},
        "updated_covariance": {"updated_11": alpha},
        "gain_derivatives": {"alpha": x.index / near * (2 * noise / far) / variance},
    }


def _above(x: Basis, root: Any, own: sp.Expr) -> Any:
    """A root less what it is without noise, by its conjugate."""
    if x.shape.sign(own) == 0:
        return root
    return x.area * x.number(x.shape.noise_ends[0]) / (root + x.number(_size(x.shape, own)))


def _size(shape: Shape, own: sp.Expr) -> sp.Expr:
    return own if shape.sign(own) > 0 else -own


def _made(shape: Shape, kernel: str) -> Made:
    builder = GraphBuilder()
    names: dict[str, Node] = {}
    index, number = builder.symbol(INDEX.name), Numbers(builder, shape)
    blank = Basis(shape, index, (None, None, None), number)
    near = graph_end_root(blank, builder, names, 0)
    far = near if shape.determinant == 0 else graph_end_root(blank, builder, names, 2)
    outputs = _outputs(Basis(shape, index, (near, None, far), number))[kernel]
    values = _outputs(symbolic_basis(shape))[kernel]
    return Made(
        builder.graph(outputs, names), {name: Signed(value) for name, value in values.items()}
    )


def _tower(shape: Shape) -> tuple[Tower, dict[str, sp.Expr]]:
    """The tower of the steady state, and the values of the roots in kernels."""
    f0, _, f2 = shape.open_loop
    noise, f = shape.noise_ends[0], shape.determinant
    below = common_denominator(shape.numbers, (f0, f2), (noise,))
    over = over_parameters(shape.numbers)
    generators: list[Generator] = []
    known: dict[str, sp.Expr] = {}

    def root(number: int, own: sp.Expr) -> sp.Expr:
        values = sp.cancel(over(own) * below), sp.cancel(over(noise) * below**2), below, INDEX
        return end_root(shape, number, values, generators, known) / below

    elements: dict[str, sp.Expr] = dict(shape.numbers.elements)
    near = root(0, f0)
    far = near if f == 0 else root(2, f2)
    own = {generator.symbol for generator in generators}
    elements |= {n: value for n, value in (("d0", near), ("d2", far)) if n not in own}
    inverse = 1 / D0 if f == 0 else (D2 - D0) / (2 * f)
    elements |= {
        "innovation_deviation": (D0 + D2) / 2,
        "predicted_11": real("innovation_deviation") ** 2 - 1,
        "updated_11": 1 - inverse**2,
        "alpha": real("updated_11"),
    }
    parameters = tuple(Parameter(name) for name in (INDEX.name, *shape.numbers.symbols))
    tower = Tower("main", parameters, tuple(generators), elements)
    return tower, {**known, "d0": D0, "d2": D2}


def _given(c: Context, tower: Tower, kernels: list[Step]) -> Given:
    shape = c.shape
    forms = _outputs(symbolic_basis(shape))
    alpha, slope = (forms[kernel]["alpha"] for kernel in ("gains", "gain_derivatives"))
    predicted = forms["predicted_covariance"]["predicted_11"]
    small, large = edge(tower, at_infinity=False), edge(tower, at_infinity=True)
    start = small.of(tower.fraction(alpha))
    f0, _, f2 = shape.open_loop
    slots = {
        **model_slots(c.original, c.model),
        "measured": "has one entry, which is",
        "title": c.original.title,
        "f": shape.determinant,
        "near": f0,
        "far": f2,
        "entering": shape.noise_ends[0],
        "variance": predicted,
        "gain": alpha,
        "slope": slope,
        "least": sp.Integer(0) if start.order else shape.readable(start.coefficient),
    }
    return Given(
        towers=(tower,),
        models={"own": c.model.data()},
        slots={"": slots},
        hints={
            "stable": {"values": [2 * D2 / (D0 + D2), 2 * D0 / (D0 + D2)]},
            "predicted-positive": {"form": predicted},
            "grows": {"form": slope * ((D0 + D2) / 2) ** 4},
            "alpha-range": {"form": slope, **_without_cancellation(tower, (small, large), alpha)},
        },
        ends={"main": {"0": small.end, "infinity": large.end}},
        steps={"free-numbers": free_number_steps(c.original), "kernels": kernels},
    )


def _without_cancellation(
    tower: Tower, ends: tuple[Edge, Edge], alpha: sp.Expr
) -> dict[str, sp.Expr]:
    """The form that a limit is seen by, where the gain as the tower has it does not show it."""
    try:
        for end in ends:
            end.of(tower.elements["alpha"])
    except NoLeadingTerm:
        return {"limit_form": alpha}
    return {}


def _meaning(kernel: str, output: str) -> str:
    return ("derivative of the " if kernel == "gain_derivatives" else "") + MEANINGS[output]


def _equations(shape: Shape) -> tuple[str, ...]:
    """What the outputs are, over the roots."""
    f0, _, f2 = shape.open_loop
    noise = linear((shape.noise_ends[0], "q"))
    return (
        f"d0^2 = ({f0})^2 + {noise}, d2^2 = ({f2})^2 + {noise}, q = Lambda^2,",
        "sigma = (d0 + d2)/2, predicted_11 = sigma^2 - 1, alpha = updated_11 = 1 - 1/sigma^2.",
        "All of it is computed from sums, products, quotients and roots of positive terms.",
    )
