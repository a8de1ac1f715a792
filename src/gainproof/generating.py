"""Files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.derive.formulas import formulas_source
from gainproof.derive.formulas_tried import require_values
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.c_language.module import c_files
from gainproof.derive.printer.c_language.trial import c_trial
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.docstring import losses_of
from gainproof.derive.printer.fpcore import fpcore
from gainproof.derive.printer.javascript.script import scripts
from gainproof.derive.printer.kernel import Module
from gainproof.derive.printer.known_values import known_values
from gainproof.derive.printer.loss import loss_text, place_text
from gainproof.derive.printer.lost_digits import with_losses
from gainproof.derive.printer.together import prove_all
from gainproof.derive.printer.write import module_files
from gainproof.derive.subject import Subject
from gainproof.derive.subject_page import subject_page


def printed(subject: Subject, certificate: Mapping[str, Any]) -> dict[str, Any]:
    """{"module", "title", "files"}: what one subject gives to the folder. The files are texts by
    name; a file of results, or of what scripts share, may come from other subjects too, and is then
    the same.
    """
    module = subject.module
    files = {**module_files(module, certificate, _proved(module)), **scripts(module)}
    return {"module": module.name, "title": module.title, "files": files}


def _proved(module: Module) -> list[tuple[KernelBound, ...]]:
    """The bounds of all kernels, with what they say of digits that can be lost."""
    pairs = zip(module.kernels, prove_all(module.kernels), strict=True)
    return [with_losses(kernel, bounds) for kernel, bounds in pairs]


def packaged(
    subject: Subject, certificate: Mapping[str, Any], *, own: bool = False
) -> dict[str, Any]:
    """The same for a package of its own: with a page, values that its tests read, and what the
    other targets have, in folders called after them; "remarks" besides: each a "text", whether the
    output is "refused", and "where" it loses half. `own`: of a user's file, whose expressions are
    refused where half of an output's digits or more can be lost. (What a model's kernels lose its
    author cannot write otherwise.) Raises BadInputError where a test against formulas could compare
    nothing.
    """
    module = subject.module
    bounds = _proved(module)
    values = {
        kernel.name: known_values(kernel, pair, module.name)
        for kernel, pair in zip(module.kernels, bounds, strict=True)
    }
    files = {
        **module_files(module, certificate, bounds),
        f"{module.name}.md": subject_page(subject, bounds),
        f"tests/values_{module.name}.json": canonical_json(values),
    }
    files |= {f"c/{name}": text for name, text in c_files(module, bounds).items()}
    files[f"c/test_{module.name}.c"] = c_trial(module, values)
    files[f"fpcore/{module.name}.fpcore"] = fpcore(module, bounds)
    formulas = formulas_source(subject)
    if formulas:
        try:
            require_values(formulas, values)
        except ValueError as error:
            raise BadInputError(f"{subject.name}: {error}") from None
        files[f"tests/formulas_{module.name}.py"] = formulas
    left_out = subject.derivation.left_out
    remarks = [{"text": left_out, "refused": False, "where": ""}] if left_out else []
    remarks += _losses(module, bounds, refusing=own and subject.model is None)
    return {"module": module.name, "title": module.title, "files": files, "remarks": remarks}


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
                    "refused": refusing and any(loss.half for loss in losses),
                    "where": f"for {name} where {place_text(losses)}",
                }
