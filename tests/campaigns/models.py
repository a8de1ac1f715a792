"""Many models of one's own with odd entries:

    python tests/campaigns/models.py [--first N] [--count N]

Each is derived in a process of its own, whose time is limited; its certificate is gone through
again, and its gains are compared with SciPy's. What is neither derived nor refused by name, and
what is derived wrongly, is listed by its seed, and the status is then 1.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections import Counter
from pathlib import Path

HELP = "models of one's own with odd entries: derived, or refused by name"
SECONDS = 120
CODE = "import sys; from model_fuzz import drawn, outcome; print(outcome(drawn(int(sys.argv[1]))))"
SUPPORT = Path(__file__).parents[1] / "support"


def told(seed: int) -> str:
    """`derived`, `refused`, `too long`, or the last line of the fault."""
    command = [sys.executable, "-c", CODE, str(seed)]
    try:
        done = subprocess.run(
            command, cwd=SUPPORT, capture_output=True, text=True, timeout=SECONDS, check=False
        )
    except subprocess.TimeoutExpired:
        return "too long"
    if done.returncode:
        return f"fault: {(done.stderr.splitlines() or ['no word'])[-1][:200]}"
    return "derived" if done.stdout.strip() == "derived" else "refused"


def main() -> int:
    """Prints the tally; 1 if there was a fault."""
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--count", type=int, default=200, help="how many models")
    options = parser.parse_args()
    found = Counter[str]()
    for seed in range(options.first, options.first + options.count):
        said = told(seed)
        found[said.split(":")[0]] += 1
        if said.startswith("fault") or said == "too long":
            sys.stdout.write(f"seed {seed}: {said}\n")
    sys.stdout.write(", ".join(f"{count} {name}" for name, count in sorted(found.items())) + "\n")
    return int(found["fault"] > 0)


if __name__ == "__main__":
    sys.exit(main())
