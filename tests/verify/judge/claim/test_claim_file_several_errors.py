"""All errors of a claim file come at once, none that only follows from another, and what they do
not touch can be judged.
"""

from __future__ import annotations

import cProfile
import itertools
from collections.abc import Iterable

import pytest
from one_of_each import further

from gainproof.verify.judge.claim.errors import MOST_FOUND
from gainproof.verify.judge.claim.file import ClaimFile, ClaimFileError, read_claim_text

TEXT = r"""format = "gainproof claims 1"

[source]
key = "notes"
title = "Notes"
authors = ["A. Someone"]
publication = "unpublished"

[symbols]
'T' = { quantity = "sampling_interval", meaning = "time between samples" }
'm' = { unit = "1", meaning = "a number" }

[settings.numbers]
title = "numbers"
kind = "algebra"

[settings.numbers.symbols]
'x' = { unit = "1", domain = 'x > 0', meaning = "a number" }
'y' = { unit = "1", meaning = "a number" }
's' = { definition = 'x + m', meaning = "a sum" }
'f' = { arguments = ['y'], definition = 'y^2', meaning = "a square" }
'M' = { shape = [2, 2], meaning = "M", definition = '\begin{pmatrix} x & 0 \\ 0 & 1\end{pmatrix}' }

[settings.filter]
title = "random velocity"
kind = "steady_state"
model = "random-velocity"

[settings.filter.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain of the position" }

[settings.sizes]
title = "letters"
kind = "matrices"
sizes = ['n']

[settings.sizes.symbols]
'P' = { shape = ["n", "n"], is = ["positive definite"], meaning = "a covariance" }

[[claims]]
id = "y"
place = "page 1"
kind = "identity"
setting = "numbers"
latex = 'y + y = 2y'

[[claims]]
id = "x"
place = "page 2"
kind = "inequality"
setting = "numbers"
latex = 's \geq m'
domain = 'x < 9'

[[claims]]
id = "f"
place = "page 3"
kind = "identity"
setting = "numbers"
latex = 'f(y) = y y'

[[claims]]
id = "M"
place = "page 4"
kind = "identity"
setting = "numbers"
latex = 'M M^T = M^T M'

[[claims]]
id = "gain"
place = "page 5"
kind = "inequality"
setting = "filter"
latex = '\alpha < 1'

[[claims]]
id = "P"
place = "page 6"
kind = "identity"
setting = "sizes"
latex = 'P P^{-1} = I_{n}'

[[claims]]
id = "P2"
place = "page 7"
kind = "identity"
setting = "sizes"
latex = 'P^{-1} P = I_{n}'
using = ['P']
"""
IDS = ("y", "x", "f", "M", "gain", "P", "P2")

FAULTS = {
    "title": ('title = "Notes"', "title = 1", "source.title", IDS),
    "shared unit": (
        """'m' = { unit = "1",""",
        """'m' = { unit = "mm",""",
        "symbols.m.unit",
        ("x",),
    ),
    "unit": ("""unit = "1", domain""", """unit = "mm", domain""", "symbols.x.unit", ("x", "M")),
    "domain": ("'x > 0'", "'x > q'", "symbols.x.domain", ("x", "M")),
    "definition": ("'x + m'", "'x + m)'", "symbols.s.definition", ("x",)),
    "argument": ("arguments = ['y']", "arguments = ['q']", "symbols.f", ("f",)),
    "shape": ("shape = [2, 2]", "shape = [2, 0]", "symbols.M.shape", ("M",)),
    "symbol": ("'y' = {", "'y y' = {", "symbols.y y", ("y", "f")),
    "meaning": (
        """quantity = "filter_gain.1", meaning""",
        """quantity = "filter_gain.1", maening""",
        "symbols.\\alpha.maening",
        ("gain",),
    ),
    "model": ('model = "random-velocity"', "model = 3", "settings.filter.model", ("gain",)),
    "letter": (
        'is = ["positive definite"]',
        'is = ["large"]',
        "settings.sizes.symbols.P.is",
        ("P", "P2"),
    ),
    "bracket": ("'y + y = 2y'", "'y + y = 2y)'", "claims.y.latex", ("y",)),
    "place": ('place = "page 2"', "place = 2", "claims.x.place", ("x",)),
    "own domain": ("'x < 9'", "'x < q'", "claims.x.domain", ("x",)),
    "kind": (
        'id = "f"\nplace = "page 3"\nkind = "identity"',
        'id = "f"\nplace = "page 3"\nkind = "identy"',
        "claims.f.kind",
        ("f",),
    ),
    "relation": ("'M M^T = M^T M'", "'M M^T = M^T q'", "claims.M.latex", ("M",)),
    "id": ('id = "gain"', 'id = "ga in"', "claims number 5.id", ("gain",)),
    "matrices": ("'P P^{-1} = I_{n}'", "'P P^{-1} = I_{k}'", "claims.P.latex", ("P", "P2")),
}
"""What stands there, what instead, where the error is, and the claims that cannot be judged."""


def spoiled(names: Iterable[str]) -> str:
    text = TEXT
    for name in names:
        old, new, *_ = FAULTS[name]
        assert text.count(old) == 1, name
        text = text.replace(old, new)
    return text


def errors_of(text: str) -> list[str]:
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(text)
    return [error.where for error in (caught.value, *caught.value.others)]


def kept(text: str) -> ClaimFile | None:
    try:
        return read_claim_text(text, keep_going=True)
    except ClaimFileError:
        return None


def test_the_text_itself_has_no_error() -> None:
    assert tuple(claim.id for claim in read_claim_text(TEXT).claims) == IDS


@pytest.mark.parametrize("name", FAULTS)
def test_one_fault_is_one_error(name: str) -> None:
    """Formulas that use what has an error are not blamed."""
    (where,) = errors_of(spoiled([name]))
    assert FAULTS[name][2] in where


@pytest.mark.parametrize("name", FAULTS)
def test_what_a_fault_does_not_touch_is_kept(name: str) -> None:
    lost = FAULTS[name][3]
    found = kept(spoiled([name]))
    if lost == IDS:
        assert found is None
        return
    assert found is not None
    assert {claim.id for claim in found.claims} == set(IDS) - set(lost)
    assert [FAULTS[name][2] in error.where for error in found.errors] == [True]
    # a claim whose id cannot be read is named by its number
    named = {"number 5" if name == "id" and claim == "gain" else claim for claim in lost}
    assert set(found.unread) == named


def test_a_claim_with_the_id_of_another_is_named_by_its_line() -> None:
    found = kept(TEXT.replace('id = "M"', 'id = "x"'))
    assert found is not None
    line = TEXT[: TEXT.index('id = "M"')].count("\n") + 1
    assert found.unread == (f"x (line {line})",)
    assert len(found.claims) == len(IDS) - 1


@pytest.mark.parametrize("letter", ["a", "p", "r", "t"])
@pytest.mark.parametrize(
    ("field", "formula"),
    [
        ("latex", r"\frac{y}{2} + z_{part} = \alpha"),
        ("latex", r"\hat{part} + \sqrt{y} = y_{a}"),
        ("plain", "tan(y) + sqrt(y) + part = y"),
    ],
)
def test_letters_inside_other_names_are_no_doubtful_symbol(
    letter: str, field: str, formula: str
) -> None:
    declared = f"'{letter}' = 3\n'y' = {{"
    text = TEXT.replace("'y' = {", declared).replace(
        "latex = 'y + y = 2y'", f"{field} = '{formula.replace('part', 'q')}'"
    )
    assert len(errors_of(text)) == 2
    used = text.replace("= '" + formula[:4], f"= '{letter} + " + formula[:4])
    assert used != text
    # what holds the symbol itself may follow from its declaration
    assert len(errors_of(used)) == 1


EXCLUDE = [
    {"symbol", "bracket"},
    {"shape", "relation"},
    {"letter", "matrices"},
]
"""Where the first may be the cause of the second, only the first is told."""


PAIRS = list(itertools.combinations(FAULTS, 2))


def _is_kept(pair: tuple[str, str]) -> bool:
    """Each fault beside the next, those of which one may be the other's cause, and some."""
    return pair in itertools.pairwise(FAULTS) or set(pair) in EXCLUDE or PAIRS.index(pair) % 10 == 0


@pytest.mark.parametrize(
    "pair", [pair if _is_kept(pair) else further(pair) for pair in PAIRS], ids="-".join
)
def test_two_faults_are_two_errors(pair: tuple[str, str]) -> None:
    text = spoiled(pair)
    found = errors_of(text)
    wanted = [FAULTS[name][2] for name in pair]
    if set(pair) in EXCLUDE:
        assert len(found) == 1
    else:
        assert len(found) == 2
        assert all(any(one in where for where in found) for one in wanted)
    rest = kept(text)
    lost = set(FAULTS[pair[0]][3]) | set(FAULTS[pair[1]][3])
    assert ({claim.id for claim in rest.claims} if rest else set()) == set(IDS) - lost


def test_all_faults_that_can_stand_together_come_in_one_run() -> None:
    names = [name for name in FAULTS if name not in {"symbol", "letter", "relation"}]
    found = errors_of(spoiled(names))
    assert len(found) == len(names)
    assert all(any(FAULTS[name][2] in where for where in found) for name in names)


def test_every_circle_is_told_once() -> None:
    text = TEXT.replace("'x + m'", "'s + 1'").replace("'y^2'", "'f(y)'")
    assert sorted(where.rpartition(".")[2] for where in errors_of(text)) == ["f", "s"]
    found = kept(text)
    assert found is not None
    assert [claim.id for claim in found.claims] == ["y", "M", "gain", "P", "P2"]


def test_what_is_kept_is_as_in_a_file_without_the_faults() -> None:
    whole = {claim.id: claim for claim in read_claim_text(TEXT).claims}
    found = kept(spoiled(["definition", "relation", "model"]))
    assert found is not None
    for claim in found.claims:
        assert claim == whole[claim.id]
    assert "s" not in found.settings["numbers"].symbols
    assert "filter" not in found.settings


def calls(text: str) -> int:
    profile = cProfile.Profile()
    profile.runcall(lambda: kept(text))
    return sum(entry.callcount for entry in profile.getstats())


@pytest.mark.parametrize("part", ["claims", "symbols"])
def test_a_file_of_errors_ends_after_so_many(part: str) -> None:
    claim = TEXT[TEXT.index('[[claims]]\nid = "y"') : TEXT.index('[[claims]]\nid = "x"')]
    if part == "claims":
        broken = claim.replace("2y", "2z")
        text = TEXT + "".join(broken.replace('"y"', f'"n{n}"') for n in range(1900))
    else:
        many = "".join(f"'z_{{{n}}}' = {{ unit = 'mm', meaning = 'z' }}\n" for n in range(450))
        text = TEXT.replace("'y' = {", f"{many}'y' = {{")
    found = errors_of(text)
    assert len(found) == MOST_FOUND + 1
    assert kept(text) is None
    assert calls(text) < 3_000_000
