"""The page, the table and the data of `gainproof bench`, from results made by hand."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from gainproof.bad_input import BadInputError
from gainproof.bench import memory, results, running, table
from gainproof.bench.columns import RATIOS, ratio_text
from gainproof.bench.measure import Figures, Options
from gainproof.bench.page import HEADINGS, page
from gainproof.bench.results import Results
from gainproof.bench.subjects import measured_kernels
from gainproof.bench.timing import best_times
from gainproof.cli import main

SUBJECT = "least-squares-mean"
NAMES = [column.over for column in RATIOS] + [column.under for column in RATIOS]
Capture = pytest.CaptureFixture[str]


def row(kernel: str = "gain", **changes: Any) -> dict[str, Any]:
    error = {"name": "alpha", "worst": 0.9, "ulps": 1.4, "proved": 1.51, "outside": 0}
    made = {
        "subject": SUBJECT,
        "kernel": kernel,
        "domain": ["sample_number whole: 1 to 9e+15"],
        "inputs": 1,
        "outputs": 1,
        "cancellations": ["a <b> & c, condition number 3"],
        "seconds": {name: 0.001 * (1 + place) for place, name in enumerate(dict.fromkeys(NAMES))},
        "missing": {},
        "errors": [error],
    }
    return {**made, **changes}


def made(*rows: dict[str, Any]) -> Results:
    conditions = {
        "machine": {"C": "cc 12, -O3", "processor": "one <of> many"},
        "points": 1000,
        "rounds": 15,
        "seconds a call": 1.0,
        "settings": {"workers": 2, "constant": None, "numbers": 1, "every_rival": True},
        "code": ["a"],
    }
    return Results(conditions, {"reading": 20.0}, 0.5, (SUBJECT,), list(rows), [SUBJECT])


BROKEN = row(
    "second",
    errors=[
        {"name": "fine", "worst": 8.0, "ulps": 9.0, "proved": 9.0, "outside": 0},
        {"name": "beta", "worst": "inf", "ulps": 0.0, "proved": 2.0, "outside": 3},
    ],
)


class Tags(HTMLParser):
    """What is open at the end, and what is read from elsewhere."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.outside: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.outside += [str(value) for name, value in attrs if name in ("src", "href", "srcset")]
        if tag in ("script", "link", "iframe", "object", "img"):
            self.outside.append(tag)
        if tag not in ("meta", "br", "wbr"):
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        pass

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def test_a_page_is_whole_and_needs_no_network() -> None:
    text = page(made(row(), row("other", seconds={"kernel": 0.001}, missing={"JAX": "a < b"})))
    read = Tags()
    read.feed(text)
    assert (read.open, read.outside) == ([], [])
    assert "url(" not in text
    assert "@import" not in text
    assert "a &lt;b&gt; &amp; c, condition number 3" in text
    assert "JAX, 1 kernels: a &lt; b" in text
    assert text.count("<svg") == 2
    for body in re.findall(r"<tr><th scope=\"row\">\w.*?</tr>", text):
        width = body.count("<t") - 1 + sum(int(n) - 1 for n in re.findall(r'colspan="(\d+)"', body))
        assert width == len(HEADINGS) + 1, body
    meanings = set(re.findall("<dt>(.*?)</dt>", text))
    assert {heading for heading in HEADINGS if heading not in meanings} == set()


@pytest.mark.parametrize("rows", [(), (row(),), (row(seconds={"kernel": 1e-3}),)])
def test_pages_of_few_rows(rows: tuple[dict[str, Any], ...]) -> None:
    read = Tags()
    read.feed(page(made(*rows)))
    assert read.open == []


def test_an_unfinished_page_says_so() -> None:
    assert "not finished" not in page(made(row()))
    assert "not finished" in page(replace(made(row()), finished=[]))


def test_a_kernel_outside_its_bound_is_shouted() -> None:
    """Though another output has the greater bound, and an infinite error is no number of JSON."""
    good, bad = made(row()), made(row(), BROKEN)
    assert 'class="alarm"' not in page(good)
    assert "at no point was an error greater than is proved" in page(good)
    assert "at no point" not in page(bad)
    assert 'role="alert"' in page(bad)
    assert f"{SUBJECT} second (beta)" in page(bad)
    assert '<tr class="alarm"><th scope="row">second' in page(bad)
    assert 'class="outside"' in page(bad)
    assert table.alarm(good) == ""
    assert f"{SUBJECT} second: beta" in table.alarm(bad)
    assert "OUTSIDE" in table.line(BROKEN)
    assert json.loads(results.as_json(bad))["rows"][1]["errors"][1]["worst"] == "inf"


def test_the_table_fits_a_terminal_of_100_columns() -> None:
    found = made(row(), row("predicted_covariance_by_tracking_index"))
    lines = [*table.opening(found), *"\n".join(map(table.line, found.rows)).splitlines()]
    assert max(map(len, lines)) < 100
    headings = next(line for line in lines if line.startswith("kernel"))
    for heading in headings.split()[1:]:
        assert sum(line.startswith(f"{heading} ") for line in lines) == 1, heading
    assert {len(line) for line in lines[lines.index(headings) :][:2]} == {len(headings)}


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (None, "-"),
        (0.254, "0.25"),
        (9.994, "9.99"),
        (12.34, "12.3"),
        (1234.5, "1,234"),
        (2e4, "20k"),
    ],
)
def test_ratios_as_text(value: float | None, text: str) -> None:
    assert ratio_text(value) == text


def test_slow_calls_have_fewer_rounds(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = {"slow": 0, "fast": 0}
    now = [0.0]
    monkeypatch.setattr("gainproof.bench.timing.time.perf_counter", lambda: now[0])
    monkeypatch.setattr("gainproof.bench.timing.time.thread_time", lambda: now[0])

    def call(name: str, seconds: float) -> None:
        counted[name] += 1
        now[0] += seconds

    found = best_times(
        {"slow": lambda: call("slow", 3.0), "fast": lambda: call("fast", 0.25)}, 15, 2.0
    )
    assert found == {"slow": 3.0, "fast": 0.25}
    assert counted == {"slow": 3, "fast": 8}


def test_bandwidth_is_measured() -> None:
    found = memory.bandwidth(10_000)
    assert set(found) == {"reading", "writing", "copying"}
    assert all(0 < value < 1e5 for value in found.values())


def run(monkeypatch: pytest.MonkeyPatch, *options: str) -> tuple[int, list[str]]:
    """The status of the command, and the kernels measured, by a measurement without time."""
    seen = list[str]()

    def figures(item: Any, folder: Path, how: Options) -> Figures:
        assert how.every_rival
        seen.append(item.kernel.name)
        if len(seen) > 1 and "--break" in options:
            raise KeyboardInterrupt
        return Figures({"kernel": 0.001}, {}, ())

    def plain(item: Any, found: Figures, remaining: Any) -> dict[str, Any]:
        return BROKEN if "--spoil" in options else row(item.kernel.name)

    monkeypatch.setattr(running, "figures", figures)
    monkeypatch.setattr(running, "row", plain)
    monkeypatch.setattr(results, "bandwidth", lambda: {"reading": 1.0})
    given = [option for option in options if option not in ("--break", "--spoil")]
    return main(["bench", SUBJECT, *given]), seen


def test_a_run_is_continued_and_writes_both_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    names = [item.kernel.name for item in measured_kernels([SUBJECT])]
    assert len(names) > 1
    place = str(tmp_path / "measured")
    status, seen = run(monkeypatch, "--html", place, "--break")
    assert (status, seen) == (130, names[:2])
    kept = json.loads((tmp_path / "measured" / "bench.json").read_text("utf-8"))
    assert [each["kernel"] for each in kept["rows"]] == names[:1]
    status, seen = run(monkeypatch, "--html", place, "--resume")
    assert (status, seen) == (0, names[1:])
    text = (tmp_path / "measured" / "bench.html").read_text("utf-8")
    assert "not finished" not in text
    assert run(monkeypatch, "--html", place, "--resume") == (0, [])
    assert run(monkeypatch, "--html", place)[1] == names, "begun anew"
    capsys.readouterr()
    with monkeypatch.context() as changed:
        changed.setattr(results, "SIZE", 7)
        assert run(monkeypatch, "--html", place, "--resume") == (2, [])
    assert "measured with another points" in capsys.readouterr().err


def test_a_fault_is_the_status(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    assert run(monkeypatch, "--json", str(tmp_path / "x.json"), "--spoil")[0] == 1
    assert "OUTSIDE THE PROVED BOUND" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--resume"], "--resume wants a file"),
        (["--html", "x.html", "--json", "x.html"], "name one file"),
        (["--json", "sub"], "cannot be written"),
        (["--html", ""], "--html: a name is wanted"),
        (["--json", "other.json", "--resume"], "is wanted"),
        (["--against", "size", "--json", "y.json"], "leave --html"),
    ],
)
def test_bad_places(
    options: list[str],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
) -> None:
    """All of it is told before anything is measured."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sub").mkdir()
    (tmp_path / "other.json").write_text('{"format": 3}', encoding="utf-8")
    monkeypatch.setattr(running, "figures", None)
    monkeypatch.setattr(results, "bandwidth", dict)
    assert main(["bench", SUBJECT, *options]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("rows", [3, [{}], [3]])
def test_data_of_another_shape_are_refused(rows: Any, tmp_path: Path) -> None:
    now = results.conditions(Options())
    data = {"format": results.FORMAT, "conditions": now, "rows": rows, "finished": []}
    path = tmp_path / "bench.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    with pytest.raises(BadInputError, match="not as `gainproof bench --json` writes them"):
        results.begun(Options(), [SUBJECT], path)
