"""The domain in which a kernel is computed in double-words, as the entries of its signature."""

from __future__ import annotations

from fractions import Fraction

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.docstring import wanted_text
from gainproof.derive.printer.double_word.refinement import ends
from gainproof.derive.printer.formats import FORMATS, Format
from gainproof.derive.printer.kernel import Input


def accurate_domain(given: Input) -> tuple[str, ...]:
    """Name, words, and least and greatest number of each type."""
    pairs = (f"({_numbers(given, form)})," for form in FORMATS)
    return f'"{given.name}",', f'"{wanted_text(given)}",', *pairs


def _numbers(given: Input, form: Format) -> str:
    low, high = ends(given)
    least = form.at_least(max(low, Fraction(form.least)))
    most = form.at_most(min(high, Fraction(form.largest)))
    return f"{literal(least)}, {literal(most)}"
