"""Certificates of answers, which `gainproof.verify.check_answer` decides: one file, without judge.
Those about matrices of any size are decided by `gainproof.verify.check_matrices`.

The evidence of a verdict names its statement in base variables, and what symbols of the source are.
Both are written here as that file reads them, and it decides: what it does not accept is not given
out.
"""

from __future__ import annotations

import contextlib
import json
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product
from time import process_time
from typing import Any

from gainproof.verify import check_answer, check_matrices
from gainproof.verify.judge.answer_lines import OF_MODEL, Said, Writer
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.certificate import boxes_from, statement_from
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of, walk
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.exact.witness import free_values
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.matrix_certificate import matrix_certificate

Data = dict[str, Any]
Graph = Mapping[str, Any]
SECONDS = 5
"""Of the processor, after which no proof is looked for any more."""
KINDS = ("identity", "inequality", "recursion", "value")
"""Claims whose statement is what their formula says."""
NO_SYMBOLS = re.compile(
    r"\\(?:begin|end)\s*\{\w+\}|\^\s*(?:\{\\mathsf\s*\{T\}\}|\{(?:\\mathsf\s*)?T\}|T)|\be\s*(?=\^)"
    r"|\\(?:[dt]?frac|sqrt|left|right|[bB]igg?[lr]?|cdot|times|quad|qquad|partial|pi|[lr]vert|prime|sinh?"
    r"|cosh?|tanh?|exp|over|approx|equiv|leq?|geq?|neq?|lt|gt|leqslant|geqslant|pm|mp)(?![a-zA-Z])"
    r"|\\(?:mathrm|mathbf|boldsymbol|displaystyle|limits)(?![a-zA-Z])|\\[^a-zA-Z]"
)
"""What is no symbol in a formula: layout, signs, functions, transposes, Euler's number."""
UNKEPT = "what a symbol of the formula stands for is not kept"
OF_MATRICES = re.compile(
    r"(?<![A-Za-z\\])[IO](?:_(?:\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}|\w))?|\bE\b"
    r"|\\Rightarrow|\\underline\s*\{0\}|\\underline 0"
)
"""Unit matrix and zero with their sizes, a mean, what follows."""


class NoCertificateError(ValueError):
    """Why there is no certificate."""


def answer_certificate(claim: Mapping[str, Any], formula: str = "") -> Data:
    """The certificate of a claim of `check --json`, of a formula as it was typed if that is not
    the claim's. Raises NoCertificateError.
    """
    latex, typed = (" ".join(text.split()) for text in (claim["latex"], formula or claim["latex"]))
    claim = {**claim, "typed": typed if typed == latex else f"{typed}, read as {latex}"}
    if claim["verdict"] not in ("proved", "refuted", "conditional"):
        raise NoCertificateError(f"the verdict is {claim['verdict']}")
    evidence = claim["evidence"]["certificate"] or {}
    in_words = isinstance(evidence.get("words"), list) and claim["verdict"] == "proved"
    if claim["kind"] not in KINDS and not in_words:
        raise NoCertificateError(f"the claim is of kind {claim['kind']}")
    statement = evidence.get("asked", evidence.get("statement"))
    try:
        if in_words:
            found, names = matrix_certificate(claim, evidence["words"])
            if left := unexplained(OF_MATRICES.sub(" ", claim["latex"]), names):
                raise NoCertificateError(f"{UNKEPT}: {left}")
            return found
        if statement is not None:
            return _certificate(claim, evidence, statement)
    except (
        ArithmeticError,
        SyntaxError,
        TimeoutError,
        Malformed,
        KeyError,
        TypeError,
        ValueError,
    ) as error:
        raise NoCertificateError(str(error)) from None
    method = claim["evidence"]["method"]
    raise NoCertificateError(f"no statement about numbers is kept of what rests on: {method}")


def rejected(certificate: Mapping[str, Any]) -> str | None:
    """Why the file does not accept it; None if it does."""
    checker = check_matrices if certificate.get("format") == check_matrices.FORMAT else check_answer
    try:
        checker.Certificate(certificate).decide()
    except Exception as reason:  # noqa: BLE001  as in the file itself
        return str(reason)
    return None


def _certificate(
    claim: Mapping[str, Any], evidence: Mapping[str, Any], data: Mapping[str, Any]
) -> Data:
    """What the claim says, and its proof. Raises ValueError and others."""
    statement, boxes, _, labels = statement_from(data)
    if statement.connective != "if":
        raise Malformed("an equivalence or implication")
    graphs = {**evidence.get("other symbols", {}), **evidence.get("quantities", {})}
    meanings = {t: read_graph(graph) for t, graph in graphs.items()}
    # of several that are the same the first, but entries of matrices stand for themselves alone
    several = Counter(e.key for e in meanings.values())
    shared = {e.key for t, e in meanings.items() if "[" in t and several[e.key] > 1}
    tokens = {
        e.key: symbol(t)
        for t, e in [*meanings.items()][::-1]
        if e.kind not in ("symbol", "number") and e.key not in shared
    }

    def in_tokens(expr: Expr) -> Expr:
        return rebuilt(expr, lambda node, _: tokens.get(node.key))

    relations = [
        Rel(r.operator, in_tokens(r.left), in_tokens(r.right)) for r in statement.relations
    ]
    needed = [in_tokens(expr) for expr in statement.needed]
    used = symbols_of(*needed, *(side for r in relations for side in (r.left, r.right)))
    letters = {**meanings, **{t: read_graph(g) for t, g in evidence.get("letters", {}).items()}}
    # symbols that stand for the same are one letter in the formula, and a line each
    keys = {meanings.get(name, symbol(name)).key for name in used}
    used |= {token for token, expr in meanings.items() if expr.key in keys}
    others = evidence.get("other symbols", ())
    used |= {token for token in others if symbols_of(meanings[token]) <= {*boxes}}
    letters = {
        token: expr
        for token, expr in letters.items()
        if token in used and labels.get(str(expr.value), expr.value) != token
    }
    for token in evidence.get("means", ()):
        if any(name == token or name.startswith(f"{token}[") for name in letters):
            raise NoCertificateError(f"a mean, that of {token}")
    for token in evidence.get("of the filter", ()):
        if token not in used:
            raise NoCertificateError(f"{token} of the filter is not kept in the statement")
        if not any(OF_MODEL.fullmatch(name) for name in symbols_of(letters[token])):
            raise NoCertificateError(f"that {token} is of the filter is not kept")
    of_filter = {meanings[token].key for token in evidence.get("of the filter", ())}
    sides = [side for r in statement.domain for side in (r.left, r.right)]
    if any(node.key in of_filter for node in walk(*sides)):
        raise NoCertificateError("a condition on quantities of the filter")
    model: dict[str, list[list[Expr]]] = {}
    if any(OF_MODEL.fullmatch(name) for name in symbols_of(*letters.values())):
        model = {
            name: [[read_graph(graph) for graph in row] for row in rows]
            for name, rows in evidence["model"].items()
        }
        boxes = {**boxes_from(evidence["domain of the model"]), **boxes}
    entries = [entry for rows in model.values() for row in rows for entry in row]
    spoken = symbols_of(*statement.exprs(), *letters.values(), *entries)
    boxes = {name: boxes[name] for name in sorted(spoken) if not OF_MODEL.fullmatch(name)}
    names = [labels.get(name, name) for name in boxes]
    said = Said(
        typed=claim["typed"],
        # the statement is that under the first convention
        convention=(claim["convention"] or "").removeprefix("any of: ").partition("; ")[0],
        partial=any(word in (claim["domain"] or "") for word in PARTIAL),
        boxes={labels.get(name, name): box for name, box in boxes.items()},
        given=tuple(_turned(r) for r in statement.domain),
        model=model,
        letters=letters,
        relations=tuple(relations),
        needed=tuple(needed),
        labels=labels,
    )
    for rel in relations if not model else ():
        meant = letters.get(str(rel.left.value), rel.left) if rel.left.kind == "symbol" else None
        if rel.left.key == rel.right.key and meant and meant.kind not in ("symbol", "number"):
            raise NoCertificateError(f"only that it is itself is kept of {rel.left.value}")
    if left := unexplained(claim["latex"], (*said.boxes, *said.letters)):
        raise NoCertificateError(f"{UNKEPT}: {left}")
    refutes = claim["verdict"] == "refuted"
    points = _inner_points(said.boxes)
    if refutes:
        points = _points((claim["evidence"]["witness"] or {}).get("point", {}), boxes, names)
    reason, latest = "no point was found", process_time() + SECONDS
    claims = [(rel,) for rel in relations] if refutes else [tuple(relations)]
    for point, chosen in product(points, claims):
        try:
            writer = Writer(replace(said, relations=chosen), point, refutes, latest)
            found = {"format": check_answer.FORMAT, **writer.written()}
            if len(json.dumps(found)) > check_answer.MOST_BYTES - 10_000:
                raise TimeoutError("its proof is too long")
            check_answer.Certificate(found).decide()
            return found
        except ValueError as error:
            reason = str(error)
    raise ValueError(reason)


PARTIAL = "has a value", "not zero", "!="
"""In a domain's words."""


def unexplained(latex: str, tokens: Iterable[str]) -> str:
    """What is left of a formula, read as text, without its symbols; empty if no letter is."""
    text = NO_SYMBOLS.sub(" ", latex)
    if re.search(r"\{\s*d\b[^{}]*\}\s*\{\s*d|\{d\}", latex):  # a derivative, an integral
        text = re.sub(r"(?<![A-Za-z\\])d(?![a-z])|(?<=\{)d|\{d\}", " ", text)
    text = _plain(text)
    known = {_plain(re.sub(r"^free |\[[\d, ]*\]$", "", token)) for token in tokens}
    for token in sorted(known, key=len, reverse=True):
        before = r"(?<![\\_])" if token[:1].isalpha() else ""
        # not in the name of a command
        sought = rf"{before}({re.escape(token)})(?![_'])|\\[A-Za-z]+"
        text = re.sub(sought, lambda found: " " if found[1] else found[0], text)
    return " ".join(text.split()) if re.search("[A-Za-z]", text) else ""


def _plain(latex: str) -> str:
    """Without braces round what an index or accent has."""
    old, text = "", latex
    while old != text:
        old, text = text, re.sub(r"(_|\\[a-zA-Z]+)\s*\{([^{}]*)\}", r"\1 \2", text)
    text = re.sub(r"[{}]", " ", text)
    accent = r"\\(?:hat|bar|tilde|d+ot|underline|vec|check|breve)"
    several = rf"(?:{accent}\s+){{2,}}"
    text = re.sub(several, lambda found: " ".join([*sorted(found[0].split()), ""]), text)
    return re.sub(rf"(_|{accent})\s+", r"\1", text).strip()


def _inner_points(boxes: Mapping[str, Box]) -> Iterator[dict[str, str]]:
    """Simple ones inside."""
    spreads = ((1, 2, 3, 5, 7), (2, 1, 5, 1, 4), (13, 3, 11, 17, 6), (3, 2, 1, 9, 1))
    scales = Fraction(1), Fraction(1, 4), Fraction(1, 20), Fraction(20)
    for scale, spread in product(
        scales if boxes else scales[:1], spreads if boxes else spreads[:1]
    ):
        point = {}
        for k, (name, box) in enumerate(boxes.items()):
            step = scale * (spread[k % 5] + k // 5)
            if box.lower is not None and box.upper is not None:
                value = box.lower + (box.upper - box.lower) * step / (step + 1)
            elif box.lower is None and box.upper is None:
                value = step - Fraction(7, 2)
            else:
                value = box.lower + step if box.lower is not None else (box.upper or 0) - step
            point[name] = str(Fraction(value // 1) if box.integer else value)
        yield point


def _points(
    witness: Mapping[str, str], boxes: Mapping[str, Box], names: Sequence[str]
) -> Iterator[dict[str, str]]:
    """That of the witness if it is in these variables and rational, then simple ones."""
    with contextlib.suppress(KeyError, ValueError):  # it may be told in other variables
        yield {name: str(Fraction(witness[name])) for name in names}
    for values in free_values(tuple(boxes), boxes):
        yield _named(names, values)


def _named(names: Iterable[str], values: Iterable[Fraction]) -> dict[str, str]:
    return {name: str(value) for name, value in zip(names, values, strict=True)}


def _turned(rel: Rel) -> Rel:
    """With a symbol that is alone on one side on the left."""
    if rel.right.kind == "symbol" and rel.left.kind != "symbol":
        return Rel(TURNED.get(rel.operator, rel.operator), rel.right, rel.left)
    return rel
