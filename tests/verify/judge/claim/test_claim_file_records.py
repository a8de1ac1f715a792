"""A claim file becomes records."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from gainproof.verify.judge.claim.file import Unit, read_claim_file, read_claim_text
from gainproof.verify.judge.claim.units import read_unit, unit_text_of
from gainproof.verify.judge.quantity_names import quantity_names

TEXT = r"""
format = "gainproof claims 1"

[source]
key = "someone-2001"
title = "Gains of a Filter"
authors = ["A. Someone", "B. Other"]
publication = "Journal of Filters 3, 14-15"
year = 2001
doi = "10.1000/1"

[symbols]
'T' = { quantity = "sampling_interval", meaning = "time between samples" }
'r' = { definition = '\frac{\sigma_w T^2}{\sigma_v}', meaning = "index of the source" }
'\sigma_w' = { unit = "m s^-2", domain = '\sigma_w > 0', meaning = "noise of the acceleration" }
'\sigma_v' = { quantity = "measurement_noise_deviation", meaning = "noise of the position" }
'\lambda' = { undefined = true, meaning = "printed and never said what it is" }

[settings.steady]
title = "two states"
kind = "steady_state"
model = "search"
gain = "predictor"

[settings.steady.symbols]
'\alpha' = { quantity = "gain.1", meaning = "gain of the position" }
'f' = { definition = 'x^2 + T', arguments = ["x"], meaning = "some function" }
'x' = { unit = "1", meaning = "its argument" }

[settings.own]
title = "a model of the user"
kind = "steady_state"
transition = [["1", "T"], ["0", "1"]]
process_noise = [['T^4/4 \sigma_w^2', 'T^3/2 \sigma_w^2'], ['T^3/2 \sigma_w^2', 'T^2 \sigma_w^2']]
measurement = [["1", "0"]]
measurement_noise = [['\sigma_v^2']]

[settings.fitted]
title = "growing memory"
kind = "growing_memory"
degree = 2

[[claims]]
id = "1"
place = "equation (1)"
kind = "identity"
setting = "steady"
latex = '\alpha = f(r)'
domain = 'r > 0 and T > 0'
given = ['T = 1']
note = "a note"

[[claims]]
id = "2"
place = "below equation (1)"
kind = "remark"
setting = "fitted"
text = "It works well."
"""
# a slash before juxtaposed factors is refused in a matrix
TEXT = TEXT.replace(r"T^4/4 \sigma", r"\frac{T^4}{4} \sigma").replace(
    r"T^3/2 \sigma", r"\frac{T^3}{2} \sigma"
)


def test_source() -> None:
    source = read_claim_text(TEXT).source
    assert source.key == "someone-2001"
    assert source.authors == ("A. Someone", "B. Other")
    assert (source.year, source.doi, source.url) == (2001, "10.1000/1", None)


def test_symbols() -> None:
    file = read_claim_text(TEXT)
    entries = file.settings["steady"].symbols
    assert entries["T"].role == "quantity"
    assert entries["T"].unit == Unit(second=Fraction(1))
    assert entries["r"].role == "definition"
    assert entries["r"].definition is not None
    assert entries["r"].definition.readings[0].relations[0].right["nodes"][-1][0] == "div"
    assert entries[r"\sigma_w"].role == "free"
    assert entries[r"\sigma_w"].unit == Unit(Fraction(1), Fraction(-2))
    assert entries[r"\sigma_w"].domain[0].operator == ">"
    assert entries[r"\lambda"].role == "undefined"
    assert entries["f"].arguments == ("x",)
    assert r"\alpha" not in file.symbols
    assert r"\alpha" not in file.settings["own"].symbols


def test_settings() -> None:
    settings = read_claim_text(TEXT).settings
    assert list(settings) == ["steady", "own", "fitted"]
    assert (settings["steady"].model, settings["steady"].gain) == ("search", "predictor")
    own = settings["own"]
    assert own.model is None
    # no symbol depends on the form of the gain
    assert own.gain == "filter"
    assert own.own_model is not None
    assert len(own.own_model.process_noise) == 2
    assert own.own_model.measurement[0][1] == {
        "nodes": [["number", "0"]],
        "outputs": {"value": 0},
    }
    assert settings["fitted"].degree == 2


def test_claims() -> None:
    first, second = read_claim_text(TEXT).claims
    assert (first.id, first.kind, first.setting) == ("1", "identity", "steady")
    assert first.latex == r"\alpha = f(r)"
    assert first.formula is not None
    assert first.formula.symbols == (r"\alpha", "f", "r")
    assert [relation.operator for relation in first.domain] == [">", ">"]
    assert first.given[0].latex == "T = 1"
    assert TEXT.split("\n")[first.line - 1] == 'id = "1"'
    assert second.formula is None
    assert second.latex == ""
    assert second.text == "It works well."
    assert TEXT.split("\n")[second.line - 1] == 'id = "2"'


def test_file_on_disk(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_bytes(TEXT.replace("\n", "\r\n").encode())
    assert read_claim_file(path).claims == read_claim_text(TEXT).claims


@pytest.mark.parametrize(
    ("text", "metre", "second"),
    [
        ("1", "0", "0"),
        ("m", "1", "0"),
        ("m s^-2", "1", "-2"),
        ("m^2/s", "2", "-1"),
        ("1/s", "0", "-1"),
        ("m/s rad", "1", "-1"),
        ("rad/s^2", "0", "-2"),
        ("m s^(-1/2)", "1", "-1/2"),
        ("s^-1/2", "0", "-1/2"),
        ("m/s^1/2", "1", "-1/2"),
        ("m^3/2/s^1/2 rad", "3/2", "-1/2"),
        ("m/s^(3/2)", "1", "-3/2"),
        ("m^2/1 s", "2", "-1"),
    ],
)
def test_units(text: str, metre: str, second: str) -> None:
    assert read_unit(text) == Unit(Fraction(metre), Fraction(second))


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("Hz", "1/s"),
        ("N", "kg m/s^2"),
        ("J", "N m"),
        ("W", "J/s"),
        ("V A", "W"),
        ("W/Hz", "J"),
        ("J/K", "kg m^2 s^-2 K^-1"),
        ("A^2 s", "A s A"),
        ("W^(1/2)", "kg^(1/2) m s^(-3/2)"),
        ("degree^2/s", "deg^2 rad Hz"),
        ("deg/s^(1/2)", "degrees s^-1/2"),
    ],
)
def test_units_by_other_names(text: str, other: str) -> None:
    assert read_unit(text) == read_unit(other) == read_unit(unit_text_of(read_unit(text)))


@pytest.mark.parametrize(
    "text",
    ["", " ", "km", "dB", "m/", "/s", "m^", "m^x", "m/2", "m^(1/0)", "m^99", "m**2", "m " * 9],
)
def test_no_units(text: str) -> None:
    with pytest.raises(ValueError, match=r".") as caught:
        read_unit(text)
    assert type(caught.value) is ValueError


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("km^2", r"m; 1 km is 1000 m"),
        ("m/ms", r"s; 1 ms is 1/1000 s"),
        ("km/h", r"m; 1 km is 1000 m"),
    ],
)
def test_a_multiple_of_a_unit_is_told_with_its_factor(text: str, instead: str) -> None:
    with pytest.raises(ValueError, match=f"is no unit: write {instead}"):
        read_unit(text)


def test_a_long_unit_is_refused_before_it_is_looked_at() -> None:
    with pytest.raises(ValueError, match="4000 characters"):
        read_unit("m^1/" * 1000)


def test_units_of_quantities() -> None:
    units = {name: quantity.unit for name, quantity in quantity_names().items()}
    assert units["filter_gain.2"] == Unit()
    assert units["predicted_state.3"] == Unit(Fraction(1), Fraction(-2))
    assert units["updated_covariance.1.2"] == Unit(Fraction(2), Fraction(-1))
