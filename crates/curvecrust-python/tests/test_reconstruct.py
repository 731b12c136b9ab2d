"""Curves from points, and what is made of them."""

import xml.etree.ElementTree

import matplotlib as mpl
import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import curvecrust

mpl.use("agg")


def ring(radius, count, centre=(0, 0)):
    angles = np.arange(count) * (2 * np.pi / count)
    return np.column_stack((np.cos(angles), np.sin(angles))) * radius + centre


ISLAND = np.vstack(
    (ring(9, 60), ring(6, 40), ring(3, 20), [*((20 + i, 0.2 * i) for i in range(6))])
)


def test_rings_inside_rings_are_polygons_with_holes():
    found = curvecrust.reconstruct(ISLAND)
    assert [path.nesting for path in found.paths] == [0, 1, 2, None]
    assert [path.parent for path in found.paths] == [None, 0, 1, None]
    outer, inner = found.to_polygons()
    assert (len(outer.interiors), len(inner.interiors)) == (1, 0)
    assert outer.is_valid
    assert [line.geom_type for line in found.to_shapely()] == [*["LinearRing"] * 3, "LineString"]
    frame = found.to_geopandas(crs="EPSG:4326")
    assert frame.geom_type.tolist() == ["Polygon", "Polygon", "LineString"]
    assert frame.points.tolist() == [100, 20, 6]
    assert frame.closed.tolist() == [True, True, False]
    parts = shapely.from_wkt(found.to_wkt()).geoms
    assert [part.equals(shape) for part, shape in zip(parts, frame.geometry, strict=True)] == [
        True
    ] * 3


def test_flat_arrays_hold_the_paths():
    found = curvecrust.reconstruct(ISLAND)
    for i, path in enumerate(found):
        part = found.indices[found.offsets[i] : found.offsets[i + 1]]
        assert path.indices.tolist() == part.tolist()
        assert path.points.tolist() == ISLAND[part].tolist()
        assert path.closed == found.closed[i]
    assert found.edges.dtype == found.indices.dtype == np.int64
    assert found.leaves.tolist() == [120, 125]


def test_options_for_known_curves():
    rows = [(i, j) for i in range(8) for j in (0, 3)]
    assert len(curvecrust.reconstruct(rows)) == 2
    assert curvecrust.reconstruct(rows, closed=True, curves=1).closed.tolist() == [True]
    assert curvecrust.reconstruct(rows, closed=False, curves=1).closed.tolist() == [False]
    opened = curvecrust.reconstruct(ring(1, 12), closed=False, curves=1, termini=[3, 4])
    assert opened.leaves.tolist() == [3, 4]


def test_equal_points_are_merged_only_if_asked():
    twice = np.vstack((ring(1, 12), ring(1, 12)[:2]))
    with pytest.raises(ValueError, match=r"12 and 0|0 and 12"):
        curvecrust.reconstruct(twice)
    found = curvecrust.reconstruct(twice, merge_within=0)
    assert found.duplicates.tolist() == [[12, 0], [13, 1]]
    assert len(found.indices) == 12
    assert len(found.violations.points) == 12
    assert len(found.reasons.edges) == 12
    near = np.vstack((ring(1, 12), [(1 + 1e-9, 0)]))
    assert len(curvecrust.reconstruct(near, merge_within=1e-6).duplicates) == 1


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"method": "crusty"}, ValueError, "no method is called 'crusty': there are least-detour"),
        ({"method": 3}, TypeError, "method must be a str"),
        ({"curves": 0}, ValueError, "curves is 0"),
        ({"curves": 1.5}, TypeError, "integer"),
        ({"termini": [99]}, ValueError, "terminus 99"),
        ({"termini": [-1]}, ValueError, "termini is -1"),
        ({"termini": 3}, TypeError, "iterable"),
        ({"threads": 0}, ValueError, "threads is 0"),
        ({"merge_within": -1}, ValueError, "length of 0 or more"),
        ({"merge_within": float("nan")}, ValueError, "length"),
        ({"method": "crust", "termini": [0]}, ValueError, "crust"),
        ({"method": "crust", "closed": True}, ValueError, "crust"),
    ],
)
def test_arguments_that_make_no_sense_are_refused(arguments, error, message):
    with pytest.raises(error, match=message):
        curvecrust.reconstruct(ring(1, 12), **arguments)


def test_reasons_and_violations():
    found = curvecrust.reconstruct(ISLAND)
    reasons = found.reasons
    assert reasons.edges.tolist() == found.edges.tolist()
    assert set(reasons.reasons) <= {"certified", "completed", "exchanged", "required"}
    assert sorted(reasons.ends.tolist()) == found.leaves.tolist()
    violations = found.violations
    assert len(violations.points) == len(ISLAND) - 2
    assert violations.degrees.min() > 100
    assert (violations.length_ratios >= 1).all()
    assert curvecrust.reconstruct(ISLAND, method="hnn-crust").reasons is None


def test_order_is_a_permutation():
    angles = np.random.default_rng(0).permutation(30)
    spiral = np.column_stack((np.cos(angles / 5), np.sin(angles / 5))) * (angles + 9)[:, None]
    rows = curvecrust.order(spiral, closed=False)
    assert angles[rows].tolist() in (list(range(30)), list(range(29, -1, -1)))
    assert sorted(curvecrust.order(ring(1, 9), closed=True)) == list(range(9))
    assert curvecrust.order([]).tolist() == []
    assert curvecrust.order([(1, 2)]).tolist() == [0]
    assert sorted(curvecrust.order([(1, 2), (3, 4)]).tolist()) == [0, 1]
    with pytest.raises(ValueError, match="point 0"):
        curvecrust.order([(1, np.nan)])
    for few in ([], [(1, 2)], [(1, 2), (3, 4)], [(1, 1), (2, 2), (3, 3)]):
        with pytest.raises(ValueError, match=r".+"):
            curvecrust.order(few, closed=True)


def test_find_curve_path_repeats_the_first_of_a_ring():
    found = curvecrust.find_curve_path(ISLAND)
    assert [path[0] == path[-1] for path in found] == [True, True, True, False]
    assert sorted({row for path in found for row in path}) == list(range(len(ISLAND)))


def test_pictures_are_whole_documents():
    found = curvecrust.reconstruct(np.vstack((ISLAND, [(100, 100)])))
    for text in (found.to_svg(), found.to_svg(points=False), found._repr_svg_()):
        root = xml.etree.ElementTree.fromstring(text)
        assert root.tag.endswith("svg")
    names = [child.tag.split("}")[1] for child in xml.etree.ElementTree.fromstring(found.to_svg())]
    assert names.count("polygon") == 3
    assert names.count("polyline") == 1
    assert names.count("circle") == len(ISLAND) + 1
    for few in ([], [(1, 1)], [(1e60, 1e60), (-1e60, -1e60)], [(0, 0), (0, 5)]):
        assert "nan" not in curvecrust.reconstruct(few).to_svg()
    ax = found.plot()
    assert found.plot(ax) is ax
    assert len(ax.collections) == 4
    mpl.pyplot.close("all")


COORDINATE = st.one_of(
    st.integers(-4, 4).map(float),
    st.floats(allow_nan=True, allow_infinity=True, width=64),
)
POINTS = st.lists(st.tuples(COORDINATE, COORDINATE), max_size=40)
METHODS = st.sampled_from([method.name for method in curvecrust.methods()])


@settings(max_examples=500, deadline=None)
@given(POINTS, METHODS, st.sampled_from([None, 0.0, 0.5]))
def test_any_points_give_curves_or_an_error_of_value(points, method, merge_within):
    try:
        found = curvecrust.reconstruct(points, method=method, merge_within=merge_within)
    except ValueError:
        return
    merged = set(found.duplicates[:, 0].tolist())
    on_curves = found.indices.tolist()
    alone = found.isolated.tolist()
    assert sorted({*on_curves, *alone} | merged) == list(range(len(points)))
    for path in found:
        pairs = list(zip(path.indices, path.indices[1:], strict=False))
        if path.closed:
            pairs.append((path.indices[-1], path.indices[0]))
        edges = {tuple(sorted(edge)) for edge in found.edges.tolist()}
        assert {tuple(sorted(map(int, pair))) for pair in pairs} <= edges
    found.to_svg()
    found.to_wkt()
