"""Methods against the truth and against each other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _curvecrust
from ._curve import Curve, _curve, sample
from ._methods import methods as all_methods
from ._points import as_points
from ._progress import listening
from ._reconstruct import reconstruct
from ._reconstruction import Reconstruction

Ints = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Evaluation:
    """Edges beside those between consecutive samples of a curve."""

    metrics: dict[str, float]
    """What was measured, by name: "exact" is 1 where all edges are right; distances are in the
    unit of the curve."""
    missing: Ints
    """True edges that were not found, of shape (k, 2)."""
    wrong: Ints
    """Edges that were found and are not true, of shape (k, 2)."""


def evaluate(
    curve: Curve, samples: Any, edges: Any = None, *, tolerance: float = 1e-3
) -> Evaluation:
    """Compare edges between samples of a smooth curve with the true ones.

    Parameters
    ----------
    curve : Curve
        A curve without corners.
    samples : array_like of shape (n, 2)
        Points on the curve, in any order.
    edges : Reconstruction or array_like of shape (m, 2), optional
        What was found; by default what `reconstruct` finds.
    tolerance : float
        How far a sample may be from the curve, as a share of its extent.

    Examples
    --------
    >>> import curvecrust
    >>> circle = curvecrust.Curve.from_path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")
    >>> samples = curvecrust.sample(circle, rho=0.5)
    >>> curvecrust.evaluate(circle, samples).metrics["exact"]
    1.0
    """
    array = as_points(samples, "samples")
    if edges is None:
        edges = reconstruct(array)
    if isinstance(edges, Reconstruction):
        edges = edges.edges
    rows = np.asarray(edges, dtype=np.int64).reshape(-1, 2)
    distance = tolerance * curve.extent
    return Evaluation(**_curvecrust.evaluate(_curve(curve), array, rows, distance))


def compare(
    points_or_curve: Any,
    *,
    methods: Iterable[str] | None = None,
    rho: float = 0.9,
    progress: bool = False,
) -> list[dict[str, Any]]:
    """Run several methods on the same points.

    Parameters
    ----------
    points_or_curve : array_like of shape (n, 2), or Curve
        Of a curve without corners, samples for `rho` are taken, and the truth is known: the records
        have what `evaluate` measures too.
    methods : iterable of str, optional
        Some of `methods()`; all by default.
    rho : float
        The condition that the curve is sampled for.
    progress : bool
        Whether to show a bar, if tqdm is installed.

    Returns
    -------
    list of dict
        A record for each method, of which pandas makes a data frame: its name, the seconds it took,
        the numbers of edges, of closed and of open curves, of isolated points and of junctions.
    """
    names = [method.name for method in all_methods()] if methods is None else list(methods)
    curve = points_or_curve if isinstance(points_or_curve, Curve) else None
    points = sample(curve, rho=rho).points if curve else as_points(points_or_curve)
    records = []
    with listening(progress, "comparing") as listener:
        for number, name in enumerate(names):
            if listener:
                listener(number, len(names))
            start = perf_counter()
            found = reconstruct(points, method=name)
            record: dict[str, Any] = {
                "method": name,
                "seconds": perf_counter() - start,
                "edges": len(found.edges),
                "closed": int(found.closed.sum()),
                "open": int((~found.closed).sum()),
                "isolated": len(found.isolated),
                "junctions": len(found.junctions),
            }
            if curve:
                record.update(evaluate(curve, points, found).metrics)
            records.append(record)
    return records
