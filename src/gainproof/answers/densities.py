"""Which Kalman-Bucy filter is meant where symbols are said to be densities: that of a position and
its derivatives, each driven by one white noise at most. What does not fit into it is refused, so
that no letter of the model is left out without a word.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from gainproof.bad_input import BadInputError
from gainproof.claims.toml_text import quoted
from gainproof.verify.judge.claim import letters
from gainproof.verify.judge.claim.letters import Meaning
from gainproof.verify.judge.claim.units import read_unit
from gainproof.verify.judge.quantity_names import quantity_names

NOISES = ("measured position", "white velocity", "white acceleration", "white jerk")
UNITS = ("m^2 s", "m^2 s^-1", "m^2 s^-3", "m^2 s^-5")
CONTINUOUS = ("gain.", "continuous_gain.", "covariance.")
"""Beginnings of the quantities that a Kalman-Bucy filter has."""
BY_FILE = "write a claim file with a setting of kind kalman_bucy (docs/claim-files.md)"


@dataclass(frozen=True)
class Densities:
    """The symbol for the density of the measurement, and those for the noises by the order of the
    derivative that each drives.
    """

    measured: str
    driving: Mapping[int, str]

    @property
    def title(self) -> str:
        """The filter in words."""
        noises = [f"{token} of a {NOISES[order]}" for order, token in sorted(self.driving.items())]
        told = ", ".join([*noises, f"{self.measured} of the {NOISES[0]}"])
        return f"Kalman-Bucy filter in its steady state, densities {told}"

    def lines(self) -> tuple[str, ...]:
        """The fields of its setting: each component is the derivative of the one before."""
        size = range(max(self.driving))
        a = [[str(int(j == i + 1)) for j in size] for i in size]
        q = [[self.driving.get(i + 1, "0") if i == j else "0" for j in size] for i in size]
        h, r = [[str(int(j == 0)) for j in size]], [[self.measured]]
        matrices = {"transition": a, "process_noise": q, "measurement": h, "measurement_noise": r}
        texts = (
            f"{name} = [{', '.join('[' + ', '.join(map(quoted, row)) + ']' for row in rows)}]"
            for name, rows in matrices.items()
        )
        return ('kind = "kalman_bucy"', *texts)

    def symbols(
        self, meant: Mapping[str, Meaning], domain: str, of: Collection[str]
    ) -> dict[str, Meaning]:
        """What the symbols are there. The domain of the claim, which speaks `of` symbols, belongs
        to the model where it speaks of densities alone.
        """
        names = quantity_names()
        found = {
            token: letters.quantity(f"continuous_{name}", names[f"continuous_{name}"].meaning)
            if (name := each.quantity).startswith("gain.")
            else each
            for token, each in meant.items()
        }
        if domain and {*of} <= {self.measured, *self.driving.values()}:
            own = found[self.measured]
            both = ", ".join(filter(None, (own.domain, domain.replace(r"\quad ", ""))))
            found[self.measured] = replace(own, domain=both)
        return found


def order_of(meaning: Meaning) -> int | None:
    """The order of the derivative that a noise of this density drives, 0 of the density of a
    measured position; None of anything else.
    """
    if meaning.role != "free" or meaning.definition:
        return None
    unit = read_unit(meaning.unit)
    return next((order for order, text in enumerate(UNITS) if unit == read_unit(text)), None)


def densities(meant: Mapping[str, Meaning]) -> Densities | None:
    """The densities among the symbols; None where no measurement in continuous time is spoken of.
    Raises BadInputError where they are no whole model, or something else stands beside them.
    """
    found: dict[int, str] = {}
    for token, each in meant.items():
        order = order_of(each)
        if order is None:
            continue
        if order in found:
            raise BadInputError(
                f"{found[order]} and {token} are both in {UNITS[order]}, as densities of a "
                f"{NOISES[order]} are: which stands where is not guessed; {BY_FILE}"
            )
        found[order] = token
    measured = found.pop(0, None)
    foreign = [
        token
        for token, each in meant.items()
        if each.role != "free" and not each.quantity.startswith(CONTINUOUS)
    ]
    if measured is None or (not found and any(meant[t].role != "density" for t in foreign)):
        return None
    discrete = "or --model with the name of a filter in discrete time"
    if not found:
        raise BadInputError(
            f"{measured} in m^2 s is taken for the density of a measurement in continuous time: "
            "say what the density of the process noise is, --symbol 'q: m^2 s^-3 > 0' for a white "
            f"acceleration, m^2 s^-1 for a white velocity; {discrete}"
        )
    if foreign:
        token = foreign[0]
        if meant[token].role == "density":
            raise BadInputError(
                f"{token} is taken for another density of process noise: say of which by its unit, "
                f"--symbol '{token}: {UNITS[2]} > 0' for a {NOISES[2]}, or what else it is"
            )
        raise BadInputError(
            f"{token} is taken for the {meant[token].meaning}, which a filter in continuous time "
            f"does not have, and {measured} in m^2 s makes it one: say --symbol '{token}: ...', "
            f"{discrete}"
        )
    _refuse_others(meant, max(found))
    return Densities(measured, found)


def _refuse_others(meant: Mapping[str, Meaning], highest: int) -> None:
    """Raises BadInputError for a rate, which a model with other matrices holds, and for a component
    beyond the last that is driven.
    """
    for token, each in meant.items():
        parts = [int(part) for part in each.quantity.split(".") if part.isdigit()]
        if max(parts, default=0) > highest:
            needed = max(parts)
            raise BadInputError(
                f"{token} is a component {needed}, and no noise is said that drives it: "
                f"--symbol 'q: {UNITS[min(needed, 3)]} > 0' is the density of a "
                f"{NOISES[min(needed, 3)]}"
            )
        other = each.role == "free" and not each.definition and order_of(each) is None
        if other and read_unit(each.unit).second:
            raise BadInputError(
                f"{token} in {each.unit} is no density, and the model that is guessed, derivatives "
                f"of a position, does not hold it: if your model does, {BY_FILE}; if it is short "
                f"for something, say --symbol '{token}: = ...'"
            )
