"""Words of a claim file for what is claimed."""

from __future__ import annotations

from collections.abc import Mapping

CLAIM_KINDS = (
    "identity",
    "inequality",
    "definition",
    "recursion",
    "limit",
    "asymptotics",
    "value",
    "monotone",
    "location",
    "solutions",
    "steady_state",
    "implication",
    "equivalence",
    "determines",
    "stability",
    "optimum",
    "ordering",
    "dimension",
    "invertible",
    "unbiased",
    "covariance",
    "remark",
)
"""What a claim may be.

* `identity`, `inequality`: the relations hold on the domain, given the setting and its definitions;
* `definition`: nothing to decide but dimensions;
* `recursion`: holds for every sample of the setting's filter, whose states are those of the batch;
* `limit`: what the left side tends to where the one condition with an arrow says;
* `asymptotics`: the left side equals the right one up to a term of the stated order, where the one
  condition with an arrow says: `f = a x + O(x^2)`, or `f \\sim g`;
* `value`: the number printed is the exact value, rounded to the digits shown;
* `monotone`: the first of `about` grows or falls, as `trend` says, with the second;
* `location`: the roots of `polynomial` in `variable`, or those that the formula lists, lie `where`;
* `solutions`: the equation has `number` different real solutions in `variable`;
* `steady_state`: the formula is a fixed point of `recursion`, in which `previous` is the value
  before;
* `implication`: the relations printed first imply those of the trailing parenthesis (or of the
  right of an arrow);
* `equivalence`: the same in both directions;
* `determines`: each symbol of `about` fixes the others in this setting;
* `stability`: the filter with free gains is stable exactly where the conditions hold, or as `sense`
  says;
* `optimum`: the gains that the formula states are the one minimum of `minimised` while `fixed`
  stays;
* `ordering`: `compared` rises strictly along the filters `ascending`, all with the same `fixed`;
* `dimension`, `invertible`, `unbiased`, `covariance`: of matrices of every size: the shape is the
  one said, there is an inverse, a mean is the one said, a mean of squares is;
* `remark`: a sentence without decidable content; its note says why.
"""

TRENDS = ("increasing", "decreasing", "nondecreasing", "nonincreasing")
"""How the subject of a claim of kind `monotone` changes; the first two are strict."""

SENSES = ("exact", "sufficient", "necessary", "unstable")
"""How conditions of a claim of kind `stability` are meant: stable exactly where they hold, wherever
they do, only where they do, nowhere where they do.
"""

LOCATIONS = ("inside the unit circle", "left half plane", "real", "complex", "equal")
"""Where the roots of a claim of kind `location` lie; `equal`: all in one place."""

ORIGINS = ("printed", "words", "reconstructed", "ours")
"""Where a claim comes from: what it says is printed in the source as a formula; the source has
words, which are read as it; the formula of the source is lost or not legible, and this one is made
in its place; the source does not say it, but other claims rest on it or it goes further.
"""


def usual_origin(claim: Mapping[str, object]) -> str:
    """The origin of a claim that does not say it, by its fields: one with `text`, or without a
    formula, is read out of words; one with an excerpt was seen.
    """
    has_formula = "latex" in claim or "plain" in claim
    return "printed" if has_formula and ("text" not in claim or "quoted" in claim) else "words"
