"""The kernels of converted measurements in the plane, as expression graphs."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.printer.graph import Graph, Node
from gainproof.derive.sensors import converted_forms as forms
from gainproof.derive.sensors.converted_forms import Axes, Noise
from gainproof.derive.sensors.draft import Draft

PLANE = "_in_plane"
KERNELS = {
    "classical": "classical_conversion",
    "debiased": "debiased_conversion",
    "unbiased": "unbiased_conversion",
    "modified": "modified_unbiased_conversion",
}
"""The kernel of each conversion, without what says the number of dimensions."""


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    made = {
        "classical": classical(),
        "debiased": debiased(),
        "unbiased": unbiased(),
        "modified": modified(),
    }
    return {f"{KERNELS[name]}{PLANE}": graph for name, graph in made.items()}


@dataclass(frozen=True)
class Given:
    """Range, deviations, cosine and sine of the azimuth."""

    draft: Draft
    r: Node
    range_: Node
    azimuth: Node
    cos: Node
    sin: Node

    def noise(self) -> tuple[Noise, Node]:
        """What the covariances are made of; and exp(-sigma^2/2), the root of L."""
        variance = self.azimuth * self.azimuth
        kept = self.draft.called("kept_azimuth", "exp", -variance / 2)
        change = self.draft.called("change_azimuth", "expm1", -variance)
        return Noise(self.r, self.range_ * self.range_, kept * kept, -change), kept

    def graph(self, length: Node, axes: Axes) -> Graph:
        """The place at this distance, and the covariance with these axes turned by the azimuth."""
        radial, cross = axes
        along, across = self.cos * self.cos, self.sin * self.sin
        return self.draft.graph(
            {
                "x": length * self.cos,
                "y": length * self.sin,
                "covariance_xx": along * radial + across * cross,
                "covariance_xy": (self.sin * self.cos) * (radial - cross),
                "covariance_yy": across * radial + along * cross,
                "radial_variance": radial,
                "cross_variance": cross,
            }
        )


def given() -> Given:
    """The inputs."""
    draft = Draft()
    r, range_, azimuth = draft.given("slant_range", "range_deviation", "azimuth_deviation")
    return Given(draft, r, range_, azimuth, *draft.circle("azimuth"))


def classical() -> Graph:
    """The measured place, with its covariance to first order."""
    have = given()
    crossing = have.r * have.azimuth
    return have.graph(have.r, (have.range_ * have.range_, crossing * crossing))


def debiased() -> Graph:
    """Less the mean bias, with the mean covariance."""
    have = given()
    noise, kept = have.noise()
    # 1 + k - k^2 with 1 - k = (1 - k^2)/(1 + k)
    length = have.r + have.r * ((kept * noise.lost) / (1 + kept))
    return have.graph(length, forms.debiased(noise))


def unbiased() -> Graph:
    """Divided by what the noise keeps of the mean."""
    have = given()
    noise, kept = have.noise()
    return have.graph(have.r / kept, forms.unbiased(noise))


def modified() -> Graph:
    """Mean and covariance of the truth given the measurement."""
    have = given()
    noise, kept = have.noise()
    return have.graph(have.r * kept, forms.spread(noise))
