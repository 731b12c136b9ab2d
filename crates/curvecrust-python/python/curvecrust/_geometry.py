"""Curves as geometries of other packages."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import geopandas
    import shapely

    from ._reconstruction import Path, Reconstruction


def lines(found: Reconstruction) -> list[shapely.LineString]:
    """Return a LinearRing or a LineString for each curve."""
    import shapely

    return [
        shapely.LinearRing(path.points) if path.closed else shapely.LineString(path.points)
        for path in found.paths
    ]


def rings(found: Reconstruction) -> list[tuple[Path, list[Path]]]:
    """Return each outer ring with the rings of its holes."""
    paths = found.paths
    holes: dict[int, list[Path]] = {
        i: [] for i, path in enumerate(paths) if path.nesting is not None and path.nesting % 2 == 0
    }
    for path in paths:
        if path.nesting is not None and path.nesting % 2 == 1 and path.parent is not None:
            holes[path.parent].append(path)
    return [(paths[i], inner) for i, inner in holes.items()]


def polygons(found: Reconstruction) -> list[shapely.Polygon]:
    """Return closed curves as polygons with holes."""
    import shapely

    return [
        shapely.Polygon(outer.points, [hole.points for hole in inner])
        for outer, inner in rings(found)
    ]


def frame(found: Reconstruction, crs: Any) -> geopandas.GeoDataFrame:
    """Return polygons with holes, then open curves."""
    import geopandas
    import shapely

    opened = [path for path in found.paths if not path.closed]
    shapes = [*polygons(found), *(shapely.LineString(path.points) for path in opened)]
    counts = [len(outer) + sum(map(len, inner)) for outer, inner in rings(found)]
    columns = {
        "closed": [True] * len(counts) + [False] * len(opened),
        "points": counts + [len(path) for path in opened],
    }
    return geopandas.GeoDataFrame(columns, geometry=shapes, crs=crs)


def wkt(found: Reconstruction) -> str:
    """Return polygons with holes and open curves as one collection."""

    def coordinates(path: Path) -> str:
        points = path.points.tolist()
        closing = points[:1] if path.closed else []
        return "(" + ", ".join(f"{_number(x)} {_number(y)}" for x, y in points + closing) + ")"

    shapes = [
        "POLYGON (" + ", ".join(map(coordinates, [outer, *inner])) + ")"
        for outer, inner in rings(found)
    ]
    shapes += ["LINESTRING " + coordinates(path) for path in found.paths if not path.closed]
    return f"GEOMETRYCOLLECTION ({', '.join(shapes)})" if shapes else "GEOMETRYCOLLECTION EMPTY"


def _number(value: float) -> str:
    """Return the shortest text that reads back as the same number."""
    return repr(int(value)) if value.is_integer() and abs(value) < 2**53 else repr(value)
