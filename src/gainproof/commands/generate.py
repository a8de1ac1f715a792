"""stub"""

import argparse

HELP = "generate"
DESCRIPTION = "generate"


def configure(parser: argparse.ArgumentParser) -> None: ...
def run(options: argparse.Namespace) -> int:
    return 0
