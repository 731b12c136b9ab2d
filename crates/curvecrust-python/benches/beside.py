"""Time and exactness beside what else can be installed, and the overhead over the library itself.

Run by `cargo xtask python bench`, with files as arguments: each line an object of JSON whose
`rings` are lists of points in order. Needs alphashape, scipy and shapely.
"""

import json
import pathlib
import statistics
import sys
import time
import warnings

import alphashape
import numpy as np
import scipy.spatial
import shapely

import curvecrust

warnings.simplefilter("ignore")


def edges_of(rows):
    """Return the edges around a ring, each with its ends ascending."""
    return {tuple(sorted((int(a), int(b)))) for a, b in zip(rows, np.roll(rows, -1), strict=True)}


def rows_of(points, ring):
    """Return the rows of the points of a ring of shapely."""
    places = {tuple(place): row for row, place in enumerate(points.tolist())}
    return [places[tuple(place)] for place in np.asarray(ring.coords)[:-1].tolist()]


def of_polygons(points, shape):
    """Return the edges of the rings of polygons."""
    parts = shapely.get_parts(shape)
    rings = [ring for p in parts if p.geom_type == "Polygon" for ring in (p.exterior, *p.interiors)]
    return set().union(*(edges_of(rows_of(points, ring)) for ring in rings), set())


def least_detour(points):
    """Return what the default finds."""
    return set(map(tuple, curvecrust.reconstruct(points).edges.tolist()))


def hnn_crust(points):
    """Return what the fastest method finds."""
    return set(map(tuple, curvecrust.reconstruct(points, method="hnn-crust").edges.tolist()))


def with_rings(points, rings):
    """Return `rings` closed curves through all points."""
    found = curvecrust.reconstruct(points, closed=True, curves=rings)
    return set(map(tuple, found.edges.tolist()))


def concave_hull(points):
    """Return the concave hull of shapely at the ratio that is most often recommended."""
    return of_polygons(points, shapely.concave_hull(shapely.MultiPoint(points), ratio=0.1))


def alpha_shape(points):
    """Return the alpha-shape at the radius of twice the median distance of nearest neighbours."""
    near = scipy.spatial.cKDTree(points).query(points, 2)[0][:, 1]
    return of_polygons(points, alphashape.alphashape(points, 1 / (2 * np.median(near))))


def nearest_unvisited(points):
    """Return the ring that goes from each point to the nearest one that is left, by scipy."""
    tree, left, row, rows = scipy.spatial.cKDTree(points), np.ones(len(points), bool), 0, []
    while True:
        rows.append(row)
        left[row] = False
        if not left.any():
            return edges_of(rows)
        count = 8
        while True:
            near = tree.query(points[row], min(count, len(points)))[1]
            near = near[left[near]]
            if len(near):
                row = near[0]
                break
            count *= 4


METHODS = {
    "curvecrust": least_detour,
    "curvecrust, method=hnn-crust": hnn_crust,
    "curvecrust, number of rings given": with_rings,
    "shapely.concave_hull(ratio=0.1)": concave_hull,
    "alphashape": alpha_shape,
    "nearest unvisited, by scipy": nearest_unvisited,
}


def shapes_in(file):
    """Return for each shape its points, in no order, the number of its rings, and its edges."""
    shapes = []
    for seed, line in enumerate(pathlib.Path(file).read_text().splitlines()):
        rings = [np.array(ring, dtype=float) for ring in json.loads(line)["rings"]]
        points = np.vstack(rings)
        order = np.random.default_rng(seed).permutation(len(points))
        rows = np.split(np.argsort(order), np.cumsum([len(ring) for ring in rings])[:-1])
        shapes.append((points[order], len(rings), set().union(*map(edges_of, rows))))
    return shapes


def beside(files):
    """Print the table of time and exactness."""
    groups = {pathlib.Path(file).stem: shapes_in(file) for file in files}
    print("| | " + " | ".join(f"{name}, {len(all_)}" for name, all_ in groups.items()) + " |")
    print("|---|" + "---|" * len(groups))
    for name, method in METHODS.items():
        cells = []
        for shapes in groups.values():
            exact, seconds = 0, 0.0
            for points, count, truth in shapes:
                start = time.perf_counter()
                try:
                    arguments = (points, count) if method is with_rings else (points,)
                    exact += method(*arguments) == truth
                except Exception as error:
                    print(f"{name}: {error!r}", file=sys.stderr)
                seconds += time.perf_counter() - start
            cells.append(
                f"{100 * exact / len(shapes):.1f} %, {1000 * seconds / len(shapes):.2f} ms"
            )
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def overhead():
    """Print what the binding costs."""
    angles = np.tile(np.arange(1000) * (2 * np.pi / 1000), (1000, 1))
    x, y = (3 * g.reshape(-1, 1)[:1000] for g in np.meshgrid(np.arange(32), np.arange(32)))
    many = np.stack((x + np.cos(angles), y + np.sin(angles)), -1).reshape(-1, 2)
    many = np.random.default_rng(0).permutation(many)
    seconds = []
    for _ in range(7):
        start = time.perf_counter()
        curvecrust.reconstruct(many, method="hnn-crust")
        seconds.append(time.perf_counter() - start)
    print(f"10^6 points by hnn-crust: {statistics.median(seconds):.3f} s")
    turn = np.arange(100) * (2 * np.pi / 100)
    cloud = np.column_stack((2 * np.cos(turn), np.sin(turn) + np.cos(2 * turn)))
    clouds = [np.random.default_rng(i).permutation(cloud) for i in range(1000)]
    for method in ("hnn-crust", "least-detour"):
        start = time.perf_counter()
        for points in clouds:
            curvecrust.reconstruct(points, method=method)
        print(
            f"1,000 clouds of 100 points by {method}: {1000 * (time.perf_counter() - start):.0f} ms"
        )


if __name__ == "__main__":
    overhead()
    if sys.argv[1:]:
        beside(sys.argv[1:])
