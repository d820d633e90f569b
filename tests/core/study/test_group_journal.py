"""The journal of a large case: what is finished stays, what is damaged is made again, nothing of others is touched."""

import pytest

from core.errors import OutputError
from core.study.group_journal import GroupJournal


def filled(path, key="k", groups=3):
    book = GroupJournal(path, key, False)
    for g in range(groups):
        book.add(g, {"q": [1.0 / (g + 3), None, "è"]})
    book.close()
    return path.read_bytes()


def test_that_rows_come_back_bit_for_bit(tmp_path):
    path = tmp_path / "c.journal"
    filled(path)
    book = GroupJournal(path, "k", True)
    assert [g in book for g in range(4)] == [True, True, True, False] and book.dropped == 0
    assert book.get(1) == {"q": [0.25, None, "è"]} and book.get(0)["q"][0] == 1.0 / 3.0
    book.add(3, {"q": [2.0]})
    assert book.get(3) == {"q": [2.0]} and book.get(2)["q"][0] == 0.2
    book.remove()
    assert not path.exists()


def test_that_a_line_a_kill_cut_off_is_made_again(tmp_path):
    path = tmp_path / "c.journal"
    content = filled(path)
    for end in range(len(content) - 40, len(content)):
        path.write_bytes(content[:end])
        book = GroupJournal(path, "k", True)
        assert sorted(book.places) == ["0", "1"] and book.dropped == 0
        book.add(2, {"q": []})
        book.close()
        assert path.read_bytes().count(b"\n") == 4


def test_that_a_damaged_line_is_dropped_and_the_others_stay(tmp_path):
    path = tmp_path / "c.journal"
    path.write_bytes(filled(path).replace(b"0.25", b"0.26"))
    book = GroupJournal(path, "k", True)
    assert sorted(book.places) == ["0", "2"] and book.dropped == 1
    book.close()


@pytest.mark.parametrize("key, resume", [("k", False), ("other", True)])
def test_that_what_is_not_resumed_is_set_aside(tmp_path, key, resume):
    path = tmp_path / "c.journal"
    content = filled(path)
    for name in ("c.journal.old", "c.journal.old2"):
        book = GroupJournal(path, key, resume)
        assert not book.places and book.set_aside == tmp_path / name and book.set_aside.read_bytes() == content
        book.close()
        path.write_bytes(content)


def test_that_the_file_of_another_is_left_alone(tmp_path):
    path = tmp_path / "c.journal"
    for content in (b"mine\n", b"mine"):
        path.write_bytes(content)
        with pytest.raises(OutputError) as caught:
            GroupJournal(path, "k", False)
        assert caught.value.code == "not_a_journal" and path.read_bytes() == content


def test_that_a_second_batch_is_refused_while_the_first_writes(tmp_path):
    path = tmp_path / "c.journal"
    book = GroupJournal(path, "k", False)
    with pytest.raises(OutputError) as caught:
        GroupJournal(path, "k", True)
    assert caught.value.code == "batch_running"
    book.close()
    with pytest.raises(OutputError):
        GroupJournal(tmp_path, "k", False)
