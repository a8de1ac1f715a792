"""What is said of a stated domain in which a side has no value somewhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Outcome, Statement
from gainproof.verify.judge.freed.certificate import Decides
from gainproof.verify.judge.freed.freely import where_valued
from gainproof.verify.judge.freed.scaled import scaled
from gainproof.verify.judge.freed.smooth import Boxes


def but_where_it_has(
    nowhere: Outcome,
    statement: Statement,
    boxes: Boxes,
    parameter: str | None,
    labels: Mapping[str, str],
    decides: Decides,
) -> Outcome:
    """`conditional` if the statement holds somewhere of all points where every part has a value,
    everywhere of these or not; else as it is.
    """
    if not statement.symbols():
        return nowhere
    turned = scaled(statement, boxes, labels)
    loose = {name: replace(box, stated=False) for name, box in turned.boxes.items()}
    for where in (loose, *_with_open_ends(turned.statement, turned.boxes)):
        try:
            found = decides(turned.statement, where, parameter, turned.labels)
        except Undecided:
            continue
        if found.verdict == "conditional" and where is loose:
            return found
        if found.verdict == "proved":
            held = where_valued(found.domain) if where is loose else found.domain
            held = ", ".join([*turned.words, held])
            held = held if held.startswith("where") else f"for {held}"
            certificate = {**found.certificate, "decides": found.verdict}
            return replace(
                found,
                verdict="conditional",
                domain=held,
                reason=f"fails {nowhere.witness.text() if nowhere.witness else ''}; holds {held}",
                witness=nowhere.witness,
                certificate=certificate,
            )
    return nowhere


def _with_open_ends(statement: Statement, boxes: Boxes) -> Iterator[Boxes]:
    """The domain of the one symbol without one of its ends or both."""
    names = statement.symbols()
    if len(names) != 1:
        return
    (name,) = names
    box = boxes.get(name, Box())
    for lower, upper in ((False, True), (True, False), (True, True)):
        opened = replace(
            box, lower_open=box.lower_open or lower, upper_open=box.upper_open or upper
        )
        if opened != box:
            yield {name: opened}
