"""Kernels against formulas as they are written in textbooks, or by their author.

The formulas are evaluated in intervals, at more and more digits until an interval says enough: how
many digits a formula loses to subtraction does not matter here.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from mpmath import iv, mp

from gainproof.standalone.shipped._package import FORMATS, VALUES, formulas, function

DIGITS = (60, 400, 1500)
KNOWN = 1e-25
"""What the width of an interval may be of what the error is measured by."""


def enclosed(formula: Callable[..., Any], at: list[float], digits: int) -> dict[str, Any]:
    """Intervals of all outputs; none where a divisor or radicand is not told from 0."""
    iv.dps = digits
    try:
        return dict(formula(*map(iv.mpf, at)))
    except (ZeroDivisionError, ValueError, NotImplementedError):
        return {}


@pytest.mark.parametrize(("module", "kernel", "formula"), formulas())
def test_kernels_compute_the_formulas(
    module: str, kernel: str, formula: Callable[..., Any]
) -> None:
    described, form = VALUES[module][kernel], FORMATS[0]
    kind = np.dtype(form).type
    bounds = {each["name"]: each[form] for each in described["outputs"]}
    compared = set()
    for point in described["points"][form]:
        came = dict(zip(bounds, function(module, kernel)(*map(kind, point["at"])), strict=True))
        left = set(point["values"])
        for digits in DIGITS:
            found = enclosed(formula, point["at"], digits) if left else {}
            left = left & set(found) if found else left
            with mp.workdps(digits):
                for name in sorted(left & set(found)):
                    middle, width = mp.mpf(found[name].mid), mp.mpf(found[name].delta)
                    scale = mp.mpf(point.get("scales", {}).get(name, abs(middle)))
                    if not width <= KNOWN * scale:  # NaN where an end is infinite
                        continue
                    over, _, under = bounds[name]["bound"].partition("/")
                    share = mp.mpf(over) / mp.mpf(under or 1) * mp.mpf(float(np.finfo(form).eps))
                    allowed = (share + 2 * KNOWN) * scale + mp.mpf(bounds[name]["beside"])
                    assert abs(mp.mpf(float(came[name])) - middle) <= allowed, (name, point["at"])
                    compared.add(name)
                    left = left - {name}
    assert compared
