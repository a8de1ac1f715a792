"""Thousands of random inputs: only the reader's own error comes out, and the longest inputs end
soon.
"""

from __future__ import annotations

import random
from itertools import product
from string import ascii_letters

import pytest
from declared import Declared
from one_of_each import cases
from reader_fuzz import check_input, random_text, read_or_refuse
from samples import samples

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_CHARACTERS
from gainproof.verify.judge.reader.reader import read_formula

INPUTS = 1_000


@pytest.mark.sampled
@pytest.mark.parametrize("seed", cases(range(20, 24), lambda seed: seed == 20))
def test_only_the_own_error(seed: int) -> None:
    source, inputs = random.Random(seed), samples(INPUTS)
    read = {False: 0, True: 0}
    for number in range(inputs):
        plain = number % 4 == 0
        read[plain] += check_input(random_text(source), plain)
    # a fuzz that reads little tests the lexers only
    assert read[False] > inputs // 10
    assert read[True] > inputs // 100


REPEATED = (
    *("k", "y", "(", "{", r"\dot", r"\dot{", "x_{", "x_", "k'", "k/", "1", "k/k k+", r"\frac"),
    *("k=1,", "(k=1)", "-", r"\sum_{k=0}^k ", r"\left", r"\text{", "_", "\\", "\n", ",", ".,;"),
    *(r"\frac 1 ", r"\frac\frac", r"\sin", r"\sin k", r"\int_0^T k dk ", r"\left.k\right|_{k=0}"),
    *(r"\begin{pmatrix}", r"\begin{pmatrix}k\\", "k&", r"\quad", r"\quad,", r"\tag{1}", "k^T"),
    *("k|_{k=0}", r"\lim_{k\to 0}", "[k,", "(k,", r"\frac{dk}{dk}", r"\frac{d", "x^{-}", "k^2_k"),
    *("E[", "O(", "e^{", "k(k)", "k(", r"\over ", r"{k\over", "^{", "dot{", "sqrt(", "[k;", "=k"),
)


@pytest.mark.alike
@pytest.mark.parametrize(
    ("piece", "ending"), cases(product(REPEATED, ("=1", "")), lambda case: case[1] == "=1")
)
def test_the_longest_inputs_end(piece: str, ending: str) -> None:
    """Each as long as a formula may be. A reader that takes more than linear time shows here: all
    of them together take seconds.
    """
    text = piece * (MOST_CHARACTERS // len(piece))
    shorter = text[: MOST_CHARACTERS - len(ending)] + ending
    read_or_refuse(shorter)
    read_or_refuse(shorter, plain=True)


def test_dots_over_many_declared_names_end() -> None:
    """Every name could be an index of every other."""
    names = [f"b_{{{first}{second}}}" for first in ascii_letters for second in ascii_letters[:9]]
    symbols = {name: Declared(integer=True) for name in (*names, *ascii_letters)}
    listed = " + ".join(names[:400])
    with pytest.raises(ReaderError):
        read_formula(rf"a = {listed} + \cdots + {names[-1]}", symbols)
