"""Own lexer: longest match against the declared symbols, everything unknown an error with its
place.

The d of a derivative and of an integral is `\\partial`, `\\mathrm{d}`, or a letter d that nobody
declared.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from gainproof.verify.judge.reader.alphabet import (
    DIGITS,
    brace_partners,
    command_at,
    is_letter,
    skip_space,
)
from gainproof.verify.judge.reader.declared_names import NameFinder
from gainproof.verify.judge.reader.environments import Environments, line_break_end
from gainproof.verify.judge.reader.errors import ReaderError, nearest_names
from gainproof.verify.judge.reader.formula_limits import MOST_DEPTH
from gainproof.verify.judge.reader.line_end import LineEnds, end_of_tag, equation_number_end
from gainproof.verify.judge.reader.printed_names import scan_base, scan_word
from gainproof.verify.judge.reader.special_names import (
    bracket_after,
    circle_number,
    declared_kind,
    function_named,
    sign_in_braces,
    sign_of_branch,
    special_name,
    transpose,
    with_base,
)
from gainproof.verify.judge.reader.token_scan import (
    NO_ALTERNATIVES,
    NORM_BARS,
    Scanned,
    is_or,
    joining_word,
    scan_bar,
    scan_mark,
    scan_norm,
    scan_number,
    scan_sized,
    unread,
)
from gainproof.verify.judge.reader.tokens import (
    COMMANDS,
    NO_EXACT_MEANING,
    SIZES,
    SPACES,
    TAKES_ARGUMENTS,
    WIDE_SPACES,
    FormulaToken,
)
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import (
    BASED,
    DIFFERENTIAL_MARKS,
    FUNCTION_COMMANDS,
    is_unread,
)

_TEXTS = frozenset(("\\text", "\\mathrm", "\\textrm", "\\mbox"))
_Match = Callable[[int], tuple[str, int] | None]


def scan_tokens(text: str, vocabulary: Vocabulary) -> list[FormulaToken]:
    """The tokens of `text` in order, brackets not yet paired."""
    return _Lexer(text, vocabulary).run()


class _Lexer:
    """One pass over one text."""

    def __init__(self, text: str, vocabulary: Vocabulary) -> None:
        self.text = text
        self.vocabulary = vocabulary
        self.tokens = TokenList(text)
        self.position = 0
        self.partners = brace_partners(text)
        self.environments = Environments(text)
        self.names = NameFinder(text, vocabulary, self.partners)
        self.differentials = Differentials(text, self.partners, self.names.longest)
        self.line_ends = LineEnds(text)

    def run(self) -> list[FormulaToken]:
        while (start := skip_space(self.text, self.names.passed(self.position))) < len(self.text):
            self.position = start
            character = self.text[start]
            if self.text.startswith("...", start):
                self._add("DOTS", "...", start + 3)
            elif character in ".,;" and (end := self.line_ends.end_at(start)) is not None:
                self.position = end
            elif character in DIGITS or character == ".":
                self._add(*scan_number(self.text, start, single=self.tokens.single))
            elif is_letter(character):
                self._letters()
            elif character == "\\":
                self._command()
            elif character == "~":
                self.position += 1
            elif (special := self._special_mark(character)) is not None:
                self._add(*special)
            elif character == "&" and not self.environments.has_columns():
                raise self._error("the character '&' has no meaning here", "&")
            else:
                self._add(*scan_mark(self.text, start, self.tokens.found))
        self.environments.refuse_open()
        return self.tokens.found

    def _error(self, problem: str, token: str, nearest: tuple[str, ...] = ()) -> ReaderError:
        return ReaderError(problem, self.text, self.position, token, nearest)

    def _add(self, kind: str, value: str, end: int) -> None:
        self.differentials.integrals += (kind == "INTEGRAL") - (kind == "DIFFERENTIAL")
        self.tokens.add(FormulaToken(kind, value, self.position, end))
        self.position = end

    def _symbol(self, name: str, end: int) -> None:
        self._add(declared_kind(self.text, name, end, self.vocabulary), name, end)

    def _letters(self) -> None:
        self._refuse_word()
        found = self.names.longest(self.position, self.tokens.single)
        if found is not None:
            self._symbol(*found)
            return
        text, start = self.text, self.position
        if (mark := self.differentials.kind_at(start)) is not None:
            self._add(mark, text[start], start + 1)
            return
        end = start + 1
        while end < len(text) and is_letter(text[end]) and end - start <= self.vocabulary.longest:
            end += 1
        if text[start:end] == "and":
            self._add("AND", "and", end)
            return
        special = special_name(text, text[start], start + 1)
        if special is not None:
            self._add(*special)
            return
        raise self.names.undeclared(text[start:end], start, end, self.tokens.single)

    def _refuse_word(self) -> None:
        """ReaderError for `or` and for a function that is not read, where nobody declared it as a
        name: its letters are no product.
        """
        text, start = self.text, self.position
        found = scan_word(text, start)
        if found is None or found[0] in self.vocabulary or is_letter(text[start - 1 : start]):
            return
        word, end = found
        if word == "or":
            raise self._error(NO_ALTERNATIVES, "")
        if is_unread(word) and text.startswith("(", skip_space(text, end)):
            raise self._error(unread(word), "")

    def _command(self) -> None:
        text, start = self.text, self.position
        command = command_at(text, start)
        end = start + len(command)
        if command in SPACES:
            self.position = end
        elif command == "\\ ":
            self._add("GAP", command, end)
        elif command in WIDE_SPACES:
            self._wide(command, end)
        elif command in ("\\tag", "\\label"):
            self.position = end_of_tag(text, end)
        elif command == "\\\\":
            self._add("LINE", command, line_break_end(text, end))
        elif command in ("\\begin", "\\end"):
            self._environment(command, end)
        elif command in SIZES:
            self._add(*scan_sized(text, start, command))
        elif command in ("\\pm", "\\mp"):
            self._add(*sign_of_branch(text, start, command, self.vocabulary.branch))
        elif command in ("\\mid", "\\vert"):
            self._add(*scan_bar(text, start, command))
        elif command in NORM_BARS:
            self._add(*scan_norm(end, self.tokens.found))
        elif command in _TEXTS and (joint := joining_word(text, end)) is not None:
            self._add(*joint)
        elif command in ("\\lor", "\\vee") or (command in _TEXTS and is_or(text, end)):
            raise self._error(NO_ALTERNATIVES, "")
        elif command in NO_EXACT_MEANING:
            raise self._error(NO_EXACT_MEANING[command], command)
        elif command in COMMANDS:
            kind, value = COMMANDS[command]
            self._add(self.differentials.fraction(end) if kind == "FRAC" else kind, value, end)
        elif command == "\\lg":
            self._add("NAMED", f"{BASED}10", end)
        elif command in FUNCTION_COMMANDS:
            self._add(
                *with_base(text, Scanned("NAMED", FUNCTION_COMMANDS[command], end), self.vocabulary)
            )
        else:
            self._named_by_command(command)

    def _special_mark(self, character: str) -> Scanned | None:
        """The mark of a transpose, or a sign in braces, where one stands here."""
        if character == "^" and not self.tokens.takes_bound() and not self._after_a_number():
            return transpose(self.text, self.position + 1)
        if character == "{" and not self.tokens.single:
            return sign_in_braces(self.text, self.position)
        return None

    def _after_a_number(self) -> bool:
        """Whether what is raised is a number, which has no transpose."""
        return bool(self.tokens.found) and self.tokens.found[-1].kind in ("NUMBER", "EULER")

    def _wide(self, command: str, end: int) -> None:
        number = equation_number_end(self.text, end)
        if number is None:
            self._add("WIDE", command, end)
        else:
            self.position = number

    def _named_by_command(self, command: str) -> None:
        text, start = self.text, self.position
        base = scan_base(text, start)
        if base is None:
            near = nearest_names(command, [*COMMANDS, *self.vocabulary.symbols])
            raise self._error(f"the command {command} is not known", command, near)
        found = self.names.declared(base[0], start, base[1], self.tokens.single)
        word = base[0][base[0].find("{") + 1 : -1]
        calls = command == "\\operatorname" or bracket_after(text, base[1]) == "("
        if found is None and calls and is_unread(word):
            raise self._error(unread(f"\\operatorname{{{word}}}"), "")
        if found is not None:
            self._symbol(*found)
        elif (mark := self.differentials.kind_of(base[0], start)) is not None:
            self._add(mark, *base)
        elif (special := special_name(text, *base) or function_named(*base)) is not None:
            self._add(*with_base(text, special, self.vocabulary))
        elif (number := circle_number(text, *base, self.vocabulary)) is not None:
            self._add(*number)
        else:
            raise self.names.undeclared(base[0], start, base[1], self.tokens.single)

    def _environment(self, command: str, end: int) -> None:
        begins = command == "\\begin"
        kind, value, after = self.environments.scan(
            self.position, end, begins, not self.tokens.found
        )
        if kind:
            self._add(kind, value, after)
        else:
            self.position = after


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
