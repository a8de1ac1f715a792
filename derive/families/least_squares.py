"""Growing-memory least squares: mean, line and parabola."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.growing_memory import module, steps, steps_use
from gainproof.derive.growing_memory.fit import batch_tower, fit, recursion_tower
from gainproof.derive.relation import Relation
from gainproof.derive.source import GAUSS_MARKOV, LECTURE
from gainproof.derive.subject import Program, Subject

NAMES = ("least-squares-mean", "least-squares-line", "least-squares-parabola")
TITLES = (
    "Least-squares mean (growing memory)",
    "Least-squares line (growing memory)",
    "Least-squares parabola (growing memory)",
)
OPENING = (
    "While a track is young every sample counts alike: fit a polynomial to all of them. The fit at "
    "the newest sample can be run as a filter whose gains depend on the number of samples only."
)
ENTRIES = [f"{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
LATEX = {
    "k": "k",
    "j": "j",
    "alpha": r"\alpha_k",
    "beta": r"\beta_k",
    "gamma": r"\gamma_k",
    **{f"information_{ij}": f"N_{{{ij}}}" for ij in ENTRIES},
    **{f"updated_{ij}": f"P_{{{ij}}}" for ij in ENTRIES},
    **{f"predicted_{ij}": f"M_{{{ij}}}" for ij in ENTRIES},
    **{f"d{i}": f"d_{i}" for i in (1, 2, 3)},
}


def mean() -> Subject:
    """The fit of a constant."""
    return _build(0)


def line() -> Subject:
    """The fit of a position and a velocity."""
    return _build(1)


def parabola() -> Subject:
    """The fit of a position, a velocity and an acceleration."""
    return _build(2)


def _build(degree: int) -> Subject:
    f = fit(degree)
    graphs = module.kernel_graphs(f)
    name, title = NAMES[degree], TITLES[degree]
    programs = [
        Step(
            f"kernel-{kernel.replace('_', '-')}",
            f"The kernel {kernel} computes what it says.",
            Relation(
                "program",
                {
                    "program": kernel,
                    "outputs": {entry: real(entry) for entry in graph["outputs"]},
                },
            ),
            "Evaluate the kernel's graph as a rational function.",
            tower="later" if kernel == "predicted_covariance" else "main",
            hint={"graph": graph},
            shown=False,
        )
        for kernel, graph in graphs.items()
    ]
    derivation = Derivation(
        OPENING,
        (
            *steps.batch_steps(f),
            *steps.recursion_steps(f),
            *steps_use.start_steps(f),
            *steps_use.end_steps(f),
            *programs,
        ),
        (LECTURE.key, GAUSS_MARKOV.key),
        LATEX,
    )
    towers = (batch_tower(f), recursion_tower(f))
    return Subject(
        name=name,
        title=title,
        model=None,
        derivation=derivation,
        towers={tower.name: tower for tower in towers},
        programs={
            kernel: Program({"sample_number": "k"}, graph) for kernel, graph in graphs.items()
        },
        module=module.kernel_module(f, name, title, graphs),
        textbook=lambda: module.textbook_forms(f),
    )
