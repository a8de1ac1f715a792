"""Claim files drafted from LaTeX: which equations, numbers and symbols; and hostile text."""

from __future__ import annotations

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
    ("definition", "told"),
    [
        (r"\newcommand{\sw}{\sigma_w}", r"\sw is a macro of the paper, for \sigma_w: "),
        (r"\renewcommand*\sw{\sigma_{w}}", r"\sw is a macro of the paper, for \sigma_{w}: "),
        (r"\def\sw{s}", r"\sw is a macro of the paper, for s: "),
        (r"\newcommand{\sw}[1]{#1}", r"\sw is a macro of the paper with arguments: "),
        (r"\newcommand{\swap}{s}", r"the command \sw is not known: write it in another way"),
        ("", r"the command \sw is not known: write it in another way"),
    ],
)
def test_a_macro_is_named_as_what_it_is(definition: str, told: str) -> None:
    text = definition + r"\begin{document}\[ q = \sw{} T \]\end{document}"
    assert f"# TODO not read, {told}" in draft(text, "a.tex", "a").text


@pytest.mark.parametrize("mark", ["T", r"\mathsf{T}", r"\top"])
def test_a_letter_under_a_transpose_is_to_be_declared(mark: str) -> None:
    text = rf"\[ Q = G^{mark} G \]"
    assert "declare it with shape = [rows, columns]" in draft(text, "a.tex", "a").text
