"""LaTeX as MathML that carries its LaTeX along; what cannot be set is shown as it is written."""

from __future__ import annotations

import functools
import re
import xml.etree.ElementTree as ET

from markupsafe import Markup

from gainproof.formulas.mathml import mathml

LONG = 24
"""Signs of a formula in a sentence from which on it may be wider than a phone has room for, which
is 294 pixels: in the widest of the fonts asked for one takes 11, a root's sign and the space around
an operator as much.
"""
_SPACED = frozenset("=+-\N{MINUS SIGN}<>\N{LESS-THAN OR EQUAL TO}\N{GREATER-THAN OR EQUAL TO}")
_TAG = re.compile(r"<[^>]*>")


def displayed(latex: str) -> Markup:
    """A formula on a line of its own, with its LaTeX for whoever copies it."""
    return Markup(_set(" ".join(latex.split()), "block"))


def inline(latex: str) -> Markup:
    """A formula within a sentence; one that may be wider than a phone scrolls in its own box, since
    browsers break no line within it.
    """
    found = _set(" ".join(latex.split()), "inline")
    drawn = found.partition("<annotation")[0]
    shown = _TAG.sub("", drawn)
    signs = len(shown) + sum(sign in _SPACED for sign in shown) + drawn.count("<msqrt>")
    return Markup(f'<span class="long" tabindex="0">{found}</span>' if signs > LONG else found)


@functools.lru_cache(maxsize=4096)
def _set(latex: str, display: str) -> str:
    """The element `math` with its LaTeX, or `code` with that where the setter does not know it."""
    root = mathml(latex, display)
    if root is None:
        return str(Markup('<code class="latex">{}</code>').format(latex))
    inner = ET.Element("mrow")
    inner.extend(list(root))
    for child in list(root):
        root.remove(child)
    semantics = ET.SubElement(root, "semantics")
    semantics.append(inner)
    note = ET.SubElement(semantics, "annotation", {"encoding": "application/x-tex"})
    note.text = latex
    return ET.tostring(root, encoding="unicode")
