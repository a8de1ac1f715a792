"""LaTeX as MathML of plain presentation: no link, style or event, whatever the LaTeX holds."""

from __future__ import annotations

import xml.etree.ElementTree as ET

from latex2mathml.converter import convert

_SPACE = "http://www.w3.org/1998/Math/MathML"
_ELEMENTS = frozenset(
    {
        *("math", "semantics", "annotation", "mrow", "mi", "mo", "mn", "mtext", "mspace"),
        *("mfrac", "msqrt", "mroot", "msub", "msup", "msubsup", "munder", "mover", "munderover"),
        *("mtable", "mtr", "mtd", "mpadded", "mphantom", "mstyle", "menclose", "merror"),
    }
)
_ATTRIBUTES = frozenset(
    {
        *("display", "mathvariant", "stretchy", "fence", "form", "separator", "accent"),
        *("minsize", "maxsize", "lspace", "rspace", "width", "linebreak", "columnalign"),
        *("columnspacing", "rowspacing", "linethickness", "movablelimits", "symmetric", "notation"),
        *("displaystyle", "scriptlevel", "largeop", "accentunder", "columnlines", "rowlines"),
    }
)


def mathml(latex: str, display: str) -> ET.Element | None:
    """The element `math`, set as a "block" or "inline"; None where the setter does not know what to
    do.

    A claim file of others may hold any LaTeX: an element or attribute that is not of plain
    presentation is taken for something unknown. The setter knows rows at their equals signs under
    one of their two names only.
    """
    try:
        root = ET.fromstring(convert(latex.replace("{aligned}", "{align*}"), display=display))
    except Exception:  # noqa: BLE001 (the setter raises errors of many types on what it cannot read)
        return None
    for element in root.iter():
        element.tag = element.tag.removeprefix(f"{{{_SPACE}}}")
        if element.tag not in _ELEMENTS or not _ATTRIBUTES.issuperset(element.attrib):
            return None
    return root
