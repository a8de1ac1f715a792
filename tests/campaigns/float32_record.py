"""Brings `float32.md`, the record of the sweep of all float32 inputs, up to date.

    python tests/campaigns/float32_record.py [STATE ...] [--missing]

STATE is a state file of `gainproof campaign float32`. Kernels of which every block was done come
into the record, in place of older rows; rows of a digest that no kernel has any more are dropped,
the others keep what was measured and get the bounds that are stated now. `--missing` prints the
names of the kernels without a row, for the next sweep, and changes nothing.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))

from float32_rows import KERNELS, RECORD, Recorded, document, rows_of, same_digest

from gainproof.campaign import float32, state


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, prog=Path(__file__).name)
    parser.add_argument("states", metavar="STATE", nargs="*", type=Path)
    parser.add_argument("--missing", action="store_true")
    options = parser.parse_args()
    known: dict[str, Recorded] = {}
    campaign = float32.campaign()
    tables = [RECORD.read_text("utf-8")]
    for path in options.states:
        done = state.read(path, campaign)
        tables.append(campaign.report([done[number] for number in sorted(done)]).text)
    for table in tables:
        known |= {row.digest: row for row in rows_of(table) if row.whole}
    if options.missing:
        left = (names[0] for digest, names in same_digest().items() if digest not in known)
        sys.stdout.write(" ".join(left) + "\n")
        return 0
    rows = [known[digest] for digest in same_digest() if digest in known]
    RECORD.write_text(document(rows), encoding="utf-8")
    named = sum(len(same_digest()[row.digest]) for row in rows)
    count = f"{named} of {len(KERNELS)} kernels are recorded"
    sys.stdout.write(f"{count}, {len(known) - len(rows)} rows dropped\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
