"""Block 102: each track at most one detection, each detection at most one track, so that the sum of
squared distances is the least.

A track without a detection counts as the gate's limit: the sum over all tracks of min(d^2, limit)
is least among all assignments within the gate.
"""

from __future__ import annotations

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.tracking.arrays import Ints
from gainproof.tracking.gating import Pairs

MISSING = "tracks need SciPy: pip install 'gainproof[tracking]'"


def require_scipy() -> None:
    """BadInputError that says how to get SciPy where there is none."""
    from importlib import util

    if util.find_spec("scipy") is None:
        raise BadInputError(MISSING)


def assigned(tracks: int, pairs: Pairs, limit: float) -> Ints:
    """For each track its detection, -1 for none."""
    found = np.full(tracks, -1)
    if not pairs.track.size:
        return found
    rivals = np.bincount(pairs.track)[pairs.track] + np.bincount(pairs.detection)[pairs.detection]
    alone = rivals == 2
    found[pairs.track[alone]] = pairs.detection[alone]
    if not alone.all():
        rest = ~alone
        track, chosen = _matched(pairs.part(rest), limit)
        found[track] = chosen
    return found


def _matched(pairs: Pairs, limit: float) -> tuple[Ints, Ints]:
    """Those that SciPy matches: every track has a column of its own for no detection.

    Weights are 1 above their costs, as the sparse matching takes a weight of 0 for no edge; each
    track has exactly one edge, so that this changes no order.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import min_weight_full_bipartite_matching

    tracks, row = np.unique(pairs.track, return_inverse=True)
    detections, column = np.unique(pairs.detection, return_inverse=True)
    n, m = len(tracks), len(detections)
    own = np.arange(n)
    weights = np.concatenate([1 + pairs.squared, np.full(n, 1 + limit)])
    places = np.concatenate([row, own]), np.concatenate([column, m + own])
    matched_row, matched = min_weight_full_bipartite_matching(
        csr_array((weights, places), shape=(n, m + n))
    )
    seen = matched < m
    return tracks[matched_row[seen]], detections[matched[seen]]
