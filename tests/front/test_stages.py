"""What is kept of a stage is used as long as all it depends on is the same, and no longer."""

import importlib
import json
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import pytest
import sympy as sp
from one_of_each import cases

from gainproof.bad_input import BadInputError
from gainproof.derive.definition_key import definition_text
from gainproof.derive.own_expressions.expressions import Result
from gainproof.derive.quantity import ONE, Quantity
from gainproof.files import places
from gainproof.jobs.cache import Cache
from gainproof.jobs.progress import Progress
from gainproof.jobs.session import Session
from gainproof.subjects import derivations, own_file

SQUARE = Quantity("square", "s", "its square, scaled", ONE)
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


def _written(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


MODULE = "from factors import FACTOR"
OPTIONAL = """try:
    from factors import FACTOR
except ImportError:
    FACTOR = 3"""
DATA = """from pathlib import Path
PLACE = Path(__file__).with_name("factor.txt")
FACTOR = int(PLACE.read_text()) if PLACE.exists() else 3"""
WORKING_FOLDER = "FACTOR = int(open('factor.txt').read())"
VARIABLE = "import os; FACTOR = int(os.environ.get('FACTOR', '3'))"
LISTED = "from pathlib import Path; FACTOR = len(list(Path(__file__).parent.glob('*.dat')))"
PROGRAM = """import subprocess, sys
from pathlib import Path
PLACE = Path(__file__).with_name("factor.txt")
CALL = [sys.executable, "-c", f"print(open({str(PLACE)!r}).read())"]
FACTOR = int(subprocess.check_output(CALL))"""
EDITED_MEANWHILE = """from factors import FACTOR
from pathlib import Path
Path(__file__).with_name("factors.py").write_text("FACTOR = 5")"""


SURROUNDINGS = {
    "module": (MODULE, {"factors.py": "FACTOR = 3"}, {"factors.py": "FACTOR = 5"}),
    "package before a module": (
        *(MODULE, {"factors.py": "FACTOR = 3"}, {"factors/__init__.py": "FACTOR = 5"}),
    ),
    "module on the path": (
        *(MODULE, {"factors.py": "FACTOR = 3"}, {"first/factors.py": "FACTOR = 5"}),
    ),
    "edited meanwhile": (EDITED_MEANWHILE, {"factors.py": "FACTOR = 3"}, {}),
    "module that was not there": (OPTIONAL, {}, {"factors.py": "FACTOR = 5"}),
    "data": (DATA, {"factor.txt": "3"}, {"factor.txt": "5"}),
    "data that were not there": (DATA, {}, {"factor.txt": "5"}),
    "data of the working folder": (
        WORKING_FOLDER,
        {"factor.txt": "3", "other/factor.txt": "5"},
        {},
    ),
    "variable": (VARIABLE, {}, {}),
    "folder": (*(LISTED, {f"{n}.dat": "" for n in range(3)}, {f"{n}.dat": "" for n in range(5)}),),
    "another program": (PROGRAM, {"factor.txt": "3"}, {"factor.txt": "5"}),
}
IN_PROCESSES = cases(SURROUNDINGS, lambda name: name in {"module", "variable"})
"""A file, which is executed wherever it is, and what only the process knows."""


def _changed(
    name: str, folder: Path, monkeypatch: pytest.MonkeyPatch, derive: Callable[[Path], object]
) -> None:
    """What is derived of an own file tells what surrounds it now."""
    imports, before, after = SURROUNDINGS[name]
    file = folder / "own.py"
    file.write_text(OWN.format(imports=imports, factor="FACTOR"))
    (folder / "other").mkdir()
    monkeypatch.setenv("PYTHONPATH", str(folder / "first"))
    monkeypatch.syspath_prepend(folder / "first")
    found = []
    for files, factor, place in ((before, "3", "."), (after, "5", "other")):
        for path, text in files.items():
            _written(folder / path, text)
        monkeypatch.setenv("FACTOR", factor)
        monkeypatch.chdir(folder / place)
        importlib.invalidate_caches()
        found.append(str(derive(file)))
    assert ["5" in each for each in found] == [False, True]


@pytest.mark.alike
@pytest.mark.parametrize("name", SURROUNDINGS)
def test_what_an_own_file_makes_of_its_surroundings_belongs_to_it(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The old proof was shown, and the old kernel printed, after an imported file had changed."""
    cache = str(tmp_path / "cache")
    _changed(name, tmp_path, monkeypatch, lambda f: own_file.derive_file(str(f), cache)["programs"])


@pytest.mark.parametrize("name", IN_PROCESSES)
def test_surroundings_belong_to_a_file_whose_process_derives_it(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def derive(file: Path) -> object:
        return derivations.derive_file(file, _shop(tmp_path)).programs

    _changed(name, tmp_path, monkeypatch, derive)


@pytest.mark.parametrize(
    ("field", "value"),
    [
        *(("model", [1]), ("model", "random"), ("model", {}), ("model", {"name": 3})),
        *(("title", None), ("sources", None), ("sources", ["a"]), ("sources", [{"key": "a"}])),
        *(("kernels", None), ("kernels", [3]), ("kernels", [{"name": "gains"}]), ("cited", None)),
    ],
)
def test_a_shipped_outline_that_is_damaged_is_said(
    field: str, value: object, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    subjects = derivations.outlines()
    subjects[1] = subjects[1] | {field: value}
    (tmp_path / derivations.OUTLINES).write_bytes(derivations.outlines_file(subjects))
    monkeypatch.setattr(places, "generated_folder", lambda: tmp_path)
    with pytest.raises(BadInputError, match="missing or damaged"):
        derivations.outlines()


def test_what_an_own_file_defines_is_derived_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "own.py"
    file.write_text(OWN.format(imports="", factor="3"))
    cache = str(tmp_path / "cache")
    first = own_file.derive_file(str(file), cache)
    monkeypatch.setattr(own_file, "built", _not_to_be_called)
    _written(file, "# a word on it\n" + file.read_text())
    again = own_file.derive_file(str(file), cache)
    assert again == json.loads(json.dumps(first))
    with pytest.raises(AssertionError):
        own_file.derive_file(str(file), cache, fresh=True)


def _not_to_be_called(*_: object) -> None:
    raise AssertionError("derived again")


def test_content_of_a_value_tells_what_differs() -> None:
    x = sp.Symbol("x", real=True)
    alike = definition_text(Result(SQUARE, x**2)) == definition_text(Result(SQUARE, x * x))
    values: list[object] = [
        *(1, True, "1", Fraction(1), 1.0, None, (1,), [1], {"1": 1}, x, sp.Symbol("x")),
        *(sp.Matrix([[1, 2]]), sp.ImmutableDenseMatrix([[1, 2]]), sp.Matrix([1, 2]), sp.Integer(1)),
        *(Result(SQUARE, x), Result(SQUARE, sp.Symbol("x")), sp.Float("0.1", 20), sp.Float("0.1")),
    ]
    assert alike
    assert len({definition_text(value) for value in values}) == len(values)


def test_what_holds_code_of_the_user_has_no_content() -> None:
    class Own(Result):
        pass

    class Doubled(sp.Function):  # type: ignore[misc]
        @classmethod
        def eval(cls, _: object) -> None:
            return None

    x = sp.Symbol("x")
    for value in (Own(SQUARE, x), Result(SQUARE, Doubled(x) + 1), sp.Function("f")(x), print):
        with pytest.raises(TypeError):
            definition_text(value)


def test_a_package_without_a_file_of_its_own_is_forgotten(tmp_path: Path) -> None:
    """One process took the module of the first file's package for that of the second's."""
    found = []
    for number in (3, 5):
        folder = tmp_path / str(number)
        _written(folder / "parts" / "factors.py", f"FACTOR = {number}\n")
        text = OWN.format(imports="from parts import factors", factor="factors.FACTOR")
        _written(folder / "own.py", text)
        found.append(definition_text(own_file.defined(str(folder / "own.py"))[1]))
    assert found[0] != found[1]


@pytest.mark.parametrize("place", ["code_of", "code_digest.versions"])
def test_what_other_code_made_of_an_own_file_is_not_taken(
    place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, cache = tmp_path / "own.py", str(tmp_path / "cache")
    file.write_text(OWN.format(imports="", factor="3"))
    own_file.derive_file(str(file), cache)
    monkeypatch.setattr(own_file, "built", _not_to_be_called)
    own_file.derive_file(str(file), cache)
    monkeypatch.setattr(f"{own_file.__name__}.{place}", lambda *_: "another")
    with pytest.raises(AssertionError):
        own_file.derive_file(str(file), cache)


def test_two_own_files_with_modules_of_one_name(tmp_path: Path) -> None:
    """A process that derived the first takes the module beside the second for it."""
    cache = str(tmp_path / "cache")
    found = []
    for number in (3, 5):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / "factors.py").write_text(f"FACTOR = {number}\n")
        text = OWN.format(imports="from factors import FACTOR", factor="FACTOR")
        (folder / "own.py").write_text(text)
        found.append(own_file.derive_file(str(folder / "own.py"), cache)["programs"])
    assert found[0] != found[1]


def test_commands_that_derive_nothing_import_no_computer_algebra(tmp_path: Path) -> None:
    """Not in any of their processes: where they look for it, there is a module that raises."""
    (tmp_path / "sympy.py").write_text("raise ImportError('computer algebra is not wanted here')")
    claims = tmp_path / "own.toml"
    claims.write_text(CLAIM)
    commands = [
        ["list"],
        ["cite", "random-velocity"],
        ["check", str(claims)],
        ["explain", str(claims), "square"],
        ["design", "--tracking-index", "1"],
    ]
    script = (
        "import sys; from functools import cache; from gainproof import cli;"
        "from gainproof.verify.judge.claim import file;"
        "file.read_claim_text = cache(file.read_claim_text);"
        f"sys.exit(str([cli.main(each) for each in {commands}]))"
    )
    run = subprocess.run(
        [sys.executable, "-c", script],
        env={"PYTHONPATH": str(tmp_path), "GAINPROOF_CACHE": str(tmp_path / "cache")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.stderr.splitlines()[-1] == str([0] * len(commands)), run.stderr


def _shop(folder: Path) -> Session:
    return Session(Cache(folder / "cache"), Progress(quiet=True))
