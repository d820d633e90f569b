"""Units of a table of walls: in the heads, in the row below them, of the right quantity."""

import re

import openpyxl
import pytest

from core.case import wall_table
from core.case.wall_table import parse_wall_rows, read_walls, text_rows
from core.errors import InputError


@pytest.mark.parametrize(
    ("head", "unit", "cell", "key", "value"),
    [
        ("H", "cm", "400", "height_m", 4.0),
        ("t", "mm", "450", "thickness_m", 0.45),
        ("t", "m", "0.45", "thickness_m", 0.45),
        ("L", "cm", "500", "length_m", 5.0),
        ("u", "mm", "30", "hinge_setback_m", 0.03),
        ("z", "cm", "350", "base_z_m", 3.5),
        ("E", "MPa", "900", "elastic_modulus_mpa", 900.0),
        ("E", "GPa", "0.9", "elastic_modulus_mpa", 900.0),
        ("E", "N/mm2", "900", "elastic_modulus_mpa", 900.0),
        ("γ", "kn/m³", "18", "unit_weight_kn_m3", 18.0),
        ("γ", "-", "18", "unit_weight_kn_m3", 18.0),
        ("H", "mm", "4000", "height_m", 4.0),
        ("γ", "kN/m3", "18", "unit_weight_kn_m3", 18.0),
    ],
)
def test_that_each_unit_of_a_table_has_its_factor(head, unit, cell, key, value):
    cells = {"Parete": ("", "a"), "H": ("m", "4"), "t": ("m", "0.5"), "Meccanismo": ("", "entrambi")}
    cells[head] = (unit, cell)
    rows = [list(cells), [pair[0] for pair in cells.values()], [pair[1] for pair in cells.values()]]
    (wall,) = parse_wall_rows(rows)
    assert getattr(wall, key) == pytest.approx(value, rel=1e-15)


@pytest.mark.shows("case.units")
@pytest.mark.parametrize(
    ("head", "unit"), [("E", "kN/m3"), ("E", ""), ("γ", "MPa"), ("H", "kN/m3"), ("H", ""), ("Meccanismo", "m")]
)
def test_that_a_unit_of_another_quantity_is_refused(head, unit):
    cells = {"Parete": ("", "a"), "H": ("m", "4"), "t": ("m", "0.5"), "Meccanismo": ("", "entrambi")}
    cells[head] = (unit, cells.get(head, ("", "900"))[1])
    rows = [list(cells), [pair[0] for pair in cells.values()], [pair[1] for pair in cells.values()]]
    with pytest.raises(InputError, match="the unit"):
        parse_wall_rows(rows)


def test_that_the_units_a_column_takes_are_listed():
    rows = "Parete;z;H;t;Meccanismo;notes\n;m;m;kN;;\na;0;4;45;su un lato;\n"
    with pytest.raises(InputError, match="the unit 'kN' of the column t .*: one of m, cm, mm, ft "):
        parse_wall_rows(text_rows(rows))
    rows = rows.replace("kN;;", "m;;m").replace(";45;", ";0.45;")
    with pytest.raises(InputError, match="the unit 'm' of the column notes is not accepted: one of -, "):
        parse_wall_rows(text_rows(rows))


@pytest.mark.parametrize(
    ("head", "unit", "word"),
    [
        ("t (mm)", "cm", "names mm, but the row of units below it names cm"),
        ("H [cm]", "m", "names cm"),
        ("E [GPa]", "MPa", "names GPa"),
        ("t (mm.)", "cm", "names mm."),
        ("t (in mm)", "cm", "names in mm"),
        ("t (dm)", "cm", "names dm"),
        ("t (muro) (mm)", "cm", "names mm"),
        ("H (ft)", "m", "names ft"),
        ("E [kPa]", "MPa", "names kPa"),
    ],
)
def test_that_a_unit_in_the_head_that_contradicts_the_row_of_units_is_refused(head, unit, word):
    heads = ["Parete", "H", "t", "Meccanismo", "E"]
    units = ["", "m", "m", "", "MPa"]
    place = next(k for k, name in enumerate(heads) if head.startswith(name))
    heads[place], units[place] = head, unit
    with pytest.raises(InputError, match=word):
        parse_wall_rows([heads, units, ["a", "4", "0.5", "entrambi", "900"]])
    heads[place] = f"{head[0]} (misurato) [{unit}]"
    assert len(parse_wall_rows([heads, units, ["a", "4", "0.5", "entrambi", "900"]])) == 1


def test_that_a_head_without_a_unit_still_asks_for_one():
    with pytest.raises(InputError, match="unit '' of the column H is not accepted"):
        wall_table.parse_wall_rows(wall_table.text_rows("Parete;H;t [m];Meccanismo\na;6;0,5;su un lato"))


THRUST = ["nome", "meccanismo", "H (m)", "t (m)", "z (m)", "peso specifico", "carico 1", "{}", "carico 1 h (m)"]
THRUST += ["carico 1 d (m)", "carico 1 massa"]
OF_THRUST = ["a", "su un lato", "7", "0.83", "0", "18", "spinta", "{}", "6.9", "0.4", "nessuna"]


def thrust(head: str, value: str, comma: bool = False) -> float:
    row = [cell.format(value) for cell in OF_THRUST]
    row = [cell.replace(".", ",") if comma and k != 7 else cell for k, cell in enumerate(row)]
    text = "\n".join(";".join(one) for one in ([head_.format(head) for head_ in THRUST], row)) + "\n"
    return parse_wall_rows(text_rows(text))[0].load[0].kn_m


@pytest.mark.parametrize(
    ("head", "value", "comma"),
    [
        ("carico 1 P (kg/m)", "1.200", False),
        ("carico 1 P (kg/m)", "1.200", True),
        ("carico 1 P", "1.200 kg/m", True),
        ("carico 1 P (kN/m) x 10", "1.2", False),
        ("carico 1 P (kN/m), valori in t/m", "1.2", False),
        ("carico 1 P (kN/m) t/m", "1.2", False),
    ],
)
def test_that_a_number_that_may_be_a_thousand_times_larger_is_asked_about(head, value, comma):
    with pytest.raises(InputError) as refused:
        thrust(head, value, comma)
    assert refused.value.code in ("thousands_or_decimals", "thousands_or_point", "unknown_unit")


def test_that_units_of_cells_and_of_number_formats_count(tmp_path):
    assert thrust("carico 1 P (kg/m)", "1200") == pytest.approx(11.76798)
    assert thrust("carico 1 P", "1200 kg/m") == pytest.approx(11.76798)
    assert thrust("carico 1 P (kN/m) stimato", "1.2") == pytest.approx(1.2)
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append([head.format("carico 1 P") for head in THRUST])
    cells = [cell.format("1.2") for cell in OF_THRUST]
    sheet.append([float(cell) if re.fullmatch(r"[\d.]+", cell) else cell for cell in cells])
    sheet["H2"].number_format = '0.0 "t/m"'
    book.save(tmp_path / "t.xlsx")
    (wall,) = read_walls(tmp_path / "t.xlsx")
    assert wall.load[0].kn_m == pytest.approx(11.76798)


def test_that_hinges_with_one_unit_and_a_row_that_begins_with_a_mark_are_not_guessed():
    rows = "nome;meccanismo;H (m);t (m);hinge_heights\n{};su un lato;9;0,5;{}\n"
    with pytest.raises(InputError):
        parse_wall_rows(text_rows(rows.format("a", "3 6 ft")))
    assert parse_wall_rows(text_rows(rows.format("a", "3 ft 6 ft")))[0].hinge_heights == pytest.approx([0.9144, 1.8288])
    (wall,) = parse_wall_rows(
        text_rows("nome;meccanismo;H;t\n#1;su un lato;7 m;0,50 m\n".replace("H;t", "H (m);t (m)"))
    )
    assert wall.name == "#1"
    (wall,) = parse_wall_rows(text_rows("nome;meccanismo;H;t\nu.m.;-;m;cm\n# nota del 2024;;;\na;su un lato;7;50\n"))
    assert wall.thickness == 0.5
