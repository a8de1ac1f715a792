"""Steps on what an exact velocity is worth: the improvement ratio, over the index alone."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto, limit
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.ends import FAR, SLOPE, index_tower, root_of_e
from gainproof.derive.vector_measurement.names import INDEX, ROOT
from gainproof.derive.vector_measurement.steps_limits import times_text
from gainproof.derive.vector_measurement.towers import rational

IMPROVEMENT = real("improvement")
KNOWN, ONLY = real("known_predicted_11"), real("only_predicted_11")


def improvement_steps(c: Context) -> list[Step]:
    """P11 with the velocity known over P11 without it; only where the first is not a polynomial."""
    noise = c.noise
    if not noise.determinant:
        return []
    tower, ends = index_tower(noise), improvement_ends(c)
    e, root = rational(noise.e), sp.sqrt(rational(noise.e))
    largest = sp.expand(sp.radsimp(4 * rational(noise.first) / (1 + root) ** 2))
    start = sp.sqrt(2) * root_of_e(noise)[0] / 4
    return [
        Step(
            "improvement",
            "Compare the predicted position's variance `P11^d` that an exact velocity leaves with "
            "`P11^o`, that without it. Their ratio `G` depends on the index alone.",
            equal(
                sp.ImmutableDenseMatrix([[IMPROVEMENT, KNOWN, FAR**2]]),
                sp.ImmutableDenseMatrix(
                    [
                        [
                            KNOWN / ONLY,
                            rational(noise.first) * INDEX**2 + 2 * INDEX / (INDEX + FAR),
                            INDEX**2 + 16 / e,
                        ]
                    ]
                ),
            ),
            "Steps @velocity-known-predicted-11 and @velocity-absent-predicted-11.",
            tower=tower.name,
            heading="What an exact velocity is worth",
        ),
        Step(
            "improvement-without",
            "Without the velocity the variance is that of the filter with position alone. Here "
            "`p^2 = Lambda`, and `p s` is the difference of that filter's `sigma` and `1/sigma`.",
            equal(
                ONLY,
                ROOT * SLOPE * (ROOT**2 + root_of_e(noise)[0] * FAR + 2 * ROOT * SLOPE) / 4,
            ),
            "That filter's page derives it, with "
            f"`eta = sqrt(16 + {times_text(e, 'Lambda^2')})`, that is `phi` times the root of {e}.",
            tower=tower.name,
        ),
        Step(
            "improvement-range",
            "The ratio grows with the index from 0 to this limit. So the larger the position's "
            "error (small `Lambda`, large `r`) the more the velocity helps, and it always helps by "
            "more than the limit says.",
            increasing_onto(IMPROVEMENT, sp.Integer(0), largest),
            "Its derivative is a quotient of sums without a minus sign; the leading terms of step "
            "@improvement at both ends of the index close the range.",
            tower=tower.name,
            hint={"form": _rising(tower), "ends": ends},
        ),
        Step(
            "improvement-small-index",
            "For a small index (large `r`) the ratio falls like the root of the index.",
            limit(IMPROVEMENT / ROOT, "0", start, "p"),
            "Here `phi` and `s` tend to their values at `Lambda = 0`; insert them in steps "
            "@improvement and @improvement-without.",
            tower=tower.name,
            hint={"ends": ends},
        ),
    ]


def _rising(tower: Tower) -> Fraction:
    """The derivative over (1 + root), which clears differences between a number and the root."""
    slope = derivative(tower, IMPROVEMENT, "tracking_index")
    names = [name for name in tower.variables if name.startswith("root_")]
    factor = tower.fraction(sp.Add(1, *map(real, names)))
    return tower.make(slope.num * factor.num, slope.den * factor.num)


def improvement_ends(c: Context) -> dict[str, End]:
    """The tower `without_ratio` at both ends of the index."""
    root, names = root_of_e(c.noise)
    held = {name: real(f"{name}_held") for name in names}
    constants = {f"{name}_held": number for name, number in names.items()}
    swap = {real(name): symbol for name, symbol in held.items()}
    inverse = sp.expand(4 * root.subs(swap) / rational(c.noise.e))
    near = {**held, "far": inverse, "s": real("root_2")}
    far = {**held, "far": sp.Integer(1), "s": (1 + root.subs(swap)) / 2}
    return {
        "0": End(constants={**constants, "root_2": 2}, boundary=near),
        "infinity": End(weights={"far": 2, "s": 1}, constants=constants, boundary=far),
    }
