"""Formats of national networks: one motion in each, cut files, and what their heads say."""

import re

import numpy as np
import pytest

from core.errors import RecordError
from core.units import G
from tests.conftest import ROOT
from tests.core.ground import dialects
from tests.core.ground.dialects import DIALECTS, MOTION, STEP, N
from tests.core.ground.networks_made import EXACT, REFUSED, TENTH, TENTHS, csmnc, film, lvm, unam
from tests.core.ground.test_dialects import read
from tests.core.ground.test_signatures import MADE


@pytest.mark.shows("records.film")
@pytest.mark.parametrize("name", TENTH)
def test_that_parts_of_g_are_the_motion_in_g(name):
    content, given, factor = TENTH[name]
    found = read(content, **given)
    assert np.allclose(found.acceleration, factor * G * TENTHS, rtol=1e-12)
    assert found.time_step == pytest.approx(STEP)
    assert "unprocessed" in {warning.code for warning in found.warnings}


@pytest.mark.shows("records.networks")
@pytest.mark.parametrize("name", REFUSED)
def test_that_what_such_a_file_cannot_mean_is_refused(name):
    content, given, code = REFUSED[name]
    with pytest.raises(RecordError) as caught:
        read(content, **given)
    assert caught.value.code == code


@pytest.mark.shows("records.cut")
@pytest.mark.parametrize("name", [*EXACT, *TENTH])
def test_that_a_file_cut_at_any_byte_is_refused_or_gives_the_same_samples(name):
    content, given, *_ = {**EXACT, **TENTH}[name]
    whole = read(content, **given).acceleration
    uncounted = "LabVIEW" in name
    step = 1 if uncounted else 11
    for size in range(0, len(content), step):
        try:
            found = read(content[:size], **given).acceleration
        except RecordError:
            continue
        assert found.size <= whole.size and np.array_equal(found, whole[: found.size])
        assert found.size == whole.size or uncounted


def test_that_pairs_touch_from_100_s_on_and_are_cut_by_their_columns():
    """As in a record of Arica: 132.925 -0.001132.930."""
    times = np.concatenate([[0.0], 99.9 + STEP * np.arange(1, N)])
    with pytest.raises(RecordError) as caught:  # a gap of 99.9 s is none of a record, but the numbers were read
        read(film(times), channel="1: NS")
    assert caught.value.code == "uneven_pairs"


@pytest.mark.shows("records.film")
def test_that_uneven_pairs_are_drawn_on_a_grid_and_doubted_as_they_stand_in_the_file():
    times = np.round(np.cumsum([0.0, *([0.01, 0.012] * N)])[:N], 3)
    found = read(film(times), channel="1: NS")
    assert found.time_step == 0.001
    assert np.allclose(
        np.interp(times, 0.001 * np.arange(found.acceleration.size), found.acceleration), 0.1 * G * TENTHS
    )
    assert "drawn_on_grid" in {warning.code for warning in found.warnings}


@pytest.mark.parametrize("step", [0.0, -0.01, 1e-320, 1e300])
def test_that_a_step_no_record_has_is_refused_in_any_format(step):
    for content, given in (
        (dialects.peer(f"NPTS= 40, DT= {step:.3e} SEC"), {}),
        (csmnc().replace(b"OF:  0.01", f"OF:  {step}".encode()), {}),
        (lvm("No").replace(b"Delta_X\t0.010000", f"Delta_X\t{step}".encode()), {}),
        ("\n".join(f"{a}" for a in MOTION).encode() + b"\n", {"unit": "g", "time_step": step}),
    ):
        with pytest.raises(RecordError):
            read(content, **given)


def test_that_long_blank_heads_are_read_in_linear_time():
    """150 lines of 299 blanks took 5 s."""
    read(unam().replace(b"=" * 80, b"=" * 80 + b"\n" + (b" " * 299 + b"x\n") * 100, 1), channel="V")


def test_that_channels_keep_their_names_and_directions():
    with pytest.raises(RecordError) as caught:
        read(unam())
    assert caught.value.values["names"] == ["N00E", "N90E", "V"]
    assert "vertical" in {warning.code for warning in read(unam(), channel="V").warnings}
    assert "vertical" in {warning.code for warning in read(film(), channel="2: V").warnings}
    assert "vertical" in {warning.code for warning in read(csmnc(component="UD")).warnings}


def test_that_a_point_on_a_structure_and_a_peak_elsewhere_are_named():
    assert "in_structure" in {warning.code for warning in read(csmnc(point="ROOF 12F")).warnings}
    for point in ("GROUND", "G", "FREE FIELD"):
        assert "in_structure" not in {warning.code for warning in read(csmnc(point=point)).warnings}
    assert "peak_elsewhere" in {warning.code for warning in read(csmnc(at=12.0)).warnings}


@pytest.mark.parametrize(
    ("code", "named"),
    [(5, True), (10, True), (12, True), (20, True), (50, True), (3, False), (6, False), (-999, False)],
)
def test_that_the_type_of_a_station_of_cosmos_is_named_where_it_is_no_free_field(code, named):
    """COSMOS Tables, table 6; integer header 19."""
    content = dialects.cosmos().replace(b" Location: roof", b"")
    head, below = content.split(b"Format= (10I8)\n")
    first = below.split(b"\n")
    first[1] = b"".join(b"%8d" % (code if k == 8 else 0) for k in range(10))
    found = read(b"Format= (10I8)\n".join([head, b"\n".join(first)]))
    assert ("in_structure" in {warning.code for warning in found.warnings}) == named


@pytest.mark.shows("records.california")
def test_that_each_head_speaks_for_its_own_channel():
    """A file of three channels, of which one stood on the roof."""
    content = dialects.volume2().replace(b"Concord", b"Concord ground", 1)
    heads = content.split(b"Corrected accelerogram ")
    heads[2] = heads[2].replace(b"Concord", b"Concord, roof")
    roof = b"Corrected accelerogram ".join(heads)
    said = {name: {w.code for w in read(roof, channel=name).warnings} for name in ("1: 360 Deg", "2: Up", "3: 90 Deg")}
    assert {name for name, codes in said.items() if "in_structure" in codes} == {"2: Up"}


@pytest.mark.parametrize("name", [*DIALECTS, *EXACT, *TENTH])
def test_that_every_line_of_a_file_is_counted(name):
    """Above the samples, of samples, others: the lines of the file, for every format that has a block."""
    content, given, *_ = {**DIALECTS, **EXACT, **TENTH}[name]
    found = read(content, **given)
    if found.lines is None or content[:2] == b"PK":
        return
    assert all(count >= 0 for count in found.lines)
    if not name.startswith("LabVIEW"):
        assert sum(found.lines) == len(content.decode("latin-1").rstrip("\n").split("\n"))


@pytest.mark.shows("records.not_read")
def test_that_the_page_of_formats_lists_every_file_tried_with_its_outcome():
    """At least 40, nine of ten read or refused by name: here all are."""
    page = (ROOT / "resources" / "docs" / "record_formats.md").read_text(encoding="utf-8")
    rows = [line for line in page.splitlines() if line.startswith("| ") and line.count("|") == 3][1:]
    listed = dict(tuple(cell.strip() for cell in row.strip("| ").split("|")) for row in rows)
    made = dict.fromkeys([*DIALECTS, *EXACT, *TENTH], "read")
    made |= {name: f"refused: {code}" for name, (_, _, code) in REFUSED.items()}
    made |= {name: f"refused by name: {code}" for name, (_, code) in MADE.items()}
    assert listed == made and len(made) >= 40


def test_that_event_station_and_date_of_film_stand_in_their_lines():
    """Lines 2, 6 and 3 of the thirteen of a channel."""
    assert read(film(), channel="2: V").details == (
        ("event", "0911131"),
        ("station", "ARICA S/N 815"),
        ("date", "11/13/2009 3:05:27 (GMT)"),
        ("processing", "none"),
    )


def test_that_channels_of_iran_without_a_component_are_numbered():
    nameless = re.sub(rb"COMP \w\d\n", b"\n", TENTH["BHRC"][0])
    for number, share in (("1", 1), ("2", 2), ("3", 3)):
        assert np.allclose(read(nameless, channel=number).acceleration, 0.1 * G * TENTHS / share, rtol=1e-6)
    with pytest.raises(RecordError) as caught:
        read(nameless)
    assert caught.value.values["names"] == ["1", "2", "3"]


def test_that_a_count_of_one_channel_of_labview_may_be_left_out():
    content = lvm(units=("m/s^2", "m/s^2"))
    assert content.count(b"Samples\t40\t40\n") == 1
    for said in (b"Samples\t40\n", b"Samples\n", b""):
        counted = content.replace(b"Samples\t40\t40\n", said)
        assert np.array_equal(read(counted, channel="a0").acceleration, MOTION)
        assert np.allclose(read(counted, channel="a1").acceleration, MOTION / 2.0)
    with pytest.raises(RecordError, match="40 samples, but the header declares 41"):
        read(content.replace(b"Samples\t40\t40\n", b"Samples\t40\t41\n"), channel="a1")


@pytest.mark.parametrize("blank", [b"\n", b"\t\t\n", b" \n"])
def test_that_blank_lines_below_the_last_row_of_labview_are_no_segment(blank):
    """However many: twice the lines take twice as long."""
    content = lvm()
    assert np.array_equal(read(content + blank * 2).acceleration, MOTION)
    assert np.array_equal(read(content + blank * 200_000).acceleration, MOTION)
    middle = content[: content.rindex(b"\n", 0, -1) + 1]
    with pytest.raises(RecordError) as caught:
        read(middle + blank + content[len(middle) :])
    assert (caught.value.code, caught.value.values) == ("lvm_segments", {"n": 2})


@pytest.mark.parametrize("segments", [0, 2, 3])
def test_that_the_segments_of_labview_are_counted_by_their_heads(segments):
    with pytest.raises(RecordError) as caught:
        read(lvm(segments=segments))
    assert (caught.value.code, caught.value.values) == ("lvm_segments", {"n": segments})


@pytest.mark.shows("records.labview")
@pytest.mark.parametrize("content", [lvm("No", comma=True), lvm(mark=",")])
def test_that_the_tags_of_labview_stand_in_any_order(content):
    lines = content.split(b"\n")
    end = lines.index(b"***End_of_Header***")
    tags = lines[1:end]
    for k in range(len(tags)):
        turned = b"\n".join([lines[0], *tags[k:], *tags[:k], *lines[end:]])
        assert np.array_equal(read(turned).acceleration, MOTION)
