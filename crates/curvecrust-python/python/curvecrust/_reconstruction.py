"""Curves through points, and what can be made of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _curvecrust, _geometry, _picture

if TYPE_CHECKING:
    from collections.abc import Iterator

    import geopandas
    import shapely
    from matplotlib.axes import Axes

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Path:
    """Points in order along one curve."""

    indices: Ints
    """The rows of the points, in order. A closed curve runs counter-clockwise where y points up,
    and does not repeat its first row."""
    closed: bool
    """Whether an edge leads from the last point back to the first."""
    points: Floats
    """The points in order, of shape (k, 2)."""
    nesting: int | None
    """How many closed curves surround a closed one: 0 outside, 1 for a hole, 2 for an island in a
    hole. None for an open curve."""
    parent: int | None
    """The place in `paths` of the closed curve right around a closed one, if there is one."""

    def __len__(self) -> int:
        return len(self.indices)

    def __repr__(self) -> str:
        kind = "closed" if self.closed else "open"
        return f"<{kind} Path of {len(self)} points>"


@dataclass(frozen=True, eq=False)
class Reasons:
    """Why least detour has each edge, and what it would cost to go on at open ends."""

    edges: Ints
    """The edges, of shape (m, 2), as in the reconstruction."""
    reasons: list[str]
    """For each edge why it is there: "certified", "completed", "exchanged" or "required"."""
    margins_at_most: Floats
    """For each edge how much more the best curves without it cost at most; nan where nobody
    looked. An upper bound: of what the search finds."""
    ends: Ints
    """The rows of points with a free end."""
    penalties: Floats
    """What each of them pays for ending there."""
    rejected: Ints
    """The point that each would best be joined to, -1 where there is none."""
    costs_at_most: Floats
    """How much more the best curves with that edge cost at most; nan where there is none."""


@dataclass(frozen=True, eq=False)
class Violations:
    """Where a reconstruction shows that points are too sparse: sharp turns and uneven edges."""

    points: Ints
    """The rows of points with two edges."""
    neighbours: Ints
    """The two other ends of these edges, of shape (k, 2)."""
    degrees: Floats
    """The angle between the edges; 180 where the curve goes straight on."""
    length_ratios: Floats
    """The length of the longer edge over that of the shorter."""


class Reconstruction:
    """The curves through points.

    `paths` has an object for every curve. For millions of curves, `indices`, `offsets` and `closed`
    hold the same in three arrays: curve i goes through `indices[offsets[i]:offsets[i + 1]]`.

    Closed curves run counter-clockwise where y points up. Equal points give equal curves, whatever
    their order, but for the names of the rows.
    """

    points: Floats
    """The points as they were given, of shape (n, 2)."""
    indices: Ints
    """The rows of the points of all curves, one curve after the other."""
    offsets: Ints
    """Where each curve begins in `indices`, and the end of the last one."""
    closed: NDArray[np.bool_]
    """Whether each curve is closed."""
    nesting: Ints
    """How many closed curves surround each closed one; -1 for an open one."""
    parents: Ints
    """The closed curve right around each closed one; -1 where there is none."""
    edges: Ints
    """Every edge once, as two rows, of shape (m, 2)."""
    leaves: Ints
    """The ends of open curves."""
    isolated: Ints
    """The points that are on no curve."""
    junctions: Ints
    """The points where three edges or more meet; none by the default method."""
    duplicates: Ints
    """The points that were merged into others, with those others, of shape (k, 2)."""

    def __init__(self, points: Floats, arguments: dict[str, Any], found: dict[str, Any]) -> None:
        """Take what the library found; call `reconstruct` instead."""
        self.points = points
        self._arguments = arguments
        for name, array in found.items():
            setattr(self, name, array)

    def __len__(self) -> int:
        """Return the number of curves."""
        return len(self.closed)

    def __iter__(self) -> Iterator[Path]:
        """Iterate over the curves."""
        return iter(self.paths)

    def __repr__(self) -> str:
        closed = int(self.closed.sum())
        counts = [(closed, "closed curve"), (len(self) - closed, "open curve")]
        counts.append((len(self.isolated), "isolated point"))
        parts = [f"{count} {what}{'' if count == 1 else 's'}" for count, what in counts if count]
        return f"<Reconstruction of {len(self.points)} points: {', '.join(parts) or 'no curve'}>"

    @cached_property
    def paths(self) -> tuple[Path, ...]:
        """The curves, each with its points in order."""
        indices = np.split(self.indices, self.offsets[1:-1]) if len(self) else []
        points = np.split(self.points[self.indices], self.offsets[1:-1]) if len(self) else []
        return tuple(
            Path(
                indices=indices[i],
                closed=bool(self.closed[i]),
                points=points[i],
                nesting=int(self.nesting[i]) if self.nesting[i] >= 0 else None,
                parent=int(self.parents[i]) if self.parents[i] >= 0 else None,
            )
            for i in range(len(self))
        )

    @cached_property
    def reasons(self) -> Reasons | None:
        """Why each edge is there; None for a method that does not say. Computed when asked for."""
        why = _curvecrust.explain(self.points, self._arguments)
        return None if why is None else Reasons(**why)

    @cached_property
    def violations(self) -> Violations:
        """Sharp turns and uneven edges. Computed when asked for."""
        return Violations(**_curvecrust.violations(self.points, self.edges))

    def to_shapely(self) -> list[shapely.LineString]:
        """Return each curve as a LinearRing or a LineString; this needs shapely."""
        return _geometry.lines(self)

    def to_polygons(self) -> list[shapely.Polygon]:
        """Return closed curves as polygons with holes; this needs shapely.

        A curve around which there is an even number of others is the outside of a polygon, and
        those right inside of it are its holes. Open curves are left out.
        """
        return _geometry.polygons(self)

    def to_geopandas(self, crs: Any = None) -> geopandas.GeoDataFrame:
        """Return polygons with holes, then open curves; this needs geopandas.

        The columns are `geometry`, `closed` and `points`, the number of points. `crs` is that of
        the coordinates, in any form that geopandas takes.
        """
        return _geometry.frame(self, crs)

    def to_wkt(self) -> str:
        """Return polygons with holes and open curves as one GEOMETRYCOLLECTION.

        >>> import curvecrust
        >>> curvecrust.reconstruct([(0, 0), (1, 1), (1, 0), (0, 1)]).to_wkt()
        'GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)))'
        """
        return _geometry.wkt(self)

    def to_svg(self, *, points: bool = True) -> str:
        """Return a picture: closed curves, open ones, and points unless these are unwanted.

        The y axis points up, as in a plot.
        """
        return _picture.svg(self, points=points)

    def _repr_svg_(self) -> str | None:
        """Show itself in a notebook, if it is not too large for one."""
        if len(self.points) > _picture.MOST_SHOWN:
            return None
        return _picture.svg(self, points=len(self.points) <= _picture.MOST_DOTS)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draw curves and points with matplotlib, on new axes unless some are given."""
        return _picture.plot(self, ax)
