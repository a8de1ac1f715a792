"""How the filters are drawn: the source has the fixed gains solid and the updated ones dotted."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.figures.lecture.look import DASH_DOT, DASHED, DOTTED, Look

LOOKS: Mapping[str, Look] = {
    "fixed": Look("#14335c", "-", "fixed"),
    "first-order-constant": Look("#c04a26", DOTTED, "updated, constant partials", 2.0),
    "first-order-recursive": Look("#c04a26", DASHED, "updated, recursive"),
    "exact": Look("#e0a030", "-", "exact gains of the index"),
    "line-of-sight": Look("#4f8f5b", DASH_DOT, "exact, line of sight"),
    "kalman": Look("0.45", "-", "Kalman filter", 2.4),
}
NOMINAL_COLOURS: Mapping[str, str] = {"far": "#14335c", "middle": "#c04a26", "near": "#3f7f4b"}
ENDS: Mapping[str, str] = {"far": "80 km", "middle": "40 km", "near": "10 km"}
