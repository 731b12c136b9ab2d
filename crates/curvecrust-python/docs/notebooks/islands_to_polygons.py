# %% [markdown]
# # Coastlines to polygons, with geopandas
#
# Points along the shores of islands and of a lake, without an order, become polygons with holes.

# %%
import geopandas
import numpy as np
import shapely

import curvecrust


def shore(east, north, size, count, seed):
    """Return points along a ragged shore."""
    rng = np.random.default_rng(seed)
    turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
    waves = [
        a * np.cos(k * turn + p)
        for k, a, p in zip(
            range(2, 9), rng.uniform(0, 0.3, 7) / range(2, 9), rng.uniform(0, 6, 7), strict=True
        )
    ]
    radius = size * (1 + sum(waves))
    return np.column_stack((east + radius * np.cos(turn), north + radius * np.sin(turn)))


shores = np.vstack(
    [
        shore(10.0, 54.0, 0.50, 300, 1),
        shore(10.0, 54.0, 0.15, 90, 2),  # A lake.
        shore(11.2, 54.3, 0.30, 180, 3),
        shore(11.0, 53.5, 0.12, 70, 4),
    ]
)
places = geopandas.GeoSeries(
    shapely.points(np.random.default_rng(0).permutation(shores)), crs="EPSG:4326"
)
len(places)

# %% [markdown]
# A series of points is as good as an array.

# %%
found = curvecrust.reconstruct(places)
found

# %%
islands = found.to_geopandas(crs=places.crs)
islands

# %% [markdown]
# The lake is a hole of the large island, by nesting.

# %%
assert [len(polygon.interiors) for polygon in islands.geometry] == [1, 0, 0]
assert islands.is_valid.all()
areas = islands.to_crs("EPSG:3035").area / 1e6
print(areas.round(1).tolist(), "square kilometres")

# %%
_ = islands.plot(edgecolor="black")
