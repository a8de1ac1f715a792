"""`gainproof track`: the page, the data, the picture, and every file that cannot be used."""

from __future__ import annotations

import csv
import json
import math
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from gainproof import cli
from gainproof.jobs import progress
from gainproof.tracking import CONVERSIONS, FILTERS, tracker
from gainproof.tracking.example import truth
from gainproof.tracking.motion import Estimate

Capture = pytest.CaptureFixture[str]
HEAD = "time [s],range [km],bearing [deg],sigma_range [m],sigma_bearing [deg]\n"
GOOD = "0,20,10,50,1\n"


@pytest.fixture(name="folder")
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> Path:
    """With the example in it."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(["track", "--example", "."]) == 0
    written = capsys.readouterr().out.splitlines()
    assert written == ["detections.csv", "gainproof track detections.csv"]
    return tmp_path


def tracked(*arguments: str, file: str = "detections.csv") -> int:
    return cli.main(["track", file, *arguments])


@pytest.mark.parametrize(
    ("unit", "turn", "count", "asked"),
    [
        ("deg", 2 * math.pi, 8, True),
        ("deg", math.pi, 3, True),
        ("deg", 2 * math.pi, 2, False),
        ("deg", 6.6, 8, False),
        ("deg", 360.0, 8, False),
        ("rad", 2 * math.pi, 8, False),
        ("mrad", 2 * math.pi, 8, False),
    ],
)
def test_bearings_that_look_like_radians_are_asked_about(
    unit: str, turn: float, count: int, asked: bool, tmp_path: Path, capsys: Capture
) -> None:
    """All around a radar, the last one at the whole turn."""
    rows = [f"{5 * i},20,{turn * (i + 1) / count:.6f},50" for i in range(count)]
    head = f"time [s],range [km],bearing [{unit}],sigma_range [m]"
    file = tmp_path / "d.csv"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    words = f"between {turn / count:.3g} and {turn:.3g} deg: are these radians?"
    for more in ((), ("--json",)):
        tracked("--sigma-bearing", "1", *more, file=str(file))
        assert (words in " ".join(capsys.readouterr().out.split())) == asked


def refused(capsys: Capture, *arguments: str, file: str = "d.csv") -> str:
    """The message of status 2."""
    assert tracked(*arguments, file=file) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err


@pytest.mark.usefixtures("folder")
def test_the_example_has_its_four_targets(capsys: Capture) -> None:
    assert tracked("--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert len(told["tracks"]) == 4
    found = []
    for track in told["tracks"]:
        state, deviation = track["state"], track["deviation"]
        off = truth(track["last_s"]) - [state["x_m"], state["y_m"]]
        near = int(np.nanargmin(np.hypot(*off.T)))
        found.append(near)
        assert (np.abs(off[near]) < 3 * np.array([deviation["x_m"], deviation["y_m"]])).all()
    assert sorted(found) == [0, 1, 2, 3]


@pytest.mark.usefixtures("folder")
def test_every_detection_is_told_with_its_track_or_unassigned(capsys: Capture) -> None:
    """Of a file whose scans stand in an order that is not its own inverse: that of bearings."""
    head, *rest = Path("detections.csv").read_text().splitlines()
    rest.sort(key=lambda line: [float(cell or 0) for cell in line.split(",")[:3:2]])
    Path("detections.csv").write_text("\n".join([head, *rest]) + "\n")
    assert tracked("--out", "tracks.csv", "--json") == 0
    told = json.loads(capsys.readouterr().out)
    given = Path("detections.csv").read_text().splitlines()
    lines = [number for number, line in enumerate(given, 1) if number > 1 and ",,,," not in line]
    with Path("tracks.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    assert [int(row["line"]) for row in rows] == lines
    assert told["detections"] == [
        {
            "line": int(row["line"]),
            "track": row["track"] if row["track"][0] == "u" else int(row["track"]),
        }
        for row in rows
    ]
    for row in rows:
        time, far, bearing, *_ = given[int(row["line"]) - 1].split(",")
        assert float(row["time [s]"]) == float(time)
        assert float(row["range [m]"]) == pytest.approx(1e3 * float(far))
        assert float(row["bearing [deg]"]) == pytest.approx(float(bearing))
        assert (row["x [m]"] == "") == (row["track"] == "unassigned")
    for track in told["tracks"]:
        scans = round((track["last_s"] - track["first_s"]) / 5) + 1
        assert track["missed"] == scans - track["detections"]
    counts = {track["track"]: track["detections"] for track in told["tracks"]}
    for number, count in counts.items():
        assert sum(row["track"] == str(number) for row in rows) == count
    assert told["files"] == ["tracks.csv"]


@pytest.mark.alike
@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("name", FILTERS)
def test_every_filter_has_a_page(name: str, capsys: Capture) -> None:
    assert tracked("--filter", name) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == f"{name} filter, modified-unbiased conversion, gate of 99.9 %"
    assert "158 detections: 140 in 4 tracks, 18 unassigned" in lines[1]
    assert max(map(len, lines)) <= 96


@pytest.mark.alike
@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("name", CONVERSIONS)
def test_every_conversion_finds_the_four(name: str, capsys: Capture) -> None:
    assert tracked("--conversion", name, "--json") == 0
    assert len(json.loads(capsys.readouterr().out)["tracks"]) == 4


@pytest.mark.usefixtures("folder")
def test_units_and_deviations_for_all(capsys: Capture) -> None:
    """Minutes, metres, radians; the deviations as options."""
    rows = [line.split(",") for line in Path("detections.csv").read_text().splitlines()[1:]]
    lines = ["bearing [rad],time [min],range [m]"]
    for time, far, bearing, *_ in rows:
        if far:
            lines.append(
                f"{math.radians(float(bearing))!r},{float(time) / 60!r},{float(far) * 1e3!r}"
            )
        else:
            lines.append(f",{float(time) / 60!r},")
    Path("d.csv").write_text("\n".join(lines) + "\n")
    sigmas = ["--sigma-range", "50", "--sigma-bearing", "1"]
    told = []
    for arguments in (["--json"], ["--json", *sigmas]):
        file = "d.csv" if len(arguments) > 1 else "detections.csv"
        assert tracked(*arguments, file=file) == 0
        told.append(json.loads(capsys.readouterr().out)["tracks"])
    for one, other in zip(*told, strict=True):
        assert one["detections"] == other["detections"]
        assert one["state"] == pytest.approx(other["state"], rel=1e-6)


@pytest.mark.usefixtures("folder")
def test_the_picture(capsys: Capture) -> None:
    pytest.importorskip("matplotlib")
    assert tracked("--plot", "map.svg") == 0
    assert capsys.readouterr().out.splitlines()[-1] == "map.svg"
    assert ET.fromstring(Path("map.svg").read_text()).tag.endswith("svg")
    assert [path.name for path in Path().glob("map.*")] == ["map.svg"]


@pytest.mark.usefixtures("folder")
def test_scans_that_would_fill_the_memory_are_refused(capsys: Capture) -> None:
    rows = [
        f"{time},{20 + i / 1e4},{10 + i / 1e4},5000,30\n" for time in (0, 5) for i in range(1500)
    ]
    Path("d.csv").write_text(HEAD + "".join(rows))
    assert "pairs of tracks and detections in one scan, at most 2000000" in refused(capsys)


@pytest.mark.usefixtures("folder")
def test_long_work_tells_how_far_it_is(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    assert tracked() == 0
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(progress, "EVERY", 0.0)
    assert tracked("--json") == 0
    told = capsys.readouterr()
    assert json.loads(told.out)["tracks"]
    assert "s] 1 of 40 scans, 3 tracks and beginnings" in told.err
    assert "s] 40 of 40 scans, " in told.err


@pytest.mark.usefixtures("folder")
def test_where_nothing_is_followed_the_status_is_1(capsys: Capture) -> None:
    Path("d.csv").write_text(HEAD + GOOD + "5,,,,\n10,,,,\n")
    assert tracked("--out", "t.csv", file="d.csv") == 1
    out = capsys.readouterr().out
    assert "no track: nothing was detected 3 times in 4 scans" in out
    assert "3 scans, 5 s apart (2 empty); 1 detection: 0 in 0 tracks, 1 unassigned." in out
    assert Path("t.csv").read_text().splitlines()[1].startswith("2,0,20000,10,unassigned,")
    Path("e.csv").write_text(HEAD + "0,,,,\n")
    assert tracked(file="e.csv") == 1


@pytest.mark.usefixtures("folder")
def test_gains_that_are_not_stable_are_told(capsys: Capture) -> None:
    assert tracked("--filter", "first-order-constant", "--nominal-range", "400e3") == 0
    assert "updates with exact gains: those of first order were not stable with alpha at" in (
        capsys.readouterr().out.replace("\n  ", " ")
    )


@pytest.mark.alike
@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("rows", "message"),
    [
        (
            "5,20,10,50,1\n0,21,10,50,1\n",
            "line 3, column 1 (time): wanted rows in the order of time",
        ),
        (GOOD + GOOD, "line 3, column 2 (range): the same detection stands already in line 2"),
        (GOOD + "0,,,,\n", "line 3, column 1 (time): a scan without a detection, and line 2 has"),
        ("0,,,,\n0,,,,\n", "line 2, column 1 (time): a scan without a detection, and line 3 has"),
        ("0,20,,50,1\n", "line 2, column 3 (bearing): the cell is empty, range has a number"),
        ("0,,10,50,1\n", "line 2, column 2 (range): the cell is empty, bearing has a number"),
        ("0,nan,10,50,1\n", "line 2, column 2 (range): wanted a finite number, got nan"),
        ("nan,20,10,50,1\n", "line 2, column 1 (time): wanted a finite number, got nan"),
        ("0,20,nan,50,1\n", "line 2, column 3 (bearing): wanted a finite number, got nan"),
        ("0,0,10,50,1\n", "line 2, column 2 (range): wanted a number above 0, got 0"),
        ("0,-20,10,50,1\n", "line 2, column 2 (range): wanted a number above 0, got -20"),
        ("0,20,10,0,1\n", "line 2, column 4 (sigma_range): wanted a number above 0, got 0"),
        ("0,20,10,50,-1\n", "line 2, column 5 (sigma_bearing): wanted a number above 0, got -1"),
        ("0,20,10,,1\n", "line 2, column 4 (sigma_range): the cell is empty"),
        ("0,20,10,50,\n", "line 2, column 5 (sigma_bearing): the cell is empty"),
        (
            GOOD + "5,20,10,50,115\n",
            "column 5 (sigma_bearing): wanted a number from 5.7296e-08 to 114.59 deg, got 115",
        ),
        ("0,20,370,50,1\n", "line 2, column 3 (bearing): wanted a bearing within one turn"),
        ("0,1e15,10,50,1\n", "line 2, column 2 (range): wanted a number from 1e-12 to 1e+09 km"),
        ("1e12,20,10,50,1\n", "line 2, column 1 (time): wanted a time of magnitude up to 1e+11 s"),
        ("1e12,,,,\n", "line 2, column 1 (time): wanted a time of magnitude up to 1e+11 s"),
        (GOOD + "1e-9,20,11,50,1\n", "line 3, column 1 (time): scans are at least 1e-06 s apart"),
        (GOOD + "1e-9,,,,\n", "line 3, column 1 (time): scans are at least 1e-06 s apart"),
        ("", "there is no line below the column names"),
        ("0,20,10,50\n", "line 2: wanted 5 cells, got 4"),
    ],
)
def test_files_that_cannot_be_used_are_named(rows: str, message: str, capsys: Capture) -> None:
    Path("d.csv").write_text(HEAD + rows)
    told = refused(capsys)
    assert told.startswith("gainproof: d.csv")
    assert message in told


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("head", "message"),
    [
        ("time [s],range [km]\n0,20\n", "there is no column bearing"),
        (
            "time [s],range [km],bearing [deg]\n0,20,10\n",
            "no column sigma_range; wanted it, or --sig",
        ),
        ("time,range [km],bearing [deg]\n0,20,10\n", "time has no unit"),
        ("time [s],range [km],bearing [m]\n0,20,10\n", "the unit of bearing is one of [deg]"),
        (
            "time [s],range [km],baering [deg]\n0,20,10\n",
            "no column is called 'baering'; known: bearing",
        ),
    ],
)
def test_headers_that_cannot_be_used_are_named(head: str, message: str, capsys: Capture) -> None:
    Path("d.csv").write_text(head)
    assert message in refused(capsys)


@pytest.mark.alike
@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--filter", "kalmann"], "no filter is called 'kalmann'; nearest: kalman"),
        (["--conversion", "unbiast"], "nearest: unbiased"),
        (["--gate", "1"], "probability between 0 and 1, at least"),
        (["--gate", "x"], "--gate takes a number, got 'x'"),
        (["--acceleration", "nan"], "--acceleration takes a finite number"),
        (["--acceleration", "-1"], "the acceleration is between"),
        (["--confirm", "3"], "--confirm takes M/N, as 3/4"),
        (["--confirm", "5/4"], "M from 2 to N and N up to 64, got 5 in 4"),
        (["--drop", "0"], "dropped after 1 to 64"),
        (["--drop", "1.5"], "--drop takes a whole number"),
        (["--sigma-range", "50"], "a column sigma_range beside --sigma-range: which holds?"),
        (
            ["--sigma-bearing", "200"],
            "--sigma-bearing takes a number from 5.7296e-08 to 114.59 degrees, got 200",
        ),
        (["--sigma-bearing", "114.592"], "from 5.7296e-08 to 114.59 degrees, got 114.592"),
        (["--sigma-bearing", "114.59"], "a column sigma_bearing beside --sigma-bearing"),
        (["--sigma-bearing", "6e-8"], "a column sigma_bearing beside --sigma-bearing"),
        (["--plot", "x.pdf"], "--plot takes a name that ends in .svg or .png"),
        (["--out", "."], "cannot be written"),
        (["--example", "x"], "--example writes a file and tracks nothing"),
    ],
)
def test_options_that_cannot_be_used_are_named(
    arguments: list[str], message: str, capsys: Capture
) -> None:
    assert message in refused(capsys, *arguments, file="detections.csv")


@pytest.mark.usefixtures("folder")
def test_without_a_file_or_scipy_it_is_said_how_to_get_them(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert cli.main(["track"]) == 2
    assert "`gainproof track --example DIR`" in capsys.readouterr().err
    assert "nowhere.csv: cannot be read: No such file" in refused(capsys, file="nowhere.csv")
    monkeypatch.setitem(sys.modules, "scipy", None)
    assert "pip install 'gainproof[tracking]'" in refused(capsys, file="detections.csv")


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("name", FILTERS)
@pytest.mark.parametrize("conversion", CONVERSIONS)
def test_variances_that_no_digits_hold_are_refused(
    name: str, conversion: str, capsys: Capture
) -> None:
    """A range to a micrometre, across it 10 km: the smaller variance is lost in x and y, and a
    filter's own fell below 0.
    """
    rows = [f"{5 * i},1e9,{10 * i},50,6e-7\n" for i in range(3)]
    rows += [f"{5 * i},1e9,{10 * i},1e-6,6e-7\n" for i in range(3, 9)]
    Path("d.csv").write_text(HEAD + "".join(rows))
    told = refused(capsys, "--json", "--filter", name, "--conversion", conversion)
    assert "d.csv, line 5, column 5 (sigma_bearing): " in told
    assert "at most 1e+13 times" in told


@pytest.mark.usefixtures("folder")
def test_a_variance_below_0_is_refused_with_its_detection(
    capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A filter that goes wrong: gains that leave no variance, in the third scan."""
    monkeypatch.setattr(
        tracker, "updated", lambda before, *_: Estimate(before.state, -before.covariance)
    )
    Path("d.csv").write_text(HEAD + "".join(f"{5 * i},20,10,50,1\n" for i in range(5)))
    told = refused(capsys, "--json")
    assert "d.csv, line 4: the variance of x after this detection is to be above 0" in told
    assert "got -" in told


@pytest.mark.usefixtures("folder")
def test_times_are_told_as_they_were_read(capsys: Capture) -> None:
    times = (
        "999999999.1",
        "999999999.2",
        "999999999.3",
        "1700000000",
        "1700000000.25",
        "99999999999",
    )
    Path("d.csv").write_text(HEAD + "".join(f"{time},20,10,50,1\n" for time in times))
    assert tracked("--out", "t.csv", "--json", file="d.csv") == 0
    (track,) = json.loads(capsys.readouterr().out)["tracks"][:1]
    assert [track["first_s"], track["last_s"]] == [999999999.1, 99999999999]
    with Path("t.csv").open() as stream:
        assert tuple(row["time [s]"] for row in csv.DictReader(stream)) == times
    assert tracked(file="d.csv") == 0
    assert "999999999.1  99999999999  " in capsys.readouterr().out


@pytest.mark.usefixtures("folder")
def test_the_time_of_the_first_scan_changes_nothing(capsys: Capture) -> None:
    """Unix time, in steps that float64 has exactly."""
    head, *rest = Path("detections.csv").read_text().splitlines()
    cells = [line.split(",", 1) for line in rest]
    moved = [f"{int(time) + 1_700_000_000},{others}" for time, others in cells]
    Path("d.csv").write_text("\n".join([head, *moved]) + "\n")
    told = []
    for file in ("detections.csv", "d.csv"):
        assert tracked("--json", file=file) == 0
        told.append(json.loads(capsys.readouterr().out))
    for first, second in zip(*(each["tracks"] for each in told), strict=True):
        for name in ("first_s", "last_s"):
            assert second.pop(name) == first.pop(name) + 1_700_000_000
        assert first == second
    assert told[0]["detections"] == told[1]["detections"]
