"""Kernels of what the process noises of three states add to covariances, over the noise ratio.

Acceleration increments and an acceleration noise that acts all through the next interval, by
(T^2/2, T, 1), share a kernel: covariances differ in the last entry alone, and there by 1.
"""

from __future__ import annotations

from gainproof.derive.fixed_gain import three_noise_forms as forms
from gainproof.derive.fixed_gain.three_noise_forms import ONE, After, Noise, Place
from gainproof.derive.pages.kernel_formulas import SCALE
from gainproof.derive.pages.kernel_page import difference
from gainproof.derive.printer.graph import Graph, GraphBuilder

NOISES: dict[str, Noise] = {
    "acceleration": forms.ACCELERATION,
    "jerk": forms.JERK,
    "white_jerk": forms.WHITE_JERK,
}
TURNING = tuple(f"updated_{ij}" for ij in ("12", "13", "22", "23", "33"))
"""Outputs whose terms have both signs: errors are over the sum of their sizes."""


def kernel_of(noise: str) -> str:
    """The name of the kernel over the gains; that over the coordinates adds `_of_coordinates`."""
    return f"{noise}_noise_variances"


def noise_graphs() -> dict[str, Graph]:
    """The graph of each kernel."""
    found = {kernel_of(name): _of_gains(noise) for name, noise in NOISES.items()}
    return found | {
        f"{kernel_of(name)}_of_coordinates": _of_coordinates(noise)
        for name, noise in NOISES.items()
    }


def _of_coordinates(noise: Noise) -> Graph:
    builder = GraphBuilder()
    names = ("linear_coefficient", "cubic_coefficient", "hurwitz_determinant")
    x, d, m = (builder.symbol(name) for name in names)
    y = (d + m) / x
    more = y + 1
    total = more + x
    entries = forms.predicted(noise, Place(ONE, x, y, d, m, more, total, total + d))
    return builder.graph({f"predicted_{ij}": value for ij, value in entries.items()})


def _of_gains(noise: Noise) -> Graph:
    """gamma times the coordinates: 2 beta, 4 alpha - gamma, 2 margin; of m gamma^2 times."""
    builder = GraphBuilder()
    alpha, beta, share = (builder.symbol(name) for name in ("alpha", "beta", "share"))
    rest, beyond, slack = 1 - alpha, 2 - alpha, 1 - share
    margin = rest * 2 + (2 - beta)
    twice = beta * 2 / beyond
    gamma = alpha * share * twice
    gap = twice * (rest * 2 + alpha * slack)  # 2 beta - gamma
    double, quarter = beta * 2, alpha * 4
    at = Place(
        gamma,
        double,
        alpha * 2 * (beta * slack + margin) / beyond,
        margin * 2,
        alpha * beta * slack * 8,
        quarter,
        quarter + double,
        builder.number(8),
    )
    outputs = {f"predicted_{ij}": value for ij, value in forms.predicted(noise, at).items()}
    after = After(gap, rest * 8, slack + share)
    differences = {}
    for ij, (plus, minus) in forms.updated(noise, at, after).items():
        name = f"updated_{ij}"
        outputs[name] = plus if minus is None else plus - minus
        if minus is not None:
            differences[difference(name)] = outputs[name]
            outputs[name + SCALE] = plus + minus
    return builder.graph(outputs, differences)
