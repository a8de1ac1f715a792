"""What proofs on location in multipath use besides their conditions: see `pages.matrices`."""

from __future__ import annotations

from typing import Any

HINTS: dict[str, dict[str, Any]] = {
    "weight-definite": {"squares": [("V^-1", 1, {"left_inverse": "V"})]},
    "information-definite": {
        "using": ["information-regular"],
        "squares": [("A", "weight-definite", {"left_inverse": "M^-1 A' V^-1"})],
    },
    "covariance-symmetric": {"using": ["weight-symmetric", "information-regular"]},
    "covariance-definite": {"squares": [("M^-1", "information-definite", {"left_inverse": "M"})]},
    "least-cost": {"squares": [("x - a_e", "information-definite")]},
    "only-estimate": {"definite": "information-definite", "side": "left"},
    "error-of-estimate": {"heavy": ["z"]},
    "unbiased": {"heavy": ["z_m"]},
    "product-of-errors": {"using": ["information-regular"], "heavy": ["z"]},
    "part-error": {"heavy": ["z"]},
    "part-unbiased": {"heavy": ["z_m"]},
    "part-definite": {"squares": [("N'", "covariance-definite", {"left_inverse": "N"})]},
    "part-variance": {"squares": [("N' e", "covariance-definite", {"left_inverse": "e' N"})]},
    "full-information": {
        "using": ["gram-regular"],
        "squares": [("A", "weight-definite", {"left_inverse": "A2^-1 A'"})],
    },
    "gram-from-information": {
        "using": ["information-regular"],
        "squares": [("A", ("unit", "m"), {"left_inverse": "M^-1 A' V^-1"})],
    },
    "gram-from-rank": {"squares": [("A", ("unit", "m"))], "rank": 1},
    "no-null-vector": {"using": ["gram-regular"], "taken": [("A2^-1 A'", 1, "unit_one")]},
    "design-vanishes": {"definite": "weight-definite", "side": "left"},
    "vector-vanishes": {
        "using": ["gram-regular"],
        "taken": [("A2^-1 A'", "design-vanishes", "unit_one")],
    },
    "information-not-negative": {"squares": [("A", "weight-definite")]},
    "fewer-information-definite": {"squares": [("U", "information-definite")], "rank": 3},
    "least-covariance": {
        "using": [
            "noise-regular",
            "weight-symmetric",
            "information-regular",
            "covariance-symmetric",
        ],
        "squares": [("(K_x - N K)'", 1)],
    },
    "only-least": {"definite": 1, "side": "right"},
    "fewer-whole": {
        "using": [
            "weight-symmetric",
            "information-regular",
            "covariance-symmetric",
            "fewer-regular",
        ],
        "squares": [("M^-1 - U M_U^-1 U'", "information-definite")],
    },
    "fewer-symmetric": {"using": ["weight-symmetric", "fewer-regular"]},
    "fewer-unknowns": {
        "using": [
            "weight-symmetric",
            "information-regular",
            "covariance-symmetric",
            "fewer-regular",
        ],
        "squares": [("(M^-1 - U M_U^-1 U') N'", "information-definite")],
    },
    "fewer-equal": {"definite": 1, "side": "right"},
    "same-spread": {"using": []},
    "equal-back": {
        "taken": [
            ("-I_k", "own-spread", "I_k"),
            ("I_k", "same-spread", "I_k"),
            ("I_k", "fewer-spread", "I_k"),
        ]
    },
    "range-model": {"heavy": ["z"]},
    "doppler-model": {"heavy": ["z"]},
    "location-weight-definite": {"squares": [("V^-1", 1, {"left_inverse": "V"})]},
    "range-noise-definite": {"squares": [("E_l", 1, {"left_inverse": "E_l'"})]},
    "doppler-noise-definite": {"squares": [("E_d", 1, {"left_inverse": "E_d'"})]},
    "g11-definite": {"squares": [("E_l", "location-weight-definite", {"left_inverse": "E_l'"})]},
    "g11-inverse-symmetric": {"using": ["location-weight-symmetric", "g11-regular"]},
    "gram-schur": {"squares": [("N_a' - S_b D12'", 1, {"left_inverse": "N_a"})]},
    "gram-corner": {"squares": [("N_a'", 1, {"left_inverse": "N_a"})]},
    "projection": {"squares": [("(I_n - H H') A_l", ("unit", "n"))]},
    "kept-schur": {"squares": [("(I_n - H H') A_l T_l'", ("unit", "n"))]},
    "kept-schur-definite": {
        "squares": [
            ("I_k", "gram-schur", {"left_inverse": "I_k"}),
            ("(I_n - H H') A_l T_l'", ("unit", "n")),
        ]
    },
    "kept-gram-definite": {"squares": [("U", 1, {"left_inverse": "N_nb' N_a + U_b H' S_b'"})]},
    "full-information-definite": {
        "using": ["full-gram-regular"],
        "squares": [("A", "location-weight-definite", {"left_inverse": "A2^-1 A'"})],
    },
    "full-information-inverse-symmetric": {
        "using": ["location-weight-symmetric", "full-information-regular"]
    },
    "kept-information-definite": {
        "squares": [("U", "full-information-definite", {"left_inverse": "N_nb' N_a + U_b H' S_b'"})]
    },
    "kept-information-inverse-symmetric": {
        "using": ["location-weight-symmetric", "kept-information-regular"]
    },
    "doppler-gram-definite": {"squares": [("W", 1, {"left_inverse": "N_a"})]},
    "gram-from-doppler": {
        "squares": [
            ("E_l' A", ("unit", "n"), {"left_inverse": "S_b"}),
            ("N_a", 1, {"left_inverse": "W"}),
        ]
    },
    "bias-information-definite": {"squares": [("H", "g11-definite", {"left_inverse": "H'"})]},
    "bias-information-inverse-symmetric": {
        "using": ["location-weight-symmetric", "bias-information-regular"]
    },
    "kept-covariance-product": {
        "taken": [
            ("N_nb", ("inverse", "kept-information-regular", "right"), "N_nb'"),
            ("(-K12) G_b^-1 U_b'", ("inverse", "kept-information-regular", "right"), "N_nb'"),
        ]
    },
    "kept-covariance-inverse-regular": {
        "taken": [("-I_k", "kept-covariance-product", "I_k")],
        "left_inverse": "K11 - K12 G_b^-1 K12'",
    },
    "kept-covariance-inverse": {
        "taken": [
            ("-I_k", "kept-covariance-product", "C_nb^-1"),
            (
                "K11 - K12 G_b^-1 K12'",
                ("inverse", "kept-covariance-inverse-regular", "right"),
                "I_k",
            ),
        ]
    },
    "kept-covariance-inverse-short": {"taken": [("I_k", "kept-covariance-inverse", "I_k")]},
    "bias-weight-definite": {
        "squares": [("G_b^-1", "bias-information-definite", {"left_inverse": "G_b"})]
    },
    "bias-share": {"squares": [("H'", "bias-weight-definite")]},
    "taken-away": {"squares": [("H' P", "bias-weight-definite")]},
    "clean-information-definite": {
        "squares": [("N_a'", "full-information-definite", {"left_inverse": "N_a"})]
    },
    "clean-information-inverse-symmetric": {
        "using": ["location-weight-symmetric", "clean-information-regular"]
    },
    "f22-definite": {"squares": [("H_S", 1, {"left_inverse": "H_S'"})]},
    "c33-definite": {"squares": [("H_L", 1, {"left_inverse": "H_L'"})]},
    "padded-below": {
        "taken": [
            ("-I_t", ("inverse", "f22-regular", "left"), "F22^-1"),
            ("I_t", ("inverse", "f22-regular", "left"), "Q_t"),
            ("Q_t", ("inverse", "f22-regular", "right"), "I_t"),
        ],
        "squares": [("F22^-1 - Q_t", "f22-definite")],
    },
    "shares-ordered": {"squares": [("H_S'", "padded-below")]},
    "c33-inverse-definite": {"squares": [("C33^-1", "c33-definite", {"left_inverse": "C33"})]},
    "share-not-negative": {"squares": [("H_L'", "c33-inverse-definite")]},
    "information-ordered": {"squares": [("H_S' P", "padded-below")]},
    "large-definite": {
        "squares": [("I_k", "information-ordered"), ("I_k", 1, {"left_inverse": "I_k"})]
    },
    "small-inverse-symmetric": {
        "taken": [
            ("-I_k", ("inverse", "small-regular", "left"), "(M_S^-1)'"),
            ("-M_S^-1", 1, "(M_S^-1)'"),
            ("M_S^-1", "small-inverse-symmetric-transposed", "I_k"),
        ]
    },
    "large-inverse-symmetric": {
        "taken": [
            ("-I_k", ("inverse", "large-regular", "left"), "(M_L^-1)'"),
            ("-M_L^-1", 1, "(M_L^-1)'"),
            ("-M_L^-1", "gap-symmetric", "(M_L^-1)'"),
            ("M_L^-1", "large-inverse-symmetric-transposed", "I_k"),
        ]
    },
    "covariances-ordered": {
        "aside": ["small-regular", "large-regular"],
        "taken": [
            ("-I_k", ("inverse", "small-regular", "left"), "M_S^-1"),
            ("I_k", ("inverse", "small-regular", "left"), "M_L^-1"),
            ("M_L^-1", ("inverse", "small-regular", "right"), "I_k"),
            ("-I_k", ("inverse", "large-regular", "left"), "M_L^-1"),
        ],
        "squares": [("M_S^-1 - M_L^-1", 1), ("M_L^-1", "information-ordered")],
    },
    "range-weight-regular": {
        "taken": [("-I_n", "range-weight-product", "I_n")],
        "left_inverse": "G11",
    },
    "range-weight": {
        "taken": [
            ("-I_n", "range-weight-product", "V_given^-1"),
            ("G11", ("inverse", "range-weight-regular", "right"), "I_n"),
        ]
    },
    "range-weight-inverse": {
        "taken": [
            ("G11^-1", "range-weight-product", "-I_n"),
            ("I_n", ("inverse", "g11-regular", "left"), "V_given"),
        ]
    },
    "cross-ratio": {"taken": [("V_d^-1 V_ld'", ("inverse", "g11-regular", "right"), "-I_n")]},
    "doppler-weight": {"taken": [("-I_n", "cross-ratio", "G12")]},
    "crossing": {
        "taken": [("I_k", "mixed", "I_n"), ("T_l A_ld' + T_d A_l'", "cross-ratio", "I_n")]
    },
    "rest-doppler": {"taken": [("I_k", "rest-square", "I_k"), ("B'", "doppler-weight", "B")]},
    "doppler-weight-definite": {
        "squares": [("V_d^-1", "doppler-noise-definite", {"left_inverse": "V_d"})]
    },
    "doppler-information-definite": {
        "using": ["doppler-gram-regular"],
        "squares": [("B", "doppler-weight-definite", {"left_inverse": "B2^-1 B'"})],
    },
    "doppler-information-inverse-symmetric": {
        "using": ["doppler-noise-inverse-symmetric", "doppler-information-regular"]
    },
    "rest-product": {
        "taken": [
            ("M_d^-1", "rest-doppler", "I_k"),
            ("I_k", ("inverse", "doppler-information-regular", "left"), "I_k"),
        ]
    },
    "rest-inverse-regular": {"taken": [("-I_k", "rest-product", "I_k")], "left_inverse": "M_d^-1"},
    "rest-inverse": {
        "taken": [
            ("-I_k", "rest-product", "R^-1"),
            ("M_d^-1", ("inverse", "rest-inverse-regular", "right"), "I_k"),
        ]
    },
    "bias-covariance-blocks": {
        "taken": [
            (
                "G11^-1 S_b' + G11^-1 P R^-1 (P' G11^-1 S_b' - N_a)",
                ("inverse", "full-information-regular", "right"),
                "S_b",
            ),
            ("G11^-1 P", ("inverse", "rest-inverse-regular", "left"), "N_a M_a^-1 S_b"),
        ]
    },
    "bias-covariance": {
        "using": [
            "location-weight-symmetric",
            "g11-regular",
            "g11-inverse-symmetric",
            "doppler-noise-inverse-symmetric",
            "cross-ratio",
            "rest-inverse",
        ],
        "taken": [("I_n", "bias-covariance-blocks", "I_n"), ("I_n", "range-weight-inverse", "I_n")],
    },
    "course-covariance-product": {
        "using": ["location-weight-symmetric", "g11-regular"],
        "taken": [
            ("N_a - P' G11^-1 S_b'", ("inverse", "full-information-regular", "right"), "N_a'"),
            ("-I_k", "rest-doppler", "C_a"),
        ],
    },
    "course-covariance": {
        "taken": [
            ("M_d^-1", "course-covariance-product", "I_k"),
            ("-I_k", ("inverse", "doppler-information-regular", "left"), "C_a"),
        ]
    },
    "bias-covariance-uncorrelated": {"taken": [("I_n", "bias-covariance", "I_n")]},
    "bias-variance": {
        "taken": [
            ("e'", "bias-covariance-uncorrelated", "e"),
            ("(-e') A_l T_l'", "course-covariance", "T_l A_l' e"),
        ]
    },
    "ranges-unheard": {"taken": [("N_a", ("inverse", "full-information-regular", "left"), "S_b")]},
    "doppler-heard": {"taken": [("-I_k", "ranges-unheard", "E_l' V E_d")]},
    "doppler-weights": {
        "taken": [
            ("I_k", "doppler-heard", "V_d^-1"),
            ("I_k", "course-covariance", "B' V_d^-1"),
            ("(-K) E_d", ("inverse", "doppler-noise-regular", "right"), "I_n"),
        ]
    },
    "doppler-alone": {
        "taken": [
            ("-(K - M_d^-1 B' V_d^-1 E_d')", ("blocks", "m"), "unit(m)"),
            ("I_k", "ranges-unheard", "E_l'"),
            ("I_k", "doppler-weights", "E_d'"),
        ]
    },
    "range-information-turned": {
        "using": ["range-noise-inverse-symmetric", "range-information-given"]
    },
    "clean-information-turned": {"using": ["location-weight-symmetric", "clean-information-given"]},
    "doppler-helps": {
        "using": [
            "location-noise-regular",
            "location-weight-symmetric",
            "range-noise-regular",
            "range-noise-inverse-symmetric",
            "range-information-given",
            "clean-information-given",
            "range-information-turned",
        ],
        "squares": [("(M_l^-1 A_l' V_l^-1 E_l' - T_l' M_n^-1 A_n' V^-1)'", 1)],
    },
    "heard-noise-definite": {"squares": [("E_h", 1, {"left_inverse": "E_h'"})]},
    "alone-unheard": {"taken": [("S_x'", ("inverse", "free-regular", "left"), "S_f")]},
    "heard-between": {"taken": [("-I_k", "alone-unheard", "E_f' V E_h")]},
    "heard-weights": {
        "taken": [
            ("I_k", "heard-between", "V_h^-1"),
            ("(-K) E_h", ("inverse", "heard-noise-regular", "right"), "I_r"),
        ]
    },
    "heard-product": {
        "taken": [
            ("-I_k", "heard-weights", "A_h"),
            ("S_x'", ("inverse", "free-regular", "left"), "S_x"),
            ("-I_k", "alone-unheard", "E_f' A_x"),
        ]
    },
    "heard-covariance-regular": {"taken": [("-I_k", "heard-product", "I_k")], "left_inverse": "C"},
    "heard-covariance": {
        "taken": [
            ("-I_k", "heard-product", "M_h^-1"),
            ("C", ("inverse", "heard-covariance-regular", "right"), "I_k"),
        ]
    },
    "heard-alone": {
        "taken": [
            ("-(K - M_h^-1 A_h' V_h^-1 E_h')", ("blocks", "m"), "unit(m)"),
            ("I_k", "alone-unheard", "E_f'"),
            ("I_k", "heard-weights", "E_h'"),
            ("-I_k", "heard-covariance", "A_h' V_h^-1 E_h'"),
        ]
    },
    "regular-definite": {
        "using": ["blocked-regular"],
        "squares": [("unit_both", 1, {"left_inverse": "D^-1", "through": True})],
    },
    "D11-definite": {"squares": [("E1", "regular-definite", {"left_inverse": "E1'"})]},
    "D22-definite": {"squares": [("E2", "regular-definite", {"left_inverse": "E2'"})]},
    "H1-definite": {
        "squares": [("E1 - E2 D22^-1 D12'", "regular-definite", {"left_inverse": "E1'"})]
    },
    "H2-definite": {
        "squares": [("E2 - E1 D11^-1 D12", "regular-definite", {"left_inverse": "E2'"})]
    },
    "D22-given-symmetric": {"using": ["D22-given"]},
    "inverse-by-H1-product-columns-1": {"using": ["H1-given", "D22-given-symmetric"]},
    "inverse-by-H1-product-columns-2": {"using": ["D22-given"]},
    "inverse-by-H1-product": {
        "taken": [
            (
                (
                    "-(((E1 - E2 D22^-1 D12') H1^-1 (E1 - E2 D22^-1 D12')' + "
                    "E2 D22^-1 E2') D - unit_both)"
                ),
                ("blocks", "t"),
                "unit_both",
            ),
            ("unit_both", "inverse-by-H1-product-columns-1", "E1'"),
            ("unit_both", "inverse-by-H1-product-columns-2", "E2'"),
        ]
    },
    "inverse-by-H1-regular": {
        "taken": [("-unit_both", "inverse-by-H1-product", "unit_both")],
        "left_inverse": "(E1 - E2 D22^-1 D12') H1^-1 (E1 - E2 D22^-1 D12')' + E2 D22^-1 E2'",
    },
    "inverse-by-H1": {
        "taken": [
            ("-unit_both", "inverse-by-H1-product", "D^-1"),
            (
                "(E1 - E2 D22^-1 D12') H1^-1 (E1 - E2 D22^-1 D12')' + E2 D22^-1 E2'",
                ("inverse", "inverse-by-H1-regular", "right"),
                "unit_both",
            ),
        ]
    },
    "D11-given-symmetric": {"using": ["D11-given"]},
    "inverse-by-H2-product-columns-1": {"using": ["D11-given"]},
    "inverse-by-H2-product-columns-2": {"using": ["H2-given", "D11-given-symmetric"]},
    "inverse-by-H2-product": {
        "taken": [
            (
                (
                    "-(((E2 - E1 D11^-1 D12) H2^-1 (E2 - E1 D11^-1 D12)' + "
                    "E1 D11^-1 E1') D - unit_both)"
                ),
                ("blocks", "t"),
                "unit_both",
            ),
            ("unit_both", "inverse-by-H2-product-columns-1", "E1'"),
            ("unit_both", "inverse-by-H2-product-columns-2", "E2'"),
        ]
    },
    "inverse-by-H2-regular": {
        "taken": [("-unit_both", "inverse-by-H2-product", "unit_both")],
        "left_inverse": "(E2 - E1 D11^-1 D12) H2^-1 (E2 - E1 D11^-1 D12)' + E1 D11^-1 E1'",
    },
    "inverse-by-H2": {
        "taken": [
            ("-unit_both", "inverse-by-H2-product", "D^-1"),
            (
                "(E2 - E1 D11^-1 D12) H2^-1 (E2 - E1 D11^-1 D12)' + E1 D11^-1 E1'",
                ("inverse", "inverse-by-H2-regular", "right"),
                "unit_both",
            ),
        ]
    },
    "D22-from-inverse": {
        "using": ["D22-given"],
        "squares": [("E2", 1, {"left_inverse": "D22^-1 E2'", "through": True})],
    },
    "H1-from-inverse": {
        "using": ["D22-given", "H1-given"],
        "squares": [("E1 - E2 D22^-1 D12'", 1, {"left_inverse": "H1^-1 E1'", "through": True})],
    },
    "definite-by-H1": {
        "using": ["D22-given"],
        "rounds": 1,
        "squares": [
            ("E1'", "H1-from-inverse", {"left_inverse": "E1 - E2 D22^-1 D12'"}),
            ("D22^-1 E2' D", "D22-from-inverse", {"left_inverse": "E2"}),
        ],
    },
    "D11-from-inverse": {
        "using": ["D11-given"],
        "squares": [("E1", 1, {"left_inverse": "D11^-1 E1'", "through": True})],
    },
    "H2-from-inverse": {
        "using": ["D11-given", "H2-given"],
        "rounds": 1,
        "squares": [("E2 - E1 D11^-1 D12", 1, {"left_inverse": "H2^-1 E2'", "through": True})],
    },
    "definite-by-H2": {
        "using": ["D11-given"],
        "heavy": ["E2"],
        "rounds": 1,
        "squares": [
            ("E2'", "H2-from-inverse", {"left_inverse": "E2 - E1 D11^-1 D12"}),
            ("D11^-1 E1' D", "D11-from-inverse", {"left_inverse": "E1"}),
        ],
    },
    "blocked-inverse-definite": {
        "rounds": 1,
        "squares": [("D^-1", 1, {"left_inverse": "unit_both", "through": True})],
    },
    "inverse-above-D22": {"rounds": 1, "squares": [("D^-1 - E2 D22^-1 E2'", 1)]},
    "inverse-above-D11": {"rounds": 1, "squares": [("D^-1 - E1 D11^-1 E1'", 1)]},
    "form-not-negative": {"squares": [("x", 1)]},
    "form-positive": {"squares": [("x", 1)], "rank": 2},
    "eigenvalue-not-negative": {"squares": [("u", 1)]},
    "eigenvalue-positive": {"squares": [("u", 1, {"left_inverse": "u'"})]},
    "form-from-eigenvalues": {"squares": [("U'", 1)]},
    "order-transitive": {"squares": [("unit(n)", 1), ("unit(n)", 2)]},
    "order-antisymmetric": {"above": 1, "below": 2},
    "larger-definite": {"squares": [("unit(n)", 1, {"left_inverse": "unit(n)"}), ("unit(n)", 2)]},
    "D1-inverse-definite": {"squares": [("D1^-1", "larger-definite", {"left_inverse": "D1"})]},
    "D2-inverse-definite": {"squares": [("D2^-1", 1, {"left_inverse": "D2"})]},
    "inverse-order": {
        "using": ["D2-regular", "D2-inverse-symmetric", "D1-regular"],
        "squares": [("D1^-1 - D2^-1", 1), ("D1^-1", 2)],
    },
    "diagonal-positive": {"squares": [("x", 1, {"left_inverse": "x'"})]},
    "diagonal-order": {"squares": [("x", 1)]},
    "congruence": {"squares": [("F", 1)]},
    "congruence-strict": {"squares": [("F", 1)], "rank": 2},
}
