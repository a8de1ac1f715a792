"""Claim files with less ink: letters that need no entry, claims that are a formula alone."""

from __future__ import annotations

import time
from contextlib import suppress

import pytest
from claim_texts import MODELS

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.usual_letters import NOISE_ORDERS, filter_meanings, usual_letters
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = 'format = "gainproof claims 1"\n'
SOURCE = '[source]\ntitle = "made for this test"\n[settings.s]\ntitle = "s"\n'
ACCELERATION = 'kind = "steady_state"\nmodel = "random-acceleration"\n'
LINE = 'kind = "growing_memory"\ndegree = 1\n'
ANY = 'kind = "fixed_gain"\nstates = 2\ncovariance = "updated"\n'
USUAL = 'symbols = "usual"\n'


def text_of(setting: str, *formulas: str, table: str = USUAL) -> str:
    """A claim file with one setting, whose claims are formulas alone."""
    claims = ",\n".join(f"  '{formula}'" for formula in formulas)
    return f"{HEAD}claims = [\n{claims},\n]\n{SOURCE}{setting}{table}"


def judged(text: str) -> list[ClaimVerdict]:
    return list(judge_file(read_claim_text(text), MODELS))


def said(verdict: ClaimVerdict) -> tuple[object, ...]:
    """What a verdict says, without how the claim was named."""
    return verdict.verdict, verdict.domain, verdict.convention, verdict.reason, verdict.witness


@pytest.mark.parametrize("kind", ["steady_state", "growing_memory", "fixed_gain"])
@pytest.mark.parametrize("model", [None, *NOISE_ORDERS])
def test_letters_are_written_as_the_reader_writes_them_and_mean_what_ask_takes(
    kind: str, model: str | None
) -> None:
    found = usual_letters(kind, model)
    assert len(found) > 60
    for token, meaning in found.items():
        assert canonical_token(token) == token
        if meaning.quantity != "sample_number":
            assert filter_meanings([token])[token] == meaning


@pytest.mark.parametrize("kind", ["algebra", "matrices", "no kind"])
def test_without_a_filter_letters_mean_nothing(kind: str) -> None:
    assert not usual_letters(kind, None)


EXPLICIT = r"""
[settings.s.symbols]
'\alpha' = { quantity = "gain.1", meaning = "gain of the position" }
'\beta' = { quantity = "gain.2", meaning = "gain of the velocity" }
'\Lambda' = { quantity = "tracking_index", meaning = "tracking index" }
'T' = { quantity = "sampling_interval", meaning = "time between samples" }
'\sigma_v' = { quantity = "measurement_noise_deviation", meaning = "deviation" }
'P_{11}' = { quantity = "covariance.1.1", meaning = "variance" }
'P_{12}' = { quantity = "covariance.1.2", meaning = "covariance" }
'R' = { quantity = "measurement_noise_variance", meaning = "variance" }
'S' = { quantity = "innovation_variance", meaning = "variance" }
"""


@pytest.mark.alike
@pytest.mark.parametrize(
    "formula",
    [
        r"\beta = 2(2 - \alpha) - 4 \sqrt{1 - \alpha}",
        r"\beta = 2(2 - \alpha) + 4 \sqrt{1 - \alpha}",
        "P_12 = beta*R/(T*(1 - alpha))",
        r"\alpha = P_{11}/S",
        r"\Lambda^2 = \frac{\beta^2}{1 - \alpha}",
        r"\alpha \to 1 \quad (\Lambda \to \infty)",
        "alpha < 1/2 if Lambda < 1/4",
    ],
)
def test_a_usual_letter_is_judged_as_if_it_was_declared(formula: str) -> None:
    (usual,) = judged(text_of(ACCELERATION, formula))
    typed = formula.replace("P_12", "P_{12}").replace("alpha", r"\alpha").replace("beta", r"\beta")
    typed = typed.replace("Lambda", r"\Lambda")
    needed = [
        line
        for line in EXPLICIT.splitlines()
        if line.startswith("[") or line.partition("'")[2].partition("'")[0] in typed
    ]
    (declared,) = judged(text_of(ACCELERATION, formula, table="\n".join(needed)))
    assert said(usual) == said(declared)


def test_what_a_letter_means_does_not_depend_on_the_other_formulas() -> None:
    formulas = [
        r"\beta = 2(2 - \alpha) - 4 \sqrt{1 - \alpha}",
        r"\sigma_w^2 T^4 = \Lambda^2 \sigma_v^2",
        r"S = \frac{R}{1 - \alpha}",
        r"P_{12} = P_{21}",
    ]
    together = judged(text_of(ACCELERATION, *formulas))
    assert [one.verdict for one in together] == ["proved"] * 4
    for formula, one in zip(formulas, together, strict=True):
        (alone,) = judged(text_of(ACCELERATION, formula))
        assert alone.verdict == one.verdict


@pytest.mark.parametrize(
    ("model", "relation"),
    [
        ("random-velocity", r"\sigma_w T = \Lambda \sigma_v"),
        # Kalata, IEEE Transactions on Aerospace and Electronic Systems 20 (1984)
        ("random-acceleration", r"\frac{\sigma_w^2 T^4}{\sigma_v^2} = \frac{\beta^2}{1 - \alpha}"),
        ("random-acceleration", r"\sigma_a T^2 = \Lambda \sigma_n"),
        ("continuous-white-acceleration", r"q T^3 = \Lambda^2 R"),
        ("continuous-white-acceleration", r"\tilde{q} T^3 = \Lambda^2 \sigma_v^2"),
    ],
)
def test_the_strength_of_the_process_noise_is_that_of_the_model(model: str, relation: str) -> None:
    (verdict,) = judged(text_of(f'kind = "steady_state"\nmodel = "{model}"\n', relation))
    assert verdict.verdict == "proved"


@pytest.mark.parametrize(
    ("model", "token"),
    [("random-acceleration", "q"), ("continuous-white-acceleration", r"\sigma_w"), ("search", "q")],
)
def test_a_strength_that_the_model_does_not_have_is_no_letter(model: str, token: str) -> None:
    text = text_of(f'kind = "steady_state"\nmodel = "{model}"\n', rf"{token} T = \alpha")
    with pytest.raises(ClaimFileError, match="is not declared") as caught:
        read_claim_text(text)
    assert (caught.value.line, caught.value.column) == (3, 4)


def test_formulas_of_other_filters() -> None:
    line = judged(
        text_of(LINE, "alpha_k = 2(2k+1)/((k+1)(k+2))", "beta_k = 6/((k+1)(k+2)) if k >= 1")
    )
    assert [one.verdict for one in line] == ["proved", "proved"]
    ratio = r"P_{11} = \frac{2\alpha^2 + \beta(2 - 3\alpha)}{\alpha(4 - 2\alpha - \beta)} R"
    (fixed,) = judged(text_of(ANY, ratio))
    assert fixed.verdict == "proved"


def test_what_the_file_declares_wins() -> None:
    own = "[settings.s.symbols]\n"
    own += "'\\lambda' = { unit = '1', domain = '\\lambda > 1', meaning = 'x' }\n"
    text = text_of(ACCELERATION, r"\lambda \alpha > \alpha", table=own)
    text = text.replace(HEAD, HEAD + USUAL)
    assert [one.verdict for one in judged(text)] == ["proved"]
    (index,) = judged(text.replace(own, ""))
    assert index.verdict == "conditional"


def test_the_setting_keeps_the_letters_that_are_used_alone() -> None:
    text = text_of(ACCELERATION, r"\beta > 0", r"\sigma_w T^2 > 0")
    symbols = read_claim_text(text).settings["s"].symbols
    assert set(symbols) == {"\\beta", "\\sigma_w", "T", "\\Lambda", "\\sigma_v"}
    gains = read_claim_text(text_of(ACCELERATION, "R > 0")).settings["s"]
    assert (gains.gain, gains.covariance) == ("filter", "predicted")


@pytest.mark.parametrize(
    ("formula", "column", "nearest"),
    [
        (r"\beta = \alpha_1 + \alpha", 12, r"\alpha"),
        (r"\Lambda = \sigma_p T", 14, r"\sigma_"),
        ("alpha + z = 1", 12, ""),
    ],
)
def test_a_letter_that_is_not_in_the_table_is_told_with_its_place(
    formula: str, column: int, nearest: str
) -> None:
    with pytest.raises(ClaimFileError, match="is not declared") as caught:
        read_claim_text(text_of(LINE if nearest == r"\alpha" else ACCELERATION, "R > 0", formula))
    error = caught.value
    assert (error.line, error.column) == (4, column)
    assert str(error).splitlines()[-1].strip() == "^"
    assert not nearest or error.nearest[0].startswith(nearest)


@pytest.mark.parametrize(
    ("formulas", "both"),
    [
        ((r"K_2 = \frac{\beta}{T}",), r"K_2|\\beta"),
        (
            (r"\beta < 1", "K_2 > 0"),
            r"K_2 and \\beta of claim 1 would both be the gain of the velocity",
        ),
        ((r"\sigma_v = \sigma_n",), r"would both be the deviation of the measured position"),
        (("T_s > 0", "T > 0"), "T and T_s of claim 1"),
        ((r"\sigma_w > \sigma_a",), "would both be the deviation of the process noise"),
        ((r"M_{12} = \tilde{P}_{12}",), "predicted covariance"),
    ],
)
def test_two_usual_letters_of_one_meaning_are_refused(formulas: tuple[str, ...], both: str) -> None:
    with pytest.raises(ClaimFileError, match=both):
        read_claim_text(text_of(ACCELERATION, *formulas))


def test_symbols_that_the_file_declares_are_its_own_affair() -> None:
    own = "[settings.s.symbols]\n"
    for name in ("\\beta", "K_2"):
        own += f"'{name}' = {{ quantity = 'gain.2', meaning = 'x' }}\n"
    text = text_of(ACCELERATION, r"\beta = K_2", table=own).replace(HEAD, HEAD + USUAL)
    assert [one.verdict for one in judged(text)] == ["proved"]
    unused = read_claim_text(text.replace(r"\beta = K_2", "R > 0")).settings["s"].symbols
    assert set(unused) == {"\\beta", "K_2", "R"}


def test_a_declared_symbol_beside_the_usual_letter_of_its_meaning_is_refused() -> None:
    own = '[settings.s.symbols]\n\'D\' = { quantity = "sampling_interval", meaning = "x" }\n'
    text = text_of(ACCELERATION, "D > 0", table=own).replace(HEAD, HEAD + USUAL)
    assert [one.verdict for one in judged(text)] == ["proved"]
    with pytest.raises(ClaimFileError, match=r"(T and D|D and T) would both be"):
        read_claim_text(text.replace("D > 0", "D = 2T"))


@pytest.mark.parametrize(("wrong", "problem"), [
    (text_of('kind = "algebra"\n', "1 = 1"), "a setting of kind algebra has no usual letters"),
    (text_of(ACCELERATION, "R > 0", table='symbols = "unusual"\n'), "a table of symbols is wanted"),
    (text_of(ACCELERATION, "R > 0") + '[settings.t]\ntitle = "t"\nkind = "algebra"\n',
     "formulas alone are claims of one setting"),
])  # fmt: skip
def test_what_cannot_be_usual_is_told(wrong: str, problem: str) -> None:
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(wrong)
    assert any(problem in str(one) for one in (caught.value, *caught.value.others))


def test_formulas_alone_have_running_ids_and_the_kind_that_they_say() -> None:
    formulas = {
        r"\alpha^2 = R/R": ("identity", "latex"),
        "alpha > 0": ("inequality", "plain"),
        r"\alpha \to 0 \quad (\Lambda \to 0)": ("limit", "latex"),
        "alpha ~= 0.75 if Lambda = 1": ("value", "plain"),
        "alpha > 1 <=> R < 0": ("equivalence", "plain"),
        r"\alpha > 1 \Rightarrow R < 0": ("implication", "latex"),
        "R^{2} > 0": ("inequality", "latex"),
    }
    claims = read_claim_text(text_of(ACCELERATION, *formulas)).claims
    assert [one.id for one in claims] == [str(n) for n in range(1, len(formulas) + 1)]
    found = [(one.kind, "latex" if one.plain is None else "plain") for one in claims]
    assert found == list(formulas.values())
    assert [one.line for one in claims] == list(range(3, 3 + len(formulas)))


def test_tables_may_stand_among_formulas() -> None:
    table = '{ id = "x", place = "p", kind = "identity", setting = "s", plain = "R = R" }'
    text = text_of(ACCELERATION, "R > 0", "S > 0").replace("'S > 0'", f"{table}, 'S > 0'")
    assert [one.id for one in read_claim_text(text).claims] == ["1", "x", "3"]


def test_a_table_still_says_what_is_claimed() -> None:
    with pytest.raises(ClaimFileError, match="kind: this field is missing"):
        read_claim_text(
            f"{HEAD}{SOURCE}{ACCELERATION}{USUAL}[[claims]]\nid = '1'\nplace = 'p'\n"
            "setting = 's'\nlatex = 'R > 0'\n"
        )


def test_a_formula_alone_of_matrices() -> None:
    setting = 'kind = "matrices"\nsizes = ["n"]\n[settings.s.symbols]\n'
    letter = "'A' = { shape = ['n', 'n'], meaning = 'a matrix' }\n"
    text = text_of(setting, "A^T + A = A + A^T", "A A = A", table=letter)
    assert [one.verdict for one in judged(text)] == ["proved", "refuted"]


FILTERS = "".join(f'[settings.s{n}]\ntitle = "s"\n{ACCELERATION}{USUAL}' for n in range(100))
BLANK = "\n" * 300_000
ESCAPED = ",\n".join([r'"a +\tb = 1"'] * 2000)
TITLE = '[source]\ntitle = "t"\n'
HOSTILE = {
    "letters": text_of(ACCELERATION, *[f"x_{n} + y_{n} = z" for n in range(2000)]),
    "runs": text_of(ACCELERATION, *["Tdtt_s" * 600 + " = 2"] * 250),
    "equal": text_of(ACCELERATION, *[r"\beta = \alpha"] * 2000),
    "marks": text_of(ACCELERATION, *[r"\tilde" * 600 + " q = 2"] * 50),
    "lines": text_of(ACCELERATION, *["''\n\n\\alpha = x''"] * 1000).replace("],", f"{BLANK}],"),
    "not found": f"{HEAD}claims = [{ESCAPED}{BLANK}]\n{SOURCE}{ACCELERATION}{USUAL}",
    "settings": f"{HEAD}{TITLE}{FILTERS}"
    + "".join(
        f"[[claims]]\nid = '{n}'\nplace = 'p'\nkind = 'identity'\nsetting = 's{n % 100}'\n"
        f"latex = '\\beta = x'\n"
        for n in range(2000)
    ),
}  # fmt: skip


@pytest.mark.alike
@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_files_are_read_or_refused_soon(name: str) -> None:
    started = time.process_time()
    with suppress(ClaimFileError):
        read_claim_text(HOSTILE[name])
    assert time.process_time() - started < 4
