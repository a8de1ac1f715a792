"""Steps on how a filter answers its one input: transfer functions, control loop, recursion."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.loop import Loop, product, row
from gainproof.derive.fixed_gain.steps_filter import EQUATIONS, STATE, given
from gainproof.derive.relation import equal

Z = real("z")
OBSERVED = tuple(real(name) for name in ("z1", "z2", "z3"))


def answer_steps(loop: Loop) -> list[Step]:
    """One input, several outputs."""
    return [*_transfer(loop), *_controller(loop), *_recursion(loop)]


def _numerators(loop: Loop) -> list[sp.Expr]:
    """What stands over c(z) in the transfer functions to the smoothed state."""
    system = sp.Matrix(Z * sp.eye(loop.size) - loop.smoothed)
    answer = system.adjugate(method="berkowitz") * sp.Matrix(Z * loop.column)
    return [sp.expand(x) for x in answer]


def _transfer(loop: Loop) -> list[Step]:
    size = loop.size
    shown = sp.ImmutableDenseMatrix([sp.factor(x) / loop.polynomial(Z) for x in _numerators(loop)])
    free = ("z", *loop.gain_names)
    system = sp.ImmutableDenseMatrix(Z * sp.eye(size) - loop.smoothed)
    other = sp.expand(system.det(method="berkowitz"))
    return [
        Step(
            "characteristic",
            "The error of a prediction goes on by `F (I - K H)`, the smoothed state by "
            "`(I - K H) F`; both have the characteristic polynomial `c(z)`.",
            equal(
                row(loop.polynomial(Z), other),
                row(*[sp.collect(loop.polynomial(Z), Z)] * 2),
                free=free,
            ),
            "Expand both determinants; `A B` and `B A` always have the same one.",
            tower=EQUATIONS,
        ),
        Step(
            "transfer",
            "One input, several outputs: from the observed position to the smoothed state the "
            "filter has the transfer functions `G(z)`, all over the same `c(z)`.",
            equal(product(system, shown), sp.ImmutableDenseMatrix(Z * loop.column), free=free),
            "`x(k) = (I - K H) F x(k - 1) + K z(k)`, so `(z I - (I - K H) F) G = z K`.",
            tower=EQUATIONS,
        ),
    ]


def _controller(loop: Loop) -> list[Step]:
    """From the innovation to the state: the open loop."""
    size = loop.size
    open_loop = Z * sp.eye(size) - loop.transition
    sums = [Z / (Z - 1), Z / (Z - 1) ** 2, Z * (Z + 1) / (2 * (Z - 1) ** 3)]
    top = sum((g * s for g, s in zip(loop.gains, sums, strict=False)), sp.Integer(0))
    second = sum((g * s for g, s in zip(loop.gains[1:], sums, strict=False)), sp.Integer(0))
    parts: list[sp.Expr] = [top, second, *[loop.gains[-1] * sums[0]] * (size - 2)]
    command = sum(
        (g * s for g, s in zip(loop.gains, (1, 1 / (Z - 1)), strict=False)), sp.Integer(0)
    )
    if size == 3:
        command += loop.gains[2] * (Z + 1) / (2 * (Z - 1) ** 2)
    free = ("z", *loop.gain_names)
    kind = (
        "a proportional part `alpha` and an integral part `beta`"
        if size == 2
        else "a proportional part, an integral part and the integral of an integral"
    )
    return [
        Step(
            "open-loop",
            "As a control loop: the innovation is the error, the state follows from it by sums of "
            "sums.",
            equal(
                product(sp.ImmutableDenseMatrix(open_loop), sp.ImmutableDenseMatrix(parts)),
                sp.ImmutableDenseMatrix(Z * loop.column),
                free=free,
            ),
            "`x(k) = F x(k - 1) + K e(k)` with the innovation `e`, so `(z I - F) G = z K`.",
            tower=EQUATIONS,
        ),
        Step(
            "controller",
            f"The smoothed position sums up what {kind} command, `z/(z - 1)` being a sum: a "
            "filter is a PID controller of the position without a differential part"
            + (", hence PI." if size == 2 else ", but with one more integral."),
            equal(
                row(top),
                row(Z / (Z - 1) * command),
                free=free,
            ),
            "Take the sum out of step @open-loop's first row.",
            tower=EQUATIONS,
        ),
    ]


def _recursion(loop: Loop) -> list[Step]:
    """Each output alone: a recursive filter of infinite impulse response."""
    size = loop.size
    seen = OBSERVED[:size]
    states = [sp.ImmutableDenseMatrix(STATE[:size])]
    for entry in seen:
        states.append(sp.ImmutableDenseMatrix(loop.smoothed * states[-1] + loop.column * entry))
    feedback = sp.Poly(loop.polynomial(Z), Z).all_coeffs()[1:]
    forward = [sp.Poly(x, Z).all_coeffs() for x in _numerators(loop)]
    past = list(reversed(states[:-1]))
    shown = [
        sum((-c * x[n] for c, x in zip(feedback, past, strict=True)), sp.Integer(0))
        + sum((b * x for b, x in zip(forward[n], reversed(seen), strict=False)), sp.Integer(0))
        for n in range(size)
    ]
    return [
        Step(
            "recursive-filter",
            "Each output alone is a recursive (IIR) filter: of the observations, here "
            f"{', '.join(f'`{x}`' for x in seen)}, and of its own values before, with the same "
            "feedback coefficients for all outputs, those of `c(z)`.",
            equal(states[-1], sp.ImmutableDenseMatrix(shown), free=given(loop, *seen)),
            f"{('Two', 'Three')[size - 2]} samples of step @matrix-form with `t = 1`.",
            tower=EQUATIONS,
            shown=size == 2,
        ),
    ]
