"""Other tools on certificates and bounds: what is true is accepted, what is broken is not."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from gainproof.campaign.printed_bound import other_bounds, printed_bounds
from gainproof.certify import bounds, external, portions, tools
from gainproof.certify.carrying_out import carry_out
from gainproof.certify.cover import Cover
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements, towers
from gainproof.certify.rounding_bound import covered
from gainproof.certify.subjects import Subject, chosen
from gainproof.cli import main

SECONDS = 120.0


def _tool(name: str) -> tools.Tool:
    (tool,) = (tool for tool in tools.TOOLS if tool.name == name)
    if not tool.present():
        pytest.skip(f"{tool.program} is not installed")
    return tool


def _subject(name: str) -> Subject:
    (subject,) = chosen([name])
    return subject


def _part(subject: Subject, *names: str) -> Subject:
    """The subject with a copy of its certificate that has these statements only."""
    certificate = json.loads(json.dumps(subject.certificate))
    certificate["statements"] = [s for s in certificate["statements"] if s["id"] in names]
    assert len(certificate["statements"]) == len(names)
    return replace(subject, certificate=certificate)


def _ids(subject: Subject, kind: str) -> list[str]:
    return [s["id"] for s in subject.certificate["statements"] if s["kind"] == kind]


@pytest.fixture(scope="module")
def small() -> Subject:
    """Riccati, Jury, positivity and an equality of one family with roots."""
    subject = _subject("random-velocity")
    names = [_ids(subject, kind)[0] for kind in ("riccati", "stable", "positive_definite")]
    return _part(subject, *names, "alpha-below-one")


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "statement"),
    [
        ("alpha-beta", "optimum"),  # a divisor that occurs twice
        ("interacting-gains", "none-at-two"),  # a factor of one that is not 0 by hypothesis
        ("alpha-beta-gamma", "transfer"),  # one that is not 0 by hypothesis, which `field` doubles
    ],
)
def test_coq_takes_divisors_as_they_come(name: str, statement: str) -> None:
    found = _tool("coq").certify(_part(_subject(name), statement), SECONDS)
    assert (found.accepted, found.rejected) == (1, "")


SLOW = ["flint", "singular", pytest.param("coq", marks=pytest.mark.thorough)]
"""The tools, of which coqc takes tens of seconds for roots."""


def test_coq_accepts_what_is_true_and_not_what_is_false(small: Subject) -> None:
    true = _part(small, "alpha-below-one")
    assert _tool("coq").certify(true, SECONDS).accepted == 1
    false = _change(small, "positive", ("claim", "expression", "nodes", 0, 1), "1/2")
    outcome = _tool("coq").certify(false, SECONDS)
    assert (outcome.accepted, outcome.rejected[:16]) == (0, "alpha-below-one:")


@pytest.mark.parametrize("name", SLOW)
def test_a_certificate_is_accepted(name: str, small: Subject) -> None:
    outcome = _tool(name).certify(small, SECONDS)
    assert not outcome.rejected
    assert outcome.accepted == outcome.statements == 5  # the cofactors are one of their own


def _first(certificate: Any, kind: str) -> Any:
    return next(s for s in certificate["statements"] if s["kind"] == kind)


def _change(subject: Subject, kind: str, path: Sequence[str | int], new: object) -> Subject:
    (name,) = _ids(subject, kind)[:1]
    broken = _part(subject, name)
    place = _first(broken.certificate, kind)
    for step in path[:-1]:
        place = place[step]
    assert place[path[-1]] != new
    place[path[-1]] = new
    return broken


BROKEN: dict[str, tuple[str, tuple[str | int, ...], object]] = {
    "cofactor": ("riccati", ("evidence", "cofactors", "1,1", 0, 0, 0), "3/32"),
    "process noise": ("riccati", ("claim", "model", "process_noise", 1, 1), "2"),
    "gain": ("riccati", ("claim", "gain", 0), "beta"),
    "Jury value": ("stable", ("evidence", "values", 1, "num", 0, 0), "3"),
    "sign of a Jury value": ("stable", ("evidence", "values", 0, "num", 0, 0), "-4"),
    "minor": ("positive_definite", ("evidence", "minors", 1, "num", 0, 0), "1/5"),
    "positive": ("positive", ("claim", "expression", "nodes", 0, 1), "1/2"),
}


@pytest.mark.parametrize("name", SLOW)
@pytest.mark.parametrize(
    "how",
    [
        pytest.param(how, marks=[] if how in ("cofactor", "Jury value") else pytest.mark.thorough)
        for how in BROKEN
    ],
)
def test_a_broken_certificate_is_rejected(name: str, how: str, small: Subject) -> None:
    kind, path, new = BROKEN[how]
    outcome = _tool(name).certify(_change(small, kind, path, new), SECONDS)
    assert outcome.rejected
    assert outcome.accepted < outcome.statements


@pytest.mark.parametrize("name", SLOW)
def test_what_is_positive_nowhere_by_its_coefficients_is_rejected(
    name: str, small: Subject
) -> None:
    """0 < alpha - 1 with its own true value as evidence: equal, and negative."""
    broken = _change(small, "positive", ("claim", "expression", "nodes", 0, 1), "-1")
    claim = _first(broken.certificate, "positive")
    claim["claim"]["expression"]["nodes"][2] = ["mul", 1]
    (term,) = claim["evidence"]["value"]["num"]
    term[0] = "-4"
    assert _tool(name).certify(broken, SECONDS).rejected


def _covered(name: str, kernel: str, output: str, factor: Fraction) -> Cover:
    """What Gappa makes of the printed bound times a factor."""
    _tool("gappa")
    subject = _subject(name)
    (printed,) = (
        p for p in printed_bounds(subject.source) if (p.kernel, p.output) == (kernel, output)
    )
    graph = subject.certificate["programs"][kernel]["graph"]
    return covered(graph, output, printed.domain, printed.bound * factor, SECONDS)


@pytest.mark.thorough
def test_gappa_proves_a_printed_bound_and_not_a_hundredth_less() -> None:
    """The sum is largest at a hundred, where no term of a sum is all of it."""
    found = _covered("random-acceleration", "gains", "alpha", Fraction(1))
    assert found.failed is None
    assert found.pieces < 60
    assert 1.68 < found.largest / 2 <= 1.69
    assert _covered("random-acceleration", "gains", "alpha", Fraction(98, 100)).failed


def test_gappa_looks_at_both_sides_of_a_choice() -> None:
    """x + x^2 below 3/4 has more roundings than x^2 from there on."""
    _tool("gappa")
    graph = _graph(
        ["number", "3/4"],
        ["mul", 0, 0],
        ["add", 0, 2],
        ["call", "select", 0, 1, 3, 2],
    )
    ends = (Fraction(1, 4), Fraction(4))
    assert covered(graph, "y", ends, Fraction(1), SECONDS).failed is None
    failed = covered(graph, "y", ends, Fraction(51, 100), SECONDS).failed
    assert failed is not None
    assert failed[1] <= Fraction(3, 4)
    above = (Fraction(3, 4), Fraction(4))
    assert covered(graph, "y", above, Fraction(51, 100), SECONDS).failed is None


def test_gappa_is_asked_about_0_by_itself() -> None:
    """(x + 1)/10 next to 0 is exactly 1/10 rounded."""
    _tool("gappa")
    graph = _graph(["number", "1"], ["add", 0, 1], ["number", "10"], ["div", 2, 3])
    ends = (Fraction(0), Fraction(4))
    assert covered(graph, "y", ends, Fraction(101, 100), SECONDS).failed is None
    low, high, sums = covered(graph, "y", ends, Fraction(2, 10), SECONDS).failed or (1, 1, None)
    assert (low, high) == (0, 0)
    exact = 2 * 2**52 * abs(Fraction(0.1) * 10 - 1)
    assert sums is not None
    assert abs(sums[0] - exact) < Fraction(1, 10**6)


def test_bounds_that_are_not_asked_about_are_counted() -> None:
    found = {name: other_bounds(_subject(name).source) for name in ("alpha-beta", "filter-step")}
    assert set(found["filter-step"]) == {"kernels of several inputs"}
    assert found["filter-step"].total() > 10
    stated = " ".join(_subject("alpha-beta").source.split()).count("* 2^-52 (float64)")
    one = len(list(printed_bounds(_subject("alpha-beta").source)))
    assert one + found["alpha-beta"].total() == stated


@pytest.mark.thorough
@pytest.mark.parametrize("noise", ["velocity", "acceleration", "continuous-white-acceleration"])
def test_gappa_proves_the_bounds_of_the_gains_of_two_states(noise: str) -> None:
    tool = _tool("gappa")
    subject = _subject(noise if "-" in noise else f"random-{noise}")
    for kernel in ("gains", "predictor_gains"):
        start = subject.source.index(f"def {kernel}(")
        source = subject.source[start : subject.source.index("\ndef ", start)]
        outcome = tool.certify(replace(subject, source=source), 10 * SECONDS)
        assert (outcome.statements, outcome.accepted) == (2, 2)
        bound = next(printed_bounds(source)).bound
        for kept, made in ((f"{float(bound):.2f} *", f"{float(bound) - 0.05:.2f} *"),):
            assert kept in source
            lower = replace(subject, source=source.replace(kept, made))
            assert tool.certify(lower, 10 * SECONDS).rejected


def _graph(*nodes: list[Any]) -> dict[str, Any]:
    return {"nodes": [["symbol", "x"], *nodes], "outputs": {"y": len(nodes)}}


X_AND_ROOT = _graph(["pow", 0, "1/2"], ["add", 0, 1], ["div", 0, 2])
"""x / (x + sqrt(x)): two roundings, and that of the root by its share, 1 next to 0 and 0 far out.
"""
WITH_ITSELF = _graph(["pow", 0, "1/2"], ["mul", 1, 1], ["div", 2, 1])
"""sqrt(x)^2 / sqrt(x): the error of the root counts once, not three times."""
LOST = _graph(["mul", 0, 0], ["number", "1"], ["add", 1, 2])
"""x x + 1: below 1e-162 the square is lost, far out it is infinite."""
LOSING = _graph(["mul", 0, 0], ["pow", 1, "1/2"])
"""sqrt(x x) is wrong below 1e-162."""


@pytest.mark.parametrize(
    ("graph", "domain", "weight"),
    [
        (X_AND_ROOT, (1e-300, 1e300), 3.0),
        (X_AND_ROOT, (1.0, 1e300), 2.5),
        (WITH_ITSELF, (1e-300, 1e300), 3.0),
        (LOSING, (1e-150, 1e150), 1.5),
        *(
            pytest.param(*case, marks=pytest.mark.thorough)
            for case in (
                (LOST, (1e-300, 1e150), 2.0),
                (LOST, (1e-300, 1e160), None),
                (LOSING, (1e-170, 1e150), None),
            )
        ),
    ],
)
def test_weights_of_roundings(
    graph: dict[str, Any], domain: tuple[float, float], weight: float | None
) -> None:
    """Weights are halves of 2^-52, and none is shown where values are lost or infinite."""
    _tool("gappa")
    ends = Fraction(domain[0]), Fraction(domain[1])
    half = Fraction(weight or 10.0) / 2
    above = covered(graph, "y", ends, half * Fraction(1001, 1000), SECONDS)
    assert (above.failed is None) == (weight is not None)
    if weight is not None:
        assert covered(graph, "y", ends, half * Fraction(999, 1000), SECONDS).failed


def test_every_statement_is_handed_over_or_has_a_reason() -> None:
    for subject in chosen(["random-acceleration", "multipath-location", "least-squares-line"]):
        known = towers(subject.certificate)
        for statement in statements(subject.certificate):
            assert bool(statement.goals) != bool(statement.left_out)
            assert statement.left_out or statement.tower in known


def test_the_table_says_what_is_absent(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("gainproof.certify.external.found", lambda _: False)
    assert main(["certify", "least-squares-mean"]) == 0
    text = capsys.readouterr().out
    assert "coqc is not installed" in text
    assert "flint" in text
    assert main(["certify", "least-squares-mean", "--tool", "coq"]) == 2


def test_an_unknown_subject(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["certify", "least-square-mean"]) == 2
    assert "least-squares-mean" in capsys.readouterr().err


def test_what_is_kept_is_not_asked_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nor what time ran out of kept; and other certificates, code and tools are asked anew."""
    state = tmp_path / "state.jsonl"
    command = ["certify", "least-squares-mean", "--tool", "flint", "--state", str(state)]
    assert main(command) == 0
    first = capsys.readouterr().out
    assert "6         6" in first
    (line,) = state.read_text().splitlines()

    asked: list[str] = []

    def certify(subject: Subject, limit: float) -> Outcome:
        asked.append(subject.name)
        return _tool("flint").certify(subject, limit)

    code = portions._code.__wrapped__
    monkeypatch.setattr(portions, "_code", code)
    monkeypatch.setattr(portions, "TOOLS", (replace(_tool("flint"), certify=certify),))
    assert main(command) == 0
    assert (capsys.readouterr().out, asked) == (first, [])
    monkeypatch.setattr(portions, "_code", lambda: "other code")
    assert main(command) == 0
    assert asked == ["least-squares-mean"]
    capsys.readouterr()
    monkeypatch.setattr(portions, "_code", code)
    unfinished = json.loads(line)
    unfinished["result"]["unfinished"] = True
    state.write_text(json.dumps(unfinished) + "\n")
    assert main(command) == 2
    assert "line 1" in capsys.readouterr().err
    assert main([*command[:-2], "--jobs", "0"]) == 2


def test_what_ran_out_of_time_is_asked_again(tmp_path: Path) -> None:
    asked: list[float] = []

    def certify(subject: Subject, limit: float) -> Outcome:
        asked.append(limit)
        return Outcome(subject.name, "flint", 3, 2, 1.0, unfinished=limit < 10)

    def carried_out(seconds: float) -> list[Outcome]:
        told: list[Outcome] = []
        path = tmp_path / "state.jsonl"
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(portions, "TOOLS", (tool,))
            assert carry_out(subjects, [tool], seconds, 1, path, told.append) == told
        return told

    tool = replace(_tool("flint"), certify=certify)
    subjects = list(chosen(["least-squares-line", "least-squares-mean"]))
    assert [each.unfinished for each in carried_out(5.0)] == [True, True]
    assert [each.unfinished for each in carried_out(20.0)] == [False, False]
    assert [each.accepted for each in carried_out(5.0)] == [2, 2]
    assert asked == [5.0, 5.0, 20.0, 20.0]


def test_gappa_is_asked_about_each_output_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Outputs that are computed alike go together, all of them somewhere, and join again."""
    monkeypatch.setattr(portions, "_version", lambda _: "any")
    (gappa,) = (tool for tool in tools.TOOLS if tool.name == "gappa")
    subject = _subject("random-velocity")
    found = [names for _, _, names, _ in portions.portions(subject, gappa)]
    assert ["gains.beta", "predictor_gains.velocity"] in [sorted(names) for names in found]
    wanted = sorted(each.name for each in printed_bounds(subject.source))
    assert sorted(name for names in found for name in names) == sorted([*wanted, bounds.OTHERS])

    def asked(
        graph: object, output: str, domain: object, bound: object, limit: float, say: object
    ) -> Cover:
        return Cover(1, Fraction(1))

    monkeypatch.setattr("gainproof.certify.bounds.covered", asked)
    whole = gappa.certify(subject, SECONDS)
    parts = [gappa.certify(replace(subject, only=frozenset(each)), SECONDS) for each in found]
    both = [each.rpartition(",")[0] for each in sorted(portions.joined(parts).notes)]
    assert both == [each.rpartition(",")[0] for each in sorted(whole.notes)]
    assert portions.joined(parts).statements == whole.statements == len(wanted)
    assert portions.joined(parts).left_out == whole.left_out == {"errors over a scale": 5}
    rejected = replace(parts[1], rejected="here", unfinished=True, left_out={"choices": 2})
    again = portions.joined([parts[2], rejected, replace(parts[3], left_out={"choices": 1})])
    assert (again.rejected, again.unfinished, again.left_out) == ("here", True, {"choices": 3})


def test_processes_say_the_same(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["certify", "least-squares-mean", "least-squares-line", "--tool", "flint"]
    told = []
    for more in ([], ["--jobs", "2", "--state", str(tmp_path / "state")]):
        assert main([*command, *more]) == 0
        rows = capsys.readouterr().out.splitlines()
        told.append([row.split()[:4] for row in rows if row.startswith("least")])
    assert told[0] == told[1]
    assert len(told[0]) == 2


def test_coq_is_asked_about_each_statement_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """A few at a time, so that one that is not accepted hides no others; they join again."""
    monkeypatch.setattr(portions, "_version", lambda _: "any")
    (coq,) = (tool for tool in tools.TOOLS if tool.name == "coq")
    subject = _subject("random-velocity")
    found = [names for _, _, names, _ in portions.portions(subject, coq)]
    every = list(statements(subject.certificate))
    assert sorted(name for names in found for name in names) == sorted({s.id for s in every})
    asked: list[str] = []

    def ask(_command: object, _name: str, text: str, _limit: float) -> external.Answer:
        asked.append(text)
        return external.Answer(0, "", 0.0)

    monkeypatch.setattr(external, "ask", ask)
    whole = coq.certify(subject, SECONDS)
    parts = [coq.certify(replace(subject, only=frozenset(each)), SECONDS) for each in found]
    assert portions.joined(parts) == replace(whole, seconds=0.0)
    lemmas = [sorted(re.findall(r"Lemma \w+ : (.*?)\. Proof", text)) for text in asked]
    assert sorted(each for some in lemmas[1:] for each in some) == lemmas[0]
