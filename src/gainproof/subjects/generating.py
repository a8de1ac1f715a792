"""Files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.derive.formula_values import require_values
from gainproof.derive.printer.bound import Bounds, KernelBound
from gainproof.derive.printer.bound_data import bounds_from, identity, plain
from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.c_language.test_program import c_trial
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.docstring import losses_of
from gainproof.derive.printer.fpcore import fpcore
from gainproof.derive.printer.generated_files import module_files
from gainproof.derive.printer.javascript.script import scripts
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.lost_digits import with_losses
from gainproof.derive.printer.lost_digits_text import loss_text, place_text
from gainproof.derive.printer.module_bounds import groups
from gainproof.derive.printer.module_bounds import proved as prove_group
from gainproof.derive.printer.octave import octave_files
from gainproof.derive.printer.other_arrays import array_api_files, jax_files
from gainproof.derive.printer.rust import rust_files
from gainproof.derive.subject import Subject
from gainproof.derive.subject_page import subject_page
from gainproof.derive.textbook_formulas import formulas_source
from gainproof.jobs.code_digest import of_modules
from gainproof.jobs.worker_state import WorkerState
from gainproof.subjects import bounds_ledger
from gainproof.subjects.chosen_kernels import options
from gainproof.subjects.deriving import derive, outline, subject_of

BOUNDING = (
    "gainproof.derive.printer.module_bounds",
    "gainproof.derive.printer.lost_digits",
    "gainproof.derive.printer.bound_data",
)
"""What proves bounds and writes them."""


TARGETS: Mapping[str, Callable[[Module, list[Bounds], Mapping[str, Any]], dict[str, str]]] = {
    "array-api": array_api_files,
    "c": lambda module, bounds, values: {
        **c_files(module, bounds),
        f"test_{module.name}.c": c_trial(module, values),
    },
    "fpcore": lambda module, bounds, _: {f"{module.name}.fpcore": fpcore(module, bounds)},
    "jax": jax_files,
    "octave": octave_files,
    "rust": rust_files,
}
"""Files of a module by name, for each target besides NumPy, from bounds and values already known; a
folder of a package is called after the target.
"""


@dataclass(frozen=True)
class Proved:
    """The bounds of all kernels of a module, with what they say of digits that can be lost; the
    same as entries of the ledger, by kernel; how many kernels have theirs from there.
    """

    bounds: list[Bounds]
    entries: dict[str, Any]
    taken: int


def everything(state: WorkerState, name: str, bounds: Mapping[str, Any]) -> list[dict[str, Any]]:
    """What the tasks on one subject of the catalogue answer, which share most of the work: its
    outline, itself derived, its files.
    """
    return [outline(state, name), derive(state, name), print_one(state, name, bounds)]


def print_one(state: WorkerState, name: str, bounds: Mapping[str, Any]) -> dict[str, Any]:
    """The files of one subject of the catalogue, as `printed` has them; its `bounds` as entries of
    the ledger, of which those are taken that still hold.
    """
    return printed(subject_of(state, name), derive(state, name)["certificate"], bounds)


def package_one(
    state: WorkerState,
    name: str,
    bounds: Mapping[str, Any],
    kernels: Sequence[str] = (),
    only: str = "",
) -> dict[str, Any]:
    """One subject of the catalogue for a package of its own: {"derived", "part"}, of which the
    first is what `derive` answers, the second what `packaged` does.
    """
    derived, subject = derive(state, name), subject_of(state, name)
    part = packaged(subject, derived["certificate"], bounds, kernels, only)
    return {"derived": derived, "part": part}


def printed(
    subject: Subject, certificate: Mapping[str, Any], known: Mapping[str, Any]
) -> dict[str, Any]:
    """{"module", "title", "files", "bounds", "counts"}: what one subject gives to the folder. The
    files are texts by name; a file of results, or of what scripts share, may come from other
    subjects too, and is then the same. "bounds" are its entries of the ledger; those of `known`
    that still hold are taken: "counts" has "taken" and "proved".
    """
    module = subject.module
    found = proved(module, known)
    files = {**module_files(module, certificate, found.bounds), **scripts(module)}
    return {
        "module": module.name,
        "title": module.title,
        "files": files,
        "bounds": found.entries,
        "counts": {"taken": found.taken, "proved": len(module.kernels) - found.taken},
    }


def proved(module: Module, known: Mapping[str, Any]) -> Proved:
    """The bounds of all kernels, those of `known` entries that still hold, the others anew."""
    code = of_modules(*BOUNDING)
    bounds: dict[str, Bounds] = {}
    entries: dict[str, Any] = {}
    taken = 0
    for places in groups(module.kernels):
        group = [module.kernels[place] for place in places]
        rests_on = f"{identity(group)} {code}"
        found = _taken(group, rests_on, known)
        if found is None:
            found = [with_losses(*pair) for pair in zip(group, prove_group(group), strict=True)]
        else:
            taken += len(group)
        for kernel, each in zip(group, found, strict=True):
            bounds[kernel.name] = each
            entries[kernel.name] = bounds_ledger.sealed(rests_on, plain(each))
    names = [kernel.name for kernel in module.kernels]
    return Proved([bounds[name] for name in names], {n: entries[n] for n in names}, taken)


def _taken(group: Sequence[Kernel], rests_on: str, known: Mapping[str, Any]) -> list[Bounds] | None:
    """The known bounds of kernels that are proved together; None unless all still hold."""
    found: list[Bounds] = []
    for kernel in group:
        entry = bounds_ledger.opened(rests_on, known.get(kernel.name))
        if entry is None:
            return None
        found.append(bounds_from(kernel, entry))
    return found


def packaged(
    subject: Subject,
    certificate: Mapping[str, Any],
    known: Mapping[str, Any],
    kernels: Sequence[str] = (),
    only: str = "",
    *,
    own: bool = False,
) -> dict[str, Any]:
    """The same for a package of its own: with a page, values that its tests read, and what the
    other targets have, in folders called after them; "remarks" besides: each a "text", whether the
    output is "refused", and "where" it loses half; "kernels" are the names of all, and "left_out"
    says which there cannot be. `kernels` are those that are wanted, all if none is named, and
    `only` the one format; where a subject has no wanted kernel it has no files. `own`: of a user's
    file, whose expressions are
    refused where half of an output's digits or more can be lost. (What a model's kernels lose its
    author cannot write otherwise.) Raises BadInputError where a test against formulas could compare
    nothing.
    """
    whole, left_out = subject.module, subject.derivation.left_out
    part: dict[str, Any] = {"module": whole.name, "title": whole.title, "left_out": left_out}
    part |= {"kernels": [kernel.name for kernel in whole.kernels], "files": {}, "remarks": []}
    # proved with the others, as for the whole module: a bound does not depend on what is wanted
    pairs = zip(whole.kernels, proved(whole, known).bounds, strict=True)
    wanted = [pair for pair in pairs if not kernels or pair[0].name in kernels]
    if not wanted:
        return part
    remarks = (
        [{"text": left_out, "refused": False, "where": ""}] if left_out and not kernels else []
    )
    if only:
        remarks += [_not_accurate(kernel) for kernel, _ in wanted if kernel.accurate]
    module = replace(
        whole,
        command=f"{whole.command}{options(kernels, only)}",
        kernels=tuple(_in_one_format(k) if only else k for k, _ in wanted),
    )
    subject = replace(subject, module=module)
    both = [pair for _, pair in wanted]
    bounds = [tuple(b for b in pair if only in ("", b.format.name)) for pair in both]
    values = {
        kernel.name: known_values(kernel, pair, module.name)
        for kernel, pair in zip(module.kernels, bounds, strict=True)
    }
    files = {
        **module_files(module, certificate, both, only),
        f"{module.name}.md": subject_page(subject, bounds),
        f"tests/values_{module.name}.json": canonical_json(values),
    }
    for target, made in TARGETS.items():
        folder = target.replace("-", "_")  # a package, where it is Python
        files |= {f"{folder}/{name}": text for name, text in made(module, bounds, values).items()}
    formulas = formulas_source(subject)
    if formulas:
        try:
            require_values(formulas, values)
        except ValueError as error:
            raise BadInputError(f"{subject.name}: {error}") from None
        files[f"tests/formulas_{module.name}.py"] = formulas
    remarks += _losses(module, bounds, refusing=own and subject.model is None)
    return {**part, "files": files, "remarks": remarks}


def _in_one_format(kernel: Kernel) -> Kernel:
    """A kernel without what it computes in double-words."""
    return replace(kernel, accurate=None, accurate_graph=None, refinement=None)


def _not_accurate(kernel: Kernel) -> dict[str, Any]:
    """What is said of a kernel in double-words where one format is wanted."""
    said = (
        f"{kernel.name}: without accurate=True, which needs both formats: float32 is computed in "
        "float64 there"
    )
    return {"text": said, "refused": False, "where": ""}


def _losses(
    module: Module, bounds: Sequence[tuple[KernelBound, ...]], refusing: bool
) -> Iterator[dict[str, Any]]:
    """What is said of each output that may lose digits."""
    for kernel, pair in zip(module.kernels, bounds, strict=True):
        for row, output in enumerate(kernel.outputs):
            if losses := losses_of(pair, row):
                name = f"{kernel.name}, {output.name}"
                yield {
                    "text": f"{name}: {loss_text(losses)}",
                    "refused": refusing
                    and not output.accepted
                    and any(loss.half for loss in losses),
                    "where": f"for {name} where {place_text(losses)}",
                }
