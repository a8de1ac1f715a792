"""Names bound while a formula is worked out: arguments of functions, indices of sums, variables of
integrals.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from gainproof.verify.judge.meaning.value import Value


@dataclass(frozen=True)
class Bindings:
    """What bound names stand for; they hide what the table of symbols says of these names, also in
    definitions that use them.

    `symbols` and `trees` keep what was worked out under these bindings.
    """

    names: Mapping[str, Value] = field(default_factory=dict)
    symbols: dict[str, Value] = field(default_factory=dict)
    trees: dict[bytes, Value] = field(default_factory=dict)

    def having(self, more: Mapping[str, Value]) -> Bindings:
        """These bindings and more; an inner name hides an outer one."""
        return Bindings({**self.names, **more})
