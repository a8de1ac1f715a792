"""The whole derivation of a three-state model with its first state measured."""

from __future__ import annotations

import textwrap
from functools import partial
from pathlib import Path

from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.kernels import kernel_roots, made
from gainproof.derive.any_three_state.model_numbers import shape_of
from gainproof.derive.any_three_state.names import LATEX
from gainproof.derive.any_three_state.page_slots import given
from gainproof.derive.any_three_state.towers import roots_of
from gainproof.derive.any_two_state.programs import kernel_steps
from gainproof.derive.any_two_state.proved_module import (
    SINGLE_RANGE,
    WIDTH,
    Printed,
    Wording,
    linear,
    measured_subject,
    printed,
    require_kernels,
)
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.model import Model, ModelError
from gainproof.derive.pages.derivation import FOLDER, written
from gainproof.derive.subject import Subject

SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "predicted_covariance": "Predicted covariance, each entry in its units.",
    "updated_covariance": "Updated covariance, each entry in its units.",
    "gain_derivatives": "First derivatives of the filter gain with respect to the tracking index.",
}
GAINS = {
    "alpha": "gain of the measured state",
    "beta": "gain of the second state",
    "gamma": "gain of the third state",
}
STATES = ("first", "second", "third")
NARROW_RANGE = ("1/100", "100")
"""Of float32, where the wide one over- or underflows."""


def module_of(c: Context) -> Printed:
    """Every kernel tried."""
    graphs = {name: partial(made, c.shape, getattr(c.quantities, name)) for name in SUMMARIES}
    said = Wording(SUMMARIES, _meaning, _equations(c))
    return printed(c.original, c.model, graphs, said, (SINGLE_RANGE, NARROW_RANGE))


def _meaning(kernel: str, output: str) -> str:
    if output in GAINS:
        return ("derivative of the " if kernel == "gain_derivatives" else "") + GAINS[output]
    kind, place = output.split("_")
    first, second = (STATES[int(digit) - 1] for digit in place)
    if first == second:
        return f"variance of the {kind} {first} state"
    return f"covariance of the {kind} {first} and {second} states"


def _equations(c: Context) -> tuple[str, ...]:
    """What the outputs are, over the roots; lines of the docstring's width."""
    f, n = c.shape.still, c.shape.shaken
    numbers = [f"A{k} = {linear((f[k], ''), (n[k], 'q'))}" for k in range(4)]
    weights, own = c.shape.closed_loop
    sums = [linear(*((w, f"d{i}") for i, w in enumerate(weights.row(k)))) for k in (1, 2)]
    texts = [
        "d0^2 = A0, d1^2 = A1 + 2 d0 d2, d2^2 = A2 + 2 d3 d1, d3^2 = A3, q = Lambda^2,",
        f"{', '.join(numbers)};",
        "N = d0 + d1 + d2 + d3, sigma = N/8, alpha = 1 - 1/sigma^2,",
        *(
            f"{name} = {linear((int(text != '0'), f'({text})/N'), (-own[k], ''))},"
            for k, name, text in zip((1, 2), ("beta", "gamma"), sums, strict=True)
        ),
        (
            "predicted_1j = sigma^2 (alpha, beta, gamma), updated_1j = (alpha, beta, gamma), the "
            "rest from predicted = F updated F' + q Q0."
        ),
        (
            "All of it is computed from sums, products, quotients and roots of positive terms but "
            "where an output is said to be a difference."
        ),
    ]
    return tuple(line for text in texts for line in textwrap.wrap(text, WIDTH))


PAGE = "first-measured-three-states"


def derive_any_three_state(model: Model, folder: Path = FOLDER) -> Subject:
    """Derive everything about the steady state of three states with the first one measured.

    The steps are those of the page `first-measured-three-states` in `folder`. Raises ModelError,
    naming the reason, for a model outside the method's reach; PageError for a mistake of the page.
    """
    c = Context(model, shape_of(model, scale_free(model)))
    if c.shape.sign(c.shape.determinant) == 0:
        raise ModelError(
            f"model {model.name}: of three states a transition with an inverse is in reach, det F "
            "= 0: its last gains are not in the poles of the filter"
        )
    roots = roots_of(c.shape)
    found = module_of(c)
    require_kernels(found, model)
    steps = kernel_steps(kernel_roots(roots.known), found)
    page = written(PAGE, given(c, steps), folder)
    return measured_subject(c, found, page, LATEX)
