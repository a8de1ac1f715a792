"""Dimensions are compared wherever something is added, compared, put in or taken as an argument;
what a file declares itself may not contradict them.
"""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file

HEAD = r"""
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[symbols]
'T' = { quantity = "sampling_interval", meaning = "interval" }
'd' = { unit = "m", domain = 'd > 0', meaning = "length" }
's' = { unit = "m", meaning = "another length" }
'v' = { unit = "m s^-1", meaning = "velocity" }
'b' = { unit = "1", domain = 'b > 0', meaning = "a number" }
'z' = { unit = "1", meaning = "a number" }
'i' = { unit = "1", integer = true, meaning = "index" }
'R' = { definition = 'd^2 + s', meaning = "length and area" }
'f' = { arguments = ['s'], definition = 's^2', meaning = "square of a length" }
'g' = { arguments = ['s'], definition = 's + 1', meaning = "length and number" }
'x' = { definition = '\begin{pmatrix} s \\ v \end{pmatrix}', shape = [2, 1], meaning = "state" }
'y' = { definition = '\begin{pmatrix} v \\ s \end{pmatrix}', shape = [2, 1], meaning = "turned" }
'F' = { definition = '\begin{pmatrix} 1 & T \\ 0 & 1 \end{pmatrix}', shape = [2, 2], meaning = "F" }
'G' = { definition = '\begin{pmatrix} 1 & 1 \\ 0 & 1 \end{pmatrix}', shape = [2, 2], meaning = "G" }
'S' = { definition = '\begin{pmatrix} 1 & T \\ T & 1 \end{pmatrix}', shape = [2, 2], meaning = "S" }
'L' = { unit = "m", shape = [2, 1], meaning = "two lengths" }
[settings.a]
title = "a"
kind = "algebra"
[settings.loop]
title = "loop"
kind = "fixed_gain"
states = 2
[settings.loop.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain" }
'P' = { quantity = "updated_covariance.1.1", meaning = "variance" }
'V' = { quantity = "updated_covariance.2.2", meaning = "variance of the velocity" }
"""


def judged(more: str, head: str = HEAD) -> tuple[str, str | None]:
    """Verdict and method of one claim."""
    text = f"{head}[[claims]]\nid = 'c'\nplace = 'p'\n"
    if "setting" not in more:
        text += "setting = 'a'\n"
    (verdict,) = judge_file(read_claim_text(text + more), ())
    return verdict.verdict, verdict.method


def claim(kind: str, latex: str) -> str:
    return f"kind = '{kind}'\nlatex = '{latex}'\n"


def trend(subject: str, about: str = "d") -> str:
    return f"kind = 'monotone'\nabout = ['{subject}', '{about}']\ntrend = 'increasing'\n"


MIXED = {
    "a definition": claim("identity", "R = R"),
    "a definition, opened": claim("identity", "R - d^2 = s"),
    "what changes": trend("d^2 + d"),
    "what changes, by a definition": trend("R"),
    "vectors": claim("identity", "x + y = y + x"),
    "sides of vectors": claim("identity", r"x - x = y - y"),
    "a matrix times a vector": claim("identity", "G x - G x = 0"),
    "entries": claim("identity", r"\begin{pmatrix} s \\ s \end{pmatrix} = x"),
    "products of a determinant": claim("identity", r"\det(S) = 1 - T^2"),
    "an inverse": claim("identity", "S S^{-1} = F F^{-1}"),
    "a trace": claim("identity", r"\operatorname{tr}(x x^T) = s^2 + v^2"),
    "an argument of a function": claim("identity", r"\sin^2 d + \cos^2 d = 1"),
    "an argument of an exponential": claim("identity", r"e^d e^{-d} = 1"),
    "an exponent": claim("identity", "b^d b^{-d} = 1"),
    "an argument of a logarithm": claim("identity", r"\log d = \log d"),
    "an argument of a declared function": claim("identity", "f(v) = v^2"),
    "the body of a declared function": claim("identity", "g(s) = s + 1"),
    "the end of a limit": claim("limit", r"\lim_{d \to 1} d^2 = 1"),
    "the place of a derivative": claim("identity", r"\left. d^2 \right|_{d=b} = b^2"),
    "bounds of an integral": claim("identity", r"\int_0^b s \mathrm{d}s = \frac{b^2}{2}"),
    "bounds of a sum": claim("identity", r"\sum_{i=1}^{2} d i = 3 d + s^2"),
    "a hypothesis": claim("identity", "s = s") + "given = ['d = d^2']\n",
    "a polynomial": "kind = 'location'\npolynomial = 'z^2 + d z'\nvariable = 'z'\nwhere = 'real'\n",
    "what is made least": (
        r"setting = 'loop'" + "\nkind = 'optimum'\n" + r"latex = '\beta = \alpha^2'" + "\n"
        "minimised = 'P + V'\n" + r"fixed = ['\frac{1 - \alpha}{\beta}']" + "\n"
    ),
    "what is fixed": (
        r"setting = 'loop'" + "\nkind = 'optimum'\n" + r"latex = '\beta = \alpha^2'" + "\n"
        "minimised = 'P'\n" + r"fixed = ['T + \frac{1 - \alpha}{\beta}']" + "\n"
    ),
}


@pytest.mark.alike
@pytest.mark.parametrize("more", MIXED.values(), ids=MIXED)
def test_what_mixes_dimensions_is_refuted_for_it(more: str) -> None:
    assert judged(more) == ("refuted", "dimensions")


MATRIX, END = r"\begin{pmatrix}", r"\end{pmatrix}"
SOUND = {
    "a matrix times a vector": claim("identity", rf"F x = {MATRIX}s + v T \\ v{END}"),
    "a square of a matrix": claim("identity", rf"F^2 = {MATRIX}1 & 2T \\ 0 & 1{END}"),
    "an inverse": claim("identity", rf"F F^{{-1}} = {MATRIX}1 & 0 \\ 0 & 1{END}"),
    "a covariance": claim("identity", rf"x^T {MATRIX}1/d^2 & 0 \\ 0 & 0{END} x = s^2/d^2"),
    "lengths": claim("identity", r"L^T L - L^T L = d^2 - d^2"),
    "a declared function": claim("identity", "f(d) = d^2"),
    "an argument without dimension": claim("identity", r"\sin^2(d/b/d) + \cos^2(1/b) = 1"),
    "what changes": trend("d^2 + d s^2/s"),
    "an integral": claim("identity", r"\int_0^d s \mathrm{d}s = \frac{d^2}{2}"),
    "a limit": claim("limit", r"\lim_{d \to 0} \frac{d^2 + d s}{d} = s"),
}  # fmt: skip


@pytest.mark.parametrize("more", SOUND.values(), ids=SOUND)
def test_what_agrees_is_judged_on(more: str) -> None:
    verdict, method = judged(more)
    assert method != "dimensions"
    assert verdict in ("proved", "conditional", "undecided")


def test_the_definition_at_fault_is_named() -> None:
    text = f"{HEAD}[[claims]]\nid = 'c'\nplace = 'p'\nsetting = 'a'\n{claim('identity', 'R = R')}"
    (verdict,) = judge_file(read_claim_text(text), ())
    assert verdict.reason.startswith(
        "dimensions: in the definition of R the terms of a sum have dimensions m^2 and m"
    )


OWN = r"""
[settings.own]
title = "own"
kind = "steady_state"
transition = [["1", "TRANSITION"], ["0", "1"]]
process_noise = [['q^2 T^4/4', 'q^2 T^3/2'], ['q^2 T^3/2', 'NOISE']]
measurement = [["1", "0"]]
measurement_noise = [['\sigma^2']]
[settings.own.symbols]
'q' = { unit = "m s^-2", domain = 'q > 0', meaning = "deviation" }
'\sigma' = { quantity = "measurement_noise_deviation", meaning = "deviation" }
"""
DECLARED = {
    "domain": (HEAD.replace("'d > 0'", "'d > 1'"), "symbols.d.domain: dimensions: the sides"),
    "unit and definition": (
        HEAD.replace("'d^2 + s', ", "'d^2 + s^2', unit = \"m\", "),
        "symbols.R.definition: dimensions: the unit and the definition",
    ),
    "variance": (
        HEAD.replace("'v' = { unit", "'v' = { variance = 's^2', unit"),
        "symbols.v.variance: dimensions: the square of v and its variance",
    ),
    "transition": (
        HEAD + OWN.replace("TRANSITION", "T^2").replace("NOISE", "q^2 T^2"),
        "settings.own.process_noise: dimensions: the entry in row 1, column 2",
    ),
    "noise": (
        HEAD + OWN.replace("TRANSITION", "T").replace("NOISE", "q^2 T^3"),
        "settings.own.process_noise: dimensions: the entry in row 2, column 2",
    ),
}


@pytest.mark.parametrize(("head", "said"), DECLARED.values(), ids=DECLARED)
def test_a_file_that_contradicts_its_own_units_is_refused(head: str, said: str) -> None:
    with pytest.raises(ClaimFileError) as refused:
        judged(claim("identity", "s = s"), head)
    assert said in str(refused.value)


def test_the_domain_of_a_claim_has_the_unit_of_its_symbol() -> None:
    with pytest.raises(ClaimFileError, match="domain: dimensions: the sides have dimensions"):
        judged(claim("identity", "s = s") + "domain = 's > 1'\n")


def test_a_sound_model_is_read() -> None:
    whole = HEAD + OWN.replace("TRANSITION", "T").replace("NOISE", "q^2 T^2")
    assert judged(claim("identity", "s = s"), whole)[0] == "proved"
