"""What the strength of a noise may mean other than a model's matrices say: a density, a variance or
a deviation. A refuted claim that is proved of another one names it, and stays refuted.
"""

from __future__ import annotations

import math
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry, Unit
from gainproof.verify.judge.claim_symbols import reached
from gainproof.verify.judge.contradicted_convention import CHANCE, FALSE, TRUE
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.exact.expression import Expr, mul, power, symbol
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.setting.environment import INTERVAL, NotEstablished
from gainproof.verify.judge.setting.own_matrices import interval_symbol, read_matrices
from gainproof.verify.judge.setting.spectral_factor import number_root
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.transcendental.monomials import monomials, ordered
from gainproof.verify.judge.trial import Trial, findings_of
from gainproof.verify.judge.verdict import ClaimVerdict
from gainproof.verify.judge.verdict_words import STRENGTH

DENSITY = 1
"""The power of T beside the density of a noise in the last entry of a process noise: that of a
noise which is constant between samples has 2, that of an increment at each sample 0.
"""
CONSTANT = 2


@dataclass(frozen=True)
class Strength:
    """Symbol `token` to the power `size` stands in the last entry of the process noise, times T to
    `times` and a number; of the noise of the measurement `place` is empty. `rest`: other entries of
    the process noise are not 0.
    """

    token: str
    size: int
    times: int = 0
    number: Fraction = Fraction(1)
    place: str = ""
    interval: str = ""
    rest: bool = False

    def others(self) -> Iterator[Strength]:
        """Those with another power of the symbol, of T, or of both."""
        powers_of_time = {DENSITY: (CONSTANT, 0), CONSTANT: (DENSITY,), 0: (DENSITY,)}
        moved = powers_of_time.get(self.times, ()) if self.place and self.interval else ()
        for size in (self.size, 3 - self.size):
            yield from (replace(self, size=size, times=times) for times in moved)
            if size != self.size:
                yield replace(self, size=size)

    def words(self, stated: Strength) -> str:
        """What the symbol is, with the entry that says so; where that has another power of T than
        `stated` the other entries have it too, which is not all that such a noise may do to them.
        """
        base = self.token if self.size == 1 else f"{self.token}^{self.size}"
        if not self.place:
            what = "variance" if self.size == 1 else "deviation"
            return f"{self.token} as the {what} of the measurement noise"
        what = {
            DENSITY: "the density of the process noise",
            CONSTANT: "the variance of a process noise that is constant between samples",
        }.get(self.times, "the variance of an increment at each sample")
        time = {0: "", 1: f" {self.interval}"}.get(self.times, f" {self.interval}^{self.times}")
        factor = "" if self.number == 1 else f"{self.number} "
        rest = ", the rest of Q in proportion" if self.rest and self.times != stated.times else ""
        return f"{base} as {what}: {self.place} = {factor}{base}{time}{rest}"

    def value(self, stated: Strength, expr: Expr) -> Expr:
        """The symbol in base variables where it has the value `expr` with what is stated."""
        whole = mul(power(expr, stated.size), power(symbol(INTERVAL), stated.times - self.times))
        if self.size == 1:
            return whole
        found = monomials(whole)
        if len(found) != 1:
            return power(whole, Fraction(1, self.size))
        ((monomial, factor),) = found.items()
        roots = [power(base, Fraction(n, self.size)) for base, n in ordered(monomial)]
        return mul(number_root(factor), *roots) if factor != 1 else mul(*roots)

    def entry(self, stated: Strength, entry: SymbolEntry) -> SymbolEntry:
        """The declaration with the unit that the symbol has then."""
        if entry.unit is None:
            return entry
        time = Unit(second=Fraction(stated.times - self.times))
        unit = (entry.unit**stated.size * time) ** Fraction(1, self.size)
        return replace(entry, unit=unit)


def strengths(setting: Setting) -> list[Strength]:
    """What the matrices of a setting's own model say of its noises, as far as each has one symbol.
    Raises Undecided.
    """
    if setting.own_model is None:
        return []
    scope, (_, q, _, r) = read_matrices(setting)
    here = interval_symbol(setting, scope)
    declared = (t for t, e in setting.symbols.items() if e.quantity == INTERVAL)
    interval = next(iter((*here, *declared)), "")
    last = next((row[i] for i, row in reversed(list(enumerate(q))) if monomials(row[i])), None)
    size = next((i + 1 for i, row in reversed(list(enumerate(q))) if monomials(row[i])), 0)
    times = {symbol(INTERVAL), *(symbol(free_name(token)) for token in here)}
    found = []
    for expr, place in ((last, f"Q_{{{size}{size}}}"), (r[0][0], "")):
        terms = {} if expr is None else monomials(expr)
        if len(terms) != 1:
            continue
        ((monomial, factor),) = terms.items()
        powers = dict(ordered(monomial))
        clock = sum(n for base, n in powers.items() if base in times)
        own = {b.name: n for b, n in powers.items() if b not in times and b.kind == "symbol"}
        tokens = [t for t in setting.symbols if free_name(t) in own]
        if len(own) == 1 and len(powers) <= 2 and len(tokens) == 1:
            (count,) = own.values()
            if count in (1, 2):
                rest = bool(place) and sum(bool(monomials(e)) for row in q for e in row) > 1
                found.append(Strength(tokens[0], count, clock, factor, place, interval, rest))
    return found


@dataclass(frozen=True)
class StrengthTask:
    """A refuted claim with other meanings of the strengths of noises that it speaks of."""

    claim: Claim
    setting: Setting
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """One trial with the findings of all of them."""
        start = time.perf_counter()
        found: list[Convention] = []
        with suppress(Undecided, Malformed, NotEstablished):
            every = [*conventions(self.setting, models, solved)]
            for stated in strengths(self.setting):
                if stated.token not in reached(self.claim, self.setting):
                    continue
                for other in stated.others():
                    stood = (c for c in every if isinstance(c, Convention))
                    fixed = (c for c in stood if stated.token in c.environment.assigned)
                    found += [_with(c, stated, other) for c in fixed]
        findings = findings_of(self.claim, found)
        return Trial(self.claim, findings, (), True, time.perf_counter() - start)


def _with(convention: Convention, stated: Strength, other: Strength) -> Convention:
    token = stated.token
    setting, environment = convention.setting, convention.environment

    def changed(assigned: Mapping[str, Expr]) -> dict[str, Expr]:
        return {t: other.value(stated, e) if t == token else e for t, e in assigned.items()}

    chart = environment.chart
    if chart is not None:
        chart = replace(chart, assigned=changed(chart.assigned))
    filled = environment.name if convention.open else ""
    name = ", ".join(part for part in (other.words(stated), filled) if part)
    symbols = {**setting.symbols, token: other.entry(stated, setting.symbols[token])}
    environment = replace(
        environment, name=name, assigned=changed(environment.assigned), chart=chart
    )
    return replace(convention, environment=environment, setting=replace(setting, symbols=symbols))


def strength_tasks(
    setting: Setting, claims: Sequence[Claim], verdicts: Sequence[ClaimVerdict]
) -> list[StrengthTask]:
    """Tasks for the refuted claims of a setting with matrices of its own."""
    refuted = {v.id for v in verdicts if v.verdict == FALSE}
    if setting.own_model is None:
        return []
    return [StrengthTask(c, setting) for c in claims if c.id in refuted and c.kind not in CHANCE]


def with_strengths(
    verdicts: Sequence[ClaimVerdict], trials: Mapping[str, Trial]
) -> list[ClaimVerdict]:
    """The verdicts, those on claims that hold with another strength with the first such one."""

    def named(verdict: ClaimVerdict) -> ClaimVerdict:
        trial = trials.get(verdict.id)
        fits = [n for n, f in trial.findings.items() if f.verdict == TRUE] if trial else []
        if verdict.verdict != FALSE or not fits:
            return verdict
        return replace(verdict, certificate={**verdict.certificate, STRENGTH: fits[0]})

    return [named(verdict) for verdict in verdicts]
