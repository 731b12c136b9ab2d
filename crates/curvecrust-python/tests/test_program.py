"""The package and the program find the same, on all fixtures."""

import io
import pathlib
import subprocess
import sys

import numpy as np
import pytest

import curvecrust

FIXTURES = pathlib.Path(__file__).parents[3] / "fixtures"
CURVES = sorted(FIXTURES.glob("curves/*.svg"))
pytestmark = pytest.mark.skipif(not CURVES, reason="the fixtures are not in the package")


def program(*arguments, check=True):
    command = [sys.executable, "-m", "curvecrust", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=check).stdout


def npy(output):
    return np.load(io.BytesIO(output))


@pytest.mark.parametrize("curve", CURVES, ids=lambda path: path.stem)
def test_fixtures_give_the_same_samples_and_edges(curve, tmp_path):
    written = npy(program("sample", curve, "--rho", 0.9, "--count", "greedy", "--to", "npy"))
    samples = curvecrust.sample(curvecrust.Curve.from_svg(curve.read_text()), rho=0.9)
    assert samples.points.tobytes() == written.tobytes()
    shuffled = np.random.default_rng(1).permutation(written)
    file = tmp_path / "points.npy"
    np.save(file, shuffled)
    for method in ("least-detour", "hnn-crust", "crust"):
        edges = npy(program("reconstruct", file, "--algorithm", method, "--to", "npy"))
        found = curvecrust.reconstruct(shuffled, method=method)
        assert found.edges.astype(edges.dtype).tobytes() == edges.tobytes()


@pytest.mark.parametrize("file", sorted(FIXTURES.glob("points/*.xy")), ids=lambda path: path.stem)
@pytest.mark.parametrize("method", [method.name for method in curvecrust.methods()])
def test_points_of_fixtures_give_the_same_edges(file, method):
    edges = npy(program("reconstruct", file, "--algorithm", method, "--to", "npy"))
    found = curvecrust.reconstruct(np.loadtxt(file), method=method)
    assert found.edges.astype(edges.dtype).tobytes() == edges.tobytes()


def test_importing_loads_nothing_else():
    code = "import sys, curvecrust; assert 'numpy' not in sys.modules; print(dir(curvecrust)[-1])"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout
    assert said.split() == [b"sample"]
    with pytest.raises(AttributeError, match="no attribute 'no_such'"):
        curvecrust.no_such  # noqa: B018


def test_the_program_has_its_exit_codes():
    assert program("--version").startswith(b"curvecrust ")
    for arguments, code in ((["--no-such"], 2), (["reconstruct", "/no/such/file"], 2)):
        with pytest.raises(subprocess.CalledProcessError) as failed:
            program(*arguments)
        assert failed.value.returncode == code
