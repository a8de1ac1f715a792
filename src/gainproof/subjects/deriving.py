"""From the catalogue to plain data. Importing this module imports SymPy: worker processes do it."""

from __future__ import annotations

import traceback
from pathlib import Path
from typing import Any, Literal

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.derive.catalogue import CATALOGUE, Entry
from gainproof.derive.derivation import PageError
from gainproof.derive.model import ModelError
from gainproof.derive.own_expressions.expressions import ExpressionError
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.quantity import MEASUREMENT_DEVIATION, SAMPLING_INTERVAL
from gainproof.derive.source import SOURCES
from gainproof.derive.subject import Subject
from gainproof.jobs.worker_state import WorkerState
from gainproof.subjects.derived import Derived, DerivedStep

GRAPH_FIELDS: tuple[Literal["nodes"], Literal["outputs"]] = ("nodes", "outputs")
_SHARED_SYMBOLS = {q.name: q.latex for q in (SAMPLING_INTERVAL, MEASUREMENT_DEVIATION)}


def outline(state: WorkerState, name: str) -> dict[str, Any]:
    """One subject with its model, kernels and sources, without its certificate."""
    return overview_of(subject_of(state, name))


def derive(state: WorkerState, name: str) -> dict[str, Any]:
    """Derive one subject of the catalogue: `Derived` as plain data.

    Raises BadInputError for a mistake on its page.
    """
    try:
        return state.kept(("derived", name), lambda: plain_subject(subject_of(state, name)).plain())
    except PageError as error:
        raise BadInputError(str(error)) from None


def subject_of(state: WorkerState, name: str) -> Subject:
    """A subject of the catalogue, derived once in a process."""
    return state.kept(("subject", name), lambda: build(name))


def overview_of(subject: Subject) -> dict[str, Any]:
    """A subject without its certificate: name, title, model, sources, kernels, cited."""
    derivation = subject.derivation
    return {
        "name": subject.name,
        "title": subject.title,
        "model": subject.model_data,
        "sources": [_source(key) for key in derivation.sources],
        "kernels": _kernels(subject),
        "cited": [
            step.relation.claim() for step in derivation.steps if step.relation.kind == "cited"
        ],
    }


def _kernels(subject: Subject) -> list[dict[str, Any]]:
    return [
        {
            "name": kernel.name,
            "summary": kernel.summary,
            "module": subject.module.name,
            "programs": list(subject.held(kernel)),
        }
        for kernel in subject.module.kernels
    ]


def _sampling(kernel: Kernel) -> dict[str, Any]:
    """What is needed to know a kernel's errors at points: its graph, and what they are relative
    to.
    """
    return {
        "graph": {field: kernel.graph[field] for field in GRAPH_FIELDS},
        "outputs": [
            {"name": each.name, "relative_to": each.relative_to, "by_terms": each.by_terms}
            for each in kernel.outputs
        ],
    }


def build(name: str) -> Subject:
    """Derive a subject. Raises BadInputError for a name that the catalogue does not have, and for a
    mistake on its page or in its file.
    """
    for entry in CATALOGUE:
        if entry.name == name:
            try:
                return entry.build()
            except PageError as error:
                raise BadInputError(str(error)) from None
            except (ModelError, ExpressionError) as error:
                raise BadInputError(f"{entry.module}: {error}") from None
            except Exception as error:
                place = _place_in_its_file(entry, error)
                if not place:
                    raise
                raise BadInputError(f"{place}: {type(error).__name__}: {error}") from None
    raise unknown_name("derivation", name, [entry.name for entry in CATALOGUE])


def _place_in_its_file(entry: Entry, error: Exception) -> str:
    """Where a subject's own file, or the catalogue's line on it, is wrong; empty where the error
    came out of what these call of ours.
    """
    walked = traceback.walk_tb(error.__traceback__)
    frames = [(f.f_globals.get("__name__", ""), f.f_code.co_filename, line) for f, line in walked]
    ours = [each for each in frames if each[0] == entry.module or each[0].startswith("gainproof.")]
    name, file, line = ours[-1]
    if isinstance(error, SyntaxError):
        name, file, line = entry.module, error.filename or "", error.lineno or 0
    if name == entry.module:
        return f"{'/'.join(Path(file).parts[-3:])}, line {line}"
    return f"the catalogue's line on {entry.name}" if name == Entry.__module__ else ""


def plain_subject(subject: Subject) -> Derived:
    """A derived subject and its certificate, without anything of SymPy."""
    derivation = subject.derivation
    return Derived(
        name=subject.name,
        title=subject.title,
        opening=f"{derivation.opening} {derivation.left_out}".strip(),
        model=subject.model_data,
        steps=tuple(
            DerivedStep(
                id=step.id,
                kind=step.relation.kind,
                tower=step.tower,
                sentence=step.sentence,
                reason=step.reason,
                claim=step.relation.claim(),
                shown=step.shown,
                heading=step.heading,
                joins=step.joins,
            )
            for step in derivation.steps
        ),
        symbols={**_SHARED_SYMBOLS, **derivation.latex},
        sources=tuple(_source(key) for key in derivation.sources),
        kernels=tuple(
            {**told, **_sampling(kernel)}
            for told, kernel in zip(_kernels(subject), subject.module.kernels, strict=True)
        ),
        certificate=subject.certificate(),
        claims=tuple(subject.claims()),
        domains=subject.domains(),
        programs=_programs(subject),
    )


def _programs(subject: Subject) -> dict[str, Any]:
    """The programs that must be proved: with what a certificate holds of the graphs that the
    kernels are printed from.

    Raises LookupError for a kernel that no program describes: it would ship unproved.
    """
    printed = {
        name: graph
        for kernel in subject.module.kernels
        for name, graph in subject.held(kernel).items()
    }
    unproved = sorted(set(printed) - set(subject.programs))
    if unproved:
        raise LookupError(f"{subject.name}: kernels without a program to prove: {unproved}")
    return {
        name: {
            "inputs": dict(program.inputs),
            # the names of intermediate values are for readers of the code and prove nothing
            "graph": {field: printed.get(name, program.graph)[field] for field in GRAPH_FIELDS},
        }
        for name, program in subject.programs.items()
    }


def _source(key: str) -> dict[str, str]:
    for source in SOURCES:
        if source.key == key:
            return {"key": key, "text": source.text(), "rests_on": source.rests_on}
    raise LookupError(f"no source of gainproof.derive.source has the key {key!r}")
