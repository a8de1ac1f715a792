"""The subjects of the catalogue, each derived once in a process, whatever tests ask for it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.subject import Subject
from gainproof.derived import Derived
from gainproof.deriving import plain_subject


@cache
def subject(name: str) -> Subject:
    """The subject of that name; ValueError if the catalogue has none."""
    (entry,) = (entry for entry in CATALOGUE if entry.name == name)
    return entry.build()


@cache
def derived(name: str) -> Derived:
    """The subject as plain data, with its certificate."""
    return plain_subject(subject(name))


def certificate(name: str) -> Mapping[str, Any]:
    """The certificate of a subject, written once in a process; nobody changes it."""
    return derived(name).certificate


def models() -> list[Mapping[str, Any]]:
    """The models of all subjects that have one, in the order of the catalogue."""
    return [data for entry in CATALOGUE if (data := subject(entry.name).model_data)]
