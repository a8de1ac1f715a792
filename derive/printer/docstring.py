"""The docstring of a printed kernel: everything a user must know of it."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from gainproof.derive.printer.bound import KernelBound, OutputBound
from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.double_word.bound import units
from gainproof.derive.printer.double_word.float32_results import single_units
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.kernel import Input, Kernel, Limit, Output, Requirement
from gainproof.derive.printer.library_functions import NUMPY, ULP, functions_of
from gainproof.derive.printer.lost_digits_text import Loss, loss_text
from gainproof.derive.printer.signed_inputs import has_signs

WIDTH = 96  # of the text, inside an indentation of four

ONE = (
    "Outside an output's range, a few numbers next to its ends apart, its true value is no normal "
    "number: it comes as 0, a subnormal number or infinity, never as NaN. Numbers and arrays are "
    "taken, arrays of any shape; inputs are broadcast. {}"
)
SEVERAL = (
    "Every true value that an error is relative to is a normal number. Numbers and arrays are "
    "taken, arrays of any shapes that broadcast. {}"
)
SIGNED = "Numbers and arrays are taken, arrays of any shapes that broadcast. {}"
ONE_TYPES = "float64 and float32 stay what they are, integers become float64."
SEVERAL_TYPES = (
    "Where all inputs are float32 so are the results; otherwise everything becomes float64, "
    "integers too."
)
SIZES = "the sum of its terms' sizes"
ASSUMED = f"err by at most {ULP} units in the last place of the true value"


def number_text(value: float, form: Format) -> str:
    """The shortest text that gives the number back in its format."""
    text = repr(value) if form is FLOAT64 else str(np.float32(value))
    return text.replace("e+", "e")


def wanted_text(given: Input) -> str:
    """The domain of an input in words, for its guard's message."""
    if given.signed:
        return _magnitude_text(given)
    number = "a whole number" if given.integer else "a number"
    number = f"0 or {number}" if given.zero else number
    text = f"{number} {_ends_text(given)}"
    if given.single is None:
        return text
    lower, upper = given.single
    single = _ends_text(replace(given, lower=lower, upper=upper))
    return f"{text}, in float32 {single}"


def _magnitude_text(given: Input) -> str:
    """Of an input of either sign."""
    ends = [(given.lower, given.upper)] + ([given.single] if given.single else [])
    if all(constant(low).rational == 0 for low, _ in ends):
        words, texts = "of magnitude at most", [_limit_text(upper) for _, upper in ends if upper]
    else:
        words = "0 or of magnitude"
        texts = [f"{_limit_text(low)} to {_limit_text(upper)}" for low, upper in ends if upper]
    double, *single = texts
    return f"{words} {double}" + "".join(f", in float32 {text}" for text in single)


def required_text(required: Requirement) -> str:
    """What is required, in words."""
    least, single = _limit_text(required.least), _limit_text(required.single)
    if least == single == "0":
        return "above 0"
    return f"at least {least}" + (f", in float32 {single}" if single != least else "")


def _ends_text(given: Input) -> str:
    least = "above" if given.lower_open else "at least"
    lower = f"{least} {_limit_text(given.lower)}"
    if given.upper is None:
        return f"{lower} and finite"
    most = "below" if given.upper_open else "at most"
    return f"{lower} and {most} {_limit_text(given.upper)}"


def _limit_text(limit: Limit) -> str:
    """A limit as its author wrote it, a large power of 2 as one; one made by roots as its nearest
    number.
    """
    if isinstance(limit, str):
        return limit
    value = constant(limit)
    if value.rational is None:
        return repr(value.nearest(FLOAT64))
    size = max(value.rational, 1 / value.rational)
    if size >= 2**40 and size == 2 ** (power := size.numerator.bit_length() - 1):
        return f"2^{power if value.rational > 1 else -power}"
    return str(value.rational)


def docstring(kernel: Kernel, bounds: Sequence[KernelBound]) -> str:
    """The text between the quotes, lines without indentation."""
    several = len(kernel.inputs) > 1
    text = (SIGNED if has_signs(kernel) else SEVERAL) if several else ONE
    types = types_text(bounds, SEVERAL_TYPES if several else ONE_TYPES)
    sections = [
        *mathematics(kernel, bounds),
        _wrap(
            f"{text.format(types)} `out`: a tuple of arrays to fill. "
            "`workers`: threads that share the work on long arrays."
        ),
        _accurate(kernel, bounds),
        _wrap(
            "ValueError: an input outside its domain, with its place; `out` or `workers` that does "
            "not fit. TypeError: an input that is no real number of these types; in `out` what is "
            "no array of the results' type."
        ),
        _wrap(f"Source: {kernel.source}"),
    ]
    return "\n\n".join("\n".join(section) for section in sections if section)


def types_text(bounds: Sequence[KernelBound], both: str) -> str:
    """What types are taken: `both` says it where there are bounds of both formats."""
    if len(bounds) > 1:
        return both
    if bounds[0].format is FLOAT64:
        return "Integers become float64; inputs that are all float32 are refused."
    return "All inputs must be float32, and results are."


def mathematics(kernel: Kernel, bounds: Sequence[KernelBound]) -> list[list[str]]:
    """What is true of a kernel in every language, as sections of lines: equations, domains,
    bounds.
    """
    return [
        [kernel.summary],
        [f"    {line}" for line in kernel.equations],
        [line for given in kernel.inputs for line in _input(given)],
        [line for required in kernel.requirements for line in _required(required)],
        [line for row in range(len(kernel.outputs)) for line in _output(kernel, bounds, row)],
    ]


def described(kernel: Kernel, bounds: Sequence[KernelBound]) -> list[str]:
    """The same as lines for other languages, by their names of functions, with the source."""
    sections = [*mathematics(kernel, bounds), textwrap.wrap(f"Source: {kernel.source}", WIDTH)]
    text = "\n\n".join("\n".join(section) for section in sections if section)
    for ours, numpys in NUMPY.items():
        text = text.replace(f"np.{numpys} ", f"{ours} ").replace(f"np.{numpys},", f"{ours},")
    return text.splitlines()


def _input(given: Input) -> Iterator[str]:
    yield from _wrap(f"{given.name}: {given.meaning}; {wanted_text(given)}.", "    ")


def _required(required: Requirement) -> Iterator[str]:
    text = f"The {required.meaning}, of the inputs together, must be {required_text(required)}."
    yield from _wrap(text, "    ")


def _output(kernel: Kernel, bounds: Sequence[KernelBound], row: int) -> Iterator[str]:
    output = kernel.outputs[row]
    scale = "Relative error" if output.relative_to is None else f"Error over {scale_text(output)}"
    if output.by_terms:
        scale = "Error over the sum of its terms taken positive"
    found = [(bound.format, bound.outputs[row]) for bound in bounds]
    sizes = ", ".join(
        f"{decimal_text(each)} * 2^{1 - form.digits} ({form.name})" for form, each in found
    )
    text = f"{output.name}: {output.meaning}. {scale} at most {sizes}, proved for "
    places = [
        f"{number_text(each.lowest, form)} <= {kernel.inputs[0].name} <= "
        f"{number_text(each.highest, form)} ({form.name})"
        for form, each in found
    ]
    text += "every input." if len(kernel.inputs) > 1 else " and ".join(places) + "."
    if has_signs(kernel):
        beside = [(each.beside, form) for form, each in found if each.beside]
        more = " and ".join(f"{rounded_up(size)} ({form.name})" for size, form in beside)
        more = f", and {more} beside it where a product underflows" if more else ""
        text = f"{text.removesuffix('.')}{more}{assumption(kernel, output.name)}."
    text += "".join(f" {said}" for said in cancellation_texts(kernel, bounds, row))
    if losses := losses_of(bounds, row):
        text += f" {loss_text(losses)}"
    yield from _wrap(text, "    ")


def scale_text(output: Output) -> str:
    """What an error is relative to that is another output of the graph."""
    own = SIZES if output.relative_to == f"{output.name}_scale" else str(output.relative_to)
    return output.scale_meaning or own


def cancellation_texts(kernel: Kernel, bounds: Sequence[KernelBound], row: int) -> dict[str, None]:
    """A sentence for each subtraction of computed values that enters an output."""
    found = [bound.outputs[row].amplification for bound in bounds]
    return dict.fromkeys(
        f"Cancellation, condition number {max(each[name] for each in found):.3g}: {reason}."
        for name, reason in kernel.cancellations.items()
        if found[0].get(name)
    )


def losses_of(bounds: Sequence[KernelBound], row: int) -> list[Loss]:
    """What an output may lose, in each format; nothing where its bound is relative to itself."""
    return [loss for bound in bounds if (loss := bound.outputs[row].loss) is not None]


def _accurate(kernel: Kernel, bounds: Sequence[KernelBound]) -> list[str]:
    if kernel.accurate is None:
        return []
    more = math.ceil(math.log2(units(kernel)))
    single = math.ceil(math.log2(single_units(kernel, bounds[0])))
    return _wrap(
        f"`accurate`: in double-words, {kernel.accurate.name} {_ends_text(kernel.accurate)}: "
        f"proved to be off by at most 0.5 + 2^{more} units in the last place (float64), 0.5 + "
        f"2^{single} (float32), where the true value is a normal number; takes 12 to 20 times as "
        "long, in float32 3 times."
    )


def assumption(kernel: Kernel, output: str) -> str:
    """On which functions' errors the bound of an output rests."""
    used = kernel.program
    names = functions_of(used, [used.outputs[output]])
    if not names:
        return ""
    *first, last = (f"np.{name}" for name in names)
    listed = f"{', '.join(first)} and {last}" if first else last
    return f", provided {listed} {ASSUMED if first else ASSUMED.replace('err', 'errs', 1)}"


def rounded_up(size: float) -> str:
    """A size with one digit, rounded up."""
    digit, _, exponent = f"{size:.0e}".partition("e")
    text = f"{digit}e{int(exponent)}"
    return text if float(text) >= size else f"{int(digit) + 1}e{int(exponent)}"


def decimal_text(bound: OutputBound) -> str:
    hundredths = int(bound.bound * 100)
    return f"{hundredths // 100}.{hundredths % 100:02d}"


def _wrap(text: str, later: str = "") -> list[str]:
    return textwrap.wrap(
        text, WIDTH, subsequent_indent=later, break_long_words=False, break_on_hyphens=False
    )
