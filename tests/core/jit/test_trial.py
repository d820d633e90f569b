"""Shipped machine code on trial until its numbers are right: kept, given up, or tried again."""

import os
import subprocess
import sys
import threading

import pytest

from core import atomic_write
from core.jit import trial

HASH = "0123456789abcdef" + 48 * "0"


@pytest.fixture
def start(tmp_path, monkeypatch):
    """A start of the program, in one process after another: whether it may use the machine code."""
    monkeypatch.setattr(trial, "self_test", [])

    def one_more(digest=HASH):
        monkeypatch.setattr(trial, "_begun", [])
        monkeypatch.setattr(trial, "failed", [])
        return trial.begin(tmp_path, digest)

    return one_more


def files(folder):
    return sorted(file.name for file in folder.iterdir())


def process_that_ended():
    done = subprocess.Popen([sys.executable, "-c", ""])
    done.wait()
    return done.pid


@pytest.mark.shows("install.machine_code")
def test_that_machine_code_is_kept_once_its_numbers_are_right(start, tmp_path):
    assert start()
    trial.self_test.append(lambda: True)
    assert trial.passed() and files(tmp_path) == ["passed-0123456789abcdef"]
    assert start()
    trial.self_test.append(lambda: pytest.fail("a second trial"))
    assert trial.passed()
    assert start("f" * 64)  # another library, of the same sources
    assert len(files(tmp_path)) == 2


@pytest.mark.shows("install.machine_code")
def test_that_wrong_numbers_are_not_used_nor_ever_again(start):
    assert start()
    trial.self_test.append(lambda: False)
    assert not trial.passed() and not trial.passed()
    assert not start() and not start()


def begun(folder, number, machine=None):
    """The file of a process in its trial."""
    path = folder / f"trial-0123456789abcdef-{machine or atomic_write.machine()}-{number}"
    path.touch()
    return path


def test_that_one_process_that_ended_in_its_trial_does_not_condemn_it_and_two_do(start, tmp_path):
    begun(tmp_path, process_that_ended())  # killed
    assert start()
    trial.withdraw()
    begun(tmp_path, process_that_ended(), "another-machine")
    old = begun(tmp_path, process_that_ended())
    os.utime(old, (1e9, 1e9))
    assert start()  # of processes elsewhere nothing is known; one of years ago says nothing
    trial.withdraw()
    begun(tmp_path, process_that_ended())
    assert not start()


def test_that_starts_at_once_each_have_their_trial(start, tmp_path):
    assert start()
    begun(tmp_path, os.getppid())  # alive
    assert start()
    trial.self_test.append(lambda: True)
    assert trial.passed()
    assert files(tmp_path)[0] == "passed-0123456789abcdef" and len(files(tmp_path)) == 2


def test_that_a_process_that_ends_leaves_the_verdict_of_another(start, tmp_path):
    assert start()
    (tmp_path / "wrong-0123456789abcdef").touch()  # of another one meanwhile
    trial.withdraw()
    assert files(tmp_path) == ["wrong-0123456789abcdef"] and not start()


def test_that_a_self_test_that_raises_is_wrong(start):
    assert start()
    trial.self_test.append(lambda: 1 // 0)
    assert not trial.passed() and not trial.passed() and not start()


def test_that_a_process_without_its_trial_leaves_nothing(start, tmp_path):
    assert start()
    trial.withdraw()
    assert files(tmp_path) == [] and not trial._begun


def test_that_a_trial_begun_by_one_thread_is_waited_for_by_the_others(start):
    assert start()
    inside, go_on, passed = threading.Event(), threading.Event(), []

    def slow():
        inside.set()
        assert trial.passed()  # the self-test's own kernels ask again
        assert go_on.wait(20)
        return True

    trial.self_test.append(slow)
    threads = [threading.Thread(target=lambda: passed.append(trial.passed())) for _ in range(4)]
    for thread in threads:
        thread.start()
    assert inside.wait(20) and not passed
    go_on.set()
    for thread in threads:
        thread.join()
    assert passed == [True] * 4


def test_that_a_cache_that_cannot_be_written_has_its_trial_each_time(start, tmp_path, monkeypatch):
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    for _ in range(2):
        monkeypatch.setattr(trial, "_begun", [])
        assert trial.begin(blocked, HASH)
        trial.self_test.append(lambda: True)
        assert trial.passed() and not trial.self_test
