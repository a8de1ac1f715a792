"""What other tools said, as a table."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from gainproof.certify.outcome import Outcome

HEAD = ("subject", "tool", "statements", "accepted", "seconds")


def row(outcome: Outcome) -> str:
    """A line of the table, with what was not accepted."""
    cells = (
        f"{outcome.subject:<40}{outcome.tool:<9}{outcome.statements:>10}"
        f"{outcome.accepted:>10}{outcome.seconds:>9.1f}"
    )
    said = f"  rejected: {outcome.rejected}" if outcome.rejected else ""
    return cells + ("  not finished in time" if outcome.unfinished else said)


def notes(outcome: Outcome) -> Iterator[str]:
    """What the tool found that is neither accepted nor rejected."""
    for note in outcome.notes:
        yield f"    {note}"


def head() -> str:
    return f"{HEAD[0]:<40}{HEAD[1]:<9}{HEAD[2]:>10}{HEAD[3]:>10}{HEAD[4]:>9}"


def foot(outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Sums by tool, and what was not handed over."""
    for tool in dict.fromkeys(outcome.tool for outcome in outcomes):
        own = [outcome for outcome in outcomes if outcome.tool == tool]
        accepted, seconds = sum(o.accepted for o in own), sum(o.seconds for o in own)
        yield (
            f"{tool}: {accepted} of {sum(o.statements for o in own)} statements accepted, "
            f"{sum(bool(o.rejected) for o in own)} subjects rejected, {seconds:.0f} s"
        )
        left_out: Counter[str] = Counter()
        for outcome in own:
            left_out.update(outcome.left_out)
        if left_out:
            parts = ", ".join(f"{count} {reason}" for reason, count in left_out.most_common())
            yield f"  not handed over: {parts}"
