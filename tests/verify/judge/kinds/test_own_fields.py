"""What fields of one kind of claim say is part of the claim: symbols in them are used by it, and
dimensions in them are compared.
"""

from __future__ import annotations

import pytest
from small_claims import HEAD

from gainproof.verify.judge.claim.claims import KIND_FIELDS
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import used
from gainproof.verify.judge.dimensions.claim import claim_readings

SETTING = """
kind = 'fixed_gain'
states = 2
[settings.s.filters]
one = ['f = e']
two = ['f = g']
[settings.s.symbols]
'x' = { unit = 'm', meaning = 'a length' }
't' = { unit = 's', meaning = 'a time' }
'z' = { unit = '1', meaning = 'a number' }
'p' = { unit = 'm', meaning = 'a value' }
'q' = { unit = 'm', meaning = 'the value before' }
'r' = { unit = 's', meaning = 'another value before' }
'e' = { quantity = 'gain.1', meaning = 'gain of the position' }
'f' = { quantity = 'gain.2', meaning = 'gain of the velocity' }
'g' = { unit = '1', meaning = 'a number' }
"""
EQUATION = "latex = 'p = x'\n"
ORDER = "ascending = ['one', 'two']\n"
CASES = [
    ("determines", "about = ['x', 't']\ntext = 'each fixes the other'", "x t", None),
    ("monotone", "about = ['x z', 't']\ntrend = 'increasing'", "x z t", None),
    ("monotone", "about = ['x + t', 'z']\ntrend = 'increasing'", "x t z", "in what changes"),
    ("location", "polynomial = 'z^2 - g'\nvariable = 'z'\nwhere = 'real'", "z g", None),
    (
        "location",
        "polynomial = 'z^2 - x'\nvariable = 'z'\nwhere = 'real'",
        "z x",
        "in the polynomial",
    ),
    ("solutions", "latex = 'z^2 = g'\nvariable = 'z'\nnumber = 2", "z g", None),
    ("steady_state", f"{EQUATION}recursion = 'p = z q'\nprevious = 'q'", "p x z q", None),
    (
        "steady_state",
        f"{EQUATION}recursion = 'p = z t'\nprevious = 'q'",
        "p x z t q",
        "in the recursion",
    ),
    (
        "steady_state",
        f"{EQUATION}recursion = 'p = z x'\nprevious = 'r'",
        "p x z r",
        "the next value and the last",
    ),
    ("asymptotics", "latex = 'x = p \\quad (z \\to 0)'\norder = 1", "x p z", None),
    ("stability", "latex = 'e > g'\nsense = 'necessary'", "e g", None),
    ("optimum", "latex = 'e = f'\nminimised = 'e z'\nfixed = ['g']", "e f z g", None),
    (
        "optimum",
        "latex = 'e = f'\nminimised = 'x + t'\nfixed = ['g']",
        "e f x t g",
        "in what is compared",
    ),
    (
        "optimum",
        "latex = 'e = f'\nminimised = 'e'\nfixed = ['z', 'x + t']",
        "e f z x t",
        "in what is fixed",
    ),
    ("ordering", f"compared = 'e z'\n{ORDER}fixed = ['g']", "e z g f", None),
    ("ordering", f"compared = 'x + t'\n{ORDER}fixed = ['g']", "x t g e f", "in what is compared"),
]


def claim_of(kind: str, fields: str) -> tuple[Claim, Setting]:
    table = f"[[claims]]\nid = '1'\nplace = 'here'\nsetting = 's'\nkind = '{kind}'\n{fields}\n"
    file = read_claim_text(f"{HEAD}{SETTING}{table}")
    return file.claims[0], file.settings["s"]


def test_every_field_is_met() -> None:
    met = {name for _, fields, *_ in CASES for name in KIND_FIELDS if f"{name} = " in fields}
    assert met == set(KIND_FIELDS)


@pytest.mark.parametrize(("kind", "fields", "spoken_of", "fault"), CASES)
def test_symbols_and_dimensions(kind: str, fields: str, spoken_of: str, fault: str | None) -> None:
    claim, setting = claim_of(kind, fields)
    assert used(claim, setting) == set(spoken_of.split())
    found = claim_readings(claim, setting)[1]
    assert found is None if fault is None else fault in (found or "")
