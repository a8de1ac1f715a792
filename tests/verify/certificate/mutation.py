"""Random mutations of plain data: numbers, names, order, entries, and parts grafted elsewhere."""

from __future__ import annotations

import random
import re
from copy import deepcopy
from typing import Any

Place = tuple[Any, Any]  # a container and the key in it

_NUMBER = re.compile(r"-?[0-9]+(/[0-9]+)?\Z")
_NUMBERS = ("0", "1", "-1", "2", "-2", "1/2", "-1/2", "3", "1/4", "4", "8")


def places(value: Any) -> list[Place]:
    """Every place inside a value."""
    entries = (
        list(value.items())
        if isinstance(value, dict)
        else list(enumerate(value))
        if isinstance(value, list)
        else []
    )
    found: list[Place] = []
    for key, entry in entries:
        found.append((value, key))
        found.extend(places(entry))
    return found


def _shape(value: Any) -> str:
    """Values of one shape may stand in each other's places."""
    if isinstance(value, dict):
        return "record " + " ".join(sorted(value))
    if isinstance(value, list):
        return "list of " + (_shape(value[0]) if value else "nothing")
    if isinstance(value, str):
        return "number" if _NUMBER.match(value) else "name"
    return type(value).__name__


def mutate(value: Any, donor: Any, generator: random.Random) -> None:
    """Change one thing in place; parts are grafted from ``donor``."""
    container, key = generator.choice(places(value))
    entry = container[key]
    how = generator.random()
    if how < 0.4:
        shape = _shape(entry)
        others = [c[k] for c, k in places(donor) if _shape(c[k]) == shape]
        if others:
            container[key] = deepcopy(generator.choice(others))
    elif isinstance(entry, str):
        if _NUMBER.match(entry):
            container[key] = generator.choice(_NUMBERS)
    elif isinstance(entry, int):
        container[key] = max(0, entry + generator.choice((-2, -1, 1, 2)))
    elif isinstance(entry, list) and len(entry) > 1:
        first, second = generator.sample(range(len(entry)), 2)
        if how < 0.8:
            entry[first], entry[second] = entry[second], entry[first]
        else:
            del entry[first]
    elif isinstance(entry, dict) and len(entry) > 1:
        first, second = generator.sample(list(entry), 2)
        entry[first], entry[second] = entry[second], entry[first]
