"""One motion in the formats of national networks and of LabVIEW, made by the grammars of record_formats.md."""

import numpy as np

from tests.core.ground.dialects import GAL, MOTION, STEP, N, rows, text

TENTHS = np.round(MOTION, 3)
"""The motion taken for tenths of g."""

NAMES = ("N00E", "N90E", "V")


def columns(form: str, *values) -> list[str]:
    return ["".join(format(value, form) for value in row) for row in zip(*values, strict=True)]


def nsmn(colon: str = "           : ", declared: int = N, unit: str = "gal") -> bytes:
    head = {
        "PLACE": "ORNEK",
        "EARTHQUAKE DATE": "2017/07/20 22:31:09 (GMT)",
        "EARTHQUAKE MAGNITUDE": "6.5 Mw",
        "STATION ID": "0921",
        "STATION ALTITUDE (m)": "",
        "NUMBER OF DATA": declared,
        "SAMPLING INTERVAL (sec)": "0.01",
        f"RAW PGA VALUES ({unit})": "(N-S) 200.000000 (E-W) 100.000000 (U-D) 50.000000",
    }
    return text(
        "STRONG GROUND MOTION RECORDS OF TURKIYE",
        [f"{key}{colon}{value}" for key, value in head.items()],
        "Copyright EARTHQUAKE DEPARTMENT",
        "       N-S          E-W          U-D",
        columns("13.6f", GAL, 0.5 * GAL, 0.25 * GAL),
    )


def unam(order=NAMES, declared: int = N, extra: int = 0, unit: str = "Gal (cm/s/s)", decimation: str = "1") -> bytes:
    size = {"N00E": 1.0, "N90E": 0.5, "V": 0.25}
    listed = {
        "ORIENTACION C1-C6 (rumbo;orientacion)": order,
        "VEL. DE MUESTREO, C1-C6 (muestras/s)": (100,) * 3,
        "INTERVALO DE MUESTREO, C1-C6 (s)": (STEP,) * 3,
        "NUM. TOTAL DE MUESTRAS, C1-C6": (declared,) * 3,
        "ACEL. MAX.(Gal), C1-C6": [200.0 * size[name] for name in order],
    }
    said = {"UNIDADES DE LOS DATOS": unit, "FACTOR DE DECIMACION": decimation}
    head = [f"{key:<39}: /{'/'.join(map(str, value))}" for key, value in listed.items()]
    head += [f"{key:<39}: {value}" for key, value in said.items()]
    body = columns("10.4f", *(size[name] * GAL for name in order))
    return text(
        "*" * 86,
        ["INSTITUTO DE INGENIERIA, UNAM"] * 4,
        "*" * 86,
        "ARCHIVO ESTANDAR DE ACELERACION:",
        f"{'CLAVE DE LA ESTACION':<39}: MADE",
        "=" * 80,
        head,
        "=" * 80,
        "DATOS DE ACELERACION:",
        "---------+" * 8,
        "   CANAL-1   CANAL-2   CANAL-3",
        "".join(name.rjust(10) for name in order),
        "---------+" * 8,
        body,
        body[-1:] * extra,
    )


def csmnc(kind="UNCORRECTED ACCELERATION", point="GROUND", component="EW", at: float = 0.07) -> bytes:
    return text(
        "051BXD130420080201",
        "0130420080246 2013-04-20 8:2:46 BTM",
        "LUSHAN EARTHQUAKE, LUSHAN,CHN",
        "STATION: 51BXD 30.400N 102.800E",
        f"OBSERVING POINT: {point}",
        f"COMP. {component}",
        f"{kind}          UNIT: CM/SEC/SEC",
        f"NO. OF POINTS:  {N}  EQUALLY SPACED INTERVALS OF:  0.01  SEC",
        f"PEAK VALUE:    200.0   AT   {at} SEC    DURATION:  1 SEC",
        "PRE-EVENT TIME:  20  SEC",
        "CSMNC",
        "",
        rows(GAL, 8, "13.6f"),
    )


def usc_two() -> bytes:
    blocks = [
        part
        for name, unit in (("ACC", "CM/SEC/SEC"), ("VEL", "CM/SEC"), ("DIS", "CM"))
        for part in (
            f"  {N} POINTS OF {name} DATA EQUALLY SPACED AT   .010 SEC.  IN UNITS {unit}",
            rows(GAL if name == "ACC" else GAL / 50.0, 8, "10.3f"),
        )
    ]
    return text(
        "CORRECTED ACCELEROGRAM  IIBB127  94.610.0 COMP N08W   FILE   0  CORRESPONDING T",
        "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:",
        "NORTHRIDGE EARTHQUAKE                                                   21",
        "COMP N08W                                                               9",
        "UNITS ARE SEC AND G/10                                                  22",
        "ACCELEROGRAM IS BAND-PASS FILTERED BETWEEN  .225- .325 AND 25.00-27.00 HZ.",
        "AT EQUALLY-SPACED INTERVALS OF    .010  SEC.",
        "PEAK ACCELERATION =  -200.00000  CMS/SEC/SEC AT     .060   SEC.",
        rows([0] * 100, 16, "5d"),
        *blocks,
    )


def raw_in_g() -> bytes:
    """CSMIP, digital recorders of the 1990s: no format is stated, nine characters a sample."""
    return text(
        "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 06/16/98, CDMG 23583",
        ["BIG BEAR EARTHQUAKE"] * 5,
        "CHAN  1:  90 DEG",
        "UNITS OF UNCOR ACCEL IS G.                 MAX  =  2.000 G, AT    .060 SEC.",
        rows([0] * 100, 16, "5d"),
        f"{N} POINTS OF ACCEL DATA EQUALLY SPACED AT .010 SEC.  (UNITS: G)",
        rows(MOTION, 8, "9.5f"),
        "/&  ----------  END OF DATA FOR CHANNEL  1  ----------",
    )


def film(times=None, first: float = 0.0, names=("1: NS", "2: V"), place="UNIVERSIDAD DE CHILE - RENADIC") -> bytes:
    """CSMIP volume 1 and RENADIC: pairs of seven characters, which touch from 100 s on."""
    times = first + STEP * np.arange(N) if times is None else times
    parts: list = []
    for k, name in enumerate(names):
        pairs = [f"{value:7.3f}" for pair in zip(times, TENTHS / (k + 1), strict=True) for value in pair]
        parts += [
            "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 06/30/2011",
            ["0911131", "11/13/2009 3:05:27 (GMT)", "", "STATION NO. 1", "ARICA S/N 815"],
            f"CHAN  {name}       (STA CHN:  {k + 1})",
            place,
            ["", ""],
            f"NO. OF POINTS =  {N:6d}  RECORD LENGTH ={times[-1] + STEP:7.3f} SEC",
            f"UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  = {0.2 / (k + 1):6.3f} G, AT    .060 SEC.",
            "RMS ACCEL OF COMPLETE RECORD = 0.005 G",
            rows([0] * 100, 16, "5d"),
            rows([0.0] * 50, 8, "10.3f"),
            ["".join(pairs[j : j + 10]) for j in range(0, len(pairs), 10)],
            f"/&  ----------  END OF DATA FOR CHANNEL {k + 1}  ----------",
        ]
    return text(*parts)


def bhrc(volume="1DS", rate: float = 100.0) -> bytes:
    parts: list = []
    for k, name in enumerate(("L1", "V2", "T3")):
        parts += [
            f"* VOL{volume} FILE:  5520/01",
            ["Inst Type = SSA-2", "Origin Time : 2012/08/11   12:23:16", "", name[0], ""],
            f"COMP {name}",
            "Ahar                      Station   38.474 N 47.059 E   Altitude 1360m",
            "Epicenter 38.520 N 46.860 E",
            "INSTR PERIOD =  .019 SEC   DAMPING =  .640",
            f"NO. OF POINTS =  {N:5d}      DURATION =  {N * STEP:.3f}",
            "UNITS ARE SECONDS AND G/10",
            "",
            ["    0" * 14] * 6,
            "    0" * 4,
            "  .188324E-01  .640000E+00  .780800E+02  .000000E+00  .100000E+00  .00",
            f"{rate:13.6E}" + "  .000000E+00" * 4 + "  .00",
            ["  .000000E+00" * 5 + "  .00"] * 4,
            "  .000000E+00" * 2,
            rows(TENTHS / (k + 1), 10, "13.6E"),
            "/&",
        ]
    return text(*parts)


def lvm(own="One", comma=False, mark="\t", units=("m/s^2",), segments: int = 1) -> bytes:
    """own : X_Columns; units : of each channel, "" where its head has none"""
    many, wide = len(units), own == "Multi"

    def cells(*values: str) -> str:
        return mark.join(values)

    def number(value: float, form: str) -> str:
        written = format(value, form)
        return written.replace(".", ",") if comma else written

    def spread(values) -> list[str]:
        return [cell for value in values for cell in ((value, "") if wide else (value,))]

    head = {"Writer_Version": "2", "Separator": "Comma" if mark == "," else "Tab", "X_Columns": own}
    head |= {"Decimal_Separator": ","} if comma else {}
    said = {"Channels": [str(many)], "Samples": [str(N)] * many, "X0": [number(0.0, ".6E")] * many}
    said |= {"Y_Unit_Label": list(units)} if any(units) else {}
    said |= {"Delta_X": [number(STEP, ".6f")] * many}
    names = [part for k in range(many) for part in (("X_Value", f"a{k}") if wide else (f"a{k}",))]
    body = []
    for k, a in enumerate(MOTION):
        time = number(STEP * k, ".6f")
        row = [number(a / (j + 1), ".6f") for j in range(many)]
        if wide:
            body.append(cells(*[part for value in row for part in (time, value)]))
        else:
            body.append(cells("" if own == "No" else time, *row))
    segment = [
        "",
        *(cells(key, *(spread(value) if len(value) > 1 or wide else value)) for key, value in said.items()),
        "***End_of_Header***",
        cells(*names, "Comment") if wide else cells("X_Value", *names, "Comment"),
        *body,
    ]
    return text(
        "LabVIEW Measurement" + mark,
        [cells(key, value) for key, value in head.items()],
        "***End_of_Header***",
        segment * segments,
    )


UNLIKE_STEPS = lvm("No", units=("m/s^2", "m/s^2")).replace(
    b"Delta_X\t0.010000\t0.010000", b"Delta_X\t0.010000\t0.005000"
)

EXACT = {
    "NSMN": (nsmn(), {"channel": "N-S"}),
    "NSMN with tabs": (nsmn("\t:\t"), {"channel": "N-S"}),
    "UNAM": (unam(), {"channel": "N00E"}),
    "UNAM, vertical first": (unam(("V", "N00E", "N90E")), {"channel": "N00E"}),
    "UNAM, the last row three times": (unam(extra=2), {"channel": "N00E"}),
    "CSMNC": (csmnc(), {}),
    "CSMNC, free field": (csmnc(point="FREE FIELD"), {}),
    "CSMNC corrected": (csmnc("CORRECTED ACCELERATION"), {}),
    "CSMNC as printed": (csmnc("UNCORRECTED ACCCELERATION", "G"), {}),
    "USC volume 2": (usc_two(), {}),
    "LabVIEW, one time column": (lvm(), {}),
    "LabVIEW, no time column": (lvm("No"), {}),
    "LabVIEW, times of each channel": (lvm("Multi", units=("m/s^2", "m/s^2")), {"channel": "a0"}),
    "LabVIEW, decimal comma": (lvm(comma=True), {}),
    "LabVIEW, commas between cells": (lvm(mark=","), {}),
    "LabVIEW beside a voltage": (lvm("Multi", units=("m/s^2", "Volts")), {}),
    "LabVIEW without a unit": (lvm(units=("",)), {"unit": "m/s2"}),
}
"""Name -> (file, what is asked): the motion bit for bit."""

TENTH = {
    "RENADIC": (film(), {"channel": "1: NS"}, 0.1),
    "CSMIP volume 1": (film(place="COPPER MOUNTAIN"), {"channel": "1"}, 0.1),
    "BHRC": (bhrc(), {"channel": "L1"}, 0.1),
    "CSMIP raw in g": (raw_in_g(), {}, 1.0),
}
"""Name -> (file, what is asked, the motion in g over its numbers)."""

REFUSED = {
    "BHRC, another volume": (bhrc("2"), {}, "bhrc_volume"),
    "BHRC, another rate": (bhrc(rate=200.0), {"channel": "L1"}, "head_lacks"),
    "CSMNC velocity": (csmnc("CORRECTED VELOCITY"), {}, "peer_quantity"),
    "LabVIEW, two segments": (lvm(segments=2), {}, "lvm_segments"),
    "LabVIEW, commas twice": (lvm(comma=True, mark=","), {}, "lvm_marks"),
    "LabVIEW, volts": (lvm(units=("Volts",)), {}, "unit_not_read"),
    "LabVIEW, no unit": (lvm(units=("",)), {}, "no_unit"),
    "LabVIEW, another count": (lvm().replace(b"Samples\t40", b"Samples\t41"), {}, "count_differs"),
    "LabVIEW, a spectrum": (lvm().replace(b"X0\t", b"X_Dimension\tFrequency\nX0\t"), {}, "lvm_abscissa"),
    "LabVIEW, milliseconds": (lvm().replace(b"X0\t", b"X_Unit_Label\tms\nX0\t"), {}, "lvm_abscissa"),
    "LabVIEW, steps of their own": (UNLIKE_STEPS, {"channel": "a1"}, "lvm_times"),
    "LabVIEW, no channels": (lvm().replace(b"Channels\t1", b"Channels\t0"), {}, "head_lacks"),
    "LabVIEW, more channels than columns": (lvm().replace(b"Channels\t1", b"Channels\t3"), {}, "head_lacks"),
    "LabVIEW, no rows": (lvm().split(b"Comment\n")[0] + b"Comment\n\n", {}, "no_numbers"),
    "CSMIP in tenths of g": (raw_in_g().replace(b"(UNITS: G)", b"(UNITS: G/10)"), {}, "unit_not_acceleration"),
    "UNAM, unlike counts": (unam().replace(b"/40/40/40", b"/40/-5/40"), {"channel": "2"}, "head_lacks"),
    "UNAM, another rate": (unam().replace(b"/100/100/100", b"/50/50/50"), {"channel": "2"}, "head_lacks"),
    "CSMNC, no step": (csmnc().replace(b"OF:  0.01", b"OF:  0.0"), {}, "time_step"),
    "NSMN, another count": (nsmn(declared=N + 1), {"channel": "N-S"}, "count_differs"),
    "NSMN, no unit": (nsmn(unit="x"), {"channel": "N-S"}, "head_lacks"),
    "UNAM, another count": (unam(declared=N + 5), {"channel": "V"}, "count_differs"),
    "UNAM, another unit": (unam(unit="g"), {"channel": "V"}, "unit_not_acceleration"),
    "UNAM, decimated": (unam(decimation="2"), {"channel": "V"}, "head_lacks"),
}
"""Name -> (file, what is asked, code of the refusal)."""
