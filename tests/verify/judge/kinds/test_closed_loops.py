"""The polynomial of the poles of steady states, against NumPy's eigenvalues of F (I - K H)."""

from __future__ import annotations

from ast import literal_eval

import numpy as np
import pytest
from small_claims import check, judged

TWO = "[['1', '1'], ['0', '1']]", "[['0.25', '0.5'], ['0.5', '1']]", "[['1', '0']]"
FORGETTING = "[['1', '0.5'], ['0', '0.75']]", "[['0.5', '0.25'], ['0.25', '2']]", "[['1', '0.5']]"
ONE = "[['0.5']]", "[['2']]", "[['1']]"
THREE = (
    "[['1', '1', '0.5'], ['0', '1', '1'], ['0', '0', '1']]",
    "[['0.25', '0.5', '0.5'], ['0.5', '1', '1'], ['0.5', '1', '1']]",
    "[['1', '0', '0']]",
)
INDEX = (
    "kind = 'steady_state'\ngain = 'filter'\nmeasurement_noise = [['1']]\n"
    "transition = [['1', '1'], ['0', '1']]\nmeasurement = [['1', '0']]\n"
    r"process_noise = [['\frac{q^2}{4}', '\frac{q^2}{2}'], ['\frac{q^2}{2}', 'q^2']]"
)
INDEXED = {
    "q": "{ unit = '1', domain = 'q > 0', meaning = 'index' }",
    "A": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
    "B": "{ quantity = 'filter_gain.2', meaning = 'gain' }",
    **{
        f"p_{j}": f"{{ quantity = 'closed_loop_coefficient.{j}', meaning = 'of z^{j}' }}"
        for j in range(3)
    },
}


@pytest.mark.parametrize("model", [ONE, TWO, FORGETTING, THREE])
def test_coefficients_of_filters_in_numbers(model: tuple[str, str, str]) -> None:
    """A recursion of 4000 steps gives K; every coefficient is printed with eight decimals, and one
    of them with the last digit wrong.
    """
    f, q, h = (np.array(literal_eval(text)).astype(float) for text in model)
    p = np.eye(len(f))
    for _ in range(4000):
        gain = p @ h.T / (h @ p @ h.T + 1)
        p = f @ (p - gain @ h @ p) @ f.T + q
    wanted = np.poly(f @ (np.eye(len(f)) - gain @ h))[::-1]
    setting = (
        "kind = 'steady_state'\ngain = 'filter'\nmeasurement_noise = [['1']]\n"
        f"transition = {model[0]}\nprocess_noise = {model[1]}\nmeasurement = {model[2]}"
    )
    for j, value in enumerate(wanted):
        name = f"'closed_loop_coefficient.{j}'"
        symbols = {"p": f"{{ quantity = {name}, meaning = 'coefficient' }}"}
        for shown, verdict in ((value, "proved"), (value + 1e-7, "refuted")):
            claim = rf"p \approx {shown:.8f}"
            check(judged("value", claim, symbols, setting), verdict)


@pytest.mark.parametrize(
    ("kind", "claim", "wanted"),
    [
        ("identity", "p_0 = 1 - A", "proved"),
        ("identity", "p_0 = A - 1", "refuted"),
        ("identity", "p_1 = A + B - 2", "proved"),
        ("identity", "p_1 = A + 2 B - 2", "refuted"),
        ("identity", "p_2 = 1", "proved"),
        # q^2 = B^2/(1 - A): the poles are complex below 8
        ("inequality", r"p_1^2 < 4 p_0 \quad (q < 8)", "proved"),
        ("inequality", "p_1^2 < 4 p_0", "conditional"),
    ],
)
def test_coefficients_over_the_index(kind: str, claim: str, wanted: str) -> None:
    check(judged(kind, claim, INDEXED, INDEX), wanted)
