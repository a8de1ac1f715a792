"""Formulas read without a symbol table: what the reader misses is declared, one name at a time.

A name is a number until a transpose or an inverse shows that it is a matrix, or brackets with a
relation outside that it is a function; the helper asks the reader's errors only, never the text.
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.judge.formula import Formula
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula

MOST_ROUNDS = 200


@dataclass(frozen=True)
class Declared:
    """A symbol as the reader asks for it."""

    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False


def matrix_like(name: str) -> bool:
    """Whether a name is printed like a vector: underlined or bold."""
    marks = ("\\underline", "\\mathbf", "\\boldsymbol")
    return any(mark in name.partition("_")[0] for mark in marks)


def declared_until_read(
    latex: str, matrices: frozenset[str] = frozenset(), branch: str | None = "upper"
) -> tuple[Formula | None, ReaderError | None, dict[str, Declared]]:
    """The formula with every name it uses declared, or the error that no declaration mends."""
    symbols: dict[str, Declared] = {"k": Declared()}
    error: ReaderError | None = None
    for _ in range(MOST_ROUNDS):
        try:
            return read_formula(latex, symbols, branch), None, symbols
        except ReaderError as found:
            error = found
        if "is not declared" in error.problem and "matrix" not in error.problem:
            try:
                name = canonical_token(error.token)
            except ReaderError:
                break
            if name in symbols:
                break
            shape = (1, 1) if matrix_like(name) or name in matrices else None
            symbols[name] = Declared(shape=shape)
        elif "as an integer" in error.problem:
            symbols[error.token] = Declared(integer=True)
        elif "two vectors in parentheses" in error.problem:
            before = latex[: error.position].rstrip()
            called = [name for name in symbols if before.endswith(name)]
            if not called:
                break
            symbols[max(called, key=len)] = Declared(arguments=("k",))
        elif "not declared as a matrix" in error.problem:
            capitals = [n for n, e in symbols.items() if e.shape is None and _capital(n)]
            if not capitals:
                break
            symbols |= dict.fromkeys(capitals, Declared(shape=(1, 1)))
        else:
            break
    return None, error, symbols


def _capital(name: str) -> bool:
    letters = name.replace("\\hat{", "").replace("\\tilde{", "").replace("\\dot{", "")
    return letters[:1].isupper() or letters.startswith(("\\Phi", "\\phi", "\\Gamma", "\\Psi"))
