"""What the reader of matrices says of notation that it does not cover, and spellings it reads."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.matrices.reader import read_matrix, read_statement
from gainproof.verify.judge.matrices.size import sizes_of
from gainproof.verify.judge.reader.errors import ReaderError

SIZES = sizes_of((("n",),))


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        ("P I = P", "the unit matrix has its size, as I_{n}"),
        (r"P \mathbf{I} = P", "the unit matrix has its size, as I_{n}"),
        (r"\operatorname{tr}(P) = 1", "tr of a matrix is not covered: read are sums"),
        (r"\mathrm{rank}(P) = n", "rank of a matrix is not covered"),
        (r"\tr P = 1", "tr of a matrix is not covered"),
        ("|P| = 1", "bars of a matrix are not covered"),
        (r"\|P\| = 1", "bars of a matrix are not covered"),
        (r"\det(P) = 1", r"of a determinant only \det(...) \neq 0 is read"),
        (r"P \neq 0", r"\neq is read after \det(...) only"),
        (r"P^{1/2} = P", "a power of a matrix is ^T, ^{-1}, ^2, ^3 or ^4"),
    ],
)
def test_what_is_not_covered_is_named(latex: str, message: str) -> None:
    with pytest.raises(ReaderError) as raised:
        read_statement(latex, {"P"}, SIZES)
    assert message in str(raised.value)


@pytest.mark.parametrize(
    "power", [r"\top", r"{\mathsf T}", r"\mathsf{T}", r"{\rm T}", r"\intercal", r"{\mathrm{T}}"]
)
def test_spellings_of_the_transpose(power: str) -> None:
    def node(latex: str) -> str:
        return repr(read_matrix(latex, {"P"}, SIZES)).split("position")[0]

    assert node(f"P^{power}") == node("P^T")
