"""A seeded sample of the mutation campaign: no false mutant accepted, no relation refused."""

from __future__ import annotations

from fractions import Fraction

import pytest
from mutation.campaign import REFUSED, Relation, is_false, report, run
from mutation.evaluator import UnknownName, steady_subject
from mutation.mutants import misprints, near_misses
from mutation.relations import claimed_relations, derived_relations
from mutation.tree import Tree, number, to_graph, to_tree
from one_of_each import cases

from gainproof.verify.judge.verdict import Finding

SEED = 20


@pytest.fixture(scope="module")
def relations() -> list[Relation]:
    return [*claimed_relations(), *derived_relations()]


@pytest.mark.parametrize("start", cases(range(16), lambda start: start == 0))
def test_relations_themselves_are_proved(relations: list[Relation], start: int) -> None:
    assert len(relations) > 80
    for relation in relations[start::16]:
        finding = relation.judge(relation.left, relation.right)
        assert finding.verdict == "proved", f"{relation.name}: {finding.reason}"


@pytest.mark.parametrize("start", cases(range(0, 32, 4), lambda start: start == 0))
def test_every_false_mutant_is_refused(relations: list[Relation], start: int) -> None:
    chosen = relations[start::32]
    results = run(chosen, 10, SEED)
    assert len(results) > 8 * len(chosen)
    assert sum(r.near for r in results) > len(results) / 8
    assert all(r.verdict in REFUSED for r in results), report(results)


def test_a_judge_that_accepts_everything_is_seen(relations: list[Relation]) -> None:
    relation = relations[0]
    fooled = Relation(
        relation.name,
        relation.left,
        relation.right,
        relation.variable,
        relation.subjects,
        relation.points,
        lambda *_: Finding("proved", ""),
    )
    results = run([fooled], 10, SEED)
    assert results
    assert "false accepts: 0" not in report(results)


def test_evaluator_tells_a_relation_of_one_family_from_that_of_another() -> None:
    alpha: Tree = ("symbol", "alpha")
    beta: Tree = ("symbol", "beta")
    left = ("mul", alpha, ("add", alpha, beta))
    right = ("mul", number(2), beta)
    model = {
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": [["0", "0"], ["0", "1"]],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
    other = {**model, "process_noise": [["1/4", "1/2"], ["1/2", "1"]]}
    for data, expected in ((model, False), (other, True)):
        subject = steady_subject(data)
        relation = Relation(
            "", left, right, "", (subject,), (Fraction(2),), lambda *_: Finding("undecided", "")
        )
        assert is_false(relation, left, right) is expected


def test_a_true_mutant_is_not_called_false(relations: list[Relation]) -> None:
    """The square does not mind the sign. Names that only a derivation gives are known too; with one
    that is not known, nothing is said.
    """
    (roots,) = (r for r in relations if r.name == "random-velocity roots-in-the-index")
    (subject,) = roots.subjects
    rho: Tree = ("symbol", "rho")
    square, other = ("pow", rho, Fraction(2)), ("pow", ("neg", rho), Fraction(2))
    assert not is_false(roots, roots.left, roots.right)
    assert not is_false(roots, square, other)
    assert is_false(roots, square, ("mul", rho, other))
    with pytest.raises(UnknownName, match="omega"):
        subject.value(("symbol", "omega"), Fraction(1))


def test_mutants_are_many_and_differ() -> None:
    tree = (
        "div",
        ("pow", ("symbol", "a"), Fraction(2)),
        ("add", number(2), ("neg", ("symbol", "a"))),
    )
    made = [new for _, new in misprints(tree)]
    assert len(made) > 15
    assert tree not in made
    assert len(list(near_misses(tree, "a"))) >= 4
    assert to_tree(to_graph(tree)) == tree
