"""Code with its syntax shown by classes, which the site's style sheet colours."""

from __future__ import annotations

from markupsafe import Markup
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name
from pygments.util import ClassNotFound

_CLASS = "code"


def highlighted(code: str, language: str) -> Markup:
    """The code as a block of its own; a language that is not known is shown plain."""
    try:
        lexer = get_lexer_by_name(language or "text")
    except ClassNotFound:
        lexer = get_lexer_by_name("text")
    # a block that is wider than the page scrolls: keyboards reach it by its place in the order
    block = highlight(code, lexer, HtmlFormatter(cssclass=_CLASS))
    return Markup(block.replace("<pre>", '<pre tabindex="0">', 1))
