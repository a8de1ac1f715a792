"""Numbers of a family as a page shows them: no root below the line, no square of a root."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real


def plain_number(value: sp.Expr) -> sp.Expr:
    """A number over named roots of integers, each put back by its name.

    One that holds another generator, a root within a root, is only multiplied out.
    """
    names = {str(symbol): symbol for symbol in value.free_symbols}
    if not all(name.startswith("root_") for name in names):
        return value
    roots = {symbol: sp.sqrt(int(name.removeprefix("root_"))) for name, symbol in names.items()}
    found = sp.expand(sp.radsimp(value.subs(roots)))
    return found.subs({root: real(str(symbol)) for symbol, root in roots.items()})
