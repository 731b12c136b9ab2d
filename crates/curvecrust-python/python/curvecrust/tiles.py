"""Curves through more points than one machine holds, on any engine that runs functions on many.

The points are cut into tiles. Each is solved by itself, by a pure function; what its border leaves
open is asked of the samples of other tiles. The edges are exactly those of all points at once.

An `Engine` calls the steps, moves frames between them, and calls them again where a worker was
lost: every file is there completely or not at all, and is the same whoever writes it.
`curvecrust.distributed` is that of Dask.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

import fsspec
import numpy as np
import pandas as pd
import pyarrow.parquet as pq

from . import _curvecrust
from . import _tile_steps as steps
from ._tile_steps import Job, Plan

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

__all__ = ["Engine", "Result", "edges", "reconstruct"]


class Engine(Protocol):
    """What runs functions on many machines."""

    def map(self, step: Callable[[Any], Any], items: Sequence[Any]) -> list[Any]:
        """Call a step for each item; return what it returns, in the order of the items."""

    def exchange(
        self,
        load: Callable[[Any], pd.DataFrame],
        items: Sequence[Any],
        empty: pd.DataFrame,
        act: Callable[[pd.DataFrame, int], int],
        parts: int,
    ) -> list[int]:
        """Load a frame for each item, bring each row to its part, and act on each part.

        The column ``goes_to`` says to which part a row goes, from 0 on; a part may have no row.
        The order of the rows of a part does not matter. `empty` is a frame without rows.
        """


@dataclass(frozen=True)
class Result:
    """What a run has found.

    Attributes
    ----------
    points
        How many points there were.
    edges
        How many edges join them.
    tiles
        How many tiles the plane was cut into.
    open
        How many points had to ask other tiles.
    """

    points: int
    edges: int
    tiles: int
    open: int


def reconstruct(
    source: str,
    target: str,
    engine: Engine,
    *,
    method: str = "hnn-crust",
    x: str | None = None,
    y: str | None = None,
    tile_points: int = 5_000_000,
    storage_options: dict[str, Any] | None = None,
) -> Result:
    """Find the edges between points in Parquet files, and write them to Parquet files.

    As `curvecrust.distributed.reconstruct`, on an engine of yours.
    """
    if tile_points < 1:
        raise ValueError(f"tile_points is {tile_points}: a tile has at least one point")
    none = np.zeros((0, 2), np.uint64)
    # This refuses a method that is not local.
    _curvecrust.tiles_join(none, none, method)
    job = Job(source, target, ("x", "y"), method, storage_options or {})
    found = steps.files(job)
    job = replace(job, columns=steps.columns(job, found[0], x, y))
    steps.begin(job)
    try:
        return _run(job, found, tile_points, engine)
    finally:
        steps.clean(job)


def _run(job: Job, found: list[str], most: int, engine: Engine) -> Result:
    job, plan = _planned(job, found, most, engine)
    tiles, parts = len(plan.cells), max(1, -(-job.points // most))
    load, act = partial(steps.rows, job), partial(steps.solve, job)
    left = engine.exchange(load, plan.pieces, _empty(steps.ROWS), act, tiles)
    engine.map(partial(steps.gather, job), [tiles])
    engine.map(partial(steps.ask, job), [tile for tile in range(tiles) if left[tile]])
    items = [(tile, left[tile] > 0) for tile in range(tiles)]
    load, act = partial(steps.pairs, job, parts), partial(steps.finish, job)
    counts = engine.exchange(load, items, _empty(steps.PAIRS), act, parts)
    steps.deliver(job, parts)
    return Result(job.points, sum(counts), tiles, sum(left))


def edges(target: str, storage_options: dict[str, Any] | None = None) -> NDArray[np.uint64]:
    """Read the edges that were written, as rows of two ends, ascending: into memory."""
    fs, path = fsspec.core.url_to_fs(target, **(storage_options or {}))
    tables = []
    for name in sorted(fs.glob(f"{path}/part-*.parquet")):
        with fs.open(name, "rb") as file:
            tables.append(pq.read_table(file))
    both = [np.concatenate([table.column(name).to_numpy() for table in tables]) for name in "ab"]
    return np.stack(both, axis=1)


def _empty(columns: dict[str, str]) -> pd.DataFrame:
    return pd.DataFrame({name: pd.Series(dtype=kind) for name, kind in columns.items()})


def _planned(job: Job, found: list[str], most: int, engine: Engine) -> tuple[Job, Plan]:
    """Cut the files into pieces, and the plane into tiles."""
    surveyed = engine.map(partial(steps.survey, job), found)
    parts = tuple(steps.pieces(surveyed, most))
    job = replace(job, points=sum(piece.rows for piece in parts))
    cells = max(1, -(-job.points // most))
    every = max(1, job.points // (cells * steps.SPREAD))
    some = engine.map(partial(steps.spread, job, every), parts)
    cuts = _curvecrust.tiles_cut(np.concatenate([np.zeros((0, 2)), *some]), cells)
    plan = Plan(parts, cuts["axes"], cuts["at"], cuts["cells"].reshape(-1, 4))
    steps.put_plan(job, plan)
    return job, plan
