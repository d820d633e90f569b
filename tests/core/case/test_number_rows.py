"""Tables of numbers and walls as programs write them: separators, decimal marks, encodings, what follows the rows."""

import itertools
import random

import pytest

from core.case.hazard_table import read_hazard
from core.case.number_rows import read_number_rows, split_cells
from core.case.wall_table import read_walls
from core.decoding import NoText, decode_text
from core.errors import InputError
from core.setting.demand_input import _read_spectrum
from core.units import G

ENCODINGS = {
    "utf-8": lambda text: text.encode(),
    "utf-8 with its mark": lambda text: text.encode("utf-8-sig"),
    "utf-16 with its mark": lambda text: text.encode("utf-16"),
    "utf-16 without": lambda text: text.encode("utf-16-le"),
    "utf-16 the other way": lambda text: text.encode("utf-16-be"),
    "Windows": lambda text: text.encode("cp1252"),
}
BETWEEN = {";": ";", "; ": "; ", "\t": "\t", " ": "  ", ",": ",", ", ": ", "}
ENDS = ("\n", "\r\n", "\r")
AFTER = ("", "\n\n", ";;;\n", "\t\t\n")


def written(rows, head, between, comma, end, after, trailing):
    def number(value):
        text = f"{value:.4f}"
        return text.replace(".", ",") if comma else text

    lines = [head, *(between.join(map(number, row)) + trailing for row in rows)]
    return end.join(lines) + end + after.replace("\n", end)


def dialects():
    for name, between, comma, end in itertools.product(ENCODINGS, BETWEEN.values(), (False, True), ENDS):
        if comma and between.startswith(","):
            continue  # nobody can tell 0,1,0,2
        yield name, between, comma, end


SPECTRUM = [(0.0, 0.3), (0.15, 0.7212), (0.45, 0.7212), (1.2, 0.2704), (2.5, 0.1)]
HAZARD = [(30.0, 0.08, 2.4, 0.28), (475.0, 0.26, 2.41, 0.35), (2475.0, 0.45, 2.5, 0.37)]


def test_that_a_spectrum_and_a_hazard_are_read_alike_in_every_dialect(tmp_path):
    draw = random.Random(7)
    for name, between, comma, end in dialects():
        after, trailing = draw.choice(AFTER), draw.choice(("", between.strip() or ""))
        for k, (rows, head) in enumerate(((SPECTRUM, "T (s)  Se (g) sito: città"), (HAZARD, "TR ag F0 TC* perché"))):
            path = tmp_path / f"{k}.txt"
            path.write_bytes(ENCODINGS[name](written(rows, head, between, comma, end, after, trailing)))
            where = (name, between, comma, end, after)
            if k == 0:
                found = [(period, ordinate / G) for period, ordinate in _read_spectrum(path)[1]]
            else:
                found = [(row.return_period_years, row.ag_g, row.f0, row.tc_star_s) for row in read_hazard(path)]
            assert [list(row) for row in found] == [pytest.approx(row) for row in rows], where


@pytest.mark.parametrize("name", ENCODINGS)
@pytest.mark.parametrize(("between", "comma"), [(";", True), (";", False), ("\t", True), (",", False)])
def test_that_a_table_of_walls_is_read_alike_in_every_encoding(name, between, comma, tmp_path):
    rows = [
        ["name", "height_m", "thickness_m", "mechanism"],
        ["città", "3.5", "0.4", "both"],
        ["b", "4.25", "0.45", "both"],
        [""] * 4,
    ]
    text = "\r\n".join(between.join(cell.replace(".", ",") if comma else cell for cell in row) for row in rows)
    path = tmp_path / "walls.csv"
    path.write_bytes(ENCODINGS[name](text + "\r\n"))
    assert [(wall.name, wall.height_m) for wall in read_walls(path)] == [("città", 3.5), ("b", 4.25)]


def test_that_what_is_no_row_is_named_by_its_line():
    table = read_number_rows("T;Se\n0;0,3\n\n0,5;0,7\nfine\n1;0,2\n")
    assert [row.number for row in table.rows] == [2, 4] and table.wrong == (5, "fine")
    assert table.head == [(1, "T;Se")]
    assert read_number_rows("0.1 0.2 x").wrong == (1, "0.1 0.2 x") and read_number_rows("a b").wrong is None


@pytest.mark.parametrize(
    ("line", "cells"),
    [
        ("0,1;0,2;", ["0,1", "0,2"]),
        ("0.1,0.2", ["0.1", "0.2"]),
        ("0,1, 0,2", ["0,1", "0,2"]),
        ("0,1 0,2", ["0,1", "0,2"]),
        ("1,2", ["1,2"]),
        (" ;; ", []),
    ],
)
def test_that_cells_are_parted_where_they_are(line, cells):
    assert split_cells(line) == cells


def test_that_a_binary_file_is_no_text(tmp_path):
    path = tmp_path / "a.txt"
    path.write_bytes(bytes(range(256)) * 4)
    with pytest.raises(NoText):
        decode_text(path.read_bytes())
    for reader in (_read_spectrum, read_hazard):
        with pytest.raises(InputError):
            reader(path)
