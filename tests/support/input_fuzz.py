"""Whole inputs as users hand them over, made wrong: claim files whose tables have other values than
they should, judged too; CSV files; command lines. What comes of each is an answer or a message.
"""

from __future__ import annotations

import contextlib
import copy
import datetime as dt
import io
import json
import tempfile
import tomllib
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from fuzz_tally import Refused, Tally, tallied
from reader_campaign import CLAIMS, broken, files
from reader_fuzz import random_text

from gainproof import cli
from gainproof.claims.template import template
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.worker import Workers

SECONDS = 1.0
"""For a claim that is judged."""
FAULT = "the judge stopped"
"""How a reason begins that is a fault of the judge."""
WRONG: tuple[Any, ...] = (
    *("", " ", "x", "TODO", "\n", "\ud7ff", "../../x", "1 < 0", "a" * 5000, "\\frac{1}{0}", "%"),
    *(0, -1, 1, 2**63, -(10**40), 10**4000, 0.5, 1e308, float("inf"), float("nan"), True, False),
    *([], [[]], [1, "x"], ["x"] * 300, {}, {"x": 1}, {"unit": "1"}, [{}], {"": {}}),
    *(dt.date(1979, 5, 27), dt.datetime(1979, 5, 27, 7, 32, tzinfo=dt.UTC)),
)
NUMBERS = ("1e400", "-0", "nan", "9" * 400, "1e-320", "0x1", "1_0", "١", "+5", "", "5e9", "-7", "x")
CELLS = (*NUMBERS, '"', "#", "\0", "\ufeff", "[km]", "range [km]", "station", "A", "\r", ";", "\t")
LINES: Sequence[Sequence[str]] = (
    *(("locate", "o.csv", "s.csv"), ("locate", "o.csv", "s.csv", "--json")),
    ("locate", "o.csv", "s.csv", "--method", "range-only", "--near", "1,2"),
    ("locate", "o.csv", "s.csv", "--false-alarm", "0.1", "--carrier", "9.4 GHz"),
    ("track", "d.csv"),
    *(("track", "d.csv", "--filter", "fixed", "--json"), ("track", "d.csv", "--out", "t.csv")),
    ("track", "d.csv", "--gate", "0.9", "--confirm", "2/3", "--drop", "2", "--max-speed", "9"),
    *(("design", "--lag", "1"), ("design", "--gains", "0.5", "0.1", "--interval", "2")),
    ("design", "--alpha", "0.5", "--states", "3", "--deviation", "5", "--json"),
    ("design", "--tracking-index", "0.4", "--acceleration", "5", "--interval", "1"),
    *(("check", "--new", "n.toml"), ("check", "--draft", "p.tex", "--out", "n.toml")),
    *(("check", "--draft", "p.tex"), ("figure", "patent"), ("figure", "x")),
    *(("campaign",), ("campaign", "x", "y", "--blocks", "9-1", "--jobs", "2")),
)
"""Commands that take no time: nothing of them is derived, judged or measured."""


def fuzz_tables(seed: int, count: int) -> Tally:
    """Claim files of the repository with other values in places of their tables."""
    random = Random(f"tables {seed}")
    return tallied(
        count, lambda: (random_tables(random), {}), lambda text, _: read_claim_text(text, "own")
    )


def fuzz_judged(seed: int, count: int) -> Tally:
    """Files of two claims whose formulas and settings are wrong, that can be read: a reason of
    the judge that is a fault of its own counts as a crash.
    """
    random = Random(f"judged {seed}")
    with Workers([], SECONDS) as workers:

        def attempt(text: str, _: object) -> None:
            claim_file = read_claim_text(text, "own.toml")
            for verdict in judge_file(claim_file, [], seconds=SECONDS, workers=workers):
                if FAULT in verdict.reason:
                    raise RuntimeError(verdict.reason)

        return tallied(count, lambda: (random_claims(random), {}), attempt)


def fuzz_commands(seed: int, count: int) -> Tally:
    """Command lines with broken words, on files with broken cells, in a folder of their own."""
    random = Random(f"commands {seed}")
    with tempfile.TemporaryDirectory() as name, contextlib.chdir(name):
        for example in ("locate", "track"):
            _status([example, "--example", "."])

        def make() -> tuple[str, dict[str, Any]]:
            return json.dumps([random_words(random), random_files(random)]), {}

        def attempt(text: str, _: object) -> None:
            words, contents = json.loads(text)
            for each in Path().iterdir():
                if each.name not in ("observations.csv", "stations.csv", "detections.csv"):
                    each.unlink()
            for file, content in contents.items():
                Path(file).write_bytes(content.encode("utf-8", errors="surrogatepass"))
            status, told = _status(words)
            if "Traceback" in told or status not in (0, 1, 2):
                raise RuntimeError(f"status {status}: {told[-600:]}")
            if status == 2 and not told.strip():
                raise RuntimeError("nothing is said")
            if status == 2:
                raise Refused

        return tallied(count, make, attempt)


def _status(words: Sequence[str]) -> tuple[int, str]:
    """Status and what was said on standard error."""
    said = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
        try:
            status = cli.main(words)
        except SystemExit as end:
            status = end.code if isinstance(end.code, int) else 2
    return status, said.getvalue()


def random_words(random: Random) -> list[str]:
    """A command line, its first word whole."""
    words = list(random.choice(LINES))
    for _ in range(random.choice((0, 0, 1, 1, 2))):
        if len(words) > 1:
            place = random.randrange(1, len(words))
            kind = random.randrange(4)
            if kind == 0:
                del words[place]
            elif kind == 1:
                words.insert(place, random.choice((*NUMBERS, "--json", "--", "-", "--x", "a\0b")))
            elif kind == 2:
                words[place] = random.choice(NUMBERS)
            else:
                words[place] = broken(words[place], CELLS, random)
    if words[0] == "check" and not {"--new", "--draft"} & set(words):
        words.append("--new")  # nothing is judged here
    return words


def random_files(random: Random) -> dict[str, str]:
    """The files that the command lines name, one of them broken."""
    texts = {
        "o.csv": _text("observations.csv"),
        "s.csv": _text("stations.csv"),
        "d.csv": "\n".join(_text("detections.csv").split("\n")[:12]) + "\n",
        "p.tex": r"\begin{equation} \beta = \frac{\alpha^2}{2 - \alpha} \label{b} \end{equation}",
        "c.toml": template("own"),
    }
    name = random.choice(sorted(texts))
    text = texts[name]
    for _ in range(random.randrange(4)):
        if random.random() < 0.5 and name.endswith(".csv"):
            rows = [row.split(",") for row in text.split("\n")]
            row = random.choice(rows)
            row[random.randrange(len(row))] = random.choice(CELLS)
            text = "\n".join(",".join(row) for row in rows)
        else:
            text = broken(text, CELLS, random)
    return {**texts, name: text}


def _text(name: str) -> str:
    return Path(name).read_text(encoding="utf-8")


def random_tables(random: Random) -> str:
    """A claim file with up to three values that are another's, of another kind, or gone."""
    data = tomllib.loads(random.choice(files()))
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        _alter(data, random)
    return dumped(data)


def random_claims(random: Random) -> str:
    """A file that can be read in most cases, with two of its claims; formulas are spliced, random,
    or exchanged.
    """
    data = tomllib.loads(random.choice(_whole_files()))
    claims = random.sample(data["claims"], min(2, len(data["claims"])))
    changed = claims[0]
    # where they are about the same symbols, most that comes of them can be read
    formulas = [
        claim["latex"]
        for claim in data["claims"]
        if "latex" in claim and claim["setting"] == changed["setting"]
    ] or ["1 = 1"]
    if "latex" in changed:
        changed["latex"] = _formula(changed["latex"], formulas, random)
    for field in ("given", "domain", "kind"):
        if random.random() < 0.1:
            other = random.choice(data["claims"])
            changed[field] = (
                [random.choice(formulas)] if field == "given" else other.get(field, "x")
            )
    data["claims"] = claims
    if random.random() < 0.2:
        _alter(data["settings"], random)
    return dumped(data)


@cache
def _whole_files() -> Sequence[str]:
    return tuple(path.read_text(encoding="utf-8") for path in sorted(CLAIMS.rglob("*.toml")))


def _formula(latex: str, others: Sequence[str], random: Random) -> str:
    kind = random.randrange(5)
    other = random.choice(others)
    if kind == 0:
        left, _, right = other.partition("=")
        return f"{latex.partition('=')[0]} = {right or left}"
    if kind == 1:
        return f"{latex} + {random.choice(NUMBERS[2:5])}" if random.random() < 0.2 else other
    if kind == 2:
        return f"{latex.partition('=')[0]} = {random_text(random)}"
    if kind == 3:
        words = latex.split(" ")
        words[random.randrange(len(words))] = random.choice(
            ("0", "-1", "2", "99", r"\frac{1}{0}", r"\sqrt{-1}", "^{-1}", "^{1/2}", "")
        )
        return " ".join(words)
    return broken(latex, ("0", "1", "-", "^2", "^{-1}", r"\ln ", "(", ")"), random)


def _alter(data: Any, random: Random) -> None:
    """One value of nested tables and lists."""
    holders = list(_holders(data))
    if not holders:
        return
    holder = random.choice(holders)
    key = random.choice(list(holder) if isinstance(holder, dict) else range(len(holder)))
    kind = random.randrange(5)
    if kind == 0:
        del holder[key]
    elif kind == 1:
        other = random.choice(holders)
        values = list(other.values() if isinstance(other, dict) else other)
        holder[key] = copy.deepcopy(random.choice(values))
    elif kind == 2 and isinstance(holder, dict):
        holder[random.choice(("x", "", "id", "unit", "a.b", "1", "é"))] = holder.pop(key)
    else:
        holder[key] = copy.deepcopy(random.choice(WRONG))


def _holders(data: Any) -> Iterator[Any]:
    if isinstance(data, dict | list) and data:
        yield data
        for each in data.values() if isinstance(data, dict) else data:
            yield from _holders(each)


def dumped(data: dict[str, Any]) -> str:
    """TOML of plain data: every table of the second level and below in one line."""
    lines = [f"{_key(name)} = {_value(data[name])}" for name in data if not _is_table(data[name])]
    for name, value in data.items():
        if _is_table(value):
            for table in value if isinstance(value, list) else [value]:
                lines.append(f"[[{_key(name)}]]" if isinstance(value, list) else f"[{_key(name)}]")
                lines += [f"{_key(key)} = {_value(each)}" for key, each in table.items()]
    return "\n".join(lines) + "\n"


def _is_table(value: Any) -> bool:
    whole = isinstance(value, list) and value and all(isinstance(each, dict) for each in value)
    return isinstance(value, dict) or bool(whole)


def _key(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _value(value: Any) -> str:
    if isinstance(value, str):
        return _key(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list):
        return f"[{', '.join(map(_value, value))}]"
    if isinstance(value, dict):
        inside = ", ".join(f"{_key(key)} = {_value(each)}" for key, each in value.items())
        return f"{{ {inside} }}"
    if isinstance(value, int) and value.bit_length() > 10000:
        return "1" + "0" * 4000
    return value.isoformat() if isinstance(value, dt.date) else repr(value)
