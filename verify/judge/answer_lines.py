"""Statements as lines of a certificate, with symbols as the file `check_answer.py` names them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from keyword import iskeyword
from typing import Any

from gainproof.verify import check_answer
from gainproof.verify.check_answer import VALUE, ZERO, Poly
from gainproof.verify.judge.answer_polynomials import pair, text_of
from gainproof.verify.judge.answer_proof import Proof
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, symbols_of, walk
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Malformed

OF_MODEL = re.compile(r"[PKSX]\[\d,\d\]")
"""Entries of a filter's matrices, as the file names them."""
PI = "245850922/78256779", 10**15
"""A number, and how many parts of 1: it is closer to pi than one of them."""
SUM, PRODUCT, POWER, ATOM = 0, 1, 2, 3
"""How tightly the last operation of a text binds."""


@dataclass(frozen=True)
class Said:
    """A statement, with variables as the source calls them where they have a label."""

    typed: str
    """The formula as it was typed."""
    convention: str
    partial: bool
    """Whether the domain of the verdict is where its parts have values."""
    boxes: Mapping[str, Box]
    """The ranges of the variables."""
    given: Sequence[Rel]
    """Conditions beside the ranges."""
    model: Mapping[str, Sequence[Sequence[Expr]]]
    """F, H, Q, R, P, K of a filter; empty where the formula is of none."""
    letters: Mapping[str, Expr]
    """What other symbols of the source stand for."""
    relations: Sequence[Rel]
    """What is claimed; if it is refuted, one of it."""
    needed: Sequence[Expr]
    """Parts of the formula, no longer in the relations, that have to have a value."""
    labels: Mapping[str, str]
    """Names of variables in the judge, and in the source."""


class Writer:
    """A statement as lines with their proof, at a point of its domain."""

    def __init__(self, said: Said, point: Mapping[str, str], refutes: bool, latest: float) -> None:
        self.said, self.point, self.refutes = said, point, refutes
        self.first = ""
        self.names: dict[str, str] = {}
        self.texts: dict[bytes, tuple[str, int]] = {}
        self.parts = 0
        self.later: list[str] = []
        for token in sorted((*said.boxes, *said.letters), key=lambda token: "[" in token):
            self.name(token)
        called = {self.names[n]: pair(Fraction(v)) for n, v in point.items()}
        self.proof = Proof(({} if refutes else called) | {"pi": pair(Fraction(PI[0]))}, latest)

    def name(self, token: str) -> str:
        """How the file calls a symbol."""
        if token not in self.names:
            plain = re.sub("[^A-Za-z0-9]+", "_", token.replace("'", "_prime")).strip("_")
            plain = plain if plain[:1].isalpha() else f"x_{plain}"
            if "[" in token and plain in self.names.values():
                plain = f"entry_of_{plain}"  # D[1, 2] beside a number D_{1,2}
            taken = {*self.names.values(), *check_answer.FUNCTIONS, "pi", "S", "X"}
            taken |= {*"FHQRPK"} if self.said.model else set()
            while plain in taken or iskeyword(plain) or re.fullmatch(r"part\d+", plain):
                plain += "_"
            self.names[token] = plain
        return self.names[token]

    def written(self) -> dict[str, Any]:
        """Format apart. Raises ValueError where something is not shown."""
        proof, said = self.proof, self.said
        proof.say("typed", said.typed)
        if said.convention:
            proof.say("convention", " ".join(said.convention.split()))
        for token, plain in self.names.items():
            if token != plain:
                proof.say("name", f"{plain} for {' '.join(token.split())}")
        given, defined = [*said.given], dict[str, Expr]()
        for rel in said.given:
            name = said.labels.get(str(rel.left.value), str(rel.left.value))
            spoken = {said.labels.get(n, n) for n in symbols_of(rel.right)}
            alone = rel.operator == "=" and rel.left.kind == "symbol" and name in said.boxes
            if alone and not spoken & {name, *defined} and not self.uses(name, defined):
                defined[name] = rel.right
                given.remove(rel)
        for token in said.boxes:
            if token not in defined:
                value = f" = {self.point[token]}" if self.refutes else ""
                proof.say("with" if self.refutes else "real", self.name(token) + value)
        nodes = walk(*self.expressions())
        if any(node.kind == "call" and node.name == "pi" for node in nodes):
            proof.say("real", "pi")
            self.where(f"pi > {PI[0]} - 1/{PI[1]}")
            self.where(f"{PI[0]} + 1/{PI[1]} > pi")
        for token, expr in defined.items():
            proof.say("with", f"{self.name(token)} = {self.text(expr)}")
        for token, box in said.boxes.items():
            self.box(self.name(token), box)
        if not self.refutes and any(rel.operator == "=" for rel in given):
            self.meet([rel for rel in given if rel.operator == "="])
        for rel in given:
            self.where(self.relation(rel))
        self.filter()
        for token, expr in said.letters.items():
            proof.say("with", f"{self.name(token)} = {self.text(expr)}")
        for k, expr in enumerate(said.needed, 1):
            proof.say("with", f"value{k}_ = {self.text(expr)}")
        for rel in said.relations:
            proof.say("false" if self.refutes else "claim", self.relation(rel))
        self.first = self.relation(said.relations[0])
        proof.angles()
        proof.open()
        if not self.prove() or proof.closed():
            self.bend()
            if not self.prove():
                raise ValueError(f"no proof was found that the file can check: {self.first}")
        point = proof.checker.data["point"]
        said_of = {n: v for n, v in point.items() if n in proof.checker.letters}
        return {"point": said_of, "lines": proof.lines}

    def meet(self, equations: Sequence[Rel]) -> None:
        """Has the point meet them, each solved for a variable."""
        proof, point = self.proof, self.proof.checker.data["point"]
        for rel in equations:
            proof.solve(proof.read(self.relation(rel))[0], None)
        for name in [*proof.solved][::-1]:
            parts = proof.by_degree(proof.solved[name][1], name)
            (top, other), (bottom, _) = (proof.checker.enclosed(parts.get(e, ZERO)) for e in (0, 1))
            if top != other:
                raise ValueError("no rational point was found")
            point[name] = pair(-top / bottom)
            proof.checker.ends, proof.values = {}, {}
        proof.solved = {}
        proof.order = []

    def expressions(self) -> Iterator[Expr]:
        said = self.said
        for rel in (*said.given, *said.relations):
            yield from (rel.left, rel.right)
        yield from (*said.needed, *said.letters.values())

    def uses(self, name: str, defined: Mapping[str, Expr]) -> bool:
        labels = self.said.labels
        return any(name in {labels.get(n, n) for n in symbols_of(e)} for e in defined.values())

    def prove(self) -> bool:
        """Whether all that is wanted is found, parts with a value apart."""
        values = [
            (p, VALUE[kind][0]) for kind, p in self.proof.checker.letters.values() if kind in VALUE
        ]
        wanted = [each for each in self.proof.checker.wanted if each not in values]
        return all(map(bool, [self.established(*each) for each in wanted]))

    def bend(self) -> None:
        """Adds conditions that may leave no convex domain, those of parts without a value last."""
        proof = self.proof
        for text in self.later:
            proof.say("where", text)
        self.later = []
        proof.open()
        for name in proof.closed():
            if name in proof.closed():
                if not self.refutes and not self.said.partial:
                    raise ValueError(f"that {name} has a value, which the verdict does not ask for")
                node: Any = ast.parse(name, mode="eval").body
                inner = node.right if isinstance(node, ast.BinOp) else node.args[0]
                sign = "!= 0" if isinstance(node, ast.BinOp) else ">= 0"
                proof.say("where", f"{ast.unparse(inner)} {sign}")
                proof.open()

    def established(self, p: Poly, sign: str) -> bool:
        """Whether the checker has it as a fact, which is looked for."""
        proof = self.proof
        if sign == "==":
            return proof.zero(p) is not None
        found = proof.nonzero(p) if sign == "!=" else proof.sign(p, sign == ">")
        if found is not None and proof.fact(p, sign) is None:
            proof.shows(p, sign, [["1", [found]]])
        return proof.fact(p, sign) is not None

    def filter(self) -> None:
        """Matrices of the model and what the file wants of them."""
        if not self.said.model:
            return
        proof = self.proof
        for name in "FHQRPK":
            rows = [", ".join(self.text(e) for e in row) for row in self.said.model[name]]
            proof.say("with", f"{name} = [{', '.join(f'[{row}]' for row in rows)}]")
        proof.say("filter", check_answer.FILTER)

    def box(self, name: str, box: Box) -> None:
        if box.lower is not None:
            self.where(f"{name} {'>' if box.lower_open else '>='} {box.lower}")
        if box.upper is not None:
            self.where(f"{box.upper} {'>' if box.upper_open else '>='} {name}")

    def where(self, text: str) -> None:
        """A condition now, if it keeps the domain convex, else later."""
        p, sign = self.proof.read(text)
        letters = self.proof.checker.letters
        flat = all(len(m) < 2 and {letters[k][0] for k in m} <= {"real"} for m in p)
        if self.refutes or (flat and sign != "!="):
            self.proof.say("where", text)
        else:
            self.later.append(text)

    def relation(self, rel: Rel) -> str:
        left, right = self.text(rel.left), self.text(rel.right)
        if rel.operator in ("<", "<="):
            left, right = right, left
        operator = {"=": "==", "<": ">", "<=": ">="}.get(rel.operator, rel.operator)
        return f"{left} {operator} {right}"

    # expressions as text

    def text(self, expr: Expr) -> str:
        for node in walk(expr):
            if node.key not in self.texts:
                text, level = self.node(node, [self.texts[part.key] for part in node.parts])
                if len(text) > 120:
                    self.parts += 1
                    self.proof.say("with", f"part{self.parts} = {text}")
                    text, level = f"part{self.parts}", ATOM
                self.texts[node.key] = text, level
        return self.texts[expr.key][0]

    def node(self, node: Expr, parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
        match node.kind:
            case "number":
                value = Fraction(str(node.value))
                return str(value), SUM if value < 0 else PRODUCT if value.denominator > 1 else ATOM
            case "symbol":
                name = str(node.value)
                if OF_MODEL.fullmatch(name):
                    return name, ATOM
                return self.name(self.said.labels.get(name, name)), ATOM
            case "add":
                text = parts[0][0]
                for part, _ in parts[1:]:
                    text += f" - {part[1:]}" if part[0] == "-" else f" + {part}"
                return text, SUM
            case "mul":
                return "*".join(_bracketed(part, PRODUCT) for part in parts), PRODUCT
            case "neg":
                return f"-{_bracketed(parts[0], PRODUCT)}", SUM
            case "div":
                return f"{_bracketed(parts[0], PRODUCT)}/{_bracketed(parts[1], ATOM)}", PRODUCT
            case "pow":
                e = Fraction(str(node.value))
                if e.denominator > 2:
                    raise Malformed(f"not known: a power {e}")
                base = _bracketed(parts[0], ATOM)
                base = base if e.denominator == 1 else f"sqrt({parts[0][0]})"
                text = base if abs(e) in (1, Fraction(1, 2)) else f"{base}**{abs(e.numerator)}"
                return (
                    (text, POWER) if e > 0 else (f"1/{_bracketed((text, POWER), POWER)}", PRODUCT)
                )
            case "call":
                return self.function(node.name, parts)
        raise Malformed(f"not known: {node.kind}")

    def function(self, name: str, parts: Sequence[tuple[str, int]]) -> tuple[str, int]:
        """Of an argument whose first term is positive."""
        if name == "pi":
            return "pi", ATOM
        if name not in ("exp", "sin", "cos", "tan"):
            raise Malformed(f"not known: {name}")
        argument = self.proof.checker.value(parts[0][0])
        if not argument:
            return ("0" if name in ("sin", "tan") else "1"), ATOM
        negative = argument[min(argument)] < 0
        text = text_of(ZERO - argument if negative else argument)
        if name == "exp":
            return (f"1/exp({text})", PRODUCT) if negative else (f"exp({text})", ATOM)
        if name == "cos":
            return f"cos({text})", ATOM
        sine = f"sin({text})" if name == "sin" else f"sin({text})/cos({text})"
        return (f"-{sine}", SUM) if negative else (sine, PRODUCT)


def _bracketed(part: tuple[str, int], least: int) -> str:
    text, level = part
    return text if level >= least else f"({text})"
