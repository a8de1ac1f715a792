"""Many inputs for the readers, tallied: those of `reader_fuzz`; formulas of the repository broken,
spliced or repeated, with their own symbols; claim files broken in a few places.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from random import Random

from fuzz_tally import Refused, Symbols, Tally, tallied
from reader_fuzz import PIECES, check_input, random_text

import gainproof.verify
from gainproof.verify.judge.claim.file import read_claim_file, read_claim_text
from gainproof.verify.judge.reader.reader import read_conditions, read_formula

CLAIMS = Path(gainproof.verify.__file__).parent / "claims"
MOST_LONG = 4200
"""A little more than the reader takes."""
SHORT_FILE = 6000
"""Characters of a claim file that is broken: long enough for every kind of table."""
TOML_PIECES = (
    *(
        "",
        "",
        "'",
        '"',
        "'''",
        '"""',
        "[",
        "]",
        "[[",
        "]]",
        "{",
        "}",
        "=",
        "\n",
        ",",
        "#",
        "\\",
        ".",
    ),
    *("id", "1", "-1", "1e400", "nan", "true", "1979-05-27", "[claims]", "[[claims]]\n", "\\u0000"),
    *("kind = 'value'\n", "kind = 'location'\n", "kind = 'steady_state'\n", "where = 'real'\n"),
    *(
        "definition = 'x'",
        "arguments = ['x']",
        "domain = '1 < 0'",
        "integer = true",
        "\u202e",
        "\x7f",
    ),
)


def fuzz_formulas(seed: int, count: int) -> Tally:
    """Formulas and conditions."""
    random = Random(f"formulas {seed}")

    return tallied(count, lambda: random_formula(random), _read_either)


def _read_either(text: str, symbols: Symbols) -> object:
    # as a condition every eighth, by a rule that needs no state
    return (read_formula if len(text) % 8 else read_conditions)(text, symbols)


def fuzz_made(seed: int, count: int) -> Tally:
    """Formulas that are made, in LaTeX and as plain text; what is read must be read again from its
    print.
    """
    random = Random(f"made {seed}")

    def attempt(text: str, _: Symbols) -> None:
        if not check_input(text, plain=len(text) % 4 == 0):
            raise Refused

    return tallied(count, lambda: (random_text(random), {}), attempt)


def fuzz_files(seed: int, count: int) -> Tally:
    """Whole claim files."""
    random = Random(f"files {seed}")
    return tallied(
        count, lambda: (random_file(random), {}), lambda text, _: read_claim_text(text, "own.toml")
    )


@cache
def corpus() -> Sequence[tuple[str, Symbols]]:
    """The formulas of all claim files, with the symbols declared for them."""
    return tuple(
        (claim.latex, claim_file.settings[claim.setting].symbols)
        for claim_file in map(read_claim_file, sorted(CLAIMS.rglob("*.toml")))
        for claim in claim_file.claims
        if claim.latex
    )


@cache
def files() -> Sequence[str]:
    """The beginnings of all claim files, cut between two claims."""
    found = []
    for path in sorted(CLAIMS.rglob("*.toml")):
        text = path.read_text(encoding="utf-8")
        first = text.index("[[claims]]")
        end = text.find("[[claims]]", max(first + 1, SHORT_FILE))
        found.append(text if end < 0 else text[:end])
    return tuple(found)


def random_formula(random: Random) -> tuple[str, Symbols]:
    """A text for the reader, and declared symbols."""
    kind = random.randrange(100)
    text, symbols = random.choice(corpus())
    if kind < 2:
        piece = "".join(random.choice(PIECES) for _ in range(random.randrange(1, 4)))
        return piece * random.randrange(1, max(2, MOST_LONG // max(1, len(piece)))), symbols
    if kind < 25:
        other, _ = random.choice(corpus())
        text = text[: random.randrange(len(text) + 1)] + other[random.randrange(len(other) + 1) :]
    return broken(text, PIECES, random), symbols


def random_file(random: Random) -> str:
    """A text for the reader of claim files."""
    text = random.choice(files())
    for _ in range(random.randrange(1, 4)):
        text = broken(text, TOML_PIECES, random)
    if random.random() < 0.2:
        lines = text.split("\n")
        lines.insert(random.randrange(len(lines)), random.choice(lines))
        text = "\n".join(lines)
    return text


def broken(text: str, pieces: Sequence[str], random: Random) -> str:
    """With up to three pieces put in place of a few characters."""
    for _ in range(random.randrange(0, 4)):
        start = random.randrange(len(text) + 1)
        end = min(len(text), start + random.choice((0, 0, 1, 1, 2, 8)))
        text = text[:start] + random.choice((*pieces, "")) + text[end:]
    return text
