"""What is kept of a stage is used as long as all it depends on is the same, and no longer."""

import subprocess
import sys
from pathlib import Path

import pytest

from gainproof import derivations
from gainproof.cache import Cache
from gainproof.progress import Progress
from gainproof.workshop import Workshop

OWN = """
import sympy as sp
from gainproof.derive.own_expressions.expressions import (
    Argument, ExpressionKernel, ExpressionSet, Result
)
from gainproof.derive.quantity import ONE, Quantity
{imports}

NUMBER = Quantity("x", "x", "a number", ONE)
SQUARE = Quantity("square", "s", "its square, scaled", ONE)
EXPRESSIONS = ExpressionSet(
    name="scaled",
    title="A scaled square",
    kernels=(
        ExpressionKernel(
            name="square",
            title="A scaled square",
            inputs=(Argument(NUMBER, "1", "10"),),
            outputs=(Result(SQUARE, {factor} * NUMBER.symbol**2),),
        ),
    ),
)
"""
CLAIM = r"""
format = "gainproof claims 1"

[source]
key = "own"
title = "Notes on gains"
authors = ["-"]
publication = "unpublished"

[settings.s]
title = "random velocity"
kind = "steady_state"
model = "random-velocity"

[settings.s.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain of the position" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain of the velocity" }

[[claims]]
id = "square"
place = "-"
kind = "identity"
setting = "s"
latex = '\beta (2 - \alpha) = \alpha^2'
"""


@pytest.mark.parametrize(
    ("imports", "factor", "beside", "content"),
    [
        ("from factors import FACTOR", "FACTOR", "factors.py", "FACTOR = {}\n"),
        (
            """from pathlib import Path
FACTOR = int((Path(__file__).parent / "factor.txt").read_text())""",
            "FACTOR",
            "factor.txt",
            "{}",
        ),
    ],
    ids=["module", "data"],
)
def test_a_file_that_an_own_file_reads_belongs_to_it(
    imports: str, factor: str, beside: str, content: str, tmp_path: Path
) -> None:
    """The old proof was shown, and the old kernel printed, after an imported file had changed."""
    file = tmp_path / "own.py"
    file.write_text(OWN.format(imports=imports, factor=factor))
    constants = []
    for number in (3, 5, 3):
        (tmp_path / beside).write_text(content.format(number))
        derived = derivations.derive_file(file, _shop(tmp_path))
        constants.append("3" in str(derived.programs) and "5" not in str(derived.programs))
    assert constants == [True, False, True]
    shop = _shop(tmp_path)
    derivations.derive_file(file, shop)
    assert (list(shop.taken.values()), shop.done) == (["derive_file"], {})


def test_two_own_files_with_modules_of_one_name(tmp_path: Path) -> None:
    """A process that derived the first takes the module beside the second for it."""
    shop = _shop(tmp_path)
    found = []
    for number in (3, 5):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "factors.py").write_text(f"FACTOR = {number}\n")
        text = OWN.format(imports="from factors import FACTOR", factor="FACTOR")
        (folder / "own.py").write_text(text)
        found.append(str(derivations.derive_file(folder / "own.py", shop).programs))
    assert found[0] != found[1]


@pytest.mark.parametrize(
    "arguments",
    [
        ["list"],
        ["cite", "random-velocity"],
        ["check", "FILE"],
        ["explain", "FILE", "square"],
        ["design", "--tracking-index", "1"],
    ],
    ids=lambda arguments: arguments[0],
)
def test_commands_that_derive_nothing_import_no_computer_algebra(
    arguments: list[str], tmp_path: Path
) -> None:
    """Not in any of their processes: where they look for it, there is a module that raises."""
    (tmp_path / "sympy.py").write_text("raise ImportError('computer algebra is not wanted here')")
    claims = tmp_path / "own.toml"
    claims.write_text(CLAIM)
    words = [str(claims) if word == "FILE" else word for word in arguments]
    run = subprocess.run(
        [sys.executable, "-m", "gainproof", *words],
        env={"PYTHONPATH": str(tmp_path), "GAINPROOF_CACHE": str(tmp_path / "cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr


def _shop(folder: Path) -> Workshop:
    return Workshop(Cache(folder / "cache"), Progress(quiet=True))
