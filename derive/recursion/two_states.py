"""The recursion of position and velocity with measured position, over any intervals."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.recursion.kernels import graphs
from gainproof.derive.recursion.module import kernel_module
from gainproof.derive.recursion.names import (
    FACTORS,
    PARAMETERS,
    latex,
    predicted_names,
    start_names,
    step_names,
)
from gainproof.derive.recursion.noise import Noise, noises
from gainproof.derive.recursion.steps_difference import difference_steps
from gainproof.derive.recursion.steps_hand_over import ROOT, hand_over_steps
from gainproof.derive.recursion.steps_model import model_steps
from gainproof.derive.recursion.steps_predict import predict_steps, shift_step
from gainproof.derive.recursion.steps_start import start_steps
from gainproof.derive.recursion.steps_update import update_steps
from gainproof.derive.recursion.towers import (
    entries_tower,
    intervals_tower,
    main_tower,
    pair_tower,
    samples_tower,
    start_tower,
)
from gainproof.derive.relation import Relation
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Program, Subject

NAME = "recursion-two-states"
TITLE = "Kalman recursion of position and velocity, any intervals"
OPENING = (
    "Before its steady state, with intervals that differ and with detections missed, a filter "
    "needs its covariance sample by sample. Carried on as it stands it loses digits and, in the "
    "end, its meaning; here it is carried so that no two computed numbers are ever subtracted."
)


def build() -> Subject:
    """Derive the recursion with the process noises of the two-state families."""
    known = noises()
    made = graphs(known)
    steps = (
        *model_steps(),
        shift_step(),
        *(step for noise in known for step in predict_steps(noise)),
        *update_steps(),
        *start_steps(known),
        *difference_steps(),
        *hand_over_steps(),
        *(_program(name, graph, known) for name, graph in made.items()),
    )
    towers = (
        main_tower(known),
        intervals_tower(),
        entries_tower(),
        start_tower(known),
        pair_tower(),
        samples_tower(),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (SPECTRAL.key, GAUSS_MARKOV.key), latex(known)),
        towers={tower.name: tower for tower in towers},
        programs={
            name: Program(
                {entry: PARAMETERS.get(entry, entry) for entry in symbols_of(graph)}, graph
            )
            for name, graph in made.items()
        },
        module=kernel_module(NAME, TITLE, known, made),
        textbook=dict,
    )


def _program(name: str, graph: Graph, known: tuple[Noise, ...]) -> Step:
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation("program", {"program": name, "outputs": _meant(name, graph, known)}),
        "Evaluate the kernel's graph as a rational function.",
        tower={"hand": "samples", "start": "start"}.get(name.split("_")[0], "main"),
        hint={"graph": graph, "roots": {"root": ROOT}},
        shown=False,
    )


def _meant(name: str, graph: Graph, known: tuple[Noise, ...]) -> dict[str, object]:
    """The quantity that each output stands for."""
    noise = next((each for each in known if name.endswith(each.name)), None)
    names = {output: output for output in graph["outputs"]}
    if noise is not None and name.startswith("start"):
        names = dict(zip(FACTORS, start_names(noise), strict=True))
    elif noise is not None and name.startswith("predict"):
        names = dict(zip(FACTORS, predicted_names(noise), strict=True))
    elif noise is not None:
        names = step_names(noise)
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    return {output: real(meant) for output, meant in names.items()}
