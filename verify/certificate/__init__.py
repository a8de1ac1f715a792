"""Certificates: proofs as data, decided exactly by a checker small enough to be read.

A certificate holds the model, the claims, and for each claim the numbers from which it can be
decided: polynomials, cofactors, positive forms. It holds no conclusion. The checker forms
residuals, derivatives, limits, minors and Schur-Cohn rows itself, in integers and fractions, and
uses no library but Python's own. It is sound, not complete: what it accepts is true at every point
of the stated domain; a true statement with poor evidence is rejected.

    from pathlib import Path
    from gainproof.verify.certificate import check, read_certificate
    report = check(read_certificate(Path("random_acceleration.json")), claims=expected)
    report.accepted, report.reason, report.statements

A certificate that is right about something else is worthless, so tell :func:`check` what you
expect: ``claims``, ``model``, ``domain``, ``programs`` and ``towers``, which alone say what the
names in a claim stand for. Nothing in a file makes the functions here raise or run on: malformed,
huge or hostile data is rejected with a reason.

The file
--------
JSON in UTF-8, no key twice, every record with exactly the fields given here::

    {"format": "gainproof certificate 1", "subject": text,
     "towers": {name: tower, ...}, "programs": {name: program, ...}, "statements": [statement, ...]}

Names are ASCII: a letter, then letters, digits and underscores, at most 64. Numbers are text in
lowest terms: "3", "-1/2", "0". Integers are JSON integers. Every tower, variable, element, program,
constant, listed fraction, root, gap and graph node must be used by something.

Polynomial
    [[coefficient, [exponents]], ...]: nonzero coefficients, exponents over all variables of the
    tower in order (parameters, generators, then the statement's free symbols), terms in strictly
    descending order of exponents; [] is zero.
Fraction
    {"num": polynomial, "den": polynomial}; "den" manifestly positive.
Tower
    {"parameters": [...], "generators": [...], "elements": {name: fraction, ...}}. Parameter:
    {"symbol", "above": "0"} is p > 0, {"symbol", "from": number} is k >= number. Generator:
    {"symbol", "power": n, "radicand": polynomial in earlier variables}: the positive real y with
    y^n = radicand; the radicand must be manifestly positive. Or {"coupled": [x, y], "free": [a, c],
    "slopes": [b, e]}: the two positive reals with x^2 = a + b y, y^2 = c + e x; polynomials in
    earlier variables, a, c manifestly nonnegative, b, e positive (`coupled`). Elements are
    fractions with names of their own. No name is given twice in a tower. An entry with "matrices"
    is a setting of matrices of every size; see `matrix_words` for it and for its kinds:
    matrix_equal, matrix_order, matrix_invertible, matrix_trace (definition, cited as below).
Graph
    {"nodes": [node, ...], "outputs": {name: node number}}; a node refers to earlier nodes, each
    node serves an output. Single expressions have the one output "value". Nodes: ["number", q],
    ["symbol", name], ["add", i, j, ...], ["mul", i, j, ...], ["div", i, j], ["neg", i],
    ["pow", i, q], ["call", "abs", i], ["call", "select", a, b, x, y] (x where a < b, else y),
    ["call", "unknown", s, w], ["call", "fixed_point", x, y, v] (the value of v where the unknown x
    is the positive number at which y, which holds x, equals x), ["call", "near_cbrt", i] (in what
    leads to an unknown's s only), ["matrix", rows, columns, i, ...], ["derivative", i, symbol],
    ["at", i, symbol, j]. The calls stand in programs only, "derivative" and "at" in claims only. No
    output holds an unknown but through its fixed point; an unknown has one y, and neither y nor v
    holds another. How the unknown is computed, s and w, is no matter of the certificate.
Program
    {"inputs": {symbol: name or graph}, "graph": graph}: a kernel, and for each of its symbols what
    it stands for in the tower of the statement.
Statement
    {"id", "kind", "tower": name, "claim": record, "evidence": record}; ids are unique.

Notions
-------
Manifestly positive polynomial
    Not zero, no free symbol, and every coefficient positive after writing each parameter "from" k0
    as k0 + x; and at least one term without any such x. (Positive inside: without the last
    condition, so zero is possible at a closed end only. Manifestly nonnegative: zero, or positive
    inside.) A fraction is, when its numerator is.
Value of an expression
    A reduced numerator over a product of factors. Sums are taken over the least common multiple of
    the factors, known factors are cancelled in quotients, nothing else is. Reduction divides by the
    monic relations y^n - radicand from the last generator down. Two values are equal when the
    numerator of their difference reduces to zero.
Divisor
    The reduced numerator of its value, or the negative, must be manifestly positive; else the
    value or its negative must equal a fraction listed under "nonzero" (manifestly positive), which
    then replaces it. With free symbols, one of their coefficients must pass this test: the divisor
    is then a nonzero polynomial in them at every point, and identities hold where defined.
    A listed fraction that no division needs is rejected.
Root in a claim
    ["pow", i, "m/n"]: the base must be zero, a perfect n-th power of one term over factors, or
    equal to the radicand of a generator of power n.
Derivative
    By a parameter (generators follow: y' = radicand'/(n y^(n-1)), pairs as in `coupled_roots`; the
    other parameters held) or a free symbol; by an element x in which one parameter p occurs and no
    other, also inside generators: (dE/dp)/(dx/dp), the other parameters held.
At
    The expression evaluated anew with another value of a parameter or free symbol, in elements too,
    every divisor shown nonzero there. Only in towers without generators; no derivative inside.

Kinds
-----
Every kind with its claim and its evidence; "nonzero": [fraction, ...] as above.

equal {"left": graph, "right": graph, "free": [names]}; {"nonzero"}
    Numbers, or matrices of one shape. Free symbols must be new names and occur.
positive {"expression": graph}; {"value": fraction, "nonzero"}
    The value is manifestly positive and equals the expression.
same_sign {"left": graph, "right": graph}; {"factor": fraction, "nonzero"}
    left = factor * right, not both zero; the factor is manifestly positive.
limit {"expression": graph, "variable": name, "point": "0" | "infinity", "value": graph |
"infinity"}; {"weights", "constants", "boundary", "nonzero"} and possibly "form": fraction
    For every fixed value of the other parameters; nothing is said of parameters tending together.
    The variable is a parameter, or an element of one parameter alone that tends to the point with
    it and only then. "weights": {generator: integer w}: with the parameter as x (at 0) or 1/x
    (at infinity) the generator is Y x^(-w); w <= 0 at 0, w >= 0 at infinity. "constants":
    [{"symbol", "power", "radicand"}, ...]: positive roots over the other parameters and earlier
    constants, exponents over the other parameters, then all constants. "boundary": {generator:
    polynomial over these}: the value of Y at x = 0, manifestly nonnegative and a root of the
    rescaled relation at x = 0, which may hold no negative power of x (pairs: `coupled_boundary`).
    Weights and boundary name every generator. The lowest powers of x above and below the line give
    the limit; their coefficients at the boundary must have plain signs (positive or negative for
    all values of the other parameters, manifestly). A "form" equals the expression and takes its
    place where its own coefficients have no plain sign; one that is not needed is rejected. "value"
    is made of numbers, of names in which the tending parameter does not occur, and of roots, which
    must be known: of the radicands of the constants, or perfect.
increasing_onto {"expression": graph, "variable": name, "from": graph, "to": graph | "infinity"};
{"derivative": fraction, "start": limit evidence, "end": limit evidence, "nonzero"}, possibly "form"
    For every fixed value of the other parameters the expression increases strictly with the
    variable (a parameter, or an element of it alone that runs from 0 to infinity with it) and takes
    every value between the limits at the two ends of its domain, "from" itself only if that domain
    is closed. The derivative equals the fraction, which is positive along the variable: positive
    inside, with a term that holds no closed end of another parameter. Limit evidence here is
    {"weights", "constants", "boundary"}; values and form as for a limit.
monotone {"expression": graph, "variable": name, "trend": "increasing" | "decreasing"};
{"derivative": fraction, "nonzero"}
    Strictly, for every fixed value of the other parameters. The variable is a parameter or an
    element of one alone; the derivative by it, or for "decreasing" its negative, equals the
    fraction, which is positive along the variable.
riccati {"model": model, "predicted": [[names]], "updated": [[names]], "gain": [names] or [[names]],
"index": name}
    M = F X F' + q Q0 with q = index^2, K (H M H' + R) = M H', X = M - K H M, and H M H' + R is
    positive definite. N/D is the index as the tower writes it.
    One measurement, model of numbers: the gain is a list; {"denominator": polynomial, "numerators":
    [[polynomial]], "cofactors": {"i,j": [polynomial per generator]}}. With M = A/d, a = A H' and
    s = H a + R d (d and s manifestly positive) the entries i <= j of
    D^2 (s (F A F' - A) - F a a' F') + s d N^2 Q0, expanded without reduction, equal the sums of
    cofactor times (y^n - radicand).
    A vector measurement: the gain is given by rows, as many as states; F, H and Q0 are polynomials;
    {"denominator": polynomial, "predicted": [[polynomial]], "updated": [[polynomial]], "precision":
    {"numerators": [[polynomial]], "denominator": polynomial}, "innovation": [fraction, ...],
    "prediction": {"i,j": ...}, "update": {"i,j": ...}}. M = A/d, X = B/d; R V = w I; d and w
    manifestly positive; K = X H' V/w; "innovation" are the leading minors of H M H' + R, manifestly
    positive; D^2 (A - F B F') - d N^2 Q0 (i <= j) and B (w d I + H' V H A) - w d A (all i, j) equal
    the sums of cofactor times relation as above.
stable {"model": model, "gain": [names] or [[names]]}; {"values": [fraction, ...]}
    All roots of a(z) = det(z I - F (I - K H)) lie inside the unit circle. For each degree from n
    down to 1 the manifestly positive a_n - a_0 and a_n + a_0, then a_k <- a_n a_(k+1) - a_0
    a_(n-k-1). With a gain by rows also "coefficients": a_0, ..., a_(n-1) as fractions, from which
    the values are formed.
positive_definite {"matrix": [[names]]}; {"minors": [fraction, ...]}
    The leading minors, manifestly positive.
program {"program": name, "outputs": {output: graph}} and possibly "nodes": {node: graph};
{"roots": {node: fraction}, "branches": {node: choice}, "gaps": {node: fraction}, "nonzero"}
    The program's outputs equal the claimed expressions, and so do the nodes claimed, which these
    outputs need and which are written so in what follows. Each evaluated fractional power has its
    root: manifestly nonnegative, its power equal to the base. Each evaluated call has a branch and
    a gap: select "then" with b - a manifestly positive, "else" with a - b manifestly nonnegative,
    the other branch not evaluated; abs "positive" or "negative" with its argument or the negative
    manifestly nonnegative. Each evaluated unknown x has its value among the roots: manifestly
    positive, and y equals it there. That it is the only one is decided by the shape of y: sums,
    products, quotients and powers of x and of nodes without x that are shown positive (manifestly,
    or made of such by the same operations), with a logarithmic slope below 1, where that of x is 1,
    of a product the sum, of a quotient the difference, of a power the multiple, and of a sum any
    between the least and the greatest of its terms. Node numbers are keys, as text.
sum {"index": name, "start": integer as text, "upper": parameter, "summand": graph, "closed":
graph}; {}
    For every integer upper of the parameter's domain the sum over index = start..upper is the
    closed form. The parameter is {"from": at least start}, the tower has no generators, both are
    polynomials.
definition {"text": text} or {"left": graph, "right": graph}; {}
    Decided only if the left side is one symbol of the tower: then the two must be equal.
cited {"theorem": text, "reference": text}; {}
    Reported as cited, never as proved.

model is {"name", "title", "transition", "process_noise", "measurement", "measurement_noise"}: rows
of number texts or graphs over names of the tower, in units that make T and the first measurement's
deviation 1. F is n by n, H m by n, R m by m; process_noise is Q0, symmetric, its principal minors
manifestly nonnegative; R is symmetric, its leading minors manifestly positive. A name in an entry
stands for all values that the tower gives it: every one if it is a parameter. All statements of a
certificate that have a model have the same one.
"""

from __future__ import annotations

from gainproof.verify.certificate.certificate_file import read_certificate
from gainproof.verify.certificate.checker import check, check_statement
from gainproof.verify.certificate.rejection import MalformedError, RejectedError
from gainproof.verify.certificate.report import CertificateReport, StatementResult

__all__ = [
    "CertificateReport",
    "MalformedError",
    "RejectedError",
    "StatementResult",
    "check",
    "check_statement",
    "read_certificate",
]
