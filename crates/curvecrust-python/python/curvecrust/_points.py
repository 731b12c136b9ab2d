"""What a caller gives: points as an array of shape (n, 2), and counts."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def as_points(points: Any, name: str = "points") -> Floats:
    """Return an array of shape (n, 2) and dtype float64, without a copy where there is no need."""
    if isinstance(points, np.ma.MaskedArray) and np.ma.is_masked(points):
        row = int(np.flatnonzero(np.ma.getmaskarray(points).reshape(len(points), -1).any(1))[0])
        raise ValueError(f"row {row} of {name} is masked: leave out masked rows")
    if hasattr(points, "__geo_interface__") or isinstance(points, Mapping):
        return _of_geometry(points, name)
    if isinstance(points, Iterator):
        points = list(points)
    try:
        array = np.asarray(points)
    except ValueError as error:
        raise ValueError(f"{name} must have two coordinates in every row: {error}") from None
    if array.ndim == 0:
        raise TypeError(f"{name} must be an array of shape (n, 2), not {type(points).__name__}")
    if array.dtype.kind == "c":
        if array.ndim != 1:
            raise ValueError(f"complex {name} must have shape (n,), not {array.shape}")
        array = np.ascontiguousarray(array, dtype=np.complex128)
        return array.view(np.float64).reshape(-1, 2)
    if array.size == 0 and array.ndim < 2:
        return np.empty((0, 2))
    if array.ndim != 2 or array.shape[1] != 2:
        hint = ": give points.T" if array.ndim == 2 and array.shape[0] == 2 else ""
        raise ValueError(f"{name} must have shape (n, 2), not {array.shape}{hint}")
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{name} must be numbers, not {array.dtype}")
    try:
        return np.asarray(array, dtype=np.float64)
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be numbers, but hold {_no_number(array)!r}") from None


def _no_number(array: NDArray[Any]) -> Any:
    """Return the first value that is no number."""
    return next((value for value in array.flat if not isinstance(value, (int, float))), None)


def _of_geometry(points: Any, name: str) -> Floats:
    geometry = getattr(points, "geometry", None)
    if geometry is not None and hasattr(geometry, "geom_type"):
        kinds = geometry.geom_type
        if hasattr(kinds, "isin") and kinds.isin(["Point", "MultiPoint"]).all():
            import shapely

            return np.asarray(shapely.get_coordinates(np.asarray(geometry)), dtype=np.float64)
    data = points if isinstance(points, Mapping) else points.__geo_interface__
    rows = [row[:2] for row in _coordinates(data, name)]
    return np.array(rows, dtype=np.float64).reshape(-1, 2)


def _coordinates(data: Mapping[str, Any], name: str) -> Iterable[Any]:
    """Yield the coordinates of all points, without the repeated first one of rings."""
    kind = data.get("type")
    if kind == "FeatureCollection":
        for feature in data["features"]:
            yield from _coordinates(feature, name)
    elif kind == "GeometryCollection":
        for geometry in data["geometries"]:
            yield from _coordinates(geometry, name)
    elif kind == "Feature":
        if data["geometry"] is not None:
            yield from _coordinates(data["geometry"], name)
    elif kind == "Point":
        if data["coordinates"]:
            yield data["coordinates"]
    elif kind in ("MultiPoint", "LineString"):
        yield from data["coordinates"]
    elif kind == "LinearRing":
        yield from data["coordinates"][:-1]
    elif kind == "MultiLineString":
        for line in data["coordinates"]:
            yield from line
    elif kind == "Polygon":
        for ring in data["coordinates"]:
            yield from ring[:-1]
    elif kind == "MultiPolygon":
        for polygon in data["coordinates"]:
            for ring in polygon:
                yield from ring[:-1]
    else:
        raise TypeError(f"{name} are a geometry of type {kind!r}: give points")


def as_count(value: Any, name: str, least: int) -> int:
    """Return a number that counts something, at least `least`."""
    count = operator.index(value)
    if not least <= count < 2**32:
        raise ValueError(f"{name} is {count}, but must be {least} or more")
    return count
