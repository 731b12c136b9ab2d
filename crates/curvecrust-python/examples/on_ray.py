"""Curves through more points than one machine holds, on Ray."""

import pandas as pd
import ray


class Ray:
    """An engine for `curvecrust.tiles.reconstruct`."""

    def map(self, step, items):
        task = ray.remote(step.func)
        return ray.get([task.remote(*step.args, item) for item in items])

    def exchange(self, load, items, empty, act, parts):
        @ray.remote(num_returns=parts)
        def scatter(item):
            frame = load(item)
            found = [frame[frame["goes_to"] == part] for part in range(parts)]
            return found if parts > 1 else found[0]

        @ray.remote
        def gather(part, *frames):
            return act(pd.concat([empty, *frames]) if frames else empty, part)

        moved = [scatter.remote(item) for item in items]
        moved = [frames if parts > 1 else [frames] for frames in moved]
        return ray.get([gather.remote(p, *[frames[p] for frames in moved]) for p in range(parts)])
