"""Certificates about matrices of any size, which `gainproof.verify.check_matrices` decides.

The proof that was found is about formulas that are multiplied out and reduced; here it is written
for those that were asked, each step of a reduction said. The file decides what is given out.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from operator import mul
from time import process_time
from typing import Any

import flint

from gainproof.verify import check_matrices
from gainproof.verify.check_matrices import Poly

Data = Mapping[str, Any]
PROPERTIES = {"symmetric": "{0}.T == {0}", "definite": "{0} > 0", "semidefinite": "{0} >= 0"}
FACTS = {"positive definite": "definite", "positive semidefinite": "semidefinite"}
SECONDS = 5
"""Of the processor, after which nothing more is looked for."""
TRIED = 40
NAME = re.compile("[A-Za-z][A-Za-z0-9_]*")


def matrix_certificate(claim: Data, proofs: Sequence[Data]) -> tuple[dict[str, Any], list[str]]:
    """The certificate of a claim with a proof in words, the last, and the names that it explains.
    Raises ValueError and others.
    """
    proof = proofs[-1]
    if proof.get("asked") is None:
        raise ValueError("how it was asked is not kept as text")
    if proof["asked"]["rests"]:
        raise ValueError("its proof rests on what others show, or leaves out a definition")
    if proof["setting"]["parameters"]:
        raise ValueError("numbers of any value beside matrices of any size")
    writer = Writer(claim, proof)
    found = writer.written()
    check_matrices.Certificate(found).decide()
    return found, [*writer.checker.meaning, *writer.checker.names.values()]


class Writer:
    """Lines as the file has read them."""

    def __init__(self, claim: Data, proof: Data) -> None:
        self.claim, self.setting, self.asked = claim, proof["setting"], proof["asked"]
        self.statements: list[Data] = proof["statements"]
        self.checker = check_matrices.Certificate({"format": check_matrices.FORMAT})
        self.blocks = {**self.asked["blocks"], **self.setting["blocks"]}
        self.lines: list[list[Any]] = []
        self.sources: dict[str, int] = {}  # of the proof: facts
        self.rules: dict[tuple[str, ...], int] = {}  # words that vanish or get shorter by a fact
        self.lets: dict[str, int] = {}
        self.bases: dict[str, str] = {}  # of inverses
        self.waiting: list[Data] = []  # hypotheses about letters to come
        self.latest = process_time() + SECONDS

    def say(self, *line: Any) -> int:
        """The number of its fact, where it has one."""
        before = len(self.checker.facts)
        self.checker.line(*line)
        self.lines.append([*line])
        for k in range(before, len(self.checker.facts)):
            p, sign = self.checker.facts[k]
            word = max(p, key=lambda w: (len(w), w), default=())
            turned = len(word) == 1 and word[0].endswith("'") and {*p} == {word, (word[0][:-1],)}
            if sign == "==" and (turned or (len(word) == 2 and {*p} <= {word, ()})):
                self.rules.setdefault(word, k)
        return before

    def written(self) -> dict[str, Any]:
        """The whole certificate. Raises ValueError where something is not shown."""
        asked, setting = self.asked, self.setting
        self.say("typed", self.claim["typed"])
        elements, inverses = setting["elements"], setting["inverses"]
        vectors = {text.split(" = ")[0] for title, text in asked["lines"] if title == "random"}
        spoken = self.spoken()
        for name, shape in {**asked["matrices"], **setting["matrices"]}.items():
            if name in spoken - elements.keys() - inverses.keys() - vectors:
                self.say("matrix", f"{name} = {' by '.join(shape)}")
        for name, size in setting["units"].items():
            self.define("unit", f"{name} = {size}")
        self.cut()
        self.waiting = [h for s in self.statements for h in s["claim"]["given"]]
        for name, facts in asked["facts"].items():
            self.waiting += [{"kind": FACTS.get(fact, fact), "matrix": name} for fact in facts]
        self.suppose()
        for title, text in asked["lines"]:
            self.define(title, text)
        later = [*elements, *inverses]
        while later:
            name = later.pop(0)
            base = {inverses[name]} if name in inverses else _letters(elements[name])
            if not base <= {*self.checker.letters}:
                later.append(name)
            elif name in inverses:
                self.define("inverse", f"{name} = {inverses[name]}**-1")
            else:
                self.define("let", f"{name} = {text_of(elements[name])}")
        for text in asked["claims"]:
            self.say("claim", text)
        for statement in self.statements:
            self.statement(statement)
        for text in asked["claims"]:
            self.conclude(text)
        self.name()
        return {"format": check_matrices.FORMAT, **self.instance(), "lines": self.lines}

    def name(self) -> None:
        """How the source calls the letters and sizes that are there, told before them."""
        letters = self.checker.meaning
        known = letters.keys() | {side for p in letters.values() for side in p.shape}
        sizes = {name: shown for name, (shown, *_) in self.asked["sizes"].items()}
        for name, token in {**self.asked["names"], **sizes}.items():
            if name in known and name != token:
                self.say("name", f"{name} for {token}")
        self.lines.sort(key=lambda line: {"typed": 0, "name": 1}.get(line[0], 2))

    def spoken(self) -> set[str]:
        """Names of letters that the statement or its proof need, with all blocks of a size."""
        parts = [[s["evidence"], s["claim"]["given"], _claimed(s)] for s in self.statements]
        said = self.asked["lines"], self.asked["claims"], self.setting["elements"], parts
        found = {*NAME.findall(json.dumps([*said, self.setting["inverses"]]))}
        self.blocks = {size: own for size, own in self.blocks.items() if found & {*own}}
        return found.union(*self.blocks.values())

    # what is printed

    def define(self, title: str, text: str) -> None:
        name, meaning = text.split(" = ")
        if name in self.checker.meaning:
            return
        k = self.say(title, text)
        if title == "let":
            self.lets[name] = k
        elif title == "inverse":
            self.bases[name] = meaning.removesuffix("**-1")
        self.suppose()

    def cut(self) -> None:
        """Selections of rows that together are the unit matrix."""
        for size, own in self.blocks.items():
            for i, one in enumerate(own):
                for j, two in enumerate(own[i:], i):
                    k = self.say("where", f"{one}.T*{two} == {int(i == j)}")
                    self.sources[key("blocks", size, i, j)] = k
                    self.sources[key("blocks", size, j, i)] = k + (i != j)
            whole = " + ".join(f"{one}*{one}.T" for one in own)
            self.sources[key("blocks", size)] = self.say("where", f"{whole} == 1")

    def suppose(self) -> None:
        """What is supposed of letters that are known by now, each once."""
        for h in [*self.waiting]:
            spoken = {h["matrix"]} if "matrix" in h else _names(h)
            if spoken <= {*self.checker.letters}:
                self.waiting.remove(h)
                if key(h) not in self.sources:
                    self.sources[key(h)] = self.supposed(h)

    def supposed(self, h: Data) -> int:
        kind, name = h["kind"], h.get("matrix", "")
        if kind == "equal":
            return self.say("where", f"{graph_text(h['left'])} == {graph_text(h['right'])}")
        if kind == "invertible":
            inverses = (n for n, base in self.setting["inverses"].items() if base == name)
            other = next(inverses, f"{name}_inverse")
            self.say("matrix", f"{other} = {' by '.join(self.checker.letters[name].shape)}")
            self.bases[other] = name
            k = self.say("where", f"{name}*{other} == 1")
            self.say("where", f"{other}*{name} == 1")
            return k
        if kind not in PROPERTIES:
            raise ValueError(f"a hypothesis: {kind}")
        return self.say("where", PROPERTIES[kind].format(name))

    # steps

    def reduced(self, p: Poly) -> tuple[Poly, list[list[Any]]]:
        """What is left when letters that meet vanish, and the terms that went."""
        steps: list[list[Any]] = []
        value = self.checker.value
        while found := self.reducible(p):
            word, at, end = found
            k = self.rules[word[at:end]]
            fact = self.checker.facts[k][0]
            left = word_text(word[:at], p[word] / fact[word[at:end]])
            right = word_text(word[end:])
            steps.append([left, k, right])
            p = p.less(self.checker.times(value(left), fact, value(right)))
            if process_time() > self.latest:
                raise ValueError("no proof was found in time")
        return p, steps

    def reducible(self, p: Poly) -> tuple[tuple[str, ...], int, int] | None:
        for word in p:
            for at in range(len(word)):
                for end in (at + 1, at + 2):
                    if word[at:end] in self.rules and end <= len(word):
                        return word, at, end
        return None

    def symmetric(self) -> None:
        """Letters that are made of others and symmetric."""
        for name in [*self.lets, *self.bases]:
            if (f"{name}'",) in self.rules:
                continue
            claim = f"{name}.T - {name} == 0"
            if name in self.lets:
                k = self.lets[name]
                p = self.checker.value(claim, True)[0]
                first = self.checker.facts[k + 1][0].less(self.checker.facts[k][0])
                if p.shape == first.shape:
                    rest, steps = self.reduced(p.less(first))
                    if not rest:
                        self.say("shows", claim, [["1", k + 1, "1"], ["-1", k, "1"], *steps])
                continue
            base = self.bases[name]
            own, s = self.rules.get((base, name)), self.rules.get((f"{base}'",))
            if own is None or s is None:
                continue
            sign = self.checker.facts[s][0][(f"{base}'",)]
            terms = [["1", own + 1, name], [f"-{name}.T", own, "1"]]
            self.say("shows", claim, [*terms, [f"({-sign})*{name}.T", s, name]])

    def element(self, name: str) -> int:
        """That it is what the proof says, from what was printed."""
        if key("element", name) not in self.sources:
            k, text = self.lets[name], text_of(self.setting["elements"][name])
            p = self.checker.value(f"{name} - ({text})")
            rest, steps = self.reduced(p.less(self.checker.facts[k][0]))
            if rest:
                raise ValueError(f"{name} is not what was printed")
            if steps:
                k = self.say("shows", f"{name} - ({text}) == 0", [["1", k, "1"], *steps])
            self.sources[key("element", name)] = k
        return self.sources[key("element", name)]

    def cofactors(self, s: Data, entries: Any) -> list[list[Any]]:
        found = []
        for c in entries:
            source, turned, sign = c["source"], "transposed" in c, ""
            if source[0] == "given":
                h = s["claim"]["given"][source[1]]
                k = self.sources[key(h)]
                if h["kind"] in FACTS.values():  # A - A', not A' - A
                    k, sign, turned = k + 1, "" if turned else "-", False
            elif source[0] == "element":
                k = self.element(source[1])
            elif source[0] == "number":
                raise ValueError("a matrix of one row and one column")
            else:
                k = self.sources[key(*source)]
            found.append([f"{sign}({text_of(c['left'])})", k + turned, text_of(c["right"])])
        return found

    def statement(self, s: Data) -> None:
        """A statement of the proof as a step."""
        e = s["evidence"]
        if s["kind"] == "matrix_invertible":
            self.invertible(s)
        elif s["kind"] == "matrix_equal" and {*e} == {"cofactors"}:
            k = self.say("shows", _claimed(s), self.cofactors(s, e["cofactors"]))
            self.sources[key("statement", s["id"])] = k
        elif s["kind"] == "matrix_order":
            squares = [
                [q["weight"][0][0], text_of(q["factor"]), self.definite(s, q["definite"])]
                for q in e["squares"]
            ]
            rank = e.get("rank", {})
            if "square" in rank:
                raise ValueError("a matrix of full column rank")
            inverses = [[text_of(one[1]), one[0], "1"] for one in rank.get("left_inverses", ())]
            terms = self.cofactors(s, e["cofactors"])
            ones = self.cofactors(s, rank.get("cofactors", ()))
            k = self.say("shows", _claimed(s), terms, squares, inverses, ones)
            self.sources[key("statement", s["id"])] = k
        else:
            raise ValueError(f"a proof by {', '.join(e)}")
        self.symmetric()

    def definite(self, s: Data, reference: Sequence[Any]) -> int | None:
        if reference[0] == "unit":
            return None
        given = reference[0] == "given"
        return self.sources[key(s["claim"]["given"][reference[1]] if given else reference)]

    def invertible(self, s: Data) -> None:
        base, e = s["claim"]["matrix"], s["evidence"]
        name = next((n for n, b in self.bases.items() if b == base), "")
        if name in self.checker.inverses:
            if "because" in e:
                self.say("opens", name, self.definite(s, e["because"]))
            else:
                left = text_of(e["left_inverse"])
                terms = [[f"-({a})", k, b] for a, k, b in self.cofactors(s, e["cofactors"])]
                k = self.say("shows", f"({left})*{base} - 1 == 0", terms)
                self.say("opens", name, k, left)
        if name:
            self.sources[key("inverse", s["id"], "right")] = self.rules[base, name]
            self.sources[key("inverse", s["id"], "left")] = self.rules[name, base]

    def conclude(self, text: str) -> None:
        """The claim, from the statements."""
        p, sign = self.checker.value(text, True)
        rest, steps = self.reduced(p)
        for s in reversed(self.statements):
            k = self.sources.get(key("statement", s["id"]), -1)
            q, its = self.checker.facts[k]
            if k >= 0 and rest and its == sign and q.shape == rest.shape:
                other, more = self.reduced(rest.less(q))
                if not other:
                    rest, steps = other, [*steps, *more]
                    if sign == "==":
                        steps.append(["1", k, "1"])
                    else:
                        self.say("shows", text, steps, [["1", "1", k]], [["1", 0, "1"]])
                        return
        if rest:
            raise ValueError("the claim is not what was proved")
        self.say("shows", text, steps)

    # matrices that meet the conditions

    def instance(self) -> dict[str, Any]:
        """Sizes and numbers. Raises ValueError if simple ones do not do."""
        for seed in range(TRIED):
            source = random.Random(seed)
            sizes = self.sizes(source, 4 if seed < TRIED // 2 else 8)
            try:
                numbers = self.drawn(sizes, source, seed % 4)
                said = {n: [[str(x) for x in row] for row in a] for n, a in numbers.items()}
                self.checker.data = {"sizes": sizes, "numbers": said}
                self.checker.work = 0
                self.checker.meet()
                return {"sizes": sizes, "numbers": said}
            except ValueError:
                if process_time() > self.latest:
                    break
        raise ValueError("no simple matrices meet the conditions")

    def sizes(self, source: random.Random, most: int) -> dict[str, int]:
        """Of steps of up to `most`, so that all are different and those of blocks their sum."""
        known = self.asked["sizes"]
        names = {n for p in self.checker.meaning.values() for n in p.shape if not n.isdigit()}
        while process_time() < self.latest:
            steps = dict[str, int]()
            found = {}
            for name in sorted(names):
                _, constant, terms = known[name]
                values = {n: steps.setdefault(n, source.randint(1, most)) for n in terms}
                found[name] = constant + sum(c * values[n] for n, c in terms.items())
            if len({*found.values()}) == len(found) and all(1 < n < 40 for n in found.values()):
                return found
        raise ValueError("no sizes that are different")

    def drawn(self, sizes: dict[str, int], source: random.Random, way: int) -> dict[str, Any]:
        facts: dict[str, set[str]] = {}
        for name, own in self.asked["facts"].items():
            facts[name] = {FACTS.get(fact, fact) for fact in own}
        for s in self.statements:
            for h in s["claim"]["given"]:
                facts.setdefault(h.get("matrix", ""), set()).add(h["kind"])
        place = {n: (size, at) for size, own in self.blocks.items() for at, n in enumerate(own)}
        found: dict[str, Any] = {}
        all_sizes = {str(n): n for n in range(40)} | sizes
        for name, p in self.checker.letters.items():
            rows, columns = (all_sizes[side] for side in p.shape)
            free = [[Fraction(source.randint(-2, 2)) for _ in range(columns)] for _ in range(rows)]
            if way and source.randrange(4) < way:
                free = [[Fraction()] * columns for _ in range(rows)]
            if name in place:
                size, at = place[name]
                before = self.blocks[size][:at]
                start = sum(all_sizes[self.checker.letters[n].shape[1]] for n in before)
                free = [[Fraction(i == j + start) for j in range(columns)] for i in range(rows)]
            elif name in self.lets:
                value = p.less(self.checker.facts[self.lets[name]][0])
                free = self.checker.evaluated(value, found, all_sizes)
            elif name in self.bases:
                free = _inverted(found[self.bases[name]])
            elif facts.get(name, set()) & {*PROPERTIES}:
                free = [[sum(map(mul, one, two)) + (one is two) for two in free] for one in free]
            found[name] = free
        return found


def _inverted(a: Any) -> Any:
    """Of a matrix of numbers, itself where there is none."""
    matrix = flint.fmpq_mat([[flint.fmpq(x.numerator, x.denominator) for x in row] for row in a])
    try:
        return [[Fraction(int(x.p), int(x.q)) for x in row] for row in matrix.inv().tolist()]
    except ZeroDivisionError:
        return a


def key(*source: Any) -> str:
    return json.dumps(source[0] if len(source) == 1 else source, sort_keys=True)


def graph_text(graph: Data) -> str:
    """An expression of a graph of the proof."""
    texts: list[str] = []
    for kind, *said in graph["nodes"]:
        if kind == "symbol":
            texts.append(said[0])
        elif kind == "number":
            texts.append(f"({said[0]})")
        else:
            parts = [texts[k] for k in said]
            joined = {"add": " + ", "mul": "*"}.get(kind, "")
            if kind == "transpose":
                texts.append(f"{parts[0]}.T")
            elif joined == "*" and "(0)" in parts:
                texts.append("0")
            elif joined:
                texts.append(f"({joined.join(parts)})")
            else:
                raise ValueError(f"a {kind} of matrices")
    return texts[-1]


def _claimed(s: Data) -> str:
    """The relation of a statement, empty of one that an inverse exists."""
    claim = s["claim"]
    if s["kind"] == "matrix_invertible":
        return ""
    sides = ("larger", "smaller") if s["kind"] == "matrix_order" else ("left", "right")
    return f" {claim.get('relation', '==')} ".join(graph_text(claim[side]) for side in sides)


def text_of(poly: Sequence[Any]) -> str:
    """An expression of a polynomial of the proof."""
    words = [word_text(word, Fraction(c)) for c, _, word in poly]
    return " + ".join(words) or "0"


def word_text(word: Sequence[str], c: Fraction | int = 1) -> str:
    number = [f"({c})"] if c != 1 or not word else []
    return "*".join([*number, *(letter.replace("'", ".T") for letter in word)])


def _names(h: Data) -> set[str]:
    nodes = [node for side in ("left", "right") for node in h[side]["nodes"]]
    return {n[1] for n in nodes if n[0] == "symbol" and not n[1].startswith("unit_")}


def _letters(poly: Sequence[Any]) -> set[str]:
    return {letter.removesuffix("'") for _, _, word in poly for letter in word}
