"""What the printed kernels of second derivatives are called and say of themselves."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from types import MappingProxyType

from gainproof.derive.pages import kernel_formulas
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Output

SCALE = f"predicted_11{kernel_formulas.SCALE}"
"""What the second derivative of M11 is measured by for e > 0: its terms, added."""
TURN = f"predicted_11{kernel_formulas.TURN}"
"""The difference in the second derivative of M11 for e > 0."""

SUMMARIES: Mapping[str, str] = MappingProxyType(
    {
        "gain_second_derivatives": "Second derivatives of the filter gain, both negative.",
        "predictor_gain_second_derivatives": "Second derivatives of the predictor gain.",
        "predicted_covariance_second_derivatives": "Second derivatives of the predicted "
        "covariance.",
        "updated_covariance_second_derivatives": "Second derivatives of the updated covariance.",
    }
)
BOTH = (
    "psi = (1 + e/(2 kappa))/rho with e = {e}: sigma^2 grows like this power of Lambda, and psi",
    "itself like the power 1 - chi.",
)
FIRST = ("d2 M11 = (sigma/Lambda)^2 psi (psi - chi), first negative, then positive.",)
EQUATIONS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "gain_second_derivatives": (
            "d2 alpha = -psi (psi + chi)/(sigma Lambda)^2, d2 beta negative, too.",
            *BOTH,
        ),
        "predictor_gain_second_derivatives": ("d2 (alpha + beta), d2 beta; both negative.",),
        "predicted_covariance_second_derivatives": (
            *FIRST,
            "d2 M12 = (sigma/Lambda) (psi/2) (2 + psi/2 - chi), d2 M22 = 2 + d2 X22.",
            *BOTH,
        ),
        "updated_covariance_second_derivatives": (
            "X11 = alpha and X12 = beta bend down, X22 bends up.",
        ),
    }
)
REASON = (
    "the variance bends down for a small index and up for a large one, so that it vanishes between"
)


def equations(kernel: str, e: Fraction) -> tuple[str, ...]:
    """The lines on what is differentiated; those on kappa and rho follow them."""
    lines = tuple(line.format(e=e) for line in EQUATIONS[kernel])
    if kernel != "predicted_covariance_second_derivatives":
        return lines
    if e == 0:
        return (*lines, "It is a product with Lambda - 4/(3 + 2 sqrt(3)), which keeps its digits.")
    return lines


def output(name: str, meaning: str, graph: Graph) -> Output:
    """One output; that of changing sign is measured by its terms."""
    scaled = name == "predicted_11" and SCALE in graph["outputs"]
    text = f"second derivative by Lambda of the {meaning}"
    return Output(name, text, relative_to=SCALE if scaled else None)


def cancellations(graph: Graph) -> Mapping[str, str]:
    """The named difference, where there is one."""
    return {TURN: REASON} if SCALE in graph["outputs"] else {}
