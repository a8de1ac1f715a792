"""A definition whose dimension contradicts its use is refuted, and the use is named."""

from __future__ import annotations

from claim_texts import algebra, judged

HEAD = (
    "'a' = { unit = 'm s^-2', meaning = 'acceleration' }\n"
    "'v' = { unit = 'm s^-1', meaning = 'velocity' }\n"
    "'x' = { unit = 'm', meaning = 'position' }\n"
    "'T' = { unit = 's', meaning = 'interval' }\n"
)


def test_use_is_named() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'a T^2 + x', meaning = 'called a velocity' }\n")
    definition, used, other = judged(
        symbols, ("definition", "w = a T^2 + x"), ("identity", "w = v + a T"), ("identity", "x = x")
    )
    assert definition.verdict == "refuted"
    assert definition.method == "dimensions"
    assert definition.reason.startswith(
        "dimensions: w is defined as a length (m), but claim c1 uses it as a velocity (m s^-1)"
    )
    assert used.verdict == "refuted"
    assert "the definition of w is at fault, claim c0" in used.reason
    assert other.verdict == "proved"


def test_unit_said_and_definition_printed_differ() -> None:
    symbols = algebra(HEAD + "'w' = { unit = 'm s^-1', meaning = 'velocity later' }\n")
    definition, used = judged(
        symbols, ("definition", "w = v + a T^2 / T^2"), ("inequality", "w^2 + v^2 \\ge 0")
    )
    assert definition.verdict == "refuted"
    assert used.verdict == "proved"


def test_a_use_that_agrees_clears_the_definition() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'v + a T', meaning = 'velocity later' }\n")
    definition, good, bad = judged(
        symbols, ("definition", "w = v + a T"), ("identity", "w - v = a T"), ("identity", "w = x")
    )
    assert [definition.verdict, good.verdict, bad.verdict] == ["definition", "proved", "refuted"]
    assert bad.method == "dimensions"


def test_a_definition_nobody_uses_is_one() -> None:
    symbols = algebra(HEAD + "'w' = { definition = 'v + a T', meaning = 'velocity later' }\n")
    (definition,) = judged(symbols, ("definition", "w = v + a T"))
    assert definition.verdict == "definition"
