"""The steps of `curvecrust.tiles`: each reads files, works on arrays, and writes files."""

from __future__ import annotations

import contextlib
import functools
import io
import json
import posixpath
import uuid
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import fsspec
import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from . import _curvecrust

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from numpy.typing import NDArray

#: Samples that are read at once when another tile is asked.
RUN = 2048
#: Bytes of a sample: its id, x and y.
SAMPLE = 24
#: How many points for each tile the cuts between tiles are made from.
SPREAD = 1024
#: The column that says where a row goes.
GOES_TO = "goes_to"

#: What the frames hold that an engine moves.
ROWS = {"id": "i8", "x": "f8", "y": "f8", GOES_TO: "i8"}
PAIRS = {"a": "i8", "b": "i8", "claim": "?", GOES_TO: "i8"}

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


@dataclass(frozen=True)
class Plan:
    """The pieces of the source, and how the plane is cut into tiles."""

    pieces: tuple[Piece, ...]
    axes: NDArray[np.uint8]
    at: NDArray[np.float64]
    cells: NDArray[np.float64]


@dataclass(frozen=True)
class Job:
    """What each task gets: its size does not grow with the points."""

    source: str
    target: str
    columns: tuple[str, str]
    method: str
    options: dict[str, Any]
    points: int = 0
    run: str = field(default_factory=lambda: uuid.uuid4().hex)

    def file_system(self) -> tuple[Any, str]:
        """Find the file system of the target, and the path of the target there."""
        found: tuple[Any, str] = fsspec.core.url_to_fs(self.target, **self.options)
        return found

    def work(self, name: str) -> str:
        """Name a file that is there during the run."""
        return posixpath.join(self.file_system()[1], f"_work-{self.run}", name)

    def put(self, name: str, data: bytes | memoryview) -> None:
        """Write a file of the run, completely or not at all."""
        fs, path = self.file_system()[0], self.work(name)
        part = f"{path}.{uuid.uuid4().hex}"
        with fs.open(part, "wb") as out:
            out.write(data)
        fs.mv(part, path)

    def get(self, name: str) -> bytes:
        """Read a file of the run."""
        data: bytes = self.file_system()[0].cat_file(self.work(name))
        return data


_plans: dict[str, Plan] = {}


def put_plan(job: Job, plan: Plan) -> None:
    """Write the plan for all tasks."""
    out = io.BytesIO()
    np.savez(out, axes=plan.axes, at=plan.at, cells=plan.cells)
    job.put("cuts", out.getvalue())
    pieces = [
        (piece.file.path, piece.file.rows, piece.groups.start, piece.groups.stop, piece.start)
        for piece in plan.pieces
    ]
    job.put("pieces", json.dumps(pieces).encode())


def plan_of(job: Job) -> Plan:
    """Read the plan, once for each worker."""
    if job.run not in _plans:
        cuts = np.load(io.BytesIO(job.get("cuts")))
        pieces = tuple(
            Piece(File(path, tuple(rows)), range(first, end), start)
            for path, rows, first, end, start in json.loads(job.get("pieces"))
        )
        _plans.clear()
        _plans[job.run] = Plan(pieces, cuts["axes"], cuts["at"], cuts["cells"])
    return _plans[job.run]


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


def place_of(job: Job, sample: int) -> str:
    """Name the row of a sample."""
    pieces = plan_of(job).pieces
    starts = [piece.start for piece in pieces]
    piece = pieces[int(np.searchsorted(starts, sample, side="right")) - 1]
    return place(piece, sample - piece.start)


def read(job: Job, piece: Piece) -> NDArray[np.float64]:
    """Read the points of a piece."""
    fs, _ = fsspec.core.url_to_fs(job.source, **job.options)
    with fs.open(piece.file.path, "rb") as file:
        table = pq.ParquetFile(file).read_row_groups(list(piece.groups), columns=[*job.columns])
    both = [table.column(name).to_numpy().astype(np.float64) for name in job.columns]
    points = np.stack(both, axis=1)
    bad = np.flatnonzero(~np.isfinite(points).all(axis=1))
    if len(bad):
        x, y = points[bad[0]]
        raise ValueError(f"{place(piece, int(bad[0]))} is ({x}, {y}): coordinates must be finite")
    return points


def spread(job: Job, step: int, piece: Piece) -> NDArray[np.float64]:
    """Read every step-th point of all."""
    return read(job, piece)[-piece.start % step :: step]


def rows(job: Job, piece: Piece) -> pd.DataFrame:
    """Read points with their ids and their tiles."""
    points = read(job, piece)
    plan = plan_of(job)
    found = _curvecrust.tiles_of(plan.axes, plan.at, points)
    ids = np.arange(piece.start, piece.start + len(points))
    tiles = found["cells"].astype(np.int64)
    return pd.DataFrame({"id": ids, "x": points[:, 0], "y": points[:, 1], GOES_TO: tiles})


def solve(job: Job, frame: pd.DataFrame, tile: int) -> int:
    """Find what one tile decides, and write it; return how many samples it leaves open."""
    samples = np.empty((len(frame), 3), np.uint64)
    samples[:, 0] = frame["id"]
    for column, name in enumerate("xy", start=1):
        samples[:, column] = np.ascontiguousarray(frame[name]).view(np.uint64)
    cell = list(plan_of(job).cells[tile])
    try:
        found = _curvecrust.tiles_solve(samples, cell, job.method, RUN)
    except ValueError as error:
        twins = frame[frame.duplicated(["x", "y"], keep=False)].sort_values(["x", "y", "id"])
        if twins.empty:
            raise
        first, second = (place_of(job, int(sample)) for sample in twins["id"][:2])
        raise ValueError(f"{first} and {second}: {error}") from None
    for kind in ("samples", "runs", "edges", "claims", "open"):
        job.put(f"{kind}-{tile}", found[kind].tobytes())
    return len(found["open"]) // 10


def gather(job: Job, tiles: int) -> None:
    """Write the areas of the runs of all tiles, and the number of the first run of each tile."""
    areas = [np.frombuffer(job.get(f"runs-{tile}")).reshape(-1, 4) for tile in range(tiles)]
    first = np.concatenate([[0], np.cumsum([len(area) for area in areas])]).astype(np.int64)
    out = io.BytesIO()
    np.savez(out, areas=np.concatenate(areas), first=first)
    job.put("atlas", out.getvalue())


def ask(job: Job, tile: int) -> int:
    """Answer the open samples of a tile from the samples of all; return how many claims follow."""
    atlas = np.load(io.BytesIO(job.get("atlas")))
    areas, first = atlas["areas"], atlas["first"]
    fs = job.file_system()[0]

    @functools.lru_cache(maxsize=1024)
    def run(number: int) -> NDArray[np.uint64]:
        other = int(np.searchsorted(first, number, side="right")) - 1
        start = (number - int(first[other])) * RUN * SAMPLE
        name = job.work(f"samples-{other}")
        data = fs.cat_file(name, start=start, end=start + RUN * SAMPLE)
        return np.frombuffer(data, np.uint64).reshape(-1, 3)

    samples = np.frombuffer(job.get(f"open-{tile}"), np.uint64).reshape(-1, 10)
    cell = list(plan_of(job).cells[tile])
    found = _curvecrust.tiles_ask(samples, cell, job.method, areas, run)
    job.put(f"answers-{tile}", found["claims"].tobytes())
    return len(found["claims"])


def pairs(job: Job, parts: int, item: tuple[int, bool]) -> pd.DataFrame:
    """Read the edges and the claims of a tile, each with the part of the result that it is for."""
    tile, answered = item
    kinds = [("edges", False), ("claims", True), *([("answers", True)] if answered else [])]
    both = [np.frombuffer(job.get(f"{kind}-{tile}"), np.int64).reshape(-1, 2) for kind, _ in kinds]
    lengths = [len(pairs) for pairs in both]
    ends = np.concatenate(both)
    claim = np.repeat([is_claim for _, is_claim in kinds], lengths)
    smaller = np.minimum(ends[:, 0], ends[:, 1])
    part = smaller * parts // max(1, job.points)
    return pd.DataFrame({"a": ends[:, 0], "b": ends[:, 1], "claim": claim, GOES_TO: part})


def finish(job: Job, frame: pd.DataFrame, part: int) -> int:
    """Join the claims of a part, and write its edges, ascending; return how many there are."""
    ends = np.stack([frame[name].to_numpy(np.uint64) for name in "ab"], axis=1)
    claim = frame["claim"].to_numpy(bool)
    edges = _curvecrust.tiles_join(ends[~claim], ends[claim], job.method)
    out = io.BytesIO()
    pq.write_table(pa.table({"a": edges["a"], "b": edges["b"]}), out, use_dictionary=False)
    job.put(f"part-{part:05}.parquet", out.getbuffer())
    return len(edges["a"])


def deliver(job: Job, parts: int) -> None:
    """Move the finished result to its place."""
    fs, target = job.file_system()
    for part in range(parts):
        name = f"part-{part:05}.parquet"
        fs.mv(job.work(name), posixpath.join(target, name))


def begin(job: Job) -> None:
    """Make the folder of the result; one that holds a result, or anything else, is refused."""
    fs, target = job.file_system()
    if fs.exists(target):
        names = [posixpath.basename(path.rstrip("/")) for path in fs.ls(target, detail=False)]
        if not all(name.startswith("_work-") for name in names):
            raise FileExistsError(f"{job.target} is there and not empty")
    fs.makedirs(job.work(""), exist_ok=True)


def clean(job: Job) -> None:
    """Remove what the run has left; tasks that still go on after an error may leave some."""
    with contextlib.suppress(OSError):
        job.file_system()[0].rm(job.work("").rstrip("/"), recursive=True)
