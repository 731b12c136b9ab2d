# %% [markdown]
# # Sample a drawing
#
# A curve needs few samples where it is plain and many where it is fine. How few suffice is what
# "Curve Reconstruction with Many Fewer Samples" (SGP 2016) is about.

# %%
import matplotlib.pyplot as plt
import numpy as np
import pandas

import curvecrust

curve = curvecrust.Curve.from_path(
    "M 10 60 C 10 10 60 10 80 40 S 150 80 160 40 S 200 10 210 60 S 170 120 120 100 "
    "S 90 80 70 100 S 10 110 10 60 Z"
)
curve

# %% [markdown]
# The local feature size is the distance to the medial axis.

# %%
measured = curvecrust.lfs(curve)
axis = curvecrust.medial_axis(curve)
fig, ax = plt.subplots()
dots = ax.scatter(*measured.points.T, c=measured.lfs, s=3, clip_on=False)
near = np.abs(axis.starts).max(1) < 300
ax.plot(*np.stack((axis.starts[near], axis.ends[near]), 1).T, color="silver", linewidth=0.5)
ax.set(aspect="equal", xlim=(0, 220), ylim=(130, 0))
_ = fig.colorbar(dots, label="local feature size")
# %% [markdown]
# Samples for three conditions. All of them can be reconstructed; the last are the fewest.

# %%
sampled = {
    "epsilon < 1/3": curvecrust.sample(curve, epsilon=1 / 3),
    "epsilon < 0.47": curvecrust.sample(curve, epsilon=0.47),
    "rho < 0.9": curvecrust.sample(curve, rho=0.9),
}
fig, axes = plt.subplots(3, 1, figsize=(6, 10))
for ax, (name, samples) in zip(axes, sampled.items(), strict=True):
    shuffled = np.random.default_rng(1).permutation(samples.points)
    found = curvecrust.reconstruct(shuffled)
    assert curvecrust.evaluate(curve, shuffled, found).metrics["exact"] == 1
    found.plot(ax)
    ax.set(title=f"{name}: {len(samples)} samples", aspect="equal")
    ax.invert_yaxis()

# %%
pandas.DataFrame(curvecrust.compare(curve, rho=0.9)).set_index("method")[
    ["edges", "closed", "open", "exact", "hausdorff_curve"]
]
