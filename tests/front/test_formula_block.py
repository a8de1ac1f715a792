"""Formulas on a page: matrices as blocks, long lines broken."""

from __future__ import annotations

from gainproof.formulas.formula_block import inline, marked_matrix, set_formula

SQUARE = marked_matrix([["1", "T"], ["0", "-1/2"]])
COLUMN = marked_matrix([["alpha"], ["beta"]])


def test_matrices_stand_side_by_side() -> None:
    assert set_formula(f"{SQUARE} {COLUMN} = b", 80) == [
        "[ 1     T ] [ alpha ] = b",
        "[ 0  -1/2 ] [  beta ]",
    ]


def test_heights_are_centred() -> None:
    tall = marked_matrix([["1"], ["2"], ["3"]])
    assert set_formula(f"x = {tall}", 80) == ["    [ 1 ]", "x = [ 2 ]", "    [ 3 ]"]


def test_a_long_line_goes_on_below() -> None:
    assert set_formula(f"{SQUARE} = {SQUARE}", 16) == [
        "[ 1     T ]",
        "[ 0  -1/2 ]",
        "    = [ 1     T ]",
        "      [ 0  -1/2 ]",
    ]


def test_inline_form_and_matrices_in_matrices() -> None:
    assert inline(f"{SQUARE} x") == "[1, T; 0, -1/2] x"
    assert inline(marked_matrix([[SQUARE]])) == "[[1, T; 0, -1/2]]"


def test_a_long_sum_is_broken_before_signs() -> None:
    text = "y = " + " + ".join(f"a{i}" for i in range(40))
    lines = set_formula(text, 60)
    assert all(len(line) <= 60 for line in lines)
    assert all(line.lstrip().startswith("+") for line in lines[1:])
    assert " ".join(line.strip() for line in lines) == text


def test_one_long_word_is_left_whole() -> None:
    assert set_formula("x" * 200, 60) == ["x" * 200]


def test_a_sum_is_broken_outside_its_parentheses_where_that_can_be_had() -> None:
    text = "y = a0 a1 a2 + b0 b1 (1/2 + c) (d0 + d1)/(1 + e0 e1)"
    assert set_formula(text, 40) == [
        "y = a0 a1 a2",
        "    + b0 b1 (1/2 + c)",
        "        (d0 + d1)/(1 + e0 e1)",
    ]


def test_a_comparison_goes_on_with_its_sign() -> None:
    assert set_formula("a + bbbbbbbb + cccccccc > 0", 25) == ["a + bbbbbbbb + cccccccc", "    > 0"]


def test_an_end_stays_on_one_line() -> None:
    assert set_formula("alpha -> bbbbbbbbbbbb as p -> infinity", 30) == [
        "alpha -> bbbbbbbbbbbb",
        "    as p -> infinity",
    ]
