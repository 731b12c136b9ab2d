"""Curves, samples and what is known of them."""

import numpy as np
import pandas
import pytest

import curvecrust

CIRCLE = curvecrust.Curve.from_path("M 1 0 A 1 1 0 0 1 -1 0 A 1 1 0 0 1 1 0 Z")
TRIANGLE = curvecrust.Curve.from_path("M 0 0 H 4 V 4 Z")
SQUARE = curvecrust.Curve.from_path("M 0 0 H 4 V 4 H 0 Z")
PLUS = curvecrust.Curve.from_path("M 0 1 H 2 M 1 0 V 2")


def test_curves_come_from_drawings_and_from_points():
    svg = '<svg xmlns="http://www.w3.org/2000/svg"><circle cx="5" cy="5" r="2"/></svg>'
    circle = curvecrust.Curve.from_svg(svg)
    assert repr(circle) == "<Curve of 1 component, closed>"
    assert circle.extent == pytest.approx(4)
    rim = circle.polylines()[0]
    assert np.hypot(*(rim - 5).T) == pytest.approx(2, rel=1e-3)
    assert (rim[0] == rim[-1]).all()
    assert TRIANGLE.corners.tolist() == [[0, 0], [4, 0], [4, 4]]
    angles = np.arange(24) * np.pi / 12
    through = curvecrust.Curve.from_points(np.column_stack((np.cos(angles), np.sin(angles))))
    assert np.hypot(*through.polylines()[0].T) == pytest.approx(1, abs=1e-4)
    assert not curvecrust.Curve.from_points([(0, 0), (1, 1), (2, 0)], closed=False).closed[0]
    assert curvecrust.Curve.from_points([(0, 0), (1, 1)], closed=False).closed == [False]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: curvecrust.Curve.from_svg("<html>"), "."),
        (lambda: curvecrust.Curve.from_svg("<svg xmlns='http://www.w3.org/2000/svg'/>"), "."),
        (lambda: curvecrust.Curve.from_svg("", snap=-1), "snap"),
        (lambda: curvecrust.Curve.from_path("M 0 0 L"), "."),
        (lambda: curvecrust.Curve.from_points([(0, 0), (1, 0)]), "3 points at least, not 2"),
        (lambda: curvecrust.Curve.from_points([(0, 0), (1, 0), (0, 0)]), "point"),
        (lambda: curvecrust.Curve.from_points([(0, 0), (1, 0), (2, 0)]), "."),
        (lambda: curvecrust.sample(CIRCLE, rho=2), "rho"),
        (lambda: curvecrust.sample(CIRCLE, rho=0.5, epsilon=0.5), "either rho or epsilon"),
        (lambda: curvecrust.sample(CIRCLE, rho=0.5, count="most"), "'most'"),
        (lambda: curvecrust.sample(TRIANGLE, rho=0.5, count="verified"), "hnn-crust"),
        (lambda: curvecrust.sample(PLUS, strokes="apart", count="verified"), "verified"),
        (lambda: curvecrust.sample(CIRCLE, rho=1e-9), "samples"),
        (lambda: curvecrust.check(CIRCLE, [(9, 9)]), "."),
        (lambda: curvecrust.evaluate(CIRCLE, [(1, 0), (-1, 0)], [(0, 2)]), "edge 0"),
    ],
)
def test_what_is_no_curve_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_samples_satisfy_what_was_asked():
    for bound in ({"rho": 0.6}, {"epsilon": 0.3}):
        samples = curvecrust.sample(CIRCLE, **bound)
        found = curvecrust.check(CIRCLE, samples, **bound)
        assert found.holds
        assert len(found.values) == 0
        assert samples.attained[0] < next(iter(bound.values()))
    assert len(curvecrust.sample(CIRCLE, max_distance=0.01)) > len(curvecrust.sample(CIRCLE))
    counts = [len(curvecrust.sample(CIRCLE, rho=0.3, count=c)) for c in ("greedy", "fewest")]
    assert counts[0] >= counts[1]
    found = curvecrust.check(CIRCLE, [(1, 0), (-1, 0)], rho=0.9)
    assert not found.holds
    assert found.between.tolist() == [[0, 1], [1, 0]]


def test_corners_are_sampled_until_they_are_found_again():
    samples = curvecrust.sample(TRIANGLE)
    assert samples.is_decoded
    found = curvecrust.reconstruct(samples)
    assert found.edges.tolist() == samples.edges.tolist()


def test_corners_are_looked_at_by_every_function():
    samples = curvecrust.sample(SQUARE, rho=0.5)
    found = curvecrust.check(SQUARE, samples, rho=0.5)
    assert found.holds
    assert len(found.order) == len(samples) + 4
    corners = [samples.points.tolist().index(corner) for corner in SQUARE.corners.tolist()]
    missed = np.delete(samples.points, corners[0], axis=0)
    assert not curvecrust.check(SQUARE, missed, rho=0.5).holds
    assert curvecrust.evaluate(SQUARE, samples, samples.edges).metrics["exact"] == 1
    axis = curvecrust.medial_axis(SQUARE)
    # Its branches run along the diagonals.
    assert np.abs(np.abs(axis.ends[:, 0] - 2) - np.abs(axis.ends[:, 1] - 2)).max() < 0.1
    counts = [len(curvecrust.sample(SQUARE, rho=0.5, count=c)) for c in ("greedy", "fewest")]
    assert counts[0] == counts[1] == len(samples)
    verified = curvecrust.sample(SQUARE, rho=0.5, count="verified")
    assert sorted(verified.points.tolist()) == sorted(SQUARE.corners.tolist())


def test_strokes_that_touch_are_cut_or_sampled_one_by_one():
    samples = curvecrust.sample(PLUS)
    assert (samples.strokes, samples.is_decoded, samples.closed.size) == ("cut", True, 3)
    assert [1, 1] in samples.points.tolist()
    assert curvecrust.check(PLUS, samples, rho=0.9).holds
    assert curvecrust.evaluate(PLUS, samples, samples.edges).metrics["exact"] == 1
    apart = curvecrust.sample(PLUS, strokes="apart")
    assert (apart.strokes, apart.is_decoded, len(apart)) == ("apart", True, 4)
    with pytest.raises(ValueError, match="touches"):
        curvecrust.sample(PLUS, strokes="together")
    with pytest.raises(ValueError, match="'auto', 'together', 'cut', 'apart'"):
        curvecrust.sample(PLUS, strokes="none")
    assert curvecrust.sample(CIRCLE).strokes == "together"
    assert curvecrust.sample(CIRCLE, strokes="apart").strokes == "apart"


def test_the_medial_axis_of_an_ellipse_is_a_segment():
    ellipse = curvecrust.Curve.from_path("M 2 0 A 2 1 0 0 1 -2 0 A 2 1 0 0 1 2 0 Z")
    axis = curvecrust.medial_axis(ellipse)
    inside = np.abs(axis.starts[:, 0]) < 1.6
    inside &= np.abs(axis.starts[:, 1]) < 0.5
    assert np.abs(axis.starts[inside, 1]).max() < 1e-2
    assert axis.radii.shape == axis.sites.shape == axis.starts.shape
    found = curvecrust.lfs(ellipse)
    assert found.lfs.min() == pytest.approx(0.5, rel=1e-2)
    assert found.lfs.max() == pytest.approx(1.0, rel=1e-2)
    assert curvecrust.lfs(TRIANGLE).lfs.shape == curvecrust.lfs(TRIANGLE).points.shape[:1]


def test_methods_are_compared():
    records = pandas.DataFrame(curvecrust.compare(CIRCLE, rho=0.5))
    assert records.method.tolist() == [method.name for method in curvecrust.methods()]
    assert records.exact[records.method == "least-detour"].tolist() == [1.0]
    samples = curvecrust.sample(CIRCLE, rho=0.5)
    assert len(curvecrust.compare(samples, methods=["crust"])) == 1
    missing = curvecrust.evaluate(CIRCLE, samples, samples.edges[1:]).missing
    assert missing.tolist() == samples.edges[:1].tolist()


def test_what_is_no_curve_is_a_type_error():
    with pytest.raises(TypeError, match="must be a Curve, not str"):
        curvecrust.sample("M 0 0 H 4 V 4 Z")
