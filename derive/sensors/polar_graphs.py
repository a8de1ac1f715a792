"""The kernels of polar coordinates in space, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors import polar_forms as forms
from gainproof.derive.sensors import polar_plane_graphs
from gainproof.derive.sensors.draft import Draft
from gainproof.derive.sensors.polar_forms import Place
from gainproof.derive.sensors.polar_names import PLACES

DEVIATIONS = ("range_deviation", "elevation_deviation", "bearing_deviation")


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    in_space = {
        "to_cartesian": to_cartesian(),
        "to_polar": to_polar(),
        "cartesian_derivatives": cartesian_derivatives(),
        "polar_derivatives": polar_derivatives(),
        "noise_covariance": noise_covariance(),
        "mean_of_converted": mean_of_converted(),
        "straight_course_rates": straight_course_rates(),
    }
    return in_space | polar_plane_graphs.graphs()


def to_cartesian() -> Graph:
    """x, y, z from range, elevation and bearing."""
    draft = Draft()
    (r,) = draft.given("slant_range")
    found = forms.place(r, draft.direction())
    return draft.graph(dict(zip(PLACES, found, strict=True)))


def to_polar() -> Graph:
    """Range, elevation and bearing from x, y, z."""
    draft = Draft()
    x, y, z = draft.given(*PLACES)
    h = draft.root("horizontal_distance", x, y)
    squares = (x * x + y * y) + z * z
    draft.names["slant_range"] = draft.builder.sqrt(squares)
    return draft.graph(
        {
            "slant_range": draft.names["slant_range"],
            "elevation": draft.called("elevation", "atan2", z, h),
            "bearing": draft.called("bearing", "atan2", x, y),
        }
    )


def cartesian_derivatives() -> Graph:
    """Of x, y, z by range, elevation and bearing."""
    draft = Draft()
    (r,) = draft.given("slant_range")
    found = forms.derivatives(r, draft.direction())
    return draft.graph({f"{place}_D_{polar}": value for (place, polar), value in found.items()})


def polar_derivatives() -> Graph:
    """Of range, elevation and bearing by x, y, z."""
    draft = Draft()
    place = _place(draft)
    found = forms.inverse_derivatives(place)
    outputs = {f"{polar}_D_{name}": value for (polar, name), value in found.items()}
    return draft.graph({**outputs, "horizontal_distance": place.h})


def _place(draft: Draft) -> Place:
    x, y, z = draft.given(*PLACES)
    h = draft.root("horizontal_distance", x, y)
    return Place(x, y, z, h, draft.root("slant_range", h, z))


def noise_covariance() -> Graph:
    """The covariance of the converted position to first order."""
    draft = Draft()
    (r, *deviations) = draft.given("slant_range", *DEVIATIONS)
    return draft.graph(forms.noise_covariance(r, draft.direction(), *deviations))


def mean_of_converted() -> Graph:
    """Mean and bias of the converted position under Gaussian noise of the angles."""
    draft = Draft()
    r, elevation, bearing = draft.given("slant_range", *DEVIATIONS[1:])
    x, y, z = forms.place(r, draft.direction())
    up = -(elevation * elevation) / 2
    level = -(elevation * elevation + bearing * bearing) / 2
    kept_up = draft.called("kept_upwards", "exp", up)
    kept = draft.called("kept_level", "exp", level)
    lost_up = draft.called("change_upwards", "expm1", up)
    lost = draft.called("change_level", "expm1", level)
    return draft.graph(
        {
            "mean_x": x * kept,
            "mean_y": y * kept,
            "mean_z": z * kept_up,
            "bias_x": x * lost,
            "bias_y": y * lost,
            "bias_z": z * lost_up,
        }
    )


def straight_course_rates() -> Graph:
    """First and second derivatives by time on a straight uniform course."""
    draft = Draft()
    place = _place(draft)
    found = forms.rates(forms.sight(place, draft.given(*(f"velocity_{name}" for name in PLACES))))
    return draft.graph({**found, "horizontal_distance": place.h})
