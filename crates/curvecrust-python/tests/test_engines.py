"""The steps of tiles on engines of the reader, the recipes of the documents among them."""

import importlib.util
import pathlib

import numpy as np
import pytest

import curvecrust

pq = pytest.importorskip("pyarrow.parquet")
pa = pytest.importorskip("pyarrow")
tiles = pytest.importorskip("curvecrust.tiles")

EXAMPLES = pathlib.Path(__file__).parents[1] / "examples"


class Serial:
    """One thing after the other, the last one first."""

    def map(self, step, items):
        return [step(item) for item in reversed(items)][::-1]


class Stopped(Serial):
    """Breaks down after some calls of steps."""

    def __init__(self, calls):
        self.calls = calls

    def map(self, step, items):
        def counted(item):
            self.calls -= 1
            if self.calls < 0:
                raise KeyboardInterrupt
            return step(item)

        return super().map(counted, items)


def recipe(name, *needs):
    for module in needs:
        pytest.importorskip(module)
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write(folder, points):
    folder.mkdir(parents=True)
    for number, part in enumerate(np.array_split(points, 3)):
        table = pa.table({"x": part[:, 0], "y": part[:, 1]})
        pq.write_table(table, folder / f"{number}.parquet", row_group_size=70)


def check(folder, engine, points, method="hnn-crust", tile_points=100):
    write(folder / "in", points)
    source, target = str(folder / "in"), str(folder / "out")
    tiles.reconstruct(source, target, engine, method=method, tile_points=tile_points)
    wanted = curvecrust.reconstruct(points, method=method).edges.astype(np.uint64)
    assert tiles.edges(target).tobytes() == wanted.tobytes()


def hard(seed):
    """Few points of a kind that is hard: lattices, lines, far away points, ties."""
    random = np.random.default_rng(seed)
    count = int(random.integers(1, 120))
    kind = seed % 4
    if kind == 0:
        points = random.integers(0, 12, (count, 2)).astype(float)
    elif kind == 1:
        points = np.stack([random.permutation(count), np.zeros(count)], axis=1).astype(float)
    elif kind == 2:
        points = random.random((count, 2)) * 10.0 ** random.integers(0, 9, (count, 1))
    else:
        angle = random.permutation(count) / count * 2 * np.pi
        points = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return random.permutation(np.unique(points, axis=0))


@pytest.mark.parametrize("seed", range(24))
def test_hard_points_in_tiles_of_any_size(tmp_path, seed):
    method = ["hnn-crust", "hnn-crust-union", "nn-crust"][seed % 3]
    check(tmp_path, Serial(), hard(seed), method, tile_points=[1, 7, 40][seed // 8])


def test_a_run_that_was_stopped_goes_on(tmp_path):
    points = hard(6)
    write(tmp_path / "in", points)
    source, target = str(tmp_path / "in"), str(tmp_path / "out")
    for calls in range(5, 200, 5):
        try:
            found = tiles.reconstruct(source, target, Stopped(calls), tile_points=10)
            break
        except KeyboardInterrupt:
            assert len(list((tmp_path / "out").glob("_work-*"))) == 1
    assert calls > 20
    wanted = curvecrust.reconstruct(points, method="hnn-crust").edges.astype(np.uint64)
    assert tiles.edges(target).tobytes() == wanted.tobytes()
    assert (found.points, found.edges) == (len(points), len(wanted))
    assert not list((tmp_path / "out").glob("_work-*"))


def test_a_run_that_was_stopped_while_it_delivered_goes_on(tmp_path, monkeypatch):
    points = hard(6)
    write(tmp_path / "in", points)
    source, target = str(tmp_path / "in"), str(tmp_path / "out")
    job = importlib.import_module("curvecrust._tile_job").Job

    def first_only(self, names):
        deliver(self, names[:1])
        raise KeyboardInterrupt

    deliver, clean = job.deliver, job.clean
    monkeypatch.setattr(job, "deliver", first_only)
    monkeypatch.setattr(job, "clean", lambda self: None)
    with pytest.raises(KeyboardInterrupt):
        tiles.reconstruct(source, target, Serial(), tile_points=10)
    monkeypatch.setattr(job, "deliver", deliver)
    monkeypatch.setattr(job, "clean", clean)
    found = tiles.reconstruct(source, target, Serial(), tile_points=10)
    wanted = curvecrust.reconstruct(points, method="hnn-crust").edges.astype(np.uint64)
    assert tiles.edges(target).tobytes() == wanted.tobytes()
    assert found.edges == len(wanted)
    # The same call again finds a result.
    with pytest.raises(FileExistsError):
        tiles.reconstruct(source, target, Serial(), tile_points=10)


def test_another_source_begins_anew(tmp_path):
    source, target = str(tmp_path / "in"), str(tmp_path / "out")
    write(tmp_path / "in", hard(6))
    with pytest.raises(KeyboardInterrupt):
        tiles.reconstruct(source, target, Stopped(12), tile_points=10)
    points = hard(10)
    for path in (tmp_path / "in").iterdir():
        path.unlink()
    (tmp_path / "in").rmdir()
    check(tmp_path, Serial(), points, tile_points=10)


@pytest.mark.filterwarnings("ignore")
def test_on_spark(tmp_path):
    module = recipe("on_spark", "pyspark")
    session = module.SparkSession.builder.master("local[2]").getOrCreate()
    try:
        check(tmp_path, module.Spark(session), hard(3))
    finally:
        session.stop()


@pytest.mark.filterwarnings("ignore")
def test_on_ray(tmp_path):
    module = recipe("on_ray", "ray")
    module.ray.init(num_cpus=2, include_dashboard=False)
    try:
        check(tmp_path, module.Ray(), hard(3), tile_points=30)
    finally:
        module.ray.shutdown()
