"""Growing-memory least squares: mean, line and parabola.

The derivation of all three is the page `least-squares` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import sympy as sp

import gainproof.derive.growing_memory
from gainproof.derive.derivation import Derivation
from gainproof.derive.growing_memory import module
from gainproof.derive.growing_memory.fit import (
    GAIN_NAMES,
    Fit,
    K,
    batch_tower,
    fit,
    recursion_tower,
)
from gainproof.derive.pages.derivation import FOLDER, Given, written
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.source import GAUSS_MARKOV, LECTURE
from gainproof.derive.subject import Program, Subject

NAMES = ("least-squares-mean", "least-squares-line", "least-squares-parabola")
TITLES = (
    "Least-squares mean (growing memory)",
    "Least-squares line (growing memory)",
    "Least-squares parabola (growing memory)",
)
PAGE = "least-squares"
WORDS = Path(gainproof.derive.growing_memory.__path__[0]) / "kernels.md"


def mean() -> Subject:
    """The fit of a constant."""
    return build(0)


def line() -> Subject:
    """The fit of a position and a velocity."""
    return build(1)


def parabola() -> Subject:
    """The fit of a position, a velocity and an acceleration."""
    return build(2)


def build(degree: int, folder: Path = FOLDER) -> Subject:
    """The fit of a polynomial of that degree, 0, 1 or 2.

    `folder`: where the page is. Raises PageError with the line of a mistake on it.
    """
    f = fit(degree)
    graphs = module.kernel_graphs(f)
    name, title = NAMES[degree], TITLES[degree]
    towers = batch_tower(f), recursion_tower(f)
    given = Given(towers, slots={"": _slots(f)}, programs=graphs)
    page = written(PAGE, given, folder)
    sources = (LECTURE.key, GAUSS_MARKOV.key)
    return Subject(
        name=name,
        title=title,
        model=None,
        derivation=Derivation(page.opening, page.steps, sources, page.latex),
        towers=page.towers,
        programs={
            kernel: Program({"sample_number": "k"}, graph) for kernel, graph in graphs.items()
        },
        module=page_module(WORDS, graphs, name, f"{title}: gains by sample number", _words(f)),
        textbook=lambda: module.textbook_forms(f),
    )


def _words(f: Fit) -> dict[str, str]:
    """What the words of kernels leave open."""
    pairs = zip(GAIN_NAMES, f.gain, strict=False)
    gains = "\n".join(f"{name} = {value}" for name, value in pairs)
    return {"first": str(f.degree), "next": str(f.degree + 1), "gains": gains}


def _slots(f: Fit) -> dict[str, Any]:
    """What the page leaves open: matrices of the size of the fit, and sentences."""
    size, more = f.size, f.degree > 0
    gains = [f"{name}_k" for name in GAIN_NAMES[:size]]
    errors = [f"d{n}" for n in range(1, size + 1)]
    leading = [sp.limit(x * K ** (n + 1), K, sp.oo) for n, x in enumerate(f.gain)]
    return {
        "velocity": "yes" if more else "",
        "acceleration": "yes" if f.degree > 1 else "",
        "first": str(f.degree),
        **{name: _rows(_symmetric(name, size)) for name in "NPM"},
        **{f"{name}_before": _rows(_symmetric(name, size, ", k, k - 1")) for name in "NP"},
        "M_row": _rows(_symmetric("M", size)[:1]),
        "K": _rows([[name] for name in gains]),
        "gain_at_n": _rows([[f"at({name}, k, n)"] for name in gains]),
        "F": f.transition,
        "back": f.transition.inv(),
        "H": f.measurement,
        "d": _rows([[name] for name in errors]),
        "d_names": ", ".join(errors),
        "unit": sp.eye(size).as_immutable(),
        "zero": sp.zeros(size, size).as_immutable(),
        "gain": f.gain,
        "first_gain": f.gain.subs(K, f.degree),
        "all_samples": " ".join(f"A({n})" for n in range(f.degree, -1, -1)),
        "errors": _listed([f"`{name}`" for name in errors]),
        "states": _listed(["position", "velocity", "acceleration"][:size]),
        "and_derivatives": " and its derivatives, in units of the sampling interval"
        if more
        else "",
        "Sums": "Sums over the samples in closed form" if more else "The number of samples",
        "Each": "Each" if more else "It",
        "no_minus_sign": f"Its leading minors have no minus sign when written in `k - {f.degree}`"
        if more
        else "It has no minus sign",
        **{f"leading_{name}": str(x) for name, x in zip(GAIN_NAMES, leading, strict=False)},
        "rates": ", ".join(
            f"`{name}` like `{x}/k{f'^{n}' if n > 1 else ''}`"
            for n, (name, x) in enumerate(zip(gains, leading, strict=True), 1)
        ),
        **_OF_DEGREE[f.degree],
    }


_OF_DEGREE = (
    {
        "A_polynomial": "A constant",
        "row": "(1)",
        "information": "[s0]",
        "Admitted": "Any start is admitted: the first sample replaces it.",
        "start_errors": "[0]",
    },
    {
        "A_polynomial": "A line",
        "row": "(1, -j)",
        "information": "[s0, -s1; -s1, s2]",
        "Admitted": "A start at sample 0 is admitted exactly if its position is the first "
        "measurement; its velocity does not matter.",
        "start_errors": "[0; -d1]",
    },
    {
        "A_polynomial": "A parabola",
        "row": "(1, -j, j^2/2)",
        "information": "[s0, -s1, s2/2; -s1, s2, -s3/2; s2/2, -s3/2, s4/4]",
        "Admitted": "A start at sample 1 is admitted exactly if its position and its velocity less "
        "half its acceleration (in units T) are those of the line through the first two samples.",
        "start_errors": "[0; -3 d1/2 - (d2 - d3/2)/2; -d1 - (d2 - d3/2)]",
    },
)


def _symmetric(name: str, size: int, where: str = "") -> list[list[str]]:
    """The entries of a symmetric matrix, each at a place if one is given."""
    places = range(1, size + 1)
    rows = [[f"{name}{min(i, j)}{max(i, j)}" for j in places] for i in places]
    return [[f"at({entry}{where})" if where else entry for entry in row] for row in rows]


def _rows(rows: list[list[str]]) -> str:
    """A matrix as pages write it."""
    return f"[{'; '.join(map(', '.join, rows))}]"


def _listed(words: list[str]) -> str:
    """A, B and C."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if words[1:] else words)
