"""What all tasks of a run know, and the files through which they hand rows to each other.

A file is written under another name and renamed, so it is there completely or not at all; it is the
same whoever writes it. So a task may run twice, and a run that was stopped finds what it had done.
"""

from __future__ import annotations

import contextlib
import posixpath
import uuid
from dataclasses import dataclass
from typing import Any

import fsspec
import numpy as np
from numpy.typing import NDArray

#: Bytes of a word of a row.
WORD = 8


@dataclass(frozen=True)
class Job:
    """What each task gets: its size does not grow with the points."""

    source: str
    target: str
    columns: tuple[str, str]
    method: str
    options: dict[str, Any]
    points: int = 0
    run: str = ""

    def file_system(self) -> tuple[Any, str]:
        """Find the file system of the target, and the path of the target there."""
        found: tuple[Any, str] = fsspec.core.url_to_fs(self.target, **self.options)
        return found

    def work(self, name: str) -> str:
        """Name a file that is there during the run."""
        return posixpath.join(self.file_system()[1], f"_work-{self.run}", name)

    def has(self, name: str) -> bool:
        """Whether a file of the run is there."""
        there: bool = self.file_system()[0].exists(self.work(name))
        return there

    def size(self, name: str) -> int:
        """How many bytes a file of the run has."""
        size: int = self.file_system()[0].size(self.work(name))
        return size

    def put(self, name: str, *chunks: bytes | memoryview) -> None:
        """Write a file of the run, completely or not at all."""
        fs, path = self.file_system()[0], self.work(name)
        part = f"{path}.{uuid.uuid4().hex}"
        with fs.open(part, "wb") as out:
            for chunk in chunks:
                out.write(chunk)
        fs.mv(part, path)

    def get(self, name: str, start: int | None = None, end: int | None = None) -> bytes:
        """Read a file of the run, or some of its bytes."""
        data: bytes = self.file_system()[0].cat_file(self.work(name), start=start, end=end)
        return data

    def put_shares(self, name: str, rows: NDArray[np.uint64], first: NDArray[np.uint64]) -> None:
        """Write rows in shares: share i has the rows from first[i] to first[i + 1]."""
        self.put(name, bytes_of(first.astype(np.uint64)), bytes_of(rows))

    def share(self, name: str, shares: int, number: int, words: int) -> NDArray[np.uint64]:
        """Read one of the shares of a file, whose rows have so many words."""
        first, end = np.frombuffer(self.get(name, number * WORD, (number + 2) * WORD), np.uint64)
        row, behind = words * WORD, (shares + 1) * WORD
        data = b""
        if first < end:
            data = self.get(name, behind + int(first) * row, behind + int(end) * row)
        return np.frombuffer(data, np.uint64).reshape(-1, words)

    def begin(self) -> None:
        """Make the folder of the result; one that holds a result, or anything else, is refused."""
        fs, target = self.file_system()
        # Where this run was stopped while it moved its result, parts of that are there.
        ours = ("_work-", "part-") if self.has("complete") else ("_work-",)
        if fs.exists(target):
            names = [posixpath.basename(path.rstrip("/")) for path in fs.ls(target, detail=False)]
            if not all(name.startswith(ours) for name in names):
                raise FileExistsError(f"{self.target} is there and not empty")
        fs.makedirs(self.work(""), exist_ok=True)

    def deliver(self, names: list[str]) -> None:
        """Move the finished result to its place, and remove all else."""
        fs, target = self.file_system()
        self.put("complete", b"")
        for name in names:
            if self.has(name):
                fs.mv(self.work(name), posixpath.join(target, name))
        self.clean()

    def clean(self) -> None:
        """Remove what the run has left; tasks that still go on after an error may leave some."""
        with contextlib.suppress(OSError):
            self.file_system()[0].rm(self.work("").rstrip("/"), recursive=True)


def bytes_of(array: NDArray[Any]) -> memoryview:
    """View the bytes of an array, as files take them."""
    return np.ascontiguousarray(array).reshape(-1).view(np.uint8).data
