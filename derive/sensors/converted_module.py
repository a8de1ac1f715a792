"""The printed module of converted measurements: domains of its kernels, and what they say."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed, signed
from gainproof.derive.sensors.converted_graphs import PLANE

MEANINGS = {
    "x": "converted x, m",
    "y": "converted y, m",
    "z": "converted z, m",
    **{f"covariance_{a}{a}": f"stated variance of {a}, m^2" for a in "xyz"},
    **{
        f"covariance_{a}{b}": f"stated covariance of {a} and {b}, m^2"
        for a, b in ("xy", "xz", "yz")
    },
}

MEANINGS |= {
    "radial_variance": "stated variance along the measured line of sight, m^2",
    "cross_variance": "stated variance across the measured line of sight, m^2",
}

_IN_PLANE = {
    "classical_conversion": "The measured place, and its covariance to first order.",
    "debiased_conversion": "The measured place less its mean bias, and its mean covariance.",
    "unbiased_conversion": "The conversion without bias given the truth, and its mean square "
    "error.",
    "modified_unbiased_conversion": "Mean and covariance of the true place given the measurement.",
}
_IN_SPACE = {name: f"{text.removesuffix('.')}, in space." for name, text in _IN_PLANE.items()}
_CORRELATED = {
    "correlated_unbiased_conversion_in_plane": "The conversion without bias given the truth, "
    "noises correlated.",
    "correlated_modified_unbiased_conversion_in_plane": "Mean and covariance of the true place "
    "given the measurement, noises correlated.",
}
SUMMARIES = {
    **_CORRELATED,
    **_IN_SPACE,
    **{f"{name}{PLANE}": text for name, text in _IN_PLANE.items()},
}

EQUATIONS: dict[str, tuple[str, ...]] = {
    "correlated_unbiased_conversion_in_plane": (
        "With k = exp(-sa^2/2), c = correlation sr sa: (r/k, -c/k) along and across the measured",
        "line of sight; the covariance is the mean square error given the measurement",
    ),
    "correlated_modified_unbiased_conversion_in_plane": (
        "With k = exp(-sa^2/2), c = correlation sr sa: (k r, k c) along and across the measured",
        "line of sight, with the covariance of the true place: both exact, given the measurement",
    ),
    "classical_conversion": (
        "x = r cos e cos a, y = r cos e sin a, z = r sin e; the covariance is J D J' with the",
        "derivatives J of these and D = diag(sr^2, se^2, sa^2)",
    ),
    "debiased_conversion": (
        "With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = (1 + k - k^2) r cos e cos a, y likewise,",
        "z = (1 + ke - ke^2) r sin e; the covariance is the mean, given the measurement, of that",
        "of the raw conversion given the truth",
    ),
    "unbiased_conversion": (
        "With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = r cos e cos a/k, y likewise,",
        "z = r sin e/ke: given the truth the mean is the truth. The covariance is the mean square",
        "error given the measurement",
    ),
    "modified_unbiased_conversion": (
        "With ke = exp(-se^2/2), k = ke exp(-sa^2/2): x = k r cos e cos a, y likewise,",
        "z = ke r sin e, with their covariance: both exact, given the measurement, where nothing",
        "was known of the truth before",
    ),
    "classical_conversion_in_plane": (
        "x = r cos a, y = r sin a; along the line of sight the variance sr^2, across it (r sa)^2.",
        "Biased given the truth by exp(-sa^2/2) - 1 times the range; a covariance to first order",
        "only, too small along the line of sight where r^2 tanh(sa^2/2) > sr^2",
    ),
    "debiased_conversion_in_plane": (
        "With k = exp(-sa^2/2): x = (1 + k - k^2) r cos a, y likewise; the covariance is the mean,",
        "given the measurement, of that of the raw conversion given the truth (Lerro, Bar-Shalom",
        "1993). What is left of the bias given the truth is -(1 - k)^2 (1 + k) times the range",
    ),
    "unbiased_conversion_in_plane": (
        "With k = exp(-sa^2/2): x = r cos a/k, y likewise: given the truth the mean is the truth.",
        "The covariance is the mean square error given the measurement (Longbin et al. 1998, (7)):",
        "along (r^2 (1 - k^2)^2 (2 + k^2)/k^2 + sr^2 (1 + k^4))/2, across (r^2 + sr^2)(1 - k^4)/2",
    ),
    "modified_unbiased_conversion_in_plane": (
        "With k = exp(-sa^2/2): x = k r cos a, y likewise; along the line of sight the variance",
        "(r^2 (1 - k^2)^2 + sr^2 (1 + k^4))/2, across it (r^2 + sr^2)(1 - k^4)/2 (Duan, Han, Li",
        "2004). Both exact, given the measurement, where nothing was known of the truth before",
    ),
}

RANGE = ("1e-20", "1e60", ("1e-3", "1e12"))
DEVIATION = ("1e-15", "2", ("1e-6", "2"))
TURN = ("1e-20", "6.2832", ("1e-12", "6.2832"))
DOMAINS: dict[str, Input] = {
    "slant_range": closed("slant_range", "measured range, m", *RANGE),
    "elevation": signed(
        "elevation",
        "measured elevation above the plane of x and y, rad",
        "1e-20",
        "1.5707963267948966",
        ("1e-12", "1.5707962"),
    ),
    "azimuth": signed("azimuth", "measured azimuth from x towards y, rad", *TURN),
    "range_deviation": closed("range_deviation", "standard deviation of the range, m", *RANGE),
    **{
        f"{angle}_deviation": closed(
            f"{angle}_deviation", f"standard deviation of the {angle}, rad", *DEVIATION
        )
        for angle in ("elevation", "azimuth")
    },
    "correlation": signed(
        "correlation", "correlation of the noises of range and azimuth", "1e-20", "1", ("1e-6", "1")
    ),
}
"""The arguments in their order."""


def kernel_module(name: str, title: str, graphs: Mapping[str, Graph]) -> Module:
    """The module of converted measurements."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in graphs.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    used = set(symbols_of(graph))
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(DOMAINS[entry] for entry in DOMAINS if entry in used),
        outputs=tuple(
            Output(entry, MEANINGS[entry], by_terms=_cancels(kernel, entry))
            for entry in graph["outputs"]
        ),
        graph=graph,
        source=f"derivation {name}",
    )


CANCELS = ("covariance_xy", "covariance_xz", "covariance_yz")
"""Outputs that change their sign: differences of the variances along the axes."""


def _cancels(kernel: str, entry: str) -> bool:
    return entry in CANCELS or kernel.startswith("correlated")
