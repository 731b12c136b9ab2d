"""Curves through more points than one machine holds, on a cluster of Dask.

``curvecrust.distributed.reconstruct("s3://maps/points", "s3://maps/edges")`` reads Parquet files of
points and writes Parquet files of edges, exactly those of all points at once. Dask runs the tasks,
watches the workers, and runs again what a lost one had begun. A run that was stopped goes on where
it was if it is called again. `curvecrust.tiles` has the steps.
"""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import distributed

from . import tiles
from .tiles import Result, edges

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

__all__ = ["Result", "edges", "reconstruct"]


def reconstruct(
    source: str,
    target: str,
    *,
    method: str = "hnn-crust",
    x: str | None = None,
    y: str | None = None,
    client: distributed.Client | None = None,
    tile_points: int = 5_000_000,
    storage_options: dict[str, Any] | None = None,
) -> Result:
    """Find the edges between points in Parquet files, and write them to Parquet files.

    Parameters
    ----------
    source
        A folder or bucket of Parquet files, one file, or a pattern; an address of fsspec.
    target
        A folder or bucket for the result. It is made; one that is not empty is refused.
    method
        "hnn-crust", "hnn-crust-union" or "nn-crust": those that are local enough.
    x, y
        The columns of the coordinates; by default x and y, X and Y, lon and lat, longitude and
        latitude, or easting and northing.
    client
        The client of a cluster of Dask; by default the current one, or a cluster on this machine
        for this call.
    tile_points
        About how many points one task has at once. A task takes some 200 bytes for each.
    storage_options
        What fsspec needs to know about the source and the target.

    Returns
    -------
    Result
        How much was found. The edges are in ``part-00000.parquet`` and so on, as columns ``a`` and
        ``b``: the numbers of their ends, which count the rows of the source, file by file in the
        order of their names. They ascend within the files and from file to file.

    Raises
    ------
    ValueError
        If two points are equal or a coordinate is not finite: file, row group and row are named.
        If a file has other columns, or is no Parquet file.
    FileExistsError
        If the target is there and not empty.
    FileNotFoundError
        If the source holds no file.
    """
    with _client(client) as cluster:
        return tiles.reconstruct(
            source,
            target,
            _Dask(cluster),
            method=method,
            x=x,
            y=y,
            tile_points=tile_points,
            storage_options=storage_options,
        )


@dataclass
class _Dask:
    cluster: distributed.Client

    def map(self, step: Callable[[Any], Any], items: Sequence[Any]) -> list[Any]:
        done: list[Any] = self.cluster.gather(self.cluster.map(step, list(items), pure=False))
        return done


@contextlib.contextmanager
def _client(client: distributed.Client | None) -> Iterator[distributed.Client]:
    if client is None:
        with contextlib.suppress(ValueError):
            client = distributed.get_client()
    if client is not None:
        yield client
        return
    with distributed.Client() as own:
        yield own
