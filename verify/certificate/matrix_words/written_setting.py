"""Settings read strictly: shapes, blocks, inverses and elements as certificates write them."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial, Shape
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import (
    MAXIMUM_VARIABLES,
    MalformedError,
    Meter,
    RejectedError,
)

FIELDS = ("parameters", "matrices", "units", "blocks", "elements", "inverses")
MAXIMUM_LETTERS = 120


def is_setting(value: Plain) -> bool:
    """Whether an entry among the towers is meant as a setting."""
    return isinstance(value, dict) and "matrices" in value


def read_setting(value: Plain, meter: Meter, place: str) -> Setting:
    """A setting. Raises RejectedError where it is not as the format wants it."""
    fields = schema.record(value, FIELDS, place)
    entries = schema.items(fields["parameters"], f"{place}.parameters")
    if len(entries) > MAXIMUM_VARIABLES:
        raise MalformedError(f"{place}: more than {MAXIMUM_VARIABLES} parameters")
    parameters, positive = [], []
    for entry in entries:
        name, above = _parameter(entry, f"{place}.parameters")
        parameters.append(name)
        positive.append(above)
    matrices = schema.table(fields["matrices"], f"{place}.matrices")
    if len(matrices) > MAXIMUM_LETTERS:
        raise MalformedError(f"{place}: more than {MAXIMUM_LETTERS} matrices")
    names = tuple(schema.name(name, f"{place}.matrices") for name in matrices)
    shapes = tuple(_shape(entry, f"{place}.matrices") for entry in matrices.values())
    units = {
        schema.name(name, f"{place}.units"): _size(size, f"{place}.units")
        for name, size in schema.table(fields["units"], f"{place}.units").items()
    }
    every = [*parameters, *names, *units]
    if len(set(every)) < len(every):
        raise MalformedError(f"{place}: a name is given twice")
    elements: dict[int, Polynomial] = {}
    bare = Setting(
        tuple(parameters), tuple(positive), names, shapes, units, {}, elements, {}, meter
    )
    blocks = _blocks(bare, fields["blocks"], f"{place}.blocks")
    inverses = _inverses(bare, fields["inverses"], f"{place}.inverses")
    for name, entry in schema.table(fields["elements"], f"{place}.elements").items():
        number = bare.index(name, f"{place}.elements")
        elements[number] = bare.polynomial(entry, shapes[number], f"{place}.elements.{name}")
    taken = [n for columns in blocks.values() for n in columns] + [*inverses, *elements]
    if len(set(taken)) < len(taken):
        raise MalformedError(f"{place}: a letter has two meanings")
    _require_acyclic(bare, inverses, place)
    return Setting(
        bare.parameters, bare.positive, names, shapes, units, blocks, elements, inverses, meter
    )


def _parameter(value: Plain, place: str) -> tuple[str, bool]:
    entries = schema.table(value, place)
    if "above" in entries:
        fields = schema.record(value, ("symbol", "above"), place)
        if fields["above"] != "0":
            raise MalformedError(f'{place}: "above" is "0" here')
    else:
        fields = schema.record(value, ("symbol", "any"), place)
        if fields["any"] != "real":
            raise MalformedError(f'{place}: "any" is "real"')
    return schema.name(fields["symbol"], place), "above" in entries


def _size(value: Plain, place: str) -> str:
    if isinstance(value, str) and value.isascii() and value.isdigit() and len(value) < 4:
        if value.startswith("0"):
            raise MalformedError(f"{place}: {value!r} is not a size")
        return value
    return schema.name(value, place)


def _shape(value: Plain, place: str) -> Shape:
    entries = schema.items(value, place)
    if len(entries) != 2:
        raise MalformedError(f"{place}: rows and columns are wanted")
    return _size(entries[0], place), _size(entries[1], place)


def _blocks(setting: Setting, value: Plain, place: str) -> dict[str, tuple[int, ...]]:
    table = schema.table(value, place)
    blocks: dict[str, tuple[int, ...]] = {}
    for size, entry in table.items():
        if _size(size, place).isdigit():
            raise MalformedError(f"{place}: the size {size} is a number: its blocks need not exist")
        columns = tuple(
            setting.index(schema.name(name, place), place) for name in schema.items(entry, place)
        )
        if not columns:
            raise MalformedError(f"{place}: at least one block is wanted")
        for number in columns:
            rows, width = setting.shapes[number]
            if rows != size or width in table:
                raise MalformedError(f"{place}: {setting.names[number]} is no block of {size}")
        blocks[size] = columns
    return blocks


def _inverses(setting: Setting, value: Plain, place: str) -> dict[int, int]:
    inverses: dict[int, int] = {}
    for name, entry in schema.table(value, place).items():
        number = setting.index(name, place)
        base = setting.index(schema.name(entry, place), place)
        rows, columns = setting.shapes[base]
        if rows != columns or setting.shapes[number] != setting.shapes[base]:
            raise MalformedError(f"{place}: {name} and {entry} are not square of one size")
        if base in inverses.values() or number == base:
            raise MalformedError(f"{place}: {entry} has two inverses")
        inverses[number] = base
    return inverses


def _require_acyclic(setting: Setting, inverses: Mapping[int, int], place: str) -> None:
    """Letters are taken away that rest upon none of those that are left, until none is left."""
    rests = {number: poly.letters() for number, poly in setting.elements.items()}
    rests |= {number: {base} for number, base in inverses.items()}
    while rests:
        free = [number for number, upon in rests.items() if not upon & set(rests)]
        if not free:
            names = sorted(setting.names[number] for number in rests)
            raise RejectedError(f"{place}: {', '.join(names)} rest upon themselves")
        for number in free:
            del rests[number]
