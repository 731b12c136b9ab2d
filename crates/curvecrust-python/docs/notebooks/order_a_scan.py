# %% [markdown]
# # Put the points of a scan in order
#
# A contour was measured point by point, and the file holds the points in the order of some
# database. We want the outline.

# %%
import numpy as np

import curvecrust

rng = np.random.default_rng(7)
turn = np.sort(rng.uniform(0, 2 * np.pi, 220))
radius = 40 + 6 * np.sin(3 * turn) + 3 * np.cos(7 * turn)
scan = np.column_stack((radius * np.cos(turn), radius * np.sin(turn)))
scan = rng.permutation(scan)
scan[:3]

# %% [markdown]
# `order` returns the rows in the order of the curve that goes through all of them.

# %%
rows = curvecrust.order(scan, closed=True)
outline = scan[rows]
outline[:3]

# %% [markdown]
# The length of the outline and the area inside are sums over its points.

# %%
steps = np.diff(outline, axis=0, append=outline[:1])
length = np.hypot(*steps.T).sum()
x, y = outline.T
area = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() / 2
print(f"length {length:.1f}, area {area:.1f}")
assert area > 0  # A closed curve runs counter-clockwise.

# %% [markdown]
# If nobody knows whether it is one curve, `reconstruct` finds out. It shows itself as a picture.

# %%
found = curvecrust.reconstruct(scan)
found

# %%
print(found, found.paths[0])

# %% [markdown]
# Two measurements of one place are an error, which names both rows. `merge_within` takes points
# that are nearer than a length for one.

# %%
twice = np.vstack((scan, scan[5] + 1e-7))
merged = curvecrust.reconstruct(twice, merge_within=1e-3)
print(merged, merged.duplicates.tolist())
assert len(merged.duplicates) == 1
