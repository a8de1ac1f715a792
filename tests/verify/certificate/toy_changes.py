"""Changing toy certificates in place, and asking what became of one statement."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

from gainproof.verify.certificate import check, check_statement

Data = dict[str, Any]


def statement(certificate: Data, identifier: str) -> Data:
    """The statement of that id, to be changed in place."""
    return next(s for s in certificate["statements"] if s["id"] == identifier)


def reason(certificate: Data, identifier: str) -> str:
    """Why this statement is rejected or given up; empty when it is neither."""
    result = check_statement(certificate, identifier)
    assert (result.status in ("rejected", "given up")) == bool(result.reason)
    return result.reason


def only(certificate: Data, identifier: str) -> Data:
    """The certificate with this statement alone (towers and programs kept)."""
    return {**certificate, "statements": [statement(certificate, identifier)]}


def changed(certificate: Data, identifier: str, path: str, new: Any) -> str:
    """Why the statement is rejected once the value at a dotted path in it is another one."""
    altered = deepcopy(certificate)
    place: Any = statement(altered, identifier)
    *steps, last = path.split(".")
    for step in steps:
        place = place[int(step) if isinstance(place, list) else step]
    key: Any = int(last) if isinstance(place, list) else last
    assert place[key] != new, "this changes nothing"
    place[key] = new
    return reason(altered, identifier)


def refused(certificate: Data) -> str:
    """Why the whole certificate is rejected; empty when it is accepted."""
    report = check(certificate)
    assert report.accepted == (not report.reason)
    return report.reason
