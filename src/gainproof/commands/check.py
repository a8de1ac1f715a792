"""stub"""

import argparse

HELP = "check"
DESCRIPTION = "check"


def configure(parser: argparse.ArgumentParser) -> None: ...
def run(options: argparse.Namespace) -> int:
    return 0
