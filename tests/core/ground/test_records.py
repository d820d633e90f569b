"""Readers: the shelf against INDEX.csv, and the grammar on files made here."""

import numpy as np
import pytest

from core.errors import InputError, RecordError
from core.ground import records
from core.ground.records.grammar import Options
from core.units import CM, G
from tests.core.ground import dialects
from tests.core.ground.networks_made import nsmn
from tests.core.ground.record_texts import MOTION, column, peer, two

READ = ("PEER_AT2", "ESM_ASCII", "SIGMA_ITACA_acc", "plain_txt", "COSMOS_CSMIP", "KNET_KIKNET", "SMC", "GEONET")

ASKED = {
    "PEER_AT2/AND270.AT2": {"unit": "g"},
    "PEER_AT2/IELC180.acc": {"unit": "g", "time_step": 0.01},
    "plain_txt/sct190985.txt": {"unit": "g", "column": 3},
    "plain_txt/tabasFN.txt": {"unit": "g", "time_step": 0.02},
    "COSMOS_CSMIP/BadHeader.V2": {"channel": "1"},
    "COSMOS_CSMIP/CE58667.V2": {"channel": "1"},
    "COSMOS_CSMIP/ce36456p_CE36456.V2": {"channel": "1"},
    "GEONET/20161113_110300_HSES_20.V1A": {"channel": "1"},
    "GEONET/20180212_211557_WPWS_20.V2A": {"channel": "1"},
}
"""What these files do not say."""


def options_of(file: str, row: dict) -> Options:
    given = dict(ASKED.get(file, {}))
    if file.startswith("plain_txt") and "unit" not in given:
        given["unit"] = row["units_in_file"].split()[0]
    return Options(**given)


@pytest.mark.shows("mechanics.measures")
def test_that_every_file_of_these_formats_has_its_known_measures(shelf, index):
    read = 0
    for file, row in index.items():
        if not file.startswith(READ) or not row["pga_g"]:
            continue
        factor = 1.0
        if "is x" in row["units_in_file"]:  # haselREC: the numbers are of the unscaled record
            factor = 1.0 / float(row["units_in_file"].split("x")[1].rstrip(")"))
        found = records.read(shelf / file, options_of(file, row), factor)
        measures = (
            (found.pga / G, "pga_g", 1e-4),
            (found.housner_intensity / CM, "SI_psv5_cm", 0.01),
            (found.pgv / CM, "pgv_cm_s", 0.01),
            (found.arias, "arias_m_s", 0.001),
        )
        for value, key, digit in measures:
            known = float(row[key])
            assert abs(value - known) <= max(0.005 * known, 0.5001 * digit), (file, key)
        assert found.acceleration.size == int(row["npts"]), file
        assert found.time_step == pytest.approx(float(row["dt_s"]), rel=1e-9), file
        read += 1
    assert read >= 67


@pytest.mark.parametrize("step", [5, pytest.param(1, marks=pytest.mark.long)])
def test_that_every_file_of_the_shelf_is_read_or_refused_in_one_sentence(shelf, index, step):
    """step : one file of so many"""
    for file in list(index)[::step]:
        for options in (Options(), Options(unit="g", time_step=0.01)):
            try:
                records.read(shelf / file, options)
            except RecordError as error:
                assert "\n" not in str(error)
                assert str(shelf) in str(error)


@pytest.mark.shows("records.plain")
@pytest.mark.parametrize(
    "content, options",
    [
        (column(), {"unit": "m/s2", "time_step": 0.01}),
        (two(), {"unit": "m/s2"}),
        (two("\t"), {"unit": "m/s2"}),
        (two(","), {"unit": "m/s2"}),
        (two(", "), {"unit": "m/s2"}),
        (two(";", decimal=","), {"unit": "m/s2"}),
        (two("\t", decimal=","), {"unit": "m/s2"}),
        (two(";"), {"unit": "m/s2"}),
        (two(end="\r\n"), {"unit": "m/s2"}),
        (two(end="\r\r\n"), {"unit": "m/s2"}),
        (two(end="\r"), {"unit": "m/s2"}),
        ("\ufeff" + two(), {"unit": "m/s2"}),
        (two() + "\x1a", {"unit": "m/s2"}),
        (two(shape="{:.6E}").replace("E", "D"), {"unit": "m/s2"}),
        ("a title\n40 0.01\n" + column(), {"unit": "m/s2"}),
        ("40 0.01\n" + two(), {"unit": "m/s2"}),
        ("# Acceleration (m/s2), dt=0.0100s\n" + column(), {}),
        ("Time[s] Accel[m/s2]\n" + two(), {}),
        ("one\ntwo 2\n" + two(), {"unit": "m/s2", "skip_lines": 2}),
    ],
)
def test_that_plain_text_is_read_under_every_accepted_dress(write, content, options):
    found = records.read(write(content), Options(**options))
    assert np.array_equal(found.acceleration, MOTION)
    assert found.time_step == 0.01


@pytest.mark.parametrize("encoding", ["utf-16", "latin-1", "utf-8-sig"])
def test_that_encodings_are_understood(write, encoding):
    path = write("# accelerazione misurata così\n" + two(), encoding=encoding)
    assert np.array_equal(records.read(path, Options(unit="m/s2")).acceleration, MOTION)


def test_that_units_convert_with_standard_gravity(write):
    for unit, factor in (("g", 9.80665), ("cm/s2", 0.01), ("mm/s2", 0.001), ("m/s2", 1.0)):
        found = records.read(write(two()), Options(unit=unit))
        assert np.array_equal(found.acceleration, MOTION * factor)


def test_that_glued_negative_fields_are_split(write):
    values = -np.abs(MOTION) - 1e-8
    assert "E-01-" in peer(values=values)
    found = records.read(write(peer(values=values)))
    assert np.allclose(found.acceleration, values * G, rtol=1e-7)


@pytest.mark.parametrize("step", [".01000", "0.1000E-01", "1.0D-2", "10.0E-3"])
def test_that_a_time_step_with_an_exponent_is_read_whole(write, step):
    assert records.read(write(peer(step=step))).time_step == 0.01


def test_that_times_rounded_in_print_are_even(write):
    """256 samples a second printed to the millisecond: steps of 0.003 and 0.004."""
    rows = [f"{k / 256:.3f} {a:.5f}" for k, a in enumerate(np.tile(MOTION, 20))]
    found = records.read(write("\n".join(rows)), Options(unit="g"))
    assert found.time_step == pytest.approx(1 / 256, rel=1e-3)


def test_that_a_short_last_line_is_accepted_and_said(write):
    found = records.read(write(peer(declared=42, values=np.append(MOTION, [0.5]))))
    assert found.acceleration.size == 41
    assert "incomplete" in found.warnings[0].text()


def test_that_missing_files_and_folders_are_one_sentence(tmp_path):
    with pytest.raises(RecordError, match="no such file"):
        records.read(tmp_path / "nowhere.txt")
    with pytest.raises(RecordError, match="not a file"):
        records.read(tmp_path)


def test_that_the_shortest_step_that_explains_the_print_is_taken(write, shelf):
    rows = [f"{0.0039 * k:.3f} {a:.5f}" for k, a in enumerate(np.tile(MOTION, 50))]
    assert records.read(write("\n".join(rows)), Options(unit="g")).time_step == 0.0039
    given = records.read(write("\n".join(rows)), Options(unit="g", time_step=0.0039))
    assert given.time_step == 0.0039
    for name, dt in (("Kobe.dat", 0.02), ("CHV1-20140203E.txt", 0.005)):
        unit = "cm/s2" if name.startswith("CHV1") else "m/s2"
        assert records.read(shelf / "plain_txt" / name, Options(unit=unit)).time_step == dt


def test_that_a_title_may_speak_of_a_corrected_acceleration(write):
    found = records.read(write("Corrected acceleration of El Centro\n" + two()), Options(unit="g"))
    assert found.format == "plain text"


@pytest.mark.parametrize("comment, step", [("dt = 0,01 s", 0.01), ("dt = 5 ms", 0.005)])
def test_that_a_time_step_in_a_comment_keeps_its_unit(write, comment, step):
    found = records.read(write(f"# {comment}\n" + column()), Options(unit="g"))
    assert found.time_step == step


@pytest.mark.parametrize("pattern", ["**foo*.txt", "x" * 300 + "*", "[", "a\0b*"])
def test_that_an_impossible_pattern_is_one_sentence(tmp_path, pattern):
    try:
        paths = records.expand(pattern, tmp_path)
    except InputError as error:
        assert "\n" not in str(error)
    else:
        with pytest.raises(InputError):
            records.read(paths[0])


def test_that_a_glob_without_match_is_an_error(tmp_path, write):
    write(two(), "a.txt")
    write(two(), "b.txt")
    names = [path.name for path in records.expand("*.txt", tmp_path)]
    assert names == ["a.txt", "b.txt"]
    with pytest.raises(InputError, match="no file matches"):
        records.expand("*.AT2", tmp_path)


def test_that_suspicious_peaks_are_warned_of(write):
    large = records.read(write(two()), Options(unit="g"), 3.0)
    assert any("above 2 g" in warning.text() for warning in large.warnings)
    small = records.read(write(two(shape="{:.5f}")), Options(unit="mm/s2"))
    assert any("below 0.001 g" in warning.text() for warning in small.warnings)


def test_that_an_offset_of_the_baseline_is_warned_of(tmp_path):
    rng = np.random.default_rng(4)
    samples = rng.normal(size=3000)
    samples -= samples.mean()
    for offset, codes in ((0.0, []), (0.1, ["offset"])):
        path = tmp_path / f"{offset}.txt"
        path.write_text("\n".join(f"{0.01 * k:.2f} {u + offset:.6f}" for k, u in enumerate(samples)))
        motion = records.read(path, Options("m/s2"))
        assert [w.code for w in motion.warnings if w.code in ("offset",)] == codes


@pytest.mark.parametrize(
    "head, unit",
    [
        ("PGA = 0.31 g at 4.2 s\nTime [s] Accel [m/s2]\n", "m/s2"),
        ("# Matched acceleration (g), dt=0.01s\n# Target Spectrum: ASCE7.txt\n", "g"),
        ("PGA 1.0 (m/s2)\nacceleration in m/s2\n", "m/s2"),
        ("Epicentral distance (m) 12\nVs30 300 [m/s]\nAcc (g)\n", "g"),
        ("periodo di ritorno TR=475\nt [s]  Acc (g)\n", "g"),
        ("SD = 0.2\nAcc (g)\n", "g"),
    ],
)
def test_that_one_unit_said_twice_or_beside_a_number_without_brackets_is_read(write, head, unit):
    assert records.read(write(head + two())).unit == unit


@pytest.mark.parametrize("step, shape", [(1 / 204.8, ".10f"), (0.003052, ".3f"), (1 / 300, ".4f")])
def test_that_a_step_of_any_length_is_found_in_times_as_printed(step, shape, write):
    # 1/204.8 s is no round number; of 0.003052 s in thousandths 5.2 % of the steps are 0.004
    rows = [f"{k * step:{shape}} {MOTION[k % 40]:g}" for k in range(1000)]
    found = records.read(write("\n".join(rows) + "\n"), Options("m/s2"))
    # the last of the 1000 times within a thousandth of a step
    assert 999 * abs(found.time_step - step) <= 1e-3 * step


def test_that_the_lines_of_a_plain_file_are_counted(write):
    """Above the samples, of samples, below them."""
    found = records.read(write(f"title\nsite\n{two()}"), Options("m/s2"))
    assert found.lines == (2, 40, 0)
    assert records.read(write(two()), Options("m/s2")).lines == (0, 40, 0)
    assert records.read(write(peer())).lines == (4, 8, 0)


@pytest.mark.parametrize("blank", [" \n", "\t\n \n"])
def test_that_blank_lines_at_the_end_of_a_table_are_none_of_it(write, blank):
    for end in (blank, 3 * blank):
        found = records.read(write(nsmn().decode() + end), Options(channel="N-S"))
        assert np.array_equal(found.acceleration, dialects.MOTION)
    rows, _, last = nsmn().decode().rstrip("\n").rpartition("\n")
    with pytest.raises(RecordError) as refused:  # two rows in one line
        records.read(write(f"{rows} {last}\n{blank}"), Options(channel="N-S"))
    assert refused.value.code == "columns_not"


def test_that_no_end_of_blanks_takes_more_than_linear_time(write):
    """Each blank line took a copy of all others, minutes for these; each empty cell one of its line."""
    blank = " \n" * 100_000
    assert np.array_equal(records.read(write(column() + "\n" + blank), Options("m/s2", 0.01)).acceleration, MOTION)
    with pytest.raises(RecordError, match="8 samples are too few"):
        records.read(write("\n".join(column().split()[:8]) + "\n" + blank), Options("m/s2", 0.01))
    cells = "".join(f"{a:.5f}{';' * 19_900}\n" for a in MOTION[:10])
    assert np.array_equal(records.read(write(cells), Options("m/s2", 0.01)).acceleration, MOTION[:10])


def test_that_components_side_by_side_are_taken_by_their_number(write):
    rows = "".join(f"{a:.5f} {a / 2:.5f} {a / 4:.5f}\n" for a in MOTION)
    content = f"dt 0.01 s\nN-S  E-W  U-D\n{rows}"
    for number, share in ((1, 1.0), (2, 2.0), (3, 4.0)):
        found = records.read(write(content), Options("m/s2", column=number))
        assert np.allclose(found.acceleration, MOTION / share, atol=5e-6)
        assert ("vertical" in {warning.code for warning in found.warnings}) == (number == 3)
    with pytest.raises(RecordError) as refused:
        records.read(write(content), Options("m/s2", column=4))
    assert refused.value.code == "component_out_of_range"


@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize(("head", "given"), [("", 0.02), ("dt = 0.02 s\n", None), ("dt = 0.02 s\n", 0.02)])
def test_that_a_column_that_counts_the_samples_is_no_time(write, first, head, given):
    rows = "".join(f"{k} {a:.5f}\n" for k, a in enumerate(MOTION, start=first))
    found = records.read(write(head + rows), Options("m/s2", given))
    assert found.time_step == 0.02 and np.array_equal(found.acceleration, MOTION)
