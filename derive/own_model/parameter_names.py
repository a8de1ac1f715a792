"""Names that a free number of a model may not have, since the derivation gives them to its own."""

from __future__ import annotations

from gainproof.derive.any_three_state import names as three_states
from gainproof.derive.any_two_state import names as two_states
from gainproof.derive.model import Model, ModelError

TAKEN = frozenset({*two_states.LATEX, *three_states.LATEX})


def require_names_of_their_own(model: Model) -> None:
    """Raises ModelError for a free number with the name of a root, a gain, an entry, the index.

    Two symbols of one name are one symbol: what is proved of the one would be said of the other.
    """
    for entry in model.parameters:
        name = entry.quantity.name
        if name in TAKEN:
            raise ModelError(
                f"model {model.name}: the parameter {name} should have another name, a quantity "
                f"of the derivation is called {name}"
            )
