"""Files that are no whole record of an acceleration are refused in one sentence, never read in part."""

import numpy as np
import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records.cut import refuse_cut
from core.ground.records.grammar import Options, to_float
from tests.core.ground.record_texts import MOTION, column, esm, peer, thousandths, two


def test_that_what_is_no_acceleration_is_refused(shelf):
    for file, word in (
        ("PEER_AT2/IELC180.DT2", "displacement"),
        ("PEER_AT2/RSN57_SFERN_ORR021.VT2", "velocity"),
        ("plain_txt/RSN1044_Damping5.txt", "spectrum"),
        ("plain_txt/SeismoSignal_Imperial_Valley.txt", "spectrum"),
        ("plain_txt/oqvmtk_dts_1.csv", "time column"),
        ("SAC_MSEED/20190706031952.CJ.T001230.HNE.sac", "file of SAC"),
        ("SAC_MSEED/TA.M04C..HNE_20140824.mseed", "file of miniSEED"),
        ("SMC/A-CAT090.AT2.smc", "give unit"),
        ("GEONET/20180212_211557_WPWS_20.V2A", '3 channels here, give channel: "S16W", "S74E", "Up" \\(vertical\\)'),
        ("COSMOS_CSMIP/imperialvalley79_ce01336p_CHAN24_FF270.V3", "spectra"),
    ):
        with pytest.raises(RecordError, match=word):
            records.read(shelf / file)


def test_that_a_velocity_without_unit_is_not_guessed(shelf):
    with pytest.raises(RecordError, match="give unit"):
        records.read(shelf / "plain_txt/RSN1063_NORTHR_RRS228.txt")


@pytest.mark.shows("records.refused")
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
        (peer(step="0.0.1"), {"unit": "g"}, "0.0.1|columns|numbers|rows of 5"),
        ("Time [s]  Acc. [cm/s2]\n" + two(), {"unit": "g"}, "states unit cm/s2"),
        ("t  Acceleration [m/s²]\n" + two(), {"unit": "g"}, "states unit m/s2"),
        ("# Units: cm/s2\n" + two(), {"unit": "g"}, "states unit cm/s2"),
        ("Tempo [s];Velocità [cm/s]\n" + two(";"), {"unit": "cm/s2"}, "Velocità"),
        ("t [s] v [m/s]\n" + two(), {"unit": "m/s2"}, "m/s: this is not"),
        ("0.00 nan\n0.01 nan\n" + two(), {"unit": "g"}, "line 1.*gap"),
        ("inf\n" + column(), {"unit": "g", "time_step": 0.01}, "line 1.*gap"),
        ("********\n" + column(), {"unit": "g", "time_step": 0.01}, "line 1.*gap"),
        (",-1\n1\n1\n", {"unit": "g"}, "line 2: 1 columns, but 2 in the line above"),
        ("41\n0.01\n" + column(), {"unit": "g", "time_step": 0.01}, "count of samples"),
        ("1940\n" + column(), {"unit": "g", "time_step": 0.01}, "beyond any earthquake"),
        (two().replace("0.61280", "6.1e200"), {"unit": "g"}, "beyond any earthquake"),
        (column().replace("0.61280", "6.1e400"), {"unit": "g", "time_step": 0.01}, "line 2"),
        (two(every=1e-9, places=12), {"unit": "g"}, "1e-05 to 0.5 s"),
        (two(), {}, "give unit"),
        (two().replace("0.05 ", "0.06 "), {"unit": "g"}, "increase in even steps"),
        (two().replace("0.05 ", "0.03 "), {"unit": "g"}, "increase in even steps"),
        (thousandths(drop=20), {"unit": "g"}, "without gaps"),
        (thousandths(double=20), {"unit": "g"}, "without gaps"),
        (thousandths(jump=20), {"unit": "g"}, "without gaps"),
        ("# dt=0.01\n" + two(every=0.02), {"unit": "g"}, "header states a time step"),
        ("40 0.02\n" + two(), {"unit": "g"}, "header states a time step"),
        (peer(step="5.0E+00"), {}, "time step 5 s"),
        (two() + "0.41 nan\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 inf\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 1_000\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 ١٢\n", {"unit": "g"}, "not numbers"),
        (two() + "0.40 1e400\n", {"unit": "g"}, "too large"),
        (two() + "0.40 1 2\n", {"unit": "g"}, "3 columns"),
        (two(" ", "{0:.5f} {0:.5f}"), {"unit": "g"}, "3 columns: give the column"),
        (two(" ", "{0:.5f} {0:.5f}"), {"unit": "g", "column": 7}, "column = 7"),
        (peer(), {"column": 2}, "leave it out"),
        (peer(declared="4" * 5000), {}, "declares 4"),
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


CUT = {
    "PEER_AT2/ARL360.at2": {},
    "PEER_AT2/IELC180.AT2": {},
    "PEER_AT2/elCentro_variant_noheader4.AT2": {},
    "PEER_AT2/AND270.AT2": {"unit": "g"},
    "SIGMA_ITACA_acc/16839_H1.cor.acc": {},
    "plain_txt/RSN175_IMPVALL.H_H-E12140_ASCE7_Matched_1col.txt": {},
    "plain_txt/Hollister.dat": {"unit": "m/s2"},
    "plain_txt/OpenSees_Northridge.dat": {},
    "plain_txt/eqsig_test_motion_dt0p01.txt": {"unit": "m/s2"},
    "plain_txt/P695_SortedEQFile_121221.txt": {"unit": "g"},
}
COUNTED = ("PEER_AT2", "SIGMA", "plain_txt/eqsig")


@pytest.mark.shows("records.cut")
@pytest.mark.parametrize("most", [25, pytest.param(90, marks=pytest.mark.long)])
@pytest.mark.parametrize("file", CUT)
def test_that_a_file_cut_at_any_byte_of_its_end_gives_no_other_sample(shelf, file, most):
    """What is left is refused, or holds the same samples; whole lines may go where no count is declared."""
    content, options = (shelf / file).read_bytes(), Options(**CUT[file])
    whole = records._motion(content, shelf / file, options, 1.0, "x").acceleration
    for missing in range(1, most):
        try:
            found = records._motion(content[:-missing], shelf / file, options, 1.0, "x").acceleration
        except RecordError:
            continue
        assert np.array_equal(found, whole[: found.size]), missing
        assert found.size == whole.size or not file.startswith(COUNTED), missing


@pytest.mark.parametrize(
    "text, last",
    [
        ("1.822073E-03", "1.822073E-0"),
        ("-.1822073E-03", "-.1822073E-"),
        ("0.01234", "0.0123"),
        ("12.5", "12."),
        ("1.5e-05", "1.5e-0"),
        ("0.0123", "0.01"),
    ],
)
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


@pytest.mark.shows("records.refused")
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
    "head",
    ["PGA 0.013 (g)", "PGA (g): 0.9", "PGA [g]: 0.31", "PGA (g) 0.31", "Max acc (g): 0.3", "gravity 9.81 (m/s2)"],
)
def test_that_the_unit_of_one_value_is_not_that_of_the_samples(write, head):
    with pytest.raises(RecordError, match="give unit"):
        records.read(write(f"{head}\n" + two()))


def test_that_a_column_of_another_quantity_is_refused(write):
    rows = "\n".join(f"{0.01 * k:.2f} {a:.5f} {3 * a:.5f}" for k, a in enumerate(MOTION)) + "\n"
    for head in ("Time[s] Acc[g] Vel[cm/s]\n", "Time[s];Acc[g];Vel[cm/s]\n", "t  acc  displacement\n"):
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


def test_that_a_last_line_of_a_mark_alone_is_no_row():
    refuse_cut(["0.125 0.250"] * 9 + [" ;"], ended=False)


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


@pytest.mark.shows("doors.bombs")
@pytest.mark.parametrize(
    "line",
    [
        "1" * 4000 + " nan",
        "*" * 4000,
        "1.5" * 2000,
        "1 " * 2000 + "x",
        "1.5e" * 2000,
        "-" * 4000,
        "(" * 4000,
        "[g" * 2000,
        "9" * 4000 + " (g",
        "units " * 1000,
        "1,2" * 1500 + "x",
        " " * 4000 + "x",
        "unit" + " " * 8000 + "x",
        "(cm/s" + " " * 20000,
        "units of" + " " * 20000,
        "npts=1" + " " * 20000,
        "vel" * 5000,
    ],
)
def test_that_no_line_takes_more_than_linear_time(write, line):
    """Twice the line, about twice the steps: a backtracking grammar would need minutes at this length."""
    for content in (line, f"{line}\n{two()}", f"{two()}{line}\n", "\r" * 4000 + line, f"#{line}\n{two()}"):
        for options in (Options("g"), Options("g", 0.01)):
            try:
                records.read(write(content), options)
            except RecordError as error:
                assert len(str(error)) < 600


def test_that_what_no_record_is_long_is_refused_before_it_takes_the_memory(write):
    with pytest.raises(RecordError, match="more than 5000000 numbers"):
        records.read(write(b"1 " * 5_000_002), Options("g", 0.01))
    with pytest.raises(RecordError, match="MB is too large for an accelerogram"):
        records.read(write(b"1.0000\n" * 3_000_000), Options("g", 0.01))


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


@pytest.mark.parametrize("text", ["", "abc", "1.2.3", "1e", "nan", "-inf", "1_000", "0x10", "1,5", "D", "1.0E+999"])
def test_that_a_text_that_is_no_number_is_a_record_error(text):
    """Whatever Python itself would take for a number, or refuse with an error of its own."""
    with pytest.raises(RecordError):
        to_float(text)


@pytest.mark.parametrize(
    ("text", "value"), [("1.5", 1.5), (" -2 ", -2.0), ("1.0D-3", 1e-3), ("3d2", 300.0), (".5", 0.5)]
)
def test_that_a_number_of_the_grammar_is_read(text, value):
    assert to_float(text) == value


@pytest.mark.parametrize("line", [5, 8, 20])
def test_that_the_line_and_the_sample_that_are_named_are_those_that_are_wrong(line, tmp_path):
    head = ["PEER NGA", "Northridge", "ACCELERATION TIME SERIES IN UNITS OF G", "NPTS=  100, DT= .0100 SEC"]
    path = tmp_path / "a.AT2"
    for word, named in (("zz", f"line {line}:"), ("nan", f"sample {5 * (line - 5) + 3} ")):
        lines = [*head, *["  .1E-01  .2E-01  -.3E-01  .1E-01  .0E+00"] * 20]
        lines[line - 1] = f"  .1E-01  .2E-01  {word}  .1E-01  .0E+00"
        path.write_text("\n".join([*lines, ""]))
        with pytest.raises(RecordError) as refused:
            records.read(path)
        assert named in str(refused.value)


@pytest.mark.parametrize(
    ("rows", "code"),
    [
        ("0.1\n\n", "blank_among_samples"),
        ("0.1\n# EW\n", "text_among_samples"),
        ("40 0.01\n0.1\n\n", "blank_among_samples"),
        ("40 0.01\n0.1\n# EW\n", "text_among_samples"),
    ],
)
def test_that_no_more_head_comes_below_the_first_sample(write, rows, code):
    """A count and a step alone are no sample: below them a blank and a remark are of the head."""
    above, below = rows.split("0.1")
    for head in ("\n", "# EW\n"):
        found = records.read(write(f"40 0.01\n{head}{column()}\n"), Options("m/s2"))
        assert np.array_equal(found.acceleration, MOTION)
    with pytest.raises(RecordError) as refused:
        records.read(write(f"{above}0.1{below}{column()}\n"), Options("m/s2", 0.01))
    assert refused.value.code == code
    assert f"line {2 + above.count(chr(10))}:" in str(refused.value)


@pytest.mark.parametrize("empty", [",", ",,", ";", "\t", " , "])
def test_that_rows_of_empty_cells_after_the_last_sample_are_none_and_among_samples_a_gap(write, empty):
    """A spreadsheet leaves twenty of them."""
    rows = [f"{0.01 * k:.2f},{a:.5f}" for k, a in enumerate(MOTION)]
    found = records.read(write("\n".join([*rows, *[empty] * 20]) + "\n"), Options("m/s2", column=2))
    assert np.allclose(found.acceleration, MOTION, atol=5e-6)
    with pytest.raises(RecordError) as refused:
        records.read(write("\n".join([*rows[:20], empty, *rows[20:]]) + "\n"), Options("m/s2", column=2))
    assert refused.value.code in ("gap", "blank_among_samples", "not_numbers")


def test_that_an_empty_field_among_blanks_moves_no_column(write):
    rows = "".join(f"{0.01 * k:.2f} {a:.5f},,{a / 2:.5f}\n" for k, a in enumerate(MOTION))
    with pytest.raises(RecordError) as refused:
        records.read(write(rows), Options("g", column=3))
    assert refused.value.code == "gap"
    spaced = rows.replace(",,", ",")
    assert np.allclose(records.read(write(spaced), Options("m/s2", column=3)).acceleration, MOTION / 2.0, atol=5e-6)


@pytest.mark.parametrize(("cell", "code"), [("∅", "gap"), ("*", "gap"), ("dubbio", "not_numbers")])
def test_that_an_empty_cell_is_a_gap_and_a_word_is_none(write, cell, code):
    rows = column().splitlines()
    with pytest.raises(RecordError) as refused:
        records.read(write("\n".join([*rows[:20], cell, *rows[20:]]) + "\n"), Options("g", 0.01))
    assert refused.value.code == code and "line 21:" in str(refused.value)


def test_that_a_time_column_alone_is_no_acceleration(write):
    for every in (0.01, 0.5, 2.0):
        with pytest.raises(RecordError) as refused:
            records.read(write("".join(f"{every * k:.2f}\n" for k in range(40))), Options("g", 0.01))
        assert refused.value.code == "time_as_acceleration"
    for many, code in ((3, "too_few_samples"), (4, "time_as_acceleration")):
        with pytest.raises(RecordError) as refused:
            records.read(write("".join(f"{0.01 * k:.2f}\n" for k in range(many))), Options("g", 0.01))
        assert refused.value.code == code


@pytest.mark.parametrize(("late", "even"), [(4.8e-9, True), (5.2e-9, False)])
def test_that_a_column_rises_evenly_where_its_steps_differ_by_less_than_a_millionth(write, late, even):
    """Of 0.01 s: one sample that is late makes one step longer and the next one shorter."""
    content = "".join(f"{0.01 * k + (late if k == 30 else 0.0):.12f}\n" for k in range(40))
    if not even:
        assert records.read(write(content), Options("g", 0.01)).acceleration.size == 40
        return
    with pytest.raises(RecordError, match="it is a time column, not an acceleration"):
        records.read(write(content), Options("g", 0.01))


@pytest.mark.parametrize("first", [12, 30])
def test_that_of_many_uneven_times_the_first_is_named(write, first):
    """Every fourth step from there on is twice as long: too many to be gaps, too long to be rounding."""
    steps = [0.02 if k >= first and k % 4 == first % 4 else 0.01 for k in range(1, 40)]
    times = np.concatenate([[0.0], np.cumsum(steps)])
    rows = "".join(f"{t:.2f} {a:.5f}\n" for t, a in zip(times, MOTION, strict=True))
    for head in ("", "title\nsite\n"):
        with pytest.raises(RecordError) as refused:
            records.read(write(head + rows), Options("g"))
        line = first + 1 + head.count("\n")
        start = 0.01 * (first - 1)
        assert f"line {line}: the time goes from {start:g} to {start + 0.02:g} s" in str(refused.value)


def test_that_a_row_alone_is_no_record_whatever_column_is_asked_for(write):
    with pytest.raises(RecordError, match="column 1 does not increase"):
        records.read(write("0.00 0.10\n"), Options("g", column=2))


def test_that_the_columns_to_choose_from_end_with_the_last_one_that_is_filled(write):
    rows = "".join(f"{0.01 * k:.2f};{a:.5f};;{a / 2:.5f};\n" for k, a in enumerate(MOTION))
    with pytest.raises(RecordError, match="3 columns: give the column of the acceleration with column = 2 to 4 "):
        records.read(write(rows), Options("g"))
    assert np.allclose(records.read(write(rows), Options("m/s2", column=4)).acceleration, MOTION / 2.0, atol=5e-6)
    with pytest.raises(RecordError, match="column = 5"):
        records.read(write(rows), Options("g", column=5))
