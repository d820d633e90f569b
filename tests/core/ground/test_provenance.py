"""What the header of each dialect says of event, station, date, magnitude and filter."""

import pytest

from core.ground import records
from core.ground.provenance import provenance, stations, unnamed
from core.ground.records.grammar import Options
from tests.conftest import shelf_folder

SHELF = [
    # file, station, words in event, date, magnitude, filter
    ("PEER_AT2/IELC180.AT2", "EL CENTRO ARRAY #9", "IMPERIAL VALLEY", "5/19/40 0439", "", ""),
    ("PEER_AT2/ROC-NS.AT2", "ROCCAMONFINA", "LAZIO-ABRUZZO EQ", "05/07/84 17:50", "", ""),
    ("PEER_AT2/RSN763_LOMAP_GIL067.AT2", "Gilroy - Gavilan Coll.", "Loma Prieta", "10/18/1989", "", ""),
    (
        "SIGMA_ITACA_acc/16839_H1.cor.acc",
        "3620 / Avezzano, Italy",
        "2009-04-06 01:32:39",
        "2009-04-06 01:32:39",
        "",
        "0.050 - 65.000 Hz",
    ),
    (
        "ESM_ASCII/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
        "HI ARS1",
        "EMSC-20190728_0000106",
        "20190728 160908",
        "ML 4.6",
        "0.100-30.000 Hz",
    ),
    ("ESM_ASCII/20101114230825_3104_ap_RawAcc_E.asc", "TK 3104", "3336", "2010/11/14 23:08:25.75", "ML 5.1", ""),
    ("SMC/0111a.smc", "San Francisco, 1295 Shafter, F", "Loma Prieta, CA", "1989 10 18 0004", "Mw 7.1", ""),
    (
        "COSMOS_CSMIP/Cosmos12TimeSeriesTest.v1",
        "01-23075",
        "Somewhere in Los Angeles, CA",
        "06/16/2005, 20:53:26.1 UTC",
        "Mw 4.8",
        "below 0.30 Hz (periods over 14.5 secs), and above 40.0 Hz",
    ),
    ("COSMOS_CSMIP/CE89146.V1", "89146", "Record of Mon Feb 13, 2012", "Mon Feb 13, 2012 13:06:45.0 PST", "", ""),
    ("COSMOS_CSMIP/017m30lw.s0a", "USC# 0016", "NORTHRIDGE EARTHQUAKE", "JAN 17, 1994 -1230 GMT", "", ""),
]


@pytest.fixture(scope="module")
def shelf():
    folder = shelf_folder()
    if folder is None:
        pytest.skip("the shelf of records is not there")
    return folder


@pytest.mark.shows("demand.stations")
@pytest.mark.parametrize(("file", "station", "event", "date", "magnitude", "corners"), SHELF)
def test_that_the_header_of_each_dialect_is_read(shelf, file, station, event, date, magnitude, corners):
    path = shelf / file
    channel = next(iter(records.channels(path)), None)
    found = provenance(records.read(path, Options(channel=channel)))
    assert found.station == station and event in found.event
    assert (found.date, found.magnitude, found.filter) == (date, magnitude, corners)


@pytest.mark.shows("demand.stations")
@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("SIGMA_ITACA_acc/16839_H1.cor.acc", "SIGMA_ITACA_acc/16839_H2.cor.acc"),
        ("ESM_ASCII/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", "ESM_ASCII/HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC"),
        ("PEER_AT2/RSN175_IMPVALL.H_H-E12140.AT2", "PEER_AT2/RSN175_IMPVALL.H_H-E12230.AT2"),
    ],
)
def test_that_two_components_of_a_station_are_one(shelf, first, second):
    pair = [records.read(shelf / file) for file in (first, second)]
    assert len(stations(pair)) == 1 and unnamed(pair) == 0


def test_that_stations_and_events_that_differ_are_more(shelf):
    files = (
        "SIGMA_ITACA_acc/16839_H1.cor.acc",
        "SIGMA_ITACA_acc/16833_H1.cor.acc",
        "ESM_ASCII/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC",
        "ESM_ASCII/HL.DLFA..HNE.D.20190728.160908.C.ACC.ASC",
        "PEER_AT2/IELC180.AT2",
        "PEER_AT2/A-ELC180.AT2",
    )
    # the last two are of one station and two earthquakes
    assert len(stations([records.read(shelf / file) for file in files])) == 6


@pytest.mark.shows("demand.stations")
def test_that_a_file_without_a_station_counts_as_one_and_is_said(tmp_path):
    for name in "ab":
        lines = "\n".join(f"{0.01 * k} {(-1) ** k * (1 + k % 3) + ord(name)}" for k in range(60)) + "\n"
        (tmp_path / f"{name}.txt").write_text(lines)
    from core.ground.records.grammar import Options

    pair = [records.read(tmp_path / f"{n}.txt", Options("cm/s2", None, None, None)) for n in "ab"]
    assert len(stations(pair)) == 2 and unnamed(pair) == 2
