"""A case in parts, and on other processes, is the undivided run, bit for bit."""

import os
import random
import shutil
import signal
import subprocess
import sys
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest
from distributed import Client, LocalCluster

from app.terminal import batch, case_run
from core.case.reader import read_case
from core.errors import InputError
from core.report import json_report
from core.setting.plan import make_plan, read_inputs
from core.study.case_parts import open_parts, part_path
from core.study.progress import task_costs
from core.study.run import journal_key, run
from core.study.scheduler import OWN_SERVER
from tests.conftest import ROOT

CASE = """
[generate]
scatter = 0
count = 3
[analysis]
q_step = 0.1
[demand]
ag_g = 0.22
[demand.spectrum]
code = "EN1998"
type = 1
soil = "B"
"""


@pytest.fixture(scope="module")
def case(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("parts")
    walls = []
    for k in range(5):
        walls.append(
            f'[[wall]]\nname = "w{k}"\nheight_m = {3.0 + 0.7 * k}\nthickness_m = 0.4\nbase_z_m = 0.0\n'
            f'mechanism = "{("one_sided", "two_sided")[k % 2]}"\n'
        )
    path = folder / "five.toml"
    path.write_text(CASE + "\n".join(walls))
    return path


def timeless(result) -> dict:
    found = json_report.results(result)
    return {key: value for key, value in found.items() if key not in ("started_utc", "elapsed_s")}


@pytest.fixture(scope="module")
def whole(case):
    return timeless(run(read_case(case), base_dir=case.parent, jobs=2))


@pytest.mark.shows("batch.part")
@pytest.mark.parametrize("n", [3, *(pytest.param(n, marks=pytest.mark.long) for n in (1, 7))])
def test_that_parts_in_any_order_and_number_are_the_undivided_run(case, whole, tmp_path, n):
    order = list(range(1, n + 1))
    random.Random(n).shuffle(order)
    for k in order:
        assert batch.run_part(case, tmp_path, 1, True, k, n) == batch.DONE
    asked = read_case(case)
    book = open_parts(tmp_path, "five", asked, journal_key())
    before = dict(book.found)
    result = run(asked, base_dir=case.parent, journal=lambda key: book)
    assert timeless(result) == whole and book.found == before  # nothing was searched again
    assert batch.run(case, tmp_path, 1, True, False, merge=True) == batch.DONE
    assert (tmp_path / "five.xlsx").exists() and part_path(tmp_path, "five", 1, n).exists()


def test_that_a_part_that_was_stopped_goes_on(case, tmp_path):
    batch.run_part(case, tmp_path, 1, True, 1, 2)
    path = part_path(tmp_path, "five", 1, 2)
    whole = path.read_bytes()
    path.write_bytes(b"\n".join(whole.split(b"\n")[:-6]) + b"\n")
    with pytest.raises(InputError) as caught:
        open_parts(tmp_path, "five", read_case(case), journal_key())
    assert caught.value.code == "part_not_finished"
    batch.run_part(case, tmp_path, 1, True, 1, 2)
    assert sorted(path.read_bytes().split(b"\n")) == sorted(whole.split(b"\n"))


@pytest.mark.shows("batch.part")
def test_that_a_part_that_does_not_belong_is_refused(case, tmp_path):
    asked, key = read_case(case), journal_key()

    def refused(code, **changes):
        with pytest.raises(InputError) as caught:
            open_parts(tmp_path, "five", changes.get("case", asked), changes.get("key", key))
        assert caught.value.code == code
        assert "{" not in caught.value.text("en") + caught.value.text("it")

    refused("no_parts")
    for k in (1, 2):
        batch.run_part(case, tmp_path, 1, True, k, 2)
    refused("part_of_another", key="another program")
    whole = part_path(tmp_path, "five", 1, 2).read_bytes()
    lines = whole.split(b"\n")
    lines[1] = lines[1][:-9] + b"~" + lines[1][-8:]
    part_path(tmp_path, "five", 1, 2).write_bytes(b"\n".join(lines))
    refused("part_damaged")
    part_path(tmp_path, "five", 1, 2).write_bytes(whole)
    other = case.with_name("other.toml")
    other.write_text(case.read_text().replace("0.22", "0.23"))
    refused("part_of_another", case=read_case(other))
    part_path(tmp_path, "five", 3, 3).write_bytes(part_path(tmp_path, "five", 1, 2).read_bytes())
    refused("parts_of_two_divisions")
    part_path(tmp_path, "five", 3, 3).unlink()
    part_path(tmp_path, "five", 2, 2).write_text("no journal")
    refused("part_of_another")
    part_path(tmp_path, "five", 2, 2).unlink()
    refused("part_missing")


def test_that_more_walls_than_a_workbook_holds_are_refused_before_the_first_analysis(case):
    asked = read_case(case)
    many = replace(asked, wall=tuple(replace(asked.wall[0], name=f"w{k}") for k in range(10_001)))
    for share in (None, (0, 4)):
        with pytest.raises(InputError) as caught:
            run(many, base_dir=case.parent, share=share)
        assert caught.value.code == "too_many_walls" and "10001" in caught.value.text("en")


class Losing(Executor):
    """Runs every task at once, and loses the second one as a killed process does."""

    def __init__(self):
        self.tasks = 0

    def submit(self, task, /, *arguments, **named):
        self.tasks += 1
        future: Future = Future()
        if self.tasks == 2:
            future.set_exception(RuntimeError("a process ended"))
        else:
            future.set_result(task(*arguments, **named))
        return future


@pytest.mark.shows("batch.part")
@pytest.mark.parametrize("kind", ["threads", "processes", "one is lost"])
def test_that_walls_on_an_executor_are_the_undivided_run(case, whole, kind):
    pool = {"threads": lambda: ThreadPoolExecutor(2), "processes": lambda: ProcessPoolExecutor(2)}.get(kind, Losing)()
    with pool:
        assert timeless(run(read_case(case), base_dir=case.parent, executor=pool)) == whole


@pytest.mark.shows("batch.part")
def test_that_a_process_that_is_killed_loses_no_result(case, whole):
    with ProcessPoolExecutor(2) as pool:
        pool.submit(os._exit, 1)
        assert timeless(run(read_case(case), base_dir=case.parent, executor=pool)) == whole


class Killing(Executor):
    """Hands tasks on, and kills a process with the last of them."""

    def __init__(self, pool: Executor, tasks: int, process: int):
        self.pool, self.left, self.process = pool, tasks, process

    def submit(self, task, /, *arguments, **named):
        future = self.pool.submit(task, *arguments, **named)
        self.left -= 1
        if self.left == 0:
            os.kill(self.process, signal.SIGTERM)
        return future


@pytest.mark.long  # that a lost process loses no result is held above, by executors that cost no start
def test_that_two_workers_of_dask_are_the_undivided_run_though_one_is_killed(case, whole):
    with (
        LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=OWN_SERVER) as cluster,
        Client(cluster) as client,
    ):
        process = next(iter(client.run(os.getpid).values()))
        pool = Killing(client.get_executor(), 5, process)
        assert timeless(run(read_case(case), base_dir=case.parent, executor=pool)) == whole
        assert process not in client.run(os.getpid).values()


STARTERS = {"parallel": ("parallel", "-j2"), "xargs": ("xargs", "-P", "2", "-I{}")}
"""Programs that only start others, as scale.md has them."""


@pytest.mark.long
@pytest.mark.parametrize("starter", ["xargs", "parallel"])
def test_that_a_scheduler_that_only_starts_programs_makes_the_parts(case, whole, tmp_path, starter):
    if not shutil.which(starter):
        pytest.skip(f"no {starter}")
    part = [
        sys.executable,
        "-P",
        "-m",
        "app",
        "--batch",
        str(case),
        "--quiet",
        "--jobs",
        "1",
        "--output",
        str(tmp_path),
    ]
    command = [*STARTERS[starter], *part, "--part", "{}/3"]
    variables = {**os.environ, "PYTHONPATH": str(ROOT)}
    subprocess.run(command, input="1\n2\n3\n", text=True, check=True, cwd=ROOT, env=variables)
    book = open_parts(tmp_path, "five", read_case(case), journal_key())
    assert timeless(run(read_case(case), base_dir=case.parent, journal=lambda key: book)) == whole


def test_that_what_the_user_can_mend_comes_back_from_a_worker(case):
    asked = read_case(case)
    path = case.with_name("missing.toml")
    path.write_text(case.read_text() + '\n[[record]]\nfile = "nowhere.AT2"\n')
    with ThreadPoolExecutor(1) as pool, pytest.raises(InputError):
        run(read_case(path), base_dir=path.parent, executor=pool)
    assert asked.wall


def test_that_parts_of_a_shipped_case_land_where_its_results_do(case):
    shipped = case_run.EXAMPLES / "verdict.toml"
    assert batch.results_of(shipped, None) == (Path(), "verdict")
    assert batch.results_of(case, None) == (case.parent, "five")
    assert batch.results_of(shipped, case.parent) == (case.parent, "verdict")


def test_that_the_statement_of_accuracy_is_made_where_the_parts_come_together(case):
    asked = read_case(case)
    asked = replace(asked, analysis=replace(asked.analysis, accuracy=True))
    inputs = read_inputs(asked, case.parent)
    stated = [("accuracy", 0) in task_costs(make_plan(asked, inputs, share)) for share in (None, (0, 2))]
    assert stated == [True, False]
