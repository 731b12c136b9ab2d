"""Points to curves."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _curvecrust
from ._points import as_count, as_points
from ._progress import listening
from ._reconstruction import Reconstruction


def reconstruct(
    points: Any,
    *,
    method: str = "least-detour",
    closed: bool | None = None,
    curves: int | None = None,
    termini: Iterable[int] | None = None,
    merge_within: float | None = None,
    threads: int | None = None,
    progress: bool = False,
) -> Reconstruction:
    """Order points into the curves that they come from, open and closed.

    No parameter is needed. If you know whether curves are closed, or how many there are, the
    result agrees with that.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        The points in any order; also points of shapely or geopandas, or complex numbers of shape
        (n,). They are not copied if they are an array of float64: do not change it afterwards.
    method : str
        One of `methods()`. "least-detour" is the default and of this project (docs/method.md);
        "hnn-crust" is the fastest, and proven for dense samples (docs/theory.md).
    closed : bool, optional
        Whether all curves are closed, or all are open.
    curves : int, optional
        How many curves there are. They then go through all points.
    termini : iterable of int, optional
        Rows of points that are ends of open curves.
    merge_within : float, optional
        A length within which points count as one; 0 for equal points alone. Without it equal
        points are an error.
    threads : int, optional
        How many threads to use; all processors by default. The result is the same.
    progress : bool
        Whether to show a bar, if tqdm is installed.

    Returns
    -------
    Reconstruction
        Its `paths` are the curves.

    Raises
    ------
    ValueError
        For coordinates that are not finite, and equal points: it names the rows. Also for a method
        that does not exist or cannot use the options.
    TypeError
        For points that are no numbers.

    Examples
    --------
    >>> import numpy as np, curvecrust
    >>> angles = np.random.default_rng(1).permutation(12) * np.pi / 6
    >>> found = curvecrust.reconstruct(np.exp(1j * angles))
    >>> found
    <Reconstruction of 12 points: 1 closed curve>
    >>> steps = np.diff(angles[found.paths[0].indices]) % (2 * np.pi)
    >>> bool(np.allclose(steps, np.pi / 6))
    True
    """
    arguments = {
        "method": _text(method, "method"),
        "closed": None if closed is None else bool(closed),
        "curves": None if curves is None else as_count(curves, "curves", 1),
        "termini": [as_count(row, "termini", 0) for row in (() if termini is None else termini)],
        "merge_within": None if merge_within is None else float(merge_within),
        "threads": None if threads is None else as_count(threads, "threads", 1),
    }
    array = as_points(points)
    with listening(progress, "reconstructing") as listener:
        found = _curvecrust.reconstruct(array, arguments, listener)
    return Reconstruction(array, arguments, found)


def order(points: Any, *, closed: bool | None = None) -> NDArray[np.int64]:
    """Sort points along the one curve that goes through all of them.

    Parameters
    ----------
    points : array_like of shape (n, 2)
        As for `reconstruct`; no two may be equal.
    closed : bool, optional
        Whether the curve is closed. If it is not said, the points decide.

    Returns
    -------
    numpy.ndarray of shape (n,), dtype int64
        Every row of the points once, so that `points[order(points)]` is the curve. A closed curve
        runs counter-clockwise (where y points up) and does not repeat its first row.

    Raises
    ------
    ValueError, TypeError
        As `reconstruct` does, and for fewer points than such a curve needs: a closed one needs
        three that are not on a line.

    Examples
    --------
    >>> import curvecrust
    >>> curvecrust.order([(4, 1), (0, 0), (7, 3), (2, 0)], closed=False)
    array([1, 3, 0, 2])
    """
    array = as_points(points)
    if len(array) < 2 and not closed:
        reconstruct(array)  # Says what is wrong with the point.
        return np.arange(len(array), dtype=np.int64)
    return reconstruct(array, closed=closed, curves=1).indices


def find_curve_path(points: Any) -> list[list[int]]:
    """Return curves as lists of rows, as FindCurvePath of the Wolfram Language does.

    A closed curve repeats its first row at the end. Rows count from 0. Points on no curve are in no
    list.

    Examples
    --------
    >>> import curvecrust
    >>> curvecrust.find_curve_path([(0, 0), (1, 1), (1, 0), (0, 1)])
    [[0, 2, 1, 3, 0]]
    """
    paths = reconstruct(points).paths
    rows = [path.indices.tolist() for path in paths]
    return [row + row[:1] if path.closed else row for row, path in zip(rows, paths, strict=True)]


def _text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}")
    return value
