"""Statements with several real parameters: open cells, and the borders between them.

`question` finds the polynomials at which truth can change, `projection` and `lifting` cut the box
into open cells with a rational point in each, and the truth on a cell is that at its point.
`question.borders` says where that does not settle nearby points too: a `border` is solved for a
parameter and put in, which gives the same question in one parameter less (`pieces`); with one
parameter left every point is decided exactly. In two parameters a border that square roots cannot
solve is followed as a `curve`. In three or more it remains undecided unless it is shown not to
meet the domain (`coefficient_signs`, `subdivision`).

`decision` makes the verdict of all this, `domain_text` the set of truth in words.
"""
