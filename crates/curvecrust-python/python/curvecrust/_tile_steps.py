"""The steps of `curvecrust.tiles`: each reads files, works on arrays, and writes files.

A step whose last file is there does nothing: a run that was stopped has done it.
"""

from __future__ import annotations

import functools
import hashlib
import io
import json
import posixpath
from dataclasses import dataclass
from typing import TYPE_CHECKING

import fsspec
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from . import _curvecrust
from ._tile_job import WORD, Job, bytes_of
from ._tile_source import File, Piece, place, read

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

#: Samples that are read at once when another tile is asked.
RUN = 2048
#: Words of a sample (its id, x and y), of an edge or claim, and of an open sample.
SAMPLE, PAIR, OPEN = 3, 2, 10
#: How many points for each tile the cuts between tiles are made from.
SPREAD = 1024
#: Which files of a run mean the same: to be changed with them.
FORM = 1


@dataclass(frozen=True)
class Plan:
    """The pieces of the source, and how the plane is cut into tiles."""

    pieces: tuple[Piece, ...]
    axes: NDArray[np.uint8]
    at: NDArray[np.float64]
    cells: NDArray[np.float64]


_plans: dict[str, Plan] = {}


def put_plan(job: Job, plan: Plan) -> None:
    """Write the plan for all tasks."""
    out = io.BytesIO()
    np.savez(out, axes=plan.axes, at=plan.at, cells=plan.cells)
    job.put("cuts", out.getbuffer())
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


def place_of(job: Job, sample: int) -> str:
    """Name the row of a sample."""
    pieces = plan_of(job).pieces
    starts = [piece.start for piece in pieces]
    piece = pieces[int(np.searchsorted(starts, sample, side="right")) - 1]
    return place(piece, sample - piece.start)


def name_of_run(job: Job, paths: Sequence[str], tile_points: int) -> str:
    """Name a run by all that its files depend on: the same call on the same source goes on."""
    fs, _ = fsspec.core.url_to_fs(job.source, **job.options)
    parts = [FORM, job.columns, job.method, tile_points, [(path, fs.ukey(path)) for path in paths]]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()[:32]


def spread(job: Job, step: int, piece: Piece) -> NDArray[np.float64]:
    """Read every step-th point of all."""
    x, y = read(job, piece)
    some = slice(-piece.start % step, None, step)
    return np.stack([x[some], y[some]], axis=1)


def scatter(job: Job, number: int) -> None:
    """Write the points of a piece with their ids, those of each tile together."""
    name = f"rows-{number}"
    if job.has(name):
        return
    plan = plan_of(job)
    piece = plan.pieces[number]
    found = _curvecrust.tiles_scatter(plan.axes, plan.at, *read(job, piece), piece.start)
    job.put_shares(name, found["samples"], found["first"])


def solve(job: Job, parts: int, tile: int) -> int:
    """Find what one tile decides, and write it; return how many samples it leaves open."""
    # The one that is written last.
    if not job.has(f"open-{tile}"):
        _solve(job, parts, tile)
    return job.size(f"open-{tile}") // (OPEN * WORD)


def _solve(job: Job, parts: int, tile: int) -> None:
    plan = plan_of(job)
    tiles, pieces = len(plan.cells), range(len(plan.pieces))
    shares = [job.share(f"rows-{piece}", tiles, tile, SAMPLE) for piece in pieces]
    samples = np.concatenate([np.zeros((0, SAMPLE), np.uint64), *shares])
    del shares
    try:
        found = _curvecrust.tiles_solve(samples, list(plan.cells[tile]), job.method, RUN)
    except ValueError as error:
        twins = _twins(samples)
        if twins is None:
            raise
        first, second = (place_of(job, sample) for sample in twins)
        raise ValueError(f"{first} and {second}: {error}") from None
    job.put(f"samples-{tile}", bytes_of(found["samples"]))
    job.put(f"runs-{tile}", bytes_of(found["runs"]))
    for kind in ("edges", "claims"):
        _put_pairs(job, parts, f"{kind}-{tile}", found[kind])
    if not found["open"].size:
        _put_pairs(job, parts, f"answers-{tile}", found["claims"][:0])
    job.put(f"open-{tile}", bytes_of(found["open"]))


def _twins(samples: NDArray[np.uint64]) -> tuple[int, int] | None:
    """Find two samples at one place: the first ones by coordinates."""
    x, y = (np.ascontiguousarray(samples[:, word]).view(np.float64) for word in (1, 2))
    order = np.lexsort((samples[:, 0], y, x))
    same = (x[order][1:] == x[order][:-1]) & (y[order][1:] == y[order][:-1])
    if not same.any():
        return None
    at = int(same.argmax())
    return int(samples[order[at], 0]), int(samples[order[at + 1], 0])


def _put_pairs(job: Job, parts: int, name: str, pairs: NDArray[np.uint64]) -> None:
    """Write edges or claims in shares, one for each part of the result, by their smaller ends."""
    smaller = np.minimum(pairs[:, 0], pairs[:, 1])
    # Edges come ascending.
    if (smaller[1:] < smaller[:-1]).any():
        order = smaller.argsort(kind="stable")
        pairs, smaller = pairs[order], smaller[order]
    bounds = np.array([-(-part * job.points // parts) for part in range(parts)], np.uint64)
    first = np.append(np.searchsorted(smaller, bounds), len(pairs))
    job.put_shares(name, pairs, first)


def gather(job: Job, tiles: int) -> None:
    """Write the areas of the runs of all tiles, and the number of the first run of each tile."""
    if job.has("atlas"):
        return
    areas = [np.frombuffer(job.get(f"runs-{tile}")).reshape(-1, 4) for tile in range(tiles)]
    first = np.concatenate([[0], np.cumsum([len(area) for area in areas])]).astype(np.int64)
    out = io.BytesIO()
    np.savez(out, areas=np.concatenate(areas), first=first)
    job.put("atlas", out.getbuffer())


def ask(job: Job, parts: int, tile: int) -> None:
    """Answer the open samples of a tile from the samples of all; claims follow."""
    if job.has(f"answers-{tile}"):
        return
    atlas = np.load(io.BytesIO(job.get("atlas")))
    areas, first = atlas["areas"], atlas["first"]

    @functools.lru_cache(maxsize=1024)
    def run(number: int) -> NDArray[np.uint64]:
        other = int(np.searchsorted(first, number, side="right")) - 1
        size = RUN * SAMPLE * WORD
        start = (number - int(first[other])) * size
        data = job.get(f"samples-{other}", start, start + size)
        return np.frombuffer(data, np.uint64).reshape(-1, SAMPLE)

    samples = np.frombuffer(job.get(f"open-{tile}"), np.uint64).reshape(-1, OPEN)
    cell = list(plan_of(job).cells[tile])
    found = _curvecrust.tiles_ask(samples, cell, job.method, areas, run)
    _put_pairs(job, parts, f"answers-{tile}", found["claims"])


def part_name(part: int) -> str:
    """Name a file of the result."""
    return f"part-{part:05}.parquet"


def finish(job: Job, parts: int, tiles: int, part: int) -> int:
    """Join the claims of a part, and write its edges, ascending; return how many there are."""
    name = part_name(part)
    fs, target = job.file_system()
    for there in (job.work(name), posixpath.join(target, name)):
        if fs.exists(there):
            with fs.open(there, "rb") as file:
                return int(pq.read_metadata(file).num_rows)

    def rows(*kinds: str) -> NDArray[np.uint64]:
        names = [f"{kind}-{tile}" for kind in kinds for tile in range(tiles)]
        return np.concatenate([job.share(name, parts, part, PAIR) for name in names])

    edges, claims = rows("edges"), rows("claims", "answers")
    found = _curvecrust.tiles_join(edges, claims, job.method)
    del edges
    out = io.BytesIO()
    pq.write_table(pa.table({"a": found["a"], "b": found["b"]}), out, use_dictionary=False)
    job.put(name, out.getbuffer())
    return len(found["a"])
