"""The points of a run: Parquet files, in pieces that one task reads."""

from __future__ import annotations

import posixpath
from dataclasses import dataclass
from typing import TYPE_CHECKING

import fsspec
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

    from ._tile_job import Job

#: The columns of x and y, where none are named.
NAMES = [
    ("x", "y"),
    ("X", "Y"),
    ("lon", "lat"),
    ("longitude", "latitude"),
    ("easting", "northing"),
]


@dataclass(frozen=True)
class File:
    """A Parquet file of points, and the rows of each of its row groups."""

    path: str
    rows: tuple[int, ...]


@dataclass(frozen=True)
class Piece:
    """Row groups in a row of one file, and the id of their first row."""

    file: File
    groups: range
    start: int

    @property
    def rows(self) -> int:
        """How many rows they have."""
        return sum(self.file.rows[group] for group in self.groups)


def files(job: Job) -> list[str]:
    """Find the files of the source, sorted by their paths."""
    fs, path = fsspec.core.url_to_fs(job.source, **job.options)
    if fs.isdir(path):
        path = posixpath.join(path, "**/*.parquet")
    found: list[str] = sorted(fs.glob(path))
    if not found:
        raise FileNotFoundError(f"there is no Parquet file in {job.source}")
    return found


def survey(job: Job, path: str) -> File:
    """Read how many rows a file has, and whether it has the columns."""
    fs, _ = fsspec.core.url_to_fs(job.source, **job.options)
    with fs.open(path, "rb") as file:
        try:
            parquet = pq.ParquetFile(file)
        except pa.ArrowInvalid as error:
            raise ValueError(f"{path}: {error}") from None
        for name in job.columns:
            if name not in parquet.schema_arrow.names:
                raise ValueError(f"{path} has no column {name!r}")
            kind = parquet.schema_arrow.field(name).type
            if not (pa.types.is_floating(kind) or pa.types.is_integer(kind)):
                raise ValueError(f"{path}: the column {name!r} is of type {kind}, not of numbers")
        meta = parquet.metadata
        return File(path, tuple(meta.row_group(i).num_rows for i in range(meta.num_row_groups)))


def columns(job: Job, path: str, x: str | None, y: str | None) -> tuple[str, str]:
    """Find the columns of x and y in the first file."""
    if x is not None and y is not None:
        return x, y
    fs, _ = fsspec.core.url_to_fs(job.source, **job.options)
    with fs.open(path, "rb") as file:
        names = pq.read_schema(file).names
    for pair in NAMES:
        found = (x or pair[0], y or pair[1])
        if set(found) <= set(names):
            return found
    raise ValueError(f"{path} has no columns x and y, but {', '.join(names)}: name them")


def pieces(found: Sequence[File], most: int) -> Iterator[Piece]:
    """Cut files into pieces of at most this many rows, where their row groups allow it."""
    start = 0
    for file in found:
        first, rows = 0, 0
        for group, count in enumerate(file.rows):
            if rows and rows + count > most:
                yield Piece(file, range(first, group), start - rows)
                first, rows = group, 0
            rows += count
            start += count
        if rows:
            yield Piece(file, range(first, len(file.rows)), start - rows)


def place(piece: Piece, row: int) -> str:
    """Name a row of a piece."""
    for group in piece.groups:
        if row < piece.file.rows[group]:
            return f"{piece.file.path}, row group {group}, row {row}"
        row -= piece.file.rows[group]
    return piece.file.path


def read(job: Job, piece: Piece) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Read the coordinates of a piece: x and y."""
    fs, _ = fsspec.core.url_to_fs(job.source, **job.options)
    with fs.open(piece.file.path, "rb") as file:
        table = pq.ParquetFile(file).read_row_groups(list(piece.groups), columns=[*job.columns])
    x, y = (table.column(name).to_numpy().astype(np.float64, copy=False) for name in job.columns)
    good = np.isfinite(x) & np.isfinite(y)
    if not good.all():
        row = int(good.argmin())
        where = place(piece, row)
        raise ValueError(f"{where} is ({x[row]}, {y[row]}): coordinates must be finite")
    return x, y
