"""C that measures results in double precision: their graph in long double, and the comparison."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from gainproof.bad_input import BadInputError
from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.constant import Constant
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.registers import plan
from gainproof.derive.printer.select_conditions import threshold

SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}

MEASURE = """\
#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>

#if FLT_RADIX != 2 || LDBL_MANT_DIG < 64 || LDBL_MAX_EXP < 16384
#error "long double has to have 64 binary digits and the exponents of 15 bits"
#endif

static inline void reference(const double x, long double *const made)
{
@BODY@
}

/* as bad as can be where there is no number */
static inline double size(const long double error)
{
    return error != error ? INFINITY : (double)error;
}

void measure(size_t n, const double *x, const double *const *results, const double *ends,
             const double *edges, double *found, int64_t *counts)
{
    for (size_t i = 0; i < n; ++i) {
        long double made[@OUTPUTS@];
        reference(x[i], made);
        for (size_t k = 0; k < @OUTPUTS@; ++k) {
            const double y = results[k][i];
            if (x[i] < ends[2 * k] || x[i] > ends[2 * k + 1]) {
                ++counts[2 * k];
                counts[2 * k + 1] += !(fabs(y) <= edges[0]) & !(fabs(y) >= edges[1]);
                continue;
            }
            const long double error = fabsl((long double)y - made[k]);
            const double relative = size(error / fabsl(made[k]));
            if (relative > found[3 * k]) {
                found[3 * k] = relative;
                found[3 * k + 1] = x[i];
            }
            if (relative * 0x1p53 > found[3 * k + 2]) { /* units are no more than that */
                int power;
                frexpl(made[k], &power);
                const double units = size(ldexpl(error, DBL_MANT_DIG - power));
                found[3 * k + 2] = units > found[3 * k + 2] ? units : found[3 * k + 2];
            }
        }
    }
}
"""


def c_text(kernel: Kernel) -> str:
    """``measure`` of results of a kernel of one input; everything is compared at every input.

    ``ends``: of each output the least and greatest input with a bound; ``edges``: the numbers next
    to 0 and infinity; ``found``: of each output the worst error over the true value, its input, and
    the worst in units in the last place of the true value, to be joined; ``counts``: how many
    inputs lie outside, and of how many of them the result is neither 0, subnormal nor infinite, to
    be added to.

    Raises BadInputError for a kernel with steps that have no counterpart in long double: iterated
    roots, and constants that are subtracted in two parts.
    """
    body = "\n".join(f"    {line}" for line in _lines(kernel))
    return MEASURE.replace("@BODY@", body).replace("@OUTPUTS@", str(len(kernel.outputs)))


def rounded_constants(kernel: Kernel) -> int:
    """How many constants of the graph are no numbers of double precision.

    Raises BadInputError where there are such beside differences: in long double their roundings
    may weigh more there than all that double precision counts.
    """
    steps = plain(kernel.program)
    used = [step.constant for step in steps.steps if step.constant is not None]
    count = sum(not each.is_exact(FLOAT64) for each in used)
    if count and any(step.operation in ("sub", "neg") for step in steps.steps):
        raise BadInputError(f"{kernel.name}: differences beside rounded constants are not compared")
    return count


def _lines(kernel: Kernel) -> Iterator[str]:
    steps = plain(kernel.program)
    ends = [steps.outputs[output.name] for output in kernel.outputs]
    names: dict[int, str] = {}
    for number, step in enumerate(steps.steps):
        if step.operation == "input":
            names[number] = "(long double)x"
        elif step.constant is not None:
            names[number] = _constant(step.constant)
    for number in plan(steps, ends).order:
        yield f"const long double t{number} = {_expression(kernel, steps, number, names)};"
        names[number] = f"t{number}"
    for row, end in enumerate(ends):
        yield f"made[{row}] = {names[end]};"


def _expression(kernel: Kernel, steps: Program, number: int, names: Mapping[int, str]) -> str:
    step = steps.steps[number]
    parts = [names[part] for part in step.operands]
    if step.scale is not None:
        return f"{parts[0]} * {step.scale.hex()}L"
    if step.operation == "sqrt":
        return f"sqrtl({parts[0]})"
    if step.operation == "abs":
        return f"fabsl({parts[0]})"
    if step.operation == "neg":
        return f"-{parts[0]}"
    if step.operation == "select":  # at the same numbers as in double precision
        limit = threshold(steps, step, FLOAT64)
        value = f"{limit.value.hex()}L"
        test = f"{parts[0]} < {value}" if limit.input_first else f"{value} < {parts[1]}"
        return f"{test} ? {parts[2]} : {parts[3]}"
    if step.operation in SIGN and in_two_parts(steps, number) is None:
        return f"{parts[0]} {SIGN[step.operation]} {parts[1]}"
    raise BadInputError(
        f"{kernel.name}: a step of operation {step.operation} has no counterpart in long double"
    )


def _constant(value: Constant) -> str:
    """A constant, rounded once to long double."""
    high, low = value.nearest(FLOAT64), value.remainder(FLOAT64)
    return f"({high.hex()}L + {low.hex()}L)"
