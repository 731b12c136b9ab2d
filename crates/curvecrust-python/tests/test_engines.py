"""The steps of tiles on engines of the reader, the recipes of the documents among them."""

import importlib.util
import pathlib

import numpy as np
import pandas as pd
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

    def exchange(self, load, items, empty, act, parts):
        moved = pd.concat([empty, *[load(item) for item in reversed(items)]])
        numbers = reversed(range(parts))
        return [act(moved[moved["goes_to"] == part], part) for part in numbers][::-1]


def recipe(name, *needs):
    for module in needs:
        pytest.importorskip(module)
    spec = importlib.util.spec_from_file_location(name, EXAMPLES / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def check(folder, engine, points, method="hnn-crust", tile_points=100):
    for number, part in enumerate(np.array_split(points, 3)):
        (folder / "in").mkdir(exist_ok=True, parents=True)
        table = pa.table({"x": part[:, 0], "y": part[:, 1]})
        pq.write_table(table, folder / "in" / f"{number}.parquet", row_group_size=70)
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
