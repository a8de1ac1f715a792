"""Theorems that a verdict rests on and the judge does not prove, told beside its certificate."""

from __future__ import annotations

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.meaning.reach import Reach

NORMAL_MEANS = (
    "moments of a normal noise v of mean 0 and variance s, by parts of its density: "
    "E[v f(v)] = s E[f'(v)], hence E[e^(i k v)] = e^(-k^2 s/2); of independent noises they multiply"
)


def cited(claim: Claim, setting: Setting) -> list[str]:
    """What is used where the claim, or a definition that it uses, takes means of normal noises."""
    if claim.formula is None:
        return []
    reach = Reach(setting.symbols)
    met = {token: None for name in claim.formula.symbols for token in (name, *reach.of(name))}
    entries = [setting.symbols[token] for token in met if token in setting.symbols]
    formulas = [claim.formula, *(e.definition for e in entries if e.definition is not None)]
    takes_means = any(
        node[:2] == ["call", "expectation"]
        for formula in formulas
        for relation in formula.readings[0].relations
        for graph in (relation.left, relation.right)
        for node in map(list, graph["nodes"])
    )
    return [NORMAL_MEANS] if takes_means and any(e.normal for e in entries) else []
