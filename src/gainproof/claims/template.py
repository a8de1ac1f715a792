"""The claim file that a user begins with: every part once, with what may stand there."""

from __future__ import annotations

import textwrap

from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.kinds.catalogue import KINDS

FORMAT_LINE = 'format = "gainproof claims 1"'

SETTINGS_COMMENT = """\
# A setting says what claims are about. kind is one of
#   steady_state    a Kalman filter in its steady state, with
#                   model = "random-velocity", "random-acceleration", ... (gainproof list),
#                   or "search" where the source does not say, or matrices of its own
#   growing_memory  least squares over all samples, with degree = 0, 1, 2 or 3
#   fading_memory   the same with weights that fall with age, after many samples
#   kalman_bucy     a steady state in continuous time, with matrices of its own
#   fixed_gain      a filter with any gains, with states = 1, 2 or 3
#   algebra         no filter: the claims follow from the definitions of their symbols
#   matrices        letters that are matrices of any size, with sizes = ['n', 'm']
"""
SYMBOLS_COMMENT = r"""# Every symbol is declared once, by its LaTeX in single quotes, as one of
#   { quantity = "filter_gain.1", meaning = "..." }       a quantity of the setting's filter
#   { definition = '\frac{a}{T}', meaning = "..." }       short for a formula
#   { unit = "m s^-1", domain = 'a > 0', meaning = "..." }     any such number
#   { undefined = true, meaning = "..." }                 printed, but never defined
"""
KINDS_COMMENT = (
    textwrap.fill(
        "Claims in the order of the source. kind is one of "
        f"{', '.join(kind.name for kind in KINDS)}; "
        "docs/claim-files.md says what each means.",
        width=95,
        initial_indent="# ",
        subsequent_indent="# ",
    )
    + "\n"
)
_HEAD = f"""\
# Claims of one source: replace what stands here, then: gainproof check THIS-FILE
{FORMAT_LINE}

[source]
key = %s
title = "Title of the paper"
authors = ["A. Author", "B. Author"]
publication = "Journal 1, 23-45"
# year, doi, url, note and logarithm (the base of \\log where none is printed) may follow

"""
_SETTING = """\
[settings.steady]
title = "alpha-beta filter in its steady state"
kind = "steady_state"
model = "search"

"""
_SYMBOLS = r"""[settings.steady.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain of the position" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain of the velocity" }
'\Lambda' = { quantity = "tracking_index", meaning = "tracking index" }

"""
_CLAIMS = r"""
[[claims]]
id = "1"
place = "equation (1)"
kind = "identity"
setting = "steady"
latex = '\beta = \frac{\alpha^2}{2 - \alpha}'

[[claims]]
id = "2"
place = "equation (2)"
kind = "limit"
setting = "steady"
latex = '\alpha \to 1 \quad (\Lambda \to \infty)'
"""


def template(key: str) -> str:
    """A claim file that can be checked as it is: a relation of the gains of an alpha-beta filter,
    and a limit.
    """
    head = _HEAD % quoted(key)
    return "".join(
        (head, SETTINGS_COMMENT, _SETTING, SYMBOLS_COMMENT, _SYMBOLS, KINDS_COMMENT, _CLAIMS)
    )
