"""The answer of `gainproof steady`: model and values read, the steady state found and printed."""

from __future__ import annotations

import argparse
import json
from fractions import Fraction
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError, listed, unknown_name
from gainproof.claims.certificate_files import write
from gainproof.files import input_file, places
from gainproof.steady.page import page, samples_page
from gainproof.steady.state import (
    MATRICES,
    Enclosed,
    SteadyState,
    exact_number,
    samples_of,
    steady_state_of,
)
from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.structure import Model
from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import MOST_BYTES
from gainproof.verify.judge.claim.model_file import ModelFile, read_model_text
from gainproof.verify.judge.claim.units import unit_text_of
from gainproof.verify.judge.reader.plain_names import plain_name
from gainproof.verify.judge.setting.model_numbers import NoNumberError, model_at


def answered(options: argparse.Namespace) -> int:
    """Status 0. Raises BadInputError for what cannot be used and where there is no steady state."""
    path = Path(options.model)
    if path.suffix == ".py":
        raise BadInputError(
            f"{options.model}: a model as text is wanted (.toml); see docs/steady.md"
        )
    model = read_model(input_file.text(path, MOST_BYTES), places.shown(path))
    values = values_of(model, ",".join(options.at))
    if options.first is not None:
        return _first(model, values, options)
    found = at_values(model, values)
    if options.certificate is not None:
        write(Path(options.certificate), json.dumps(found.certificate) + "\n")
    if options.json:
        print(json.dumps(plain(model, values, found), indent=1))
    else:
        print(page(model, values, found, options.certificate))
    return 0


def _first(model: ModelFile, values: dict[str, Fraction], options: argparse.Namespace) -> int:
    """Status 0: the first samples, printed."""
    if options.certificate is not None:
        raise BadInputError("--certificate belongs to the steady state, and not to --first")
    if not options.first.isdecimal() or len(options.first) > 6:
        raise BadInputError(f"--first: a whole number is wanted, got {options.first[:40]!r}")
    numbers, start = _numbers(model, values)
    if start is None:
        problem = "--first needs `start`, the covariance of the prediction of the first sample"
        raise BadInputError(f"{model.path}: {problem}")
    found = samples_of(numbers, start, int(options.first))
    if options.json:
        samples = [{name: _both(getattr(one, name)) for name in MATRICES} for one in found]
        print(json.dumps({**_said(model, values), "samples": samples}, indent=1))
    else:
        print(samples_page(model, values, found))
    return 0


def asked(text: str, at: str) -> dict[str, Any]:
    """The steady state of the model in a text, as data. Raises BadInputError."""
    if len(text.encode("utf-8", "replace")) > MOST_BYTES:
        raise BadInputError(f"the text has more than {MOST_BYTES} bytes")
    model = read_model(text, "text")
    values = values_of(model, at)
    return plain(model, values, at_values(model, values))


def read_model(text: str, name: str) -> ModelFile:
    """The model in a text. Raises BadInputError with all that is wrong in it."""
    try:
        return read_model_text(text, name)
    except ClaimFileError as error:
        errors = [each.to_json() for each in (error, *error.others)]
        raise BadInputError(listed(errors), errors) from None


def at_values(model: ModelFile, values: dict[str, Fraction]) -> SteadyState:
    """The steady state where the symbols have these values. Raises BadInputError."""
    return steady_state_of(_numbers(model, values)[0])


def _numbers(model: ModelFile, values: dict[str, Fraction]) -> tuple[Model, Box | None]:
    try:
        return model_at(model, values)
    except NoNumberError as reason:
        raise BadInputError(f"{model.path}: {reason}") from None


def values_of(model: ModelFile, text: str) -> dict[str, Fraction]:
    """The values that `T=1, q=1e-22` gives to symbols, by token, which may be typed as in a formula
    (`\\sigma`) or plainly (`sigma`). Raises BadInputError.
    """
    names = {plain_name(token): token for token in model.symbols}
    names |= {token: token for token in model.symbols}
    found: dict[str, Fraction] = {}
    for part in (part.strip() for part in text.split(",") if part.strip()):
        name, equals, value = (word.strip() for word in part.partition("="))
        if not (name and equals and value):
            raise BadInputError(f"--at: NAME=VALUE is wanted, got {part[:80]!r}")
        if name not in names:
            raise unknown_name("symbol of the model", name[:80], names)
        if names[name] in found:
            raise BadInputError(f"--at: {name} has two values")
        try:
            found[names[name]] = exact_number(value)
        except ValueError:
            raise BadInputError(f"--at: {name}: a number is wanted, got {value[:40]!r}") from None
    return found


def plain(model: ModelFile, values: dict[str, Fraction], found: SteadyState) -> dict[str, Any]:
    """All of it as data for JSON."""
    return {
        **_said(model, values),
        **{name: _both(getattr(found, name)) for name in MATRICES},
        "poles": [
            {
                "real": pole.centre.real,
                "imaginary": pole.centre.imag,
                "error": pole.radius,
                "count": pole.count,
            }
            for pole in found.poles
        ],
        "certificate": found.certificate,
    }


def _said(model: ModelFile, values: dict[str, Fraction]) -> dict[str, Any]:
    return {
        "title": model.title,
        "at": {token: str(x) for token, x in values.items()},
        "states": [_named(c) for c in model.states],
        "measurements": [_named(c) for c in model.measurements],
    }


def _both(of: Enclosed) -> dict[str, Any]:
    return {"values": of.values, "errors": of.errors}


def _named(component: Any) -> dict[str, Any]:
    unit = None if component.unit is None else unit_text_of(component.unit)
    return {"name": component.name, "unit": unit}
