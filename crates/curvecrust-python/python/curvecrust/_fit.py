"""Smooth curves of points that scatter about them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _curvecrust
from ._points import as_count, as_points

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class FittedCurve:
    """A smooth curve of cubic Béziers, and how sure it is."""

    cubics: Floats
    """The control points, of shape (k, 4, 2). Each cubic starts where the last one ends."""
    closed: bool
    """Whether the last cubic ends where the first starts. A closed curve runs counter-clockwise
    where y points up."""
    corners: Ints
    """The position in `cubics` of each cubic that starts at a corner, ascending. Everywhere else
    the curve is smooth. None for clean points, where straight pieces meet at every joint."""
    count: int
    """How many points belong to it."""
    sigma: Floats
    """The standard deviation of the points from the curve at each joint, of shape (k + 1,)."""
    standard_error: Floats
    """The standard error of the curve across its direction at each joint, of shape (k + 1,)."""

    def points(self, tolerance: float) -> Floats:
        """Return places along the curve, of shape (m, 2).

        Their polyline is nowhere farther from the curve than `tolerance`, a length above 0. A
        closed curve does not repeat its first place.
        """
        if not tolerance > 0:
            raise ValueError(f"tolerance must be a length above 0, not {tolerance!r}")
        controls = self.cubics.reshape(-1, 2)
        found: Floats = _curvecrust.polyline(controls, self.closed, float(tolerance))["points"]
        return found

    def __repr__(self) -> str:
        kind = "closed" if self.closed else "open"
        return f"<{kind} FittedCurve of {self.count} points>"


class Fit:
    """Curves that points scatter about, and where each point belongs."""

    def __init__(self, points: Floats, found: dict[str, Any]) -> None:
        self._points = points
        self._found = found

    @property
    def points(self) -> Floats:
        """The points that were given, of shape (n, 2)."""
        return self._points

    @cached_property
    def curves(self) -> list[FittedCurve]:
        """The curves, those with the most points first; none if the points form no curve."""
        found = self._found
        cubics = found["controls"].reshape(-1, 4, 2)
        offsets = found["offsets"].tolist()
        curves = []
        for k, (start, end) in enumerate(pairwise(offsets)):
            # Each curve has one joint more than cubics.
            joints = slice(start + k, end + k + 1)
            curves.append(
                FittedCurve(
                    cubics=cubics[start:end],
                    closed=bool(found["closed"][k]),
                    corners=np.flatnonzero(found["at_corner"][start:end]),
                    count=int(found["counts"][k]),
                    sigma=found["sigmas"][joints],
                    standard_error=found["standard_errors"][joints],
                )
            )
        return curves

    @property
    def sigma(self) -> float:
        """How far points deviate from their curves, as a root mean square; 0 if they are clean."""
        return float(self._found["sigma"])

    @property
    def clean(self) -> bool:
        """Whether the points that are no outliers lie on their curves.

        These are then straight between them: `reconstruct` is for such points.
        """
        return bool(self._found["clean"])

    @property
    def edges(self) -> Ints:
        """The edges between clean points, of shape (m, 2); none if the points scatter."""
        found: Ints = self._found["edges"]
        return found

    @property
    def curve_of(self) -> Ints:
        """For each point the place of its curve in `curves`, -1 for an outlier; shape (n,)."""
        found: Ints = self._found["curve_of"]
        return found

    @property
    def parameters(self) -> Floats:
        """For each point where it belongs: the cubic, and from 0 to 1 the place on it.

        It is nan for an outlier. Sorted by them, the points of a curve are in order along it.
        """
        found: Floats = self._found["parameters"]
        return found

    @property
    def distances(self) -> Floats:
        """How far each point is from its curve, nan for an outlier; shape (n,)."""
        found: Floats = self._found["distances"]
        return found

    @property
    def outliers(self) -> Ints:
        """The rows of the points that belong to no curve, ascending."""
        return np.flatnonzero(self.curve_of < 0)

    def __repr__(self) -> str:
        closed = sum(curve.closed for curve in self.curves)
        opened = len(self.curves) - closed
        return (
            f"<Fit of {len(self.points)} points: {closed} closed and {opened} open, "
            f"{len(self.outliers)} outliers>"
        )


def fit(
    points: Any,
    *,
    closed: bool | None = None,
    curves: int | None = None,
    sigma: float | None = None,
    merge_within: float | None = None,
    threads: int | None = None,
) -> Fit:
    """Fit smooth curves to points that scatter about them, some of which belong to none.

    Nothing has to be known: how far points scatter, which are outliers and how many curves there
    are is found. Points that do not scatter are joined as by `reconstruct`.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        As for `reconstruct`.
    closed : bool, optional
        Whether all curves are closed, or all are open.
    curves : int, optional
        How many curves there are.
    sigma : float, optional
        The standard deviation of the points from their curves, as a length; 0 if they lie on them.
    merge_within : float, optional
        A length within which points count as one; 0 for equal points alone. Without it equal
        points are an error.
    threads : int, optional
        How many threads to use; all processors by default. The result is the same.

    Returns
    -------
    Fit
        Its `curves` are cubic Béziers.

    Raises
    ------
    ValueError, TypeError
        As `reconstruct` does, and for a deviation that is no length.

    Examples
    --------
    >>> import numpy as np, curvecrust
    >>> random = np.random.default_rng(2)
    >>> angles = random.uniform(0, 2 * np.pi, 400)
    >>> circle = np.c_[np.cos(angles), np.sin(angles)]
    >>> found = curvecrust.fit(circle + 0.05 * random.normal(size=(400, 2)))
    >>> [curve.closed for curve in found.curves]
    [True]
    >>> radius = np.hypot(*found.curves[0].points(1e-3).T)
    >>> bool(abs(radius - 1).max() < 0.05 and abs(found.sigma - 0.05) < 0.01)
    True
    """
    arguments = {
        "closed": None if closed is None else bool(closed),
        "curves": None if curves is None else as_count(curves, "curves", 1),
        "sigma": None if sigma is None else float(sigma),
        "merge_within": None if merge_within is None else float(merge_within),
        "threads": None if threads is None else as_count(threads, "threads", 1),
    }
    array = as_points(points)
    return Fit(array, _curvecrust.fit(array, arguments))
