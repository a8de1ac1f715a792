"""How the checker of certificates decides a statement of each kind, in a sentence for readers."""

from __future__ import annotations

from collections.abc import Mapping

_BY_COMBINATION = (
    "each entry is expanded as a polynomial and is the combination of the defining equations that "
    "the certificate holds"
)
_IN_WORDS = "words in letters that do not commute, for every size of the matrices"
HOW: Mapping[str, str] = {
    "equal": "both sides are the same element of the tower of radicals, in exact arithmetic",
    "positive": "numerator and denominator are polynomials whose coefficients show their sign",
    "same_sign": "the quotient of both sides is positive, by polynomials that show their sign",
    "limit": "leading terms at the end of the domain, exactly",
    "increasing_onto": "the derivative is positive, and the limits at both ends are exact",
    "monotone": "the sign of the derivative, exactly",
    "riccati": f"the Riccati equation and the gain: {_BY_COMBINATION}",
    "stable": "the rows of Schur and Cohn of the characteristic polynomial are positive",
    "positive_definite": "every leading minor is positive",
    "program": "the graph that the kernel is printed from has these values, in exact arithmetic",
    "sum": "induction: first term, and the step from k to k + 1, as polynomials",
    "definition": "nothing to decide: it says what a name means",
    "cited": "a published theorem, used and not proved here",
    "matrix_equal": _IN_WORDS,
    "matrix_order": f"a sum of squares with cofactors: {_IN_WORDS}",
    "matrix_invertible": f"an inverse from one side, or definiteness: {_IN_WORDS}",
    "matrix_trace": f"factors of a trace turned in a circle: {_IN_WORDS}",
}


def how(kind: str) -> str:
    """The sentence, or the name of a kind that has none."""
    return HOW.get(kind, kind.replace("_", " "))
