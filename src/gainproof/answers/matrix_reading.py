"""Formulas whose letters are matrices, as people type them: LaTeX, MATLAB or NumPy."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from gainproof.answers.matrix_shapes import Said, base_letter
from gainproof.answers.typed import Typed, in_ascii, typed
from gainproof.bad_input import BadInputError
from gainproof.verify.judge.claim.notation import is_plain

_GREEK = (
    "alpha|beta|gamma|delta|(?:var)?epsilon|zeta|eta|theta|kappa|lambda|mu|nu|xi|rho|sigma|tau|"
    "(?:var)?phi|chi|psi|omega"
)
_NUMBERS = re.compile(rf"\\(?:{_GREEK})(?![A-Za-z])")
"""Letters that are numbers before a matrix, unless they are transposed or said to be none."""
_MARK = r"(?:T(?![A-Za-z0-9_])|\\top\b|\\intercal\b|\\math(?:sf|rm|bf)\s*(?:T|\{\s*T\s*\}))"
_TRANSPOSE = re.compile(
    rf"\^\s*(?:T(?![a-z0-9_])|{_MARK}|\{{\s*(?:{_MARK}|\\rm\s+T|\\text\{{T\}})\s*\}})"
)
_OF_GREEK = re.compile(
    rf"(\\(?:{_GREEK}))(?![A-Za-z])(?:_(?:\w|\{{[^{{}}]{{0,40}}\}}))?\s*(?={_TRANSPOSE.pattern})"
)
_PRIME = re.compile(r"(?<=[\w)\]}])(?:'|\.T\b)")
_OF_MATRIX = re.compile(
    r"[)\]]'|\.T\b|@|\b(?:inv|eye)\("
    r"|[A-Z]\w*'\s*[*@A-Za-z(]|[*@(]\s*[A-Z]\w*'|[A-Za-z)]\s+[A-Z]\w*'"
    r"|[a-z]\w*'\s*[*@]?\s*(?!T\b)[A-Z]"
)
"""Where plain text speaks of matrices: a prime of `x'` alone may mark the next state."""
_CODE = re.compile(r"[*'@]|\.T\b|\binv\(|\^\(")
"""What LaTeX has not."""
_EYE = re.compile(r"\b(?:np\.|numpy\.)?eye\(\s*\w+\s*\)")
_BOLD_IDENTITY = re.compile(
    r"\\(?:math(?:bf|rm|bb|it)|boldsymbol|bm)\s*(?:\{\s*I\s*\}|I(?![A-Za-z]))"
)
_IDENTITY = re.compile(
    r"(?<![A-Za-z\\_^{])I(?:_(?:([a-z])|\{([a-z]|[2-9]|\d\d)\}|([2-9])))?(?![A-Za-z0-9_{])"
)
_ACCENTED = re.compile(
    r"\\(?:wide)?(?:hat|tilde|bar|vec|d?dot|check|breve|acute|grave|overline|underline)\s*\{?\s*$"
    r"|\\math(?:cal|scr|frak|sf|tt)\s*\{?\s*$"
)
"""A command in front of which an I is a letter with an accent, in another type."""
NUMBERED = re.compile(r"\bI_(?:\{(\d+)\}|(\d+))")
"""An identity matrix while its size is not known yet."""
_PRIOR = re.compile(r"(?:_(?:(\w)|\{([^{}]*)\}))?\s*\^(?:\{([-+])\}|([-+])(?!\s*[\dT{]))")
"""The marks of `P_k^-` and `P^{+}`, which stand below in claim files on matrices."""
_INVERSE = re.compile(r"\^-(\d|T(?![A-Za-z]))")
_ORDERS = {
    "\\succeq": "\\geq",
    "\\succcurlyeq": "\\geq",
    "\\succ": ">",
    "\\preceq": "\\leq",
    "\\preccurlyeq": "\\leq",
    "\\prec": "<",
    ">=": "\\geq ",
    "<=": "\\leq ",
    "==": "=",
}


def transposes(formula: str) -> bool:
    """Whether there is a transpose, as LaTeX, MATLAB or NumPy writes it."""
    code = is_plain(formula) and _OF_MATRIX.search(formula) is not None
    return code or _TRANSPOSE.search(formula) is not None


def _as_typed(message: str) -> str:
    """A message without the numbers of identity matrices, its mark under the same place."""
    *lines, shown, mark = ["", *message.split("\n")]
    before = shown[: mark.find("^")]
    moved = len(before) - len(NUMBERED.sub("I", before))
    lines = [NUMBERED.sub("I", line) for line in [*lines, shown]]
    return "\n".join([*lines, mark[moved:] if mark.strip() == "^" else NUMBERED.sub("I", mark)])[1:]


def with_mark_below(token: str) -> str:
    """The name of a letter in claim files on matrices: `P_{prior}` of `P^{-}`."""
    return _PRIOR.sub(_below, token)


def _below(found: re.Match[str]) -> str:
    index, mark = found[1] or found[2] or "", found[3] or found[4]
    words = {"-": "prior", "+": "posterior"}
    return f"_{{{index},{mark}}}" if index else f"_{{{words[mark]}}}"


def transposed_greek(texts: Iterable[str]) -> frozenset[str]:
    """Small Greek letters that are no numbers, since they have a transpose somewhere."""
    return frozenset(found[1] for text in texts for found in _OF_GREEK.finditer(text))


@dataclass
class MatrixReader:
    """Reads formulas with letters that are matrices. Each identity matrix becomes a letter of its
    own, `I_{number}`; `identities` are the sizes that its index says, empty without one.
    """

    said: Mapping[str, Said]
    columns: frozenset[str]
    identities: list[str] = field(default_factory=list)

    def is_number(self, token: str) -> bool:
        """Whether a letter is a number: said to be, or a small Greek one that is not transposed."""
        if token in self.said:
            return self.said[token].number
        greek = _NUMBERS.match(base_letter(token))
        return greek is not None and greek[0] not in self.columns

    def read(self, text: str) -> Typed:
        """The formula. Raises BadInputError, with a mark under the place."""
        try:
            return self._read(_EYE.sub("I", in_ascii(text)))
        except BadInputError as error:
            raise BadInputError(_as_typed(str(error))) from None

    def _read(self, text: str) -> Typed:
        if "I" not in self.said:
            text = _IDENTITY.sub(self._numbered, _BOLD_IDENTITY.sub("I", text))
        code = is_plain(text) and _CODE.search(text) is not None
        if code:
            # a blank parts the mark from a letter behind it
            return typed(_PRIME.sub("^T ", text), self.said, self.is_number)
        text = _PRIOR.sub(_below, _INVERSE.sub(r"^{-\1}", text))
        for sign, meant in _ORDERS.items():
            text = text.replace(sign, meant)
        return typed(text, self.said, self.is_number, latex=True)

    def _numbered(self, found: re.Match[str]) -> str:
        if _ACCENTED.search(found.string, max(0, found.start() - 40), found.start()):
            return found[0]
        self.identities.append(found[1] or found[2] or found[3] or "")
        return f"I_{{{100 + len(self.identities)}}}"

    def size_of(self, token: str) -> str | None:
        """The size that an identity matrix has by its index, empty without one; None for others."""
        found = NUMBERED.fullmatch(token)
        return None if found is None else self.identities[int(found[1] or found[2]) - 101]
