"""The journal: lines that prove themselves, a file that is nobody else's, one batch at a time."""

import json
import random
import threading

import pytest

from core.errors import OutputError
from core.study.journal import Journal

KEY = "0.3.0 abc"


def filled(path, runs=6, resume=False):
    book = Journal(path, KEY, resume)
    for k in range(runs):
        book.add(f"run{k}", {"status": "collapse_found", "q": 1.25 + k, "analyses": 3, "outcomes": "001"})
    book.close()
    return path.read_bytes()


def test_that_finished_runs_come_back_digit_for_digit(tmp_path):
    path = tmp_path / "c.journal"
    filled(path)
    book = Journal(path, KEY, True)
    assert [book.get(f"run{k}")["q"] for k in range(6)] == [1.25 + k for k in range(6)] and book.dropped == 0
    book.remove()
    assert not path.exists()


@pytest.mark.parametrize("count", [200, pytest.param(1500, marks=pytest.mark.long)])
def test_that_no_mutation_of_a_byte_changes_a_result(tmp_path, count):
    """Each line is whole or run again: bits flipped, bytes cut out, lines doubled, exchanged, cut."""
    path = tmp_path / "c.journal"
    content, chance = filled(path), random.Random(1)
    whole = {json.loads(line)["run"]: json.loads(line)["result"] for line in content.splitlines()[1:]}
    head = content.index(b"\n") + 1
    for k in range(count):
        changed, place = bytearray(content), chance.randrange(head, len(content))
        kind = k % 4
        if kind == 0:
            changed[place] ^= 1 << chance.randrange(8)
        elif kind == 1:
            del changed[place : place + chance.randrange(1, 40)]
        elif kind == 2:
            del changed[place:]
        else:
            changed[place:place] = bytes(chance.randrange(256) for _ in range(chance.randrange(1, 9)))
        path.write_bytes(changed)
        book = Journal(path, KEY, True)
        assert all(whole[name] == result for name, result in book.found.items())
        lost = 6 - len(book.found)
        assert lost <= 2 or kind in (1, 2)  # two where the mutation took or made a line end
        book.close()
        again = Journal(path, KEY, True)  # what was damaged is gone, what was whole is there
        assert again.found == book.found and again.dropped == 0
        again.close()


def test_that_a_line_of_another_study_is_not_taken(tmp_path):
    path = tmp_path / "c.journal"
    content = filled(path)
    line = json.dumps({"run": "run9", "result": {"q": 9.0}, "hash": "0" * 16}).encode()
    path.write_bytes(content + line + b"\n")
    book = Journal(path, KEY, True)
    assert book.get("run9") is None and book.dropped == 1
    book.close()


@pytest.mark.parametrize("content", [b"my notes\n", b"{}", b'{"journalx": 1}\n', b"\x00\x01", b" "])
def test_that_a_file_of_somebody_else_is_never_touched(tmp_path, content):
    path = tmp_path / "c.journal"
    path.write_bytes(content)
    with pytest.raises(OutputError, match="not a journal of Ribalta"):
        Journal(path, KEY, False)
    assert path.read_bytes() == content


def test_that_what_is_set_aside_takes_no_place_of_another_file(tmp_path):
    path = tmp_path / "c.journal"
    content = filled(path)
    (tmp_path / "c.journal.old").write_bytes(b"mine")
    book = Journal(path, KEY, False)
    assert book.set_aside.name == "c.journal.old2" and book.set_aside.read_bytes() == content
    assert (tmp_path / "c.journal.old").read_bytes() == b"mine"
    book.close()


def test_that_no_journal_that_was_set_aside_is_written_over(tmp_path):
    """Killed after fifteen runs, then after three, then after one: each of them is there still."""
    path, kept = tmp_path / "c.journal", []
    for runs in (15, 3, 1):
        kept.append(filled(path, runs))
    Journal(path, KEY, False).close()
    names = ("c.journal.old", "c.journal.old2", "c.journal.old3")
    assert [(tmp_path / name).read_bytes() for name in names] == kept


def test_that_several_threads_add_whole_lines(tmp_path):
    book = Journal(tmp_path / "c.journal", KEY, False, sync_seconds=60.0)

    def add(first: int) -> None:
        for k in range(200):
            book.add(f"{first} {k}", {"q": "x" * 3000})

    threads = [threading.Thread(target=add, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    book.close()
    again = Journal(tmp_path / "c.journal", KEY, True)
    assert len(again.found) == 800 and again.dropped == 0
    again.close()


def test_that_a_second_batch_on_the_same_output_is_refused(tmp_path):
    first = Journal(tmp_path / "c.journal", KEY, False)
    first.add("run0", {"q": 1.0})
    with pytest.raises(OutputError, match="another batch is writing"):
        Journal(tmp_path / "c.journal", KEY, True)
    first.add("run1", {"q": 2.0})
    first.close()
    book = Journal(tmp_path / "c.journal", KEY, True)
    assert set(book.found) == {"run0", "run1"}
    book.close()


def test_that_what_a_kill_left_of_the_first_line_is_a_journal_still(tmp_path):
    path = tmp_path / "c.journal"
    for content in (b"", b'{"Riba', b'{"Ribalta journal": "0.3'):
        path.write_bytes(content)
        Journal(path, KEY, True).close()
        assert json.loads(path.read_bytes()) == {"Ribalta journal": KEY}
