"""The functions for Octave: every value as proved, and the bits of NumPy."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from gainproof.standalone.shipped._package import FORMATS, PACKAGE, VALUES, function

FOLDER = PACKAGE / "octave"
KIND = {"float64": ("double", np.uint64), "float32": ("single", np.uint32)}
LIBRARY = ("sin", "cos", "atan2", "hypot", "exp", "expm1", "log1p")
"""Functions that may round otherwise than NumPy's own."""


def octave(*arguments: str) -> str:
    """What Octave prints; the test is skipped where there is none."""
    command = shutil.which("octave-cli")
    if command is None:
        pytest.skip("needs octave-cli")
    run = [command, "--no-init-file", *arguments]
    done = subprocess.run(run, cwd=FOLDER, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize("module", VALUES)
def test_the_script_finds_every_value_as_proved(module: str) -> None:
    assert octave(f"test_{module}.m").startswith("0 of ")


@pytest.mark.parametrize("module", VALUES)
def test_the_bits_are_those_of_numpy(module: str, tmp_path: Path) -> None:
    lines, wanted = [], []
    for kernel, described in VALUES[module].items():
        text = (FOLDER / f"+{module}" / f"{kernel}.m").read_text(encoding="utf-8")
        if any(f"{name}(" in text for name in LIBRARY):
            continue
        for form in FORMATS:
            kind, whole = KIND[form]
            rows = [point["at"] for point in described["points"][form]]
            numbers = "; ".join(", ".join(map(repr, row)) for row in rows)
            inputs = ", ".join(f"at(:, {i + 1})" for i in range(len(rows[0])))
            outputs = [f"y{i}" for i in range(len(described["outputs"]))]
            lines += [f"at = {kind}([{numbers}]);"]
            lines += [f"[{', '.join(outputs)}] = {module}.{kernel}({inputs});"]
            lines += [f"disp(num2hex({y}));" for y in outputs]
            given = [np.array(x, form) for x in zip(*rows, strict=True)]
            found = function(module, kernel)(*given)
            wanted += [int(x) for y in found for x in np.asarray(y).view(whole)]
    script = tmp_path / "bits.m"
    script.write_text("\n".join(lines), encoding="utf-8")
    assert [int(line, 16) for line in octave(str(script)).split()] == wanted


@pytest.mark.parametrize("module", VALUES)
def test_what_is_outside_of_a_domain_is_refused(module: str, tmp_path: Path) -> None:
    lines = []
    for kernel, described in VALUES[module].items():
        count = len(described["inputs"])
        for value in (f"{KIND[FORMATS[0]][0]}(NaN)", "int8(1)"):
            call = f"{module}.{kernel}({', '.join([value] * count)})"
            lines.append(f"try, {call}; catch e, disp(e.identifier), end")
    script = tmp_path / "refused.m"
    script.write_text("\n".join(lines), encoding="utf-8")
    kinds = ["gainproof:domain", "gainproof:type"]
    assert octave(str(script)).split() == kinds * len(VALUES[module])
