"""Range rates as Doppler shifts of a carrier: the same estimate; what is left open is named."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from gainproof import cli
from gainproof.generated.range_doppler import doppler_shift
from gainproof.location.doppler import shift_of_rate

Capture = pytest.CaptureFixture[str]
CARRIER = 9.4e9
LIGHT = 299_792_458.0


@pytest.fixture(name="rows")
def _rows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> list[dict[str, str]]:
    """The example's observations, in its folder."""
    monkeypatch.chdir(tmp_path)
    assert cli.main(["locate", "--example", "."]) == 0
    capsys.readouterr()
    with Path("observations.csv").open(encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def as_shifts(rows: list[dict[str, str]], share: str = "") -> str:
    """The same with the classical formula of a shift, in kHz, and with a correlation."""
    lines = ["station,range [km],sigma_range [m],doppler [kHz],sigma_doppler [Hz],correlation"]
    for row in rows:
        shift = -float(row["range_rate [m/s]"]) * CARRIER / LIGHT / 1e3
        deviation = float(row["sigma_range_rate [m/s]"]) * CARRIER / LIGHT
        own = [row["station"], row["range [km]"], row["sigma_range [m]"]]
        lines.append(",".join([*own, f"{shift:.12f}", f"{deviation:.12f}", share]))
    return "\n".join(lines) + "\n"


def told(capsys: Capture, file: str, *options: str) -> dict[str, list[float]]:
    assert cli.main(["locate", file, "stations.csv", "--json", *options]) == 0
    found: dict[str, list[float]] = json.loads(capsys.readouterr().out)
    return found


def test_shifts_give_what_their_rates_give(rows: list[dict[str, str]], capsys: Capture) -> None:
    Path("d.csv").write_text(as_shifts(rows))
    by_rate = told(capsys, "observations.csv")
    by_shift = told(capsys, "d.csv", "--carrier", "9.4 GHz")
    for name in ("position_m", "velocity_m_s", "position_deviation_m"):
        assert np.allclose(by_shift[name], by_rate[name], rtol=1e-9, atol=1e-6), name


def test_a_column_of_carriers_is_each_rows_own(rows: list[dict[str, str]], capsys: Capture) -> None:
    """Twice the carrier, twice the shift: as of an echo."""
    lines = as_shifts(rows).splitlines()
    lines[0] += ",carrier [MHz]"
    cells = lines[1].split(",")
    cells[3:5] = [f"{2 * float(cell):.12f}" for cell in cells[3:5]]
    lines[1:] = [",".join(cells) + ",18800", *(f"{line},9400" for line in lines[2:])]
    Path("d.csv").write_text("\n".join(lines) + "\n")
    found, wanted = told(capsys, "d.csv"), told(capsys, "observations.csv")
    assert np.allclose(found["position_m"], wanted["position_m"], rtol=1e-9, atol=1e-6)


def test_a_correlation_with_the_shift_is_the_opposite_of_that_with_the_rate(
    rows: list[dict[str, str]], capsys: Capture
) -> None:
    Path("d.csv").write_text(as_shifts(rows, "0.6"))
    head, *lines = Path("observations.csv").read_text().splitlines()
    rates = [f"{head},correlation", *(f"{line},-0.6" for line in lines)]
    Path("r.csv").write_text("\n".join(rates) + "\n")
    found = told(capsys, "d.csv", "--carrier", "9.4 GHz")
    wanted = told(capsys, "r.csv")
    assert np.allclose(found["covariance"], wanted["covariance"], rtol=1e-7, atol=1e-12)


def test_the_shift_of_a_rate_is_that_of_the_printed_kernel() -> None:
    """In space, a target that goes away straight up at 7 m/s, and one that comes."""
    for speed in (7.0, -7.0):
        course = (0.0, 0.0, 500.0, 0.0, 0.0, speed)
        station = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        shift = doppler_shift(*course, *station, CARRIER).doppler_shift
        assert float(shift) / shift_of_rate(CARRIER) == pytest.approx(speed, rel=1e-14)
        assert (float(shift) < 0) is (speed > 0)


@pytest.mark.parametrize(
    ("edit", "options", "why"),
    [
        (("", ""), (), "no column carrier; wanted it, or --carrier"),
        (("", ""), ("--carrier", "9.4"), "--carrier takes a number and one of Hz, kHz, MHz, GHz"),
        (("", ""), ("--carrier", "9.4 THz"), "--carrier takes a number and one of"),
        (("", ""), ("--carrier", "x GHz"), "--carrier takes a number and one of"),
        (("", ""), ("--carrier", "-9.4 GHz"), "--carrier is between 1 Hz"),
        (("", ""), ("--carrier", "nan GHz"), "--carrier"),
        (("doppler [kHz]", "doppler"), ("--carrier", "9.4 GHz"), "column 4: doppler has no unit"),
        (("doppler [kHz]", "doppler [m/s]"), ("--carrier", "9.4 GHz"), "[Hz], [kHz], [MHz], [GHz]"),
        (("sigma_doppler [Hz]", "sigma_range_rate [m/s]"), ("--carrier", "9 GHz"), "sigma_doppler"),
        (("doppler [kHz]", "range_rate [m/s]"), ("--carrier", "9 GHz"), "no column doppler"),
        (("", ""), ("--carrier", "9 GHz", "--covariance", "stations.csv"), "beside --covariance"),
        (("correlation", "carrier [GHz]"), ("--carrier", "9 GHz"), "beside --carrier: which"),
        (("correlation", "carrier [GHz]"), (), "line 2, column 6 (carrier): the cell is empty"),
    ],
)
def test_what_is_left_open_is_named(
    rows: list[dict[str, str]],
    edit: tuple[str, str],
    options: tuple[str, ...],
    why: str,
    capsys: Capture,
) -> None:
    Path("d.csv").write_text(as_shifts(rows).replace(*edit, 1) if edit[0] else as_shifts(rows))
    assert cli.main(["locate", "d.csv", "stations.csv", *options]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert why in captured.err


def test_cells_that_are_missing_or_twice_are_named(
    rows: list[dict[str, str]], capsys: Capture
) -> None:
    head = "station,doppler [Hz],sigma_doppler [Hz],carrier [GHz],range_rate [m/s]"
    given = ["carrier", "sigma_doppler", "range_rate", "carrier is", "deviation is"]
    for line, why in zip(
        ("B1,100,3,,", "B1,100,,9.4,", "B1,100,3,9.4,7", "B1,100,3,1e10,", "B1,1,1e-9,9.4,"),
        given,
        strict=True,
    ):
        Path("d.csv").write_text(f"{head},sigma_range_rate [m/s]\n{line},\n")
        assert cli.main(["locate", "d.csv", "stations.csv"]) == 2
        message = capsys.readouterr().err
        assert "d.csv, line 2, column" in message
        assert why in message
    assert rows


@pytest.mark.parametrize(
    ("shift", "carrier"), [("-9400", "9.4 kHz"), ("9400", "9.4 kHz"), ("2e6", "9.4 kHz")]
)
def test_a_shift_of_the_carrier_or_more_is_refused(
    rows: list[dict[str, str]], shift: str, carrier: str, capsys: Capture
) -> None:
    """No target goes as fast as light; the usual mistake is the unit of the carrier."""
    lines = as_shifts(rows).splitlines()
    lines[0] = lines[0].replace("doppler [kHz]", "doppler [Hz]", 1)
    cells = [line.split(",") for line in lines[1:]]
    for row, cell in zip(cells, ("1", "-2", shift, "3"), strict=True):
        row[3] = cell
    Path("d.csv").write_text("\n".join([lines[0], *(",".join(row) for row in cells)]) + "\n")
    assert cli.main(["locate", "d.csv", "stations.csv", "--carrier", carrier]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "d.csv, line 4, column 4 (doppler): wanted a shift below the carrier" in captured.err
    assert f"got {float(shift):g} Hz at a carrier of 9400 Hz" in captured.err


def test_a_shift_just_below_the_carrier_is_taken(rows: list[dict[str, str]]) -> None:
    head = "station,doppler [Hz],sigma_doppler [Hz],carrier [kHz]"
    Path("d.csv").write_text(
        f"{head}\n" + "".join(f"{row['station']},9399,1,9.4\n" for row in rows)
    )
    assert cli.main(["locate", "d.csv", "stations.csv", "--method", "doppler-only"]) != 2
