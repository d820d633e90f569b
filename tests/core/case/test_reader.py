"""Case files: read, or refused in one sentence."""

import pytest

from core.case.reader import read_case
from core.errors import InputError


@pytest.mark.shows("case.refused")
def test_that_files_that_are_no_case_are_one_sentence(tmp_path):
    for name, content, word in (
        ("a.toml", b"[[wall\n", "not TOML"),
        ("b.toml", b"\xff\xfe\x00\x01", "not UTF-8"),
        ("c.toml", b"just words", "not TOML"),
        ("d.toml", b"x = " + b"[" * 5000, "not TOML"),
        ("e.toml", b"x = 1" + b"0" * 5000, "not TOML|unknown key"),
    ):
        path = tmp_path / name
        path.write_bytes(content)
        with pytest.raises(InputError, match=word) as caught:
            read_case(path)
        assert name in str(caught.value)
    with pytest.raises(InputError, match="no such case"):
        read_case(tmp_path / "nowhere.toml")
    with pytest.raises(InputError, match="not a file"):
        read_case(tmp_path)
    (tmp_path / "date.toml").write_text(
        '[report]\ndate = 2026-01-05\n[[wall]]\nname = "w"\nheight_m = 3.0\nthickness_m = 0.3\nmechanism = "both"\n'
    )
    assert read_case(tmp_path / "date.toml").report.date == "2026-01-05"


def test_that_every_shipped_case_can_be_read():
    from tests.conftest import ROOT

    shipped = sorted((ROOT / "resources" / "cases").glob("*.toml"))
    assert shipped
    for path in shipped:
        assert read_case(path).wall


def test_that_a_key_of_thousands_of_parts_is_refused_at_once(tmp_path):
    path = tmp_path / "c.toml"
    for text in ("a." * 30000 + "b = 1", "[" + "a." * 30000 + "b]", "[[" + "a . " * 9000 + "b]]"):
        path.write_text(f'title = "x"\n{text}\n')
        with pytest.raises(InputError, match="more than 50 parts"):
            read_case(path)


@pytest.mark.shows("case.refused")
@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("0,83  # m", "line 3: 0,83 has a comma"),
        ("'0,83'", "without quotes .* thickness_m = 0.83"),
        ("'0.83'", "without quotes"),
    ],
)
def test_that_a_decimal_comma_and_a_quoted_number_are_named(tmp_path, written, words):
    path = tmp_path / "c.toml"
    path.write_text(f"[[wall]]\nname = 'a, 0,5'\nthickness_m = {written}\nheight_m = 7.0\nmechanism = 'one_sided'\n")
    with pytest.raises(InputError, match=words):
        read_case(path)


@pytest.mark.parametrize(
    ("path", "code"),
    [("C:\\Users\\anna\\rec.txt", "toml_backslash"), ("C:\\temp\\new.txt", "path_escaped"), ("C:/temp/new.txt", None)],
)
def test_that_a_path_with_backslashes_is_told_how_it_is_written(tmp_path, path, code):
    case = tmp_path / "case.toml"
    wall = '[[wall]]\nname = "w"\nheight_m = 6.0\nthickness_m = 0.6\nmechanism = "two_sided"\nbase_z_m = 0.0\n'
    case.write_text(f'{wall}[[record]]\nunit = "g"\nfile = "{path}"\n', encoding="utf-8")
    if code is None:
        assert read_case(case).record[0].file == path
        return
    with pytest.raises(InputError) as refused:
        read_case(case)
    assert refused.value.code == code and "single quotes" in str(refused.value) and "\n" not in str(refused.value)
    case.write_text(f"{wall}[[record]]\nunit = \"g\"\nfile = '{path}'\n", encoding="utf-8")
    assert read_case(case).record[0].file == path
