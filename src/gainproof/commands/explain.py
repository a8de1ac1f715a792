"""stub"""

import argparse

HELP = "explain"
DESCRIPTION = "explain"


def configure(parser: argparse.ArgumentParser) -> None: ...
def run(options: argparse.Namespace) -> int:
    return 0
