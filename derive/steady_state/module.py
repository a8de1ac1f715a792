"""The printed module of a two-state family: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.steady_state import curvature_module
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.kernels import largest_beta
from gainproof.derive.subject import in_double_words

ACCURATE_GAINS = in_double_words("gains")
SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "gain_derivatives": "First derivatives of the filter gain with respect to the tracking index.",
    "gains_with_derivatives": "Filter gain and its first derivatives in one pass.",
    "predictor_gains": "Steady-state predictor gain F K.",
    "predictor_gain_derivatives": "First derivatives of the predictor gain.",
    "predicted_covariance": "Predicted covariance in units of sigma_v^2 and T.",
    "predicted_covariance_derivatives": "First derivatives of the predicted covariance.",
    "updated_covariance": "Updated covariance in units of sigma_v^2 and T.",
    "updated_covariance_derivatives": "First derivatives of the updated covariance.",
    "closed_loop_poles": "Poles of the filter: a complex pair or two real numbers.",
    "index_from_alpha": "The tracking index that belongs to a position gain.",
    "beta_from_alpha": "The velocity gain that belongs to a position gain.",
    "index_from_beta": "The tracking index that belongs to a velocity gain.",
    "alpha_from_beta": "The position gain that belongs to a velocity gain.",
}

MEANINGS = {
    "alpha": "position gain",
    "beta": "velocity gain times the sampling interval",
    "position": "position entry of F K, alpha + beta",
    "velocity": "velocity entry of F K times the sampling interval, beta",
    "tracking_index": "tracking index Lambda",
    "predicted_11": "variance of the predicted position over sigma_v^2",
    "predicted_12": "covariance of predicted position and velocity times T/sigma_v^2",
    "predicted_22": "variance of the predicted velocity times T^2/sigma_v^2",
    "updated_11": "variance of the updated position over sigma_v^2",
    "updated_12": "covariance of updated position and velocity times T/sigma_v^2",
    "updated_22": "variance of the updated velocity times T^2/sigma_v^2",
    "first_real": "real part of the first pole",
    "first_imaginary": "imaginary part of the first pole, not negative",
    "second_real": "real part of the second pole",
    "second_imaginary": "imaginary part of the second pole, not positive",
}


def kernel_module(c: Context, graphs: Mapping[str, Graph]) -> Module:
    """The module of a family."""
    kernels = (_kernel(c, name, graphs) for name in graphs if name != ACCURATE_GAINS)
    return catalogue_module(
        c.model.name,
        f"{c.model.title}: steady state with measured position",
        kernels,
        results="_two_state_results",
    )


def _kernel(c: Context, name: str, graphs: Mapping[str, Graph]) -> Kernel:
    graph = graphs[name]
    shown = [output for output in graph["outputs"] if not output.endswith(("_modulus", "_scale"))]
    second = name in curvature_module.SUMMARIES
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=curvature_module.SUMMARIES[name] if second else SUMMARIES[name],
        equations=_equations(c, name),
        inputs=(_input(c, name),),
        outputs=tuple(
            curvature_module.output(output, MEANINGS[output], graph)
            if second
            else _output(name, output)
            for output in shown
        ),
        graph=graph,
        source=f"derivation {c.model.name}",
        cancellations=curvature_module.cancellations(graph) if second else {},
        accurate=_accurate_input(c) if name == "gains" else None,
        accurate_graph=graphs[ACCURATE_GAINS] if name == "gains" else None,
    )


def _root_text(e: Fraction) -> str:
    """h of gains with derivatives in words."""
    if e == 0:
        return "4/p"
    return f"sqrt(16/Lambda + {'' if e == 1 else f'{e} '}Lambda)"


def _input(c: Context, name: str) -> Input:
    if name.endswith("from_alpha"):
        return Input("alpha", "position gain", "0", "1")
    if name.endswith("from_beta"):
        return Input("beta", "velocity gain times the sampling interval", "0", largest_beta(c.e))
    return Input("tracking_index", f"Lambda, with Lambda^2 = {c.model.noise_ratio}")


def _accurate_input(c: Context) -> Input:
    given = _input(c, "gains")
    return closed(given.name, given.meaning, Fraction(1, 2**400), 2**400)


def _output(kernel: str, output: str) -> Output:
    derivative = output.startswith("d_") or kernel in {
        "gain_derivatives",
        "predictor_gain_derivatives",
        "predicted_covariance_derivatives",
        "updated_covariance_derivatives",
    }
    meaning = MEANINGS[output.removeprefix("d_")]
    scale = f"{output.split('_')[0]}_modulus" if kernel == "closed_loop_poles" else None
    return Output(
        output,
        f"derivative of the {meaning}" if derivative else meaning,
        relative_to=scale,
    )


def _equations(c: Context, name: str) -> tuple[str, ...]:
    e = c.e
    if "_from_" in name:
        return (f"{c.spectrum.relation} = 0, Lambda^2 = beta^2/(1 - alpha)",)
    own = {
        "gains": ("beta = 2/(1/2 + kappa + rho), alpha = rho beta",),
        "gains_with_derivatives": (
            "alpha = 2 r/(p + h + r), beta = 4 p/(p + h + r), p = sqrt(Lambda),",
            f"h = {_root_text(e)}, r = 2 rho p,",
        ),
        "closed_loop_poles": (
            "z^2 - (2 - alpha - beta) z + (1 - alpha) = 0; first_modulus and second_modulus are",
            "the moduli of the poles;",
            "all poles lie inside the unit circle; rounded, a real part may come as 1 + 2^-52",
        ),
        "predicted_covariance": (
            "predicted_11 = rho Lambda sigma, predicted_12 = Lambda sigma,",
            f"predicted_22 = Lambda^2 (rho + {1 - c.n})",
        ),
        "updated_covariance": (
            "updated_11 = alpha, updated_12 = beta,",
            f"updated_22 = Lambda^2 {f'(rho - {c.n})' if c.n else 'rho'}",
        ),
        "gain_derivatives": (
            f"d alpha = {f'(1 + {e / 2}/kappa)' if e else '1'}/(rho sigma^2 Lambda),",
            "d beta = (2 + 1/rho)/(kappa sigma^2 Lambda)",
        ),
    }
    if name in curvature_module.SUMMARIES:
        own[name] = curvature_module.equations(name, e)
    kappa = "2/Lambda" if e == 0 else f"sqrt(4/Lambda^2 + {e / 4})"
    return (
        *own.get(name, ()),
        f"kappa = {kappa}, rho = sqrt(kappa + {(1 + e) / 4}) = alpha/beta,",
        "sigma = Lambda/beta = Lambda (1/2 + kappa + rho)/2",
    )
