"""Shipped machine code on trial until its numbers are right: kept, given up, or tried again."""

import os
import shutil
import subprocess
import sys
import threading

import pytest

from core.errors import InputError
from core.jit import cache, shipped, trial

FILES = {"a.nbi": b"index", "a.1.nbc": b"machine code"}


@pytest.fixture
def start(tmp_path, monkeypatch):
    """A start of the program, in one process after another: the folder it takes."""
    monkeypatch.setenv("RIBALTA_CACHE", str(tmp_path / "user"))
    monkeypatch.setattr(cache, "name", lambda: "0123456789abcdef-x86-64")
    monkeypatch.setattr(shipped, "level", lambda: "x86-64")
    monkeypatch.setattr(shipped, "whole_files", lambda level: dict(FILES))
    monkeypatch.setattr(cache.atexit, "register", lambda function: None)
    monkeypatch.setattr(trial, "self_test", [])
    make, made = cache.folder.__wrapped__, []

    def one_more():
        monkeypatch.setattr(trial, "_begun", [])
        monkeypatch.setattr(trial, "_failed", [])
        folder = make()
        made.append(folder)
        monkeypatch.setattr(cache, "folder", lambda: folder)
        cache.folder.is_made = lambda: True
        return folder

    yield one_more
    for folder in made:
        shutil.rmtree(folder, ignore_errors=True)


def holds_files(folder):
    return {name: (folder / name).read_bytes() for name in FILES} == FILES


def process_that_ended():
    done = subprocess.Popen([sys.executable, "-c", ""])
    done.wait()
    return done.pid


@pytest.mark.shows("install.machine_code")
def test_that_machine_code_is_kept_once_its_numbers_are_right(start):
    folder = start()
    assert folder.name == "kernels-0123456789abcdef-x86-64" and holds_files(folder)
    trial.self_test.append(lambda: True)
    cache.proven()
    assert not trial.begun() and not trial.under_way(folder)
    trial.self_test.append(lambda: pytest.fail("a second trial"))
    cache.proven()
    cache.close()
    assert start() == folder and not trial.begun()
    cache.proven()


@pytest.mark.shows("install.machine_code")
def test_that_wrong_numbers_refuse_every_kernel_and_are_not_used_again(start):
    folder = start()
    trial.self_test.append(lambda: False)
    for _ in range(2):
        with pytest.raises(InputError, match="machine code"):
            cache.proven()
    cache.close()
    for _ in range(2):
        other = start()
        assert other.name == folder.name + "-own" and not any(other.glob("*.nb*"))
        cache.proven()


def test_that_one_process_that_ended_in_its_trial_does_not_condemn_it_and_two_do(start, monkeypatch):
    folder = start()
    (folder / trial.TRIAL).write_text(f"{process_that_ended()}\n")  # killed
    second = start()
    assert second.name.startswith(cache.TEMPORARY) and holds_files(second) and trial.begun()
    both = (folder / trial.TRIAL).read_text().split()
    assert len(both) == 2 and both[1] == str(os.getpid())
    (folder / trial.TRIAL).write_text(f"{both[0]}\n{process_that_ended()}\n")
    assert start().name == folder.name + "-own"


def test_that_starts_at_once_each_try_a_copy_and_end_with_one_proven_folder(start):
    folder = start()
    first = list(trial._begun)
    second = start()  # the same process number: alive
    assert second != folder and holds_files(second)
    trial.self_test.append(lambda: True)
    cache.proven()
    cache.close()
    assert not second.exists() and not trial.under_way(folder) and holds_files(folder)
    trial._begun[:] = first
    trial.self_test.append(lambda: True)
    trial.pass_it()
    assert start() == folder and not trial.begun()


def test_that_a_process_without_its_trial_leaves_nothing(start):
    folder = start()
    cache.close()
    assert not folder.exists() and not trial.begun()
    assert start() == folder and trial.begun()


def test_that_a_trial_begun_by_one_thread_is_waited_for_by_the_others(start):
    start()
    inside, go_on, passed = threading.Event(), threading.Event(), []

    def slow():
        inside.set()
        cache.proven()  # the self-test's own kernels ask again
        assert go_on.wait(20)
        return True

    trial.self_test.append(slow)
    threads = [threading.Thread(target=lambda: (cache.proven(), passed.append(1))) for _ in range(4)]
    for thread in threads:
        thread.start()
    assert inside.wait(20) and not passed
    go_on.set()
    for thread in threads:
        thread.join()
    assert len(passed) == 4 and not trial.begun()


def test_that_a_cache_without_room_leaves_a_folder_of_the_process(start, tmp_path, monkeypatch):
    write, failed = type(tmp_path).write_bytes, []

    def no_room_at_first(path, content):
        if path.name == "a.1.nbc" and not failed:
            failed.append(path.parent)
            raise OSError(28, "No space left on device")
        return write(path, content)

    monkeypatch.setattr(type(tmp_path), "write_bytes", no_room_at_first)
    folder = start()
    assert folder.name.startswith(cache.TEMPORARY) and not failed[0].exists()
    assert trial.begun() and holds_files(folder)
    cache.close()
    assert not folder.exists()
