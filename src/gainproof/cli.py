"""The command line: `gainproof COMMAND`. Nothing heavy is imported before a command needs it."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from gainproof.version import VERSION


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="gainproof")
    parser.add_argument("--version", action="version", version=f"gainproof {VERSION}")
    parser.parse_args(arguments)
    return 0


if __name__ == "__main__":
    sys.exit(main())
