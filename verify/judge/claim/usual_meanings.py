"""What a claim file need not say: the usual meaning of letters, and all but the formula of a claim.

`symbols = "usual"` gives the letters of `usual_letters` to a setting. What one means depends on the
setting alone. Two that mean one thing are not both used in a setting: \\beta beside K_2 is
another thing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim.notation import is_plain
from gainproof.verify.judge.claim.record import Claim, Setting, SymbolEntry
from gainproof.verify.judge.claim.usual_letters import NOISE_ORDERS, Meaning, bare, usual_letters
from gainproof.verify.judge.claim_symbols import closure, named_by, used
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.reader.reader import read_formula

ORIGINS = ("printed", "words", "reconstructed", "ours")
"""Where a claim comes from: what it says is printed in the source as a formula; the source has
words, which are read as it; the formula of the source is lost or not legible, and this one is made
in its place; the source does not say it, but other claims rest on it or it goes further.
"""
USUAL = "usual"
"""What stands in place of a table of symbols."""
_PARTS = ("tracking_index", "measurement_noise_deviation", "sampling_interval")
"""What the strength of a process noise is made of."""


def usual_origin(claim: Mapping[str, object]) -> str:
    """The origin of a claim that does not say it, by its fields: one with `text`, or without a
    formula, is read out of words; one with an excerpt was seen.
    """
    has_formula = "latex" in claim or "plain" in claim
    return "printed" if has_formula and ("text" not in claim or "quoted" in claim) else "words"


def usual_entries(
    kind: str, model: str | None, explicit: Mapping[str, SymbolEntry]
) -> dict[str, SymbolEntry]:
    """The usual letters of a setting that the file does not declare itself; `explicit` are those
    that it does.
    """
    known = quantity_names()
    found: dict[str, SymbolEntry] = {}
    strengths: dict[str, Meaning] = {}
    for token, meaning in usual_letters(kind, model).items():
        if token in explicit:
            continue
        if meaning.role != "quantity":
            strengths[token] = meaning
            continue
        name = meaning.quantity
        unit, integer = known[name].unit, name == "sample_number"
        found[token] = SymbolEntry(token, meaning.meaning, "quantity", name, unit, integer=integer)
    by_quantity = {e.quantity: t for t, e in [*found.items(), *explicit.items()][::-1]}
    parts = [by_quantity.get(name) for name in _PARTS]
    if model is not None and None not in parts:
        for token, meaning in strengths.items():
            found[token] = _strength(token, meaning, model, [str(part) for part in parts], found)
    return found


def _strength(
    token: str,
    meaning: Meaning,
    model: str,
    parts: Sequence[str],
    symbols: Mapping[str, SymbolEntry],
) -> SymbolEntry:
    """The strength of the process noise: its square is that of the index over powers of T."""
    role, order, _ = NOISE_ORDERS[model]
    index, deviation, interval = parts
    text = (
        rf"\frac{{{index} {deviation}}}{{{interval}^{order // 2}}}"
        if role == "deviation"
        else rf"\frac{{{index}^2 {deviation}^2}}{{{interval}^{order}}}"
    )
    bare_entry = SymbolEntry(token, meaning.meaning, "definition")
    declared = {part: SymbolEntry(part, "", "free") for part in parts} | {token: bare_entry}
    return replace(
        bare_entry, definition=read_formula(f"{token} = {text}", {**symbols, **declared})
    )


def pruned(setting: Setting, usual: Iterable[str], claims: Iterable[Claim]) -> Setting:
    """The setting without usual letters that nothing in it uses, nor a convention about them."""
    named = {name for claim in claims for name in used(claim, setting)}
    explicit = set(setting.symbols).difference(usual)
    kept = closure({*named, *named_by(setting), *explicit}, setting.symbols)
    symbols = {token: entry for token, entry in setting.symbols.items() if token in kept}
    quantities = [entry.quantity or "" for entry in symbols.values()]
    conventions: dict[str, Any] = {}
    if not any(name.startswith("gain.") for name in quantities):
        conventions["gain"] = "filter"
    if not any(name.startswith("covariance.") for name in quantities):
        conventions["covariance"] = "predicted"
    return replace(setting, symbols=symbols, **conventions)


def clash(
    tokens: Iterable[str], before: Mapping[str, str], usual: Iterable[str], setting: Setting
) -> tuple[str, str] | None:
    """A usual letter, and another symbol that means the same: of `before`, by what they mean, or of
    the tokens. None where there is no such pair.
    """
    seen, letters = dict(before), set(usual)
    for token in tokens:
        meaning = means(setting.symbols[token])
        other = seen.setdefault(meaning, token) if meaning else token
        if "covariance." in meaning and bare(other)[:-2] == bare(token)[:-2]:
            continue  # P_{12} and P_{21}
        if other != token and not letters.isdisjoint((token, other)):
            return token, other
    return None


def means(entry: SymbolEntry) -> str:
    """What a symbol stands for, if it is a quantity or a usual strength of the process noise."""
    return entry.quantity or (entry.meaning if entry.role == "definition" else "")


def table_of(setting: Mapping[str, Any], table: object) -> dict[str, Mapping[str, Any]]:
    """The declarations in a file's `table` of symbols of a `setting`, as TOML has them."""
    if isinstance(table, Mapping):
        return dict(table)
    letters = usual_letters(str(setting.get("kind")), setting.get("model"))
    return {token: {"meaning": meaning.meaning} for token, meaning in letters.items()}


def whole_claims(claims: Sequence[Any], kinds: Mapping[str, str]) -> list[Any]:
    """The claims as tables: one that is a formula alone gets the number of its place as id, the
    setting of the file, and None as what is claimed; `kinds` are those of the settings, by name.
    """
    name, kind = next(iter(kinds.items()), ("", ""))

    def whole(number: int, formula: str) -> dict[str, str | None]:
        plain = is_plain(formula) and "^{" not in formula and kind != "matrices"
        place = {"id": str(number), "place": "formulas", "setting": name, "kind": None}
        return place | {"plain" if plain else "latex": formula}

    return [
        whole(number, one) if isinstance(one, str) else one
        for number, one in enumerate(claims, start=1)
    ]
