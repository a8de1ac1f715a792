"""Goals as lemmas on real numbers for Coq, proved by `field`, `ring` and the signs of terms.

A lemma says what the claim says: for all positive parameters and roots that obey the relations.
Roots are multiplied by integers in the proof, since `ring` replaces powers by integer polynomials.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from math import lcm, prod

from gainproof.certify import external
from gainproof.certify.divisors import divisors, known_forms
from gainproof.certify.expression import Tree
from gainproof.certify.goals import Goal, Relation, Statement, Tower
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements, towers
from gainproof.certify.subjects import Subject

NAME, PROGRAM = "coq", "coqc"
_PLACE = re.compile(r'File "[^"]*", line (\d+)')
HEAD = """\
Require Import Reals Lra.
Open Scope R_scope.

Ltac sign := lazymatch goal with
  | |- 0 < ?a + ?b => first [apply Rplus_lt_0_compat; sign | apply Rplus_lt_le_0_compat; sign
      | apply Rplus_le_lt_0_compat; sign]
  | |- 0 < ?a * ?b => apply Rmult_lt_0_compat; sign
  | |- 0 < ?a / ?b => apply Rdiv_lt_0_compat; sign
  | |- 0 < ?a ^ ?n => apply pow_lt; sign
  | |- 0 <= ?a + ?b => apply Rplus_le_le_0_compat; sign
  | |- 0 <= ?a * ?b => apply Rmult_le_pos; sign
  | |- 0 <= ?a ^ ?n => apply pow_le; sign
  | |- _ => first [assumption | apply Rlt_le; assumption | lra]
  end.
Ltac nonzero := apply Rgt_not_eq; unfold Rgt; first [sign | ring_simplify; sign].
Ltac given := match goal with n : ?d <> 0 |- ?e <> 0 =>
  let h := fresh in intro h; apply n; first [lra | rewrite h; ring] end.
Ltac parts := repeat match goal with |- _ /\\ _ => split end.
"""


def certify(subject: Subject, limit: float) -> Outcome:
    """coqc reads lemma after lemma and stops at the first that it does not accept."""
    certificate = subject.certificate
    only = subject.only
    every = [each for each in statements(certificate) if only is None or each.id in only]
    chosen = [statement for statement in every if statement.goals]
    text, owners = _script(chosen, towers(certificate))
    answer = external.Answer(0, "", 0.0)
    if chosen:
        answer = external.ask([PROGRAM, "-q", "-noglob"], "certificate.v", text, limit)
    rejected, accepted = "", len(chosen) if answer.status == 0 else 0
    if answer.status:
        place = _PLACE.search(answer.text)
        line = int(place[1]) - 1 if place else 0
        said = " ".join(answer.text.split("Error:")[-1].split())
        rejected = f"{owners[line] or 'the file'}: {said[:200]}"
        accepted = len(set(owners[:line]) - {"", owners[line]})
    left_out = Counter(statement.left_out for statement in every if statement.left_out)
    return Outcome(
        subject.name,
        NAME,
        len(chosen),
        accepted,
        answer.seconds,
        rejected,
        answer.status is None,
        left_out,
    )


def _script(statements: Sequence[Statement], towers: Mapping[str, Tower]) -> tuple[str, list[str]]:
    """A file of Coq, and for each of its lines the statement that it belongs to."""
    lines = [("", line) for line in HEAD.splitlines()]
    for place, (name, tower) in enumerate(towers.items()):
        own = [statement for statement in statements if statement.tower == name]
        if any(statement.goals for statement in own):
            lines += _Tower(f"t{place}", tower).lines(own)
    return "".join(line + "\n" for _, line in lines), [owner for owner, _ in lines]


class _Tower:
    def __init__(self, prefix: str, tower: Tower) -> None:
        self.prefix, self.tower = prefix, tower
        self.variables = " ".join(f"v_{name}" for name in tower.names)
        self.scales = _multiples(tower)

    def lines(self, statements: Sequence[Statement]) -> Iterator[tuple[str, str]]:
        for name, value in self.tower.elements.items():
            arguments = f" ({self.variables} : R)" if self.variables else ""
            yield "", f"Definition {self.prefix}_{name}{arguments} : R := {self.text(value)}."
        for place, statement in enumerate(statements):
            for count, goal in enumerate(statement.goals):
                yield statement.id, self._lemma(f"{self.prefix}_l{place}_{count}", goal)

    def text(self, tree: Tree) -> str:
        match tree.operation:
            case "number":
                return _number(tree.value)
            case "symbol" if tree.name in self.tower.elements:
                return f"({self.prefix}_{tree.name} {self.variables})".replace(" )", ")")
            case "symbol":
                return f"v_{tree.name}"
            case "pow" if tree.exponent < 0:
                return f"(/ {self.text(tree.parts[0])} ^ {-tree.exponent})"
            case "pow":
                return f"({self.text(tree.parts[0])} ^ {tree.exponent})"
        sign = {"add": " + ", "mul": " * ", "div": " / "}[tree.operation]
        return f"({sign.join(map(self.text, tree.parts))})"

    def _hypotheses(self) -> Iterator[str]:
        for name in self.tower.parameters:
            start = self.tower.shifted.get(name)
            yield f"0 < v_{name}" if start is None else f"{_number(Fraction(start))} <= v_{name}"
        for relation in self.tower.relations:
            yield f"0 < v_{relation.symbol}"
        for relation in self.tower.relations:
            yield f"v_{relation.symbol} ^ {relation.power} = {self.text(relation.radicand)}"

    def _start(self) -> Iterator[str]:
        """The variables and hypotheses, roots multiplied, parameters counted from their ends."""
        for name, start in self.tower.shifted.items():
            yield _replaced(name, "<=", f"v_{name} - {start}", f"{start} + x_{name}")
        scaled = {name: scale for name, scale in self.scales.items() if scale != 1}
        for name, scale in scaled.items():
            yield _replaced(name, "<", f"{scale} * v_{name}", f"x_{name} / {scale}")
        for relation in self.tower.relations if scaled else ():
            name, power, scale = relation.symbol, relation.power, self.scales[relation.symbol]
            whole = self._whole(relation)
            new = f"x_{name}" if scale != 1 else f"v_{name}"
            old = f"x_{name} / {scale}" if scale != 1 else f"v_{name}"
            yield f"assert (q_{name} : {new} ^ {power} = {whole}) by ("
            multiplied = f"({scale} ^ {power} * ({old}) ^ {power})"
            yield f"replace ({new} ^ {power}) with {multiplied} by field;"
            yield f"rewrite r_{name}; field); clear r_{name}; rename q_{name} into r_{name};"

    def _letter(self, name: str) -> str:
        """What stands for a variable once the roots are multiplied, parameters counted anew."""
        if name in self.tower.shifted:
            return f"({self.tower.shifted[name]} + x_{name})"
        return f"v_{name}" if self.scales.get(name, 1) == 1 else f"x_{name}"

    def _whole(self, relation: Relation) -> str:
        """The radicand times scale^power as a polynomial in the multiplied roots."""
        factor = Fraction(self.scales[relation.symbol]) ** relation.power
        terms = []
        for powers, coefficient in _expanded(relation.radicand).items():
            value = coefficient * factor
            factors = []
            for name, power in powers:
                scale = self.scales.get(name, 1)
                value /= Fraction(scale) ** power
                factors.append(f"{self._letter(name)} ^ {power}")
            terms.append(" * ".join([_number(value), *factors]))
        return " + ".join(terms) or "0"

    def _lemma(self, name: str, goal: Goal) -> str:
        left, right = self.text(goal.left), self.text(goal.right)
        claim = f"0 < {left}" if goal.positive else f"{left} = {right}"
        undefined = [
            self.text(divisor)
            for divisor in divisors(goal)
            if divisor.symbols().intersection(goal.free)
        ]
        conditions = [f"{divisor} <> 0" for divisor in dict.fromkeys(undefined)]
        claim = _for_all(goal.free, conditions, claim)
        claim = _for_all(self.tower.names, list(self._hypotheses()), claim)
        names, roots = self.tower.names, [root.symbol for root in self.tower.relations]
        given = [f"v_{name}" for name in names]
        given += [f"h_{name}" for name in names] + [f"r_{name}" for name in roots]
        given += [f"v_{name}" for name in goal.free]
        given += [f"n_{place}" for place in range(len(conditions))]
        proof = f"intros {' '.join(given)}." if given else ""
        start = " ".join(self._start())
        if self.tower.elements:
            start += f"unfold {', '.join(f'{self.prefix}_{e}' for e in self.tower.elements)} in *;"
        rules = " ".join(f"r_{name}" for name in roots)
        rules = f" [{rules}]" if rules else ""
        nonzero = f"assumption || given || nonzero || ({_NONZERO.format(rules)})"
        equal = f"{start} field{rules}; parts; ({nonzero})"
        if goal.left is goal.right:
            return f"Lemma {name} : {claim}. Proof. {proof} sign. Qed."
        if goal.positive:
            proof += f" assert (final : {left} = {right})."
        proof += " {"
        for _, divisor, form in known_forms(goal, self.tower):
            proof += f" assert (same : {self.text(divisor)} = {self.text(form)})"
            # one of the same words was replaced with the first of them
            proof += f" by ({equal}). try rewrite same; clear same."
        proof += f" {equal}. }}"
        if goal.positive:
            shift = f"{start} apply Rdiv_lt_0_compat; ring_simplify; " if self.tower.shifted else ""
            proof += f" rewrite final; clear final; {shift}sign."
        return f"Lemma {name} : {claim}. Proof. {proof} Qed."


_NONZERO = """first [apply Rgt_not_eq; unfold Rgt; ring_simplify{0}; sign \
| apply Rlt_not_eq; apply Ropp_lt_cancel; \
rewrite Ropp_0; ring_simplify{0}; sign]"""


def _for_all(names: Sequence[str], hypotheses: Sequence[str], claim: str) -> str:
    implied = " -> ".join([*hypotheses, claim])
    return f"forall {' '.join(f'v_{name}' for name in names)} : R, {implied}" if names else implied


def _replaced(name: str, order: str, new: str, old: str) -> str:
    """The variable as `old` in a new one that is 0 `order` it."""
    return (
        f"assert (d_{name} : 0 {order} {new}) by lra; remember ({new}) as x_{name} eqn:e_{name}; "
        f"assert (f_{name} : v_{name} = {old}) by lra; clear e_{name} h_{name}; subst v_{name};"
    )


def _number(value: Fraction) -> str:
    top = f"{value.numerator}" if value >= 0 else f"(- {-value.numerator})"
    return top if value.denominator == 1 else f"({top} / {value.denominator})"


def _multiples(tower: Tower) -> dict[str, int]:
    """For each root an integer by which it is multiplied, so that the relations are of integers."""
    scales: dict[str, int] = {}
    for relation in tower.relations:
        scales[relation.symbol] = _denominator(relation.radicand, scales)
    return scales


def _denominator(tree: Tree, scales: Mapping[str, int]) -> int:
    inner = [_denominator(part, scales) for part in tree.parts]
    match tree.operation:
        case "number":
            return tree.value.denominator
        case "symbol":
            return scales.get(tree.name, 1)
        case "add":
            return lcm(*inner)
        case "pow":
            return int(inner[0] ** tree.exponent)
    return prod(inner)


def _expanded(tree: Tree) -> dict[tuple[tuple[str, int], ...], Fraction]:
    """A polynomial of names as terms."""
    match tree.operation:
        case "number":
            return {(): tree.value}
        case "symbol":
            return {((tree.name, 1),): Fraction(1)}
        case "add":
            pieces = [item for part in tree.parts for item in _expanded(part).items()]
        case "pow":
            return _expanded(Tree("mul", tree.parts * tree.exponent))
        case _:
            pieces = [((), Fraction(1))]
            for part in tree.parts:
                inner = _expanded(part).items()
                pieces = [(_joined(a, b), x * y) for a, x in pieces for b, y in inner]
    result: dict[tuple[tuple[str, int], ...], Fraction] = {}
    for powers, value in pieces:
        result[powers] = result.get(powers, Fraction(0)) + value
    return result


def _joined(
    left: tuple[tuple[str, int], ...], right: tuple[tuple[str, int], ...]
) -> tuple[tuple[str, int], ...]:
    powers = dict(left)
    for name, power in right:
        powers[name] = powers.get(name, 0) + power
    return tuple(sorted(powers.items()))
