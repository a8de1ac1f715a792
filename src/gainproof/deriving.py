"""From the catalogue to plain data. Importing this module imports SymPy: worker processes do it."""

from __future__ import annotations

from typing import Any

from gainproof.bad_input import unknown_name
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.subject import Subject
from gainproof.derived import Derived, DerivedStep


def catalogue_names() -> list[str]:
    """Every subject that can be derived, in the order of the catalogue."""
    return [entry.name for entry in CATALOGUE]


def build(name: str) -> Subject:
    """Derive a subject. Raises BadInputError for a name that the catalogue does not have."""
    for entry in CATALOGUE:
        if entry.name == name:
            return entry.build()
    raise unknown_name("derivation", name, catalogue_names())


def derive_subject(name: str) -> Derived:
    """Derive a subject and write its certificate, as plain data."""
    return plain_subject(build(name))


def plain_subject(subject: Subject) -> Derived:
    """A derived subject without anything of SymPy in it."""
    derivation = subject.derivation
    return Derived(
        name=subject.name,
        title=derivation.title or subject.title,
        opening=derivation.opening,
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
            )
            for step in derivation.steps
        ),
        symbols=dict(derivation.latex),
        sources=derivation.sources,
        kernels=tuple(
            {"name": kernel.name, "summary": kernel.summary} for kernel in subject.module.kernels
        ),
        certificate=subject.certificate(),
        claims=tuple(subject.claims()),
        domains=subject.domains(),
    )
