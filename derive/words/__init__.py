"""Matrix statements for every size: formulas in noncommuting letters, and proofs found for them.

    setting = Setting("m", {"P": "n n", "H": "m n", "R": "m m", "S": "m m"},
                      elements={"S": H @ P @ H.T + R}, inverses=("S",))
    given = [semidefinite("P"), definite("R")]
    squares = [Square(H.T, given[0]), Square(unit("m"), given[1], left_inverse=unit("m"))]
    positive = prove_order("s", Search(setting, given), S, ZERO, squares, strict=True)
    inverse = prove_invertible("i", Search(setting, given, [positive]), "S", positive)

`search.Search` rewrites with the equations at hand; a statement keeps the hypotheses that its proof
needed, and its cofactors. Nothing here is trusted: `gainproof.verify.certificate.matrix_words`
expands them and compares. What is not found by rewriting is helped by `multiples`, `taken`,
`rounds` and `heavy`, or by a statement on the way.
"""
