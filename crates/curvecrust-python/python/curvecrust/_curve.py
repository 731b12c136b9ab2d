"""Curves to samples, and what is known of curves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _curvecrust
from ._points import as_points
from ._progress import listening

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


class Curve:
    """Curves in the plane: closed or open, made of cubic Béziers, with or without corners.

    Make one by `Curve.from_svg`, `Curve.from_path` or `Curve.from_points`.
    """

    def __init__(self, curve: _curvecrust.Curve) -> None:
        """Take a curve of the extension module; use the functions `from_...` instead."""
        self._curve = curve

    @classmethod
    def from_svg(cls, text: str, *, snap: float = 1e-4) -> Curve:
        """Read the paths and shapes of an SVG document, with the y axis pointing down.

        Parameters
        ----------
        text : str
            The document itself, not the name of a file.
        snap : float
            Gaps and segments up to this share of the drawing are rounding errors, and joined.

        Raises
        ------
        ValueError
            For text that is no SVG, and for drawings without curves.
        """
        return cls(_curvecrust.Curve.from_svg(text, snap))

    @classmethod
    def from_path(cls, d: str) -> Curve:
        """Read path data of SVG, the attribute d.

        >>> import curvecrust
        >>> curvecrust.Curve.from_path("M 0 0 H 4 V 3 Z")
        <Curve of 1 component, closed, 3 corners>
        """
        return cls(_curvecrust.Curve.from_path(d))

    @classmethod
    def from_points(cls, samples: Any, *, closed: bool = True) -> Curve:
        """Lay a smooth curve through points in order.

        At each point it has the tangent of the circle through that point and its neighbours.

        Parameters
        ----------
        samples : array_like of shape (n, 2)
            Three points or more; for an open curve two.
        closed : bool
            Whether it goes on from the last point to the first.
        """
        return cls(_curvecrust.Curve.from_points(as_points(samples, "samples"), bool(closed)))

    @property
    def closed(self) -> list[bool]:
        """Whether each component is closed."""
        return self._curve.closed

    @property
    def corners(self) -> Floats:
        """The corners, of shape (k, 2)."""
        return self._curve.corners()["at"]

    @property
    def extent(self) -> float:
        """The larger side of the bounding box."""
        return self._curve.extent

    def polylines(self, per_segment: int = 32) -> list[Floats]:
        """Return points along each smooth piece, `per_segment` on each Bézier.

        That of a closed piece ends where it begins.
        """
        found = self._curve.polylines(per_segment)
        parts = np.split(found["points"], found["starts"][1:])
        pairs = zip(parts, found["closed"], strict=True)
        return [np.vstack((part, part[:1])) if closed else part for part, closed in pairs]

    def __repr__(self) -> str:
        count, corners = len(self.closed), len(self.corners)
        kinds = {True: "closed", False: "open"}
        kind = kinds[self.closed[0]] if len(set(self.closed)) == 1 else "closed and open"
        plural = "" if count == 1 else "s"
        with_corners = f", {corners} corner{'' if corners == 1 else 's'}" if corners else ""
        return f"<Curve of {count} component{plural}, {kind}{with_corners}>"


@dataclass(frozen=True, eq=False, repr=False)
class Samples:
    """Samples of a curve, in order along each of its components."""

    points: Floats
    """The samples, of shape (n, 2)."""
    offsets: Ints
    """Where each component begins, and the end of the last one."""
    closed: NDArray[np.bool_]
    """Whether each component is closed."""
    edges: Ints
    """The edges between consecutive samples, of shape (m, 2): what is to be reconstructed."""
    attained: tuple[float, float] | None
    """The largest epsilon or rho that the samples attain, and a bound that it does not exceed."""
    is_decoded: bool | None
    """For curves with corners, whether least detour returns exactly these edges; of strokes that
    are apart, those of each from its own samples. None for smooth curves."""
    strokes: str
    """How components were sampled: "together"; "cut" where they touch or cross, so that components
    are what is left of them; or "apart", each as if it were alone."""

    def __len__(self) -> int:
        return len(self.points)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.points, dtype=dtype, copy=copy)

    def __repr__(self) -> str:
        return f"<{len(self)} Samples>"


def sample(
    curve: Curve,
    *,
    rho: float | None = None,
    epsilon: float | None = None,
    max_distance: float | None = None,
    count: str = "greedy",
    strokes: str = "auto",
    threads: int | None = None,
    progress: bool = False,
) -> Samples:
    """Sample a curve as sparsely as it can be reconstructed from.

    Parameters
    ----------
    curve : Curve
        Curves that do not cross or touch themselves.
    rho : float, optional
        Every point is nearer to a sample than rho times the reach of its interval, the smallest
        local feature size there (SGP 2016, Definition 3). 0.9 if neither this nor epsilon is given.
    epsilon : float, optional
        Every point is nearer to a sample than epsilon times its local feature size.
    max_distance : float, optional
        The curve stays this near to the polygon of the samples.
    count : {"greedy", "fewest", "verified"}
        "greedy" takes the next sample as late as the condition allows; "fewest" has the fewest of
        all samples at dense points that satisfy it; "verified" takes away more, as long as
        HNN-Crust returns the polygon, which it does not where a corner is sharp. Corners are
        samples; between two of them "greedy" and "fewest" are the same.
    strokes : {"auto", "together", "cut", "apart"}
        "together" refuses curves that touch or cross. "cut" cuts them there: one runs through the
        place, which is a sample, the others end a hundredth of the extent short of it. "apart"
        samples each as if it were alone, and promises no reconstruction of all together. "auto"
        does the first of these that goes.
    threads, progress
        As for `reconstruct`.

    Raises
    ------
    ValueError
        For a bound out of range, and curves that cross or touch themselves: it says where.

    Examples
    --------
    >>> import curvecrust
    >>> circle = curvecrust.Curve.from_path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")
    >>> curvecrust.sample(circle, rho=0.9)
    <4 Samples>
    """
    asked = _asked(0.9 if rho is None and epsilon is None else rho, epsilon, max_distance)
    asked.update(count=count, strokes=strokes, threads=threads)
    with listening(progress, "sampling") as listener:
        return Samples(**_curvecrust.sample(_curve(curve), asked, listener))


@dataclass(frozen=True, eq=False)
class Check:
    """What samples of a curve attain."""

    epsilon: tuple[float, float] | None
    """The smallest epsilon for which they are an epsilon-sample, and a bound on it."""
    rho: tuple[float, float] | None
    """The smallest rho for which they are a rho-sample, and a bound on it."""
    holds: bool | None
    """Whether the condition holds at all dense points; None if none was given."""
    certain: bool | None
    """Whether it is certain to hold everywhere."""
    order: Ints
    """The rows of the samples in the order of the curve; that of one at a corner is there twice."""
    between: Ints
    """For each violation the rows of the samples around it, -1 where there is none."""
    at: Floats
    """For each violation the worst place."""
    values: Floats
    """For each violation the epsilon or rho there."""


def check(
    curve: Curve,
    samples: Any,
    *,
    rho: float | None = None,
    epsilon: float | None = None,
    max_distance: float | None = None,
    tolerance: float = 1e-3,
) -> Check:
    """Measure how good samples of a curve are.

    At a corner the local feature size is 0, so that nothing holds beside one that is no sample.
    Beside one that is, it is that of the smooth pieces. Strokes that touch are cut, as by `sample`.

    Parameters
    ----------
    curve : Curve
        Curves with or without corners.
    samples : array_like of shape (n, 2)
        Points on the curve, in any order.
    rho, epsilon, max_distance
        The condition to check, as for `sample`; none need be given.
    tolerance : float
        How far a sample may be from the curve, as a share of its extent.

    Examples
    --------
    >>> import curvecrust
    >>> circle = curvecrust.Curve.from_path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")
    >>> found = curvecrust.check(circle, [(1, 0), (0, 1), (-1, 0), (0, -1)], rho=0.9)
    >>> found.holds, round(found.rho[0], 3)
    (True, 0.765)
    """
    asked = _asked(rho, epsilon, max_distance)
    array = as_points(samples, "samples")
    return Check(**_curvecrust.check(_curve(curve), array, asked, tolerance * curve.extent))


@dataclass(frozen=True, eq=False)
class Lfs:
    """The local feature size along a curve."""

    points: Floats
    """Dense points of the curve, in order, of shape (n, 2)."""
    lfs: Floats
    """The distance of each to the medial axis; 0 at corners."""


def lfs(curve: Curve) -> Lfs:
    """Measure the local feature size of a curve: the distance of its points to its medial axis."""
    return Lfs(**_curvecrust.lfs(_curve(curve)))


@dataclass(frozen=True, eq=False)
class MedialAxis:
    """The points with two or more nearest points on a curve, as line segments."""

    starts: Floats
    """One end of each segment, of shape (m, 2)."""
    ends: Floats
    """The other end of each segment, of shape (m, 2)."""
    radii: Floats
    """The distance to the curve at both ends, of shape (m, 2)."""
    sites: Ints
    """Which two dense points each segment is equidistant from, of shape (m, 2)."""
    points: Floats
    """The dense points of the curve, of shape (n, 2)."""


def medial_axis(curve: Curve) -> MedialAxis:
    """Compute the medial axis of a curve, from the Voronoi diagram of dense points.

    Into every corner goes a branch. Strokes that touch are cut, as by `sample`.
    """
    return MedialAxis(**_curvecrust.medial_axis(_curve(curve)))


def _curve(curve: Curve) -> _curvecrust.Curve:
    if not isinstance(curve, Curve):
        raise TypeError(f"curve must be a Curve, not {type(curve).__name__}")
    return curve._curve


def _asked(rho: float | None, epsilon: float | None, max_distance: float | None) -> dict[str, Any]:
    if rho is not None and epsilon is not None:
        raise ValueError("give either rho or epsilon")
    values = {"rho": rho, "epsilon": epsilon, "max_distance": max_distance}
    return {
        **{name: None if value is None else float(value) for name, value in values.items()},
        "count": "greedy",
        "strokes": "auto",
        "threads": None,
    }
