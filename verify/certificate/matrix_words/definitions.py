"""Statements of a setting that prove nothing: what a letter stands for, and cited theorems."""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.expression import expand_pair
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

STATED = ("definition", "cited")


def stated(setting: Setting, kind: str, place: str, claim: Plain, evidence: Plain) -> str:
    """definition {"text"} or {"left", "right"}, graphs: an element of the setting and
    what it stands for; cited {"theorem", "reference"}. Evidence: none.
    """
    schema.record(evidence, (), f"{place}.evidence")
    where = f"{place}.claim"
    if kind == "cited" or "text" in schema.table(claim, where):
        fields = ("theorem", "reference") if kind == "cited" else ("text",)
        for value in schema.record(claim, fields, where).values():
            schema.text(value, where)
    elif kind == "definition":
        sides = schema.record(claim, ("left", "right"), where)
        left, right = expand_pair(sides["left"], sides["right"], setting, where)
        spoken = left.letters()
        if not any(
            left == setting.letter(number) and right == meaning
            for number, meaning in setting.elements.items()
            if number in spoken
        ):
            raise RejectedError(f"{place}: the setting has no such element")
    else:
        raise MalformedError(f"{place}: {kind!r} is decided elsewhere")
    return kind
