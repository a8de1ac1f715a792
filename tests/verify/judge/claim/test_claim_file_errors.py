"""What is wrong with a claim file is said by name and place."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof.verify.judge.claim.file import (
    MOST_BYTES,
    ClaimFileError,
    read_claim_file,
    read_claim_text,
)

TEXT = r"""format = "gainproof claims 1"

[source]
key = "someone-2001"
title = "Gains of a Filter"
authors = ["A. Someone"]
publication = "Journal of Filters"

[symbols]
'T' = { quantity = "sampling_interval", meaning = "time between samples" }
'a' = { unit = "1", meaning = "any number" }
'b' = { definition = 'a + 1', meaning = "one more" }

[settings.steady]
title = "two states"
kind = "steady_state"
model = "search"

[settings.steady.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain of the position" }

[[claims]]
id = "first"
place = "equation (1)"
kind = "identity"
setting = "steady"
latex = '\alpha = a'

[[claims]]
id = "second"
place = "equation (2)"
kind = "limit"
setting = "steady"
latex = '\alpha \to 1 \quad (a \to \infty)'
"""
MODEL = 'model = "search"'


def refusal(old: str, new: str, count: int = 1) -> ClaimFileError:
    assert old in TEXT
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(TEXT.replace(old, new, count), "own.toml")
    assert str(caught.value).startswith("own.toml")
    return caught.value


def test_the_text_itself_is_read() -> None:
    assert len(read_claim_text(TEXT).claims) == 2


@pytest.mark.parametrize(
    ("old", "new", "where", "problem"),
    [
        ('format = "gainproof claims 1"', "", "file.format", "missing"),
        ("claims 1", "claims 2", "file.format", "wanted"),
        ("'a' = {", "'a' = 1\n'a' = {", "", "'a' stands in this table a second time"),
        ("[source]", "[sources]", "file.sources", "nearest is source"),
        ('key = "someone-2001"', "key = 1", "source.key", "a text is wanted, not a number"),
        ('key = "someone-2001"', 'key = ""', "source.key", "empty"),
        ("title =", "titel =", "source.titel", "nearest is title"),
        ('["A. Someone"]', "[]", "source.authors", "at least one"),
        ('["A. Someone"]', "[1]", "source.authors", "a list of texts"),
        ('publication = "J', 'year = true\npublication = "J', "source.year", "whole number"),
        ('publication = "J', 'year = 0\npublication = "J', "source.year", "outside"),
        ('publication = "J', 'yaer = 2001\npublication = "J', "source.yaer", "nearest is year"),
        ("[settings.steady]", "[setting.steady]", "file.setting", "nearest is settings"),
        ('quantity = "samp', 'quantiy = "samp', "symbols.T.quantiy", "nearest is quantity"),
        ("sampling_interval", "sampling_intervall", "symbols.T.quantity", "sampling_interval"),
        ('unit = "1", ', "", "symbols.a.unit", "needs a unit"),
        ('unit = "1"', 'unit = "km"', "symbols.a.unit", "'km' is no unit"),
        ('unit = "1", meaning', 'unit = "1", meening', "symbols.a.meening", "nearest is meaning"),
        ('meaning = "any number"', 'meaning = ["x"]', "symbols.a.meaning", "not a list"),
        ('{ unit = "1", meaning = "any number" }', '"x"', "symbols.a", "a table is wanted"),
        ('quantity = "samp', 'unit = "m", quantity = "samp', "symbols.T.unit", "whose unit is 's'"),
        ("definition = 'a", "quantity = 'tracking_index', definition = 'a", "symbols.b", "both"),
        ("definition = 'a", "arguments = ['a', 'a'], definition = 'a", "symbols.b", "twice"),
        ("definition = 'a", "arguments = ['z'], definition = 'a", "symbols.b", "not declared"),
        ('unit = "1"', "unit = \"1\", arguments = ['T']", "symbols.a.arguments", "only a def"),
        ('unit = "1"', "undefined = false", "symbols.a.undefined", "only true"),
        ("'a + 1'", "'a = 1'", "symbols.b.definition", "one expression"),
        ("'a + 1'", "'b + 1'", "symbols.b", "in a circle: b -> b"),
        ("'\\alpha' = {", "'\\alpha ' = {}\n'\\alpha' = {", r"symbols.\alpha", "missing"),
        ("'a' =", "'a b' =", "symbols.a b", "not a symbol"),
        ("'a' =", "'infinity' =", "symbols.infinity", "reserved"),
        ("'a' =", "'ln' =", "symbols.ln", "the symbol ln is the name of a function"),
        ("'a' =", "'arctan' =", "symbols.arctan", "name of a function"),
        ("'a' =", "'sqrt' =", "symbols.sqrt", "name of a function"),
        ("'a' =", "'tr' =", "symbols.tr", "name of a function"),
        ("'\\alpha' =", "'T' =", "settings.steady.symbols.T", "shadows"),
        ('kind = "steady_state"', 'kind = "steady"', "settings.steady.kind", "steady_state"),
        (MODEL, "", "settings.steady.model", "wanted"),
        (MODEL, MODEL + "\ndegree = 1", "settings.steady.degree", "no degree"),
        (MODEL, MODEL + "\ntransition = [['1']]", "settings.steady.model", "either"),
        (MODEL, "transition = [['1']]", "settings.steady.process_noise", "four"),
        (MODEL, MODEL + "\ngain = 'both'", "settings.steady.gain", "filter, predictor"),
        (MODEL, MODEL + "\ngian = 'filter'", "settings.steady.gian", "nearest is gain"),
        ('kind = "identity"', 'kind = "identiy"', "claims.first.kind", "identity"),
        ('setting = "steady"', 'setting = "stedy"', "claims.first.setting", "nearest is steady"),
        ('place = "equation (1)"', "", "claims.first.place", "missing"),
        ('place = "equation (1)"', "place = 1979-05-27", "claims.first.place", "date or time"),
        ("latex = '\\alpha = a'", "", "claims.first.latex", "missing"),
        ("latex = '\\alpha = a'", "latx = 'a'", "claims.first.latx", "nearest is latex"),
        ('id = "first"', 'id = "first"\nid2 = 1', "claims.first.id2", "not known"),
        ('id = "second"', 'id = "first"', "claims.first.id", "already that of the claim of line"),
        ('id = "first"', 'id = "fi rst"', "claims number 1.id", "letters, digits"),
        ('id = "first"', "", "claims number 1.id", "missing"),
        ("'\\alpha = a'", "'\\alpha < a'", "claims.first.latex", "no relation <"),
        (r"\quad (a \to \infty)", "", "claims.second.latex", "where to"),
        (
            'kind = "limit"',
            'kind = "implication"\nabout = ["a"]',
            "claims.second.about",
            "not take",
        ),
        ('kind = "limit"', 'kind = "determines"\nabout = ["a"]', "claims.second.about", "two symb"),
        ('kind = "limit"', 'kind = "determines"\nabout = ["a", "c"]', "claims.second.about", "not"),
        ('kind = "identity"', 'kind = "implication"', "claims.first.latex", "two parts"),
    ],
)
def test_named_errors(old: str, new: str, where: str, problem: str) -> None:
    error = refusal(old, new)
    assert where in error.where
    assert problem in error.problem


def test_complaints_of_toml_have_their_place() -> None:
    error = refusal("'\\alpha = a'", '"\\alpha = a"')
    assert error.line == TEXT.split("\n").index("latex = '\\alpha = a'") + 1
    assert error.column is not None
    assert "LaTeX stands in single quotes" in error.problem


def test_a_misspelt_table_has_its_line() -> None:
    error = refusal("[settings.steady]", "[setings.steady]")
    assert error.line == TEXT.split("\n").index("[settings.steady]") + 1


def test_line_of_a_claim() -> None:
    error = refusal(
        'setting = "steady"\nlatex = \'\\alpha \\to', 'setting = "x"\nlatex = \'\\alpha \\to'
    )
    assert error.line == TEXT.split("\n").index('id = "second"') + 4
    assert error.column is None


def test_formula_by_line_column_and_caret() -> None:
    error = refusal(r"'\alpha = a'", r"'\alpha = a + \alpah'")
    line = TEXT.split("\n").index("latex = '\\alpha = a'") + 1
    assert (error.line, error.column) == (line, len("latex = '\\alpha = a + ") + 1)
    assert error.token == r"\alpah"
    assert error.nearest[0] == r"\alpha"
    assert str(error).startswith(f"own.toml, line {line}, column 23: claims.first.latex: ")
    assert str(error).endswith("^")


def test_formula_over_several_lines() -> None:
    error = refusal(r"'\alpha = a'", "'''\n\\alpha\n  = a + q'''")
    line = TEXT.split("\n").index("latex = '\\alpha = a'") + 1
    assert (error.line, error.column) == (line + 2, 9)


def test_formula_in_escapes() -> None:
    error = refusal(r"'\alpha = a'", '"\\\\alpha = \\\\alpha q"')
    assert (error.line, error.column) == (TEXT.split("\n").index('id = "first"') + 1, None)
    assert "line 1, column 17" in error.problem


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("'a + 1'", "'a + q'"),
        ('meaning = "any number"', "domain = 'q > 1', meaning = \"any\""),
        ("'\\alpha = a'", "'\\alpha = a'\ndomain = 'q > 1'"),
        ("'\\alpha = a'", "'\\alpha = a'\ngiven = ['q = 1']"),
    ],
)
def test_formulas_elsewhere(old: str, new: str) -> None:
    error = refusal(old, new)
    assert error.token == "q"
    assert error.line is not None
    lines = TEXT.replace(old, new, 1).split("\n")
    assert lines[error.line - 1][(error.column or 0) - 1] == "q"


def test_circle_of_three() -> None:
    circle = (
        "'b' = { definition = 'c', meaning = 'b' }\n'c' = { definition = 'd + a', meaning = 'c' }\n"
    )
    circle += "'d' = { definition = '2b', meaning = 'd' }\n'b2' ="
    error = refusal("'b' =", circle.replace("'b2'", "'g'"))
    assert "b -> c -> d -> b" in error.problem


def test_the_same_symbol_in_two_spellings() -> None:
    twice = "'x_{k}' = { unit = '1', meaning = 'x' }\n'x_k' = { unit = '1', meaning = 'x' }\n'a' ="
    assert "declared twice" in refusal("'a' =", twice).problem


@pytest.mark.parametrize("character", ["\u200b", "\u202e", "\u0000", "\ue000", "\u2028", "\x1b"])
def test_invisible_characters(character: str) -> None:
    error = refusal("Gains of", f"Gains {character}of")
    assert f"U+{ord(character):04X}" in error.problem
    assert error.line == 5
    assert character not in str(error)


@pytest.mark.parametrize(
    ("latex", "escape", "column"),
    [(r"\theta = a", r"\t", 10), (r"\nu = a", r"\n", 10), (r"\\alpha = \beta", r"\b", 20)],
)
def test_latex_in_double_quotes(latex: str, escape: str, column: int) -> None:
    r"""TOML makes a tab and `heta` of \theta: the symbol heta was said not to be declared."""
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(TEXT.replace(r"'\alpha = a'", f'"{latex}"'))
    assert f"in double quotes {escape} is an escape" in str(caught.value)
    assert f"line 27, column {column}" in str(caught.value)


def test_latex_in_double_quotes_with_each_backslash_doubled() -> None:
    assert len(read_claim_text(TEXT.replace(r"'\alpha = a'", r'"\\alpha = a"')).claims) == 2


def test_names_in_any_script_are_fine() -> None:
    assert read_claim_text(TEXT.replace("A. Someone", "小菅義夫")).source.authors == ("小菅義夫",)


@pytest.mark.parametrize(
    "text",
    [
        "x = ",
        "x = " + "[" * 100_000,
        "x = " + "{a = " * 20_000,
        "x = " + "1" * 5000,
        ".".join("a" * 300) + " = 1",
        "x = 1\nx = 2",
        "[claims]\nid = 1",
        "claims = [1]",
        "x" * 9000,
        "",
        "\ud800",
    ],
)
def test_no_claim_file(text: str) -> None:
    with pytest.raises(ClaimFileError):
        read_claim_text(text, "own.toml")
    with pytest.raises(ClaimFileError):
        read_claim_text(TEXT + text if text else text, "own.toml")


def test_sizes() -> None:
    with pytest.raises(ClaimFileError, match="more than"):
        read_claim_text("#" + "\n" * MOST_BYTES)
    many = "\n".join(f"'a_{{{n}}}' = {{ unit = '1', meaning = 'x' }}" for n in range(501))
    assert "504 symbols" in refusal("'T' =", many + "\n'T' =").problem
    claim = TEXT[TEXT.index('[[claims]]\nid = "first"') : TEXT.index('[[claims]]\nid = "second"')]
    claims = "".join(claim.replace("first", f"n{n}") for n in range(2001))
    assert "2003 claims" in refusal(claim, claim + claims).problem


@pytest.mark.parametrize(
    "key", ["../x", "/etc/x", "a/b", "..", ".x", "-x", "a b", "a\\\\b", "<x>", "x" * 81, "a&b"]
)
def test_a_key_is_no_path_and_no_markup(key: str) -> None:
    """Pages are named after it."""
    found = refusal('key = "someone-2001"', f'key = "{key}"')
    assert found.where == "source.key"
    assert "letters, digits, - _ . : + are wanted" in found.problem
    assert found.line


@pytest.mark.parametrize("key", ["a", "2001", "Müller_2001", "kalata:1984", "a.b+c", "x" * 80])
def test_keys_as_they_are_in_use(key: str) -> None:
    text = TEXT.replace('key = "someone-2001"', f'key = "{key}"')
    assert read_claim_text(text).source.key == key


def test_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(ClaimFileError, match="cannot be read"):
        read_claim_file(tmp_path / "none.toml")
    with pytest.raises(ClaimFileError, match="cannot be read"):
        read_claim_file(tmp_path)
    with pytest.raises(ClaimFileError, match="cannot be read: File name too long"):
        read_claim_file("a" * 300)
    (tmp_path / "latin.toml").write_bytes(b"x = 1\ny = '\xff'")
    with pytest.raises(ClaimFileError, match="line 2: the text is not UTF-8"):
        read_claim_file(tmp_path / "latin.toml")
    (tmp_path / "long.toml").write_bytes(b"#" * (MOST_BYTES + 1))
    with pytest.raises(ClaimFileError, match="more than"):
        read_claim_file(tmp_path / "long.toml")
