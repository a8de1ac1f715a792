"""Every equation of the claim files made false by its dimensions alone, and put before the judge.

    python tests/campaigns/dimensions.py [--only TEXT]

Each part of an equation, and of each definition that it uses, is multiplied by a symbol that is 1
and has a unit. Where an equation was true, and is false in other units of length and time, the
judge has to say that its dimensions do not agree; where one as printed stays true, the judge may
not. Integrals are left out: they are taken by numbers. Status 1 where the judge is wrong.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from claim_campaign.mixed_units import mixed_units
from claim_campaign.proved import claim_paths

from gainproof.derive.catalogue import CATALOGUE

HELP = "every equation of the claim files made false by its dimensions alone"


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--only", default="", help="text that the name of a claim must contain")
    options = parser.parse_args()
    every = [data for entry in CATALOGUE if (data := entry.build().model_data)]
    models = list({data["name"]: data for data in every}.values())
    total: Counter[str] = Counter()
    wrong: list[str] = []
    for path in claim_paths():
        counts, found = mixed_units(path, models, options.only)
        total += counts
        wrong += found
        tell(path.stem, counts)
    tell("all files", total)
    sys.stdout.writelines(f"WRONG {words}\n" for words in wrong)
    return 1 if wrong else 0


def tell(name: str, counts: Counter[str]) -> None:
    """One line of counts."""
    told = [name, *(f"{words}: {number}" for words, number in sorted(counts.items()))]
    sys.stdout.write("; ".join(told) + "\n")


if __name__ == "__main__":
    sys.exit(main())
