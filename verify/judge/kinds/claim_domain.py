"""The domain of a claim: where it is said to hold, and what the formula itself rests on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_symbols import reached
from gainproof.verify.judge.domain import bounded
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import number, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.free_names import free_name, token_of, with_tokens
from gainproof.verify.judge.exact.statement import ORDERS, Enclosure, Outcome, Rel, Statement
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.hypotheses import without_equations
from gainproof.verify.judge.kinds.slopes_without_rules import with_slopes
from gainproof.verify.judge.meaning.base_variables import refuse_fractions
from gainproof.verify.judge.meaning.derivatives import Slope
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import SAMPLE, Environment
from gainproof.verify.judge.source_symbols import speaks_of
from gainproof.verify.judge.transcendental.certificate import certificate_of
from gainproof.verify.judge.transcendental.decision import decided
from gainproof.verify.judge.verdict import Finding, finding_of
from gainproof.verify.judge.verdict_words import NOT_COMPARED

PLAIN = ("=", "!=", "<", "<=", ">", ">=")
OTHER = {"=": "!=", "!=": "=", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
"""What is true where a relation with values is not."""
NATURAL = ("identity", "inequality")
"""Kinds of claims whose domain may be where their formula has a value."""
LACKING = "what is supposed has no value"
"""The note of a witness at which a hypothesis has no value."""


@dataclass(frozen=True)
class Frame:
    """Domains of the base variables, further conditions, names for messages, and the derivatives
    in the formulas.

    `natural` are those of the conditions that nobody stated: beyond them sums and integrals have no
    value, or no closed form that has one.
    """

    boxes: Mapping[str, Box]
    conditions: tuple[Rel, ...]
    parameter: str | None
    labels: Mapping[str, str]
    environment: Environment
    slopes: tuple[Slope, ...] = ()
    natural: tuple[Rel, ...] = ()

    def decide(self, statement: Statement) -> Outcome:
        """The statement under the conditions of the frame, kept as asked where the certificate is
        of another one, in other variables. Raises Undecided.
        """
        whole = replace(statement, conditions=(*statement.conditions, *self.conditions))
        found = _with_fixed(self.decide_alone(whole), self.conditions, self.labels)
        own = {name: box for name, box in self.boxes.items() if name in whole.symbols()}
        asked = statement_data(whole, own, self.parameter, self.labels)
        if found.certificate and found.certificate.get("statement") != asked:
            found = replace(found, certificate={**found.certificate, "asked": asked})
        if not self.natural or not found.domain or found.region:
            return found  # a region is told with its conditions
        labels = with_tokens(self.labels, statement.symbols())
        words = [_words(rel, labels) for rel in self.natural]
        told = [found.domain, *words] if found.domain != "everywhere" else words
        return replace(found, domain=", ".join(dict.fromkeys(told)))

    def decide_alone(self, statement: Statement) -> Outcome:
        """The statement without the conditions of the frame, its equations solved and put in."""
        if self.environment.decide is not None:
            own = self.environment.decide(statement, self.boxes, self.labels)
            if own is not None:
                return own
        if statement.connective == "if":
            statement = without_equations(statement, self.boxes, self.parameter, self.labels)

        def alone(part: Statement, boxes: Mapping[str, Box]) -> Outcome:
            found = decided(part, boxes, self.parameter, self.labels)
            if found.witness is None or found.certificate:
                return found
            # seen at a point alone: what is said there has to be known for going through it again
            certificate = certificate_of(part, boxes, self.parameter, self.labels)
            return replace(found, certificate=certificate)

        return with_slopes(statement, self.slopes, self.boxes, alone, self.labels)

    def holds(self, *relations: Rel) -> bool:
        """Whether relations are proved on the whole domain; False also where nothing is known."""
        try:
            return self.decide(Statement(relations)).verdict == "proved"
        except Undecided:
            return False


def fixed_numbers(conditions: Iterable[Rel]) -> dict[str, Fraction]:
    """The symbols that a condition sets to a rational number, with the first that it is."""
    found: dict[str, Fraction] = {}
    for c in conditions:
        for side, other in ((c.left, c.right), (c.right, c.left)):
            if c.operator == "=" and side.kind == "symbol":
                value = constant_value(other)
                if value is not None:
                    found.setdefault(side.name, value)
    return found


def _with_fixed(found: Outcome, conditions: Iterable[Rel], labels: Mapping[str, str]) -> Outcome:
    """The outcome with a witness that tells the symbols too that have one value: they were put in,
    and what is told in other symbols depends on them.
    """
    if found.witness is None:
        return found
    fixed = {labels.get(n, n): str(value) for n, value in fixed_numbers(conditions).items()}
    witness = replace(found.witness, point={**fixed, **found.witness.point})
    reason = found.reason.replace(found.witness.text(), witness.text())
    return replace(found, witness=witness, reason=reason)


def strictly(frame: Frame) -> Frame:
    """The frame in which a conclusion without value counts as false where its premise holds."""
    return replace(frame, boxes={n: replace(b, stated=True) for n, b in frame.boxes.items()})


def where_hypotheses_have_values(
    found: Finding, hypotheses: Iterable[Rel], frame: Frame
) -> Finding:
    """A proof from hypotheses, unless these lack a value somewhere on the domain: nothing is said
    there. Raises Undecided.
    """
    sides = dict.fromkeys(side for rel in hypotheses for side in (rel.left, rel.right))
    partial = tuple(Rel("<=", side, side) for side in sides if not is_total(side))
    if found.verdict != "proved" or not partial:
        return found
    valued = finding_of(frame.decide(Statement(partial)))
    if valued.verdict == "proved":
        return found
    none = Enclosure("", "", NOT_COMPARED)
    witness = valued.witness and replace(valued.witness, left=none, right=none, note=LACKING)
    inner = valued.reason
    if valued.witness and witness:
        # that a side of `side <= side` has no value is no news
        inner = inner.replace(valued.witness.text(), witness.text())
    return replace(valued, reason=inner, witness=witness)


def only_plain(relations: Iterable[Rel]) -> None:
    """Raises Undecided for relations that are neither equations nor orders."""
    for rel in relations:
        if rel.operator not in PLAIN:
            raise Undecided(f"the relation {rel.operator} is not covered here")


def framed(
    claim: Claim, scope: Scope, printed: Iterable[Rel] = (), used: Iterable[Rel] = ()
) -> Frame:
    """The domain from `printed` conditions, the fields `domain` and `given`, and the symbols.

    To be called once the formulas are resolved. `used` are relations that may speak of the sample
    before. Raises Undecided.
    """
    stated = [*printed, *[scope.relation(r) for r in claim.domain]]
    for formula in claim.given:
        if len(formula.readings) != 1:
            raise Undecided("a hypothesis with several readings")
        for relation in formula.readings[0].relations:
            stated += scope.relations(relation)
    _meet_hidden(scope)
    done: set[str] = set()
    while pending := [token for token in scope.used if token not in done]:
        for token in pending:
            done.add(token)
            stated += [scope.relation(r) for r in scope.setting.symbols[token].domain]
    stated += [*scope.supposed, *scope.environment.conditions]
    if _rests_on_model(scope.used, scope.setting, scope.environment):
        stated += scope.environment.rests
    if scope.uses_steady() and scope.environment.region is not None:
        # without stability a steady covariance or lag has no value
        stated += scope.environment.region.relations
    only_plain(stated)
    boxes = scope.boxes()
    before = {s for rel in used for s in symbols_of(rel.left, rel.right)}
    if SAMPLE in boxes and any(name.startswith("previous_state") for name in before):
        # there is no sample before the first one
        lower = boxes[SAMPLE].lower
        boxes[SAMPLE] = replace(boxes[SAMPLE], lower=max(lower or Fraction(0), Fraction(1)))
    boxes, rest = bounded({**boxes, **scope.bound_domains}, stated)
    boxes = _spoken_of(boxes, rest)
    refuse_fractions(scope.whole, boxes)
    empty = [n for n, box in boxes.items() if box.is_empty and n not in scope.bound_domains]
    if empty:
        # also of a symbol that the formula does not hold: a hypothesis fails everywhere
        raise Undecided(f"the domain of {scope.labels().get(empty[0], empty[0])} is empty")
    environment = scope.environment
    labels, slopes = scope.labels(), tuple(scope.slopes)
    frame = Frame(boxes, rest, environment.parameter, labels, environment, slopes)
    if scope.environment.assigned:
        frame = _without_implied(frame)
        _refuse_other_model(frame, scope)
    return _with_required(frame, scope.required, _unsaid(frame) if claim.kind in NATURAL else set())


def where_model_is(
    found: Finding, claim: Claim, setting: Setting, environment: Environment
) -> Finding:
    """The finding with all in its domain that the model of its quantities rests on; a bound of a
    symbol that the domain speaks of is told there already.
    """
    domain = found.domain
    if domain in (None, "nowhere") or found.verdict == "refuted":
        return found
    if not _rests_on_model(reached(claim, setting), setting, environment):
        return found
    words = [] if domain == "everywhere" else [domain]
    told = domain.removeprefix("for ").split(", ")
    for rel in environment.rests:
        names = symbols_of(rel.left, rel.right)
        is_bound = len(names) == 1 and (rel.operator in ORDERS or bool(found.region))
        more = _words(rel, with_tokens({}, names))
        if more not in told and not (is_bound and speaks_of(domain, token_of(min(names)))):
            words.append(more if words else f"for {more}")
            told.append(more)
    return replace(found, domain=", ".join(words) or domain)


def _rests_on_model(tokens: Iterable[str], setting: Setting, environment: Environment) -> bool:
    """Whether one of these symbols is a quantity of a model that exists under conditions alone."""
    named = {entry.quantity for t in tokens if (entry := setting.symbols.get(t)) is not None}
    return bool(environment.rests) and not named.isdisjoint(environment.quantities)


def _meet_hidden(scope: Scope) -> None:
    """Symbols with domains that no formula names count as met where what it names is made of them,
    as a variance is of the process noise, and gains where stable filters are spoken of.
    """
    environment, symbols = scope.environment, scope.setting.symbols
    met = (symbols[token].quantity or "" for token in scope.used)
    within = symbols_of(*[environment.quantities[n] for n in met if n in environment.quantities])
    region = () if environment.region is None else environment.region.relations
    gains = symbols_of(*[side for rel in region for side in (rel.left, rel.right)])
    for token, entry in symbols.items():
        if not entry.domain or entry.shape is not None:
            continue
        known = environment.quantities.get(entry.quantity or "")
        is_gain = known is not None and known.kind == "symbol" and known.name in gains
        if is_gain or (entry.role == "free" and free_name(token) in within):
            scope.symbol(token)


def _spoken_of(boxes: Mapping[str, Box], conditions: Iterable[Rel]) -> dict[str, Box]:
    """The boxes, stated where a condition bounds the symbol in any other form than by a number.

    Where x^2 < 4 a formula without value at x = -1 fails there, as it does where x < 4.
    """
    orders = [rel for rel in conditions if rel.operator != "="]
    names = {n for rel in orders for n in symbols_of(rel.left, rel.right)}
    return {n: replace(box, stated=box.stated or n in names) for n, box in boxes.items()}


def _without_implied(frame: Frame) -> Frame:
    """Without the conditions that a model of the source's own makes true everywhere."""
    bare = replace(frame, conditions=())
    return replace(frame, conditions=tuple(c for c in frame.conditions if not bare.holds(c)))


def _refuse_other_model(frame: Frame, scope: Scope) -> None:
    """Raises Undecided where a symbol of the model cannot lie in its domain, whatever the model is.

    With an intensity q < 0 there is none: nothing holds of its gain, be q in the formula or not.
    """
    bare = replace(frame, conditions=())
    for token in scope.environment.assigned:
        for rel in scope.setting.symbols[token].domain:
            stated = scope.relation(rel)
            if bare.holds(_opposite(stated)):
                raise Undecided(f"the model does not hold where {token} is said to lie")


def _unsaid(frame: Frame) -> set[str]:
    """Symbols of which nothing was said: they lie where a formula has a value."""
    return {name for name, box in frame.boxes.items() if not box.stated}


def _with_required(frame: Frame, required: Iterable[Rel], unsaid: set[str]) -> Frame:
    """The frame where sums have their bounds in order, series and integrals converge and closed
    forms have values. Raises Undecided.

    A symbol of which nothing was said begins where its sum has a term; `unsaid` ones lie where all
    of this holds.
    """
    said = frame.boxes
    for rel in required:
        narrowed = _beginning(rel, said)
        if narrowed is not None:
            frame = replace(frame, boxes=_later(frame.boxes, narrowed))
        elif frame.holds(rel):
            continue
        elif symbols_of(rel.left, rel.right) <= unsaid and _fails(frame, _opposite(rel)):
            conditions, more = (*frame.conditions, rel), (*frame.natural, rel)
            frame = replace(frame, conditions=conditions, natural=more)
        else:
            raise Undecided(
                "a sum with its bounds turned round, a sum or integral without a value, or a "
                "variance below 0 is not excluded by the domain that is stated, which does not say "
                f"that {_words(rel, with_tokens(frame.labels, symbols_of(rel.left, rel.right)))}"
            )
    return frame


def _opposite(rel: Rel) -> Rel:
    return Rel(OTHER[rel.operator], rel.left, rel.right)


def _words(rel: Rel, labels: Mapping[str, str]) -> str:
    return f"{labelled(rel.left, labels)} {rel.operator} {labelled(rel.right, labels)}"


def _fails(frame: Frame, rel: Rel) -> bool:
    """Whether a point of the domain is known where a relation is false; False also where nothing
    is.
    """
    try:
        return frame.decide(Statement((rel,))).verdict in ("refuted", "conditional")
    except Undecided:
        return False


def _later(boxes: Mapping[str, Box], narrowed: Mapping[str, Box]) -> dict[str, Box]:
    """The boxes with those that begin later."""
    found = dict(boxes)
    for name, box in narrowed.items():
        known = found[name].lower
        if known is None or (box.lower is not None and box.lower > known):
            found[name] = box
    return found


def _beginning(rel: Rel, boxes: Mapping[str, Box]) -> dict[str, Box] | None:
    """For `k + constant >= -1` with an integer k of no stated domain: k + constant >= 0."""
    names = symbols_of(rel.left)
    if rel.operator != ">=" or rel.right != number(-1) or len(names) != 1:
        return None
    (name,) = names
    box = boxes.get(name, Box())
    at = [constant_value(substituted(rel.left, {name: number(n)})) for n in (0, 1)]
    if box.stated or not box.integer or at[0] is None or at[1] is None or at[1] - at[0] != 1:
        return None
    return {name: Box(lower=-at[0], lower_open=False, integer=True)}
