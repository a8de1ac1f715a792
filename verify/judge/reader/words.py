"""Words with a meaning of their own: named functions, what joins statements, what stands round
lines and matrices.
"""

from __future__ import annotations

# fmt: off
FUNCTION_COMMANDS = {
    "\\sin": "sin", "\\cos": "cos", "\\tan": "tan", "\\cot": "cot", "\\sec": "sec",
    "\\csc": "csc", "\\arcsin": "asin", "\\arccos": "acos", "\\arctan": "atan",
    "\\sinh": "sinh", "\\cosh": "cosh", "\\tanh": "tanh", "\\exp": "exp", "\\ln": "log",
    "\\log": "log", "\\det": "det", "\\max": "max", "\\min": "min",
}
FUNCTION_WORDS = {
    "sin": "sin", "cos": "cos", "tan": "tan", "cot": "cot", "sec": "sec", "csc": "csc",
    "arcsin": "asin", "arccos": "acos", "arctan": "atan", "asin": "asin", "acos": "acos",
    "atan": "atan", "atan2": "atan2", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh",
    "exp": "exp", "ln": "log", "log": "log", "det": "det", "max": "max", "min": "min",
    "tr": "trace", "trace": "trace", "rank": "rank", "diag": "diag",
    "blkdiag": "block_diagonal", "cov": "covariance", "var": "variance", "sgn": "sign",
    "sign": "sign", "erf": "erf", "erfinv": "erfinv", "arctan2": "atan2", "floor": "floor",
    "ceil": "ceil", "mod": "mod",
}
# fmt: on
"""Names of functions by the word printed: `\\ln` and `\\log` are both the natural logarithm,
unless a text means another by `\\log`.
"""
BASED = "log "
"""What the names of logarithms to a base begin with, which follows: no declared function has a
blank in its name.
"""


def function_of(word: str) -> str | None:
    """What a word of plain text or upright letters names, `log10` too; None if it is no
    function.
    """
    base = word.removeprefix("log")
    if word == "lg":
        base = "10"
    if word != base and base.isascii() and base.isdecimal() and len(base) < 9 and int(base) > 1:
        return f"{BASED}{int(base)}"
    return FUNCTION_WORDS.get(word)


# fmt: off
_UNREAD = frozenset((
    "round", "rint", "nearbyint", "nint", "around", "int", "trunc", "fix", "ceiling", "frac",
    "float", "double", "single", "cbrt", "nthroot", "exp2", "exp10", "expm1", "log1p", "pow10",
    "sech", "csch", "coth", "asinh", "acosh", "atanh", "asech", "acsch", "acoth", "arcsinh",
    "arccosh", "arctanh", "arsinh", "arcosh", "artanh", "asec", "acsc", "acot", "arcsec", "arccsc",
    "arccot", "sind", "cosd", "tand", "asind", "acosd", "atand", "sinpi", "cospi", "sinc",
    "deg2rad", "rad2deg", "radians", "degrees", "wrap", "wrapToPi", "unwrap", "erfc", "erfcinv",
    "factorial", "nchoosek", "binom", "comb", "tgamma", "lgamma", "gammaln", "heaviside",
    "signum", "copysign", "fdim", "fma", "clip", "clamp", "square", "absolute", "real", "imag",
    "conj", "arg", "dot", "cross", "mean", "median", "std", "expm", "logm", "sqrtm", "prod",
    "cumsum", "int32", "int64", "quad", "trapz", "integrate", "gradient",
))
# fmt: on


def is_unread(word: str) -> bool:
    """Whether languages have a function of this name that is not read, also with the mark of C for
    single or long precision: with a bracket behind it a product is hardly meant.
    """
    if word in _UNREAD or word.removesuffix("f") in _UNREAD:
        return True
    name = word.removesuffix("l")
    known = name in (*_UNREAD, "sqrt", "fabs", "pow", "hypot") or function_of(name) is not None
    return name != word and known


MATRIX_VALUED = frozenset(("diag", "block_diagonal", "family"))
CARRIES_SHAPE = frozenset(("expectation", "covariance", "sum", "product", "integral"))
"""Functions whose value is a matrix always, and where their first argument is one."""

BINDERS = frozenset(("sum", "product", "integral", "family"))
"""Functions whose second argument is a symbol that means something in the first one only."""

CIRCLE = "pi"
"""What the number is called in graphs: a call without arguments."""
CIRCLE_NAMES = frozenset(("\\pi", "\\mathrm{\\pi}", CIRCLE))

MADE_BY_READER = frozenset(
    (
        *("abs", "norm", "sum", "product", "integral", "expectation", "order", "power", "family"),
        CIRCLE,
        *FUNCTION_WORDS.values(),
    )
)
"""Names of calls that are the reader's own: no declared function may have one of them."""

PLAIN_FORMS = {
    "abs": 1,
    "norm": 1,
    "sqrt": 1,
    "transpose": 1,
    "inverse": 1,
    "matrix": 1,
    "kron": 2,
    "pow": 2,
    "hypot": 2,
    "diff": 2,
    "at": 3,
    "sum": 4,
    "product": 4,
    "integral": 4,
    "family": 4,
}
"""Words of plain text for what LaTeX prints with signs, with the number of their arguments."""

JOINING_WORDS = (
    {"and": ("AND", "and")}
    | dict.fromkeys(("if", "as", "for", "when", "where", "with"), ("IF", "if"))
    | dict.fromkeys(("otherwise", "else"), ("OTHERWISE", "otherwise"))
)
"""Words between statements: what they join, or that a condition follows; and what is said of all
else in cases.
"""
CASES = "cases"
"""Of the environment, and of its form in plain text: `cases(x, x > 0; -x)`."""
OF_CASES = f"{CASES} "
"""What the names of cases begin with, whose conditions follow: no declared function has a blank in
its name.
"""

LINE_ENVIRONMENTS = frozenset(
    (
        *("aligned", "align", "align*", "split", "gathered", "gather", "gather*"),
        *("equation", "equation*", "eqnarray", "eqnarray*", "multline", "multline*"),
    )
)
MATRIX_ENVIRONMENTS = frozenset(
    ("matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "array", "vmatrix")
)
TRANSPOSE_MARKS = ("T", "\\top", "\\intercal", "\\mathsf{T}", "\\mathrm{T}", "\\mathtt{T}")
DIFFERENTIAL_MARKS = ("\\mathrm{d}", "\\text{d}", "\\operatorname{d}")
EXPECTATION_NAMES = frozenset(("E", "\\mathrm{E}", "\\mathbb{E}", "\\operatorname{E}"))
ORDER_NAMES = frozenset(("O", "\\mathcal{O}", "\\mathrm{O}"))
EULER_NAMES = frozenset(("e", "\\mathrm{e}"))
BRANCHES = ("upper", "lower")
"""Which sign of `\\pm` and `\\mp` is meant."""
