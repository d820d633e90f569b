"""Where two results, two workbooks, the lines of two notes differ."""

import io

import openpyxl

from core.report.differences import case_of_workbook, compare_workbooks, diff_lines, diff_results


def test_that_a_key_more_a_key_less_and_another_type_are_differences():
    found = list(diff_results({"a": 1.0, "b": [1, 2], "c": True}, {"b": [1, 2, 3], "c": 1, "d": None}))
    assert [one.place for one in found] == ["a", "b", "c", "d"]
    assert list(diff_results({"seconds": 1.0, "q": 2.0}, {"seconds": 2.0, "q": 2.0})) == []


def test_that_a_number_is_off_by_its_share_and_true_is_no_number():
    (found,) = diff_results({"walls": [{"q_set": 2.0}]}, {"walls": [{"q_set": 1.9}]})
    assert (found.place, found.reported, found.found) == ("walls[0].q_set", "2.0", "1.9")
    assert abs(found.share - 0.05) < 1e-12
    (found,) = diff_results({"passed": True}, {"passed": 1})
    assert found.share is None


def test_that_changed_lines_and_lines_that_are_gone_have_their_number():
    found = list(diff_lines(["a", "q = 2.10", "c", "d"], ["a", "q = 1.10", "c"]))
    assert [(one.place, one.reported, one.found) for one in found] == [("2", "q = 2.10", "q = 1.10"), ("4", "d", "")]


def book_of(**cells) -> bytes:
    book, stream = openpyxl.Workbook(), io.BytesIO()
    book.active.title = cells.pop("title", "Check")
    for place, value in cells.items():
        book.active[place] = value
    book.save(stream)
    return stream.getvalue()


def test_that_numbers_texts_and_formulas_of_cells_are_compared_and_sheets_by_name():
    one = book_of(A1="zeta", B1=0.5, C1="=B1*2")
    assert compare_workbooks(one, book_of(A1="zeta", B1=0.5, C1="=B1*2")).cells == []
    places = [found.place for found in compare_workbooks(one, book_of(A1="ZETA", B1=0.6, C1="=B1*3", D1=1)).cells]
    assert places == ["Check!A1", "Check!B1", "Check!D1", "Check!C1"]
    (found,) = compare_workbooks(one, book_of(title="Other")).cells
    assert (found.reported, found.found) == ("Check", "Other")


def test_that_the_case_within_a_workbook_is_read_line_by_line():
    lines = {"A1": "title", "A3": "The case as it was run", "A4": "[[wall]]", "A6": 'name = "w"'}
    assert case_of_workbook(book_of(title="Input", **lines)) == ('[[wall]]\n\nname = "w"\n', [])
    assert case_of_workbook(book_of(A1=1)) == ("", [])
