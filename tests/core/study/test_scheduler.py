"""Walls on the workers of a scheduler of Dask are the undivided run, and what goes wrong there is a sentence."""

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections import Counter
from concurrent.futures import Executor, Future, ThreadPoolExecutor

import psutil
import pytest
from distributed import LocalCluster
from distributed.scheduler import KilledWorker

from app.look.language import set_language
from app.terminal import batch, command_line, large_batch
from core.case.reader import read_case
from core.errors import Cancelled, InputError
from core.ground.artificial import filtered_noise
from core.report.columns import columns_of
from core.setting import plan
from core.setting.plan import read_inputs
from core.study import executors, large_case, scheduler
from core.study.executors import iterate_results, make_remote_plan, make_task_context
from core.study.run import run_wall_task
from core.study.scheduler import OWN_SERVER, DaskExecutor, open_dask_executor
from tests.conftest import ROOT
from tests.core.study.cases import DEMAND

CASE = f"""
[[record]]
file = "short.txt"
unit = "m/s2"
time_step_s = 0.01
kind = "artificial"
[analysis]
q_step = 0.05
{DEMAND}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """few.toml has three walls, many.toml the same and three more as a table."""
    place = tmp_path_factory.mktemp("scheduled")
    samples = filtered_noise(1, 2.0)[200:500]
    (place / "short.txt").write_text("\n".join(f"{value:.5f}" for value in samples))
    keys = ("name", "height_m", "thickness_m", "base_z_m", "mechanism")
    rows = [(f"w{k}", 3.0 + 0.6 * k, 0.4, 0.0, ("one_sided", "two_sided")[k % 2]) for k in range(6)]
    (place / "walls.csv").write_text("\n".join([";".join(keys), ";m;m;m;", *(";".join(map(str, row)) for row in rows)]))
    (place / "many.toml").write_text(f'walls = "walls.csv"\n{CASE}')
    given = [dict(zip(keys, row, strict=True)) for row in rows[:3]]
    walls = ["[[wall]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in one.items()) for one in given]
    (place / "few.toml").write_text(CASE + "".join(walls))
    return place


@pytest.fixture(scope="module")
def address():
    """Address of a scheduler whose worker is within this process: in the other tests here, it is of a process of its
    own."""
    with LocalCluster(
        n_workers=1, threads_per_worker=2, processes=False, protocol="tcp://", dashboard_address=OWN_SERVER
    ) as cluster:
        yield cluster.scheduler_address


@pytest.fixture
def few(monkeypatch):
    """So few walls are many, in groups of two."""
    monkeypatch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 3)
    monkeypatch.setattr(large_case, "MAX_GROUP", 2)


def timeless(path) -> dict:
    found = json.loads(path.read_text())
    return {key: value for key, value in found.items() if key not in ("started_utc", "elapsed_s")}


@pytest.fixture(scope="module")
def whole(folder):
    """Folder of the files of the undivided runs."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 3)
        patch.setattr(large_case, "MAX_GROUP", 2)
        assert batch.run(folder / "few.toml", folder / "whole", 1, True, False) == batch.DONE
        assert batch.run(folder / "many.toml", folder / "whole", 1, True, False) == batch.DONE
    return folder / "whole"


def equal(made, whole) -> None:
    """The files of a large case are the same, byte for byte."""
    for name in ("many.parquet", "many.json"):
        assert (made / name).read_bytes() == (whole / name).read_bytes()


@pytest.mark.shows("batch.scheduler")
def test_that_walls_on_a_scheduler_are_the_undivided_run(folder, whole, address, tmp_path, capsys):
    assert batch.run(folder / "few.toml", tmp_path, 1, False, False, scheduler=address) == batch.DONE
    assert timeless(tmp_path / "few.json") == timeless(whole / "few.json")
    assert (tmp_path / "few.xlsx").exists() and not (tmp_path / "few.journal").exists()
    assert "w2" in capsys.readouterr().out


@pytest.mark.shows("batch.scheduler")
def test_that_the_table_of_many_walls_is_the_same_byte_for_byte(folder, whole, address, tmp_path, few):
    assert batch.run(folder / "many.toml", tmp_path, 1, True, False, scheduler=address) == batch.DONE
    equal(tmp_path, whole)


class Counting(Executor):
    """Runs each task at once, some of them not at all, and counts them by their names.

    lost : numbers of the tasks that are lost with their process
    stop : told of each number
    """

    def __init__(self, lost=(), stop=lambda number: None):
        self.lost, self.stop, self.tasks, self.number = lost, stop, Counter(), 0

    def submit(self, task, /, *arguments, **named):
        self.number, future = self.number + 1, Future()
        self.tasks[task.__name__] += 1
        self.stop(self.number)
        if self.number in self.lost:
            future.set_exception(RuntimeError("a process ended"))
        else:
            future.set_result(task(*arguments, **named))
        return future


def use(monkeypatch, executor) -> None:
    """Let --scheduler be this executor."""
    given = contextlib.nullcontext(executor)
    monkeypatch.setattr(batch, "executor_of", lambda word: given)
    monkeypatch.setattr(large_batch, "executor_of", lambda word: given)


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize("name, task, walls", [("few", "run_wall_task", 3), ("many", "run_group_task", 3)])
def test_that_ctrl_c_keeps_what_came_and_a_resume_hands_out_the_rest(
    folder, whole, tmp_path, few, monkeypatch, capsys, name, task, walls
):
    """The third task is not done: Ctrl-C is pressed when it is handed out."""
    monkeypatch.setattr(executors, "MAX_TASKS_AHEAD", 1)
    pressed = Counting(stop=lambda number: number == 3 and signal.raise_signal(signal.SIGINT))
    use(monkeypatch, pressed)
    case = folder / f"{name}.toml"
    assert batch.run(case, tmp_path, 1, True, False, scheduler="tcp://h:1") == 130
    assert "--resume" in capsys.readouterr().err
    assert [path.name for path in tmp_path.iterdir()] == [f"{name}.journal"]
    again = Counting()
    use(monkeypatch, again)
    assert batch.run(case, tmp_path, 1, True, True, scheduler="tcp://h:1") == batch.DONE
    assert pressed.tasks[task] == 3 and again.tasks[task] == walls - 2
    if name == "few":
        assert timeless(tmp_path / "few.json") == timeless(whole / "few.json")
    else:
        equal(tmp_path, whole)


@pytest.mark.shows("batch.scheduler")
def test_that_a_lost_worker_costs_its_group(folder, whole, tmp_path, few, monkeypatch):
    pool, made = Counting(lost=(2,)), []
    use(monkeypatch, pool)

    def here(large, todo, *rest):
        made.extend(todo)
        return large_case.group_results(large, todo, *rest)

    monkeypatch.setattr(large_batch, "group_results", here)
    assert batch.run(folder / "many.toml", tmp_path, 1, True, False, scheduler="tcp://h:1") == batch.DONE
    assert made == [1] and pool.tasks["run_group_task"] == 3
    equal(tmp_path, whole)


def test_that_a_run_without_a_scheduler_goes_on_with_what_one_made(folder, whole, tmp_path, few, monkeypatch):
    use(monkeypatch, Counting(stop=lambda number: number == 3 and signal.raise_signal(signal.SIGINT)))
    monkeypatch.setattr(executors, "MAX_TASKS_AHEAD", 1)
    assert batch.run(folder / "many.toml", tmp_path, 1, True, False, scheduler="tcp://h:1") == 130
    monkeypatch.undo()
    monkeypatch.setattr(plan, "MAX_WALLS_IN_WORKBOOK", 3)
    monkeypatch.setattr(large_case, "MAX_GROUP", 2)
    assert batch.run(folder / "many.toml", tmp_path, 1, True, True) == batch.DONE
    equal(tmp_path, whole)


def test_that_searches_of_a_run_without_a_scheduler_are_not_made_again(folder):
    """It left those of a wall in its journal, but not all of its checks."""
    case = read_case(folder / "few.toml")
    shared = make_task_context(case, folder, read_inputs(case, folder), None)
    found, analyses = run_wall_task(shared, case.wall[0], {})
    known = {name: result for name, result in found.items() if "outcomes" in result}
    again, fewer = run_wall_task(shared, case.wall[0], known)
    assert known and again == {k: v for k, v in found.items() if k not in known} and fewer < analyses


def test_that_rows_are_written_as_they_come_and_only_in_the_journal_before(folder, tmp_path, few, monkeypatch):
    """The second group comes last: the table has the first, and waits."""
    seen = []
    real = large_batch.parquet_file.write

    def watched(stream, groups, metadata):
        def told():
            for rows in groups:
                seen.append((rows["wall"], (tmp_path / "many.journal").read_bytes().count(b"\n") - 1))
                yield rows

        real(stream, told(), metadata)

    def reordered(large, todo, *arguments):
        found = dict(large_case.run_groups_remotely(large, todo, *arguments))
        yield from ((g, found[g]) for g in (0, 2, 1))

    monkeypatch.setattr(large_batch.parquet_file, "write", watched)
    monkeypatch.setattr(large_batch, "run_groups_remotely", reordered)
    use(monkeypatch, Counting())
    assert batch.run(folder / "many.toml", tmp_path, 1, True, False, scheduler="tcp://h:1") == batch.DONE
    assert seen == [([1, 2], 1), ([3, 4], 3), ([5, 6], 3)]


def test_that_progress_counts_groups_as_they_come(folder, few):
    case = read_case(folder / "many.toml")
    large, told = large_case.prepare_large_case(case, folder), []
    groups = large_case.run_groups_remotely(large, [1, 2], Counting(), columns_of, lambda *one: told.append(one))
    assert [g for g, _ in groups] == [1, 2]
    assert [done for done, _, _ in told] == [large.tasks[0] + large.tasks[1], sum(large.tasks)]
    assert told[-1][1:] == (sum(large.tasks), 0.0)


def test_that_no_more_is_handed_out_than_there_is_room_and_the_rest_is_taken_back(monkeypatch):
    monkeypatch.setattr(executors, "MAX_TASKS_AHEAD", 3)
    free, made, stop = threading.Event(), [], threading.Event()

    def arguments():
        for k in range(100):
            made.append(k)
            yield k, ()

    with ThreadPoolExecutor(1) as pool:
        results = iterate_results(pool, free.wait, arguments(), stop.is_set)
        threading.Timer(0.2, stop.set).start()
        with pytest.raises(Cancelled):
            next(results)
        free.set()
    assert made == [0, 1, 2]


@pytest.mark.parametrize("threads, room", [(0, scheduler.MIN_ROOM), (1000, 2000)])
def test_that_what_is_handed_out_goes_with_the_workers(threads, room):
    client = type("Client", (), {"get_executor": lambda self, pure: None, "nthreads": lambda self: {"a": threads}})()
    assert DaskExecutor(client, "tcp://h:1").room() == room


def refused(code, folder, tmp_path, word, name="few.toml"):
    """The sentence of what ends a batch, which leaves no result."""
    with pytest.raises(InputError) as caught:
        batch.run(folder / name, tmp_path / "new", 1, True, False, scheduler=word)
    assert caught.value.code == code
    assert not [path for path in (tmp_path / "new").glob("*") if path.suffix != ".journal"]
    for language in ("en", "it"):
        text = caught.value.text(language)
        assert "\n" not in text and "{" not in text
    return caught.value.text()


@pytest.mark.shows("batch.scheduler")
def test_that_an_address_without_a_scheduler_is_refused(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(scheduler, "CONNECT_SECONDS", 0.3)
    with socket.socket() as closed, socket.socket() as other:
        closed.bind(("127.0.0.1", 0))
        other.bind(("127.0.0.1", 0))
        other.listen()  # answers, but is no scheduler
        for one in (closed, other):
            word = f"tcp://127.0.0.1:{one.getsockname()[1]}"
            assert f"no scheduler of Dask can be used at {word}" in refused("no_scheduler", folder, tmp_path, word)
    assert not (tmp_path / "new").exists()


def test_that_a_missing_package_is_refused_before_the_run(folder, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert "a scheduler of Dask needs distributed" in refused("packages_missing", folder, tmp_path, "local:2")


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize("name", ["few.toml", "many.toml"])
def test_that_a_worker_of_another_program_or_other_files_is_refused(folder, tmp_path, few, monkeypatch, address, name):
    for changed, code in (({"program": "0.1 abc"}, "worker_of_another"), ({"files": "0"}, "worker_other_files")):

        def shared(*arguments, changed=changed):
            return make_task_context(*arguments)._replace(**changed)

        monkeypatch.setattr("core.study.run.make_task_context", shared)
        monkeypatch.setattr(large_case, "make_task_context", shared)
        refused(code, folder, tmp_path, address, name)


def test_that_a_worker_that_does_not_see_a_record_is_named(folder, tmp_path):
    case = read_case(folder / "few.toml")
    shared = make_task_context(case, folder, read_inputs(case, folder), None)
    with pytest.raises(InputError) as caught:
        make_remote_plan(shared._replace(base_dir=tmp_path), case.wall[:1])
    assert caught.value.text().startswith("worker ") and "short.txt" in caught.value.text()


class Ending(Executor):
    """An executor whose futures end with an error."""

    def __init__(self, error):
        self.error = error

    def submit(self, task, /, *arguments, **named):
        future: Future = Future()
        if self.error is None:
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            future.set_exception(self.error)
        return future


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize(
    "error, code",
    [
        (KilledWorker("task", type("Worker", (), {"address": "tcp://h:1"})(), 3), "worker_lost_often"),
        (ModuleNotFoundError("No module named 'core'"), "worker_without_program"),
        (None, "scheduler_lost"),
    ],
)
def test_that_what_a_scheduler_gives_up_ends_the_run_with_a_sentence(folder, tmp_path, monkeypatch, error, code):
    client = type("Client", (), {"get_executor": lambda self, pure: Ending(error), "nthreads": lambda self: {"a": 1}})()
    use(monkeypatch, DaskExecutor(client, "tcp://h:1"))
    text = refused(code, folder, tmp_path, "tcp://h:1")
    assert "tcp://h:1" in text or "workers ended" in text


def test_that_a_scheduler_that_goes_away_ends_the_run(folder):
    def gone(self):
        raise OSError("closed")

    client = type("Client", (), {"get_executor": lambda self, pure: None, "nthreads": gone})()
    with pytest.raises(InputError) as caught:
        list(iterate_results(DaskExecutor(client, "tcp://h:1"), os.getpid, [(0, ())], lambda: False))
    assert caught.value.code == "scheduler_lost"


def test_that_waiting_for_the_first_worker_is_said(folder, monkeypatch, capsys):
    from app.terminal import case_run

    client = type("Client", (), {"get_executor": lambda self, pure: None, "nthreads": lambda self: {}})()
    monkeypatch.setattr(case_run, "open_dask_executor", lambda word: contextlib.nullcontext(DaskExecutor(client, word)))
    with case_run.executor_of("tcp://h:1"):
        assert "tcp://h:1 has no worker yet" in capsys.readouterr().err


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize(
    "word", ["local:0", "local:1025", "local:x", "tcp://h", "tcp://h:0", "tcp://h:65536", "h:8786"]
)
def test_that_another_word_than_an_address_or_a_number_of_processes_is_wrong_usage(word, capsys):
    with pytest.raises(SystemExit) as caught:
        command_line.parse(["--batch", "case.toml", "--scheduler", word])
    assert caught.value.code == 2 and f"'{word}' is neither a scheduler such as" in capsys.readouterr().err


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize(
    "words", [["--study", "paper"], ["--batch", "c", "--part", "1/2"], ["--batch", "c", "--merge"], ["case.toml"]]
)
def test_that_a_scheduler_goes_with_a_whole_batch(words, capsys):
    for language, said in (("en", "--scheduler goes with --batch"), ("it", "--scheduler va con --batch")):
        set_language(language)
        try:
            with pytest.raises(SystemExit) as caught:
                command_line.parse([*words, "--scheduler", "local:2"])
        finally:
            set_language("en")
        assert caught.value.code == 2 and said in capsys.readouterr().err


PROGRAM = """
import sys
from core.setting import plan
from core.study import large_case
plan.MAX_WALLS_IN_WORKBOOK, large_case.MAX_GROUP = 3, 2
from app.__main__ import main
sys.exit(main(["--batch", *sys.argv[1:]]))
"""
"""The program, for which the case of many walls is a large one."""


@contextlib.contextmanager
def started(*words):
    """The program in a group of processes of its own."""
    command = [sys.executable, "-P", "-c", PROGRAM, *map(str, words)]
    variables, kept = {**os.environ, "PYTHONPATH": str(ROOT)}, subprocess.PIPE
    with subprocess.Popen(
        command, env=variables, stdout=kept, stderr=subprocess.STDOUT, text=True, start_new_session=True
    ) as process:
        try:
            yield process
        finally:
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGKILL)


def ended(process, code) -> str:
    """What a program said, that ends with this code."""
    said, _ = process.communicate(timeout=300)
    assert process.returncode == code, said
    return said


def workers_of(process) -> list[int]:
    """Processes of the workers of a cluster that a process started."""
    children = psutil.Process(process.pid).children()
    return [one.pid for one in children if "multiprocessing.spawn" in " ".join(one.cmdline())]


def waited(path, lines) -> None:
    end = time.monotonic() + 120.0
    while not path.exists() or path.read_bytes().count(b"\n") < lines:
        assert time.monotonic() < end, "the journal does not grow"
        time.sleep(0.01)


@contextlib.contextmanager
def half_way(case, folder):
    """A program whose two workers have done some of a case, and its workers."""
    with started(case, "--output", folder, "--scheduler", "local:2") as process:
        waited(folder / "many.journal", 4)
        yield process, workers_of(process)


@pytest.fixture(scope="module")
def longer(folder):
    """The case of many walls, of sixty, and the folder of its undivided run."""
    rows = [f"w{k};{3.0 + 0.1 * k:.1f};0.4;0.0;{('one_sided', 'two_sided')[k % 2]}" for k in range(60)]
    head = (folder / "walls.csv").read_text().splitlines()[:2]
    (folder / "sixty.csv").write_text("\n".join([*head, *rows]))
    (folder / "sixty").mkdir()
    case = folder / "sixty" / "many.toml"
    case.write_text((folder / "many.toml").read_text().replace("walls.csv", "../sixty.csv").replace("sh", "../sh", 1))
    with started(case, "--output", folder / "sixty" / "whole", "--quiet") as process:
        ended(process, batch.DONE)
    return case, folder / "sixty" / "whole"


@pytest.mark.long
@pytest.mark.shows("batch.scheduler")
@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_that_a_worker_that_is_killed_changes_no_byte(longer, tmp_path):
    case, whole = longer
    with half_way(case, tmp_path) as (process, workers):
        os.kill(workers[0], signal.SIGKILL)
        ended(process, batch.DONE)
    assert len(workers) == 2
    equal(tmp_path, whole)


@pytest.mark.long
@pytest.mark.shows("batch.scheduler")
@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_that_ctrl_c_ends_the_workers_too_and_a_resume_makes_the_same_bytes(longer, tmp_path):
    case, whole = longer
    with half_way(case, tmp_path) as (process, workers):
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        said = ended(process, 130)
    assert "--resume" in said and "Traceback" not in said and len(workers) == 2
    for number in workers:
        with pytest.raises(ProcessLookupError):
            os.kill(number, 0)
    assert [path.name for path in tmp_path.iterdir()] == ["many.journal"]
    with started(case, "--output", tmp_path, "--scheduler", "local:2", "--resume") as process:
        ended(process, batch.DONE)
    equal(tmp_path, whole)


@pytest.mark.long
@pytest.mark.shows("batch.scheduler")
def test_that_a_task_that_ends_its_workers_is_given_up_with_a_sentence():
    with open_dask_executor("local:2") as executor, pytest.raises(InputError) as caught:
        list(iterate_results(executor, os._exit, [(0, (1,))], lambda: False))
    assert caught.value.code == "worker_lost_often" and "4 workers ended" in caught.value.text()


@pytest.mark.shows("batch.scheduler")
def test_that_what_starts_here_listens_to_this_machine_alone_and_takes_no_port_of_another():
    """Dask's own choice is a server for everybody on port 8787."""
    with socket.socket() as taken:
        with contextlib.suppress(OSError):  # somebody else has it already
            taken.bind(("127.0.0.1", 8787))
            taken.listen()
        with open_dask_executor("local:1") as made:
            assert made.threads() == 1
            here = psutil.Process()
            processes = here, *here.children(recursive=True)
            open_to = {
                one.laddr.ip for process in processes for one in process.net_connections("tcp4") if not one.raddr
            }
    assert open_to == {"127.0.0.1"}


@pytest.mark.shows("batch.scheduler")
@pytest.mark.parametrize("how", ["plain", "own certificate"])
def test_that_a_strangers_process_runs_no_code_on_the_workers_of_a_run(how):
    """Whoever is logged in to this machine reaches its ports: a scheduler of Dask runs what it is sent."""
    from distributed import Client, Security

    with open_dask_executor("local:1") as made:
        address = made._client.scheduler.address
        assert address.startswith("tls://127.0.0.1:")
        stranger = {"security": Security.temporary()} if how == "own certificate" else {}
        address = address if stranger else address.replace("tls://", "tcp://")
        with pytest.raises((OSError, TypeError, ValueError)):
            Client(address, timeout=2.0, set_as_default=False, **stranger)
        assert made.submit(sum, (1, 2)).result() == 3
