"""Matrix statements for every size: words in noncommuting letters, compared letter by letter.

A statement whose "tower" is a setting (`setting`) is about matrices of sizes that have names and
no values. Its claim is an implication: the hypotheses under "given" (`relations`) make it true,
whatever matrices and sizes stand for the letters. Formulas in claims are graphs (`expression`).

    matrix_equal       an equation of matrices, shown by cofactors (`combination`)
    matrix_order       X >= Y or X > Y in the order of symmetric matrices, by squares (`definite`)
    matrix_invertible  a letter is invertible
    matrix_trace       an equation of traces (`trace`)

`decide` gives the claims and evidence of each. A proof may use earlier statements of its setting,
never later ones. Nothing is searched for here: what a proof uses, and where, stands in it.

Every hypothesis must be used: the proof names it, or names a statement that has it, and its
equation does not drop out of the cofactors whatever it says (`combination`). That keeps slips out
and does not promise that the claim needs it: equations that follow from others, two that say the
same, products of an equation with itself and traces that cancel still let a proof use more than it
needs. Such a claim says less than it could, and nothing false.
"""

from __future__ import annotations

from gainproof.verify.certificate.matrix_words.decision import KINDS, prove
from gainproof.verify.certificate.matrix_words.definitions import STATED, stated
from gainproof.verify.certificate.matrix_words.setting import Setting
from gainproof.verify.certificate.matrix_words.written_setting import is_setting, read_setting

__all__ = ["KINDS", "STATED", "Setting", "is_setting", "prove", "read_setting", "stated"]
