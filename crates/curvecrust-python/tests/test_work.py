"""Threads, signals, processes and memory."""

import concurrent.futures
import gc
import multiprocessing
import os
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import curvecrust

UNIFORM = np.random.default_rng(5).random((20_000, 2))


def test_eight_threads_at_once_find_what_one_finds():
    parts = [UNIFORM[i::8] for i in range(8)]
    alone = [curvecrust.reconstruct(part).edges.tobytes() for part in parts]
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        for _ in range(3):
            together = pool.map(lambda part: curvecrust.reconstruct(part).edges.tobytes(), parts)
            assert list(together) == alone


def test_threads_change_nothing():
    edges = {curvecrust.reconstruct(UNIFORM, threads=n).edges.tobytes() for n in (None, 1, 2, 5)}
    assert len(edges) == 1


def test_other_threads_run_meanwhile():
    ticks = []
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        done = pool.submit(curvecrust.reconstruct, UNIFORM)
        while not done.done():
            ticks.append(time.perf_counter())
            time.sleep(0.001)
    assert len(ticks) > 10


def edges_of_uniform(_):
    return curvecrust.reconstruct(UNIFORM[:3000]).edges.tobytes()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only where processes fork")
@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_a_forked_process_works():
    expected = edges_of_uniform(0)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(edges_of_uniform, range(4)).get(timeout=60) == [expected] * 4


LONG = """
import numpy as np, curvecrust, time
points = np.random.default_rng(1).random((2_000_000, 2))
print("ready", flush=True)
start = time.perf_counter()
try:
    {call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    # What goes on would take processor time, of which sleeping takes none. On a busy machine the
    # threads need a moment to hear of it; the work itself would take longer than all of these.
    def is_quiet():
        before = time.process_time()
        time.sleep(0.5)
        return time.process_time() - before < 0.1
    print(any(is_quiet() for _ in range(6)), flush=True)
"""
WAVE = '"M 0 0" + " q .5 1 1 0 q .5 -1 1 0" * 50_000'
CALLS = [
    "curvecrust.reconstruct(points)",
    "curvecrust.reconstruct(points, method='crust')",
    "curvecrust.order(points[:100_000], closed=True)",
    f"curvecrust.sample(curvecrust.Curve.from_path({WAVE}), rho=0.3)",
]


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent to a process of its own")
@pytest.mark.parametrize("call", CALLS)
def test_ctrl_c_ends_the_work(call):
    command = [sys.executable, "-c", LONG.format(call=call)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "ready\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        said, _ = process.communicate(timeout=60)
    assert said.split() == ["interrupted", "True"]


def test_what_listens_may_end_the_work():
    from curvecrust import _curvecrust

    def listener(done, total):
        raise RuntimeError(f"{done} of {total}")

    arguments = {"method": "least-detour", "closed": None, "curves": None, "termini": []}
    arguments.update(merge_within=None, threads=None)
    points = np.random.default_rng(1).random((200_000, 2))
    with pytest.raises(RuntimeError, match="0 of 0"):
        _curvecrust.reconstruct(points, arguments, listener)


def test_progress_changes_nothing():
    plain = curvecrust.reconstruct(UNIFORM).edges.tobytes()
    assert curvecrust.reconstruct(UNIFORM, progress=True).edges.tobytes() == plain


def test_references_are_given_back():
    points = UNIFORM[:100].copy()
    curvecrust.reconstruct(points)
    gc.collect()
    before = sys.getrefcount(points)
    for _ in range(50):
        found = curvecrust.reconstruct(points)
        found.paths, found.reasons, found.violations  # noqa: B018
        with pytest.raises(ValueError, match="no method"):
            curvecrust.reconstruct(points, method="none")
    del found
    gc.collect()
    assert sys.getrefcount(points) == before


@pytest.mark.skipif(not pathlib.Path("/proc/self/statm").exists(), reason="only on Linux")
def test_memory_is_given_back():
    def pages():
        gc.collect()
        return int(pathlib.Path("/proc/self/statm").read_text().split()[1])

    for _ in range(20):
        curvecrust.reconstruct(UNIFORM, method="hnn-crust")
    before = pages()
    for _ in range(200):
        curvecrust.reconstruct(UNIFORM, method="hnn-crust")
    # 200 results are 150 MB.
    assert pages() - before < 40_000_000 / 4096
