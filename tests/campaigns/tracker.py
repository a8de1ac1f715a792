"""The tracker on many targets: scans per second, memory, tracks kept and swapped.

    python tests/campaigns/tracker.py [--targets N] [--scans N] [--seed N] [--bearing DEG]
                                      [--false-alarms N] [--filter NAME]

Targets fly circles between 20 and 110 km, 95 % of them are detected in each scan, with false alarms
beside them. For each filter: scans a second from detections to tracks, the most memory beside what
was there before (as tracemalloc sees NumPy's arrays, in a run of its own), the number of tracks,
targets whose detections lie in one track alone, changes from one target to another within a track,
false alarms in tracks, detections of targets that no track took.
"""

from __future__ import annotations

import argparse
import sys
import time
import tracemalloc
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from tracker_scene import Drawn, Scene, drawn, judged

from gainproof.tracking import FILTERS, Settings, followed

HELP = "the tracker on many targets: scans per second, memory, tracks kept and swapped"
HEADS = ("filter", "scans/s", "MB", "tracks", "kept", "swaps", "false", "lost")


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--targets", type=int, default=300)
    parser.add_argument("--scans", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--bearing", type=float, default=1.0, help="its deviation, degrees")
    parser.add_argument("--false-alarms", type=float, default=30.0, help="in a scan")
    parser.add_argument("--filter", choices=[*FILTERS], help="one alone")
    options = parser.parse_args()
    scene = Scene(
        targets=options.targets,
        scans=options.scans,
        seed=options.seed,
        bearing_deviation=float(np.deg2rad(options.bearing)),
        false_alarms=options.false_alarms,
    )
    given = drawn(scene)
    total = len(given.target)
    sys.stdout.write(f"{scene.targets} targets, {scene.scans} scans, {total} detections\n")
    sys.stdout.write("".join(f"{head:>{9 if i else 22}}" for i, head in enumerate(HEADS)) + "\n")
    for name in [options.filter] if options.filter else FILTERS:
        sys.stdout.write(_row(given, scene, name) + "\n")
        sys.stdout.flush()
    return 0


def _row(given: Drawn, scene: Scene, name: str) -> str:
    settings = Settings(filter=name)
    begin = time.perf_counter()
    found = followed(given.scans, settings)
    speed = scene.scans / (time.perf_counter() - begin)
    tracemalloc.start()
    followed(given.scans, settings)
    memory = tracemalloc.get_traced_memory()[1] / 1e6
    tracemalloc.stop()
    told = judged(given, found, scene.targets)
    cells = (
        f"{speed:.0f}",
        f"{memory:.1f}",
        str(told.tracks),
        str(told.kept),
        str(told.swaps),
        str(told.false_alarms),
        f"{told.lost:.2%}",
    )
    return f"{name:>22}" + "".join(f"{cell:>9}" for cell in cells)


if __name__ == "__main__":
    raise SystemExit(main())
