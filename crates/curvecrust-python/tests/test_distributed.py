"""Tiles on a cluster of Dask: the edges of one machine, whatever happens."""

import os
import pathlib
import signal
import threading
import time

import numpy as np
import pytest

import curvecrust

distributed = pytest.importorskip("distributed")
pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
tiles = pytest.importorskip("curvecrust.distributed")

METHODS = ["hnn-crust", "nn-crust"]


@pytest.fixture(scope="module")
def client():
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=":0", memory_limit=0
    )
    with cluster, distributed.Client(cluster) as client:
        yield client


def curves(count, seed=1):
    """Points of circles and arcs, in no order."""
    random = np.random.default_rng(seed)
    parts = []
    for number in range(max(1, count // 100)):
        turn = 2 * np.pi if number % 3 else 5.0
        angle = np.linspace(0, turn, 100, endpoint=False)
        radius = 0.2 + 0.6 * random.random()
        centre = np.array([number % 10, number // 10]) * 2.0
        parts.append(centre + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1))
    points = np.concatenate(parts)
    return random.permutation(points)


def write(folder, points, files=3, groups=50):
    folder.mkdir(parents=True, exist_ok=True)
    for number, part in enumerate(np.array_split(points, files)):
        table = pa.table({"x": part[:, 0], "y": part[:, 1], "name": ["p"] * len(part)})
        pq.write_table(table, folder / f"points-{number:02}.parquet", row_group_size=groups)


def at_once(points, method):
    return curvecrust.reconstruct(points, method=method).edges.astype(np.uint64)


def lattice(side):
    return np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2) * 1.0


@pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::ResourceWarning")
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(
    ("points", "tile_points"),
    [
        (curves(2000), 300),
        (curves(2000), 100_000),
        (np.random.default_rng(2).random((700, 2)), 50),
        (lattice(20), 37),
        (np.stack([np.arange(300.0), np.zeros(300)], axis=1), 40),
        (np.array([[0.0, 0.0]]), 5),
    ],
    ids=["curves", "one tile", "uniform", "lattice", "line", "point"],
)
def test_edges_are_those_of_one_machine(client, tmp_path, points, tile_points, method):
    write(tmp_path / "in", points)
    found = tiles.reconstruct(
        str(tmp_path / "in"),
        str(tmp_path / "out"),
        method=method,
        client=client,
        tile_points=tile_points,
    )
    wanted = at_once(points, method)
    assert tiles.edges(str(tmp_path / "out")).tobytes() == wanted.tobytes()
    assert (found.points, found.edges) == (len(points), len(wanted))
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == [f"part-{part:05}.parquet" for part in range(-(-len(points) // tile_points))]


@pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::ResourceWarning")
def test_a_lost_worker_changes_nothing(tmp_path):
    points = curves(40_000)
    write(tmp_path / "in", points, files=8, groups=1000)
    cluster = distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=":0", memory_limit=0
    )
    killed = []

    def kill():
        # When the first tiles are solved, others are under way.
        while not list(pathlib.Path(tmp_path).glob("out/_work-*/edges-*")):
            time.sleep(0.01)
        victim = next(iter(cluster.workers.values())).pid
        os.kill(victim, signal.SIGKILL)
        killed.append(victim)

    with cluster, distributed.Client(cluster) as client:
        thread = threading.Thread(target=kill, daemon=True)
        thread.start()
        tiles.reconstruct(
            str(tmp_path / "in"), str(tmp_path / "out"), client=client, tile_points=1000
        )
    assert killed
    wanted = at_once(points, "hnn-crust")
    assert tiles.edges(str(tmp_path / "out")).tobytes() == wanted.tobytes()


@pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::ResourceWarning")
def test_what_is_wrong_is_named(client, tmp_path):
    def error(points, kind=ValueError, **options):
        source = tmp_path / f"in{len(list(tmp_path.iterdir()))}"
        write(source, points)
        with pytest.raises(kind) as raised:
            tiles.reconstruct(
                str(source), str(tmp_path / "out"), client=client, tile_points=50, **options
            )
        return str(raised.value)

    points = curves(500)
    broken = points.copy()
    broken[401, 1] = np.nan
    assert "points-02.parquet, row group 1, row 17" in error(broken)
    twice = points.copy()
    twice[477] = twice[3]
    said = error(twice)
    assert "points-00.parquet, row group 0, row 3 and " in said
    assert "points-02.parquet, row group 2, row 43: " in said
    assert "no column 'lon'" in error(points, x="lon", y="lat")
    assert "not of numbers" in error(points, x="x", y="name")
    assert "least-detour" in error(points, method="least-detour")
    (tmp_path / "empty").mkdir()
    with pytest.raises(FileNotFoundError):
        tiles.reconstruct(str(tmp_path / "empty"), str(tmp_path / "out"), client=client)
    full = tmp_path / "full"
    full.mkdir()
    (full / "mine").write_text("kept")
    source = tmp_path / "good"
    write(source, points)
    with pytest.raises(FileExistsError):
        tiles.reconstruct(str(source), str(full), client=client)
    assert (full / "mine").read_text() == "kept"


@pytest.mark.filterwarnings("ignore::FutureWarning", "ignore::ResourceWarning")
def test_no_points_are_no_edges(client, tmp_path):
    write(tmp_path / "in", np.zeros((0, 2)), files=1)
    found = tiles.reconstruct(str(tmp_path / "in"), str(tmp_path / "out"), client=client)
    assert found.edges == 0
    assert tiles.edges(str(tmp_path / "out")).shape == (0, 2)
