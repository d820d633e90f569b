"""Readers: the shelf against INDEX.csv, and the grammar on files made here."""

import numpy as np
import pytest

from core import records
from core.errors import InputError, RecordError
from core.records.grammar import Options
from core.units import CM, G

READ = ("PEER_AT2", "ESM_ASCII", "SIGMA_ITACA_acc", "plain_txt")

ASKED = {
    "PEER_AT2/AND270.AT2": {"unit": "g"},
    "PEER_AT2/IELC180.acc": {"unit": "g", "time_step": 0.01},
    "plain_txt/sct190985.txt": {"unit": "g", "column": 3},
    "plain_txt/tabasFN.txt": {"unit": "g", "time_step": 0.02},
}
"""What these files do not say."""

MOTION = np.round(np.sin(np.arange(40) * 0.7) * np.exp(-0.05 * np.arange(40)), 5)


def options_of(file: str, row: dict) -> Options:
    given = dict(ASKED.get(file, {}))
    if file.startswith("plain_txt") and "unit" not in given:
        given["unit"] = row["units_in_file"].split()[0]
    return Options(**given)


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
    assert read >= 50


def test_that_what_is_no_acceleration_is_refused(shelf):
    for file, word in (
        ("PEER_AT2/IELC180.DT2", "displacement"),
        ("PEER_AT2/RSN57_SFERN_ORR021.VT2", "velocity"),
        ("plain_txt/RSN1044_Damping5.txt", "spectrum"),
        ("plain_txt/SeismoSignal_Imperial_Valley.txt", "spectrum"),
        ("plain_txt/oqvmtk_dts_1.csv", "time column"),
        ("SAC_MSEED/20190706031952.CJ.T001230.HNE.sac", "binary"),
        ("SAC_MSEED/TA.M04C..HNE_20140824.mseed", "binary"),
        ("KNET_KIKNET/test.knet", "K-NET"),
        ("SMC/0111a.smc", "SMC"),
        ("GEONET/20180212_211557_WPWS_20.V2A", "not read yet"),
    ):
        with pytest.raises(RecordError, match=word):
            records.read(shelf / file)


def test_that_a_velocity_without_unit_is_not_guessed(shelf):
    with pytest.raises(RecordError, match="give unit"):
        records.read(shelf / "plain_txt/RSN1063_NORTHR_RRS228.txt")


def test_that_every_file_of_the_shelf_is_read_or_refused_in_one_sentence(shelf, index):
    for file in index:
        for options in (Options(), Options(unit="g", time_step=0.01)):
            try:
                records.read(shelf / file, options)
            except RecordError as error:
                assert "\n" not in str(error)
                assert str(shelf) in str(error)


@pytest.fixture
def write(tmp_path):
    def make(content, name="motion.txt", encoding="utf-8"):
        path = tmp_path / name
        data = content if isinstance(content, bytes) else content.encode(encoding)
        path.write_bytes(data)
        return path

    return make


def column(separator="\n", shape="{:.5f}"):
    return separator.join(shape.format(value) for value in MOTION)


def two(separator=" ", shape="{:.5f}", end="\n", decimal=".", every=0.01, places=2):
    rows = [f"{every * k:.{places}f}{separator}{shape.format(a)}" for k, a in enumerate(MOTION)]
    return end.join(rows).replace(".", decimal) + end


def thousandths(drop=None, double=None, jump=None):
    """Times printed to the millisecond at 1 kHz: the print is as coarse as the step."""
    rows = [f"{0.001 * k + (0.001 if jump and k > jump else 0):.3f} {a:.5f}"
            for k, a in enumerate(MOTION)]  # fmt: skip
    if drop:
        del rows[drop]
    if double:
        rows.insert(double, rows[double])
    return "\n".join(rows)


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


def peer(declared=40, values=None, unit="ACCELERATION TIME HISTORY IN UNITS OF G", step=".01000"):
    body = [f"{value:14.7E}" for value in (MOTION if values is None else values)]
    rows = ["".join(body[k : k + 5]) for k in range(0, len(body), 5)]
    head = ["PEER STRONG MOTION DATABASE RECORD", "EVENT, STATION", unit,
            f"NPTS= {declared}, DT= {step} SEC"]  # fmt: skip
    return "\n".join(head + rows) + "\n"


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


@pytest.mark.parametrize(
    "content, options, word",
    [
        (peer(declared=60), {}, "declares 60"),
        (peer(declared=30), {}, "declares 30"),
        (peer(unit="VELOCITY TIME HISTORY IN UNITS OF CM/S"), {}, "velocity"),
        (peer(unit="ACCELERATION TIME HISTORY"), {}, "give unit"),
        (peer(), {"unit": "m/s2"}, "states unit g"),
        (peer(), {"time_step": 0.02}, "states time_step_s"),
        (peer().replace("E-01", "E-0x", 1), {}, "not numbers"),
        (column(), {"unit": "g"}, "give time_step_s"),
        (peer(unit="ACCELERATION IN UNITS OF CM/S/S"), {"unit": "g"}, "states unit cm/s2"),
        (peer(unit="ACCELERATION IN UNITS OF G/10"), {"unit": "g"}, "g/10"),
        (peer(step="0.0.1"), {"unit": "g"}, "0.0.1|columns|numbers"),
        ("Time [s]  Acc. [cm/s2]\n" + two(), {"unit": "g"}, "states unit cm/s2"),
        ("t  Acceleration [m/s²]\n" + two(), {"unit": "g"}, "states unit m/s2"),
        ("# Units: cm/s2\n" + two(), {"unit": "g"}, "states unit cm/s2"),
        ("Tempo [s];Velocità [cm/s]\n" + two(";"), {"unit": "cm/s2"}, "velocità"),
        ("t [s] v [m/s]\n" + two(), {"unit": "m/s2"}, "m/s: this is not"),
        ("0.00 nan\n0.01 nan\n" + two(), {"unit": "g"}, "line 1.*gap"),
        ("inf\n" + column(), {"unit": "g", "time_step": 0.01}, "line 1.*gap"),
        ("********\n" + column(), {"unit": "g", "time_step": 0.01}, "line 1.*gap"),
        ("41\n0.01\n" + column(), {"unit": "g", "time_step": 0.01}, "count of samples"),
        ("1940\n" + column(), {"unit": "g", "time_step": 0.01}, "beyond any earthquake"),
        (two().replace("0.61280", "6.1e200"), {"unit": "g"}, "beyond any earthquake"),
        (column().replace("0.61280", "6.1e400"), {"unit": "g", "time_step": 0.01}, "line 2"),
        (two(every=1e-9, places=12), {"unit": "g"}, "1e-05 to 0.5 s"),
        (two(), {}, "give unit"),
        (two().replace("0.05 ", "0.06 "), {"unit": "g"}, "sorted and even"),
        (two().replace("0.05 ", "0.03 "), {"unit": "g"}, "sorted and even"),
        (thousandths(drop=20), {"unit": "g"}, "without gaps"),
        (thousandths(double=20), {"unit": "g"}, "without gaps"),
        (thousandths(jump=20), {"unit": "g"}, "without gaps"),
        ("# dt=0.01\n" + two(every=0.02), {"unit": "g"}, "header states a time step"),
        ("40 0.02\n" + two(), {"unit": "g"}, "header states a time step"),
        (peer(step="5.0E+00"), {}, "time step 5 s"),
        (two() + "\n0.41 nan\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 inf\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 1_000\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 ١٢\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 1e400\n", {"unit": "g"}, "too large"),
        (two() + "0.40 1 2\n", {"unit": "g"}, "3 columns"),
        (two(" ", "{0:.5f} {0:.5f}"), {"unit": "g"}, "3 columns: say which"),
        (two(" ", "{0:.5f} {0:.5f}"), {"unit": "g", "column": 7}, "column = 7"),
        (peer(), {"column": 2}, "leave it out"),
        ("40 0.01\n" + column()[:200], {"unit": "g"}, "declares 40"),
        ("", {"unit": "g"}, "empty"),
        ("just words\n", {"unit": "g"}, "no numbers"),
        ("0.1\n0.2\n", {"unit": "g", "time_step": 0.01}, "too few"),
        ("0\n" * 50, {"unit": "g", "time_step": 0.01}, "zero"),
        (b"\x00\x01\x02\x03" * 100, {"unit": "g"}, "binary"),
        (two(), {"unit": "furlong"}, "furlong"),
    ],
)
def test_that_a_bad_file_is_refused_in_one_sentence(write, content, options, word):
    with pytest.raises(RecordError, match=word) as caught:
        records.read(write(content), Options(**options))
    assert "motion.txt" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_that_gaps_inside_a_record_are_refused_and_nan_tails_dropped(write):
    text = peer(declared=40, values=MOTION)
    nan_tail = text + "NaN NaN NaN\n"
    found = records.read(write(nan_tail))
    assert found.acceleration.size == 40
    assert "3 surplus zeros or NaN at the end were dropped" in found.warnings[0].text()
    zeros = records.read(write(text + "0.0 0.0\nNaN NaN\n"))
    assert "4 surplus zeros or NaN" in zeros.warnings[0].text()
    rows = text.splitlines()
    rows[6] = "NaN " * 5
    with pytest.raises(RecordError, match="gap"):
        records.read(write("\n".join(rows)))


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
        path.write_text(
            "\n".join(f"{0.01 * k:.2f} {u + offset:.6f}" for k, u in enumerate(samples))
        )
        motion = records.read(path, Options("m/s2"))
        assert [w.code for w in motion.warnings if w.code != "ends_moving"] == codes


CUT = {
    "PEER_AT2/ARL360.at2": {}, "PEER_AT2/IELC180.AT2": {}, "PEER_AT2/elCentro_variant_noheader4.AT2": {},
    "PEER_AT2/AND270.AT2": {"unit": "g"}, "SIGMA_ITACA_acc/16839_H1.cor.acc": {},
    "plain_txt/RSN175_IMPVALL.H_H-E12140_ASCE7_Matched_1col.txt": {},
    "plain_txt/Hollister.dat": {"unit": "m/s2"}, "plain_txt/OpenSees_Northridge.dat": {},
    "plain_txt/eqsig_test_motion_dt0p01.txt": {"unit": "m/s2"}, "plain_txt/P695_SortedEQFile_121221.txt": {"unit": "g"},
}  # fmt: skip
COUNTED = ("PEER_AT2", "SIGMA", "plain_txt/eqsig")


@pytest.mark.parametrize("file", CUT)
def test_that_a_file_cut_at_any_byte_of_its_end_gives_no_other_sample(shelf, file):
    """What is left is refused, or holds the same samples; whole lines may go where no count is declared."""
    content, options = (shelf / file).read_bytes(), Options(**CUT[file])
    whole = records._motion(content, shelf / file, options, 1.0, "x").acceleration
    for missing in range(1, 90):
        try:
            found = records._motion(
                content[:-missing], shelf / file, options, 1.0, "x"
            ).acceleration
        except RecordError:
            continue
        assert np.array_equal(found, whole[: found.size]), missing
        assert found.size == whole.size or not file.startswith(COUNTED), missing


@pytest.mark.parametrize(
    "text, last",
    [
        ("1.822073E-03", "1.822073E-0"), ("-.1822073E-03", "-.1822073E-"), ("0.01234", "0.0123"),
        ("12.5", "12."), ("1.5e-05", "1.5e-0"), ("0.0123", "0.01"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("end", ["", "\n"])
def test_that_a_last_number_shorter_than_those_above_is_refused(write, text, last, end):
    content = "\n".join([text] * 30)
    records.read(write(content + "\n"), Options("m/s2", 0.01))
    with pytest.raises(RecordError):
        records.read(write(content + "\n" + last + end), Options("m/s2", 0.01))


def test_that_numbers_of_no_one_shape_need_a_line_end(write):
    content = "\n".join(f"{value:g}" for value in MOTION)
    assert records.read(write(content + "\n"), Options("m/s2", 0.01)).acceleration.size == 40
    with pytest.raises(RecordError, match="without a line end"):
        records.read(write(content), Options("m/s2", 0.01))


@pytest.mark.parametrize(
    "head, words",
    [
        ("gravity = 9.81 [m/s2]\nTime [s]  Acc [g]\n", ["m/s2", "g in"]),
        ("PGA 0.013 (g)\nacceleration in cm/s2\n", ["cm/s2", "g in"]),
        ("units: cm/s2\nTime [s] Accel [g]\n", ["cm/s2", "g in"]),
        ("units: cm/s2\nacceleration in m/s2\nTime [s] Accel [g]\n", ["cm/s2 in", "m/s2 in"]),
        ("Velocity (cm/s)\n(g)\n", ["velocity"]),
        ("Vel. of the station (g)\n", ["vel"]),
        ("# UNITS OF CM/S\n", ["cm/s"]),
        ("T Sa\n", ["sa: this"]),
        ("Period (s), PSA (g)\n", ["period"]),
        ("Acceleration response spectrum [g]\n", ["spectrum"]),
        ("units: m/s\n", ["m/s"]),
        ("Unit: cm\n", ["cm"]),
        ("units = cm/s\n", ["cm/s"]),
        ("units cm/sec\n", ["cm/sec"]),
        ("t v [cm/sec.]\n", ["cm/sec"]),
        ("time velocity_x\n", ["velocity_x"]),
        ("displacements\n", ["displacements"]),
        ("VelX\n", ["velx"]),
        ("acc integrated to velocity (cm/s)\n", ["velocity"]),
        ("Accelerometer: velocity\n", ["velocity"]),
        ("Accra station velocity [cm/s]\n", ["velocity"]),
        ("T Se(T) (g)\n", ["se: this"]),
        ("Pseudo acceleration (g)\n", ["pseudo"]),
        ("Frequency (Hz) Amplitude (g)\n", ["frequency"]),
        ("Fourier [g]\n", ["fourier"]),
        ("Periods(s) (g)\n", ["periods"]),
    ],
)
@pytest.mark.parametrize("unit", [None, "g", "cm/s2"])
def test_that_two_units_or_another_quantity_are_refused_whatever_is_given(write, head, words, unit):
    with pytest.raises(RecordError) as caught:
        records.read(write(head + two()), Options(unit))
    assert all(word in str(caught.value) for word in words)


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


@pytest.mark.parametrize(
    "head",
    [
        "PGA 0.013 (g)",
        "PGA (g): 0.9",
        "PGA [g]: 0.31",
        "PGA (g) 0.31",
        "Max acc (g): 0.3",
        "gravity 9.81 (m/s2)",
    ],
)
def test_that_the_unit_of_one_value_is_not_that_of_the_samples(write, head):
    with pytest.raises(RecordError, match="give unit"):
        records.read(write(f"{head}\n" + two()))


def test_that_a_column_of_another_quantity_is_refused(write):
    rows = "\n".join(f"{0.01 * k:.2f} {a:.5f} {3 * a:.5f}" for k, a in enumerate(MOTION)) + "\n"
    for head in (
        "Time[s] Acc[g] Vel[cm/s]\n",
        "Time[s];Acc[g];Vel[cm/s]\n",
        "t  acc  displacement\n",
    ):
        content = head + (rows.replace(" ", ";") if ";" in head else rows)
        assert records.read(write(content), Options("g", column=2)).pga < 20.0
        with pytest.raises(RecordError, match=r"vel|displacement|cm/s"):
            records.read(write(content), Options("g", column=3))


@pytest.mark.parametrize("zero", ["0", "0.0", "0.", ".0", "-0.0"])
def test_that_a_last_zero_may_be_written_shorter(write, zero):
    content = column(shape="{:.7f}") + f"\n{zero}\n"
    assert records.read(write(content), Options("g", 0.01)).acceleration[-1] == 0.0


def test_that_names_of_stations_are_no_quantities(write):
    for station in ("Vel 3", "DISP. PLANT", "SPECTRUM HALL (m)", "PERIODO"):
        lines = peer().split("\n")
        lines[1] = f"IMPERIAL VALLEY 5/19/40, {station}, 180"
        assert records.read(write("\n".join(lines))).unit == "g"


def test_that_unsigned_glue_is_not_two_numbers(write):
    with pytest.raises(RecordError, match="not numbers"):
        records.read(write(column() + "\n1.52.5\n"), Options("g", 0.01))


def test_that_a_second_header_inside_a_record_is_refused(write):
    with pytest.raises(RecordError, match="second header|not numbers"):
        records.read(write(peer() + peer()))


def test_that_velocity_units_are_refused_in_an_at2_whatever_is_given(write):
    for unit in (None, "g", "cm/s2"):
        with pytest.raises(RecordError):
            records.read(write(peer(unit="TIME HISTORY IN UNITS OF CM/S")), Options(unit))


def test_that_a_record_without_count_that_ends_moving_is_warned_of(write):
    found = records.read(write(two().rsplit("\n", 21)[0] + "\n"), Options("m/s2"))
    assert "ends_moving" in [warning.code for warning in found.warnings]


@pytest.mark.parametrize(
    "line",
    ["1" * 4000 + " nan", "*" * 4000, "1.5" * 2000, "1 " * 2000 + "x", "1.5e" * 2000, "-" * 4000,
     "(" * 4000, "[g" * 2000, "9" * 4000 + " (g", "units " * 1000, "1,2" * 1500 + "x", " " * 4000 + "x",
     "unit" + " " * 8000 + "x", "(cm/s" + " " * 20000, "units of" + " " * 20000, "npts=1" + " " * 20000, "vel" * 5000],
)  # fmt: skip
def test_that_no_line_takes_more_than_linear_time(write, line):
    """Twice the line, about twice the steps: a backtracking grammar would need minutes at this length."""
    for content in (
        line,
        f"{line}\n{two()}",
        f"{two()}{line}\n",
        "\r" * 4000 + line,
        f"#{line}\n{two()}",
    ):
        for options in (Options("g"), Options("g", 0.01)):
            try:
                records.read(write(content), options)
            except RecordError as error:
                assert len(str(error)) < 600


def test_that_what_no_record_is_long_is_refused_before_it_takes_the_memory(write):
    with pytest.raises(RecordError, match="more than 5000000 numbers"):
        records.read(write(b"1 " * 5_000_002), Options("g", 0.01))
    with pytest.raises(RecordError, match="MB is no accelerogram"):
        records.read(write(b"1.0000\n" * 3_000_000), Options("g", 0.01))


def esm(units="cm/s^2", peak=None, duration=None):
    """A DYNA file of MOTION in this unit."""
    rows = {"SAMPLING_INTERVAL_S": "0.01", "NDATA": "40", "UNITS": units, "DATA_TYPE": "ACCELERATION",
            "PGA_CM/S^2": peak, "DURATION_S": duration}  # fmt: skip
    head = [f"{key}: {value}" for key, value in rows.items() if value is not None]
    return "\n".join([*head, *(f"{value:.6f}" for value in MOTION)]) + "\n"


def test_that_an_esm_header_that_contradicts_itself_is_refused(write):
    peak = np.abs(MOTION).max()
    assert records.read(write(esm(peak=f"{peak:.6f}", duration="0.40"))).unit == "cm/s2"
    assert records.read(write(esm("m/s^2", f"{100 * peak:.4f}", "0.39"))).warnings == ()
    for content, word in (
        (esm("m/s^2", f"{peak:.6f}"), "one of them is wrong"),
        (esm("g", f"{peak:.6f}"), "PGA_CM"),
        (esm(duration="0.80"), "DURATION_S is 0.8 s"),
        (esm(duration="0.2"), "DURATION_S"),
    ):
        with pytest.raises(RecordError, match=word):
            records.read(write(content))


@pytest.mark.parametrize("step, shape", [(1 / 204.8, ".10f"), (0.003052, ".3f"), (1 / 300, ".4f")])
def test_that_a_step_of_any_length_is_found_in_times_as_printed(step, shape, write):
    # 1/204.8 s is no round number; of 0.003052 s in thousandths 5.2 % of the steps are 0.004
    rows = [f"{k * step:{shape}} {MOTION[k % 40]:g}" for k in range(1000)]
    found = records.read(write("\n".join(rows) + "\n"), Options("m/s2"))
    # the last of the 1000 times within a thousandth of a step
    assert 999 * abs(found.time_step - step) <= 1e-3 * step
