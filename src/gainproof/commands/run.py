"""stub"""

import argparse

HELP = "run"
DESCRIPTION = "run"


def configure(parser: argparse.ArgumentParser) -> None: ...
def run(options: argparse.Namespace) -> int:
    return 0
