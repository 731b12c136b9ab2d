"""Points in, ordered curves out.

>>> import curvecrust
>>> points = [(0, 0), (1, 1), (1, 0), (0, 1)]
>>> for path in curvecrust.reconstruct(points).paths:
...     print(path.closed, path.indices)
True [0 2 1 3]

`reconstruct` finds the curves that points come from, open and closed, `order` sorts points along
one curve, and `fit` fits smooth curves to points that scatter. `sample` goes the other way, from a
curve to the few samples that it can be reconstructed from. No parameter is needed; options
take what you know of the curves.

Points are whatever numpy takes as an array of shape (n, 2): arrays, lists of pairs, complex
numbers, data frames of two columns; also points of shapely and geopandas. Lengths are in the unit
of the points, indices are rows of what was given. The y axis may point up or down.

The methods are those of S. Ohrhallinger, S. A. Mitchell, M. Wimmer, "Curve Reconstruction with Many
Fewer Samples", SGP 2016, its relatives, and least detour, the default, which is of this project.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from ._curvecrust import __version__

if TYPE_CHECKING:
    from ._compare import Evaluation, compare, evaluate
    from ._curve import Check, Curve, Lfs, MedialAxis, Samples, check, lfs, medial_axis, sample
    from ._fit import Fit, FittedCurve, fit
    from ._methods import Method, methods
    from ._reconstruct import find_curve_path, order, reconstruct
    from ._reconstruction import Path, Reasons, Reconstruction, Violations

__all__ = [
    "Check",
    "Curve",
    "Evaluation",
    "Fit",
    "FittedCurve",
    "Lfs",
    "MedialAxis",
    "Method",
    "Path",
    "Reasons",
    "Reconstruction",
    "Samples",
    "Violations",
    "__version__",
    "check",
    "compare",
    "evaluate",
    "find_curve_path",
    "fit",
    "lfs",
    "medial_axis",
    "methods",
    "order",
    "reconstruct",
    "sample",
]

_MODULES = {
    "_compare": ("Evaluation", "compare", "evaluate"),
    "_curve": (
        "Check",
        "Curve",
        "Lfs",
        "MedialAxis",
        "Samples",
        "check",
        "lfs",
        "medial_axis",
        "sample",
    ),
    "_fit": ("Fit", "FittedCurve", "fit"),
    "_methods": ("Method", "methods"),
    "_reconstruct": ("find_curve_path", "order", "reconstruct"),
    "_reconstruction": ("Path", "Reasons", "Reconstruction", "Violations"),
}
_MODULE_OF = {name: module for module, names in _MODULES.items() for name in names}


def __getattr__(name: str) -> Any:
    """Load a name when it is first used: numpy takes longer to load than all of this package."""
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_MODULE_OF[name]}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
