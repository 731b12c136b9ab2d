"""The part of the package that is Rust: arrays in, arrays out."""

from collections.abc import Callable
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__version__: str

__all__ = [
    "Curve",
    "__version__",
    "check",
    "evaluate",
    "explain",
    "fit",
    "lfs",
    "medial_axis",
    "methods",
    "polyline",
    "reconstruct",
    "run",
    "sample",
    "tiles_ask",
    "tiles_cut",
    "tiles_join",
    "tiles_scatter",
    "tiles_solve",
    "violations",
]

@final
class Curve:
    """Curves that may have corners."""

    @staticmethod
    def from_svg(text: str, snap: float) -> Curve: ...
    @staticmethod
    def from_path(d: str) -> Curve: ...
    @staticmethod
    def from_points(points: NDArray[np.float64], closed: bool) -> Curve: ...
    @property
    def closed(self) -> list[bool]: ...
    @property
    def extent(self) -> float: ...
    def corners(self) -> dict[str, NDArray[np.float64]]: ...
    def polylines(self, per_segment: int) -> dict[str, Any]: ...

def reconstruct(
    points: NDArray[np.float64],
    arguments: dict[str, Any],
    progress: Callable[[int, int], None] | None,
) -> dict[str, Any]: ...
def explain(points: NDArray[np.float64], arguments: dict[str, Any]) -> dict[str, Any] | None: ...
def fit(points: NDArray[np.float64], arguments: dict[str, Any]) -> dict[str, Any]: ...
def polyline(controls: NDArray[np.float64], closed: bool, tolerance: float) -> dict[str, Any]: ...
def violations(points: NDArray[np.float64], edges: NDArray[np.int64]) -> dict[str, Any]: ...
def sample(
    curve: Curve, asked: dict[str, Any], progress: Callable[[int, int], None] | None
) -> dict[str, Any]: ...
def check(
    curve: Curve, samples: NDArray[np.float64], asked: dict[str, Any], tolerance: float
) -> dict[str, Any]: ...
def lfs(curve: Curve) -> dict[str, Any]: ...
def medial_axis(curve: Curve) -> dict[str, Any]: ...
def evaluate(
    curve: Curve,
    samples: NDArray[np.float64],
    edges: NDArray[np.int64],
    tolerance: float,
) -> dict[str, Any]: ...
def methods() -> list[dict[str, Any]]: ...
def run(args: list[str], again: list[str]) -> int: ...
def tiles_cut(points: NDArray[np.float64], cells: int) -> dict[str, Any]: ...
def tiles_scatter(
    axes: NDArray[np.uint8],
    at: NDArray[np.float64],
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    start: int,
) -> dict[str, Any]: ...
def tiles_solve(
    samples: NDArray[np.uint64], cell: list[float], method: str, run_length: int
) -> dict[str, Any]: ...
def tiles_ask(
    left: NDArray[np.uint64],
    cell: list[float],
    method: str,
    runs: NDArray[np.float64],
    read: Callable[[int], NDArray[np.uint64]],
) -> dict[str, Any]: ...
def tiles_join(
    edges: NDArray[np.uint64], claims: NDArray[np.uint64], method: str
) -> dict[str, Any]: ...
