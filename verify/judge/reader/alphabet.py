"""Letters, accents, blanks and commands: what LaTeX text is made of."""

from __future__ import annotations

# fmt: off
GREEK = frozenset(
    (
        "\\alpha", "\\beta", "\\gamma", "\\delta", "\\epsilon", "\\varepsilon", "\\zeta",
        "\\eta", "\\theta", "\\vartheta", "\\iota", "\\kappa", "\\lambda", "\\mu", "\\nu",
        "\\xi", "\\pi", "\\varpi", "\\rho", "\\varrho", "\\sigma", "\\varsigma", "\\tau",
        "\\upsilon", "\\phi", "\\varphi", "\\chi", "\\psi", "\\omega", "\\Gamma", "\\Delta",
        "\\Theta", "\\Lambda", "\\Xi", "\\Pi", "\\Sigma", "\\Upsilon", "\\Phi", "\\Psi",
        "\\Omega", "\\ell",
    )
)
ACCENTS = frozenset(
    (
        "\\dot", "\\ddot", "\\dddot", "\\ddddot", "\\hat", "\\widehat", "\\tilde",
        "\\widetilde", "\\bar", "\\vec", "\\check", "\\breve", "\\acute", "\\grave",
        "\\mathring", "\\underline", "\\underbar", "\\overline", "\\overrightarrow",
        "\\mathbf", "\\mathrm", "\\mathit", "\\mathsf", "\\mathtt", "\\mathcal", "\\mathbb",
        "\\mathfrak", "\\mathscr", "\\boldsymbol", "\\bm", "\\text", "\\textrm",
        "\\operatorname",
    )
)
# fmt: on
BLANKS = " \t\n"
DIGITS = frozenset("0123456789")


def is_letter(character: str) -> bool:
    """Whether it is an unaccented Latin letter."""
    return character.isascii() and character.isalpha()


def skip_space(text: str, position: int) -> int:
    """The first position from `position` on that holds no blank."""
    while position < len(text) and text[position] in BLANKS:
        position += 1
    return position


def command_at(text: str, position: int) -> str:
    """The LaTeX command whose backslash stands at `position`, e.g. `\\alpha` or `\\,`."""
    end = position + 1
    while end < len(text) and is_letter(text[end]):
        end += 1
    return text[position:end] if end > position + 1 else text[position : position + 2]


def braced_sign_end(text: str, position: int) -> int | None:
    """The end of `{+}` or `{-}` at `position`, which prints a sign without blanks round it."""
    start = skip_space(text, position + 1)
    end = skip_space(text, start + 1)
    if text[start : start + 1] in ("+", "-") and text[end : end + 1] == "}":
        return end + 1
    return None


def brace_partners(text: str) -> dict[int, int]:
    """The position of the closing brace for that of each opening one; `\\{` and `\\}` are none."""
    found: dict[int, int] = {}
    waiting: list[int] = []
    position = 0
    while position < len(text):
        if text[position] == "\\":
            position += 2
            continue
        if text[position] == "{":
            waiting.append(position)
        elif text[position] == "}" and waiting:
            found[waiting.pop()] = position
        position += 1
    return found
