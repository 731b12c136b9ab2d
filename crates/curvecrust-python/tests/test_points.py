"""What may be given for points, and what is said of what may not."""

import geopandas
import numpy as np
import pandas
import pytest
import shapely

import curvecrust

ANGLES = np.random.default_rng(3).permutation(24) * (np.pi / 12)
RING = np.column_stack((np.cos(ANGLES), np.sin(ANGLES)))
EXPECTED = curvecrust.reconstruct(RING).indices

TABLE = np.column_stack((RING, np.zeros(len(RING))))
STRIDED = np.repeat(RING, 2, axis=0)[::2]
READ_ONLY = RING.copy()
READ_ONLY.setflags(write=False)


@pytest.mark.parametrize(
    "points",
    [
        pytest.param(RING.tolist(), id="lists"),
        pytest.param([tuple(row) for row in RING], id="tuples"),
        pytest.param(iter(RING.tolist()), id="iterator"),
        pytest.param(np.asfortranarray(RING), id="fortran"),
        pytest.param(TABLE[:, :2], id="columns"),
        pytest.param(STRIDED, id="strided"),
        pytest.param(RING[::-1][::-1], id="reversed-twice"),
        pytest.param(READ_ONLY, id="read-only"),
        pytest.param(RING.astype(">f8"), id="big-endian"),
        pytest.param(RING.astype(object), id="objects"),
        pytest.param(RING[:, 0] + 1j * RING[:, 1], id="complex"),
        pytest.param(pandas.DataFrame(RING, columns=["x", "y"]), id="frame"),
        pytest.param(shapely.MultiPoint(RING), id="multipoint"),
        pytest.param(geopandas.GeoSeries(shapely.points(RING)), id="series"),
        pytest.param(geopandas.GeoDataFrame(geometry=shapely.points(RING)), id="geoframe"),
        pytest.param({"type": "MultiPoint", "coordinates": RING.tolist()}, id="mapping"),
        pytest.param(np.ma.masked_invalid(RING), id="nothing-masked"),
    ],
)
def test_every_kind_of_points_is_the_same(points):
    assert curvecrust.reconstruct(points).indices.tolist() == EXPECTED.tolist()


def test_an_array_is_not_copied():
    assert np.shares_memory(curvecrust.reconstruct(RING).points, RING)


def test_single_precision_and_integers_are_widened():
    square = np.array([(0, 0), (1, 1), (1, 0), (0, 1)])
    for kind in ("f4", "f2", "i4", "u1", "i8"):
        assert curvecrust.reconstruct(square.astype(kind)).closed.tolist() == [True]


@pytest.mark.parametrize("empty", [[], (), np.empty((0, 2)), np.empty(0), shapely.MultiPoint()])
def test_no_points_give_no_curves(empty):
    found = curvecrust.reconstruct(empty)
    assert len(found) == 0
    assert found.paths == ()
    assert found.edges.shape == (0, 2)
    assert found.offsets.tolist() == [0]
    assert repr(found) == "<Reconstruction of 0 points: no curve>"


@pytest.mark.parametrize(
    ("points", "error", "message"),
    [
        (np.zeros((4, 3)), ValueError, r"shape \(n, 2\), not \(4, 3\)$"),
        (np.zeros((2, 5)), ValueError, r"not \(2, 5\): give points.T"),
        (np.zeros(4), ValueError, r"not \(4,\)"),
        (np.zeros((2, 2, 2)), ValueError, r"not \(2, 2, 2\)"),
        (5, TypeError, "not int"),
        ([(0, 0), (1,)], ValueError, "two coordinates in every row"),
        ([(0, 0), (1, np.nan)], ValueError, r"point 1 is \(1, NaN\)"),
        ([(0, 0), (np.inf, 1)], ValueError, "point 1 is"),
        ([(0, 0), (1, 0), (0, 0)], ValueError, "point"),
        ([("a", "b"), ("c", "d")], TypeError, "must be numbers"),
        (np.array([(0, None), (1, 2)]), ValueError, r"point 0 is \(0, NaN\)"),
        (np.array([(0, "x"), (1, 2)], dtype=object), TypeError, "hold 'x'"),
        (np.array(["2020-01-01"] * 2, dtype="M8[D]").reshape(1, 2), TypeError, "numbers"),
        (None, TypeError, "not NoneType"),
        ({"type": "Circle"}, TypeError, "'Circle'"),
        (
            np.ma.masked_equal([(0.0, 1.0), (2.0, 3.0)], 3.0),
            ValueError,
            "row 1 of points is masked",
        ),
    ],
)
def test_what_is_no_points_is_refused(points, error, message):
    with pytest.raises(error, match=message):
        curvecrust.reconstruct(points)


def test_rings_of_geometries_do_not_repeat_their_first_point():
    square = shapely.box(0, 0, 1, 1)
    assert len(curvecrust.reconstruct(square).points) == 4
    assert len(curvecrust.reconstruct(square.exterior).points) == 4
    feature = {"type": "Feature", "geometry": shapely.geometry.mapping(square)}
    assert len(curvecrust.reconstruct({"type": "FeatureCollection", "features": [feature]})) == 1
