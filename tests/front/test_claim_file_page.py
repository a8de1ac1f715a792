"""docs/claim-files.md against the code: every field and every word that is read is documented, and
nothing else is.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from gainproof.verify.judge.claim import claims as claim_list
from gainproof.verify.judge.claim import (
    declarations,
    models,
    settings,
)
from gainproof.verify.judge.claim import (
    file as claim_file,
)
from gainproof.verify.judge.kinds.catalogue import KINDS
from gainproof.verify.judge.kinds.kind import Kind
from gainproof.verify.judge.kinds.location import LOCATIONS
from gainproof.verify.judge.kinds.monotone import SIGNS
from gainproof.verify.judge.kinds.stability import SENSES
from gainproof.verify.judge.quantity_names import quantity_names

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "claim-files.md").read_text("utf-8")


def part(title: str) -> str:
    """The page from a heading to the next."""
    start = PAGE.index(f"\n## {title}\n")
    end = PAGE.find("\n## ", start + 1)
    return PAGE[start : end if end >= 0 else len(PAGE)]


def rows(text: str, head: str) -> dict[str, str]:
    """The table with this heading: the words in code of the first column, and the rest."""
    table = text[text.index(f"| {head} |") :].split("\n\n")[0]
    found: dict[str, str] = {}
    for line in table.split("\n")[2:]:
        first, _, rest = line.removeprefix("| ").partition(" | ")
        found |= dict.fromkeys(re.findall(r"`([^`]+)`", first), rest)
    return found


def test_parts_of_the_file() -> None:
    shown = {re.split(r"[.\]]", name.strip("["))[0] for name in rows(part("The parts"), "part")}
    assert shown == set(claim_file.TABLES)


def test_fields_of_the_source() -> None:
    assert set(rows(part("[source]"), "field")) == set(claim_file.SOURCE_FIELDS)


def test_fields_of_symbols() -> None:
    assert set(rows(part("[symbols]"), "field")) == set(declarations.FIELDS)


def test_quantities() -> None:
    shown = rows(part("[symbols]"), "quantity")
    known = quantity_names()
    assert set(shown) <= set(known)
    starts = {re.sub(r"[.\d]+$", "", name) for name in shown}
    assert starts == {re.sub(r"[.\d]+$", "", name) for name in known}


def test_fields_of_settings() -> None:
    text = part("[settings.NAME]")
    conventions = rows(text[text.index("Conventions say") :], "field")
    assert set(conventions) == set(settings.CONVENTIONS)
    for name, choices in settings.CONVENTIONS.items():
        said = re.findall(r"`([^`]+)`", conventions[name])
        assert set(choices) - {"search"} <= set(said), name
    others = rows(text, "field")
    assert set(others) | set(conventions) == set(settings.FIELDS)
    assert set(models.MATRICES) < set(others)
    assert all(f"`{kind}`" in others["kind"] for kind in settings.SETTING_KINDS)


def test_fields_of_claims() -> None:
    assert set(rows(part("[[claims]]"), "field")) == set(claim_list.FIELDS) - set(
        claim_list.KIND_FIELDS
    )


def test_kinds_of_claims_are_told_as_their_records_say() -> None:
    words = [(kind, kind.own_words and f" {kind.own_words}") for kind in KINDS]
    told = [f"| `{kind.name}` | {kind.meaning} |{own} |" for kind, own in words]
    table = PAGE.split("| kind | claims that | fields of its own |\n")[1].split("\n\n")[0]
    assert table.splitlines()[1:] == told


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
def test_a_kind_names_its_fields(kind: Kind) -> None:
    assert all(f"`{name}`" in kind.own_words for name in kind.own)
    words = {"trend": SIGNS, "where": LOCATIONS, "sense": SENSES}
    for name in words.keys() & set(kind.own):
        assert all(f"`{word}`" in kind.own_words for word in words[name])


@pytest.mark.parametrize(
    "limit",
    [
        f"{claim_list.MOST_CLAIMS} claims",
        f"{declarations.MOST_SYMBOLS} symbols",
        f"{settings.MOST_SETTINGS}\nsettings",
    ],
)
def test_limits(limit: str) -> None:
    assert limit in part("Limits")


def test_the_example_is_read() -> None:
    blocks = re.findall(r"^```toml\n(.*?)^```$", PAGE, flags=re.MULTILINE | re.DOTALL)
    short, example = sorted((one for one in blocks if "format =" in one), key=len)
    assert len(claim_file.read_claim_text(short).claims) == 3
    more = [one for one in blocks if "format =" not in one]
    file = claim_file.read_claim_text("\n".join((example, *more)))
    assert [claim.id for claim in file.claims] == [str(n) for n in range(1, 7)]
    assert claim_file.FORMAT in example


def test_prose_fits() -> None:
    prose = [line for line in PAGE.splitlines() if not line.startswith("|")]
    assert max(map(len, prose)) <= 130
