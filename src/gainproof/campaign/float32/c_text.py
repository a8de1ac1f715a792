"""C that measures a kernel's results: its graph in double precision and the comparison, in pieces
that stay in the fastest cache.
"""

from __future__ import annotations

from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.kernel import Kernel

PIECE = 512
"""Inputs of a piece: a few arrays of doubles take 4 kB each."""

MEASURE = """\
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#define PIECE @PIECE@
#define ROWS @ROWS@
#define INFINITE 0x7FF0000000000000
#define POWER_OF_ONE_OVER 0x7FE0000000000000

/* bits of numbers that are not negative have their order, and those of NaN come last */
static inline int64_t size_bits(double x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits & INT64_MAX;
}

static inline double number(int64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* errors of one output: joins the largest over the scale, its first input, and the largest over
   the scale's power of two */
static void errors(size_t n, const float *x, const float *y, const double *value,
                   const double *scale, double *found)
{
    int64_t worst = -1, last = -1;
    for (size_t i = 0; i < n; ++i) {
        const double error = fabs((double)y[i] - value[i]);
        const int64_t power = size_bits(scale[i]) & INFINITE;
        const int64_t over_scale = size_bits(error / fabs(scale[i]));
        const int64_t over_power = size_bits(error * number(POWER_OF_ONE_OVER - power));
        worst = over_scale > worst ? over_scale : worst;
        last = over_power > last ? over_power : last;
    }
    const double most = worst > INFINITE ? INFINITY : number(worst);
    if (n > 0 && most > found[0]) {
        size_t i = 0;
        while (size_bits(fabs((double)y[i] - value[i]) / fabs(scale[i])) < worst)
            ++i;
        /* infinite is as bad as NaN: the first of both counts */
        for (size_t j = 0; worst >= INFINITE && j < i; ++j)
            if (size_bits(fabs((double)y[j] - value[j]) / fabs(scale[j])) >= INFINITE)
                i = j;
        found[0] = most;
        found[1] = x[i];
    }
    if (n > 0) {
        const double units = last > INFINITE ? INFINITY : number(last);
        found[2] = units > found[2] ? units : found[2];
    }
}

/* how many results are none of 0, subnormal and infinite, a little more admitted */
static int64_t undocumented(size_t n, const float *y, double small, double large)
{
    int64_t count = 0;
    for (size_t i = 0; i < n; ++i) {
        const double size = fabs((double)y[i]);
        count += !(size <= small) & !(size >= large);
    }
    return count;
}

void measure(size_t n, const float *x, size_t outputs, const float *const *results,
             const size_t *rows, const double *ends, const double *edges, double *found,
             int64_t *counts)
{
    for (size_t start = 0; start < n; start += PIECE) {
        const size_t count = n - start < PIECE ? n - start : PIECE;
        double given[PIECE], made[ROWS][PIECE];
        for (size_t i = 0; i < count; ++i)
            given[i] = x[start + i];
        @NAME@(count, given, @MADE@);
        for (size_t k = 0; k < outputs; ++k) {
            const float *y = results[k] + start;
            size_t low = 0, high = count;
            while (low < count && given[low] < ends[2 * k])
                ++low;
            while (high > low && given[high - 1] > ends[2 * k + 1])
                --high;
            errors(high - low, x + start + low, y + low, made[rows[2 * k]] + low,
                   made[rows[2 * k + 1]] + low, found + 3 * k);
            counts[2 * k] += count - (high - low);
            counts[2 * k + 1] += undocumented(low, y, edges[0], edges[1]);
            counts[2 * k + 1] += undocumented(count - high, y + high, edges[0], edges[1]);
        }
    }
}
"""


def c_text(kernel: Kernel) -> str:
    """The graph of a kernel as a loop in double precision, and ``measure`` of its outputs' rows.

    ``ends``: of each output the least and greatest input with a bound; ``edges``: the numbers next
    to 0 and infinity; ``found``: of each output the worst error, its input and the worst over the
    scale's power of two, to be joined; ``counts``: how many inputs lie outside, and of how many of
    them the result is undocumented, to be added to. Inputs come in their order.
    """
    rows = len(kernel.outputs)
    text = MEASURE.replace("@PIECE@", str(PIECE)).replace("@ROWS@", str(rows))
    text = text.replace("@NAME@", kernel.name)
    text = text.replace("@MADE@", ", ".join(f"made[{row}]" for row in range(rows)))
    return f"{c_loop(kernel)}\n{text}"
