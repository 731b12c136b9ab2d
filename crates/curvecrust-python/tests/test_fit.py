"""Smooth curves of points that scatter."""

import numpy as np
import pytest

import curvecrust


def ring(n: int, sigma: float, seed: int = 1) -> np.ndarray:
    random = np.random.default_rng(seed)
    angles = random.uniform(0, 2 * np.pi, n)
    circle = np.c_[np.cos(angles), np.sin(angles)]
    return circle + sigma * random.normal(size=(n, 2))


def test_every_array_has_its_shape() -> None:
    points = np.r_[ring(300, 0.05), [[0.0, 0.0], [0.2, 0.1]]]
    found = curvecrust.fit(points)
    (curve,) = found.curves
    k = len(curve.cubics)
    assert curve.closed
    assert curve.cubics.shape == (k, 4, 2)
    assert curve.sigma.shape == curve.standard_error.shape == (k + 1,)
    assert np.allclose(curve.cubics[1:, 0], curve.cubics[:-1, 3])
    # A few points of a normal distribution are more than 3.5 deviations away.
    assert {300, 301} <= set(found.outliers.tolist())
    assert len(found.outliers) < 6
    assert found.curve_of.shape == found.parameters.shape == found.distances.shape == (302,)
    assert np.isnan(found.distances[300])
    assert not np.isnan(found.distances[0])
    assert not found.clean
    assert found.edges.shape == (0, 2)
    assert 0.03 < found.sigma < 0.07
    places = curve.points(1e-3)
    assert abs(np.hypot(*places.T) - 1).max() < 0.08
    count = len(found.outliers)
    assert repr(found) == f"<Fit of 302 points: 1 closed and 0 open, {count} outliers>"


def test_corners_are_listed() -> None:
    random = np.random.default_rng(2)
    along = np.linspace(0, 1, 80, endpoint=False)
    sides = [np.c_[along, 0 * along], np.c_[1 + 0 * along, along]]
    sides += [1 - side for side in sides]
    square = np.concatenate(sides) + 0.005 * random.normal(size=(320, 2))
    (curve,) = curvecrust.fit(square).curves
    corners = curve.cubics[curve.corners, 0]
    assert np.allclose(sorted(corners.round().tolist()), [[0, 0], [0, 1], [1, 0], [1, 1]])
    assert abs(corners - corners.round()).max() < 0.02
    (smooth,) = curvecrust.fit(ring(300, 0.05)).curves
    assert len(smooth.corners) == 0


def test_clean_points_have_the_edges_of_reconstruct() -> None:
    angles = np.random.default_rng(4).permutation(60) * np.pi / 30
    points = np.c_[np.cos(angles), np.sin(angles)]
    found = curvecrust.fit(points)
    assert found.clean
    assert found.sigma == 0
    assert np.array_equal(found.edges, curvecrust.reconstruct(points).edges)


def test_equal_points_share_a_place() -> None:
    points = ring(200, 0.05)
    points = np.r_[points, points[:1]]
    with pytest.raises(ValueError, match="200"):
        curvecrust.fit(points)
    found = curvecrust.fit(points, merge_within=0)
    assert found.parameters[0] == found.parameters[200]


def test_options_are_checked() -> None:
    points = ring(200, 0.05)
    assert not any(curve.closed for curve in curvecrust.fit(points, closed=False).curves)
    with pytest.raises(ValueError, match="sigma"):
        curvecrust.fit(points, sigma=-1)
    with pytest.raises(ValueError, match="curves"):
        curvecrust.fit(points, curves=0)
    with pytest.raises(ValueError, match="tolerance"):
        curvecrust.fit(points).curves[0].points(0)


def test_points_all_over_the_place_form_no_curve() -> None:
    points = np.random.default_rng(3).random((500, 2))
    found = curvecrust.fit(points)
    assert found.curves == []
    assert len(found.outliers) == 500
