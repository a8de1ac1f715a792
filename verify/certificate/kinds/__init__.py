"""The kinds of statements a certificate may hold, each with the function that decides it.

A function takes the statement's case and returns "proved", "cited" or "definition", or raises
RejectedError.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from gainproof.verify.certificate.checked_statement import Case
from gainproof.verify.certificate.kinds.definitions import cited, definition
from gainproof.verify.certificate.kinds.finite_sums import finite_sum
from gainproof.verify.certificate.kinds.identity import equal, positive, same_sign
from gainproof.verify.certificate.kinds.limits import increasing_onto, limit, monotone
from gainproof.verify.certificate.kinds.positive_definite import positive_definite
from gainproof.verify.certificate.kinds.program import program
from gainproof.verify.certificate.kinds.riccati import riccati
from gainproof.verify.certificate.kinds.stability import stable

KINDS: Mapping[str, Callable[[Case], str]] = MappingProxyType(
    {
        "equal": equal,
        "positive": positive,
        "same_sign": same_sign,
        "limit": limit,
        "increasing_onto": increasing_onto,
        "monotone": monotone,
        "riccati": riccati,
        "stable": stable,
        "positive_definite": positive_definite,
        "program": program,
        "sum": finite_sum,
        "definition": definition,
        "cited": cited,
    }
)
