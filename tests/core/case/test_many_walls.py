"""Walls of a long table, read one at a time: those that the whole table gives."""

import pytest

from core.case import wall_table
from core.case.many_walls import LazyWalls, group_walls
from core.case.reader import read_case
from core.case.wall_table import read_table
from core.errors import InputError

HEAD = ["Parete;z;H;t;Meccanismo", ";m;m;cm;"]


@pytest.fixture(autouse=True)
def few_rows(monkeypatch):
    """So few rows are many."""
    monkeypatch.setattr(wall_table, "MAX_ROWS", 6)


def written(path, lines):
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def walls(count: int) -> list[str]:
    return [f"w{k};0;{3 + 0.01 * k:.2f};{30 + k % 9};un lato" for k in range(count)]


@pytest.mark.parametrize(
    "lines",
    [
        [*HEAD, *walls(20)],
        ["Parete;z [m];H [m];t [cm];Meccanismo", *walls(20)],
        ["sep=;", "Parete;z [m];H [m];t [cm];Meccanismo", *walls(20)],
        ["sep=;", *HEAD, *walls(20)],
        ["# survey of May", "", "Parete;z [m];H [m];t [cm];Meccanismo", *walls(20)],
        ["", "", "", *HEAD, *walls(20)],
        ["", *HEAD, "", *walls(9), ";;;;", *walls(30)[9:]],
        [
            "notes;" + HEAD[0],
            ";" + HEAD[1],
            '" \n ";"a ""b""";0;4,5;40;su due lati',
            *(f";{line}" for line in walls(9)),
        ],
    ],
)
def test_that_the_walls_are_those_of_the_whole_table(tmp_path, monkeypatch, lines):
    path = written(tmp_path / "walls.csv", lines)
    many, _, *_ = read_table(path, True, many=True)
    assert isinstance(many, LazyWalls)
    monkeypatch.setattr(wall_table, "MAX_ROWS", 2000)
    known, _, *_ = read_table(path, True)
    assert list(many) == known == [many[k] for k in range(len(many))]
    with pytest.raises(IndexError):
        many[len(many)]


def test_that_a_long_table_is_refused_where_all_walls_are_to_be_shown(tmp_path):
    with pytest.raises(InputError) as caught:
        read_table(written(tmp_path / "walls.csv", [*HEAD, *walls(20)]))
    assert caught.value.code == "table_too_large"


def case_of(tmp_path, lines):
    written(tmp_path / "walls.csv", lines)
    path = tmp_path / "case.toml"
    path.write_text('walls = "walls.csv"\n[[wall]]\nname = "own"\nheight_m = 4\nthickness_m = 0.4\n'
                    'mechanism = "two_sided"\nbase_z_m = 0\n[demand]\nag_g = 0.1\n')  # fmt: skip
    return path


def test_that_the_walls_of_the_case_stand_before_those_of_its_table(tmp_path):
    case = read_case(case_of(tmp_path, [*HEAD, *walls(20)]), many=True)
    assert [wall.name for wall in case.wall][:3] == ["own", "w0", "w1"] and len(case.wall) == 21
    assert case.table == "walls.csv" and case.walls is None and len(case.sha256) == 64


@pytest.mark.parametrize(
    "line, code, said",
    [
        ("w3;0;4;40;un lato", "same_name", "w3"),
        ("own;0;4;40;un lato", "same_name", "own"),
        ("x;0;four;40;un lato", "not_a_number", "row 23"),
        ("x;;4;40;un lato", "base_missing", "row 23"),
        ("x;0;4;40;un lato;1", "value_beyond_columns", "row 23"),
        ("x;0;4;900000;un lato", None, "row 23"),
    ],
)
def test_that_a_wrong_row_is_refused_by_its_number(tmp_path, line, code, said):
    with pytest.raises(InputError) as caught:
        read_case(case_of(tmp_path, [*HEAD, *walls(20), line]), many=True)
    assert said in caught.value.text("en") and code in (None, caught.value.code)


def test_that_a_long_table_without_titles_is_refused(tmp_path):
    for lines, code in (([f"{k}" for k in range(20)], "unknown_column"), ([""] * 20, "table_rows")):
        with pytest.raises(InputError) as caught:
            read_table(written(tmp_path / "walls.csv", lines), many=True)
        assert caught.value.code == code


def test_that_walls_of_one_name_are_never_in_two_groups(tmp_path):
    lines = ["Parete;variant;z;H;t;Meccanismo", ";;m;m;m;"]
    lines += [f"w{k % 13};{('stato di fatto', 'progetto')[k // 13]};0;4;0.4;un lato" for k in range(26)]
    many, _, *_ = read_table(written(tmp_path / "walls.csv", lines), True, many=True)
    groups = group_walls(many, 3)
    assert sorted(k for group in groups for k in group) == [*range(26)]
    names = [{many[k].name for k in group} for group in groups]
    assert all(not one & other for k, one in enumerate(names) for other in names[:k])
    assert [many[group[0]].name for group in groups][:2] == ["w0", "w2"] and max(map(len, groups)) <= 4


MODES = (
    "[building]\nheight_m = 12\nstoreys = 3\n[[building.modes]]\nperiod_s = 0.3\ndamping = 0.05\nparticipation = 1.2\n"
)


@pytest.mark.parametrize("other", ["3", "6,5"])
def test_that_modes_are_refused_with_walls_of_a_long_table_at_two_heights(tmp_path, other):
    lines = ["Parete;z;H;t;Meccanismo;Cerniere", ";m;m;cm;;", *(f"w{k};3;3;40;un lato;base" for k in range(20))]
    path = case_of(tmp_path, [*lines, f"x;{other};3;40;un lato;base"])
    path.write_text(path.read_text() + MODES)
    if other == "3":
        assert len(read_case(path, many=True).wall) == 22
        return
    with pytest.raises(InputError, match="there are walls at 3 m and 6.5 m"):
        read_case(path, many=True)


def test_that_thousands_are_asked_about_in_a_long_table_with_decimal_commas_alone(tmp_path):
    """As in a short one: `1.250` is 1.25 where no number has a comma."""
    lines = [*HEAD, *walls(20), "x;1.250;4;40;un lato"]
    many, _, *_ = read_table(written(tmp_path / "walls.csv", lines), True, many=True)
    assert many[20].base_z_m == 1.25
    commas = [line.replace(".", ",") for line in lines[:-1]]
    many, _, *_ = read_table(written(tmp_path / "walls.csv", commas), True, many=True)
    assert many[7].height_m == 3.07
    with pytest.raises(InputError, match=r"row 23: .*1\.250"):
        read_table(written(tmp_path / "walls.csv", [*commas, lines[-1]]), True, many=True)


def test_that_a_long_table_has_up_to_160_columns(tmp_path):
    for columns in (160, 161):
        marks = ";" * (columns - 5)
        path = written(tmp_path / "walls.csv", [line + marks for line in (*HEAD, *walls(20))])
        if columns == 160:
            assert len(read_table(path, True, many=True)[0]) == 20
            continue
        with pytest.raises(InputError, match="more than 2000000 rows or 160 columns"):
            read_table(path, True, many=True)
