"""Steps on the numbers of a model that stay free."""

from __future__ import annotations

from gainproof.derive.any_two_state.names import ODDS
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.model import Model
from gainproof.derive.pages.model_slots import plain
from gainproof.derive.relation import described, equal


def free_number_steps(model: Model) -> list[Step]:
    """One step for each: between which bounds it runs."""
    steps: list[Step] = []
    for entry in model.parameters:
        name, meaning = entry.quantity.name, entry.quantity.meaning
        text = plain(entry.quantity.latex)
        if entry.below_one:
            steps.append(
                Step(
                    f"parameter-{name.replace('_', '-')}",
                    f"`{text}` is the {meaning}, a number between 0 and 1; `x_{text}` runs through "
                    "all positive numbers.",
                    equal(real(name), 1 / (1 + real(f"{name}{ODDS}"))),
                    "Each number between 0 and 1 is `1/(1 + x)` for one positive `x`.",
                )
            )
        else:
            steps.append(
                Step(
                    f"parameter-{name.replace('_', '-')}",
                    f"`{text}` is the {meaning}, any positive number.",
                    described(f"`{text} > 0`"),
                    "It stays free.",
                )
            )
    return steps
