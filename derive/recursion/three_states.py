"""The recursion of position, velocity and acceleration with measured position, any intervals."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation, Step
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.recursion.triple_kernels import graphs
from gainproof.derive.recursion.triple_module import kernel_module
from gainproof.derive.recursion.triple_names import (
    FACTORS,
    PARAMETERS,
    latex,
    predicted_names,
    start_names,
)
from gainproof.derive.recursion.triple_noise import TripleNoise, triple_noises
from gainproof.derive.recursion.triple_steps_difference import difference_steps
from gainproof.derive.recursion.triple_steps_hand_over import hand_over_steps
from gainproof.derive.recursion.triple_steps_model import model_steps
from gainproof.derive.recursion.triple_steps_predict import predict_steps
from gainproof.derive.recursion.triple_steps_start import start_steps
from gainproof.derive.recursion.triple_steps_update import update_steps
from gainproof.derive.recursion.triple_towers import (
    entries_tower,
    intervals_tower,
    pair_tower,
    predict_tower,
    samples_tower,
    start_tower,
    update_tower,
)
from gainproof.derive.relation import Relation
from gainproof.derive.source import GAUSS_MARKOV, SPECTRAL
from gainproof.derive.subject import Program, Subject

NAME = "recursion-three-states"
TITLE = "Kalman recursion of position, velocity and acceleration, any intervals"
OPENING = (
    "With three states the usual factors of a covariance lose digits too: their update subtracts. "
    "Written as shears, like the motion itself, everything is again a sum of positive terms."
)


def build() -> Subject:
    """Derive the recursion with the process noises of the three-state families."""
    known = triple_noises()
    made = graphs(known)
    steps = (
        *model_steps(),
        *(step for noise in known for step in predict_steps(noise)),
        *update_steps(),
        *start_steps(known),
        *difference_steps(),
        *hand_over_steps(),
        *(_program(name, graph, known) for name, graph in made.items()),
    )
    towers = (
        update_tower(),
        intervals_tower(),
        entries_tower(),
        *map(predict_tower, known),
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
            name: Program({entry: PARAMETERS[entry] for entry in symbols_of(graph)}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, TITLE, known, made),
        textbook=dict,
    )


def _program(name: str, graph: Graph, known: tuple[TripleNoise, ...]) -> Step:
    noise = next((each for each in known if name.endswith(each.name)), None)
    starts = name.startswith("start")
    names = {output: output for output in graph["outputs"]}
    if noise is not None:
        meant = start_names(noise) if starts else predicted_names(noise)
        names = dict(zip(FACTORS, meant, strict=True))
    elif name == "update":
        names = {output: f"updated_{output}" for output in FACTORS}
    outputs = {output: real(meant) for output, meant in names.items()}
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation("program", {"program": name, "outputs": outputs}),
        "Evaluate the kernel's graph as a rational function.",
        tower="main" if noise is None else "start" if starts else noise.name,
        hint={"graph": graph},
        shown=False,
    )
