"""Claim files drafted from LaTeX: which equations, numbers and symbols; and hostile text."""

from __future__ import annotations

import time
import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from samples import samples

from gainproof.claims.draft import draft
from gainproof.claims.symbols_met import symbols_met
from gainproof.claims.tex_rows import Equation, equations
from gainproof.claims.tex_text import argument_of, without_comments
from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text

PAPER = r"""
\documentclass{article}
\newcommand{\trap}[1]{\begin{equation} #1 \end{equation}}
\title{Gains of
  filters \\ in practice}
\author{A. Reader \and B. Other}
\begin{document}
% \begin{equation} not = this \end{equation}
It costs 5\% more, \[ 0 < \alpha < 1. \]
\begin{equation}\label{eq:gain}
  \beta = \frac{\alpha^2}{2 - \alpha},
\end{equation}
\begin{align}
  x_{pk} &= x_{sk-1} + T \dot{x}_{sk-1} \nonumber \\[2pt]
  a &= kT, \\
  b &= c \tag{A5} \\
    &= d
\end{align}
\begin{subequations}
\begin{gather}
  p = q \\
  q = p
\end{gather}
\end{subequations}
\begin{verbatim}
\begin{equation} nor = this \end{equation}
\end{verbatim}
$$ \lambda = \macro{3} $$
\begin{equation*} e = f \end{equation*}
\end{document}
"""


def found(text: str) -> list[Equation]:
    return list(equations(without_comments(text)))


def test_equations_of_a_paper() -> None:
    assert [(e.number, e.latex) for e in found(PAPER)] == [
        (None, r"0 < \alpha < 1"),
        ("1", r"\beta = \frac{\alpha^2}{2 - \alpha}"),
        (None, r"x_{pk} = x_{sk-1} + T \dot{x}_{sk-1}"),
        ("2", "a = kT"),
        ("A5", "b = c = d"),
        ("3a", "p = q"),
        ("3b", "q = p"),
        (None, r"\lambda = \macro{3}"),
        (None, "e = f"),
    ]


def test_labels_and_lines() -> None:
    equation = found(PAPER)[1]
    assert equation.label == "eq:gain"
    lines = PAPER.split("\n")
    assert "eq:gain" in lines[equation.line - 1]
    assert all(e.latex[:5] in lines[e.line - 1].replace("&", "") for e in found(PAPER)[7:])


@pytest.mark.parametrize(
    ("text", "latex"),
    [
        (r"\[ a = \begin{matrix} b & c \\ d & e \end{matrix} \]", None),
        (r"\begin{multline} a = b \\ + c \end{multline}", "a = b + c"),
        (r"\begin{align} a &= b \\ &\quad + c \end{align}", None),
        (r"\begin{alignat}{2} a &= b \end{alignat}", "a = b"),
        (r"\begin{eqnarray} a &=& b \end{eqnarray}", "a = b"),
        (r"\begin{align} a &= \{b \\ c\} \end{align}", None),
        (r"line break \\[ a = b ] \[ c = d \]", "c = d"),
        (r"100\% \[ a = b \] % \[ c = d \]", "a = b"),
        (r"\\% \[ c = d \]" + "\n" + r"\[ a = b \]", "a = b"),
        (r"\[ a = b", None),
        (r"\begin{equation} a = b \end{align}", None),
        ("$$ a = b", None),
    ],
)
def test_displays(text: str, latex: str | None) -> None:
    assert latex is None or [e.latex.replace("  ", " ") for e in found(text)] == [latex]


def test_rows_of_matrices_stay_together() -> None:
    (equation,) = found(r"\begin{align} a &= \begin{matrix} b \\ c \end{matrix} \end{align}")
    assert equation.latex == r"a = \begin{matrix} b \\ c \end{matrix}"


def test_symbols_are_those_that_the_reader_asks_for() -> None:
    met = symbols_met(r"\dot{x}_{sk} = kT_s + \sqrt{\sigma_w'}")
    assert met.symbols == (r"\dot{x}_{sk}", "k", "T_s", r"\sigma_w'") or met.formula is not None
    assert "T_s" in met.symbols
    assert "k" in met.symbols
    assert symbols_met(r"a = \macro").formula is None
    assert "\\macro" in symbols_met(r"a = \macro").problem


def test_the_draft_of_a_paper() -> None:
    made = draft(PAPER, "paper.tex", "paper")
    assert (made.equations, made.unread) == (9, 1)
    data = tomllib.loads(made.text)
    assert data["source"]["title"] == "Gains of filters in practice"
    assert data["source"]["authors"] == ["A. Reader", "B. Other"]
    assert [claim["id"] for claim in data["claims"]] == [
        "line-9", "1", "line-14", "2", "A5", "3a", "3b", "line-29"
    ]  # fmt: skip
    assert data["claims"][0]["kind"] == "inequality"
    assert "\\macro is not known" in made.text
    assert "\\beta" in data["settings"]["main"]["symbols"]


@pytest.mark.parametrize(
    ("formula", "kind"),
    [(r"a \approx 0.38", "value"), (r"0.38 \approx a", "value"), (r"a \approx b", "identity")],
)
def test_a_rounded_number_is_a_value(formula: str, kind: str) -> None:
    made = tomllib.loads(draft(rf"\[ {formula} \]", "a.tex", "a").text)
    assert made["claims"][0]["kind"] == kind


def test_thanks_are_no_part_of_a_title() -> None:
    text = draft(r"\title{Gains\thanks{Grant \emph{7}} of filters}", "a.tex", "a").text
    assert tomllib.loads(text)["source"]["title"] == "Gains of filters"


def test_a_draft_is_refused_until_everything_is_said() -> None:
    text = draft(PAPER, "paper.tex", "paper").text
    with pytest.raises(ClaimFileError, match=r"line \d+: source\.publication: still marked TODO"):
        read_claim_text(text)
    said = text.replace('kind = "TODO"', 'kind = "algebra"')
    said = said.replace('unit = "TODO"', 'unit = "1"').replace('"TODO"', '"said"')
    assert len(read_claim_text(said).claims) == 8


def test_a_paper_without_equations() -> None:
    made = draft("no mathematics", "a.tex", "a")
    assert made.equations == 0
    assert tomllib.loads(made.text)["source"]["title"] == "TODO"


def test_ids_are_unique_and_plain() -> None:
    text = r"\begin{align} a &= b \tag{1'} \\ c &= d \tag{2} \\ e &= f \tag{2} \end{align}"
    ids = [claim["id"] for claim in tomllib.loads(draft(text, "a.tex", "a").text)["claims"]]
    assert ids == ["line-1", "2", "2-2"]


@pytest.mark.alike
@pytest.mark.parametrize(
    "text",
    [
        "\\begin{equation}" * 5000,
        "\\begin{align}" + "\\\\" * 20_000 + "\\end{align}",
        "\\[" + "\\label{" * 20_000 + "\\]",
        "\\title{" * 20_000,
        "\\%" * 100_000,
        "$$" * 50_001,
        "\\[ a = b \\]" * 1500,
        "\\[" + "\\dot" * 20_000 + "\\]",
        "\\[ " + "a_{" * 1000 + " \\]",
        "\\[ ab\u202ecd = \u0430 \\]",
    ],
)
def test_hostile_texts_leave_a_readable_draft(text: str) -> None:
    made = draft(text, "bad\u202e\n.tex", "bad'\n\u202e")
    assert tomllib.loads(made.text)
    assert "\u202e" not in made.text


PIECES = (
    "\\begin{equation}", "\\end{equation}", "\\begin{align}", "\\end{align}", "\\[", "\\]", "$$",
    "\\\\", "&", "{", "}", "%", "\n", "\\label{x}", "\\tag{1}", "\\nonumber", "a", "=", "b'", "\\",
    "\\frac", "_", "^", "\\title{", "\\begin{subequations}", "\\end{subequations}", '"', "'''", "é",
)  # fmt: skip


@settings(max_examples=samples(120), deadline=None)
@given(st.lists(st.sampled_from(PIECES), max_size=60))
def test_any_text_leaves_a_readable_draft(pieces: list[str]) -> None:
    data = tomllib.loads(draft("".join(pieces), "a.tex", "a").text)
    ids = [claim["id"] for claim in data.get("claims", [])]
    assert len(ids) == len(set(ids))


def test_arguments() -> None:
    assert argument_of(r"\title{a {b} c} \title{d}", "\\title") == "a {b} c"
    assert argument_of(r"\title{a", "\\title") is None
    assert argument_of(r"\titlepage", "\\title") is None


@pytest.mark.parametrize(
    ("definitions", "printed", "put_in"),
    [
        (r"\newcommand{\sw}{\sigma_w}", r"q = \sw^2 T", r"q = \sigma_w^2 T"),
        (r"\renewcommand*\sw{\sigma_{w}}", r"q = \sw{} T", r"q = \sigma_{w} T"),
        (r"\providecommand{\sw} {\sigma_w}", r"q = \sw\,T", r"q = \sigma_w\,T"),
        (r"\def\sw{s}", r"q = 2\sw T", r"q = 2s T"),
        (r"\def\pair#1#2{(#1 + #2)}", r"q = \pair{a}b", r"q = (a + b)"),
        (
            r"\newcommand{\of}[2][x]{\frac{#2}{#1}}",
            r"\of{a} = \of[y]b",
            r"\frac{a}{x} = \frac{b}{y}",
        ),
        (r"\newcommand{\half}{\frac12}", r"q = a^\half", r"q = a^{\frac12}"),
        (r"\newcommand{\a}{\alpha}\newcommand{\b}{2\a}", r"q = \b x", r"q = 2\alpha x"),
        (r"\newcommand{\up}[1]{#1^\tr}\newcommand{\tr}{T}", r"q^2 = \up{x}", None),
        (r"\DeclareMathOperator{\tr}{tr}", r"q = \tr(A)", r"q = \operatorname{tr}(A)"),
        (r"\DeclareMathOperator*{\Det}{det}", r"q = \Det A", r"q = \operatorname{det} A"),
        (r"\newcommand{\sw}{\ensuremath{\sigma_w}\xspace}", r"q = \sw T", r"q = \sigma_w T"),
        (r"\newcommand{\x}{a}\providecommand{\x}{a}", r"q = \x", r"q = a"),
        (r"\newcommand{\hh}{h}", r"q = \sin\hh + x", r"q = \sin h + x"),
        (r"\newcommand{\hh}{h}", r"q = \sin \hh", r"q = \sin h"),
        (r"\newcommand{\of}[1]{\sin#1 + b}", r"q = \of{h}", r"q = \sin h + b"),
        (r"\newcommand{\of}[1]{#1x}", r"q = \of\alpha", r"q = \alpha x"),
        (r"\newcommand{\no}{}", r"q = \sin\no{}h", r"q = \sin h"),
        (r"\newcommand{\swap}{s}", r"q = s", r"q = s"),
    ],
)
def test_macros_are_put_in(definitions: str, printed: str, put_in: str | None) -> None:
    text = rf"{definitions}\begin{{document}}\[ {printed} \]\end{{document}}"
    made = draft(text, "a.tex", "a")
    assert made.equations == 1
    if put_in is None:
        assert "(1, 1)" not in made.text
        assert r"x^T" in made.text
        return
    assert made.unread == 0
    assert tomllib.loads(made.text)["claims"][0]["latex"] == put_in


def test_macros_for_displays_are_put_in() -> None:
    text = "\\newcommand{\\be}{\\begin{equation}}\n\\def\\ee{\\end{equation}}\n\\begin{document}\n"
    text += "\\be a = b \\ee\n\n\\be c = d \\ee \\end{document}"
    data = tomllib.loads(draft(text, "a.tex", "a").text)
    assert [(one["id"], one["latex"]) for one in data["claims"]] == [("1", "a = b"), ("2", "c = d")]


@pytest.mark.parametrize(
    ("definitions", "printed", "told"),
    [
        (r"\newcommand{\sw}{\sw x}", r"q = \sw", r"the macro \sw goes on without an end"),
        (r"\def\a{\b}\def\b{\a}", r"q = \a", "goes on without an end"),
        (r"\def\a{\b\b}\def\b{\c\c\c\c\c\c}\def\c{" + "x" * 900 + "}", r"q = \a", "more than 4000"),
        (r"\newcommand{\sw}[1]{#1}", r"q = \sw", r"the macro \sw is without its argument 1"),
        (r"\newcommand{\sw}[1]{#1}", r"q = \sw{a", r"the macro \sw has an argument without an end"),
        (r"\newcommand{\swap}{s}", r"q = \sw", r"the command \sw is not known"),
        *[
            (rf"\newcommand{{\x}}{{a}}{second}", r"q = \x", r"the macro \x is defined twice")
            for second in (
                *(r"\renewcommand{\x}{b}", r"\providecommand{\x}{b}", r"\def\x{b}"),
                *(r"\renewcommand{\x}[1]{a}", r"\gdef\x{b}", r"\let\x=\y", r"\def\x#1.{b}"),
                *(r"\DeclareMathOperator{\x}{b}", r"\RenewDocumentCommand{\x}{}{b}"),
                r"\renewcommand{\x}{b}\renewcommand{\x}{b}",
            )
        ],
        (r"\def\sw#1.{#1}", r"q = \sw a.", r"the command \sw is not known"),
    ],
)
def test_macros_that_cannot_be_put_in_are_told(definitions: str, printed: str, told: str) -> None:
    text = rf"{definitions}\begin{{document}}\[ {printed} \]\end{{document}}"
    made = draft(text, "a.tex", "a")
    assert made.unread == 1
    assert told in made.text


@pytest.mark.parametrize("mark", ["T", r"\mathsf{T}", r"\top", r"{\mathsf T}"])
@pytest.mark.parametrize(
    ("base", "matrices", "others"),
    [
        ("G", ["G"], ["q"]),
        (r"\hat{x}_k", [r"\hat{x}_k"], ["q"]),
        (r"(I - K H)", ["I", "K", "H"], ["q"]),
        (r"\left( A B \right)", ["A", "B"], ["q"]),
    ],
)
def test_letters_under_a_transpose_are_drafted_with_a_shape(
    mark: str, base: str, matrices: list[str], others: list[str]
) -> None:
    made = draft(rf"\[ Q = {base} q {base}^{mark} \] \[ p = G \]", "a.tex", "a")
    symbols = tomllib.loads(made.text)["settings"]["main"]["symbols"]
    assert made.unread == 0
    assert all(symbols[name]["shape"] == "TODO" for name in matrices)
    assert not any("shape" in symbols[name] for name in [*others, "p", "Q"])


def test_a_function_under_a_transpose_is_one_of_its_argument() -> None:
    text = r"\[ Q = \int_0^T F(u) G q G^\mathsf{T} F(u)^\mathsf{T} \, \mathrm{d}u \]"
    made = draft(text, "a.tex", "a")
    symbols = tomllib.loads(made.text)["settings"]["main"]["symbols"]
    assert made.unread == 0
    assert symbols["F"] == {
        "definition": "TODO", "arguments": ["u"], "shape": "TODO", "meaning": "TODO"
    }  # fmt: skip
    assert set(symbols) == {"Q", "T", "F", "u", "G", "q"}


@pytest.mark.parametrize(
    ("printed", "read", "taken"),
    [
        (r"x = \tan^{-1} \frac yz", r"x = \arctan \frac yz", r"\tan^{-1} was taken as \arctan"),
        (r"x = \sin ^ { -1 } y", r"x = \arcsin y", r"\sin^{-1} was taken as \arcsin"),
        (r"y = \sin \omega T", r"y = \sin(\omega T)", r"\sin \omega T was taken as \sin(\omega T)"),
        (r"y = \cos\theta(1 + a)", r"y = \cos(\theta)(1 + a)",
         r"\cos\theta(1 + a) was taken as \cos(\theta)(1 + a)"),
        (r"y = \sin \omega T + \cos \omega T", r"y = \sin(\omega T) + \cos(\omega T)",
         r"\cos \omega T was taken as \cos(\omega T)"),
        (r"y = \sin^2 \omega T x - 1", r"y = \sin^2(\omega T x) - 1", r"\sin^2(\omega T x)"),
    ],
)  # fmt: skip
def test_what_a_print_leaves_open_is_taken_and_told(printed: str, read: str, taken: str) -> None:
    made = draft(rf"\[ {printed} \]", "a.tex", "a")
    assert tomllib.loads(made.text)["claims"][0]["latex"] == read
    assert taken in made.text.partition("[[claims]]")[0]


@pytest.mark.parametrize(
    "display",
    [
        r"\begin{align} a &= b \\ &\quad + c \end{align}",
        r"\begin{align*} a &= b \\ &\qquad {}+ c \end{align*}",
        r"\begin{gather} a = b + c \end{gather}",
        r"\begin{equation}\begin{split} a &= b \\ &+ c \end{split}\end{equation}",
        r"\begin{multline} a = b \\ + c \end{multline}",
        r"\begin{equation*}\begin{aligned} a &= b + c \end{aligned}\end{equation*}",
    ],
)
def test_displays_of_several_lines_are_one_equation(display: str) -> None:
    made = draft(display, "a.tex", "a")
    assert (made.equations, made.unread) == (1, 0)
    relation = symbols_met(tomllib.loads(made.text)["claims"][0]["latex"]).formula
    expected = symbols_met("a = b + c").formula
    assert relation is not None
    assert expected is not None
    assert relation.readings[0].relations == expected.readings[0].relations


def test_cases_are_one_claim() -> None:
    text = r"""\begin{equation} f = \begin{cases} a & x > 0 \\ b, & \text{if } x \le 0 \\
        c & \text{otherwise.} \end{cases} \end{equation}"""
    (claim,) = tomllib.loads(draft(text, "a.tex", "a").text)["claims"]
    assert symbols_met(claim["latex"]).formula is not None
    assert claim["latex"].startswith(r"f = \begin{cases} a & x > 0 \\ b, &")


@pytest.mark.alike
@pytest.mark.parametrize(
    "text",
    [
        "\\newcommand" * 20_000,
        "\\newcommand{\\a}[9][" * 5000,
        "\\def\\a#1{" * 10_000,
        "".join(f"\\def\\{'abcdefghij'[n]}{{\\{'bcdefghija'[n]}}}" for n in range(10))
        + "\\[ x = \\a \\]" * 1000,
        "\\def\\a{\\a\\a}\\begin{document}" + "\\[ x = \\a \\]" * 1000,
        "\\def\\be{\\begin{equation}}\\begin{document}" + "\\be" * 20_000,
        "\\[ " + "\\sin x y " * 300 + " = 1 \\]",
        "\\[ " + "x^T + " * 600 + " 1 = 1 \\]",
        "\\[ " + "(x)^T + " * 400 + " 1 = 1 \\]",
    ],
)
def test_hostile_macros_and_prints_end_soon(text: str) -> None:
    started = time.process_time()
    assert tomllib.loads(draft(text, "a.tex", "a").text)
    assert time.process_time() - started < 10
