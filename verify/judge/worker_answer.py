"""What a child process answers, as JSON text: a child handles hostile input, so its answer is data
and is never unpickled.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import fields
from typing import Any

from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.convention import Unusable
from gainproof.verify.judge.exact.statement import Enclosure, Witness
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import Finding

MOST_BYTES = 16 << 20
"""Size of one answer; certificates take a few thousand bytes."""
RECORDS = {record.__name__: record for record in (Finding, Witness, Enclosure, Unusable)}
"""What an answer may hold besides numbers, texts, lists and mappings."""


class BadAnswer(ValueError):
    """Bytes that are no answer."""


def answer_bytes(trial: Trial) -> bytes:
    """All of a trial but its claim, which whoever asked has; a failure in place of what is longer
    than `MOST_BYTES`.
    """
    found = {f.name: _plain(getattr(trial, f.name)) for f in fields(trial) if f.name != "claim"}
    data = json.dumps(found).encode()
    if len(data) <= MOST_BYTES:
        return data
    reason = f"the evidence takes {len(data)} bytes, but at most {MOST_BYTES} are kept"
    return answer_bytes(Trial(trial.claim, {}, (), False, trial.seconds, reason))


def read_answer(data: bytes, claim: Claim) -> Trial:
    """The trial of a claim. Raises BadAnswer."""
    try:
        found = {name: _record(value) for name, value in json.loads(data).items()}
        return Trial(claim=claim, **{**found, "unusable": tuple(found["unusable"])})
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise BadAnswer(f"an answer that cannot be read: {type(error).__name__}") from None


def _plain(value: object) -> Any:
    """Records and mappings are told apart by a name in front."""
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, Mapping):
        return {"mapping": {str(key): _plain(inner) for key, inner in value.items()}}
    if isinstance(value, Sequence):
        return [_plain(inner) for inner in value]
    name = type(value).__name__
    if RECORDS.get(name) is not type(value):
        raise TypeError(f"{name} is no part of an answer")
    # what is as it is unless said otherwise need not be said
    said = {f.name: getattr(value, f.name) for f in fields(RECORDS[name])}
    defaults = {f.name: f.default for f in fields(RECORDS[name])}
    return {name: {key: _plain(inner) for key, inner in said.items() if inner != defaults[key]}}


def _record(value: Any) -> Any:
    if isinstance(value, list):
        return [_record(inner) for inner in value]
    if not isinstance(value, dict):
        return value
    ((name, inner),) = value.items()
    content = {key: _record(part) for key, part in inner.items()}
    return content if name == "mapping" else RECORDS[name](**content)
