"""An executor on the workers of a scheduler of Dask, whose troubles are sentences (resources/docs/scale.md)."""

import asyncio
import contextlib
import functools
import logging
import pickle
import time
from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Executor, Future
from typing import Any

from core.errors import InputError
from core.packages import require

TASKS_PER_THREAD, MIN_ROOM = 2, 64
"""Tasks handed out for a thread of a worker: the one it does, and the next; and at least, so that a cluster that grows
with what waits does so."""

BETWEEN_COUNTS = 5.0
"""Least time between two counts of the workers [s]."""

CONNECT_SECONDS = 10.0
"""Time a scheduler has to answer [s]."""

LOCAL = "local:"
"""How the word for workers of this machine begins."""

OWN_SERVER = "127.0.0.1:0"
"""Where its server of web pages listens, which it has in any case: to this machine alone, on no port of another."""

NO_INTERRUPT = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
"""What a worker of this machine does first: Ctrl-C is for the process that hands out."""


class _Call:
    """What is, once unpickled, the result of a call."""

    def __init__(self, call: Callable):
        self.call = call

    def __reduce__(self):
        return self.call, ()


class DaskExecutor(Executor):
    """Tasks on the workers of a scheduler, which does again what a lost worker was at.

    client : distributed.Client
    address : of the scheduler, for what is said
    """

    def __init__(self, client: Any, address: str):
        self.address = address
        self._client, self._pool = client, client.get_executor(pure=False)
        self._threads, self._counted = 0, -BETWEEN_COUNTS

    def threads(self) -> int:
        """Threads of the workers there are now. Raises InputError where the scheduler does not answer."""
        try:
            return sum(self._client.nthreads().values())
        except (OSError, RuntimeError) as error:
            raise self._lost() from error

    def room(self) -> int:
        """Tasks to be handed out at a time. Raises as `threads` does."""
        if time.monotonic() - self._counted >= BETWEEN_COUNTS:
            self._threads, self._counted = self.threads(), time.monotonic()
        return max(MIN_ROOM, TASKS_PER_THREAD * self._threads)

    def submit(self, task: Callable, /, *arguments, **named) -> Future:
        """The future of a task; of its errors those that a worker or the scheduler are the cause of are InputErrors."""
        # unpickling it is the call: a worker that cannot is told of by its error, and does not lose its stream
        content = pickle.dumps(_Call(functools.partial(task, *arguments, **named)))
        handed, future = self._pool.submit(pickle.loads, content), Future()

        def told(_: Future) -> None:
            if not future.set_running_or_notify_cancel():
                return
            try:
                error = handed.exception()
            except CancelledError:
                error = self._lost()
            if error is None:
                future.set_result(handed.result())
            else:
                future.set_exception(self._worded(error))

        def taken_back(_: Future) -> None:
            if future.cancelled():
                handed.cancel()

        handed.add_done_callback(told)
        future.add_done_callback(taken_back)
        return future

    def _lost(self) -> InputError:
        return InputError("scheduler_lost", address=self.address)

    def _worded(self, error: BaseException) -> BaseException:
        from distributed.scheduler import KilledWorker

        if isinstance(error, KilledWorker):
            times, last = error.allowed_failures + 1, error.last_worker.address
            return InputError("worker_lost_often", times=times, worker=last)
        if isinstance(error, ImportError):
            return InputError("worker_without_program", address=self.address, reason=_reason(error))
        return error


def _reason(error: BaseException) -> str:
    """The first line of an error."""
    return (str(error).strip() or type(error).__name__).splitlines()[0][:200]


@contextlib.contextmanager
def open_dask_executor(word: str) -> Iterator[DaskExecutor]:
    """The executor of a scheduler; at the end its workers go on for others, those of `local:` end.

    word : its address, tcp://host:8786, or local:8 for so many processes of this machine
    Raises InputError where none answers, and OutputError without the packages.
    """
    require("scheduler")
    from distributed import Client, LocalCluster, Security
    from distributed.comm import connect

    async def answer() -> None:
        """Raise OSError where nothing of Dask answers in time, of which the client, once connected, waits forever."""
        how = Security().get_connection_args("client")
        comm = await asyncio.wait_for(connect(word, timeout=CONNECT_SECONDS, **how), CONNECT_SECONDS)
        await comm.close()

    for name in ("distributed", "distributed.client", "tornado"):  # what matters of it is a sentence of ours
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as opened:
        try:
            where: Any = word
            if word.startswith(LOCAL):
                where = LocalCluster(
                    n_workers=int(word.removeprefix(LOCAL)),
                    threads_per_worker=1,
                    memory_limit=None,
                    dashboard_address=OWN_SERVER,
                    silence_logs=logging.CRITICAL,
                    preload=NO_INTERRUPT,
                    protocol="tls://",
                    security=Security.temporary(),  # a certificate of this run: who has it not, runs nothing here
                )
                opened.enter_context(where)
            else:
                asyncio.run(answer())
            client = opened.enter_context(Client(where, timeout=CONNECT_SECONDS, set_as_default=False))
        except (OSError, ValueError, RuntimeError) as error:
            raise InputError("no_scheduler", address=word, reason=_reason(error)) from None
        yield DaskExecutor(client, word)
