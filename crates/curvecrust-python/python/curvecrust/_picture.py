"""Pictures of curves."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._reconstruction import Reconstruction

CLOSED, OPEN, ALONE = "#1f77b4", "#d62728", "#888888"
WIDTH = 400.0
"""The larger side of the picture."""
MARGIN = 10.0
MOST_SHOWN, MOST_DOTS = 100_000, 2_000
"""A notebook shows no curves through more points than this, and no dots for more than that."""

Floats = NDArray[np.float64]


def svg(found: Reconstruction, *, points: bool) -> str:
    """Return a picture of the curves, and of the points if these are wanted."""
    place, (width, height) = _to_page(found.points)
    parts = []
    for path in found.paths:
        places = " ".join(f"{x:.2f},{y:.2f}" for x, y in place(path.points).tolist())
        shape, colour = ("polygon", CLOSED) if path.closed else ("polyline", OPEN)
        parts.append(
            f'<{shape} points="{places}" fill="none" stroke="{colour}" stroke-width="1.5"/>'
        )
    if points:
        alone = np.zeros(len(found.points), dtype=bool)
        alone[found.isolated] = True
        for (x, y), is_alone in zip(place(found.points).tolist(), alone.tolist(), strict=True):
            colour = ALONE if is_alone else "#000000"
            parts.append(f'<circle cx="{x:.2f}" cy="{y:.2f}" r="2" fill="{colour}"/>')
    body = "\n".join(parts)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.2f} {height:.2f}">\n'
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n{body}\n</svg>\n'
    )


def _to_page(
    points: Floats,
) -> tuple[Callable[[Floats], Floats], tuple[float, float]]:
    """Return what places points on the page, and the size of the page."""
    if not len(points):
        return lambda places: places, (2 * MARGIN, 2 * MARGIN)
    # Halves, since the extent of what is finite may not be.
    low, high = points.min(0) / 2, points.max(0) / 2
    largest = float((high - low).max())
    scale = (WIDTH - 2 * MARGIN) / largest if largest > 0 else 0.0
    width, height = ((high - low) * scale + 2 * MARGIN).tolist()

    def place(places: Floats) -> Floats:
        x, y = ((places / 2 - low) * scale + MARGIN).T
        return np.column_stack((x, height - y))

    return place, (width, height)


def plot(found: Reconstruction, ax: Axes | None) -> Axes:
    """Draw curves and points on axes."""
    import matplotlib.pyplot as plt
    from matplotlib.collections import LineCollection

    if ax is None:
        ax = plt.subplots()[1]
        ax.set_aspect("equal")
    for colour, closed in ((CLOSED, True), (OPEN, False)):
        curves = [path for path in found.paths if path.closed == closed]
        lines = [np.vstack((p.points, p.points[:1])) if closed else p.points for p in curves]
        label = "closed" if closed else "open"
        if lines:
            ax.add_collection(LineCollection(lines, colors=colour, label=label))
    ax.plot(*found.points.T, ".", color="black", markersize=3)
    if len(found.isolated):
        ax.plot(*found.points[found.isolated].T, ".", color=ALONE, label="isolated")
    ax.autoscale_view()
    return ax
