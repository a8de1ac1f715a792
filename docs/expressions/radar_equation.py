"""Signal power that a radar receives from a target, and its ratio to the noise of the receiver."""

import sympy as sp

from gainproof.derive.own_expressions.expressions import (
    Argument,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.quantity import KILOGRAM, METRE, ONE, SECOND, Quantity

WATT = KILOGRAM * METRE**2 / SECOND**3
SENT = Quantity("sent_power", "P_t", "power that the antenna radiates", WATT)
GAIN = Quantity("gain", "G", "gain of the antenna", ONE)
WAVELENGTH = Quantity("wavelength", r"\lambda", "wavelength", METRE)
AREA = Quantity("cross_section", r"\sigma", "radar cross section", METRE**2)
RANGE = Quantity("slant_range", "R", "range of the target", METRE)
NOISE = Quantity("noise_power", "N", "noise power of the receiver", WATT)
RECEIVED = Quantity("received_power", "P_r", "power that the antenna receives", WATT)
RATIO = Quantity("signal_to_noise", "S", "ratio of signal power and noise power", ONE)

P, G, wave, sigma, R, N = (each.symbol for each in (SENT, GAIN, WAVELENGTH, AREA, RANGE, NOISE))
POWER = P * G**2 * wave**2 * sigma / ((4 * sp.pi) ** 3 * R**4)

EXPRESSIONS = ExpressionSet(
    name="radar-equation",
    title="Radar equation",
    kernels=(
        ExpressionKernel(
            name="radar_equation",
            title="Power received from a point target in free space, and its ratio to the noise",
            inputs=(
                Argument(SENT, "1e-3", "1e7"),
                Argument(GAIN, "1", "1e5"),
                Argument(WAVELENGTH, "1e-3", "1e2"),
                Argument(AREA, "1e-6", "1e6", single=("1e-4", "1e4")),
                Argument(RANGE, "1", "1e8", single=("1", "1e5")),
                Argument(NOISE, "1e-20", "1e-6", single=("1e-16", "1e-6")),
            ),
            outputs=(Result(RECEIVED, POWER), Result(RATIO, POWER / N)),
        ),
    ),
)
