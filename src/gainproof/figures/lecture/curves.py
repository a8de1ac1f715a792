"""The named alpha-beta filters, numbers and pictures: variance at equal lag, and where they lie."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from gainproof.figures.lecture import look
from gainproof.figures.lecture.look import Look
from gainproof.figures.lecture.turn import GAINS
from gainproof.generated import alpha_beta
from gainproof.plots.table import Column, Reals, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAST_LAGS = {"mv": 0.25, "nps": 0.5, "ra": 0.5, "rv": 0.6036}
"""Above these, beta being 1 over the lag, the filters are stable: MV for beta < 4, NP-S and RA for
beta < 2, RV for lags from the lower end of its kernel on."""
NAMES = {
    "mv": "minimum variance (NP-P)",
    "nps": "least smoothed variance (NP-S)",
    "ra": "random acceleration",
    "rv": "random velocity",
}
COMPARED = ("mv", "ra", "rv")
MOST_LAG = 100.0
POINTS = 241


def minimum_variance() -> Table:
    """Variance of the predicted position against the lag, MV, RA and RV, and over that of MV."""
    lag = np.geomspace(LEAST_LAGS["mv"], MOST_LAG, POINTS)[1:]
    variance = {name: _by_lag(name, lag)[2] for name in COMPARED}
    ratios = {name: variance[name] / variance["mv"] for name in ("ra", "rv")}
    return Table(
        "MV, RA and RV: variance of the predicted position at equal lag",
        (
            Column("lag", "1/beta: lag behind a constant acceleration a over a T^2", lag),
            *(
                Column(f"{name}_variance", f"{NAMES[name]}: sigma_p^2/B", variance[name])
                for name in COMPARED
            ),
            *(
                Column(f"{name}_over_mv", f"{NAMES[name]} over minimum variance", ratio)
                for name, ratio in ratios.items()
            ),
        ),
        {f"least {name} over MV on this range": float(np.nanmin(r)) for name, r in ratios.items()},
        (
            "The lecture compares MV and RA; the range of lags and RV are ours.",
            "An empty cell: no stable filter of this name has the lag.",
        ),
    )


def stability() -> Table:
    """The gains of the named filters, by the lag; the region itself is a triangle."""
    rows: dict[str, Reals] = {}
    lag = LEAST_LAGS["mv"] * np.geomspace(1 + 1e-6, 4e4, POINTS)
    # the curves of RA and RV begin at the border too
    lag = np.unique(np.concatenate([lag, [LEAST_LAGS["rv"], LEAST_LAGS["ra"] * (1 + 1e-9)]]))
    for name in NAMES:
        alpha, beta, _ = _by_lag(name, lag)
        rows |= {f"{name}_alpha": alpha, f"{name}_beta": beta}
    margins = {name: float(alpha_beta.coordinates(*gains).margin) for name, gains in GAINS.items()}
    return Table(
        "Stability region of alpha and beta, with the named filters",
        (
            Column("lag", "1/beta", lag),
            *(
                Column(f"{name}_{gain}", f"{words}: {gain}", rows[f"{name}_{gain}"])
                for name, words in NAMES.items()
                for gain in ("alpha", "beta")
            ),
        ),
        {"4 - 2 alpha - beta of the lecture's gain pairs": margins},
        (
            "Stable: alpha > 0, beta > 0 and beta < 4 - 2 alpha (proved as an equivalence).",
            "The named filters are shown where they are stable; ours: NP-S, the range of lags.",
        ),
    )


def _by_lag(name: str, lag: Reals) -> tuple[Reals, Reals, Reals]:
    """alpha, beta, variance; NaN below the least lag."""
    there = lag >= LEAST_LAGS[name] if name == "rv" else lag > LEAST_LAGS[name]
    kernels: Mapping[str, Callable[[Reals], tuple[Any, ...]]] = {
        "mv": alpha_beta.minimum_variance_by_lag,
        "nps": alpha_beta.minimum_smoothed_variance_by_lag,
        "ra": alpha_beta.random_acceleration_by_lag,
        "rv": alpha_beta.random_velocity_by_lag,
    }
    found = np.full((3, lag.size), np.nan)
    found[:, there] = kernels[name](lag[there])[:3]
    return found[0], found[1], found[2]


VARIANCE_SIZE = (6.3, 5.2)
STABILITY_SIZE = (5.6, 5.4)
LOOKS = {
    "mv": Look(look.DARK, look.SOLID, "MV"),
    "nps": Look("0.45", look.DOTTED, "NP-S", 2.0),
    "ra": Look(look.MIDDLE, look.DASHED, "RA"),
    "rv": Look(look.LIGHT, look.DASH_DOT, "RV"),
}
CURVES = {
    "mv": r"MV (NP-P): $(\alpha+\beta/2)^2 = \beta$",
    "nps": r"NP-S: $2\sqrt{\beta}\,(1-\alpha) = 2\alpha-\beta$",
    "ra": r"RA: $(\alpha+\beta/2)^2 = 2\beta$",
    "rv": r"RV: $\alpha(\alpha+\beta) = 2\beta$",
}


def draw_minimum_variance(table: Table, sheet: Figure) -> None:
    """Above the variances, below how much more than the least."""
    variance, ratio = sheet.subplots(2, 1, sharex=True, height_ratios=(1.6, 1))
    look.framed(variance, "", r"$\sigma_p^2/B$, predicted position")
    look.framed(ratio, r"lag $1/\beta$, of a constant acceleration over $aT^2$", "over that of MV")
    for name in COMPARED:
        own = LOOKS[name]
        variance.plot(table["lag"], table[f"{name}_variance"], **own.line)
        if name != "mv":
            ratio.plot(table["lag"], table[f"{name}_over_mv"], **own.line)
    ratio.axhline(1.0, **LOOKS["mv"].line)
    variance.set_xscale("log")
    variance.set_yscale("log")
    variance.set_ylim(0.1, 30)
    ratio.set_ylim(0.95, 2.0)
    variance.set_xlim(table["lag"][0], table["lag"][-1])
    variance.legend(loc="upper right")


def draw_stability(table: Table, sheet: Figure) -> None:
    """The triangle, the curves of the named filters, the lecture's two gain pairs."""
    axes = sheet.subplots()
    look.framed(axes, r"$\alpha$", r"$\beta$")
    axes.fill([0, 2, 0], [0, 0, 4], color="0.92", linewidth=0)
    axes.plot([0, 2], [4, 0], color="0.35", linewidth=0.9)
    axes.annotate(r"$\beta = 4 - 2\alpha$", (1.2, 1.6), xytext=(8, 6), textcoords="offset points")
    for name, own in LOOKS.items():
        plain = {**own.line, "label": CURVES[name]}
        axes.plot(table[f"{name}_alpha"], table[f"{name}_beta"], **plain)
    for name, (alpha, beta) in GAINS.items():
        label = "the lecture's gain pairs" if name == "small" else None
        mark: dict[str, Any] = {"color": "white", "markeredgecolor": "black", "zorder": 5}
        axes.plot(alpha, beta, "o", label=label, clip_on=False, **mark)
    axes.text(0.95, 0.12, "stable inside", color="0.3")
    axes.set_xlim(0, 2.1)
    axes.set_ylim(0, 4.2)
    axes.legend(loc="upper right")
