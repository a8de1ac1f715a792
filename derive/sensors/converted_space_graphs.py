"""The kernels of converted measurements in space, as expression graphs."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.printer.graph import Graph, Node
from gainproof.derive.sensors import converted_space_forms as forms
from gainproof.derive.sensors.converted_forms import Noise
from gainproof.derive.sensors.converted_graphs import KERNELS
from gainproof.derive.sensors.converted_space_forms import Frame, Sight
from gainproof.derive.sensors.draft import Draft


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    made = {
        "classical": classical(),
        "debiased": debiased(),
        "unbiased": unbiased(),
        "modified": modified(),
    }
    return {KERNELS[name]: graph for name, graph in made.items()}


@dataclass(frozen=True)
class Given:
    """Range, deviations of range, elevation and azimuth, and cosines and sines of the two."""

    draft: Draft
    r: Node
    range_: Node
    elevation: Node
    azimuth: Node
    cos_e: Node
    sin_e: Node
    cos_a: Node
    sin_a: Node

    def plain(self) -> Sight:
        """Without exponentials."""
        noise = Noise(self.r, self.range_ * self.range_, None, None)
        return Sight(self.cos_e, self.sin_e, noise, None, None, None)

    def sight(self) -> tuple[Sight, Node]:
        """What the covariances are made of; and the root of the elevation's L."""
        rising, upright, upright_lost = self._kept("elevation", self.elevation)
        level, kept, lost = self._kept("azimuth", self.azimuth)
        noise = Noise(self.r, self.range_ * self.range_, upright, upright_lost)
        return Sight(self.cos_e, self.sin_e, noise, level, kept, lost), rising

    def _kept(self, angle: str, deviation: Node) -> tuple[Node, Node, Node]:
        variance = deviation * deviation
        root = self.draft.called(f"kept_{angle}", "exp", -variance / 2)
        change = self.draft.called(f"change_{angle}", "expm1", -variance)
        return root, root * root, -change

    def graph(self, level: Node, height: Node, frame: Frame) -> Graph:
        """At these distances ahead and up, the frame turned by the azimuth."""
        place = {"x": level * self.cos_a, "y": level * self.sin_a, "z": height}
        return self.draft.graph(place | forms.in_coordinates(frame, self.cos_a, self.sin_a))


def given() -> Given:
    """The inputs."""
    draft = Draft()
    r, range_ = draft.given("slant_range", "range_deviation")
    elevation, azimuth = draft.given("elevation_deviation", "azimuth_deviation")
    upright, level = draft.circle("elevation"), draft.circle("azimuth")
    return Given(draft, r, range_, elevation, azimuth, *upright, *level)


def classical() -> Graph:
    """The measured place, with its covariance to first order."""
    have = given()
    frame = forms.classical(have.plain(), have.elevation, have.azimuth)
    return have.graph(have.r * have.cos_e, have.r * have.sin_e, frame)


def debiased() -> Graph:
    """Less the mean bias, with the mean covariance."""
    have = given()
    sight, rising = have.sight()
    both = sight.kept_root * rising
    # 1 + k - k^2 with 1 - k = (1 - k^2)/(1 + k)
    level = (have.r * have.cos_e) * (1 + (both * forms.lost_of_both(sight)) / (1 + both))
    height = (have.r * have.sin_e) * (1 + (rising * sight.rising.lost) / (1 + rising))
    return have.graph(level, height, forms.debiased(sight))


def unbiased() -> Graph:
    """Divided by what the noise keeps of the mean."""
    have = given()
    sight, rising = have.sight()
    level = (have.r * have.cos_e) / (sight.kept_root * rising)
    return have.graph(level, (have.r * have.sin_e) / rising, forms.unbiased(sight, rising))


def modified() -> Graph:
    """Mean and covariance of the truth given the measurement."""
    have = given()
    sight, rising = have.sight()
    level = (have.r * have.cos_e) * (sight.kept_root * rising)
    return have.graph(level, (have.r * have.sin_e) * rising, forms.spread(sight))
