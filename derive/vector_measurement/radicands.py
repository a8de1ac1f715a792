"""The squares of the roots from which the steady state is made, times S^2, without a subtraction.

Like the forms in `forms`, they work on anything with the operators + * /.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.vector_measurement.process_noise import Noise, times


def level_squared(noise: Noise, index: Any, ratio: Any) -> Any:
    """S^2 w^2 = S^2 + d Lambda^2; None where d = 0."""
    if not noise.determinant:
        return None
    return ratio * ratio + times(noise.determinant, index * index)


def eta_squared(noise: Noise, index: Any, ratio: Any) -> Any:
    """S^2 eta^2 = S^2 (16 + e Lambda^2) + Lambda^2 (4 + d Lambda^2); for n = 1/2 a product."""
    area, square = index * index, ratio * ratio
    first = times(noise.e, area) + 16 if noise.e else None
    if noise.interval:
        second = square * 4 + area
        return second * 4 if first is None else first * (second / 4)
    return first * square + area * 4


def delta_squared(noise: Noise, index: Any, ratio: Any, width: Any, eta_scaled: Any) -> Any:
    """S^2 delta^2 = S^2 (m^2 - 4), without a subtraction; `width` is S w."""
    area = index * index
    if not noise.interval:
        return area + (index * ratio) * ((index * ratio + eta_scaled) / 2)
    own = area * (noise.determinant / 2) + 1 if noise.determinant else 1
    return area * (times((1 + noise.e) / 4, ratio * ratio) + own) + (index * width) * (
        eta_scaled / 2
    )
