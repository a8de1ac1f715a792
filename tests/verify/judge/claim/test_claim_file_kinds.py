"""Fields that belong to one kind of claim, and to conventions of a setting."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.file import Claim, ClaimFileError, Setting, read_claim_text

HEAD = r"""format = "gainproof claims 1"

[source]
key = "someone-2001"
title = "Gains of a Filter"
authors = ["A. Someone"]
publication = "Journal of Filters"

[settings.free]
title = "numbers"
kind = "algebra"

[settings.free.symbols]
'a' = { unit = "1", meaning = "any number" }
'b' = { unit = "1", meaning = "another" }
'z' = { unit = "1", meaning = "variable of a polynomial" }
'p' = { unit = "m^2", meaning = "variance" }
'p_k' = { unit = "m^2", meaning = "variance at sample k" }
'p_{k-1}' = { unit = "m^2", meaning = "variance at sample k-1" }
'A' = { unit = "1", shape = [2, 3], meaning = "a matrix" }

"""
STEADY = r"""
[settings.steady]
title = "two states"
kind = "steady_state"
model = "search"
%s
[settings.steady.symbols]
'\alpha' = { quantity = "%s", meaning = "position gain" }
"""
LATEX = "latex = 'a = b'\n"


def claim(kind: str, fields: str) -> Claim:
    text = f'[[claims]]\nid = "1"\nplace = "p. 1"\nsetting = "free"\nkind = "{kind}"\n{fields}'
    return read_claim_text(HEAD + text).claims[0]


def setting(lines: str, quantity: str = "gain.1") -> Setting:
    text = '[[claims]]\nid = "1"\nplace = "p"\nsetting = "free"\nkind = "identity"\n' + LATEX
    return read_claim_text(HEAD + STEADY % (lines, quantity) + text, "own.toml").settings["steady"]


def test_monotone() -> None:
    found = claim("monotone", 'about = [\'\\frac{1}{a}\', "a"]\ntrend = "decreasing"')
    assert found.own["about"].symbol == "a"
    assert found.own["about"].expression["nodes"][-1][0] == "div"
    assert found.own["trend"].word == "decreasing"


def test_asymptotics() -> None:
    found = claim("asymptotics", "latex = 'a = b \\quad (b \\to 0)'\norder = 2")
    assert found.own["order"].number == 2


def test_value() -> None:
    found = claim("value", "latex = 'a \\approx 0.382'")
    assert found.formula is not None
    assert found.formula.readings[0].relations[0].operator == "approx"


def test_location() -> None:
    found = claim(
        "location", "polynomial = 'z^2 - a'\nvariable = 'z'\nwhere = 'inside the unit circle'"
    )
    assert found.own["polynomial"].expression["nodes"][0] == ["symbol", "z"]
    assert found.own["variable"].symbol == "z"
    assert found.own["where"].word == "inside the unit circle"


def test_steady_state() -> None:
    fields = "latex = 'p = a p'\nrecursion = 'p_k = b p_{k-1}'\nprevious = 'p_{k-1}'"
    found = claim("steady_state", fields)
    assert len(found.own["recursion"].formulas) == 1
    assert found.own["previous"].symbol == "p_{k-1}"


def test_shape() -> None:
    symbols = (
        read_claim_text(
            HEAD
            + '[[claims]]\nid = "1"\nplace = "p"\nsetting = "free"\nkind = "identity"\n'
            + LATEX
        )
        .settings["free"]
        .symbols
    )
    assert symbols["A"].shape == (2, 3)
    assert symbols["a"].shape is None


@pytest.mark.parametrize(
    ("kind", "fields", "where", "problem"),
    [
        ("identity", LATEX + "trend = 'increasing'", "trend", "does not take"),
        ("monotone", "about = ['a']\ntrend = 'increasing'", "about", "with which"),
        ("monotone", "about = ['a', 'c']\ntrend = 'increasing'", "about", "not declared"),
        ("monotone", "about = ['a +', 'b']\ntrend = 'increasing'", "about", ""),
        ("monotone", "about = ['a', 'b']\ntrend = 'up'", "trend", "none of increasing"),
        ("monotone", "about = ['a', 'b']", "trend", "missing"),
        ("asymptotics", LATEX, "latex", "where to"),
        ("asymptotics", LATEX + "order = -1", "order", "outside"),
        ("value", "latex = 'a \\approx b'", "latex", "number on one side"),
        ("value", "latex = 'a < 0.3'", "latex", "no relation <"),
        ("location", "where = 'real'", "polynomial", "wanted"),
        ("location", "polynomial = 'z^2'\nwhere = 'real'", "variable", "together"),
        ("location", "polynomial = 'z^2'\nvariable = 'z'", "where", "missing"),
        ("location", LATEX + "where = 'far away'", "where", "none of"),
        ("steady_state", LATEX + "previous = 'a'", "recursion", "missing"),
        ("steady_state", LATEX + "recursion = 'a = b'", "previous", "missing"),
        ("steady_state", LATEX + "recursion = 'a < b'\nprevious = 'a'", "recursion", "one equ"),
        ("steady_state", LATEX + "recursion = 'a = b'\nprevious = 'c'", "previous", "declared"),
        ("solutions", LATEX + "variable = 'a'", "number", "missing"),
        ("solutions", LATEX + "number = 1", "variable", "missing"),
        ("solutions", LATEX + "variable = 'a'\nnumber = -1", "number", "outside"),
        ("solutions", "latex = 'a < b'\nvariable = 'a'\nnumber = 1", "latex", "no relation <"),
        ("identity", LATEX + "number = 1", "number", "does not take"),
        ("determines", "about = ['a', 'b']", "text", "missing"),
        ("identity", LATEX + "plain = 'a = b'", "plain", "either"),
        ("identity", LATEX + "branch = 'upper'", "branch", "no"),
        ("identity", "latex = 'a = \\pm b'\nbranch = 'left'", "branch", "none of upper, lower"),
        ("identity", "latex = 'a = \\pm b'", "latex", "declare branch"),
    ],
)
def test_fields_of_kinds_refused(kind: str, fields: str, where: str, problem: str) -> None:
    with pytest.raises(ClaimFileError) as caught:
        claim(kind, fields)
    assert caught.value.where == f"claims.1.{where}"
    assert problem in caught.value.problem


@pytest.mark.parametrize("shape", ["[2]", "[0, 1]", "[2, true]", "[2, 99]", "'2x2'", "[1.0, 1]"])
def test_shapes_refused(shape: str) -> None:
    with pytest.raises(ClaimFileError, match="whole numbers"):
        read_claim_text(HEAD.replace("[2, 3]", shape))


def test_conventions() -> None:
    found = setting("gain = 'predictor'\nthird_gain = '1/2'\npower_of_T = 0\nnoise = 'search'")
    assert (found.gain, found.third_gain, found.power_of_T) == ("predictor", "1/2", "0")
    assert (found.noise, found.index_origin, found.covariance) == ("search", "0", "predicted")


def test_what_no_symbol_depends_on_is_not_searched_for() -> None:
    assert setting("").gain == "search"
    assert setting("", "filter_gain.1").gain == "filter"
    assert setting("", "covariance.1.1").covariance == "search"


@pytest.mark.parametrize("gain", ["predictor", "search"])
def test_a_form_of_gain_that_reaches_no_symbol(gain: str) -> None:
    with pytest.raises(ClaimFileError, match=r"line \d+: settings.steady.gain: .* as gain.1"):
        setting(f"gain = '{gain}'", "filter_gain.1")


@pytest.mark.parametrize(
    ("line", "quantity", "name"),
    [
        ("third_gain = 2", "filter_gain.3", "gain.3"),
        ("power_of_T = 0", "predictor_gain.2", "gain.2"),
        ("covariance = 'search'", "updated_covariance.1.2", "covariance.1.2"),
    ],
)
def test_conventions_that_reach_no_symbol(line: str, quantity: str, name: str) -> None:
    with pytest.raises(ClaimFileError, match=rf"does not reach \\alpha, .* as {name}$"):
        setting(line, quantity)


def test_the_usual_convention_may_be_said() -> None:
    assert setting("gain = 'filter'\npower_of_T = 1", "filter_gain.2").gain == "filter"


@pytest.mark.parametrize("line", ["third_gain = 3", "noise = 'loud'", "index_origin = true"])
def test_conventions_refused(line: str) -> None:
    with pytest.raises(ClaimFileError, match=r"settings\.steady\."):
        setting(line)


def test_plain_text_is_read_to_the_same_graphs() -> None:
    found = claim("identity", "plain = 'a^2/(2 - a) = b'\n")
    printed = claim("identity", "latex = '\\frac{a^2}{2 - a} = b'\n")
    assert found.plain == "a^2/(2 - a) = b"
    assert found.formula is not None
    assert printed.formula is not None
    assert found.formula.readings == printed.formula.readings
    assert found.latex == "\\frac{a^{2}}{2 - a} = b"


def test_a_branch_is_part_of_the_reading() -> None:
    found = claim("identity", "latex = 'a = \\pm b'\nbranch = 'lower'\n").formula
    assert found is not None
    (reading,) = found.readings
    assert reading.text == "the lower signs"
    assert reading.relations[0].right["nodes"][-1][0] == "neg"


def test_a_relation_of_another_kind_names_the_kinds_that_have_it() -> None:
    with pytest.raises(ClaimFileError, match="no relation approx; kinds that have it: value"):
        claim("identity", "latex = 'a \\approx 0.4'\n")


@pytest.mark.parametrize(
    ("fields", "why"),
    [
        ("variance = 'p', distribution = 'uniform'", "'uniform' is not known"),
        ("distribution = 'normal'", "its variance is missing"),
        ("definition = '2 p', distribution = 'normal'", "its variance is missing"),
        ("definition = '2 p', variance = 'p', distribution = 'normal'", "only a free symbol"),
    ],
)
def test_distributions_refused(fields: str, why: str) -> None:
    line = f"'n' = {{ unit = \"m\", {fields}, meaning = 'noise' }}\n"
    with pytest.raises(ClaimFileError, match=why):
        read_claim_text(HEAD.replace("'A' =", f"{line}'A' ="))
