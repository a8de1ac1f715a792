"""Whether a symmetric matrix of rational numbers is positive (semi)definite, with a direction that
shows it where it is not.
"""

from __future__ import annotations

from flint import fmpq, fmpq_mat


def is_symmetric(matrix: fmpq_mat) -> bool:
    """Whether it is its own transpose."""
    return bool(matrix == matrix.transpose())


def compared(left: fmpq_mat, operator: str, right: fmpq_mat) -> bool:
    """Whether a relation of two matrices is true."""
    if operator == "=":
        return bool(left == right)
    gap = left - right if operator.startswith(">") else right - left
    return is_symmetric(gap) and bad_direction(gap, "=" not in operator) is None


def bad_direction(matrix: fmpq_mat, strict: bool) -> list[fmpq] | None:
    """x with x' S x < 0, or where `strict` with x' S x = 0 and x not 0; None if there is none.

    Elimination keeps the form diagonal on the part that is done; each basis vector is kept as a
    combination of the unit vectors, so that x is one too.
    """
    size = matrix.nrows()
    form = [[matrix[i, j] for j in range(size)] for i in range(size)]
    basis = [[fmpq(int(i == j)) for j in range(size)] for i in range(size)]
    left = list(range(size))
    while left:
        negative = next((i for i in left if form[i][i] < 0), None)
        if negative is not None:
            return basis[negative]
        pivot = next((i for i in left if form[i][i] > 0), None)
        if pivot is None:
            return _of_zero_diagonal(form, basis, left, strict)
        left.remove(pivot)
        for i in left:
            factor = form[i][pivot] / form[pivot][pivot]
            if factor:
                basis[i] = [x - factor * y for x, y in zip(basis[i], basis[pivot], strict=True)]
                for j in left:
                    form[i][j] -= factor * form[pivot][j]
        for i in left:
            form[i][pivot] = form[pivot][i] = fmpq(0)
    return None


def _of_zero_diagonal(
    form: list[list[fmpq]], basis: list[list[fmpq]], left: list[int], strict: bool
) -> list[fmpq] | None:
    for i in left:
        for j in left:
            if form[i][j] < 0:
                return [x + y for x, y in zip(basis[i], basis[j], strict=True)]
            if form[i][j] > 0:
                return [x - y for x, y in zip(basis[i], basis[j], strict=True)]
    return basis[left[0]] if strict else None
