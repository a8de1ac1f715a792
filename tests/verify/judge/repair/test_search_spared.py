"""What the search for repairs leaves out, or computes once, changes nothing that it finds."""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from claim_texts import MODELS, algebra, claim_file, judged, memory, steady

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.repair import definition_chains
from gainproof.verify.judge.repair.definition import definition_task
from gainproof.verify.judge.repair.edits import LARGE, PLAIN, SLIGHT
from gainproof.verify.judge.repair.exchanged_symbols import sample_numbers, table_of
from gainproof.verify.judge.repair.formula_values import Values, truth
from gainproof.verify.judge.repair.generic_points import free_points, generic_points
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.repair.single_changes import changes
from gainproof.verify.judge.scope import Scope

CHAIN = algebra(
    "'x' = { unit = '1', domain = 'x > 0', meaning = 'a number' }\n"
    "'y' = { unit = '1', domain = 'y > 0', meaning = 'another' }\n"
    "'a' = { definition = 'x - y', meaning = 'first' }\n"
    "'b' = { definition = 'x y + 1', meaning = 'of no other' }\n"
    "'c' = { definition = '\\frac{a^2}{b}', meaning = 'of both' }\n"
    "'d' = { definition = 'c + \\sqrt{b}', meaning = 'of all' }\n"
)
CLAIMS = [
    ("identity", r"c = \frac{(x + y)^2}{1 + x y}"),
    ("identity", r"d - \sqrt{1 + x y} = \frac{(x + y)^2}{b}"),
    ("inequality", r"b > 1"),
    ("inequality", r"\frac{d}{a} + \sqrt{x} > 0 \quad (a > 0)"),
]


def _convention(setting: Setting) -> Convention:
    found = next(iter(conventions(setting, MODELS, {})))
    assert isinstance(found, Convention)
    return found


@pytest.mark.parametrize(
    ("symbols", "claim"),
    [
        (CHAIN, CLAIMS[1]),
        (CHAIN, CLAIMS[3]),
        (memory(1), ("identity", r"\beta = \frac{6}{k^2 + 3 k + 2} \quad (1 \le k)")),
        (steady("random-velocity"), ("identity", r"\Lambda^2 = \frac{\beta^2}{1 - \alpha}")),
        (steady("random-velocity"), ("inequality", r"\alpha^2 + 2 \beta < 4 - \frac{\alpha}{2}")),
    ],
)
@pytest.mark.parametrize("most", [SLIGHT, PLAIN])
def test_light_changes_are_those_of_all_that_are_light(
    symbols: str, claim: tuple[str, str], most: int
) -> None:
    found = claim_file(symbols, [claim])
    (one,), setting = found.claims, found.settings["s"]
    assert one.formula is not None
    formula = printed(one.formula.readings[0])
    table, numbers = table_of(setting, formula, ()), sample_numbers(setting)
    light = list(changes(formula, table, numbers, most))
    everything = list(changes(formula, table, numbers, LARGE))
    assert {change.weight for change in everything} > {change.weight for change in light}
    seen = {change.printed for change in light}
    # what is heavier and written alike comes first in some places, and is the same formula
    assert seen >= {change.printed for change in everything if change.weight <= most}
    assert seen <= {change.printed for change in everything}


def test_equations_among_the_conditions_leave_no_free_points() -> None:
    claims = [("identity", r"x = y \quad (x = 2 y)"), ("identity", r"x = y \quad (x > 2)")]
    found = claim_file(CHAIN, claims)
    convention = _convention(found.settings["s"])
    for claim, expected in zip(found.claims, (0, 2), strict=True):
        assert claim.formula is not None
        conditions = claim.formula.readings[0].conditions
        free, general = (
            find(claim, conditions, Scope(convention.setting, convention.environment), 2)
            for find in (free_points, generic_points)
        )
        points, put_in = general
        assert len(free) == expected
        assert (free == points) == (not put_in)


class _Plain(Values):
    """Definitions put in by hand, everything computed afresh."""

    def __init__(self, scope: Scope, point: Mapping[str, object], bodies: Mapping[str, Expr]):
        super().__init__(scope, point, {})  # type: ignore[arg-type]
        self.bodies = bodies

    def symbol(self, name: str) -> object:
        return self._ball(self.bodies[name]) if name in self.bodies else super().symbol(name)


@pytest.mark.parametrize("token", ["a", "b", "c", "d"])
def test_what_a_changed_definition_reaches_not_is_known(token: str) -> None:
    found = claim_file(CHAIN, CLAIMS)
    convention = _convention(found.settings["s"])
    setting = convention.setting
    scope = Scope(setting, convention.environment)
    points = {}
    for claim in found.claims:
        assert claim.formula is not None
        fresh = Scope(setting, convention.environment)
        for name in "abcd":
            fresh.symbol(name)
        points[claim.id] = free_points(claim, claim.formula.readings[0].conditions, fresh, 2)
    bodies = definition_chains.printed_bodies(setting)
    definition = setting.symbols[token].definition
    assert definition is not None
    formula = printed(definition.readings[0])
    table = table_of(setting, formula, found.claims)
    tried = [
        body
        for change in changes(formula, table, frozenset())
        if not _uses(body := change.printed.sides[1], token, bodies)
    ]
    assert len(tried) > 50

    def afresh(claim: Claim, body: Expr) -> list[bool | None]:
        assert claim.formula is not None
        told = printed(claim.formula.readings[0])
        changed = {**bodies, token: body}
        return [truth(_Plain(scope, point, changed), told) for point in points[claim.id]]

    several = 0
    for chosen in (found.claims[:1], found.claims[1:2], found.claims[:2], found.claims[2:]):
        chain = definition_chains.Chain(token, chosen, points, scope, bodies)
        for body in tried:
            all_found = [one for claim in chosen for one in afresh(claim, body)]
            expected = False not in all_found and True in all_found
            assert chain.agrees(body) == expected
            several += expected
    assert several


def _uses(body: Expr, token: str, bodies: Mapping[str, Expr]) -> bool:
    """Whether a definition with this body is one in terms of itself."""
    if body.kind == "symbol":
        return body.name == token or (
            body.name in bodies and _uses(bodies[body.name], token, bodies)
        )
    return any(_uses(part, token, bodies) for part in body.parts)


def test_what_is_true_wherever_it_has_a_value_accuses_no_definition() -> None:
    claims = [
        ("identity", r"\frac{c b}{a} = a"),
        ("identity", r"\sqrt{a}^2 = x - y"),
        ("identity", r"b - x y = 2"),
    ]
    found = claim_file(CHAIN, claims)
    verdicts = {verdict.id: verdict for verdict in judged(CHAIN, *claims)}
    assert [v.only_lacks_values for v in verdicts.values()] == [True, True, False]
    task = definition_task(found.settings["s"], found.claims, verdicts, ())
    assert task is not None
    assert {suspect.token for suspect in task.suspects} == {"b"}
    assert definition_task(found.settings["s"], found.claims[:2], verdicts, ()) is None
    (suspect,) = task.suspects
    assert [claim.id for claim in suspect.wrong] == ["c2"]
    assert [claim.id for claim in suspect.kept] == ["c0"]
