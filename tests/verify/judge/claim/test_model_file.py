"""Model files: read by the reader of claim files, units and shapes held together, nothing guessed;
and their matrices at values of the symbols.
"""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.model_file import read_model_text
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.setting.model_numbers import NoNumberError, model_at

CLOCK = r"""
format = "gainproof model 1"
title = "a clock against a reference"
transition = [[1, "T"], [0, 1]]
process_noise = [["q_1 T + q_2 T^3/3", "q_2 T^2/2"], ["q_2 T^2/2", "q_2 T"]]
measurement = [[1, 0]]
measurement_noise = [['\sigma^2']]
states = { phase = "s", frequency = "1" }
measurements = { offset = "s" }

[symbols]
'T' = { unit = "s", domain = 'T > 0', meaning = "interval" }
'q_1' = { unit = "s", domain = 'q_1 > 0', meaning = "white noise of the frequency" }
'q_2' = { unit = "s^-1", domain = 'q_2 > 0', meaning = "its random walk" }
'\sigma' = { unit = "s", domain = '\sigma > 0', meaning = "deviation of a measured phase" }
"""
VALUES = {
    "T": Fraction(2),
    "q_1": Fraction("1e-22"),
    "q_2": Fraction("3e-28"),
    r"\sigma": Fraction("1e-9"),
}


def test_a_clock_in_numbers() -> None:
    found, _ = model_at(read_model_text(CLOCK), VALUES)
    assert found.f.c == [[1, 2], [0, 1]]
    assert found.q.c[0] == [Fraction("2e-22") + Fraction("8e-28"), Fraction("6e-28")]
    assert found.r.c == [[Fraction("1e-18")]]
    assert found.s.c == [[0], [0]]
    assert found.names == (("phase", "frequency"), ("offset",))
    assert found.is_exact


PLAIN = """
format = "gainproof model 1"
title = "numbers"
transition = [{f}]
process_noise = [[{q}]]
measurement = [[1]]
measurement_noise = [[1]]
"""


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.1", "1/10"),
        ("-3", "-3"),
        ("1e-22", "1e-22"),
        ('"1e-22"', "1e-22"),
        ('"2.5E3"', "2500"),
        ('"1/3"', "1/3"),
        (r"'\frac{1}{3} - 0.1'", "7/30"),
        ("1_000.5", "1000.5"),
    ],
)
def test_numbers_are_taken_as_they_are_printed(text: str, value: str) -> None:
    found, _ = model_at(read_model_text(PLAIN.format(f=f"[{text}]", q="1")), {})
    assert found.f.c == [[Fraction(value)]]


@pytest.mark.parametrize(
    "text", ["nan", "inf", "true", "1e999", '"1e999"', "1979-05-27", "[1]", '"x"']
)
def test_what_is_no_number_and_no_formula_is_refused(text: str) -> None:
    with pytest.raises(ClaimFileError, match="transition"):
        read_model_text(PLAIN.format(f=f"[{text}]", q="1"))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("gainproof model 1", "gainproof claims 1", "wanted 'gainproof model 1'"),
        ("measurement_noise = [['\\sigma^2']]\n", "", "measurement_noise: this matrix is missing"),
        ("transition = [[1,", "transitoin = [[1,", "the nearest is transition"),
        ("[[1, 0]]", "[[1, 0, 0]]", "measurement: wanted 1 by 2, but it is 1 by 3"),
        ('"q_2 T^2/2"], ["q_2 T^2/2"', '"q_2 T"], ["q_2 T^2/2"', "row 1, column 2 has the unit 1"),
        ('[0, 1]]', '[0, "T"]]', "transition: row 2, column 2 has the unit s, wanted is 1"),
        ("q_1 T +", "q_1 +", "process_noise: row 1, column 1"),
        ('"q_2 T"]', '"q_3 T"]', "the nearest declared name is q_"),
        ('"s", frequency', '"seconds", frequency', "states: phase: 'seconds'"),
        ('{ offset = "s" }', "{}", "measurements: a table of 1 names"),
        ('unit = "s^-1"', 'unit = "ms"', "1/1000 s"),
        ("measurements =", 'cross_noise = [["0"]]\nmeasurements =', "cross_noise: wanted 2 by 1"),
        ("measurements =", 'start = [["T"]]\nmeasurements =', "start: wanted 2 by 2"),
        ("'T > 0'", "'S > 0'", "S"),
    ],
)  # fmt: skip
def test_a_mistake_is_told_with_its_place(old: str, new: str, words: str) -> None:
    assert old in CLOCK
    with pytest.raises(ClaimFileError) as raised:
        read_model_text(CLOCK.replace(old, new, 1), "clock.toml")
    told = "\n".join(str(each) for each in (raised.value, *raised.value.others))
    assert words in told
    assert told.startswith("clock.toml")


def test_noises_in_numbers_are_covariances() -> None:
    text = PLAIN.format(f="[1, 0], [0, 1]", q="1, 2], [3, 9")
    text = text.replace("measurement = [[1]]", "measurement = [[1, 0]]")
    with pytest.raises(ClaimFileError, match="row 1, column 2 is 2, and the other way 3"):
        read_model_text(text)
    with pytest.raises(ClaimFileError, match="positive semidefinite"):
        read_model_text(text.replace("[3, 9", "[2, 3"))


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({}, "T has no value"),
        (VALUES | {"T": Fraction(0)}, "T is outside of its domain, T > 0"),
        (VALUES | {"x": Fraction(0)}, "x is no free symbol"),
    ],
)
def test_values_that_do_not_fit_are_refused(values: dict[str, Fraction], words: str) -> None:
    with pytest.raises(NoNumberError, match=words):
        model_at(read_model_text(CLOCK), values)


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        (r"\exp(10^{12})", r"about 2\^14426950408\d\d"),
        (r"\exp(-10^{12})", r"about 2\^-14426950408\d\d"),
        ("((((2^{64})^{64})^{64})^{64})^{64}", r"about 2\^10737418\d\d"),
    ],
)
def test_of_a_number_that_fills_a_memory_the_size_is_told(entry: str, words: str) -> None:
    text = PLAIN.format(f="[1]", q=f"'{entry}'")
    with pytest.raises(NoNumberError, match=words):
        model_at(read_model_text(text), {})


@pytest.mark.parametrize(
    "entry",
    [
        r"2 + \exp(-10^{12}) - \exp(-10^{12})",
        r"2 + \exp(-10^{12}) (\sqrt{2} - \sqrt{3})",
        r"2 + \exp(-10^{12}) + \sqrt{2} - \sqrt{2}",
    ],
)
def test_terms_that_are_far_below_the_others_are_rounded(entry: str) -> None:
    found, _ = model_at(read_model_text(PLAIN.format(f="[1]", q=f"'{entry}'")), {})
    centre, radius = found.q.c[0][0], found.q.radius[0][0]
    assert abs(centre - 2) <= radius < Fraction("1e-60")
    assert radius > 0 or "exp(-10^{12}) - " in entry


SINGER = r"""
format = "gainproof model 1"
title = "exponentially correlated velocity"
transition = [["1", '\tau (1 - e)'], ["0", "e"]]
process_noise = [
  ['\sigma^2 \tau^2 (2 T/\tau - 3 + 4 e - e^2)', '\sigma^2 \tau (1 - e)^2'],
  ['\sigma^2 \tau (e - 1)^2', '\sigma^2 (1 - e^2)'],
]
measurement = [[1, 0]]
measurement_noise = [["1/n"]]
states = { position = "m", velocity = "m/s" }

[symbols]
'T' = { quantity = "sampling_interval", domain = 'T > 0', meaning = "interval" }
'\tau' = { unit = "s", domain = '\tau > 0', meaning = "time constant" }
'\sigma' = { unit = "m/s", meaning = "deviation of the velocity" }
'e' = { definition = '\exp(-T/\tau)', meaning = "decay" }
'n' = { unit = "m^-2", integer = true, domain = 'n > 0', meaning = "number of looks" }
"""


def test_entries_that_are_not_rational_come_as_boxes() -> None:
    values = {"T": Fraction(1), r"\tau": Fraction(3), r"\sigma": Fraction(2), "n": Fraction(4)}
    found, _ = model_at(read_model_text(SINGER), values)
    with mpmath.workdps(60):
        e = mpmath.exp(-mpmath.mpf(1) / 3)
        true = {
            (0, 0): 36 * (mpmath.mpf(2) / 3 - 3 + 4 * e - e * e),
            (1, 0): 12 * (1 - e) ** 2,
            (1, 1): 4 * (1 - e * e),
        }
        for (i, j), value in true.items():
            c, r = found.q.c[i][j], found.q.radius[i][j]
            assert abs(mpmath.mpf(c.numerator) / c.denominator - value) < 1e-55
            assert 0 < r < Fraction(1, 10**60)
    assert found.q.c[0][1] == found.q.c[1][0]
    assert found.f.radius[0][0] == 0
    assert found.r.c == [[Fraction(1, 4)]]
    with pytest.raises(NoNumberError, match="whole number"):
        model_at(read_model_text(SINGER), values | {"n": Fraction(1, 2)})


def test_what_is_zero_or_very_large_beside_an_exponential() -> None:
    values = {"T": Fraction(1), r"\tau": Fraction(3), r"\sigma": Fraction(0), "n": Fraction(4)}
    assert model_at(read_model_text(SINGER), values)[0].q.c == [[0, 0], [0, 0]]
    assert model_at(read_model_text(SINGER), values)[0].q.r is None
    text = SINGER.replace(r"\exp(-T/\tau)", r"\exp(T/\tau)")
    with pytest.raises(NoNumberError, match="row 1, column 2: a number of about 2\\^"):
        model_at(read_model_text(text), values | {r"\tau": Fraction(1, 10**4)})


def test_a_division_by_zero_is_told_with_its_entry() -> None:
    text = CLOCK.replace("'T > 0'", r"'T \geq 0'").replace('"q_2 T"]', '"q_2 T^2/T"]')
    with pytest.raises(NoNumberError, match="process_noise, row 2, column 2"):
        model_at(read_model_text(text), VALUES | {"T": Fraction(0)})


CLAIMS = """
format = "gainproof claims 1"
[source]
title = "numbers as they are printed"
[settings.s]
title = "one filter"
kind = "steady_state"
transition = {f}
process_noise = [["0.25", "1/2"], ["1/2", "1"]]
measurement = [["1", "0"]]
measurement_noise = {r}
[settings.s.symbols]
'K_1' = {{ quantity = "filter_gain.1", meaning = "gain of the position" }}
[[claims]]
id = "1"
place = "equation (1)"
kind = "identity"
setting = "s"
latex = 'K_1 = \\frac{{3}}{{4}}'
"""


def test_settings_of_claim_files_take_numbers_too() -> None:
    texts = (
        CLAIMS.format(f='[["1", "1"], ["0", "1"]]', r='[["1/10"]]'),
        CLAIMS.format(f="[[1, 1], [0, 1]]", r="[[0.1]]"),
        CLAIMS.format(f="[[1.0, 1], [0, 1e0]]", r='[["1e-1"]]'),
    )
    for text in texts:
        own = read_claim_text(text).settings["s"].own_model
        assert own is not None
        values = [[constant_value(read_graph(x)) for x in row] for row in own.transition]
        assert values == [[1, 1], [0, 1]]
        assert constant_value(read_graph(own.measurement_noise[0][0])) == Fraction(1, 10)
