"""What formulas of matrices are written with: relations, arrows, powers, words without meaning."""

from __future__ import annotations

import re

RELATIONS = {
    "=": "=",
    "<": "<",
    ">": ">",
    "\\lt": "<",
    "\\gt": ">",
    "\\le": "<=",
    "\\leq": "<=",
    "\\leqq": "<=",
    "\\leqslant": "<=",
    "\\preceq": "<=",
    "\\prec": "<",
    "\\ge": ">=",
    "\\geq": ">=",
    "\\geqq": ">=",
    "\\geqslant": ">=",
    "\\succeq": ">=",
    "\\succ": ">",
}
ARROWS = {
    "\\Rightarrow": "=>",
    "\\implies": "=>",
    "\\Longrightarrow": "=>",
    "\\Leftrightarrow": "<=>",
    "\\iff": "<=>",
    "\\Longleftrightarrow": "<=>",
}
WIDE = ("\\quad", "\\qquad")
SILENT = frozenset(("\\left", "\\right", "\\bigl", "\\bigr", "\\Bigl", "\\Bigr", "\\big", "\\Big"))
TIMES = frozenset(("\\cdot", "\\times"))
MATRICES = ("{pmatrix}", "{bmatrix}", "{array}", "{matrix}")
POWERS = {
    "T": "T",
    "{T}": "T",
    "\\top": "T",
    "{\\top}": "T",
    "\\intercal": "T",
    "{\\intercal}": "T",
    "\\mathsf{T}": "T",
    "\\mathrm{T}": "T",
    "{\\mathsf{T}}": "T",
    "{\\mathrm{T}}": "T",
    "{\\mathsfT}": "T",
    "{\\mathrmT}": "T",
    "{\\rmT}": "T",
    "{-1}": "-1",
    "{-T}": "-T",
}

WORD = re.compile(
    r"\\(?:operatorname|mathrm|mathsf|text|mathit|rm)\*?\s*\{\s*([A-Za-z]{2,})\s*\}"
    r"|\\(tr|Tr|trace|rank|diag|lVert|lvert|Vert|vert|log|exp)(?![A-Za-z])"
)
COVERED = "read are sums, products, powers ^T and ^{-1}, \\det(...) \\neq 0 and means E[...]"
