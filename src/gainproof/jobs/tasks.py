"""What worker processes do: functions of plain data, by name.

Named as text, they are imported where they are called: this module depends on none of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gainproof.jobs import code_digest

if TYPE_CHECKING:
    from gainproof.jobs.worker_state import WorkerState


@dataclass(frozen=True)
class Task:
    """A function of ours that takes and returns plain data.

    Attributes
    ----------
    module, function : str
        Where it is; its answer depends on the code of `module` and of all that this imports.
    derives : bool
        It imports SymPy. Others are never done in a process in which such a one was.
    with_state : bool
        Its first argument is the `WorkerState` of the process.
    executes : bool
        It executes a user's file, which may import all of `gainproof.derive`.
    """

    module: str
    function: str
    derives: bool = False
    with_state: bool = False
    executes: bool = False

    def call(self, state: WorkerState, arguments: Mapping[str, Any]) -> Any:
        """The answer of the function."""
        function = getattr(import_module(self.module), self.function)
        return function(state, **arguments) if self.with_state else function(**arguments)


_SUBJECTS = "gainproof.subjects"
TASKS: Mapping[str, Task] = {
    "outline": Task(f"{_SUBJECTS}.deriving", "outline", derives=True, with_state=True),
    "derive": Task(f"{_SUBJECTS}.deriving", "derive", derives=True, with_state=True),
    "everything": Task(f"{_SUBJECTS}.generating", "everything", derives=True, with_state=True),
    "print_one": Task(f"{_SUBJECTS}.generating", "print_one", derives=True, with_state=True),
    "package_one": Task(f"{_SUBJECTS}.generating", "package_one", derives=True, with_state=True),
    "derive_file": Task(f"{_SUBJECTS}.own_file", "derive_file", derives=True, executes=True),
    "package_file": Task(f"{_SUBJECTS}.own_file", "package_file", derives=True, executes=True),
    "picture": Task("gainproof.book.sampled_kernel", "sampled"),
    "recheck": Task(f"{_SUBJECTS}.rechecking", "recheck"),
    "recheck_proofs": Task("gainproof.claims.claim_proofs", "recheck"),
    "judge": Task("gainproof.claims.judging", "judge", with_state=True),
    "ask": Task("gainproof.answers.judge", "asked", with_state=True),
    "steady": Task("gainproof.steady.answer", "asked"),
}


def derives(task: str) -> bool:
    """Whether a task imports SymPy; one that this process does not know need not."""
    return task in TASKS and TASKS[task].derives


def code_of(task: str, arguments: Mapping[str, Any]) -> str:
    """A digest of the code on which the answer of a task depends: of `modules_of`, and of the text
    of this module.
    """
    here = Path(__file__)
    own = code_digest.of_files(here.parent, [here])
    return f"{own} {code_digest.of_modules(*modules_of(task, arguments))}"


def is_as_read(task: str, arguments: Mapping[str, Any]) -> bool:
    """Whether that code is what it was when its digest was taken."""
    return code_digest.is_as_read(*modules_of(task, arguments))


def modules_of(task: str, arguments: Mapping[str, Any]) -> tuple[str, ...]:
    """What a task calls, its subject, and all that a user's file may import of ours."""
    from gainproof.derive.catalogue import CATALOGUE

    modules: tuple[str, ...] = ("gainproof.jobs.worker_state", TASKS[task].module)
    modules += tuple(entry.module for entry in CATALOGUE if entry.name == arguments.get("name"))
    if task == "picture":
        modules += (f"gainproof.generated.{arguments['module']}",)
    if TASKS[task].executes:
        modules += tuple(code_digest.modules_in("derive"))
    return modules
