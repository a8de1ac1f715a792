"""Models of a source's own: four matrices of formulas whose shapes fit, whose noises are
covariances as far as they are numbers.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from itertools import combinations

from gainproof.verify.judge.claim.fields import Fields, kind_of
from gainproof.verify.judge.claim.formulas import Symbols, graph_in
from gainproof.verify.judge.claim.record import OwnModel
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.formula import Graph

MOST_STATES = 20
MOST_DIGITS = 400
"""Of a number, powers of ten included."""
EXPONENT = re.compile(r"[+-]?[0-9]{1,99}(\.[0-9]{1,99})?[eE][+-]?[0-9]{1,3}", re.ASCII)
"""A number with a power of ten, which formulas print otherwise."""
MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")
GAIN_MATRICES = ("transition", "measurement", "process_noise")
"""Those of a filter with free gains."""
Rows = tuple[tuple[Graph, ...], ...]


def read_own_model(fields: Fields, symbols: Symbols) -> OwnModel | None:
    """The model in the fields of a setting, or None. Raises ClaimFileError."""
    given = [name for name in MATRICES if fields.has(name)]
    if not given:
        return None
    if len(given) < len(MATRICES):
        missing = next(name for name in MATRICES if name not in given)
        raise fields.fail(missing, "this matrix is missing: a model has four")
    read = {name: read_matrix(fields, name, symbols) for name in MATRICES}
    _check_shapes(fields, read)
    for name in ("process_noise", "measurement_noise"):
        _check_covariance(fields, name, read[name])
    return OwnModel(**read)


def read_gain_matrices(fields: Fields, symbols: Symbols) -> dict[str, Rows]:
    """Transition, measurement and process noise of a filter with free gains, as far as given.
    Raises ClaimFileError.
    """
    names = [name for name in GAIN_MATRICES if fields.has(name)]
    read = {name: read_matrix(fields, name, symbols) for name in names}
    states = len(read["transition"]) if "transition" in read else None
    wanted = {"transition": states, "measurement": 1, "process_noise": states}
    for name, matrix in read.items():
        rows = wanted[name] or len(matrix)
        columns = states or len(matrix[0])
        if (len(matrix), len(matrix[0])) != (rows, columns):
            shape = f"{len(matrix)} by {len(matrix[0])}"
            raise fields.fail(name, f"wanted {rows} by {columns}, but it is {shape}")
    if "process_noise" in read:
        _check_covariance(fields, "process_noise", read["process_noise"])
    return read


def read_matrix(fields: Fields, name: str, symbols: Symbols) -> Rows:
    """The matrix in a field, its entries formulas or numbers. Raises ClaimFileError."""
    value = fields.take(name)
    problem = f"a list of 1 to {MOST_STATES} rows of formulas or numbers, all of one length,"
    if not isinstance(value, list) or not 1 <= len(value) <= MOST_STATES:
        raise fields.fail(name, f"{problem} is wanted")
    rows: list[tuple[Graph, ...]] = []
    for row in value:
        if not isinstance(row, list) or not 1 <= len(row) <= MOST_STATES:
            raise fields.fail(name, f"{problem} is wanted")
        if len(row) != len(value[0]):
            raise fields.fail(name, f"{problem} is wanted")
        rows.append(tuple(_entry(fields, name, entry, symbols) for entry in row))
    return tuple(rows)


def _entry(fields: Fields, name: str, entry: object, symbols: Symbols) -> Graph:
    if isinstance(entry, str) and not EXPONENT.fullmatch(entry.strip()):
        return graph_in(fields, name, entry, symbols)
    if isinstance(entry, bool) or not isinstance(entry, int | Decimal | str):
        raise fields.fail(name, f"a formula or a number is wanted, not {kind_of(entry)}")
    number = Decimal(entry)
    if not number.is_finite() or len(number.as_tuple().digits) > MOST_DIGITS:
        raise fields.fail(name, f"{str(entry)[:40]}: a number of reasonable length is wanted")
    if number and abs(number.adjusted()) > MOST_DIGITS:
        raise fields.fail(
            name, f"{str(entry)[:40]}: a number beyond 10^{MOST_DIGITS} or its inverse"
        )
    return {"nodes": [["number", str(Fraction(number))]], "outputs": {"value": 0}}


def _check_shapes(fields: Fields, read: Mapping[str, Rows]) -> None:
    states, measured = len(read["transition"]), len(read["measurement"])
    wanted = {
        "transition": (states, states),
        "process_noise": (states, states),
        "measurement": (measured, states),
        "measurement_noise": (measured, measured),
    }
    for name, (rows, columns) in wanted.items():
        found = (len(read[name]), len(read[name][0]))
        if found != (rows, columns):
            shape = f"{found[0]} by {found[1]}"
            raise fields.fail(name, f"wanted {rows} by {columns}, but it is {shape}")


def _check_covariance(fields: Fields, name: str, matrix: Rows) -> None:
    """A noise given in numbers must be symmetric and positive semidefinite."""
    numbers = [[_number(entry) for entry in row] for row in matrix]
    known = [[value for value in row if value is not None] for row in numbers]
    if any(len(row) < len(numbers) for row in known):
        return
    for i, j in combinations(range(len(known)), 2):
        if known[i][j] != known[j][i]:
            problem = (
                f"row {i + 1}, column {j + 1} is {known[i][j]}, and the other way {known[j][i]}"
            )
            raise fields.fail(name, f"a covariance is symmetric, but {problem}")
    if not positive_semidefinite(known):
        problem = "a covariance is positive semidefinite, but this matrix is not"
        raise fields.fail(name, problem)


def _number(entry: Graph) -> Fraction | None:
    try:
        return constant_value(read_graph(entry))
    except Malformed:
        return None


def positive_semidefinite(matrix: list[list[Fraction]]) -> bool:
    """Whether a symmetric matrix of fractions is; by exact elimination."""
    if not matrix:
        return True
    pivot, *rest = matrix[0]
    if pivot < 0 or (pivot == 0 and any(rest)):
        return False
    below = [
        [entry - (row[0] * rest[j] / pivot if pivot else 0) for j, entry in enumerate(row[1:])]
        for row in matrix[1:]
    ]
    return positive_semidefinite(below)
