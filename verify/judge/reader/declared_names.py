"""Which declared name begins at a place: the longest, with as many marks as possible."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.reader.alphabet import command_at, is_letter, skip_space
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.name_marks import scan_mark_above, scan_mark_behind
from gainproof.verify.judge.reader.printed_names import scan_decorations, scan_names
from gainproof.verify.judge.reader.subscripts import scan_subscript
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import EULER_NAMES


class NameFinder:
    """Finds names in one text. `jumps` leads from the end of a superscript over the subscript that
    is printed after it.
    """

    def __init__(self, text: str, vocabulary: Vocabulary, partners: Mapping[int, int]) -> None:
        self.text = text
        self.vocabulary = vocabulary
        self.partners = partners
        self.jumps: dict[int, int] = {}

    def passed(self, position: int) -> int:
        """Where reading goes on: behind a subscript that belongs to a name before."""
        return self.jumps.pop(position, position)

    def undeclared(self, base: str, start: int, end: int, single: bool = False) -> ReaderError:
        """The error for a name that is not declared, with those nearest to it. `(+)` and `(-)`
        behind it can be nothing but marks.
        """
        name = base
        if not single:
            name, after = scan_decorations(self.text, base, end)
            behind = scan_mark_behind(self.text, after)
            if behind is not None and behind.text in ("(+)", "(-)"):
                name += behind.text
        near = nearest_names(name, self.vocabulary.symbols)
        problem = f"the symbol {name} is not declared"
        if name in EULER_NAMES:
            problem += "; Euler's number alone is e^1"
        return ReaderError(problem, self.text, start, name, near)

    def longest(self, position: int, single: bool = False) -> tuple[str, int] | None:
        """The longest declared name that begins with the letter at `position`; primes, a subscript
        and marks follow its last letter. With `single` one bare letter, as TeX takes it.
        """
        text = self.text
        most = position + (1 if single else self.vocabulary.longest + 1)
        end = position + 1
        while end < min(len(text), most) and is_letter(text[end]):
            end += 1
        word = text[position:end]
        found = self.declared(word, position, end, single)
        if found is not None:
            return found
        for length in range(len(word) - 1, 0, -1):
            if word[:length] in self.vocabulary and word != "and":
                return word[:length], position + length
        return None

    def declared(self, base: str, start: int, end: int, single: bool) -> tuple[str, int] | None:
        """The declared name that begins with `base`, which stands from `start` to `end`."""
        if single:
            return (base, end) if base in self.vocabulary else None
        found = self._subscript_after_power(base, start, end)
        if found is not None:
            return found
        for name, after in scan_names(self.text, base, end):
            if name in self.vocabulary:
                return name, after
        return None

    def _subscript_after_power(self, base: str, start: int, end: int) -> tuple[str, int] | None:
        """`\\sigma^2_v` is `\\sigma_v^2`: the name ends before the superscript, and the subscript
        is passed over after it.
        """
        text = self.text
        power = skip_space(text, end)
        if text[power : power + 1] != "^":
            return None
        above = skip_space(text, power + 1)
        if text[above : above + 1] == "{":
            over = self.partners.get(above, -1) + 1
        else:
            over = above + len(command_at(text, above) if text[above : above + 1] == "\\" else "x")
        under = skip_space(text, over)
        if over <= above or text[under : under + 1] != "_":
            return None
        subscript, after = scan_subscript(text, under + 1)
        if base + subscript in self.vocabulary:
            self.jumps[over] = after
            return base + subscript, end
        # marks such as `x^{-}_k` belong to the name, and only a name can have a subscript
        if base not in self.vocabulary or scan_mark_above(text, end) is not None:
            return None
        raise self.undeclared(base + subscript, start, after, single=True)
