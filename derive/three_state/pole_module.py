"""What the printed kernel of the closed-loop poles says of itself."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from gainproof.derive.three_state.context import Context

SUMMARY = "Poles: the real one; of the other two modulus, half sum, half the distance squared."
MEANINGS: Mapping[str, str] = MappingProxyType(
    {
        "real_pole": "positive pole, the one that is real for every index",
        "modulus": "geometric mean of the moduli of the other two, that of each while they are "
        "complex",
        "half_sum": "half the sum of these two, the real part of each while they are complex",
        "quarter_discriminant": "square of half their difference, negative while they are complex",
    }
)


def equations(c: Context) -> tuple[str, ...]:
    """The lines on what the outputs are."""
    known = (
        "c(z) = (z - real_pole) (z^2 - 2 half_sum z + modulus^2),",
        "quarter_discriminant = half_sum^2 - modulus^2,",
    )
    if c.spectrum.rational_in_root:
        return (
            *known,
            "real_pole = w = 1/sigma, modulus = sqrt(w), half_sum = (xi^2 - 8)/(xi^2 + 2 xi),",
            "xi^3 - 4 xi = 64/Lambda",
        )
    m1, m2 = c.spectrum.m1, c.spectrum.m2
    linear = f" + {1 - m1} G" if m1 != 1 else ""
    rise = "" if m1 == 1 else f"{2 - m1} "
    cubic = f"G (G^2 + {rise}G + {1 - m1 + m2})"
    last = f"G^2{linear}{f' + {m2}' if m2 else ''}"
    return (
        *known,
        f"{cubic} = 64/Lambda^2, t = sqrt(1 + G), g = sqrt({last}),",
        f"a = sqrt({m1} + 2 g - G), real_pole = (t - 1)/(t + 1), half_sum = (g - 1)/(1 + a + g)",
    )
