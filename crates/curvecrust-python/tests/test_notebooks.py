"""The notebooks run."""

import pathlib
import runpy

import matplotlib as mpl
import pytest

mpl.use("agg")
NOTEBOOKS = sorted(pathlib.Path(__file__).parents[1].glob("docs/notebooks/*.py"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
@pytest.mark.filterwarnings("default")
def test_a_notebook_runs(notebook):
    runpy.run_path(str(notebook))
    mpl.pyplot.close("all")
