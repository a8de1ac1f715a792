"""The printed module of a three-state family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.pages.kernel_formulas import SCALE, TURN
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output
from gainproof.derive.subject import in_double_words
from gainproof.derive.three_state import pole_module
from gainproof.derive.three_state.accurate_gains import REFINEMENT, accurate_input
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernel_poles import POLES

SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "gain_derivatives": "First derivatives of the filter gain with respect to the tracking index.",
    "gains_with_derivatives": "Filter gain and its first derivatives in one pass.",
    "predictor_gains": "Steady-state predictor gain F K.",
    "predictor_gain_derivatives": "First derivatives of the predictor gain.",
    "innovation_deviation": "Standard deviation of an innovation in units of sigma_v.",
    "pole_product": "Product of the three poles of the filter, which is 1 - alpha.",
    POLES: pole_module.SUMMARY,
    "predicted_covariance": "Predicted covariance in units of sigma_v^2 and T.",
    "predicted_covariance_derivatives": "First derivatives of the predicted covariance.",
    "updated_covariance": "Updated covariance in units of sigma_v^2 and T.",
    "updated_covariance_derivatives": "First derivatives of the updated covariance.",
    "gain_second_derivatives": "Second derivatives of the filter gain, all negative.",
    "predictor_gain_second_derivatives": "Second derivatives of the predictor gain.",
    "predicted_covariance_second_derivatives": "Second derivatives of the predicted covariance "
    "but for M11 and M12.",
    "predicted_position_second_derivatives": "Second derivatives of M11 and M12.",
    "updated_covariance_second_derivatives": "Second derivatives of the updated covariance but "
    "for its first row.",
    "index_from_alpha": "The tracking index that belongs to a position gain.",
    "gains_from_alpha": "The velocity and acceleration gain that belong to a position gain.",
}
STATES = ("position", "velocity", "acceleration")
UNITS = {2: "over sigma_v^2", 3: "times T/sigma_v^2", 4: "times T^2/sigma_v^2"}
UNITS |= {5: "times T^3/sigma_v^2", 6: "times T^4/sigma_v^2"}
MEANINGS = {
    "alpha": "position gain",
    "beta": "velocity gain times the sampling interval",
    "gamma": "acceleration gain times the square of the sampling interval",
    "position": "position entry of F K, alpha + beta + gamma/2",
    "velocity": "velocity entry of F K times the sampling interval, beta + gamma",
    "acceleration": "acceleration entry of F K times the square of the sampling interval, gamma",
    "tracking_index": "tracking index Lambda",
    "innovation_deviation": "standard deviation of an innovation over sigma_v",
    **pole_module.MEANINGS,
    "pole_product": "product of the poles, and what is left of 1 beside the position gain",
}
STEADY = (f"updated_23{TURN}", f"updated_33{TURN}")
APART = "what the update takes from M'' stays less than it"
TURNS = "it bends down for a small index and up for a large one, so that it vanishes between"
ACCURATE_GAINS = in_double_words("gains")
# The cube of a smaller position gain, an index, leaves the range of the format.
LEAST_ALPHA = (Fraction(1, 2**330), Fraction(1, 2**40))
# Parts of M11'' and M12'' both leave it below an index.
TURNING = (Fraction(1, 2**750), Fraction(1, 2**80))
# Multiples of a larger one, and so slopes of covariances, leave it.
MOST = (2**1000, 2**120)
SLOPES = (
    "predicted_covariance_derivatives",
    "updated_covariance_derivatives",
    "predicted_covariance_second_derivatives",
)


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    kernels = (_kernel(c, name, graphs) for name in graphs if name != ACCURATE_GAINS)
    return catalogue_module(
        c.model.name, f"{c.model.title}: steady state with measured position", kernels
    )


def _kernel(c: Context, name: str, graphs: Mapping[str, Graph]) -> Kernel:
    graph, accurate = graphs[name], graphs.get(ACCURATE_GAINS) if name == "gains" else None
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c, name),
        inputs=(_input(c, name),),
        outputs=tuple(
            Output(
                output,
                _meaning(name, output),
                relative_to=f"{output}{SCALE}" if f"{output}{SCALE}" in graph["outputs"] else None,
            )
            for output in graph["outputs"]
            if not output.endswith(SCALE)
        ),
        graph=graph,
        source=f"derivation {c.model.name}",
        cancellations=_cancellations(graph),
        accurate=accurate_input(_input(c, name)) if accurate else None,
        accurate_graph=accurate,
        refinement=REFINEMENT if accurate else None,
    )


def _cancellations(graph: Graph) -> Mapping[str, str]:
    """The differences that are meant, each with its reason."""
    names = graph.get("names", {})
    return {name: APART if name in STEADY else TURNS for name in names if name.endswith(TURN)}


def _input(c: Context, name: str) -> Input:
    if name.endswith("from_alpha"):
        least, small = LEAST_ALPHA
        return Input("alpha", "position gain", least, "1", False, single=(small, "1"))
    meaning = f"Lambda, with Lambda^2 = {c.model.noise_ratio}"
    double, single = MOST
    if name == "predicted_position_second_derivatives":
        low, least = TURNING
        return Input("tracking_index", meaning, low, double, False, False, single=(least, single))
    if name in SLOPES:
        return Input("tracking_index", meaning, "0", double, upper_open=False, single=("0", single))
    return Input("tracking_index", meaning)


def _meaning(kernel: str, output: str) -> str:
    plain = output.removeprefix("d_")
    second = kernel.endswith("_second_derivatives")
    derivative = plain != output or (
        kernel.endswith("_derivatives") and kernel != "gains_with_derivatives"
    )
    meaning = MEANINGS.get(plain) or _entry(plain)
    word = "second derivative by Lambda" if second else "derivative"
    return f"{word} of the {meaning}" if derivative else meaning


def _entry(name: str) -> str:
    """The meaning of an entry of a covariance."""
    kind, places = name.split("_")
    first, second = (int(place) for place in places)
    unit = UNITS[first + second]
    if first == second:
        return f"variance of the {kind} {STATES[first - 1]} {unit}"
    return f"covariance of {kind} {STATES[first - 1]} and {STATES[second - 1]} {unit}"


def _of_poles(c: Context) -> tuple[str, ...]:
    """What is said of the poles beside their product."""
    known = (
        "one pole is w = 1/sigma, the others solve z^2 - 2 m z + w = 0, "
        "m = (xi^2 - 8)/(xi^2 + 2 xi),"
        if c.spectrum.rational_in_root
        else "with d(s) = 1 + xi s + eta s^2 + delta s^3 and z = (1 + s)/(1 - s),"
    )
    return ("pole_product = 1/sigma^2, sigma = Lambda nu/8,", known)


def _equations(c: Context, name: str) -> tuple[str, ...]:
    a1, a2, e = c.numbers
    if name.endswith("from_alpha"):
        return (
            "beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w),",
            "Lambda = gamma/w, w = sqrt(1 - alpha)",
        )
    if name == POLES:
        return pole_module.equations(c)
    own = {
        "gains": ("alpha = 2 (1 + eta)/nu, beta = 4 xi/nu, gamma = 8/nu,",),
        "innovation_deviation": ("sigma = Lambda nu/8,",),
        "pole_product": _of_poles(c),
        "predicted_covariance": (
            "predicted_1j = sigma^2 (alpha, beta, gamma), sigma = Lambda nu/8,",
        ),
        "updated_covariance": ("updated_1j = (alpha, beta, gamma),",),
    }
    return (
        *own.get(name, ()),
        f"delta = {f'sqrt(64/Lambda^2 + {e})' if e else '8/Lambda'},",
        f"xi = sqrt({a1} + 2 eta), eta = sqrt({a2} + 2 delta xi), nu = 1 + xi + eta + delta",
    )
