"""The goals of a certificate decided by Singular: quotients of polynomials modulo the relations.

A quotient is a list of two polynomials, reduced. Singular does all arithmetic; the script holds the
expressions as they stand in the claims.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from gainproof.certify import external
from gainproof.certify.divisors import divisors, known_forms
from gainproof.certify.expression import Tree
from gainproof.certify.goals import Goal, Statement, Tower
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements, towers
from gainproof.certify.subjects import Subject

NAME, PROGRAM = "singular", "Singular"
HEAD = """\
proc made(poly a, poly b) { a = reduce(a, J); b = reduce(b, J);
  poly g = gcd(a, b); list q = a / g, b / g; return(q); }
proc sum(list l, list r) { return(made(l[1]*r[2] + r[1]*l[2], l[2]*r[2])); }
proc times(list l, list r) { return(made(l[1]*r[1], l[2]*r[2])); }
proc over(list l, list r) { return(made(l[1]*r[2], l[2]*r[1])); }
proc power(list l, int n) { return(made(l[1]^n, l[2]^n)); }
proc same(list l, list r) { if (l[2] == 0 or r[2] == 0) { return(0); }
  return(reduce(l[1]*r[2] - r[1]*l[2], J) == 0); }
proc plus(poly a) { a = subst_ends(a); if (a == 0) { return(0); } int i; int inside = 0;
  for (i = 1; i <= size(a); i++) { if (leadcoef(a[i]) < 0) { return(0); }
    if (reduce(lead(a[i]), E) != 0) { inside = 1; } } return(inside); }
proc signed(list l) { return(plus(l[1]) or plus(-l[1])); }
"""
_SAID = re.compile(r"^(\d+) (\d)$", re.MULTILINE)


def certify(subject: Subject, limit: float) -> Outcome:
    """One run of Singular for all statements of a subject; each says 1 or 0."""
    every = list(statements(subject.certificate))
    own = [statement for statement in every if statement.goals]
    text = script(own, towers(subject.certificate))
    answer = external.ask([PROGRAM, "-q", "--no-rc"], "certificate.sing", text, limit)
    said = {int(place): value == "1" for place, value in _SAID.findall(answer.text)}
    refuted = [statement.id for place, statement in enumerate(own) if not said.get(place)]
    rejected = "" if answer.status is None or not refuted else f"{refuted[0]}: not shown"
    left_out = Counter(statement.left_out for statement in every if statement.left_out)
    return Outcome(
        subject.name,
        NAME,
        len(own),
        sum(said.values()),
        answer.seconds,
        rejected,
        answer.status is None,
        left_out,
    )


def script(own: Sequence[Statement], known: Mapping[str, Tower]) -> str:
    """The whole input of Singular."""
    lines: list[str] = []
    for name, tower in known.items():
        for place, statement in enumerate(own):
            if statement.tower == name:
                lines += _Ring(f"R{place}", tower, statement).lines(place)
    return "\n".join([*lines, "quit;", ""])


class _Ring:
    """The polynomials of a tower and a statement's free names, roots first: their powers reduce."""

    def __init__(self, ring: str, tower: Tower, statement: Statement) -> None:
        self.ring, self.tower, self.statement = ring, tower, statement
        free = dict.fromkeys(name for goal in statement.goals for name in goal.free)
        roots = [relation.symbol for relation in tower.relations]
        self.free = tuple(free)
        self.letters = (*reversed(roots), *tower.parameters, *free)
        self.index = {name: f"x({place})" for place, name in enumerate(self.letters, 1)}

    def lines(self, place: int) -> Iterator[str]:
        yield f"ring {self.ring} = 0, x(1..{max(1, len(self.letters))}), lp;"
        rules = [
            f"{self.index[r.symbol]}^{r.power} - ({self.polynomial(r.radicand)})"
            for r in reversed(self.tower.relations)
        ]
        yield f'ideal J = {", ".join(rules) or "0"}; attrib(J, "isSB", 1);'
        ends = [self.index[name] for name in self.tower.shifted]
        yield f'ideal E = {", ".join(ends) or "0"}; attrib(E, "isSB", 1);'
        moved = "".join(
            f"a = subst(a, {self.index[n]}, {self.index[n]} + ({start}));"
            for n, start in self.tower.shifted.items()
        )
        yield f"proc subst_ends(poly a) {{ {moved} return(a); }}"
        yield HEAD
        used = set().union(
            *(side.symbols() for goal in self.statement.goals for side in (goal.left, goal.right))
        )
        for name, element in self.tower.elements.items():
            if name in used:
                yield f"list e_{name} = {self.quotient(element)};"
        yield "int good = 1;"
        for goal in self.statement.goals:
            for condition in self._conditions(goal):
                yield f"if (not ({condition})) {{ good = 0; }}"
        yield f'print("{place} " + string(good)); kill good; kill {self.ring};'

    def _conditions(self, goal: Goal) -> Iterator[str]:
        forms = {id(divisor): form for divisor, _, form in known_forms(goal, self.tower)}
        for divisor in divisors(goal):
            if not divisor.symbols().isdisjoint(goal.free):
                continue
            form = forms.get(id(divisor))
            if form is None:
                yield f"signed({self.quotient(divisor)})"
            else:
                yield f"signed({self.quotient(form)})"
                yield f"same({self.quotient(divisor)}, {self.quotient(form)})"
        yield f"same({self.quotient(goal.left)}, {self.quotient(goal.right)})"
        if goal.positive:
            for part in goal.right.parts:
                yield f"plus({self.quotient(part)}[1])"

    def polynomial(self, tree: Tree) -> str:
        match tree.operation:
            case "number":
                return f"({tree.value})"
            case "symbol":
                return self.index[tree.name]
            case "pow":
                return f"({self.polynomial(tree.parts[0])})^{tree.exponent}"
        sign = {"add": " + ", "mul": " * "}[tree.operation]
        return f"({sign.join(map(self.polynomial, tree.parts))})"

    def _is_polynomial(self, tree: Tree) -> bool:
        if tree.operation == "div" or tree.exponent < 0 or tree.name in self.tower.elements:
            return False
        return all(map(self._is_polynomial, tree.parts))

    def quotient(self, tree: Tree) -> str:
        """Polynomials are written as such: Singular reads calls no deeper than some thousand."""
        if self._is_polynomial(tree):
            return f"made({self.polynomial(tree)}, 1)"
        match tree.operation:
            case "symbol":
                return f"e_{tree.name}"
            case "pow" if tree.exponent < 0:
                return f"power(over(made(1, 1), {self.quotient(tree.parts[0])}), {-tree.exponent})"
            case "pow":
                return f"power({self.quotient(tree.parts[0])}, {tree.exponent})"
        call = {"add": "sum", "mul": "times", "div": "over"}[tree.operation]
        first, *rest = map(self.quotient, tree.parts)
        for part in rest:
            first = f"{call}({first}, {part})"
        return first
