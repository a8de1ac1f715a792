"""The kernels of polar coordinates, in space and in the plane, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors import polar_forms as forms
from gainproof.derive.sensors.draft import Draft
from gainproof.derive.sensors.polar_forms import Place

PLANE = "_in_plane"
"""The end of the names of kernels without elevation and height."""
PLACES = ("x", "y", "z")
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
    in_plane = {
        "to_cartesian": to_cartesian_in_plane(),
        "to_polar": to_polar_in_plane(),
        "cartesian_derivatives": cartesian_derivatives_in_plane(),
        "polar_derivatives": polar_derivatives_in_plane(),
        "noise_covariance": noise_covariance_in_plane(),
        "mean_of_converted": mean_of_converted_in_plane(),
        "straight_course_rates": straight_course_rates_in_plane(),
    }
    return in_space | {f"{name}{PLANE}": graph for name, graph in in_plane.items()}


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


def to_cartesian_in_plane() -> Graph:
    """x, y from range and bearing."""
    draft = Draft()
    (r,) = draft.given("slant_range")
    cos_b, sin_b = draft.circle("bearing")
    return draft.graph({"x": r * sin_b, "y": r * cos_b})


def to_polar_in_plane() -> Graph:
    """Range and bearing from x, y."""
    draft = Draft()
    x, y = draft.given("x", "y")
    r = draft.root("slant_range", x, y)
    return draft.graph({"slant_range": r, "bearing": draft.called("bearing", "atan2", x, y)})


def cartesian_derivatives_in_plane() -> Graph:
    """Of x, y by range and bearing."""
    draft = Draft()
    (r,) = draft.given("slant_range")
    cos_b, sin_b = draft.circle("bearing")
    return draft.graph(
        {
            "x_D_slant_range": sin_b,
            "x_D_bearing": r * cos_b,
            "y_D_slant_range": cos_b,
            "y_D_bearing": -(r * sin_b),
        }
    )


def polar_derivatives_in_plane() -> Graph:
    """Of range and bearing by x, y."""
    draft = Draft()
    x, y = draft.given("x", "y")
    r = draft.root("slant_range", x, y)
    sin_b, cos_b = x / r, y / r
    return draft.graph(
        {
            "slant_range_D_x": sin_b,
            "slant_range_D_y": cos_b,
            "bearing_D_x": cos_b / r,
            "bearing_D_y": -(sin_b / r),
            "slant_range": r,
        }
    )


def noise_covariance_in_plane() -> Graph:
    """The covariance of the converted position to first order."""
    draft = Draft()
    r, deviation, bearing = draft.given("slant_range", "range_deviation", "bearing_deviation")
    cos_b, sin_b = draft.circle("bearing")
    crossing = r * bearing
    ahead, across = deviation * deviation, crossing * crossing
    east, north = sin_b * sin_b, cos_b * cos_b
    return draft.graph(
        {
            "covariance_xx": east * ahead + north * across,
            "covariance_xy": (sin_b * cos_b) * (ahead - across),
            "covariance_yy": north * ahead + east * across,
        }
    )


def mean_of_converted_in_plane() -> Graph:
    """Mean and bias of the converted position under Gaussian noise of the bearing."""
    draft = Draft()
    r, bearing = draft.given("slant_range", "bearing_deviation")
    cos_b, sin_b = draft.circle("bearing")
    x, y = r * sin_b, r * cos_b
    level = -(bearing * bearing) / 2
    kept = draft.called("kept_level", "exp", level)
    lost = draft.called("change_level", "expm1", level)
    return draft.graph(
        {"mean_x": x * kept, "mean_y": y * kept, "bias_x": x * lost, "bias_y": y * lost}
    )


def straight_course_rates_in_plane() -> Graph:
    """First and second derivatives by time on a straight uniform course."""
    draft = Draft()
    x, y, vx, vy = draft.given("x", "y", "velocity_x", "velocity_y")
    r = draft.root("slant_range", x, y)
    sin_b, cos_b = x / r, y / r
    radial = sin_b * vx + cos_b * vy
    crossing = cos_b * vx - sin_b * vy
    turn = crossing / r
    return draft.graph(
        {
            "range_rate": radial,
            "bearing_rate": turn,
            "range_acceleration": (crossing * crossing) / r,
            "bearing_acceleration": -(2 * turn * (radial / r)),
            "slant_range": r,
        }
    )
