"""Curves through more points than one machine holds, on any engine that runs functions on many.

The points are cut into tiles. Each is solved by itself, by a pure function; what its border leaves
open is asked of the samples of other tiles. The edges are exactly those of all points at once.

An `Engine` calls the steps, and calls them again where a worker was lost. The rows go from step to
step through files beside the result, each of which is there completely or not at all, and is the
same whoever writes it. So a run that was stopped goes on where it was.
`curvecrust.distributed` is that of Dask.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any, Protocol

import fsspec
import numpy as np
import pyarrow.parquet as pq

from . import _curvecrust
from . import _tile_source as source_files
from . import _tile_steps as steps
from ._tile_job import Job
from ._tile_steps import Plan

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from numpy.typing import NDArray

__all__ = ["Engine", "Result", "edges", "reconstruct"]


class Engine(Protocol):
    """What runs functions on many machines, all of which reach the source and the target."""

    def map(self, step: Callable[[Any], Any], items: Sequence[Any]) -> list[Any]:
        """Call a step for each item; return what it returns, in the order of the items.

        Steps and items can be pickled. A step may be called twice for an item, on one machine or on
        two at once; what it returns is small.
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
    found = source_files.files(job)
    job = replace(job, columns=source_files.columns(job, found[0], x, y))
    job = replace(job, run=steps.name_of_run(job, found, tile_points))
    job.begin()
    try:
        return _run(job, found, tile_points, engine)
    except ValueError:
        # The source has to change, and then this is of no use.
        job.clean()
        raise


def _run(job: Job, found: list[str], most: int, engine: Engine) -> Result:
    job, plan = _planned(job, found, most, engine)
    tiles, parts = len(plan.cells), max(1, -(-job.points // most))
    engine.map(partial(steps.scatter, job), range(len(plan.pieces)))
    left = engine.map(partial(steps.solve, job, parts), range(tiles))
    engine.map(partial(steps.gather, job), [tiles])
    engine.map(partial(steps.ask, job, parts), [tile for tile in range(tiles) if left[tile]])
    counts = engine.map(partial(steps.finish, job, parts, tiles), range(parts))
    job.deliver([steps.part_name(part) for part in range(parts)])
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


def _planned(job: Job, found: list[str], most: int, engine: Engine) -> tuple[Job, Plan]:
    """Cut the files into pieces, and the plane into tiles."""
    surveyed = engine.map(partial(source_files.survey, job), found)
    pieces = tuple(source_files.pieces(surveyed, most))
    job = replace(job, points=sum(piece.rows for piece in pieces))
    if job.has("pieces"):
        return job, steps.plan_of(job)
    cells = max(1, -(-job.points // most))
    every = max(1, job.points // (cells * steps.SPREAD))
    some = engine.map(partial(steps.spread, job, every), pieces)
    cuts = _curvecrust.tiles_cut(np.concatenate([np.zeros((0, 2)), *some]), cells)
    plan = Plan(pieces, cuts["axes"], cuts["at"], cuts["cells"].reshape(-1, 4))
    steps.put_plan(job, plan)
    return job, plan
