"""Second derivatives of the enclosed steady state with respect to the tracking index.

Independent for the reason that the enclosure is: the Riccati equation differentiated twice is a
Lyapunov equation with the same closed loop, whose right side holds the change of the loop. With
L = F (I - K H) and P' = L P' L' + Q', P'' = L P'' L' + Q'' + D + D' where D = (dL) P' L' and
dL = -F K' H. No radical expression of any gain is used.
"""

from __future__ import annotations

from collections.abc import Mapping

import flint

from gainproof.verify.oracles import quantities
from gainproof.verify.oracles.ball import Enclosure, balls, enclose, lyapunov, rows
from gainproof.verify.oracles.matrices import Matrix
from gainproof.verify.oracles.spectrum import Spectrum
from gainproof.verify.oracles.state_space import Index, NotConverged, SteadyState, exact

LARGEST_DIGITS = 10_000


def second_slopes(
    spectrum: Spectrum, tracking_index: Index, digits: int = 40
) -> Mapping[str, tuple[flint.arb, flint.arb]]:
    """Second derivatives of gains and covariances by name, each with its scale.

    The scale is the derivative's own ball. ``predicted_11_by_terms`` is that of predicted_11, which
    may vanish, with another: 2 M11'^2/(1 + M11) - M11'', (1 + M11)^2 times how fast the gain
    1 - 1/(1 + M11) bends down. Of three states ``predicted_12_by_terms`` is M12'' with the scale
    M12'' - 2 M12' x'/x, where x = beta/gamma falls, and ``updated_ij_by_terms`` is X'' = M'' - U''
    with the scale M'' + U'', for the entries beyond the first row. Radii are at most 10^-digits of
    the scales; NotConverged where that is not reached.
    """
    index = exact(tracking_index)
    # the gains bend like its fourth inverse power
    above = max(index.numerator.bit_length() - index.denominator.bit_length(), 0)
    wanted = digits + 2 * above
    while wanted <= LARGEST_DIGITS:
        found = enclose(spectrum, index, wanted)
        with flint.ctx.workprec(found.bits):
            named = _scaled(found, quantities.named(*_second(spectrum, found)))
            if all(_settled(value, scale, digits) for value, scale in named.values()):
                return named
        wanted *= 2
    raise NotConverged(f"second derivatives: {digits} digits not reached")


def _settled(value: flint.arb, scale: flint.arb, digits: int) -> bool:
    bits = digits * 10 // 3 + 1
    if scale.rel_accuracy_bits() < bits:
        return False
    return bool(value.rad() * flint.arb(2) ** bits < abs(scale))


def _second(spectrum: Spectrum, found: Enclosure) -> tuple[SteadyState, Matrix]:
    """The second derivatives as a steady state, and that of F K."""
    model = spectrum.model
    f, h, q0 = balls(model.transition), balls(model.measurement), balls(model.process_noise)
    slope, gain, d_gain = (
        flint.arb_mat([list(row) for row in part])
        for part in (found.slope.predicted, found.state.gain, found.slope.gain)
    )
    unit = flint.arb_mat(model.size, model.size, _identity(model.size))
    innovation, d_innovation = found.state.innovation[0][0], found.slope.innovation[0][0]

    kept, d_kept = unit - gain * h, d_gain * h * -1
    loop, d_loop = f * kept, f * d_kept
    moved = d_loop * slope * loop.transpose()
    noise = q0 * flint.arb(2) + moved + moved.transpose()
    (bent,) = lyapunov(loop, (noise,))

    turned = d_kept * slope * kept.transpose()
    updated = kept * bent * kept.transpose() + turned + turned.transpose()
    column = kept * bent + d_kept * slope
    d2_gain = column * h.transpose() * (1 / innovation) - d_gain * (d_innovation / innovation)
    state = SteadyState(*map(rows, (bent, updated, d2_gain, h * bent * h.transpose())))
    return state, rows(f * d2_gain)


def _identity(size: int) -> list[int]:
    return [int(i == j) for i in range(size) for j in range(size)]


def _scaled(
    found: Enclosure, named: Mapping[str, flint.arb]
) -> Mapping[str, tuple[flint.arb, flint.arb]]:
    innovation, slope = found.state.innovation[0][0], found.slope.innovation[0][0]
    own = named["predicted_11"]
    both = {name: (value, value) for name, value in named.items()}
    both["predicted_11_by_terms"] = own, 2 * slope * slope / innovation - own
    if "gamma" not in named:
        return both
    at, d = quantities.values(found), quantities.slopes(found)
    falling = d["beta"] / at["beta"] - d["gamma"] / at["gamma"]
    turning = named["predicted_12"]
    both["predicted_12_by_terms"] = turning, turning - 2 * d["predicted_12"] * falling
    for place in ("22", "23", "33"):
        after = named[f"updated_{place}"]
        both[f"updated_{place}_by_terms"] = after, 2 * named[f"predicted_{place}"] - after
    return both
