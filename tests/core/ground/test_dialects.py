"""Dialects of the world's networks: one motion in all of them, channels, cut and lying files."""

import datetime
import io
import zipfile
from pathlib import Path

import numpy as np
import pytest
from openpyxl import Workbook

from core.errors import RecordError
from core.ground import records
from core.ground.provenance import provenance, stations
from core.ground.records.grammar import Options
from tests.core.ground import dialects
from tests.core.ground.dialects import DIALECTS, MOTION, STEP
from tests.core.ground.networks_made import EXACT
from tests.core.ground.test_records import ASKED
from tests.core.ooxml.writers import WRITERS, Fault, Formula, Writer
from tests.core.ooxml.writers import workbook as written_by


def read(content: bytes, **given):
    return records._motion(content, Path("x.txt"), Options(**given), 1.0, "x")


@pytest.mark.shows("records.peer_esm", "records.california", "records.pacific", "records.networks", "records.labview")
@pytest.mark.parametrize("name", [*DIALECTS, *EXACT])
def test_that_one_motion_is_the_same_bit_for_bit_in_every_dialect(name):
    content, given = {**DIALECTS, **EXACT}[name]
    found = read(content, **given)
    assert np.array_equal(found.acceleration, MOTION)
    assert found.time_step == STEP


@pytest.mark.parametrize("title", [title for title, _, _ in records.readers()])
@pytest.mark.parametrize("lines", [[], [""], [" "]])
def test_that_a_dialect_is_asked_of_a_file_without_lines(title, lines):
    knows = next(knows for name, knows, _ in records.readers() if name == title)
    assert knows(lines) in (True, False)


def test_that_pairs_at_uneven_times_are_drawn_on_a_grid_that_holds_them_all():
    found = read(dialects.usc())
    assert found.time_step == 0.001 and found.acceleration.size == 391
    assert np.allclose(found.acceleration[::10], 0.1 * 9.80665 * MOTION, rtol=1e-12)
    between = 0.5 * (found.acceleration[0] + found.acceleration[10])
    assert found.acceleration[5] == pytest.approx(between)
    assert {w.code for w in found.warnings} >= {"drawn_on_grid", "unprocessed"}


@pytest.mark.shows("records.cut")
@pytest.mark.parametrize("name", DIALECTS)
def test_that_a_dialect_cut_at_any_byte_is_refused_or_gives_the_same_samples(name):
    content, given = DIALECTS[name]
    whole = read(content, **given).acceleration
    counted = name not in ("one column", "two columns", "csv of an Italian Excel", "SeismoSignal")
    for size in range(len(content)):
        if size % 7 and size < len(content) - 120:  # every byte of the end, every seventh before
            continue
        try:
            found = read(content[:size], **given).acceleration
        except RecordError as error:
            assert "\n" not in str(error)
            continue
        assert np.array_equal(found, whole[: found.size]), size
        assert found.size == whole.size or not counted, size


@pytest.mark.shows("records.channels")
@pytest.mark.parametrize(
    ("name", "names", "vertical"),
    [
        ("CWA", ["U", "N", "E"], "U"),
        ("GeoNet V1A", ["N10E", "Up", "S80E"], "Up"),
        ("CSMIP V2", ["1: 360 Deg", "2: Up", "3: 90 Deg"], "2: Up"),
        ("zip of ESM", sorted(k for k in dialects.ESM_ZIP if ".ACC." in k), "IT.AMT..HGZ.D.EMSC-1.ACC.MP.ASC"),
    ],
)
def test_that_a_file_of_several_channels_asks_which(tmp_path, name, names, vertical):
    path = tmp_path / "several.v2"
    path.write_bytes(DIALECTS[name][0])
    with pytest.raises(RecordError) as caught:
        records.read(path)
    words = str(caught.value)
    assert "give channel" in words and all(one[:30] in words for one in names)
    assert f'"{vertical[:60]}" (vertical)' in words
    assert sorted(records.channels(path)) == sorted(names)
    found = records.read(path, Options(channel=vertical))
    assert "vertical" in {warning.code for warning in found.warnings}
    assert (found.channel == vertical and vertical in found.name) or name == "zip of ESM"
    for wrong in ("nowhere", "0", "99", ""):
        with pytest.raises(RecordError, match="no channel"):
            records.read(path, Options(channel=wrong))


def test_that_processed_horizontals_of_a_zip_come_first_and_what_is_converted_only_is_warned_of():
    content = dialects.zipped(**dialects.ESM_ZIP)
    first = read(content, channel="1")
    assert first.channel == "IT.AMT..HGE.D.EMSC-1.ACC.MP.ASC" and not first.warnings
    raw = read(content, channel="IT.AMT..HGE.D.EMSC-1.ACC.CV.ASC")
    assert [warning.code for warning in raw.warnings] == ["unprocessed"]
    nested = dialects.zipped(**{"a.V2": dialects.volume2(), "b.V2": dialects.volume2()})
    with pytest.raises(RecordError, match="a.V2.*give channel"):
        read(nested, channel="a.V2")
    assert np.array_equal(read(nested, channel="a.V2: 3").acceleration, 3.0 * MOTION)


@pytest.mark.parametrize(
    ("content", "word"),
    [
        (dialects.knet(peak=20.0), "peak"),
        (dialects.knet(declared=0.5), "declares 50"),
        (dialects.knet(declared=0.3), "declares 30"),
        (dialects.knet().replace(b"       25", b"     25.5", 1), "whole"),
        (dialects.cwa(unit="cm/s"), "unit"),
        (dialects.cwa(rate=200), "SampleRate"),
        (dialects.smc(declared=44), "44|40"),
        (dialects.smc(declared=36), "36"),
        (dialects.smc(declared=1), "40 samples, but the header declares 1 *$"),
        (dialects.smc(declared=0), "SMC, 16, 17, 2"),
        (dialects.smc(kind="3 VELOCITY"), "velocity"),
        (dialects.smc(kind="0 UNKNOWN"), "give unit"),
        (dialects.volume2(declared=48), "48|40"),
        (dialects.cosmos(seconds=40.0), "head"),
        (dialects.cosmos(quantity="velocity"), "velocity"),
        (dialects.geonet(True).replace(b"Number of points  40", b"Number of points  50", 1), "lines"),
        (dialects.geonet(False).replace(b"at 0.010 sec", b"at 0.010 hrs", 1), "intervals"),
        (dialects.usc().replace(b"G/10", b"G/99"), "G/10"),
        (dialects.usc().replace(b"0.100", b"0.600"), "times"),
        (dialects.dyna(DATA_TYPE="VELOCITY"), "VELOCITY"),
        (dialects.dyna(DATA_TYPE="ACCELERATION RESPONSE SPECTRUM"), "SPECTRUM"),
        (dialects.zipped(**{"x.zip": dialects.zipped(a=b"1")}), "within an archive"),
        (dialects.zipped(**{"a.pdf": b"%PDF"}), "no accelerogram"),
        (dialects.zipped(**{"a.txt": b"0.1\n" * 6_000_000}), "20 MB"),
        (dialects.zipped(**{f"{k}.txt": b"1" for k in range(600)}), "600"),
        (b"PK\x03\x04" + b"\0" * 60, "cannot be opened"),
        (dialects.zipped(zipfile.ZIP_LZMA, **{"a.txt": b"0.1 " * 99}), "LZMA"),
        (dialects.workbook(sheets=("a", "b")), 'give channel.*"a", "b"'),
        (dialects.workbook(heads=("T [s]", "Sa [g]")), "this is"),
    ],
)
def test_that_what_lies_or_is_damaged_is_refused_in_one_sentence(content, word):
    given = {"channel": "1"} if content[:9] in (b"Corrected", b"Uncorrect", b"#Earthqua") else {}
    if b"v01.20" in content[:90]:
        given = {}
    with pytest.raises(RecordError, match=word) as caught:
        read(content, **given)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("step", [5, pytest.param(1, marks=pytest.mark.long)])
def test_that_a_slip_of_the_unit_is_warned_of_or_refused(shelf, index, step):
    """Each acceleration of the shelf, or one of so many, read with its unit off by 9.81, 981 and 1000: refused where
    the file states its own, else warned of."""
    slips = {
        "g": ("m/s2", "cm/s2", "mm/s2"),
        "m/s2": ("g", "cm/s2", "mm/s2"),
        "cm/s2": ("g", "m/s2", "mm/s2"),
        "mm/s2": ("g", "m/s2", "cm/s2"),
    }
    tried = caught = 0
    for file, row in list(index.items())[::step]:
        if not row["pga_g"] or file.startswith("SAC"):
            continue
        given = {**ASKED.get(file, {}), **({"channel": "1"} if file.endswith((".V2", "A")) else {})}
        if "CHAN24" in file:
            given = {}
        given.pop("unit", None)
        for wrong in slips[
            row["units_in_file"]
            .replace("^", "")
            .replace("sec", "s")
            .split("(")[0]
            .split()[0]
            .replace("counts", "cm/s2")
        ]:
            tried += 1
            try:
                found = records.read(shelf / file, Options(unit=wrong, **given))
            except RecordError as error:
                caught += error.code in ("contradicts_file", "contradicts_line", "peak_too_large")
            else:
                caught += bool(found.warnings)
    assert tried > 200 / step and caught >= 0.99 * tried


@pytest.mark.parametrize(
    ("name", "event", "station"),
    [
        ("K-NET", "2018/01/24", "AOM001"),
        ("CWA", "2018/02/06", "EGF"),
        ("GeoNet V2A", "2016 November 13", "HSES"),
        ("SMC, 8 fields", "Loma Prieta", "San Francisco"),
        ("CSMIP V2", "COALINGA", "58667"),
        ("COSMOS", "Los Angeles", "01-23075"),
        ("ITACA before 2014", "EMSC-1", "IT AMT"),
        ("PEER", "EVENT", "STATION"),
    ],
)
def test_that_event_and_station_are_kept(name, event, station):
    content, given = DIALECTS[name]
    where = provenance(read(content, **given))
    assert event in where.event and station in where.station
    assert not where.date or any(letter.isdigit() for letter in where.date)


def test_that_channels_are_for_files_that_have_them():
    with pytest.raises(RecordError, match="one channel"):
        read(dialects.peer(), channel="2")
    assert read(dialects.knet(), channel="E-W").channel == ""


@pytest.mark.shows("records.pacific")
@pytest.mark.parametrize(
    ("direction", "codes"),
    [
        ("U-D", {"unprocessed", "vertical"}),
        ("1", {"unprocessed", "borehole"}),
        ("4", {"unprocessed"}),
        ("6", {"unprocessed", "vertical"}),
        ("N-S", {"unprocessed"}),
    ],
)
def test_that_verticals_and_boreholes_of_japan_are_named(direction, codes):
    assert {w.code for w in read(dialects.knet(direction=direction)).warnings} == codes


A, B = MOTION, 0.2 * MOTION[::-1]


def sheet(*rows) -> bytes:
    book = Workbook()
    for row in rows:
        book.active.append(list(row))
    room = io.BytesIO()
    book.save(room)
    return room.getvalue()


def lines(mark: str, *columns, head=()) -> bytes:
    table = [mark.join(head)] if head else []
    table += [mark.join(cells) for cells in zip(*columns, strict=True)]
    return ("\n".join(table) + "\n").encode()


TIMES = [f"{k * STEP:.2f}" for k in range(MOTION.size)]
FIRST, SECOND, NONE = [f"{a:.3f}" for a in A], [f"{b:.3f}" for b in B], [""] * MOTION.size


@pytest.mark.parametrize("mark", [",", ";", "\t"])
def test_that_an_empty_column_keeps_its_place(mark):
    content = lines(mark, TIMES, NONE, FIRST, SECOND)
    assert np.array_equal(read(content, unit="m/s2", column=3).acceleration, A)
    assert np.allclose(read(content, unit="m/s2", column=4).acceleration, B)
    for wrong in ({"column": 2}, {}):
        with pytest.raises(RecordError, match="column"):
            read(content, unit="m/s2", **wrong)
    spare = lines(mark, TIMES, NONE, FIRST)
    assert np.array_equal(read(spare, unit="m/s2").acceleration, A)
    velocity = lines(mark, TIMES, NONE, FIRST, SECOND, head=("t [s]", "", "acc [m/s2]", "vel [cm/s]"))
    with pytest.raises(RecordError, match="this is"):
        read(velocity, column=4)
    gap = FIRST[:9] + [""] + FIRST[10:]
    with pytest.raises(RecordError, match="line 10"):
        read(lines(mark, TIMES, gap, SECOND), unit="m/s2", column=2)


@pytest.mark.parametrize("mark", [";", "\t"])
def test_that_points_and_commas_may_stand_in_fields_of_their_own(mark):
    content = lines(mark, TIMES, [a.replace(".", ",") for a in FIRST])
    assert np.array_equal(read(content, unit="m/s2").acceleration, A)
    with pytest.raises(RecordError):
        read(lines(mark, TIMES, ["1,234.5"] * len(TIMES)), unit="m/s2")


def test_that_sheets_refuse_what_is_no_number_and_keep_their_columns():
    rows = [[k * STEP, None, float(a), float(b)] for k, (a, b) in enumerate(zip(A, B, strict=True))]
    found = read(sheet(["t [s]", None, "a [m/s2]", "b [m/s2]"], *rows), column=3)
    assert np.array_equal(found.acceleration, A)
    formulas = [[k * STEP, "=1*0.2", float(b)] for k, b in enumerate(B)]
    with pytest.raises(RecordError, match=r"formulas without values B1, B2, .* \(40\)"):
        read(sheet(*formulas), unit="m/s2")
    for wrong in ("#DIV/0!", "#N/A", None, datetime.date(2024, 1, 5)):
        column = [[float(a)] for a in A]
        column[20] = [wrong]
        with pytest.raises(RecordError):
            read(sheet(*column), unit="m/s2", time_step=STEP)
    text = "\n".join([*FIRST[:20], "#DIV/0!", *FIRST[21:]]) + "\n"
    with pytest.raises(RecordError, match="gap"):
        read(text.encode(), unit="m/s2", time_step=STEP)


SAMPLES = [["t [s]", "a [m/s2]"], *([round(k * STEP, 2), float(a)] for k, a in enumerate(MOTION))]


def notes(content: bytes, **given) -> list[str]:
    """Words of the warnings of a record, but for those on its samples."""
    return [w.text() for w in read(content, **given).warnings if w.code not in ("ends_moving", "unit_as_given")]


@pytest.mark.shows("records.plain")
@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_a_sheet_is_the_same_record_whoever_wrote_it(writer):
    found = read(written_by(writer, SAMPLES))
    assert np.array_equal(found.acceleration, MOTION) and found.time_step == STEP
    title = [["Stazione di prova", None], *SAMPLES]
    assert np.array_equal(read(written_by(writer, title, merged=("A1:B1",))).acceleration, MOTION)


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_a_sheet_refuses_formulas_without_value_and_merged_samples_by_name(writer):
    formulas = [*SAMPLES[:21], *([t, Formula("B2*2")] for t, _ in SAMPLES[21:])]
    with pytest.raises(RecordError, match="formulas without values B22, B23, .* .20."):
        read(written_by(writer, formulas))
    column = [[a] for _, a in SAMPLES[1:-2]] + [[None], [None]]
    with pytest.raises(RecordError, match="merged cells A38:A40: each cell"):
        read(written_by(writer, column, merged=("A38:A40",)), unit="m/s2", time_step=STEP)
    with pytest.raises(RecordError, match="errors C3: each cell"):
        read(written_by(writer, [*SAMPLES[:2], [*SAMPLES[2], Fault("#N/A")], *SAMPLES[3:]]))


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_hidden_samples_and_formulas_of_a_sheet_are_read_and_said(writer):
    assert notes(written_by(writer, SAMPLES)) == []
    hidden = written_by(writer, SAMPLES, hidden_rows=(5, 6), hidden_columns=(2,), others=[("Grezzi", [[1]])])
    assert np.array_equal(read(hidden).acceleration, MOTION)
    assert notes(hidden) == [
        "Hidden rows of the sheet were read like the others: 5, 6. Do they belong to the record?",
        "Hidden columns of the sheet count like the others: B (a [m/s2]). Is the column read the intended one?",
        "Hidden sheets of the workbook were not read: Grezzi.",
    ]
    formulas = [*SAMPLES[:40], [SAMPLES[40][0], Formula("1", SAMPLES[40][1])]]
    assert np.array_equal(read(written_by(writer, formulas)).acceleration, MOTION)
    assert notes(written_by(writer, formulas)) == [
        "Formulas of the sheet were read with their last computed values: B41."
    ]


def test_that_a_sheet_beyond_its_limits_is_refused_and_never_cut():
    wide = [[*row, *[None] * 98, 1.0] for row in SAMPLES]
    with pytest.raises(RecordError, match="column 100"):
        read(written_by(Writer(), wide))


@pytest.mark.parametrize("word", ["UP", "DWN", "VER", "V", "UD", "up"])
def test_that_a_vertical_of_peer_is_named(word):
    content = dialects.peer().replace(b"STATION, 90", f"STATION, {word}".encode())
    assert "vertical" in {warning.code for warning in read(content).warnings}
    zipped = dialects.zipped(**{f"RSN1_A-{word}.AT2": content, "RSN1_A-90.AT2": dialects.peer()})
    with pytest.raises(RecordError, match=rf'RSN1_A-{word}.AT2" .vertical'):
        read(zipped)


def test_that_a_number_is_that_of_the_channel_where_the_file_numbers_them():
    content = dialects.volume2()
    first = content.index(b"/&  ----------  End of data for channel  1")
    rest = content[content.index(b"\n", first) + 1 :]
    assert read(rest, channel="2").channel == "2: Up" and read(rest, channel="3").channel == "3: 90 Deg"
    with pytest.raises(RecordError, match="no channel"):
        read(rest, channel="1")


@pytest.mark.shows("records.peer_esm")
def test_that_every_name_that_is_offered_reads_also_within_zips(tmp_path):
    one, two = ({"a.V2": dialects.volume2()}, {"a.V2": dialects.volume2(), "b/b.V2": dialects.volume2()})
    for members, count in ((one, 3), (two, 6), (dialects.ESM_ZIP, 4)):
        path = tmp_path / "x.zip"
        path.write_bytes(dialects.zipped(**members))
        names = records.channels(path)
        assert len(names) == count
        for name in names:
            assert records.read(path, Options(channel=name)).acceleration.size == MOTION.size


@pytest.mark.parametrize(
    ("content", "old", "new"),
    [
        (dialects.volume2(), b"sec, in cm/sec2. (8f10.6)", b"sec, in mm/sec2. (8f10.6)"),
        (dialects.cosmos(), b"units=cm/sec2", b"units=mm/sec2"),
        (dialects.volume2(), b"accel data equally spaced at  .010 sec", b"accel data equally spaced at  .020 sec"),
        (dialects.geonet(False), b"Duration 0.40 s", b"Duration 9.00 s"),
    ],
)
def test_that_a_data_line_that_contradicts_its_head_is_refused(content, old, new):
    assert old in content
    with pytest.raises(RecordError):
        read(content.replace(old, new, 1), channel="1")


def test_that_all_channels_of_a_file_are_of_one_station(shelf):
    for file in ("CE58667.V2", "BadHeader.V2", "ce36456p_CE36456.V2", "CE89146.V1"):
        path = shelf / "COSMOS_CSMIP" / file
        found = [records.read(path, Options(channel=name)) for name in records.channels(path)]
        assert len(found) == 3 and len(stations(found)) == 1, file
    pair = {name: dialects.peer().replace(b"90", name[:3].encode()) for name in ("090.AT2", "180.AT2")}
    content = dialects.zipped(**pair)
    assert len(stations([read(content, channel=k) for k in ("1", "2")])) == 1


def test_that_of_many_channels_a_sentence_names_some_and_counts_the_others(tmp_path):
    (tmp_path / "many.V2").write_bytes(dialects.volume2(names=["360 Deg"] * 60))
    with pytest.raises(RecordError, match="60 channels here.*36 more") as caught:
        records.read(tmp_path / "many.V2")
    assert len(str(caught.value)) < 1000 and len(records.channels(tmp_path / "many.V2")) == 60


def wide_cosmos(step_ms: float, seconds: float, times: int = 10) -> bytes:
    """The samples of the dialect so many times over."""
    content = dialects.cosmos(step_ms, seconds=seconds)
    samples = b"\n".join(content.split(b"\n")[-7:-2]) + b"\n"
    longer = content.replace(samples, samples * times)
    return longer.replace(b"   40  acceleration pts", b"   %d  acceleration pts" % (40 * times))


@pytest.mark.parametrize(
    ("seconds", "agrees"), [(100.0, True), (98.1, True), (102.0, True), (97.9, False), (102.2, False)]
)
def test_that_the_step_of_cosmos_agrees_with_its_length_within_a_fiftieth(seconds, agrees):
    """400 samples 0.25 s apart; of short records within a second."""
    content = wide_cosmos(250.0, seconds)
    if agrees:
        assert read(content).acceleration.size == 400
    else:
        with pytest.raises(RecordError, match="100 Real-header values, 62"):
            read(content)
    assert read(dialects.cosmos(seconds=1.39)).time_step == STEP
    with pytest.raises(RecordError, match="100 Real-header values, 62"):
        read(dialects.cosmos(seconds=1.41))


def test_that_a_step_of_cosmos_is_any_above_zero():
    """20 kHz, and none."""
    assert read(dialects.cosmos(step_ms=0.05)).time_step == pytest.approx(5e-5, rel=1e-12)
    for step in (0.0, -10.0):
        with pytest.raises(RecordError, match="100 Real-header values, 62"):
            read(dialects.cosmos(step_ms=step))


def test_that_pairs_end_where_the_next_channel_begins():
    """Three channels of one, a half and a quarter of the motion, counted from the end of each."""
    blocks = []
    for share, name in ((1.0, "N90E"), (2.0, "N00E"), (4.0, "UP")):
        head, _, _ = dialects.usc().partition(b"   0.000")
        pairs = [x for k, a in enumerate(np.round(MOTION / share, 3)) for x in (k * STEP, a)]
        blocks.append(head.replace(b"N90E", name.encode()) + dialects.text(dialects.rows(pairs, 10, "8.3f")))
    for name, share in (("N90E", 1.0), ("N00E", 2.0), ("UP", 4.0)):
        found = read(b"".join(blocks), channel=name)
        assert np.allclose(found.acceleration[::10], 0.1 * 9.80665 * np.round(MOTION / share, 3), rtol=1e-12)
        assert ("vertical" in {warning.code for warning in found.warnings}) == (name == "UP")


def test_that_channels_of_california_without_a_name_are_numbered():
    content = b"\n".join(line for line in dialects.volume2().split(b"\n") if not line.startswith(b"Chan "))
    with pytest.raises(RecordError) as caught:
        read(content)
    assert caught.value.values["names"] == ["1", "2", "3"]
    assert np.array_equal(read(content, channel="2").acceleration, 2.0 * MOTION)


@pytest.mark.parametrize("channel", ["1", "2", "3"])
def test_that_a_corrected_channel_below_the_title_of_its_raw_one_is_corrected(channel):
    """The second title of each channel names the uncorrected data it was made from."""
    found = read(dialects.volume2(), channel=channel)
    assert dict(found.details)["processing"] == "corrected"
    assert dict(found.details)["event"] == "COALINGA EARTHQUAKE"
    assert "unprocessed" not in {warning.code for warning in found.warnings}


@pytest.mark.parametrize("raw", [True, False])
def test_that_fields_of_geonet_touch_and_are_cut_by_their_columns(raw):
    """-875.0001000.000 are two of eight characters."""
    content, printed = dialects.geonet(raw), dialects.rows(dialects.MM, 10, "8.1f")
    touching = dialects.rows(0.5 * dialects.MM, 10, "8.3f")
    assert any("-875.0001000.000" in row for row in touching)
    content = content.replace(dialects.text(printed), dialects.text(touching)).replace(b"2000.0 mm", b"1000.0 mm")
    assert np.array_equal(read(content, channel="1").acceleration, 0.5 * MOTION)


@pytest.mark.parametrize(("late", "agrees"), [(0.00055, True), (-0.00055, True), (0.00064, False), (-0.00064, False)])
def test_that_a_time_of_taiwan_is_off_by_no_more_than_its_print(late, agrees):
    """Two neighbours lie a step apart within 0.6 ms."""
    content = dialects.cwa().replace(b"     0.050", f"{0.05 + late:10.5f}".encode())
    if agrees:
        assert np.array_equal(read(content, channel="N").acceleration, MOTION)
    else:
        with pytest.raises(RecordError, match="SampleRate"):
            read(content, channel="N")


def test_that_a_rate_of_zero_is_none():
    with pytest.raises(RecordError, match="DataSequence"):
        read(dialects.cwa(rate=0), channel="N")


@pytest.mark.parametrize("many", [1, 2, 3, 9])
def test_that_a_short_table_of_taiwan_has_too_few_samples(many):
    lines = dialects.cwa().replace(b"RecordLength(sec): 0.4", b"RecordLength(sec): %.2f" % (many * STEP)).split(b"\n")
    with pytest.raises(RecordError, match=f"{many} samples are too few for a record: at least 10"):
        read(b"\n".join(lines[: 12 + many]) + b"\n", channel="U")


@pytest.mark.parametrize(("seconds", "agrees"), [(0.41, False), (0.40, True), (0.39, True), (0.38, False)])
def test_that_a_table_of_taiwan_may_have_the_sample_at_its_end(seconds, agrees):
    """Of 40 samples a hundredth of a second apart the last one is at 0.39 s."""
    content = dialects.cwa().replace(b"RecordLength(sec): 0.4", b"RecordLength(sec): %.2f" % seconds)
    if agrees:
        assert np.array_equal(read(content, channel="N").acceleration, MOTION)
        return
    with pytest.raises(RecordError, match=f"40 samples, but the header declares {100 * seconds:.0f}"):
        read(content, channel="N")


def test_that_an_smc_needs_no_comment():
    """The 16th integer counts them."""
    lines = dialects.smc().decode().splitlines()
    assert lines[12][70:] == "         1" and lines.pop(27) == "| a comment"
    lines[12] = lines[12][:70] + "         0"
    assert np.array_equal(read(dialects.text(lines)).acceleration, MOTION)


def test_that_an_smc_states_the_time_of_its_peak_or_leaves_it_out():
    """The reals 29 to 32: time and value of the largest sample, then of the smallest; 1.7E+38 is none."""
    lines = dialects.smc().decode().splitlines()
    assert not read(dialects.text(lines)).warnings
    assert not read(dialects.text(lines[:18], ["*"] * 9, lines[27:])).warnings  # the first line has the rate
    for time, codes in ((0.06, []), (1.0, ["peak_elsewhere"])):
        extremes = dialects.rows([1.7e38] * 3 + [time, 200.0, 0.05, -175.0] + [1.7e38] * 3, 5, "15.7E")
        found = read(dialects.text(lines[:22], extremes, lines[24:]))
        assert [warning.code for warning in found.warnings] == codes
