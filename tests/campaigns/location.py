"""Example 1 of kosuge-doppler over many draws of noise and several sets of biases.

    python tests/campaigns/location.py [--runs N] [--seed N] [--false-alarm P] [--trust P]

For every set of biases of B1 to B4 in m: RMS errors with 0, 2 and 4 ranges taken as clean and
with those that the test (55) chooses, beside the deviations of the covariance; how often each range
is called biased, beside the noncentral chi-square distribution. What theory says something of is
compared with it; if all is as theory says, `--trust` is how often the campaign, all comparisons
together, nevertheless ends with status 1.
"""

from __future__ import annotations

import argparse
import sys
from statistics import NormalDist

import numpy as np

from gainproof.location.monte_carlo import Outcome, compared, simulate

HELP = "example 1 of kosuge-doppler over many draws of noise and several sets of biases"
SETS = (
    (0, 0, 0, 0),
    (0, 0, 30, 20),
    (0, 0, 60, 40),
    (0, 0, 120, 90),
    (50, 0, 0, 80),
    (-40, 60, 90, 30),
)


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--runs", type=int, default=20_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--false-alarm", type=float, default=0.05)
    parser.add_argument("--trust", type=float, default=1e-6)
    options = parser.parse_args()
    outcomes = [
        simulate(biases, options.runs, options.seed + i, options.false_alarm)
        for i, biases in enumerate(SETS)
    ]
    everything = [each for outcome in outcomes for each in compared(outcome)]
    allowed = -NormalDist().inv_cdf(options.trust / 2 / len(everything))
    worst = max(everything, key=lambda each: each.off)
    lines = [line for outcome in outcomes for line in shown(outcome)]
    lines.append(
        f"{len(everything)} comparisons with theory, {allowed:.2f} deviations allowed for "
        f"{options.trust:g} of all campaigns; worst {worst.off:.2f}: {worst.what} "
        f"{worst.found:.5g}, theory {worst.theory:.5g}\n"
    )
    sys.stdout.write("\n".join(lines))
    lost = [each for outcome in outcomes for each in outcome.errors if each.converged < 1]
    return int(worst.off > allowed or bool(lost))


def shown(outcome: Outcome) -> list[str]:
    """RMS errors with the covariance's deviations in brackets; rates with those of theory."""
    biases = ", ".join(f"{bias:g}" for bias in outcome.biases)
    heads = "".join(f"{head:>18}" for head in ("x, m", "y, m", "vx, m/s", "vy, m/s"))
    lines = [f"biases {biases} m, {outcome.runs} runs: RMS errors (promised), converged"]
    lines.append(f"  {'':8}{heads}")
    for each in outcome.errors:
        cells = [
            f"{rms:.4g} ({promised:.4g})" if np.isfinite(promised) else f"{rms:.4g}"
            for rms, promised in zip(each.rms, each.promised, strict=True)
        ]
        line = "".join(f"{cell:>18}" for cell in cells)
        lines.append(f"  {each.name:8}{line}  {each.converged:.2%}")
    rates = zip(outcome.called, outcome.theory, strict=True)
    told = ", ".join(f"{rate:.4f} ({theory:.4f})" for rate, theory in rates)
    lines.append(f"  called biased (theory): {told}; clean on average {outcome.clean:.2f}\n")
    return lines


if __name__ == "__main__":
    raise SystemExit(main())
