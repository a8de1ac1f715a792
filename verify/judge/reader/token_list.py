"""Tokens collected in order, and how many arguments of a command are still to come."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_DEPTH
from gainproof.verify.judge.reader.tokens import TAKES_ARGUMENTS, FormulaToken


class TokenList:
    """`found` are the tokens. Where a command still takes arguments, `single` says that a digit or
    a letter stands for itself alone, as in TeX.
    """

    def __init__(self, text: str) -> None:
        self.found: list[FormulaToken] = []
        self._text = text
        self._waiting = 0
        self._outer: list[int] = []
        self._open: list[int] = []
        self._last_group = 0
        self._bare_fractions = 0

    @property
    def single(self) -> bool:
        """Whether the next token is an argument without braces."""
        return self._waiting > 0

    def takes_bound(self) -> bool:
        """Whether a superscript here is the bound of a sum or an integral, and no mark of a
        transpose: `\\int_0^T`.
        """
        found, last = self.found, len(self.found)
        if last and found[-1].kind == "RIGHT_BRACE":
            last = self._last_group
        elif last > 1 and found[-2].kind == "UNDER":
            last -= 1
        if last and found[last - 1].kind == "UNDER":
            last -= 1
        return last > 0 and found[last - 1].kind in ("SUM", "INTEGRAL")

    def add(self, token: FormulaToken) -> None:
        """One more token. ReaderError where fractions without braces nest too deep."""
        kind = token.kind
        if kind in ("SUM", "PARTIAL_OPERATOR") and self.found and self.found[-1].kind == "DOT":
            # the grammar looks one token ahead: this dot ends a product instead of continuing it
            self.found[-1] = replace(self.found[-1], kind="DOT_BEFORE_BIG")
        self._bare_fractions += kind == "FRAC" and self._waiting > 0
        if self._bare_fractions > MOST_DEPTH:
            problem = f"more than {MOST_DEPTH} fractions without braces, which nest"
            raise ReaderError(problem, self._text, token.start, token.value)
        self.found.append(token)
        self._count(kind)

    def _count(self, kind: str) -> None:
        """What the token does to the arguments still to come; braces keep those round them."""
        if kind == "LEFT_BRACE":
            self._open.append(len(self.found) - 1)
            self._outer.append(max(0, self._waiting - 1))
            self._waiting = 0
        elif kind == "ROOT_OPEN":
            self._outer.append(self._waiting)
            self._waiting = 0
        elif kind in ("RIGHT_BRACE", "ROOT_CLOSE"):
            if kind == "RIGHT_BRACE" and self._open:
                self._last_group = self._open.pop()
            self._waiting = self._outer.pop() if self._outer else 0
        else:
            self._waiting = max(0, self._waiting - 1) + TAKES_ARGUMENTS.get(kind, 0)
