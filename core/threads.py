"""Independent work on threads: the kernels hold no lock, results do not depend on the number of threads."""

import contextlib
import heapq
import itertools
import queue
import threading
from collections.abc import Callable, Generator, Iterable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, NamedTuple

from core.errors import Cancelled

TASKS_PER_THREAD = 2
"""Tasks of a thread that it is handed: the one it does, and the next."""


def nothing(key: Any, result: Any) -> None:
    """Do nothing: for tasks whose results need not be told one by one."""


class Batch(NamedTuple):
    """Tasks that do not wait for each other.

    tasks : `task(stop)` by key
    on_result : called from the calling thread with the key and the result of each
    """

    tasks: Mapping[Any, Callable]
    on_result: Callable[[Any, Any], None] = nothing


Work = Generator[Batch, dict, Any]
"""Work that needs tasks done: it yields a Batch, is sent their results by key, and returns its own."""


class Threads:
    """jobs : threads
    cancelled : asked from the calling thread and, through `stop`, from the workers
    """

    def __init__(self, jobs: int, cancelled: Callable[[], bool]):
        self.jobs, self.cancelled = max(1, jobs), cancelled

    def run(self, tasks: Mapping[Any, Callable], on_result: Callable[[Any, Any], None] = nothing) -> dict:
        """Results by key of `task(stop)`; the parameters are those of a Batch. Raises as `run_works` does."""

        def work() -> Work:
            return (yield Batch(tasks, on_result))

        results: list[dict] = []
        self.run_works([work()], results.append)
        return results[0]

    def run_works(self, works: Iterable[Work], on_end: Callable[[Any], None]) -> None:
        """Carry works out side by side, the tasks of the first ones first, each begun when threads would be idle.
        on_end : called from the calling thread with what each returns, in their order

        What a task raises is thrown into its work, which may end with another result. Raises Cancelled within 0.1 s of
        a cancel, a task's stop and what runs in this thread, and whatever a work raises.
        """
        ended, done = threading.Event(), queue.SimpleQueue()
        with ThreadPoolExecutor(self.jobs) as pool:
            under_way = _UnderWay(works, on_end, self.cancelled)
            flying: dict[Future, tuple[int, Any]] = {}
            try:
                while True:
                    while (
                        len(flying) < TASKS_PER_THREAD * self.jobs and (upcoming := under_way.next_task()) is not None
                    ):
                        number, key, task = upcoming
                        future = pool.submit(task, lambda: ended.is_set() or self.cancelled())
                        flying[future] = number, key
                        future.add_done_callback(done.put)
                    if not flying:
                        return
                    ready = None
                    with contextlib.suppress(queue.Empty):
                        ready = done.get(timeout=0.1)
                    if ready is not None:
                        under_way.take(*flying.pop(ready), ready)
                    if self.cancelled():
                        raise Cancelled
            finally:
                ended.set()
                for future in flying:
                    future.cancel()


class _UnderWay:
    """Works that are begun and not ended. works, on_end : of `run_works`; cancelled : of Threads"""

    def __init__(self, works: Iterable[Work], on_end: Callable[[Any], None], cancelled: Callable[[], bool]):
        self._works, self._on_end, self._cancelled = enumerate(works), on_end, cancelled
        self._waiting: list[tuple[int, int, Any, Callable]] = []
        self._counted = itertools.count()
        self._open: dict[int, tuple[Work, Batch, dict]] = {}
        self._ended: dict[int, Any] = {}
        self._told = 0

    def next_task(self) -> tuple[int, Any, Callable] | None:
        """(number of its work, key, task) of the next task, of a work begun for it if need be; None where none is left
        that waits for no other."""
        while self._waiting and self._waiting[0][0] not in self._open:  # of a work that an error ended
            heapq.heappop(self._waiting)
        while not self._waiting:
            begun = next(self._works, None)
            if begun is None:
                return None
            if self._cancelled():
                raise Cancelled
            self._send(*begun, None)
        number, _, key, task = heapq.heappop(self._waiting)
        return number, key, task

    def take(self, number: int, key: Any, done: Future) -> None:
        """The result of a task that is done, or what it raised."""
        if number not in self._open:
            return
        work, batch, results = self._open[number]
        if (error := done.exception()) is not None:
            self._send(number, work, None, error)
            return
        results[key] = done.result()
        batch.on_result(key, results[key])
        if len(results) == len(batch.tasks):
            self._send(number, work, results)

    def _send(self, number: int, work: Work, results: Any, error: BaseException | None = None) -> None:
        """Go on with a work to its next tasks, or its end. results : None to begin with; error : of one of its tasks,
        after which it has no more of them"""
        self._open.pop(number, None)
        try:
            batch = work.send(results) if error is None else work.throw(error)
            while not batch.tasks:
                batch = work.send({})
        except StopIteration as end:
            self._ended[number] = end.value
        else:
            self._open[number] = work, batch, {}
            for key, task in batch.tasks.items():
                heapq.heappush(self._waiting, (number, next(self._counted), key, task))
        # outside of the except, so that an error does not carry the results of the work
        while self._told in self._ended:
            self._told += 1
            self._on_end(self._ended.pop(self._told - 1))
