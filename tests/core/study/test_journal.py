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


@pytest.mark.shows("files.journal")
def test_that_finished_runs_come_back_digit_for_digit(tmp_path):
    path = tmp_path / "c.journal"
    filled(path)
    book = Journal(path, KEY, True)
    assert [book.get(f"run{k}")["q"] for k in range(6)] == [1.25 + k for k in range(6)] and book.dropped == 0
    book.remove()
    assert not path.exists()


@pytest.mark.shows("files.journal")
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
        assert all(whole[name] == book.get(name) for name in book.places)
        lost = 6 - len(book.places)
        assert lost <= 2 or kind in (1, 2)  # two where the mutation took or made a line end
        held = {name: book.get(name) for name in book.places}
        book.close()
        again = Journal(path, KEY, True)  # what was damaged is gone, what was whole is there
        assert {name: again.get(name) for name in again.places} == held and again.dropped == 0
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
    assert len(again.places) == 800 and again.dropped == 0
    again.close()


def test_that_a_second_batch_on_the_same_output_is_refused(tmp_path):
    first = Journal(tmp_path / "c.journal", KEY, False)
    first.add("run0", {"q": 1.0})
    with pytest.raises(OutputError, match="another batch is writing"):
        Journal(tmp_path / "c.journal", KEY, True)
    first.add("run1", {"q": 2.0})
    first.close()
    book = Journal(tmp_path / "c.journal", KEY, True)
    assert set(book.places) == {"run0", "run1"}
    book.close()


def test_that_what_a_kill_left_of_the_first_line_is_a_journal_still(tmp_path):
    path = tmp_path / "c.journal"
    for content in (b"", b'{"Riba', b'{"Ribalta journal": "0.3'):
        path.write_bytes(content)
        Journal(path, KEY, True).close()
        assert json.loads(path.read_bytes()) == {"Ribalta journal": KEY}


def test_that_a_head_without_its_line_end_is_written_again(tmp_path):
    """What a full disk leaves of the first line may be all of it but its end."""
    path = tmp_path / "c.journal"
    path.write_bytes(json.dumps({"Ribalta journal": KEY}).encode())
    filled(path, 3, resume=True)
    again = Journal(path, KEY, True)
    assert len(again.places) == 3 and again.dropped == 0
    again.close()


def test_that_a_line_that_could_not_be_written_whole_is_taken_back(tmp_path):
    path = tmp_path / "c.journal"
    journal = Journal(path, KEY, False)
    journal.add("run0", {"q": 1.0})
    real = journal._stream

    class Full:
        """A disk that takes ten bytes more."""

        def __getattr__(self, name):
            return getattr(real, name)

        def write(self, content):
            if self.taken:
                raise OSError(28, "No space left on device")
            self.taken = True
            return real.write(content[:10])

        taken = False

    journal._stream = Full()
    with pytest.raises(OutputError, match="No space left"):
        journal.add("run1", {"q": 2.0})
    journal._stream = real
    journal.add("run2", {"q": 3.0})
    journal.close()
    again = Journal(path, KEY, True)
    assert sorted(again.places) == ["run0", "run2"] and again.dropped == 0
    again.close()


# rows of groups of a large case


def grouped(path, key="k", groups=3):
    book = Journal(path, key, False)
    for g in range(groups):
        book.add(g, {"q": [1.0 / (g + 3), None, "è"]})
    book.close()
    return path.read_bytes()


def test_that_rows_come_back_bit_for_bit(tmp_path):
    path = tmp_path / "c.journal"
    grouped(path)
    book = Journal(path, "k", True)
    assert [g in book for g in range(4)] == [True, True, True, False] and book.dropped == 0
    assert book.get(1) == {"q": [0.25, None, "è"]} and book.get(0)["q"][0] == 1.0 / 3.0
    book.add(3, {"q": [2.0]})
    assert book.get(3) == {"q": [2.0]} and book.get(2)["q"][0] == 0.2
    book.remove()
    assert not path.exists()


def test_that_a_line_a_kill_cut_off_is_made_again(tmp_path):
    path = tmp_path / "c.journal"
    content = grouped(path)
    for end in range(len(content) - 40, len(content)):
        path.write_bytes(content[:end])
        book = Journal(path, "k", True)
        assert sorted(book.places) == ["0", "1"] and book.dropped == 0
        book.add(2, {"q": []})
        book.close()
        assert path.read_bytes().count(b"\n") == 4


def test_that_a_damaged_line_is_dropped_and_the_others_stay(tmp_path):
    path = tmp_path / "c.journal"
    path.write_bytes(grouped(path).replace(b"0.25", b"0.26"))
    book = Journal(path, "k", True)
    assert sorted(book.places) == ["0", "2"] and book.dropped == 1
    book.close()


@pytest.mark.parametrize("key, resume", [("k", False), ("other", True)])
def test_that_what_is_not_resumed_is_set_aside(tmp_path, key, resume):
    path = tmp_path / "c.journal"
    content = grouped(path)
    for name in ("c.journal.old", "c.journal.old2"):
        book = Journal(path, key, resume)
        assert not book.places and book.set_aside == tmp_path / name and book.set_aside.read_bytes() == content
        book.close()
        path.write_bytes(content)


def test_that_the_file_of_another_is_left_alone(tmp_path):
    path = tmp_path / "c.journal"
    for content in (b"mine\n", b"mine"):
        path.write_bytes(content)
        with pytest.raises(OutputError) as caught:
            Journal(path, "k", False)
        assert caught.value.code == "not_a_journal" and path.read_bytes() == content


def test_that_a_folder_is_no_journal_and_a_second_batch_is_refused(tmp_path):
    path = tmp_path / "c.journal"
    book = Journal(path, "k", False)
    with pytest.raises(OutputError) as caught:
        Journal(path, "k", True)
    assert caught.value.code == "batch_running"
    book.close()
    with pytest.raises(OutputError):
        Journal(tmp_path, "k", False)
