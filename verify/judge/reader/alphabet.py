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
        "\\dot", "\\ddot", "\\dddot", "\\hat", "\\widehat", "\\tilde", "\\widetilde",
        "\\bar", "\\vec", "\\underline", "\\overline", "\\mathbf", "\\mathrm", "\\mathit",
        "\\mathcal", "\\boldsymbol",
    )
)
# fmt: on
BLANKS = " \t\n"


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
