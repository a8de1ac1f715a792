"""Conversions of polar measurements over many draws: normalised errors, and definite covariances.

    python tests/campaigns/conversions.py [--draws N] [--inputs N] [--seed N] [--trust P]

For several targets every conversion under each condition: mean error along the line of sight, mean
of e' P^-1 e over the number of coordinates with its interval, and its expectation. Then how often
of random inputs the covariance is positive definite as computed, from the printed form and from the
kernel. If all is as expected, `--trust` is how often the campaign, all comparisons together,
nevertheless ends with status 1.
"""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from statistics import NormalDist

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from converted_definite import definite, definite_correlated
from converted_monte_carlo import Normalised, Scene, normalised

HELP = "conversions of polar measurements over many draws"
DEGREE = math.radians(1)
SCENES = (
    Scene((20e3, 0.0, 0.7), (50.0, 0.0, DEGREE)),
    Scene((100e3, 0.0, 0.7), (50.0, 0.0, DEGREE)),
    Scene((400e3, 0.0, 0.7), (50.0, 0.0, DEGREE)),
    Scene((100e3, 0.0, 0.7), (50.0, 0.0, 15 * DEGREE)),
    Scene((100e3, 0.5, 0.7), (50.0, DEGREE, 2 * DEGREE)),
)


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--draws", type=int, default=200_000)
    parser.add_argument("--inputs", type=int, default=1_000_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--trust", type=float, default=1e-6)
    options = parser.parse_args()
    outcomes = [
        normalised(scene, options.draws, options.seed + number)
        for number, scene in enumerate(SCENES)
    ]
    every = [each for outcome in outcomes for each in outcome]
    allowed = -NormalDist().inv_cdf(options.trust / 2 / len(every))
    lines = []
    for scene, outcome in zip(SCENES, outcomes, strict=True):
        lines += shown(scene, outcome)
    worst = max(every, key=lambda each: each.off)
    lines.append(
        f"{len(every)} comparisons, {allowed:.2f} deviations allowed for {options.trust:g} of all "
        f"campaigns; worst {worst.off:.2f}: {worst.name} given the {worst.condition}\n"
    )
    lines.append(f"positive definite, of {options.inputs} random inputs: printed, kernel, axes")
    found = definite(options.inputs, options.seed)
    lines += [
        f"  {each.name:18}{each.printed:12.4%}{each.kernel:12.4%}{each.axes:12.4%}"
        for each in found
    ]
    correlated = definite_correlated(options.inputs, options.seed)
    lines += [f"  {name:30}{share:12.4%}" for name, share in correlated.items()]
    sys.stdout.write("\n".join([*lines, ""]))
    fell_short = any(each.axes < 1 for each in found) or min(correlated.values()) < 1
    return int(worst.off > allowed or fell_short)


def shown(scene: Scene, outcome: list[Normalised]) -> list[str]:
    """A line for each conversion and condition; the interval is that of 99 %."""
    r, e, _ = scene.place
    sr, se, sa = (scene.deviations[0], *map(math.degrees, scene.deviations[1:]))
    rising = f", elevation {e:g} with {se:g} deg" if se else ""
    heads = f"{'given the':>12}{'bias, m':>12}{'squared':>12}{'+-':>9}{'expected':>11}"
    rows = [
        f"  {each.name:18}{each.condition:>12}{each.bias:12.2f}{each.found:12.4f}"
        f"{2.576 * each.deviation:9.4f}{each.expected:11.4f}"
        for each in outcome
    ]
    title = f"range {r / 1e3:g} km, noise {sr:g} m, {sa:g} deg{rising}"
    return [title, f"  {'':18}{heads}", *rows, ""]


if __name__ == "__main__":
    raise SystemExit(main())
