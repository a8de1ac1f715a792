"""Where the derivation meets the source's own equations, before it comes to its closed form."""

from __future__ import annotations

PLACES = {
    "model": "These are the source's (1) to (8); it writes `Phi` for `F`, and its `sigma_a` is the "
    "standard deviation of an acceleration.",
    "index": "The source's `A` (14a) is `Lambda^2`.",
    "ratio": "This is the source's `S` (15).",
    "filter": "These are the source's (9) to (11), held still; its `P` with a tilde (12) is our "
    "`P`, its `P` with a hat (13) our `U`, with the indices 1, 2, 3 for 11, 12, 22.",
    "position": "`P11` in these units is the source's `G1`.",
    "gain": "The four entries are those of the source's (18).",
    "velocity-absent-innovation-ratio": "The limit of `P11` is the subject of the source's (20).",
    "velocity-known-updated-11": "The limit of `P11` is the subject of the source's (21).",
    "improvement": "The source draws it in figure 3.",
    "width-range": "The source draws `S1` in figure 2.",
}
"""What the source says at a step of the derivation, by the step's id."""
