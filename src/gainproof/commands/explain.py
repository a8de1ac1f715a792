"""`gainproof explain`: the whole proof or witness of one claim."""

from __future__ import annotations

import argparse

from gainproof.claims import time_limit

HELP = "print the whole proof or witness of one claim"
DESCRIPTION = """\
Prints all that is known about one claim of a claim file: what was decided, by which method, with
the certificate of a proof or the exact point where a formula fails. Of other claims that a proof on
matrices uses it prints what they say; their proofs are on their own pages. The certificate is gone
through again: proofs on matrices of every size by the checker of certificates, which knows nothing
of the judge, the others by the judge's own code. Exit status 1 if it leads elsewhere, or if an
accident such as a killed process kept the claim from being judged."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", metavar="FILE", help="a claim file, or the key of one of gainproof")
    parser.add_argument("claim", metavar="ID", help="the id of a claim")
    time_limit.configure(parser)
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0; 1 where the certificate does not lead to the verdict again; 2 for a claim that the file
    does not have.
    """
    import sys

    from gainproof import terminal_text
    from gainproof.claims import judgements
    from gainproof.claims.claim_proofs import checked
    from gainproof.claims.source_words import claim_words
    from gainproof.jobs.session import open_session
    from gainproof.verdicts.explanation import explanation

    file = judgements.find(options.file)
    session = open_session(fresh=options.fresh, quiet=True)
    claim = judgements.judge_claim(file, options.claim, session, options.seconds)
    words = claim_words(judgements.read(file)).get(options.claim, "")
    good, said = checked(claim)
    print(explanation(claim, terminal_text.width(), words, said), end="")
    if claim["accident"]:
        print(
            f"gainproof: not judged, by accident (ask again): {claim['accident']}", file=sys.stderr
        )
    return 0 if good and not claim["accident"] else 1
