"""What is made least or compared is among what a claim depends on: under conventions that differ in
it alone it is judged under each.
"""

from __future__ import annotations

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim_symbols import reached

TEXT = r"""
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[settings.s]
title = "s"
kind = "fixed_gain"
states = 2
covariance = "search"
filters = { one = ['\beta = b'], two = ['\beta = \alpha'] }
[settings.s.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "gain" }
'p' = { quantity = "covariance.1.1", meaning = "variance" }
'e' = { quantity = "predicted_lag.1.2", meaning = "lag" }
'b' = { unit = "1", meaning = "number" }
[[claims]]
id = "least"
place = "p"
kind = "optimum"
setting = "s"
latex = '\alpha = \sqrt{\beta}'
minimised = 'p'
fixed = ['e']
[[claims]]
id = "order"
place = "p"
kind = "ordering"
setting = "s"
text = "two is better"
compared = 'p'
fixed = ['e']
ascending = ["one", "two"]
"""


def test_it_is_reached() -> None:
    claim_file = read_claim_text(TEXT)
    setting = claim_file.settings["s"]
    least, order = (reached(claim, setting) for claim in claim_file.claims)
    assert {"p", "e"} <= least
    assert {"p", "e", "b"} <= order
