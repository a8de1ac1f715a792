"""Formulas with more than one sensible reading say which was taken; all others say nothing."""

from __future__ import annotations

from dataclasses import dataclass

import pytest
from small_claims import judged

from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.reader.reader import read_formula, read_plain


@dataclass(frozen=True)
class Declared:
    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False


LETTERS = {token: Declared() for token in ("a", "b", "c", "d", "f", "x", r"\theta", r"\hat{P}")}
LETTERS["g"] = Declared(("u",))


def read(text: str, plain: bool = False) -> Reading:
    reader = read_plain if plain else read_formula
    return reader(text, LETTERS).readings[0]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("f(x) = a", ["f(x) is the product of f and x"]),
        ("a = 2 f(x) + b", ["f(x) is the product of f and x"]),
        ("a f^2(x) = b", ["f^2(x) is the product of f^2 and x"]),
        (r"\frac{\hat{P}(a)}{b} = c", [r"\hat{P}(a) is the product of \hat{P} and a"]),
        (r"a = f [x] \quad (b > 0)", ["f [x] is the product of f and x"]),
        (r"\sin 2x = a", [r"\sin 2x is \sin(2x)"]),
        (r"a = b\cos^2 3\theta", [r"\cos^2 3\theta is \cos^2(3\theta)"]),
        (
            r"a \neq b \neq c",
            [r"a \neq b \neq c says a \neq b and b \neq c and nothing of other pairs"],
        ),
        ("a = b/f(x)", ["f(x) is the product of f and x"]),
        ("a < b > c", ["a < b > c says a < b and b > c and nothing of other pairs"]),
        (r"a \equiv b", [r"\equiv is an equation"]),
        ("a := f(x)", [":= is an equation", "f(x) is the product of f and x"]),
    ],
)
def test_another_reading_is_told(text: str, said: list[str]) -> None:
    assert list(read(text).taken) == said


@pytest.mark.parametrize(
    "text",
    [
        "a(b + c) = a b + a c",
        "a(1 - x) = b",
        "(a)(b) = c",
        "2(x) = a",
        "g(x) = a",
        "a b = c d",
        r"\sin\theta\cos\theta = a",
        r"\sin(2x) = a",
        r"a = \ln 2",
        "a = b = c",
        "0 < a < b = c \\leq d",
        r"a = \frac{1}{3} \approx 0.333",
        r"a = b \quad (0 < x < 1)",
        "a/b = c",
    ],
)
def test_what_has_one_reading_needs_no_word(text: str) -> None:
    assert not read(text).taken


def test_two_signs_of_plain_text_are_told() -> None:
    assert read("a == f(x)", plain=True).taken == (
        "== is an equation",
        "f(x) is the product of f and x",
    )


def test_words_about_the_print_are_no_part_of_what_is_read() -> None:
    assert read("f(x) = a") == read("f x = a")


NUMBER = "{ unit = '1', domain = '%s > 0', meaning = 'a number' }"
SYMBOLS = {token: NUMBER % token for token in ("a", "b", "f", "x")} | {
    "h": "{ unit = '1', definition = 'f(x) + 1', meaning = 'a number by definition' }"
}


@pytest.mark.parametrize(
    ("latex", "verdict", "reading"),
    [
        ("f(x) = x f", "proved", "f(x) is the product of f and x"),
        ("f(x) = 2 f", "refuted", "f(x) is the product of f and x"),
        ("h - 1 = f x", "proved", None),
        ("h = f x", "refuted", "in the definition of h f(x) is the product of f and x"),
        # a chain that holds says what it says; of one that fails a witness speaks of one link
        ("a + b = b + a = a + a + b - a", "proved", None),
        ("a + b = b + a = 2a", "refuted", "a + b = b + a = 2a says a + b = b + a and b + a = 2a"),
    ],
)
def test_verdicts_say_how_it_was_read(latex: str, verdict: str, reading: str | None) -> None:
    found = judged("identity", latex, SYMBOLS)
    assert (found.verdict, found.reading) == (verdict, reading)
