"""Location from range and Doppler in multipath: what holds for every number of stations.

The derivation is the page `multipath-location` of `derive/pages`.
"""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.estimation import bias_kernel, example_steps
from gainproof.derive.estimation.multipath_hints import HINTS
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.source import DOPPLER, MATRICES
from gainproof.derive.subject import Program, Subject

NAME = "multipath-location"


def build() -> Subject:
    """Derive the estimates, their covariances, and when they exist."""
    made = {bias_kernel.KERNEL: bias_kernel.graph()}
    given = Given(
        towers=(bias_kernel.tower(), example_steps.tower()),
        hints=HINTS,
        steps={
            "one-station": bias_kernel.kernel_steps(made),
            "example": example_steps.example_steps(),
        },
    )
    page = written(NAME, given)
    latex = {**page.latex, **bias_kernel.LATEX, **example_steps.LATEX}
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, (DOPPLER.key, MATRICES.key), latex),
        towers=page.towers,
        programs={
            name: Program({bias_kernel.INPUT: bias_kernel.INPUT}, graph)
            for name, graph in made.items()
        },
        module=bias_kernel.kernel_module(NAME, page.title, made),
        textbook=dict,
        settings=page.settings,
    )
