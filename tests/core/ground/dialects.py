"""One motion written in every dialect that is read."""

import io
import zipfile

import numpy as np
from openpyxl import Workbook

STEP = 0.01
MOTION = np.array([0.25, -0.5, 0.75, -1.0, 1.25, -1.75, 2.0, -1.5, 1.0, -0.5] * 4)
"""[m/s2]; the mean is zero, and each sample is the same double in m/s2, cm/s2 and mm/s2."""

GAL, MM = 100.0 * MOTION, 1000.0 * MOTION
N = MOTION.size


def rows(values, per_line: int, form: str) -> list[str]:
    """Fortran lines of so many fields."""
    fields = [format(value, form) for value in values]
    return ["".join(fields[k : k + per_line]) for k in range(0, len(fields), per_line)]


def text(*parts) -> bytes:
    lines = [line for part in parts for line in ([part] if isinstance(part, str) else part)]
    return ("\n".join(lines) + "\n").encode()


def knet(values=GAL, declared=N / 100.0, peak=200.0, direction="E-W") -> bytes:
    head = {
        "Origin Time": "2018/01/24 19:51:00",
        "Lat.": "41.0",
        "Long.": "142.5",
        "Depth. (km)": "30",
        "Mag.": "6.2",
        "Station Code": "AOM001",
        "Station Lat.": "41.5",
        "Station Long.": "140.9",
        "Station Height(m)": "39",
        "Record Time": "2018/01/24 19:51:43",
        "Sampling Freq(Hz)": "100Hz",
        "Duration Time(s)": f"{declared:g}",
        "Dir.": direction,
        "Scale Factor": "2000(gal)/2000",
        "Max. Acc. (gal)": f"{peak:.3f}",
        "Last Correction": "2018/01/24 19:51:43",
        "Memo.": "",
    }
    return text([f"{key:<18}{value}" for key, value in head.items()], rows(values, 8, "9.0f"))


def cwa(unit="gal. DCoffset(corr)", rate=100) -> bytes:
    lines = [f"{k * STEP:10.3f}{0.5 * a:10.3f}{a:10.3f}{-a:10.3f}" for k, a in enumerate(GAL)]
    return text(
        "#Earthquake Information",
        "#Origin Time(GMT+08): 2018/02/06-23:50:42",
        "#Magnitude(Ml): 6.0",
        "",
        "#StationCode: EGF",
        "#StartTime(GMT+08): 2018/02/06-23:50:29.000",
        f"#RecordLength(sec): {N * STEP:g}",
        f"#SampleRate(Hz): {rate}",
        f"#AmplitudeUnit:  {unit}",
        "#AmplitudeMAX. N:    200.0~ -175.0",
        "#DataSequence: Time U(+); N(+); E(+)",
        "#Data: 4F10.3",
        lines,
    )


def geonet(raw: bool, names=("N10E", "Up", "S80E")) -> bytes:
    parts: list = []
    for k, name in enumerate(names):
        said = (
            "Raw readings in units of 1.00 mm/s/s  at intervals of 0.010 s"
            if raw
            else "Instrument corrected data at 0.010 sec intervals"
        )
        head = [
            f"{'Unc' if raw else 'C'}orrected accelerogram 20161113_110256_HSES_20 GNS Science",
            "Site HSES      42 31 24S  172 49 50E",
            "",
            "",
            "",
            "",
            "",
            "2016 November 13  11:02:56 UT",
            "Epicentre  42 41 33S 173 01 19E  Bearing S40E  Dist   25km  Depth   15km Mw 7.82",
            f"Number of points  {N}    Duration 0.40 s",
            said,
            "",
            f"Component {name}",
            "Acceleration:  Peak   2000.0 mm/s/s at  48.13 s     RMS   209.89 mm/s/s",
            "",
            "",
            *["       0"] * 10,
        ]
        parts += [head, rows((1.0 if k == 0 else 0.5 * (k + 1)) * MM, 10, "8.1f")]
        parts += [] if raw else [rows(MM / 50.0, 10, "8.1f")] * 2
    return text(*parts)


def smc(form="10.4f", per_line=8, kind="2 CORRECTED ACCELEROGRAM", declared=N) -> bytes:
    integers = [-32768] * 48
    integers[15], integers[16] = 1, declared
    reals = [1.7e38] * 50
    reals[1] = 100.0
    return text(
        kind,
        "*",
        "SAF0A",
        "     1989  10  18    0004 Loma Prieta, CA",
        "Moment Mag=      7.1",
        "station = San Francisco, 1295 Shafter, F component=    360",
        "pk     =    200.0",
        ["*"] * 4,
        rows(integers, 8, "10d"),
        rows(reals, 5, "15.7E"),
        "| a comment",
        rows(GAL, per_line, form),
    )


def volume2(names=("360 Deg", "Up", "90 Deg"), declared=N) -> bytes:
    parts: list = []
    for k, name in enumerate(names, start=1):
        head = [
            f"Corrected accelerogram   58667-L2866-14236.52       Chan  {k}: {name}         from",
            "Uncorrected Accelerogram Data             Processed: 08/24/14",
            "COALINGA EARTHQUAKE",
            "",
            "",
            "Station No. 58667   37.973N, 122.038W",
            "Concord",
            f"Chan  {k}: {name}",
            *[""] * 7,
            f"  {declared} points of instrument- and baseline-corrected accel, veloc and displ data",
            "At equally-spaced intervals of    .010  sec.",
            f"Peak acceleration =  {200.0 * k}    cm/sec/sec  at 1 sec.",
            f" {declared} points of accel data equally spaced at  .010 sec, in cm/sec2. (8f10.6)",
        ]
        other = [
            f" {N} points of {what} data equally spaced at  .010 sec, in {unit}.  (8f10.7)"
            for what, unit in (("veloc", "cm/sec"), ("displ", "cm"))
        ]
        small = rows(GAL / 250.0, 8, "10.6f")
        parts += [head, rows(k * GAL, 8, "10.4f"), other[0], small, other[1], small]
        parts.append(f"/&  ----------  End of data for channel  {k}  ----------")
    return text(*parts)


def volume1() -> bytes:
    return text(
        "Uncorrected Accelerogram Data             Processed: 02/13/12",
        ["words"] * 5,
        "Chan  1: 360 Deg",
        f" {N} Accelerogram points at 100 pts/sec in units of cm/sec2 .      Format: (8f9.3)",
        rows(GAL, 8, "9.3f"),
        "/&  ----------  End of Data for Channel  1  ----------",
    )


def cosmos(step_ms=10.0, quantity="acceleration", seconds=None) -> bytes:
    reals = [-999.0] * 100
    reals[61] = step_ms
    seconds = N * STEP if seconds is None else seconds
    return text(
        f"Corrected {quantity}    (Format v01.20 with 13 text lines) Src: f.txt",
        "Los Angeles, CA",
        ["words"] * 2,
        "Statn No: 01-23075  Code:CE-J2236",
        ["words"] * 3,
        "Sta Cha:  1: 340 deg (Rcrdr Chan  1) Location: roof",
        "words",
        "Processed: 06/17/2005      Max =  200.0 cm/sec2  at  27.850 sec",
        "filtered below 0.30 Hz",
        "words",
        " 100 Integer-header values follow on  10 lines, Format= (10I8)",
        rows([0] * 100, 10, "8d"),
        " 100 Real-header values follow on  17 lines, Format= (6F13.6)",
        rows(reals, 6, "13.6f"),
        "   1 Comment line(s) follow, each starting with a '|':",
        "| none",
        f"   {N}  {quantity} pts, approx   {seconds:g} secs, units=cm/sec2(04),Format=(8F10.5)",
        rows(GAL, 8, "10.4f"),
        "End-of-data for Chan  1 acceleration",
    )


def usc() -> bytes:
    """Pairs of time and G/10, at even times here."""
    pairs = [x for k, a in enumerate(np.round(MOTION, 3)) for x in (k * STEP, a)]
    return text(
        "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:",
        "NORTHRIDGE EARTHQUAKE",
        "JAN 17, 1994",
        "IBB101",
        "STATION USC# 0016   34 05 22N",
        "700 N, FARING RD.",
        "COMP N90E",
        "",
        "",
        "",
        f"NO. OF POINTS =   {N}      DURATION =  {(N - 1) * STEP:.3f} SEC",
        "UNITS ARE SEC AND G/10",
        "RMS",
        rows([0] * 100, 16, "5d"),
        rows([0.038] * 50, 8, "10.3f"),
        rows(pairs, 10, "8.3f"),
    )


def dyna(**changed) -> bytes:
    """ESM, AFAD and ITACA by their keys; None leaves a key out."""
    head = {
        "EVENT_NAME": "NORCIA",
        "EVENT_ID": "EMSC-1",
        "EVENT_DATE_YYYYMMDD": "20161030",
        "MAGNITUDE_W": "6.5",
        "NETWORK": "IT",
        "STATION_CODE": "AMT",
        "EPICENTRAL_DISTANCE_KM": "26.4",
        "SAMPLING_INTERVAL_S": "0.01",
        "NDATA": str(N),
        "DURATION_S": "",
        "STREAM": "HGE",
        "UNITS": "cm/s^2",
        "PGA_CM/S^2": "200.0",
        "DATABASE_VERSION": "",
        "DATA_TYPE": "ACCELERATION",
        "PROCESSING": "manual (Paolucci et al., 2011)",
    }
    head |= changed
    return text(
        [f"{key}: {value}" for key, value in head.items() if value is not None], [f"{value:.6f}" for value in GAL]
    )


OLD_ITACA = {
    "STREAM": None,
    "COMPONENT": "WE",
    "DATA_TYPE": "PROCESSED ACCELERATION",
    "PROCESSING": None,
    "DATA_VERSION": "1.0",
}
DYNA_1_0 = {"USER1": "", "USER2": "", "USER3": "", "USER4": ""}


def sigma() -> bytes:
    return text(
        "Event Date & Time : 2009-04-06",
        "Time Increment (s) : 0.01",
        f"Number of Data : {N}",
        "PGA (m/s/s) : 2.0",
        "Accelaration time series in m/s/s",
        rows(MOTION, 5, "14.7E"),
    )


def peer(last="NPTS= 40, DT= .01000 SEC") -> bytes:
    return text(
        "PEER STRONG MOTION DATABASE RECORD",
        "EVENT, 1, STATION, 90",
        "ACCELERATION TIME HISTORY IN UNITS OF CM/S/S",
        last,
        rows(GAL, 5, "15.7E"),
    )


def zipped(compression=zipfile.ZIP_DEFLATED, /, **members: bytes) -> bytes:
    room = io.BytesIO()
    with zipfile.ZipFile(room, "w", compression) as folder:
        for name, content in members.items():
            folder.writestr(name, content)
    return room.getvalue()


ESM_ZIP = {
    "IT.AMT..HGE.D.EMSC-1.ACC.MP.ASC": dyna(),
    "IT.AMT..HGN.D.EMSC-1.ACC.MP.ASC": dyna(STREAM="HGN"),
    "IT.AMT..HGZ.D.EMSC-1.ACC.MP.ASC": dyna(STREAM="HGZ"),
    "IT.AMT..HGE.D.EMSC-1.ACC.CV.ASC": dyna(PROCESSING="none"),
    "IT.AMT..HGE.D.EMSC-1.VEL.MP.ASC": dyna(DATA_TYPE="VELOCITY"),
    "IT.AMT..HGE.D.EMSC-1.DIS.MP.ASC": dyna(DATA_TYPE="DISPLACEMENT"),
    "README.txt": b"words",
}


def workbook(sheets=("accelerogram",), heads=("t [s]", "a [m/s2]")) -> bytes:
    book = Workbook()
    book.remove(book.active)
    for name in sheets:
        sheet = book.create_sheet(name)
        sheet.append(list(heads))
        for k, a in enumerate(MOTION):
            sheet.append([round(k * STEP, 2), float(a)])
    room = io.BytesIO()
    book.save(room)
    return room.getvalue()


TWO = text([f"{k * STEP:.2f} {a:.2f}" for k, a in enumerate(MOTION)])

DIALECTS: dict[str, tuple[bytes, dict]] = {
    "PEER": (peer(), {}),
    "PEER, values first": (peer("40    0.0100    NPTS, DT"), {}),
    "tab matrix": (text(f"{GAL[0]}\t{STEP}\t{N}", [f"{a}\t0\t0" for a in GAL[1:]]), {"unit": "cm/s2"}),
    "ESM": (dyna(), {}),
    "AFAD": (dyna(DATA_TYPE="Acceleration", EVENT_DATE_YYYYMMDD="2010/11/14"), {}),
    "ITACA before 2014": (dyna(**OLD_ITACA), {}),
    "DYNA 1.0": (dyna(**DYNA_1_0), {}),
    "SIGMA": (sigma(), {}),
    "K-NET": (knet(), {}),
    "CWA": (cwa(), {"channel": "N"}),
    "GeoNet V1A": (geonet(True), {"channel": "N10E"}),
    "GeoNet V2A": (geonet(False), {"channel": "1"}),
    "SMC, 8 fields": (smc(), {}),
    "SMC, 5 fields": (smc("14.7E", 5), {}),
    "CSMIP V2": (volume2(), {"channel": "1"}),
    "CSMIP V1": (volume1(), {}),
    "COSMOS": (cosmos(), {}),
    "one column": (text([f"{a:.2f}" for a in MOTION]), {"unit": "m/s2", "time_step": STEP}),
    "two columns": (TWO, {"unit": "m/s2"}),
    "csv of an Italian Excel": (TWO.replace(b" ", b";").replace(b".", b","), {"unit": "m/s2"}),
    "npts dt": (text("title", f"{N} {STEP}", [f"{a:.2f}" for a in MOTION]), {"unit": "m/s2"}),
    "SeismoSignal": (
        text(
            "Accelerogram of a station",
            "",
            "Time [sec]\tAcceleration [m/s2]",
            TWO.decode().replace(" ", "\t").splitlines(),
        ),
        {},
    ),
    "zip of ESM": (zipped(**ESM_ZIP), {"channel": "IT.AMT..HGE.D.EMSC-1.ACC.MP.ASC"}),
    "xlsx": (workbook(), {}),
}
"""name -> (content, what the user says of it)."""
