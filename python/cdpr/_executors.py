"""Work in parts, on any executor: threads, processes or a Dask cluster."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from typing import Any, TypeAlias, TypeVar

from ._arrays import shown
from ._given import function
from .exceptions import InputError

Progress: TypeAlias = Callable[[int, int], object]
Answer = TypeVar("Answer")

# Number of parts given to an executor: many more than workers, so that no worker waits long for the last part.
_PARTS = 64
# Time between two checks for Ctrl-C, s.
_PATIENCE = 0.05


def check(executor: Executor | None, progress: Progress | None) -> None:
    """Check that an executor and a function for progress, if given, are what they should be."""
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError(f"executor: found {shown(executor)}, expected an executor of concurrent.futures or Dask")
    function("progress", progress)


def ranges(first: int, end: int) -> list[tuple[int, int]]:
    """Divide a range of numbers into parts for an executor."""
    size = -(-(end - first) // _PARTS)
    return [(start, min(start + size, end)) for start in range(first, end, max(size, 1))]


def gathered(
    executor: Executor,
    work: Callable[..., Answer],
    parts: Sequence[tuple[Any, ...]],
    sizes: Sequence[int],
    progress: Progress | None,
    interrupted: Sequence[Answer] = (),
) -> list[Answer]:
    """Call `work` with the arguments of each part in the workers, and return the answers in order.

    `progress` is called with the sizes of what is done and of all. After Ctrl-C, waiting parts are cancelled; what is not done
    then has the answer in `interrupted`, if there is one for each part.
    """
    futures: list[Future[Answer]] = [executor.submit(work, *part) for part in parts]
    waiting = set(futures)
    try:
        while waiting:
            done, waiting = wait(waiting, _PATIENCE, FIRST_COMPLETED)
            for part in done:
                part.result()
            if done and progress is not None:
                progress(sum(size for part, size in zip(futures, sizes, strict=True) if part not in waiting), sum(sizes))
    except KeyboardInterrupt:
        if not interrupted:
            raise
        whole = [part.done() and not part.cancelled() and part.exception() is None for part in futures]
        return [part.result() if ok else instead for part, ok, instead in zip(futures, whole, interrupted, strict=True)]
    finally:
        for part in waiting:
            part.cancel()
    return [part.result() for part in futures]
