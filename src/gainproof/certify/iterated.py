"""Kernels with a root that Newton's method finds: the root and its iterates on a piece, by Gappa.

Taken from the printer: that the map y has one fixed point X, with y(x)/x falling through 1 there,
and what a step makes of an iterate's distance from X (`derive.printer.newton`, with the slope and
the curvature that it reads from the map's shape); that a start by bits is within 3.25 % of a cube
root. Gappa shows the rest: where X is, that the start is as near as it has to be, how far roundings
lead a step astray, and how much those after the last iterate but one weigh. That iterate is held
fixed: of its distance from X what the last step leaves is an error of the root of second order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise

from gainproof.certify import gappa, roundings
from gainproof.certify.expression import NotExportedError
from gainproof.certify.gappa import Enclosure
from gainproof.certify.operations import Operation, operations
from gainproof.certify.piece import Piece, Section
from gainproof.certify.sizes import Size, logarithm, sizes
from gainproof.derive.printer.cube_root_start import ERROR
from gainproof.derive.printer.newton import Convergence
from gainproof.derive.printer.program import Step
from gainproof.derive.printer.unrolled_fixed_point import Cycle

ROUGH = Fraction(1, 2**40)
"""The relative error of one step of Newton's method by roundings, which is to be shown."""
NEAR = Fraction(1, 2**30)
"""How near the last iterate but one has to be."""
TRIES = 8


@dataclass(frozen=True)
class Iterated:
    """The operations around a root: of the map, of a step, of the start's cube, and of an output.

    `root` and `before` are the numbers of the last two iterates; `left` is what the distance of the
    one before leaves in the root, over 2^-53.
    """

    root: int
    before: int
    cube: int
    left: Fraction
    cycle: Cycle
    map: tuple[Operation, ...]
    step: tuple[Operation, ...]
    start: tuple[Operation, ...]
    output: tuple[Operation, ...]

    def weighed(
        self, argument: int, low: Fraction, high: Fraction, stop: float
    ) -> Enclosure | None:
        """As `roundings.weighed`, of the output."""
        middle = Size((logarithm(low) + logarithm(high)) / 2, 1, Fraction(1))
        root = self._root(argument, middle)
        known = {argument: middle, self.root: root, self.before: root}
        ends = [
            self._root(argument, replace(middle, log=logarithm(x))).log
            - float(root.power) * logarithm(x)
            for x in (low, high)
        ]
        section = Section(self.map, argument, sizes(self.map, known), {}, {}, {})
        found = self._between(section, ends, low, high, stop)
        if found is None or not self._starts(argument, known, found, low, high, stop):
            return None
        within = 1 + self.cycle.within
        wide = Section(
            self.step,
            argument,
            sizes(self.step, known),
            {self.before: (gappa.down(found[0] / within), gappa.up(found[1] * within))},
            {},
            {},
        )
        rough = roundings.weighed(wide, low, high, stop)
        if rough is None or rough[1] > roundings.MOST:
            return None
        near = gappa.down(found[0] * (1 - NEAR)), gappa.up(found[1] * (1 + NEAR))
        section = Section(
            self.output,
            argument,
            sizes(self.output, known),
            {self.before: near},
            {self.root: near},
            {self.root: 1 + self.left},
        )
        return roundings.weighed(section, low, high, stop)

    def _root(self, argument: int, x: Size) -> Size:
        """About how large the root is, and the power of x that it follows."""
        found = Size(0.0, 1, Fraction(0), Fraction(0))
        for _ in range(60):  # K is at most 1/2 in what is printed; the rest is shown by Gappa
            unknown = Size(found.log, 1, Fraction(0), Fraction(1))
            found = sizes(self.map, {argument: x, self.root: unknown})[self.map[-1].number]
        return Size(found.log, 1, found.power / (1 - found.of_unknown))

    def _between(
        self, section: Section, ends: Sequence[float], low: Fraction, high: Fraction, stop: float
    ) -> Enclosure | None:
        """a and b with y(a) >= a and y(b) <= b on the whole piece, times x^q."""
        result = []
        room = 2.0**-24 + abs(ends[0] - ends[1]) / 64
        steep = 1 / (1 - float(self.cycle.convergence.slope))
        for place, log in ((0, min(ends) - room), (1, max(ends) + room)):
            for _ in range(TRIES):
                whole = round(log)
                value = gappa.down(Fraction(2.0 ** (log - whole)) * Fraction(2) ** whole)
                given = replace(section, given={self.root: (value, value)})
                piece = Piece(given, (), {})
                end, power = section.operations[-1].number, section.sizes[self.root].power
                piece.ask("Y", end, power, gappa.dyadic(value))
                range_of_z = roundings.between(given.root, low, high)
                said = gappa.enclosures(
                    piece.definitions(), [range_of_z, *piece.given], ["Y"], stop
                )
                if "Y" not in said or said["Y"][0] <= 0:
                    return None
                ratio = said["Y"][place]
                if (ratio >= 1) if place == 0 else (ratio <= 1):
                    result.append(value)
                    break
                log += logarithm(ratio) * steep + (room if place else -room) / 16
            else:
                return None
        return result[0], result[1]

    def _starts(
        self,
        argument: int,
        known: dict[int, Size],
        found: Enclosure,
        low: Fraction,
        high: Fraction,
        stop: float,
    ) -> bool:
        """Whether the number whose cube root is the start is normal, and near the root's cube."""
        section = Section(self.start, argument, sizes(self.start, known), {}, {}, {})
        if section.operations[-1].kind == "input" or not roundings.weighed(
            section, low, high, stop
        ):
            return False
        power = known[self.root].power
        section = replace(section, sizes={**section.sizes, self.root: known[self.root]})
        piece = Piece(section, (), {})
        # the cube of the root has three times its power of x, which `ask` takes off
        piece.ask("Y", self.cube, 3 * power, "r * r * r")
        ends = f"r in [{gappa.dyadic(found[0])},{gappa.dyadic(found[1])}]"
        size = piece.sizes[self.cube]
        said = gappa.enclosures(
            piece.definitions(),
            [roundings.between(section.root, low, high), ends, *piece.given],
            ["Y", size],
            stop,
        )
        if "Y" not in said or size not in said:
            return False
        most = ((1 + self.cycle.within) / (1 + Fraction(ERROR))) ** 3
        near = said["Y"][0] * most >= 1 and said["Y"][1] <= most
        return near and said[size][0] >= 2 * roundings.LEAST


def iterated(steps: Sequence[Step], cycle: Cycle, end: int) -> Iterated:
    """The operations of an output with this root. NotExportedError for what has another form."""
    start, *iterates = (steps[number].operands[0] for number in cycle.iterates)
    if steps[start].operation != "near_cbrt" or len(iterates) < 2:
        raise NotExportedError("kernels with iterated roots from other starts")
    _require_like_steps(steps, [start, *iterates])
    error = cycle.within
    for _ in iterates[:-1]:
        error = gappa.up((1 + _after_step(cycle.convergence, error)) * (1 + 2 * ROUGH) - 1)
    left = gappa.up(_after_step(cycle.convergence, error) * 2**53)
    if error > NEAR or left > 1:
        raise NotExportedError("kernels with iterated roots that are not near in time")
    root, before, cube = iterates[-1], iterates[-2], steps[start].operands[0]
    return Iterated(
        root,
        before,
        cube,
        left,
        cycle,
        operations(steps, cycle.map_value, (root,)),
        operations(steps, root, (before,)),
        operations(steps, cube),
        operations(steps, end, (before,)),
    )


def _after_step(map_: Convergence, error: Fraction) -> Fraction:
    """How far a step N leads: X/(1 + e) <= N(x) <= X (1 + e).

    For all x from X/(1 + error) to X (1 + error): 4 of `derive.printer.newton`, in fractions.
    NotExportedError for a distance of which that does not speak.
    """
    most, bend, below = map_.slope, map_.curvature, 1 / (1 + error)
    if below > most:
        above = bend * error**2 / (2 * (1 - most))
        found = max(above, bend * (1 - below) ** 2 / (2 * below * (below - most)))
        if found < 1:
            return found / (1 - found)
    raise NotExportedError("kernels with iterated roots from far starts")


def _require_like_steps(steps: Sequence[Step], iterates: Sequence[int]) -> None:
    """NotExportedError unless each iterate is made of the one before by the same operations.

    What is shown of one step, of the roundings in it too, is then shown of all.
    """
    forms = {_form(operations(steps, new, (old,)), old) for old, new in pairwise(iterates)}
    if len(forms) != 1:
        raise NotExportedError("kernels with iterated roots by unlike steps")


def _form(chosen: Sequence[Operation], before: int) -> tuple[object, ...]:
    """What is made of the iterate `before`, in order, with places in place of numbers."""
    place: dict[int, object] = {before: "iterate"}
    form: list[object] = []
    for each in chosen:
        if any(part in place for part in each.parts):
            parts = tuple(place.get(part, f"step {part}") for part in each.parts)
            place[each.number] = len(form)
            form.append((each.kind, parts, each.factor, each.rounded))
    return tuple(form)
