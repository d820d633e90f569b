"""Independent work on threads: the kernels hold no lock, results do not depend on the number of threads."""

import contextlib
import queue
import threading
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

from core.errors import Cancelled


class Threads:
    """jobs : threads
    cancelled : asked from the calling thread and, through `stop`, from the workers
    """

    def __init__(self, jobs: int, cancelled: Callable[[], bool]):
        self.jobs, self.cancelled = max(1, jobs), cancelled

    def run(self, tasks: Mapping[Any, Callable], on_result: Callable[[Any, Any], None]) -> dict:
        """Results by key of `task(stop)`; on_result(key, result) from the calling thread.

        Raises Cancelled within 0.1 s of a cancel and a task's stop, and whatever a task raises.
        """
        results, ended = {}, threading.Event()
        # not `wait`, which looks at each of thousands of futures every time
        done = queue.SimpleQueue()

        def stop() -> bool:
            return ended.is_set() or self.cancelled()

        with ThreadPoolExecutor(self.jobs) as pool:
            waiting = {pool.submit(task, stop): key for key, task in tasks.items()}
            try:
                for future in list(waiting):
                    future.add_done_callback(done.put)
                while len(results) < len(tasks):
                    future = None
                    with contextlib.suppress(queue.Empty):
                        future = done.get(timeout=0.1)
                    if future is not None:
                        key = waiting.pop(future)
                        results[key] = future.result()
                        on_result(key, results[key])
                    if self.cancelled():
                        raise Cancelled
            finally:
                ended.set()
                for future in waiting:
                    future.cancel()
        return results
