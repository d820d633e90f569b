"""Walls of a study on other processes and machines: tasks handed to an executor, and what they find taken as it comes
(resources/docs/scale.md)."""

import contextlib
import functools
import hashlib
import platform
from collections.abc import Callable, Hashable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

from core.case.schema import Case
from core.case.wall import Wall
from core.codes.spectrum_codes import CODES
from core.errors import Cancelled, InputError, place
from core.file_names import name_of
from core.jit import native
from core.regular_file import read_regular
from core.setting.demand_input import MAX_SPECTRUM_BYTES
from core.setting.plan import Inputs, Plan, make_plan, read_inputs
from core.study.journal import journal_key
from core.study.scheduler import DaskExecutor

MAX_TASKS_AHEAD = 256
"""Tasks an executor holds at a time; a `DaskExecutor` says it by its workers."""


def files_key(case: Case, base_dir: Path, inputs: Inputs) -> str:
    """Key of what a case reads: its records, the file of its spectrum, the annex that makes it.

    base_dir : folder record paths start from
    inputs : of `read_inputs`
    """
    _, motions, kinds = inputs
    spectrum, asked = b"", case.demand.spectrum if case.demand else None
    annex = CODES[asked.code].digest if asked else ""
    if case.demand and case.demand.spectrum_file:
        spectrum = read_regular(base_dir / name_of(case.demand.spectrum_file), MAX_SPECTRUM_BYTES)
    read = [(repr(m), m.samples_sha256, m.warnings, m.details, kind) for m, kind in zip(motions, kinds, strict=True)]
    return hashlib.sha256(repr((read, hashlib.sha256(spectrum).hexdigest(), annex)).encode()).hexdigest()


@functools.cache
def program_fingerprint() -> str:
    """This program, the state of its sources, and the packages its numbers are made with."""
    packages = (f"{name} {metadata.version(name)}" for name in ("numba", "numpy"))
    return ", ".join([journal_key(), f"Python {platform.python_version()}", *packages])


class TaskContext(NamedTuple):
    """What the tasks of a study have in common, sent with each of them.

    case : without walls, its records chosen
    base_dir : folder record paths start from, absolute
    longest : period of the mechanisms of all walls [s]; None where a wall alone is a task
    files, program : `files_key` and `program_fingerprint` of the process that hands out
    """

    case: Case
    base_dir: Path
    longest: float | None
    files: str
    program: str


def make_task_context(case: Case, base_dir: Path, inputs: Inputs, longest: float | None) -> TaskContext:
    """What the tasks of a case have in common. case : its records chosen; inputs, longest : as in Shared"""
    bare = replace(case, wall=(), source="", table_notes=(), files=())
    return TaskContext(bare, base_dir.absolute(), longest, files_key(case, base_dir, inputs), program_fingerprint())


_read: dict[TaskContext, Inputs] = {}
"""Inputs of the last study that this process, working for an executor, took a task of."""


def make_remote_plan(shared: TaskContext, walls: tuple[Wall, ...]) -> Plan:
    """The plan of a task. Raises InputError where this process has another program or other files than the one that
    hands out."""
    if program_fingerprint() != shared.program:
        raise InputError(
            "worker_of_another", worker=platform.node(), found=program_fingerprint(), expected=shared.program
        )
    native.ready()
    inputs = _read.get(shared)
    if inputs is None:
        try:
            inputs = read_inputs(shared.case, shared.base_dir)
        except InputError as error:
            raise error.at(place("worker", name=platform.node())) from None
        if files_key(shared.case, shared.base_dir, inputs) != shared.files:
            raise InputError("worker_other_files", worker=platform.node(), path=shared.base_dir)
        _read.clear()
        _read[shared] = inputs
    return make_plan(replace(shared.case, wall=walls), inputs, None, shared.longest)


def iterate_results(
    executor: Executor, task: Callable, arguments: Iterable[tuple[Hashable, tuple]], cancelled: Callable[[], bool]
) -> Iterator[tuple[Any, Any]]:
    """(key, what the task returned) as the tasks come back, in any order; None for one that was lost with its process.

    arguments : (key, arguments) of each task, of which no more are made than are handed out
    Raises Cancelled, and InputError where a task does; what is still handed out then is taken back.
    """
    waiting, flying = iter(arguments), dict[Future, Hashable]()
    try:
        while True:
            while len(flying) < _room(executor) and (one := next(waiting, None)) is not None:
                key, given = one
                flying[_handed(executor, task, given)] = key
                if cancelled():
                    raise Cancelled
            if not flying:
                return
            done, _ = wait(flying, 0.1, FIRST_COMPLETED)
            if cancelled():
                raise Cancelled
            for future in [one for one in flying if one in done]:
                yield flying.pop(future), _returned(future)
    finally:
        for future in flying:
            future.cancel()


def _room(executor: Executor) -> int:
    return executor.room() if isinstance(executor, DaskExecutor) else MAX_TASKS_AHEAD


def _handed(executor: Executor, task: Callable, given: tuple) -> Future:
    """The future of a task; of one that cannot be handed out any more it is lost."""
    try:
        return executor.submit(task, *given)
    except BrokenExecutor as error:
        lost: Future = Future()
        lost.set_exception(error)
        return lost


def _returned(future: Future) -> Any:
    """What a task returned; None where it was lost, or failed: done here, it fails here. Raises InputError."""
    with contextlib.suppress(CancelledError):
        error = future.exception()
        if isinstance(error, InputError):
            raise error
        if error is None:
            return future.result()
    return None


def make_waiter(arrivals: Iterator[int]) -> Callable[[int], None]:
    """A function that returns once a number has arrived. arrivals : numbers, in any order"""
    come: set[int] = set()

    def wait_for(number: int) -> None:
        while number not in come:
            come.add(next(arrivals))

    return wait_for
