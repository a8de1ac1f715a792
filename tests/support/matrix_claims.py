"""Claims about matrices of every size, judged in this process."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file, judge_setting
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = """
format = "gainproof claims 1"
[source]
key = "trial"
title = "trial"
authors = ["A. Reader"]
publication = "unpublished"
[settings.s]
title = "trial"
kind = "matrices"
"""
SIZES = r"sizes = ['p \leq n', 'm']"
SYMBOLS = r"""
'A' = { shape = ["m", "n"], meaning = "any" }
'B' = { shape = ["n", "n"], meaning = "any" }
'C' = { shape = ["n", "n"], meaning = "any" }
'X' = { shape = ["n", "n"], is = ["symmetric"], meaning = "symmetric" }
'Y' = { shape = ["n", "n"], is = ["symmetric"], meaning = "symmetric" }
'Z' = { shape = ["n", "n"], is = ["symmetric"], meaning = "symmetric" }
'S' = { shape = ["n", "n"], is = ["positive semidefinite"], meaning = "at least 0" }
'R' = { shape = ["m", "m"], is = ["positive definite"], meaning = "above 0" }
'Q' = { shape = ["n", "n"], is = ["positive definite"], meaning = "above 0" }
'V' = { shape = ["n", "n"], is = ["positive definite"], meaning = "in blocks", blocks = BLOCKS_V }
'V_1' = { shape = ["p", "p"], meaning = "block" }
'V_{12}' = { shape = ["p", "n-p"], meaning = "block" }
'V_2' = { shape = ["n-p", "n-p"], meaning = "block" }
'D' = { shape = ["n", "n"], is = REGULAR, meaning = "regular", blocks = BLOCKS_D }
'D_1' = { shape = ["p", "p"], meaning = "block" }
'D_{12}' = { shape = ["p", "n-p"], meaning = "block" }
'D_2' = { shape = ["n-p", "n-p"], meaning = "block" }
'H' = { definition = '\begin{pmatrix} O_{p,n-p} \\ I_{n-p} \end{pmatrix}', meaning = "picks" }
'G' = { definition = '\begin{pmatrix} A & I_m \\ O_{n,n} & A^T \end{pmatrix}', meaning = "blocks" }
'x' = { shape = ["n", "1"], meaning = "column" }
'a' = { shape = ["n", "1"], meaning = "unknown" }
'v' = { shape = ["m", "1"], variance = 'R', meaning = "noise" }
'w' = { shape = ["m", "1"], variance = 'R', meaning = "other noise" }
'z' = { definition = 'A a + v', meaning = "measurement" }
'\hat{a}' = { definition = '(A^T R^{-1} A)^{-1} A^T R^{-1} z', meaning = "estimate" }
"""


def text_of(claims: str, symbols: str = SYMBOLS, sizes: str = SIZES) -> str:
    """A claim file with one setting."""
    symbols = symbols.replace("REGULAR", "['positive semidefinite', 'invertible']")
    for name in "VD":
        rows = f"[['{name}_1', '{name}_{{12}}'], ['{name}_{{12}}^T', '{name}_2']]"
        symbols = symbols.replace(f"BLOCKS_{name}", rows)
    return f"{HEAD}{sizes}\n[settings.s.symbols]{symbols}{claims}"


def claim(latex: str, kind: str = "identity", more: str = "", name: str = "1") -> str:
    """The table of a claim."""
    return (
        f"\n[[claims]]\nid = '{name}'\nplace = 'here'\nkind = '{kind}'\nsetting = 's'\n"
        f"latex = '{latex}'\n{more}\n"
    )


def judged_matrices(
    latex: str,
    kind: str = "identity",
    more: str = "",
    before: Sequence[str] = (),
    symbols: str = SYMBOLS,
    *,
    repairs: bool = False,
) -> ClaimVerdict:
    """The verdict on the last of the claims; `before` are tables of earlier ones. What would be
    true in the place of a false one is looked for only with `repairs`: that may take its whole time
    and is another question.
    """
    file = read_claim_text(text_of("".join(before) + claim(latex, kind, more), symbols))
    if repairs:
        return judge_file(file, [], only="1")[0]
    (found,) = (v for v in judge_setting(file.settings["s"], file.claims, [], {}) if v.id == "1")
    return found
