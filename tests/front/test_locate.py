"""`gainproof locate`: the page, the data, the picture, and every file that cannot be used."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from one_of_each import cases

from gainproof import cli
from gainproof.location.errors import DivergedError
from gainproof.location.example import BIASES, POSITION, VELOCITY
from gainproof.location.methods import METHODS
from gainproof.location.page import plain_failure
from gainproof.location.result import Convergence

Capture = pytest.CaptureFixture[str]
HEAD = "station,range [km],range_rate [m/s],sigma_range [m],sigma_range_rate [m/s]"
BESIDE = """\
S1,11.1803,196.9,10,0.1
S2,11.1803,89.3,10,0.1
S3,18.0278,-11.1,10,0.1
S4,26.9258,-52.0,10,0.1
S5,36.4005,-71.5,10,0.1
"""
ROW = "station,x [km],y [m]\nS1,0,0\nS2,10,0\nS3,20,0\nS4,30,0\nS5,40,0\n"


@pytest.fixture(name="folder")
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> Path:
    """With the example in it."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(["locate", "--example", "."]) == 0
    written = capsys.readouterr().out.splitlines()
    assert written[:2] == ["observations.csv", "stations.csv"]
    assert written[2] == "gainproof locate observations.csv stations.csv"
    return tmp_path


def located(
    *arguments: str, observed: str = "observations.csv", given: str = "stations.csv"
) -> int:
    return cli.main(["locate", observed, given, *arguments])


def refused(capsys: Capture, *arguments: str, observed: str = "o.csv", given: str = "s.csv") -> str:
    """The message of status 2."""
    assert located(*arguments, observed=observed, given=given) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    return captured.err


@pytest.mark.usefixtures("folder")
def test_the_example_is_found_within_its_errors(capsys: Capture) -> None:
    assert located("--json") == 0
    told = json.loads(capsys.readouterr().out)
    off = np.array(told["position_m"]) - POSITION
    assert (np.abs(off) < 3 * np.array(told["position_deviation_m"])).all()
    off = np.array(told["velocity_m_s"]) - VELOCITY
    assert (np.abs(off) < 3 * np.array(told["velocity_deviation_m_s"])).all()
    for bias in told["biases"]:
        true = BIASES[int(bias["station"][1]) - 1]
        assert abs(bias["bias_m"] - true) < 3 * bias["deviation_m"]
    clean = [each["station"] for each in told["selection"]["ranges"] if each["clean"]]
    assert clean == ["B1", "B2"]
    assert told["covariance_of"] == ["x_m", "y_m", "vx_m_s", "vy_m_s", "bias_B3_m", "bias_B4_m"]
    variances = np.diag(told["covariance"])
    assert np.allclose(np.sqrt(variances[:2]), told["position_deviation_m"])
    assert told["bias_detection"]["method"] == "bias-detection"
    assert told["convergence"]["ended"] == "converged"


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("method", [method.name for method in METHODS])
def test_every_method_has_a_page(method: str, capsys: Capture) -> None:
    assert located("--method", method) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith(f"{method}: ")
    assert lines[3].split()[::2][:2] == ["x", "m"]
    assert any(line.startswith("vx") for line in lines) == (method != "range-only")
    assert max(map(len, lines)) <= 92


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("terminal", [60, 80, 120])
def test_a_page_has_the_width_of_the_terminal(
    terminal: int, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("COLUMNS", str(terminal))
    assert located() == 0
    sentences = [line for line in capsys.readouterr().out.splitlines() if line.count("  ") == 0]
    assert terminal - 15 < max(map(len, sentences)) <= terminal


@pytest.mark.usefixtures("folder")
def test_units_are_read_and_lines_passed_over(capsys: Capture) -> None:
    """Everything in other units, a mark of the byte order, comments, empty lines, another order."""
    rows = [line.split(",") for line in Path("observations.csv").read_text().splitlines()[1:]]
    lines = ["sigma_range_rate [cm/s], station ,range [mm],range_rate [km/h],sigma_range [cm]", ""]
    for name, distance, rate, _, _ in rows[::-1]:
        lines.append(f"10,{name},{float(distance) * 1e6:.3f},{float(rate) * 3.6!r},1000")
    Path("o.csv").write_text(
        "\ufeff# remark\n" + "\n".join(lines) + "\n\n# end\n", encoding="utf-8"
    )
    assert located("--json") == 0
    first = json.loads(capsys.readouterr().out)
    assert located("--json", observed="o.csv") == 0
    second = json.loads(capsys.readouterr().out)
    assert np.allclose(first["position_m"], second["position_m"], rtol=1e-9)
    assert np.allclose(first["velocity_m_s"][0], second["velocity_m_s"][0], rtol=1e-9)


@pytest.mark.usefixtures("folder")
def test_a_covariance_file_says_the_same_as_columns(capsys: Capture) -> None:
    text = Path("observations.csv").read_text()
    rows = [line.split(",")[:3] for line in text.splitlines()]
    Path("o.csv").write_text("\n".join(",".join(row) for row in rows) + "\n")
    noise = np.diag([100.0] * 4 + [0.01] * 4)
    noise[0, 4] = noise[4, 0] = 0.5
    Path("v.csv").write_text("\n".join(",".join(map(repr, row)) for row in noise.tolist()) + "\n")
    tail = ["correlation", "0.5", "", "0", ""]
    joined = [f"{line},{cell}" for line, cell in zip(text.splitlines(), tail, strict=True)]
    Path("c.csv").write_text("\n".join(joined) + "\n")
    told = []
    for arguments, file in ((("--covariance", "v.csv"), "o.csv"), ((), "c.csv")):
        assert located("--json", *arguments, observed=file) == 0
        told.append(json.loads(capsys.readouterr().out))
    assert np.allclose(told[0]["covariance"], told[1]["covariance"], rtol=1e-9)
    assert located("--json") == 0
    without = json.loads(capsys.readouterr().out)
    assert not np.allclose(without["covariance"][0], told[0]["covariance"][0], rtol=1e-3)


@pytest.mark.usefixtures("folder")
def test_the_mirror_image_is_told_and_can_be_chosen(capsys: Capture) -> None:
    Path("o.csv").write_text(f"{HEAD}\n{BESIDE}")
    Path("s.csv").write_text(ROW)
    files = {"observed": "o.csv", "given": "s.csv"}
    assert located(**files) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "the mirror image in the line of the stations, explains the observations as well" in text
    assert located("--near", "5000,-10000", "--json", **files) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["position_m"][1] < 0 < told["others"][0]["position_m"][1]


@pytest.mark.usefixtures("folder")
def test_where_there_is_no_estimate_status_is_1_and_data_say_why(capsys: Capture) -> None:
    rows = Path("observations.csv").read_text().splitlines()
    Path("o.csv").write_text("\n".join(rows[:4]) + "\n")
    assert located("--json", observed="o.csv") == 1
    captured = capsys.readouterr()
    assert "no estimate: unknown-reduction in 2 dimensions needs at least 4" in captured.err
    told = json.loads(captured.out)
    assert (told["error"], told["need"], told["have"]) == ("too few observations", 4, 3)
    still = [",".join([*row.split(",")[:2], "0", *row.split(",")[3:]]) for row in rows[1:]]
    Path("o.csv").write_text("\n".join([rows[0], *still]) + "\n")
    assert located("--json", "--method", "doppler-only", observed="o.csv") == 1
    told = json.loads(capsys.readouterr().out)
    assert told["error"] == "not observable"
    assert [each["words"] for each in told["directions"]] == [
        "position along x",
        "position along y",
    ]


@pytest.mark.parametrize("ending", cases(("svg", "png"), lambda ending: ending == "svg"))
def test_the_picture(folder: Path, ending: str, capsys: Capture) -> None:
    pytest.importorskip("matplotlib")
    name = f"plot.{ending}"
    assert located("--plot", name) == 0
    assert capsys.readouterr().out.splitlines()[-1] == name
    first = (folder / name).read_bytes()
    if ending == "svg":
        assert ET.fromstring(first.decode()).tag.endswith("svg")
        assert b"<dc:date>" not in first
    assert located("--plot", name, "--json") == 0
    assert json.loads(capsys.readouterr().out)["files"] == [name]
    assert (folder / name).read_bytes() == first


@pytest.mark.alike
@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("observed", "given", "message"),
    [
        (f"{HEAD}\nS1,1,2,3", ROW, "o.csv, line 2: wanted 5 cells, got 4"),
        (f"{HEAD}\nS9,1,2,3,4", ROW, "line 2, column 1 (station): s.csv has no station S9"),
        (
            f"{HEAD}\n{BESIDE}S1,1,2,3,4",
            ROW,
            "line 7, column 1 (station): S1 observes already in line 2",
        ),
        (f"{HEAD}\nS1,nan,2,3,4", ROW, "line 2, column 2 (range): wanted a finite number, got nan"),
        (f"{HEAD}\nS1,0,2,3,4", ROW, "line 2, column 2 (range): wanted a number above 0, got 0"),
        (f"{HEAD}\nS1,1,2,-3,4", ROW, "line 2, column 4 (sigma_range): wanted a number above 0"),
        (f"{HEAD}\nS1,1,fast,3,4", ROW, "column 3 (range_rate): wanted a number, got 'fast'"),
        (
            f"{HEAD}\nS1,1,2,,4",
            ROW,
            "column 4 (sigma_range): the cell is empty, range has a number",
        ),
        (f"{HEAD}\nS1,1e999,2,3,4", ROW, "wanted a finite number, got 1e999"),
        (f"{HEAD}\nS1,1e300,2,3,4", ROW, "ranges of S1 must not be beyond 1e+15"),
        ("station,range,sigma_range [m]\nS1,1,2", ROW, "line 1, column 2: range has no unit"),
        ("station,range [s],sigma_range [m]\nS1,1,2", ROW, "the unit of range is one of [m], [km]"),
        ("station,rnage [m]\nS1,1", ROW, "no column is called 'rnage'; known: range"),
        ("station,range [m]\nS1,1", ROW, "a column range and no column sigma_range"),
        ("station,range [m],range [m]\nS1,1,1", ROW, "column 3: a second column range"),
        ("range [m]\n1", ROW, "line 1: there is no column station"),
        ("station [m]\nS1", ROW, "station holds words, it has no unit"),
        ("", ROW, "o.csv: there is no line of column names"),
        (HEAD, ROW, "o.csv: there is no line below the column names"),
        (
            f"{HEAD}\n{BESIDE}",
            f"{ROW}S1,1,1\n",
            "s.csv, line 7, column 1 (station): S1 stands",
        ),
        (f"{HEAD}\n{BESIDE}", "station,x [m]\nS1,0", "s.csv, line 1: there is no column y"),
        (
            f"{HEAD}\n{BESIDE}",
            ROW.replace("S2,10,0", "S2,10,"),
            "column 3 (y): the cell is empty",
        ),
        (
            f"{HEAD},correlation\nS1,1,2,3,4,1",
            ROW,
            "column 6 (correlation): wanted a number between -1 and 1, got 1.0",
        ),
        (f"{HEAD},correlation\nS1,1,,3,,0.5", ROW, "wanted a range and a range rate with it"),
        ("\0", ROW, "o.csv: cannot be read: is no text"),
        (f"{HEAD}\nS1,1_0,2,3,4", ROW, "column 2 (range): wanted a number, got '1_0'"),
        (f"{HEAD}\nS1,\uff11,2,3,4", ROW, "column 2 (range): wanted a number, got '\uff11'"),
        (f'{HEAD}\n{BESIDE}"#5",1,1,1,1', ROW, "line 7, column 1 (station): a name does not begin"),
        (f"{HEAD}\nS\x1b[31m,1,2,3,4", ROW, "line 2, column 1 (station): a name holds no control"),
        (f'{HEAD}\n"S\n1",1,2,3,4', ROW, "o.csv, line 2: a quoted cell does not end there"),
        (
            f"{HEAD}\nS1,1,2,3,4",
            "station,x [m],y [m],vx [m/s]\nS1,0,0,1",
            "s.csv: there is a column vx and no column vy",
        ),
        (
            HEAD + "".join(f"\nT{i},1,2,3,4" for i in range(1001)),
            "station,x [m],y [m]" + "".join(f"\nT{i},{i},0" for i in range(1001)),
            "o.csv: at most 2000 ranges and range rates are taken, got 2002",
        ),
        (
            f"{HEAD}\n{BESIDE.replace(',10,', ',1e200,', 1)}",
            ROW,
            "line 2, column 4 (sigma_range): a deviation is between 1e-09 and 1e+12 in m and m/s",
        ),
        (
            f"{HEAD}\n{BESIDE.replace(',0.1', ',1e-10', 1)}",
            ROW,
            "line 2, column 5 (sigma_range_rate): a deviation is between",
        ),
    ],
)
def test_files_that_cannot_be_used_are_named_with_their_place(
    observed: str, given: str, message: str, capsys: Capture
) -> None:
    Path("o.csv").write_text(observed, encoding="utf-8")
    Path("s.csv").write_text(given)
    assert message in refused(capsys)


@pytest.mark.usefixtures("folder")
def test_a_name_is_the_same_composed_and_in_parts(capsys: Capture) -> None:
    for file, letter in (("observations.csv", "\u00e9"), ("stations.csv", "e\u0301")):
        text = Path(file).read_text().replace("B1", letter)
        Path(file[0] + ".csv").write_text(text, encoding="utf-8")
    assert located("--json", observed="o.csv", given="s.csv") == 0
    told = json.loads(capsys.readouterr().out)
    assert told["selection"]["ranges"][0]["station"] == "\u00e9"


@pytest.mark.usefixtures("folder")
@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("method", [method.name for method in METHODS])
def test_deviations_at_the_ends_of_what_is_taken_give_numbers(method: str, capsys: Capture) -> None:
    """All data are JSON without NaN, whatever the status."""
    for sigma, of_rate in (("1e-9", "1e12"), ("1e12", "1e-9"), ("1e-9", "1e-9"), ("1e12", "1e12")):
        text = Path("observations.csv").read_text().replace(",10,0.1", f",{sigma},{of_rate}")
        Path("o.csv").write_text(text)
        assert located("--json", "--method", method, observed="o.csv") in (0, 1)
        told = capsys.readouterr().out
        assert "NaN" not in told
        assert "Infinity" not in told


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("matrix", "message"),
    [
        ("1,2\n", "v.csv, line 1: wanted 4 numbers"),
        ("1,0,0,0\n" * 3, "v.csv: wanted 4 rows, got 3"),
        ("1,0,0,x\n", "v.csv, line 1, column 4: wanted a number, got 'x'"),
        ("1,0,0,inf\n", "v.csv, line 1, column 4: wanted a finite number, got inf"),
        (
            "1,0,0,0\n0,1,0,0\n0,0,1,0\n1,0,0,1\n",
            "must be symmetric: the range of S1 with the range rate of S2 has 0.0",
        ),
        (
            "1e300,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,1\n",
            "v.csv: a covariance is at most 1e+24, got 1e+300",
        ),
        (
            "1e-20,0,0,0\n0,1,0,0\n0,0,1,0\n0,0,0,1\n",
            "v.csv: the deviation of the range of S1 is between 1e-09 and 1e+12 in m and m/s",
        ),
        ("1,2,0,0\n2,1,0,0\n0,0,1,0\n0,0,0,1\n", "must be positive definite"),
        (
            "1,0,0,0\n0,-1,0,0\n0,0,1,0\n0,0,0,1\n",
            "the variance of the range of S2 must be above 0",
        ),
    ],
)
def test_a_covariance_that_is_none_is_named(matrix: str, message: str, capsys: Capture) -> None:
    Path("o.csv").write_text("station,range [m],range_rate [m/s]\nS1,1,2\nS2,3,4\n")
    Path("s.csv").write_text(ROW)
    Path("v.csv").write_text(matrix)
    assert message in refused(capsys, "--covariance", "v.csv")


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--method", "dopler-only"], "no method is called 'dopler-only'; nearest: doppler-only"),
        (["--near", "1,2,3"], "--near takes 2 numbers in m"),
        (["--near=1_0,1"], "--near takes numbers, got '1_0'"),
        (["--near=1e16,1"], "--near takes numbers up to 1e+15 m"),
        (["--near=1,-1e300"], "--near takes numbers up to 1e+15 m"),
        (["--near", "1,x"], "--near takes numbers, got 'x'"),
        (["--false-alarm", "1"], "--false-alarm is between 0 and 1, got 1"),
        (["--false-alarm", "nan"], "--false-alarm takes finite numbers"),
        (["--false-alarm", "0.1", "--method", "range-only"], "belongs to unknown-reduction"),
        (["--plot", "x.pdf"], "--plot takes a name that ends in .svg or .png"),
        (["--example", "x"], "--example writes files and locates nothing"),
        (["--covariance", "v.csv"], "a column sigma_range beside --covariance"),
    ],
)
def test_options_that_cannot_be_used_are_named(
    arguments: list[str], message: str, capsys: Capture
) -> None:
    assert message in refused(capsys, *arguments, observed="observations.csv", given="stations.csv")


def test_without_files_it_is_said_how_to_get_some(capsys: Capture) -> None:
    assert cli.main(["locate"]) == 2
    assert "`gainproof locate --example DIR`" in capsys.readouterr().err
    assert cli.main(["locate", "nowhere.csv", "nothing.csv"]) == 2
    assert "nowhere.csv: cannot be read: No such file" in capsys.readouterr().err


def test_data_hold_no_number_that_json_has_not() -> None:
    """An iteration without a step has an infinite length of the last one."""
    ended = Convergence("ran away", 3, 0, float("inf"), float("nan"), 4, 0.5)
    told = plain_failure(DivergedError("no", ended))["convergence"]
    assert (told["step"], told["cost"], told["ratio"]) == (None, None, 0.5)
