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

from gainproof.verify import check_answer, check_matrices, check_memory
from gainproof.verify.judge.answer_lines import Writer
from gainproof.verify.judge.certificate_text import OF_MODEL, Said
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.certificate import boxes_from, statement_from
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.exact.witness import free_values
from gainproof.verify.judge.exact.work_limits import Malformed
from gainproof.verify.judge.matrix_certificate import matrix_certificate
from gainproof.verify.judge.memory_certificate import memory_certificate

Data = dict[str, Any]
Graph = Mapping[str, Any]
SECONDS = 5
"""Of the processor, after which no proof is looked for any more."""
KINDS = ("identity", "inequality", "recursion", "value")
"""Claims whose statement is what their formula says."""
NO_SYMBOLS = re.compile(
    r"\\(?:begin|end)\s*\{\w+\}|\^\s*(?:\{\\mathsf\s*\{T\}\}|\{(?:\\mathsf\s*)?T\}|T)|\be\s*(?=\^)"
    r"|\\(?:[dt]?frac|sqrt|det|left|right|[bB]igg?[lr]?|cdot|times|quad|qquad|partial|pi|[lr]vert|prime|sinh?"
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
    others = {checker.FORMAT: checker for checker in (check_matrices, check_memory)}
    try:
        others.get(certificate.get("format"), check_answer).Certificate(certificate).decide()
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

    latex = claim["latex"]
    # those in the source's own letters, which a formula may write out: K_2 = \sqrt{q/r}
    closed = evidence.get("of the filter", ()) if "A" in evidence.get("model", ()) else ()
    closed = [token for token in closed if _count(token, latex)]
    texts = latex.split("=") if latex.count("=") == len(statement.relations) == 1 else [latex] * 2

    def in_tokens(expr: Expr, text: str = "") -> Expr:
        counts = {token: _count(token, text or latex) for token in closed}
        kept = {key: t for key, t in tokens.items() if counts.get(str(t.value), 1)}
        found = rebuilt(expr, lambda node, _: kept.get(node.key))
        if any(_places(token, found) > count for token, count in counts.items()):
            raise NoCertificateError("what is a gain is not kept as it is written")
        return found

    def defined(left: Expr, right: Expr) -> Expr:
        """A definition that is all of the formula is kept as that."""
        whole = meanings.get(str(left.value), left) if left.kind == "symbol" else left
        if left.key != right.key or whole.kind in ("symbol", "number"):
            return right
        if several[whole.key] > 1:
            raise NoCertificateError(f"only that it is itself is kept of {left.value}")
        return rebuilt(whole, lambda node, _: tokens.get(node.key) if node != whole else None)

    sides = [
        (r.operator, in_tokens(r.left, texts[0]), in_tokens(r.right, texts[1]))
        for r in statement.relations
    ]
    keeps = "model" not in evidence
    relations = [Rel(op, a, defined(a, b) if keeps else b) for op, a, b in sides]
    alone = claim["latex"].partition("=")[0].strip()
    is_number = len(sides) == 1 and relations[0].left.kind == "number"
    if is_number and alone in evidence.get("of the filter", ()):
        relations = [replace(relations[0], left=symbol(alone))]  # it may be the number 0
    needed = [in_tokens(expr) for expr in statement.needed]
    used = symbols_of(*needed, *(side for r in relations for side in (r.left, r.right)))
    letters = {**meanings, **{t: read_graph(g) for t, g in evidence.get("letters", {}).items()}}
    # symbols that stand for the same are one letter in the formula, and a line each
    keys = {meanings.get(name, symbol(name)).key for name in used}
    used |= {token for token, expr in meanings.items() if expr.key in keys}
    others = evidence.get("other symbols", ())
    used |= {token for token in others if symbols_of(meanings[token]) <= {*boxes}}
    shown = symbols_of(*(letters[token] for token in used & letters.keys()))
    for token in evidence.get("of the filter", ()):
        if any(OF_MODEL.fullmatch(n) and n in shown for n in symbols_of(letters[token])):
            used |= {token}  # by what other symbols are defined
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
    if any(node.key in of_filter for r in statement.domain for node in walk(r.left, r.right)):
        raise NoCertificateError("a condition on quantities of the filter")
    model: dict[str, list[list[Expr]]] = {}
    if any(OF_MODEL.fullmatch(name) for name in symbols_of(*letters.values())):
        model = {
            name: [[read_graph(graph) for graph in row] for row in rows]
            for name, rows in evidence["model"].items()
        }
        boxes = {**boxes_from(evidence["domain of the model"]), **boxes}
    entries = [entry for rows in model.values() for row in rows for entry in row]
    asked = statement.exprs()
    if "region" in model:  # of gains, in which coordinates are not kept
        asked = tuple(side for r in relations for side in (r.left, r.right)) + tuple(needed)
    spoken = symbols_of(*asked, *letters.values(), *entries) - letters.keys()
    boxes = {name: boxes[name] for name in sorted(spoken) if not OF_MODEL.fullmatch(name)}
    if "region" in model and any(name.startswith("step.") for name in spoken):
        raise NoCertificateError("a part of the formula in coordinates of the gains")
    if "region" in model and claim["verdict"] == "proved" and "stable" not in claim["domain"]:
        raise NoCertificateError("gains that are not stable too")
    region, inside = (model.pop(name, [[]])[0] for name in ("region", "inside"))
    names = [labels.get(name, name) for name in boxes]
    functions = _functions(claim["latex"], evidence.get("functions", {}))
    given = [_turned(r) for r in statement.domain]
    given += [r for e in region if (r := Rel(">", e, number(0))) not in given]
    said = Said(
        typed=claim["typed"],
        # the statement is that under the first convention
        convention=(claim["convention"] or "").removeprefix("any of: ").partition("; ")[0],
        partial=any(word in (claim["domain"] or "") for word in PARTIAL),
        boxes={labels.get(name, name): box for name, box in boxes.items()},
        given=given,
        model=model,
        letters=letters,
        relations=tuple(relations),
        needed=tuple(needed),
        labels=labels,
        functions=[*functions.values()],
    )
    if left := unexplained(claim["latex"], (*said.boxes, *said.letters, *functions)):
        raise NoCertificateError(f"{UNKEPT}: {left}")
    refutes = claim["verdict"] == "refuted"
    if "N" in model:
        if refutes:
            raise NoCertificateError("what is false of a memory")
        return memory_certificate(said)
    gains = {labels.get(f"filter_gain.{i}", f"filter_gain.{i}"): e for i, e in enumerate(inside, 1)}
    points: Iterator[dict[str, str]] = (
        point | {name: str(e.value) for name, e in gains.items()}
        for point in _inner_points(said.boxes)
    )
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


def _functions(latex: str, defined: Mapping[str, str]) -> dict[str, str]:
    """Those that a formula calls, and that these call, by their definitions."""
    called: dict[str, str] = {}
    while True:
        text = " ".join([latex, *called.values()])
        more = {
            name: said
            for name, said in defined.items()
            if name not in called and re.search(rf"(?<![A-Za-z_\\]){re.escape(name)}\(", text)
        }
        if not more:
            return called
        called |= more


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


def _count(token: str, latex: str) -> int:
    """How often a symbol is in a formula, read as text."""
    name = _plain(token)
    before = r"(?<![\\_])" if name[:1].isalpha() else ""
    return len(re.findall(rf"{before}{re.escape(name)}(?![_'\d])", _plain(latex)))


def _places(token: str, expr: Expr) -> int:
    """How often a symbol is in an expression."""
    found: dict[bytes, int] = {}
    for node in walk(expr):
        found[node.key] = int(node.value == token) + sum(found[part.key] for part in node.parts)
    return found[expr.key]


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
    """That of the witness if it is rational, 1 for what it does not tell; then simple ones."""
    with contextlib.suppress(ValueError):  # it may be told in other variables, or be no number
        told = {name: str(Fraction(witness[name])) for name in names if name in witness}
        if told:
            yield {name: told.get(name, "1") for name in names}
    for values in free_values(tuple(boxes), boxes):
        yield _named(names, values)


def _named(names: Iterable[str], values: Iterable[Fraction]) -> dict[str, str]:
    return {name: str(value) for name, value in zip(names, values, strict=True)}


def _turned(rel: Rel) -> Rel:
    """With a symbol that is alone on one side on the left."""
    if rel.right.kind == "symbol" and rel.left.kind != "symbol":
        return Rel(TURNED.get(rel.operator, rel.operator), rel.right, rel.left)
    return rel
