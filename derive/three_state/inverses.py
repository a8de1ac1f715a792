"""From the position gain back to the index and the other gains, in positive forms.

Where m1 = 1 and m2 = 0 all are rational in w = sqrt(1 - alpha), and 1 - w = alpha/(1 + w):
beta = 2 (1 - w)^2, gamma = 2 (1 - w)^3/(1 + w), Lambda = gamma/w.
"""

from __future__ import annotations

from typing import Any

Forms = dict[str, Any]


def gains_from_alpha(alpha: Any, w: Any) -> Forms:
    """beta and gamma; `w` is the root of 1 - alpha."""
    step = alpha / (w + 1)
    square = step * step
    return {"beta": square * 2, "gamma": (square * 2) * (step / (w + 1))}


def index_from_alpha(alpha: Any, w: Any) -> Forms:
    """The index."""
    step = alpha / (w + 1)
    square = step * step
    return {"tracking_index": ((square * 2) * (step / (w + 1))) / w}
