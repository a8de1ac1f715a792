"""What a package says of one module, in Markdown: what it is of, its kernels, what is proved."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.docstring import ONE_TYPES, types_text
from gainproof.derive.printer.kernel_page import kernel_page
from gainproof.derive.subject import Subject

NOT_DECIDED = ("definition", "cited")
NUMBERS = (
    "Numbers and arrays of shapes that broadcast are taken; `out=` takes a tuple of arrays to "
    "fill. {} An input outside its domain, NaN included, is a `ValueError` with its place. Errors "
    "are relative to the exact value unless something else is named, and proved, not measured: for "
    "every number of the format in the domain."
)
MATRICES = {
    "F": "transition",
    "Q over the square of the index": "process_noise",
    "H": "measurement",
    "R": "measurement_noise",
}


def subject_page(subject: Subject, bounds: Sequence[Sequence[KernelBound]]) -> str:
    """The page of a subject's module, with the bounds of its kernels in their order."""
    return "\n".join(_lines(subject, bounds)) + "\n"


def _lines(subject: Subject, bounds: Sequence[Sequence[KernelBound]]) -> Iterator[str]:
    module = subject.module
    yield from (f"# {module.title.removesuffix('.')}", "", f"`{module.name}.py`")
    yield from ("", subject.derivation.opening, "")
    if subject.model_data is not None:
        yield from _model(subject.model_data)
    yield from ("## Kernels", "", NUMBERS.format(types_text(bounds[0], ONE_TYPES)), "")
    for kernel, pair in zip(module.kernels, bounds, strict=True):
        yield kernel_page(kernel, pair)
    yield from ("## What is proved", "")
    yield from _proved(subject)


def _model(model: dict[str, Any]) -> Iterator[str]:
    yield "In units in which the sampling interval and the first deviation measured are 1:"
    yield from ("", "```text")
    for name, key in MATRICES.items():
        yield f"{name} = {[[_entry(entry) for entry in row] for row in model[key]]}".replace(
            "'", ""
        )
    yield from ("```", "")


def _entry(entry: Any) -> str:
    return entry if isinstance(entry, str) else "a graph (see the certificate)"


def _proved(subject: Subject) -> Iterator[str]:
    claims = subject.claims()
    decided = [claim for claim in claims if claim["kind"] not in NOT_DECIDED]
    count = f"{len(decided)} statement{'' if len(decided) == 1 else 's'}"
    yield (
        f"`{subject.module.name}.json` is a certificate of {count}, each with the evidence from "
        "which a checker without computer algebra decides it exactly, on the whole domain. Those "
        "of kind `program` say what each output of each kernel is. It was accepted before this "
        "file was written. The bounds of the errors are proved separately, of the very operations "
        "that the code does."
    )
    cited = [claim["claim"] for claim in claims if claim["kind"] == "cited"]
    if cited:
        yield from ("", "Used and not proved here:", "")
        yield from (f"- {claim['theorem']} ({claim['reference']})" for claim in cited)
