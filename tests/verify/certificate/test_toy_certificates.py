"""The toy certificates are accepted as they stand."""

from __future__ import annotations

import copy
import subprocess
import sys
from typing import Any

from tests.verify.certificate.toy_writer import expectations

from gainproof.verify.certificate import check


def test_acceleration_is_accepted(acceleration: dict[str, Any]) -> None:
    report = check(acceleration, **expectations(acceleration))
    assert report.accepted, report.reason
    assert report.count("proved") == 16
    assert report.count("cited") == 1
    assert report.count("definition") == 4


def test_memory_is_accepted(memory: dict[str, Any]) -> None:
    report = check(memory, **expectations(memory))
    assert report.accepted, report.reason
    assert report.count("proved") == len(memory["statements"])


def test_pure_python() -> None:
    """The checker stands on Python's own library alone."""
    code = (
        "import sys; import gainproof.verify.certificate.alteration_campaign;"
        "print(*[m for m in ('sympy', 'numpy', 'flint', 'mpmath', 'scipy', 'lark')"
        " if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == ""


def test_a_noise_that_is_no_covariance_is_rejected(acceleration: dict[str, Any]) -> None:
    changed = copy.deepcopy(acceleration)
    for statement in changed["statements"]:
        if "model" in statement["claim"]:
            statement["claim"]["model"]["process_noise"] = [["1/100", "1/4"], ["1/4", "1"]]
    report = check(changed)
    assert any("not a covariance" in result.reason for result in report.statements)
