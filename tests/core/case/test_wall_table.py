"""Tables of walls: heads in two languages, units, decimal comma, hostile files."""

import io
import zipfile
from dataclasses import fields

import pytest
from openpyxl import Workbook, load_workbook

from core.case import wall_columns, wall_table
from core.case.document import Document
from core.case.hold import Hold
from core.case.loads import Load, ReturnWalls
from core.case.reader import read_case
from core.case.solids import Opening, Step, Wedges
from core.case.values import field_of
from core.case.wall import Wall
from core.case.wall_table import parse_wall_rows, read_table, read_walls, text_rows
from core.errors import InputError
from tests.core.ooxml.writers import WRITERS, Fault, Formula, Writer, packed, unpacked
from tests.core.ooxml.writers import workbook as written_by

CSV = """Parete;Piano;z;H;t;L;Peso specifico;u;Meccanismo;Vincolo 1;Note
;;m;m;cm;m;kN/m3;cm;;;
Facciata;terra;0;7,0;83;5;19;5;un lato;muri trasversali;prova
Timpano;2;6,5;3.5;45;4;18;;su due lati;;
"""

NESTED_OF_A_WALL = (
    "load",
    "set_aside",
    "return_walls",
    "hold",
    "leaf",
    "plan",
    "evidence",
    "solid",
    "openings",
    "steps",
    "return_wedges",
    "corner",
    "drawing",
)
"""Keys of a wall whose own keys are columns; a drawing is named in the case."""


def book(rows, change=None) -> bytes:
    made = Workbook()
    for row in rows:
        made.active.append(row)
    if change:
        change(made.active)
    stream = io.BytesIO()
    made.save(stream)
    return stream.getvalue()


ROWS = [["Wall", "H", "t", "mechanism"], ["", "m", "m", ""], ["a", 5.0, "0,5", "two_sided"]]


@pytest.mark.shows("case.table")
def test_that_an_italian_csv_gives_its_walls(tmp_path):
    path = tmp_path / "w.csv"
    for encoding in ("utf-8-sig", "cp1252"):
        path.write_bytes(CSV.encode(encoding))
        first, second = read_walls(path)
        assert (first.name, first.mechanism, first.hold[0].kind) == ("Facciata", "one_sided", "cross_walls")
        assert first.height_m == 7.0
        assert first.thickness_m == pytest.approx(0.83, rel=1e-15)
        assert first.hinge_setback_m == pytest.approx(0.05, rel=1e-15)
        assert (second.base_z_m, second.height_m, second.floor) == (6.5, 3.5, "2")


def test_that_commas_and_tabs_separate_too(tmp_path):
    rows = "wall,H,t,mechanism\n,m,m,\na,5.0,0.5,two_sided\n"
    assert parse_wall_rows(text_rows(rows)) == parse_wall_rows(text_rows(rows.replace(",", "\t")))


def test_that_an_xlsx_gives_its_walls(tmp_path):
    path = tmp_path / "w.xlsx"
    path.write_bytes(book(ROWS))
    (wall,) = read_walls(path)
    assert (wall.name, wall.height_m, wall.thickness_m) == ("a", 5.0, 0.5)


def test_that_the_template_is_read_as_it_is():
    from tests.conftest import ROOT

    walls = read_walls(ROOT / "resources" / "templates" / "walls.xlsx")
    assert len(walls) == 2


@pytest.mark.parametrize(
    ("column", "words", "section", "key"),
    [
        ("J", wall_columns.WORDS_OF_CHOICE["hold.kind"], Hold, "kind"),
        ("Z", wall_columns.WORDS_OF_CHOICE["evidence.kind"], Document, "kind"),
        ("O", wall_columns.LOAD_KINDS, Load, "kind"),
        ("S", wall_columns.LOAD_MASSES, Load, "mass"),
        ("I", wall_columns.MECHANISMS, Wall, "mechanism"),
    ],
)
def test_that_the_template_offers_every_choice_of_its_columns(column, words, section, key):
    from tests.conftest import ROOT

    (sheet,) = load_workbook(ROOT / "resources" / "templates" / "walls.xlsx").worksheets
    (offered,) = (
        rule.formula1.strip('"').split(",")
        for rule in sheet.data_validations.dataValidation
        if f"{column}3" in rule.sqref
    )
    assert {words[word] for word in offered} == set(field_of(section, key).metadata["names"])


def test_that_a_case_takes_its_walls_from_the_table(tmp_path):
    (tmp_path / "w.csv").write_text(CSV)
    path = tmp_path / "c.toml"
    path.write_text('title = "t"\nwalls = "w.csv"\n')
    case = read_case(path)
    assert [wall.name for wall in case.wall] == ["Facciata", "Timpano"]
    changed = CSV.replace("83", "84")
    (tmp_path / "w.csv").write_text(changed)
    assert read_case(path).sha256 != case.sha256


def merged(sheet):
    sheet.merge_cells("A3:B3")


def formula(sheet):
    sheet["B3"] = "=1+1"


def bomb() -> bytes:
    parts = unpacked(book(ROWS))
    sheet = "xl/worksheets/sheet1.xml"
    spaces = (b" " * 60 + b"<a/>") * 400_000
    return packed({**parts, sheet: parts[sheet].replace(b"</worksheet>", spaces + b"</worksheet>")})


def lying(content: bytes) -> bytes:
    """The same workbook whose dimension tag says it is one cell."""
    import re

    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(stream, "w") as new:
        for entry in old.infolist():
            data = old.read(entry)
            if entry.filename.endswith("sheet1.xml"):
                data = re.sub(rb'<dimension ref="[^"]*"', b'<dimension ref="A1"', data)
            new.writestr(entry, data)
    return stream.getvalue()


def test_that_a_lying_dimension_changes_nothing(tmp_path):
    path = tmp_path / "w.xlsx"
    path.write_bytes(lying(book(ROWS)))
    assert len(read_walls(path)) == 1


@pytest.mark.shows("case.table_refused")
@pytest.mark.parametrize(
    ("content", "words"),
    [
        (book(ROWS, merged), "merged cells A3:B3"),
        (book(ROWS, formula), "formulas B3"),
        (bomb(), "larger than 20 MB"),
        (b"not a zip", "not a workbook"),
        (book(ROWS)[:-300], "not a workbook"),
        (book([["Wall", "colour"], ["", ""], ["a", "red"]]), "'colour' is not known"),
        (book([["Wall", "H"], ["", "kN"], ["a", 5]]), "unit 'kN'"),
        (book([["Wall", "H"], ["", ""], ["a", 5]]), "unit ''"),
        (book([*ROWS, ["b", "5,0.1", 0.5, "two_sided"]]), 'sheet "Sheet": row 4, H: '),
        (book([*ROWS, ["b", 5, 0.5, "sideways"]]), "row 4.*mechanism"),
        (book([*ROWS, ["b", 500, 0.5, "two_sided"]]), "row 4.*height_m = 500"),
        (book([["Wall", "Parete"], ["", ""], ["a", "b"]]), "twice"),
        (book(ROWS[:2]), "a row of column titles"),
        (book([*ROWS, ["a", 5, 0.5, "both", None, 7]]), "beyond the last column"),
    ],
)
def test_that_a_wrong_table_is_refused_in_one_sentence(tmp_path, content, words):
    path = tmp_path / "w.xlsx"
    path.write_bytes(content)
    with pytest.raises(InputError, match=words) as caught:
        read_walls(path)
    assert "w.xlsx" in str(caught.value) and "\n" not in str(caught.value)


def test_that_an_entity_bomb_is_refused(tmp_path):
    content = book(ROWS)
    stream = io.BytesIO()
    evil = b'<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>'
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(stream, "w") as new:
        for entry in old.infolist():
            data = old.read(entry)
            if entry.filename.endswith(("sheet1.xml", "workbook.xml")):
                data = evil + data.split(b"?>", 1)[-1] if data.startswith(b"<?xml") else evil + data
            new.writestr(entry, data)
    path = tmp_path / "w.xlsx"
    path.write_bytes(stream.getvalue())
    with pytest.raises(InputError, match="not a workbook"):
        read_walls(path)


def test_that_damaged_bytes_are_refused_and_never_an_internal_error(tmp_path):
    import random

    content = bytearray(book(ROWS))
    chance = random.Random(1)
    path = tmp_path / "w.xlsx"
    for _ in range(300):
        damaged = bytearray(content)
        damaged[chance.randrange(len(damaged))] ^= 1 << chance.randrange(8)
        path.write_bytes(damaged)
        try:
            read_walls(path)
        except InputError as error:
            assert "w.xlsx" in str(error)


def test_that_a_modulus_and_confirmations_are_columns():
    rows = (
        "Parete;z;H;t;Meccanismo;E;peso specifico;Parete scarica\n;m;m;m;;GPa;kN/m3;\n"
        "a;0;4;0,5;su un lato;1,2;18;sì\nb;6;4;0,5;su due lati;;;\n"
    )
    a, b = parse_wall_rows(text_rows(rows))
    assert (a.unloaded_confirmed, a.elastic_modulus_mpa) == (True, 1200.0)
    assert (b.unloaded_confirmed, b.elastic_modulus_mpa) == (False, None)
    with pytest.raises(InputError, match="row 3, Parete scarica: 'forse' is not accepted"):
        parse_wall_rows(text_rows(rows.replace(";sì", ";forse")))
    for word in ("sì", "si", "Yes", "true", "VERO", "x", "1"):
        assert parse_wall_rows(text_rows(rows.replace(";sì", f";{word}")))[0].unloaded_confirmed is True
    for word in ("no", "false", "FALSO", "0"):
        assert parse_wall_rows(text_rows(rows.replace(";sì", f";{word}")))[0].unloaded_confirmed is False


def workbook(tmp_path, hide=(), sheets=()):
    """A table of three walls; rows to hide, and further sheets (name, hidden)."""
    import openpyxl

    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Pareti"
    sheet.append(["Parete", "z", "H", "t", "Meccanismo"])
    sheet.append([None, "m", "m", "cm", None])
    for name in "abc":
        sheet.append([name, 0, 4, 45, "su un lato"])
    for number in hide:
        sheet.row_dimensions[number].hidden = True
    for name, hidden in sheets:
        other = book.create_sheet(name, 0 if hidden else None)
        other.append(["not", "walls"])
        other.sheet_state = "hidden" if hidden else "visible"
    path = tmp_path / "w.xlsx"
    book.save(path)
    return path


@pytest.mark.shows("case.table_refused")
def test_that_hidden_rows_and_sheets_are_not_read_and_said(tmp_path):
    walls, notes, *_ = read_table(workbook(tmp_path, hide=(4,), sheets=[("Old", True), ("Note", False)]))
    assert [wall.name for wall in walls] == ["a", "c"]
    assert [note.text() for note in notes] == [
        "Walls read from the sheet Pareti.",
        "Hidden rows of the table of walls were not read: 4.",
        "Other sheets of the table of walls were not read: Old, Note.",
    ]
    assert "foglio Pareti" in notes[0].text("it")
    walls, notes, *_ = read_table(workbook(tmp_path))
    assert len(walls) == 3 and len(notes) == 1


def test_that_unicode_text_of_a_spreadsheet_is_read_or_refused_by_name(tmp_path):
    rows = "Parete\tH\tt\tMeccanismo\n\tm\tm\t\nè\t4\t0,5\tentrambi\n"
    path = tmp_path / "w.txt"
    path.write_bytes(rows.encode("utf-16"))
    assert read_walls(path)[0].name == "è"
    path.write_bytes(rows.encode("utf-16-le"))
    assert read_walls(path)[0].name == "è"
    path.write_bytes(rows.encode("utf-32-le"))
    with pytest.raises(InputError, match="not text: save the table as"):
        read_walls(path)


def test_that_a_slenderness_in_degrees_is_taken_as_it_is():
    for unit in ("deg", "°", "-", ""):
        rows = [["Parete", "H", "alpha", "Meccanismo"], ["", "m", unit, ""], ["a", "4", "7.5", "entrambi"]]
        assert parse_wall_rows(rows)[0].slenderness_deg == 7.5


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('hidden="1"', "hidden='1'"),
        ('hidden="1"', 'ht="0" customHeight="1"'),
        ('hidden="1"', 'hidden="true"'),
        ("<row r=", "<row n="),  # a row without its number follows the one above
    ],
)
def test_that_a_row_is_hidden_however_a_workbook_says_it(tmp_path, old, new):
    import zipfile

    path = workbook(tmp_path, hide=(4,))
    with zipfile.ZipFile(path) as book:
        parts = {name: book.read(name) for name in book.namelist()}
    sheet = "xl/worksheets/sheet1.xml"
    assert old.encode() in parts[sheet]
    parts[sheet] = parts[sheet].replace(old.encode(), new.encode())
    with zipfile.ZipFile(path, "w") as book:
        for name, content in parts.items():
            book.writestr(name, content)
    assert [wall.name for wall in read_table(path)[0]] == ["a", "c"]


LOADED = """Parete;z;H;t;Peso specifico;Meccanismo;velocity_ratio;Carico 1;Carico 1 p;Carico 1 d;Carico 1 h;\
Carico 1 massa;Carico 2;load2_kn_m;load2_h_m;Vincolo 1;hold1_out_kn_m;hold1_h_m;Vincolo 1 lunghezza barra;Variante
;m;m;cm;kN/m3;;;;kN/m;cm;m;;;kN/m;m;;kN/m;m;m;
A;0;3;45;18;un lato;0,5;verticale;10;30;3;orizzontale;spinta;0,5;1,5;catena;2,5;2,8;9;progetto
B;0;3;45;18;un lato;;;;;;;;;;;;;;
"""


def test_that_loads_and_ties_stand_in_columns_of_their_own():
    rows = text_rows(LOADED.replace("e;Carico", "velocity_ratio;Carico").replace("un lato;;v", "un lato;0,5;v"))
    loaded, bare = parse_wall_rows(rows)
    first, second = loaded.load
    assert (first.kind, first.kn_m, first.d_m, first.h_m, first.mass) == ("vertical", 10.0, 0.3, 3.0, "horizontal")
    assert (second.kind, second.kn_m, second.h_m, second.mass) == ("thrust", 0.5, 1.5, None)
    (tie,) = loaded.ties
    assert (tie.kind, tie.out_kn_m, tie.h_m, tie.bar_length_m) == ("tie", 2.5, 2.8, 9.0)
    assert loaded.variant == "progetto" and bare.load == bare.hold == ()


def test_that_a_tie_to_be_designed_stands_in_columns_of_a_hold():
    """The word for a tie may be either of the two."""
    heads = "Parete;H [m];t [m];Meccanismo;Peso specifico;Vincolo 1;Vincolo 1 h [m];Vincolo 1 da dimensionare"
    for word in ("catena", "tirante", "tie"):
        (wall,) = parse_wall_rows(text_rows(f"{heads}\na;3;0,45;un lato;18;{word};2,8;sì"))
        assert (wall.sought.kind, wall.sought.h_m, wall.ties) == ("tie", 2.8, ())


def test_that_a_load_that_lacks_its_size_names_row_and_key():
    text = "name;h;t;peso specifico;mechanism;load 1;load 1 h\n;m;m;kN/m3;;;m\nA;3;0.45;18;one_sided;thrust;2\n"
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows(text))
    assert "row 3" in str(caught.value) and "kn_m" in str(caught.value)


BODY = (
    "nome;H [m];t [cm];meccanismo;lunghezza [m];peso specifico;timpano [m];apertura 1 s [m];apertura 1 z [m];"
    "apertura 1 larghezza [cm];apertura 1 altezza [m];opening 2 s [m];opening 2 z [m];opening 2 diameter [m];cunei;"
    "cunei t [cm];cunei lunghezza in sommità [m];risega 1 da z [m];risega 1 t [cm]"
)


def test_that_the_shape_of_a_wall_stands_in_columns_of_its_own():
    facade, plain = parse_wall_rows(
        text_rows(
            f"{BODY}\nfacciata;11;90;un lato;10;19;3;4;0;200;3,5;5;6,5;2,4;2;60;1,6;;\n"
            "muro;8;60;un lato;5;18;;;;;;;;;;;;4;45\n"
        )
    )
    assert facade.gable_m == 3.0 and facade.return_wedges == Wedges(2, 0.6, 1.6)
    assert facade.openings == (Opening(4.0, 0.0, 2.0, 3.5), Opening(5.0, 6.5, diameter_m=2.4))
    assert (plain.gable_m, plain.openings, plain.return_wedges) == (None, (), None)
    assert plain.steps == (Step(4.0, 0.45),)
    heads = "name\tH [m]\tt [cm]\tmechanism\tlength [m]\tunit weight\tsolid 1\tsolid 1 corners\tsolid 1 to [m]\n"
    (wall,) = parse_wall_rows(text_rows(f"{heads}w\t6\t50\tone_sided\t4\t18\televation\t0 0; 4 0; 4 6; 0 6\t0.5\n"))
    assert wall.solid[0].polygon_m[2] == (4.0, 6.0)


def test_that_an_opening_that_lacks_its_height_names_row_and_column():
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows(f"{BODY}\nfacciata;11;90;un lato;10;19;3;4;;200;;;;;;;;;\n"))
    assert "row 2, apertura 1 z" in str(caught.value) and "z_m is missing" in str(caught.value)


@pytest.mark.parametrize(("cell", "heights"), [("piani", "floors"), ("1,5 3", (1.5, 3.0)), ("2", (2.0,))])
def test_that_hinges_stand_in_a_column(cell, heights):
    text = f"name\th\tt\tmechanism\tcerniere\n\tm\tm\nA\t6\t0,6\tone_sided\t{cell}\n"
    (wall,) = parse_wall_rows(text_rows(text))
    assert wall.hinge_heights == heights
    with pytest.raises(InputError):
        parse_wall_rows(text_rows(text.replace(cell, "high")))


@pytest.mark.shows("case.table")
def test_that_a_table_takes_every_key_of_a_wall():
    columns = wall_columns.columns()
    for entry in fields(Wall):
        assert entry.name in columns or entry.name in NESTED_OF_A_WALL, entry.name
    for entry in fields(ReturnWalls):
        assert f"across_{entry.name}" in columns, entry.name
    titles = [title for column in columns.values() for title in column.titles]
    assert len(titles) == len(set(titles))
    heads = [
        "Parete",
        "H [m]",
        "t [cm]",
        "Meccanismo",
        "z [m]",
        "L [m]",
        "Peso specifico",
        "Muri ortogonali",
        "Muri ortogonali t [cm]",
        "Muri ortogonali hb [cm]",
        "Muri ortogonali l [cm]",
        "f [MPa]",
    ]
    text = ";".join(heads) + "\na;6,5;45;su un lato;0;4;18;2;40;12;25;2,5"
    (wall,) = wall_table.parse_wall_rows(wall_table.text_rows(text))
    assert (wall.height_m, wall.thickness_m, wall.compressive_strength_mpa) == (6.5, 0.45, 2.5)
    assert wall.return_walls == ReturnWalls(2, 0.4, 0.12, 0.25, 0.577)
    (block,) = wall_table.parse_wall_rows(
        wall_table.text_rows("Parete;R [m];alpha [deg];I0/m [m2];Meccanismo\nb;3;8;12,5;su due lati")
    )
    assert (block.radius_m, block.inertia_over_mass_m2) == (3.0, 12.5)


@pytest.mark.parametrize(
    ("cell", "words"),
    [("oscillante", "su due lati, due lati, su un lato"), ("spingente", "verticale, spinta, massa portata")],
)
def test_that_a_wrong_word_is_answered_with_the_words_of_the_list(cell, words):
    head = "Parete;H [m];t [m];Meccanismo;Peso specifico;Carico 1"
    row = f"a;6;0,5;{cell};18;" if words.startswith("su") else f"a;6;0,5;su un lato;18;{cell}"
    with pytest.raises(InputError) as caught:
        wall_table.parse_wall_rows(wall_table.text_rows(f"{head}\n{row}"))
    column = "Meccanismo" if words.startswith("su") else "Carico 1"
    assert f"row 2, {column}: '{cell}' is not accepted: one of {words}" in str(caught.value)


THRUST = [
    ["Parete", "z", "H", "t", "Meccanismo", "Peso specifico", "Carico 1", "Carico 1 p", "Carico 1 h"],
    ["", "m", "m", "cm", "", "kN/m3", "", "kN/m", "m"],
    ["A", 0, 4, 45, "su un lato", 18, "spinta", 2.5, 3],
    ["B", 0, 4, 45, "su un lato", 18, None, None, None],
    ["C", 0, 5, 45, "su un lato", 18, None, None, None],
]


@pytest.fixture
def saved(tmp_path):
    """Write bytes as a table and give its path."""

    def save(content: bytes, name="w.xlsx"):
        path = tmp_path / name
        path.write_bytes(content)
        return path

    return save


@pytest.mark.shows("case.table")
@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_a_table_is_the_same_whoever_wrote_it(writer, saved):
    walls, notes, *_ = read_table(saved(written_by(writer, THRUST, hidden_rows=(4,), others=[("Note", [["x"]])])), True)
    assert walls == parse_wall_rows(
        [[("" if c is None else str(c)) for c in row] for row in THRUST[:3] + THRUST[4:]], True
    )
    assert [note.code for note in notes] == ["table_sheet", "hidden_rows", "other_sheets"]


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_a_load_merged_over_two_walls_never_reaches_the_first_alone(writer, saved):
    path = saved(written_by(writer, THRUST, merged=("G3:G4", "H3:H4", "I3:I4")))
    with pytest.raises(InputError, match='sheet "Foglio 1": merged cells G3:G4, H3:H4, I3:I4: each cell'):
        read_table(path)


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_all_cells_without_a_value_of_their_own_are_named_at_once(writer, saved):
    rows = [*THRUST[:3], ["B", 0, Formula("C3", 4), 45, "su un lato", 18], [Fault("#REF!"), 0, 4, 45, "su un lato", 18]]
    path = saved(written_by(writer, rows, merged=("A4:B4",)))
    with pytest.raises(InputError, match="merged cells A4:B4, formulas C4, errors A5: each cell"):
        read_table(path)


@pytest.mark.shows("case.table_refused")
def test_that_hidden_columns_are_not_read_and_said(saved):
    rows = [[*row[:2], *row[2:]] for row in THRUST]
    walls, notes, *_ = read_table(saved(written_by(Writer(), rows, hidden_columns=(7, 8, 9))))
    assert [wall.load for wall in walls] == [(), (), ()]
    assert notes[1].text() == (
        "Hidden columns of the table of walls were not read: G (Carico 1), H (Carico 1 p), I (Carico 1 h)."
    )
    assert "nascoste" in notes[1].text("it")
    walls, _, *_ = read_table(
        saved(written_by(Writer(), [[*row[:2], "?", *row[2:]] for row in THRUST], hidden_columns=(3,)))
    )
    assert [wall.height_m for wall in walls] == [4.0, 4.0, 5.0]


def test_that_a_merged_cell_of_another_sheet_is_no_matter(saved):
    parts = unpacked(written_by(Writer(), THRUST, others=[("Note", [["x"]])]))
    second = "xl/worksheets/sheet2.xml"
    merged = b'</sheetData><mergeCells><mergeCell ref="A1:B1"/></mergeCells>'
    parts[second] = parts[second].replace(b"</sheetData>", merged)
    assert len(read_walls(saved(packed(parts)))) == 3


@pytest.mark.parametrize("text", [";" * 20_000_000, ";;\n" * 6_000_000, '"";' * 6_000_000, "a\tb\n" + "\t" * 400_000])
def test_that_a_text_of_countless_cells_is_refused_before_they_are_made(text, monkeypatch):
    monkeypatch.setattr(wall_table.csv, "reader", lambda *_, **__: pytest.fail("they were made"))
    with pytest.raises(InputError, match="more than 2000 rows or 160 columns"):
        text_rows(text)


STYLES, STRINGS, SHEET = "xl/styles.xml", "xl/sharedStrings.xml", "xl/worksheets/sheet1.xml"


@pytest.mark.shows("doors.bombs")
@pytest.mark.parametrize(
    ("part", "before", "unit"),
    [
        (STYLES, "</styleSheet>", "<fonts><font><b/></font></fonts>"),
        (STYLES, "</cellXfs>", '<xf numFmtId="0"/>'),
        (STRINGS, "</sst>", "<si><t>a</t></si>"),
        (SHEET, "</sheetData>", "<row/>"),
        (SHEET, "</row>", "<c/>"),
        (SHEET, "</worksheet>", "<mergeCells><mergeCell ref='A1:XFD1048576'/></mergeCells>"),
    ],
)
def test_that_a_workbook_of_some_kilobytes_takes_no_more_than_it_is_worth(part, before, unit, saved, monkeypatch):
    """18 kB of styles took 22 s and 1.1 GB: what is read is counted, and what is not needed is not kept."""
    import tracemalloc

    parts = unpacked(written_by(Writer(), THRUST))
    grown = parts[part].replace(before.encode(), unit.encode() * (18_000_000 // len(unit)) + before.encode(), 1)
    path = saved(packed({**parts, part: grown}))
    assert path.stat().st_size < 200_000
    del grown
    monkeypatch.setattr("core.ooxml.package.MAX_ELEMENTS", 20_000)  # tracing takes its time
    tracemalloc.start()
    with pytest.raises(InputError, match="more parts, cells, texts or formats than can be read"):
        read_table(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10e6


TABLE = "nome;meccanismo;altezza (m);spessore (m);quota (m)\na;su due lati;5,0;0,50;0\nb;su due lati;4,0;0,40;7,75\n"


def test_that_a_table_cut_anywhere_is_refused_read_as_fewer_walls_or_said(tmp_path):
    """Cut at every byte: what is read is what the rows that are whole say, or the last cell is said to be uncertain."""
    path, whole = tmp_path / "w.csv", parse_wall_rows(text_rows(TABLE))
    refused = said = 0
    for n in range(len(TABLE) + 1):
        path.write_text(TABLE[:n], encoding="utf-8")
        try:
            walls, notes, *_ = read_table(path)
        except InputError:
            refused += 1
            continue
        assert walls[:-1] == whole[: len(walls) - 1]
        if TABLE[:n].endswith("\n"):
            assert walls == whole[: len(walls)]
        else:
            said += 1
            assert any(note.code == "table_not_ended" for note in notes)
    assert refused > 90 and said > 0


@pytest.mark.shows("case.table_refused")
@pytest.mark.parametrize("row", ["c;su due lati;5,0;0,50", 'c;"su due lati;5,0;0,50;0', "c"])
def test_that_a_short_row_and_an_open_quote_are_refused(row):
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows(TABLE + row + "\n" + "d;su due lati;5,0;0,50;0\n"))
    assert caught.value.code in ("row_cut", "not_a_table")


def test_that_a_separator_said_on_top_and_comments_are_read_over():
    plain = parse_wall_rows(text_rows(TABLE))
    assert parse_wall_rows(text_rows("sep=;\n" + TABLE)) == plain
    assert (
        parse_wall_rows(text_rows("# of the survey; in autumn\n" + TABLE.replace("\nb;", "\n# the back;\nb;"))) == plain
    )
    (named, _) = parse_wall_rows(text_rows(TABLE.replace("\na;", "\n# a;")))
    assert named.name == "# a"  # a row with numbers is a wall, whatever it is called


def test_that_titles_that_are_keys_need_no_unit_and_cells_are_read_as_people_write_them():
    """A row of a comment, a note of two lines, 6E-1, and a thickness beside a height whatever its size: read as they
    are, once."""
    text = (
        "name,height_m,thickness_m,mechanism,base_z_m,notes\n# of the surveyor,,,,,\n"
        'w1,7.25,6,two_sided,0,"first line\nsecond line"\nw2,6.0,6E-1,two_sided,0,\n'
    )
    first, second = parse_wall_rows(text_rows(text))
    assert (first.thickness_m, first.notes, second.thickness_m) == (6.0, "first line second line", 0.6)
    with pytest.raises(InputError, match="unit"):
        parse_wall_rows(text_rows(text.replace("height_m", "height")))
    cm = text.replace("thickness_m", "thickness_m [cm]")
    assert parse_wall_rows(text_rows(cm))[0].thickness_m == pytest.approx(0.06)


@pytest.mark.parametrize("cell", ["1.250", "-1.250", "12.345.678"])
def test_that_italian_thousands_are_asked_about(cell):
    with pytest.raises(InputError) as caught:
        parse_wall_rows(text_rows(TABLE.replace("7,75", cell)))
    assert caught.value.code == "thousands_or_decimals"
    pointed = TABLE.replace(",", ".").replace("7.75", "1.250")
    assert parse_wall_rows(text_rows(pointed))[1].base_z_m == 1.25
    assert parse_wall_rows(text_rows(TABLE.replace("7,75", "−7,75".replace("−", ""))))[1].base_z_m == 7.75


def test_that_a_table_has_up_to_160_columns():
    rows = [row + [""] * (160 - len(row)) for row in text_rows(TABLE)]
    assert len(parse_wall_rows(rows)) == 2
    with pytest.raises(InputError, match="more than 2000 rows or 160 columns"):
        parse_wall_rows([[*row, ""] for row in rows])


@pytest.mark.parametrize("row", [3, 4])
def test_that_thousands_are_asked_about_in_every_row_of_a_workbook(row, saved):
    """In cells that are text, as those of a table that was pasted: a number has no marks of its own."""
    rows = [["Parete", "z", "H", "t", "Meccanismo"], ["", "m", "m", "cm", ""]]
    rows += [[name, "0,5", "4", "45", "su un lato"] for name in "ab"]
    assert [wall.base_z_m for wall in read_walls(saved(book(rows)))] == [0.5, 0.5]
    rows[row - 1][2] = "4.000"
    with pytest.raises(InputError, match=f"row {row}: .*4\\.000"):
        read_walls(saved(book(rows)))
    rows[row - 1][2] = 4.0
    assert len(read_walls(saved(book(rows)))) == 2
