"""The printed module of a two-state model: its kernels, and why one is not printed."""

from __future__ import annotations

import textwrap
from functools import partial

from gainproof.derive.any_two_state import forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.kernels import KERNELS, made
from gainproof.derive.any_two_state.proved_module import (
    WIDTH,
    Printed,
    Wording,
    linear,
    printed,
)

SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "predicted_covariance": "Predicted covariance, each entry in its units.",
    "updated_covariance": "Updated covariance, each entry in its units.",
    "gain_derivatives": "First derivatives of the filter gain with respect to the tracking index.",
    "gain_second_derivatives": "Second derivatives of the filter gain by the tracking index.",
}
ORDERS = {
    "gain_derivatives": "derivative of the ",
    "gain_second_derivatives": "second derivative of the ",
}
MEANINGS = {
    "alpha": "gain of the measured state",
    "beta": "gain of the second state",
    "predicted_11": "variance of the predicted first state",
    "predicted_12": "covariance of both predicted states",
    "predicted_22": "variance of the predicted second state",
    "updated_11": "variance of the updated first state",
    "updated_12": "covariance of both updated states",
    "updated_22": "variance of the updated second state",
}


def module_of(c: Context) -> Printed:
    """Every kernel tried."""
    graphs = {name: partial(made, c.shape, parts) for name, parts in KERNELS.items()}
    return printed(c.original, c.model, graphs, Wording(SUMMARIES, _meaning, _equations(c)))


def _meaning(kernel: str, output: str) -> str:
    return ORDERS.get(kernel, "") + MEANINGS[output]


def _equations(c: Context) -> tuple[str, ...]:
    """What the outputs are, over the roots; lines of the docstring's width."""
    f0, f1, f2 = c.shape.open_loop
    n0, n1 = c.shape.noise_ends
    f11, f12, f21, f22 = (c.shape.entry(i, j) for i in (1, 2) for j in (1, 2))
    texts = [
        (
            "d0^2 = f0^2 + q n0, d2^2 = f2^2 + q n1, d1^2 = f1^2 - 2 f0 f2 + q (n0 + n1) + 2 d0 d2,"
            " sigma = (d0 + d1 + d2)/4, q = Lambda^2;"
        ),
        f"f0 = {f0}, f1 = {f1}, f2 = {f2}, n0 = {n0}, n1 = {n1};",
        "alpha = 1 - 1/sigma^2,",
    ]
    if forms.below_beta(c.basis) is None:
        texts.append(
            f"{linear((f12, 'sigma beta'))} = "
            f"{linear((f22, 'sigma'), (1, '(d0 - d2)/2'), (f11, '(1 - alpha) sigma'))};"
        )
    else:
        first, second = forms.couplings(c.basis)
        weights = linear(*((w, f"d{i}") for i, w in enumerate(c.basis.far_weights)))
        factor = linear((1, "sigma W/4"), (-f12 * f21, ""))
        texts.append(
            f"beta {f'({factor})' if f12 * f21 != 0 else factor} = "
            f"{linear((first, 'alpha'), (second, 'q'))}, W = {weights};"
        )
    texts += [
        (
            "predicted_11 = sigma^2 - 1, predicted_12 = beta sigma^2, updated_11 = alpha, "
            "updated_12 = beta, predicted_22 = updated_22 + beta^2 sigma^2."
        ),
        (
            "All of it is computed from sums, products, quotients and roots of positive terms"
            " but where an output is said to be a difference."
        ),
    ]
    return tuple(line for text in texts for line in textwrap.wrap(text, WIDTH))
