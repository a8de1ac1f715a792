"""The d of a derivative and of an integral: `\\partial`, `\\mathrm{d}`, or a letter d that nobody
declared.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gainproof.verify.judge.reader.alphabet import command_at, is_letter, skip_space
from gainproof.verify.judge.reader.names import scan_base
from gainproof.verify.judge.reader.words import DIFFERENTIAL_MARKS

_Match = Callable[[int], tuple[str, int] | None]


class Differentials:
    """Where in one text a d is a differential. `matches` finds the declared name at a letter."""

    def __init__(self, text: str, partners: Mapping[int, int], matches: _Match) -> None:
        self.text = text
        self.partners = partners
        self.matches = matches
        self.above: set[int] = set()
        self.below_until = -1
        self.integrals = 0

    def fraction(self, end: int) -> str:
        """What begins with the `\\frac` that ends at `end`: a quotient, `\\frac{\\partial}{...}`,
        which acts on what follows, or `\\frac{\\partial x}{...}`.
        """
        text = self.text
        brace = skip_space(text, end)
        numerator = skip_space(text, brace + 1)
        after = self._mark_end(numerator) if text[brace : brace + 1] == "{" else None
        closing = self.partners.get(brace)
        if after is None or closing is None:
            return "FRAC"
        below = skip_space(text, closing + 1)
        denominator = skip_space(text, below + 1)
        if text[below : below + 1] != "{" or self._mark_end(denominator) is None:
            return "FRAC"
        self.above.add(numerator)
        self.below_until = max(self.below_until, self.partners.get(below, -1))
        self.above.add(denominator)
        rest = self._after_order(after)
        return "PARTIAL_OPERATOR" if rest == closing else "FRAC_PARTIAL"

    def _after_order(self, position: int) -> int:
        """The place after the order of a derivative, `^2` or `^{2}`, and blanks."""
        position = skip_space(self.text, position)
        if self.text[position : position + 1] == "^":
            start = skip_space(self.text, position + 1)
            position = skip_space(self.text, self.partners.get(start, start) + 1)
        return position

    def _mark_end(self, position: int) -> int | None:
        """The end of a mark of a differential at `position`, or None."""
        text = self.text
        if text[position : position + 1] == "d":
            return None if self.matches(position) else position + 1
        if text[position : position + 1] != "\\":
            return None
        command = command_at(text, position)
        if command == "\\partial":
            return position + len(command)
        if not any(mark.startswith(command + "{") for mark in DIFFERENTIAL_MARKS):
            return None
        found = scan_base(text, position)
        return found[1] if found is not None and found[0] in DIFFERENTIAL_MARKS else None

    def kind_at(self, position: int) -> str | None:
        """What an undeclared letter at `position` is: `PARTIAL` in a derivative, `DIFFERENTIAL`
        before a variable where an integral is open, or None.
        """
        if self.text[position] != "d":
            return None
        if position in self.above or position < self.below_until:
            return "PARTIAL"
        following = skip_space(self.text, position + 1)
        begins = self.text[following : following + 1]
        is_variable = begins == "\\" or is_letter(begins)
        return "DIFFERENTIAL" if self.integrals > 0 and is_variable else None

    def kind_of(self, name: str, start: int) -> str | None:
        """The same for `\\mathrm{d}` at `start`, whatever follows."""
        if name not in DIFFERENTIAL_MARKS:
            return None
        return "PARTIAL" if start in self.above or start < self.below_until else "DIFFERENTIAL"
