"""What heads say in English and Italian: each agrees with what is used, or is refused with its line."""

import re
from pathlib import Path

import pytest

from core.errors import RecordError
from core.ground import records
from core.ground.records.grammar import Options
from core.ground.records.wordings import folded
from core.units import G
from tests.core.ground.record_texts import column, two

TIMES, SAMPLES = two(), column() + "\n"
"""A motion of 40 samples 0.01 s apart, with its times and alone."""


def read(text: str, scale: float = 1.0, **given):
    return records._motion(text.encode(), Path("x.txt"), Options(**given), scale, "x")


def refused(text: str, line: str, scale: float = 1.0, **given) -> RecordError:
    """The error, which quotes the line of the head."""
    with pytest.raises(RecordError) as caught:
        read(text, scale, **given)
    shown = line.strip()[:60]
    assert shown in str(caught.value), str(caught.value)
    assert "\n" not in str(caught.value)
    return caught.value


STEPS = """
dt = 0.005|dt=0.005|DT: 0.005|DT 0.005|dt 0.005 s|dt=5ms|dt [s] = 0.005|dt (s): 0.005|dt(sec)=0.005
dt_s = 0.005|dt (ms) = 5|# dt=5.0E-3|dt = 5.0D-03 s|dt = 0,005 s|dt -> 0.005|dt = 1/200|dt = 1/200 s|Dt = .005
delta t = 0.005 s|Delta=0.005|delta-t: 0.005|Delta_t = 0.005 s|deltaT = 0.005|Δt = 0.005 s|Δt: 5 ms|δt = 0.005
∆t=0.005|Δτ = 0.005 s|ΔΤ = 0.005|Time step: 0.005 s|time step = 0.005|TIME STEP 0.005|timestep=0.005
time_step: 0.005|time-step 0.005 sec|Time step (ms) = 5|Time step, s: 0.005|time step of 0.005 s|step 0.005
step = 0.005|step: 5 ms|step size 0.005|Sampling interval: 0.005 s|sampling interval 5 msec
SAMPLING_INTERVAL_S: 0.005|sample interval = 0.005|Time interval: 0.005 s
time interval between samples: 0.005 s|interval = 0.005 sec|Sampling period 0.005 s
sample period: 5 milliseconds|sampling time 0.005 s|sample time = 0.005|time increment 0.005
Increment: 0.005 s|Time Increment (s) : 0.005|equal spacing of 0.005 sec|sample spacing: 0.005 s
spacing = 0.005 s|at equally spaced intervals of .005 sec|samples every 0.005 s|sampled at 0.005 s
Sampling: 0.005 s|sampling=0.005|data every 5 ms|time resolution 0.005 s|0.005 s|0.005 sec|5 ms|# ts = 0.005
digitization interval 0.005 s|resampled at 0.005 s|passo 0,005 s|passo: 0.005|passo = 5 ms
passo temporale 0,005 s|Passo temporale (s): 0.005|passo di tempo = 0.005 s|passo di campionamento 0,005 s
passo d'integrazione 0.005 s|passo di acquisizione 0,005 s|Passo [s]: 0,005|passo temporale pari a 0,005 s
passo costante di 0.005 s|intervallo di campionamento: 0,005 s|intervallo 0.005 s|intervallo di tempo 0.005 s
intervallo temporale = 0.005|intervallo tra i campioni 0,005 s|incremento temporale 0,005 s
incremento di tempo: 5 ms|periodo di campionamento 0,005 s|tempo di campionamento = 0.005 s
campionamento 0,005 s|campionato a 0,005 s|campionati ogni 0,005 s|campionamento ogni 5 millisecondi
campioni ogni 0.005 s|ogni 0,005 s|risoluzione temporale 0.005 s|spaziatura 0,005 s|NPTS, DT: 40, 0.005
"""
RATES = """
Sampling rate: 200 Hz|sampling rate = 200|SAMPLING RATE 200|Sampling rate (Hz): 200|Sample rate (Hz): 200
sample rate: 200|sample_rate=200|samplerate 200 Hz|sample-rate: 200 sps|Sampling frequency: 200 Hz
sampling frequency (Hz): 200 Hz|sampling freq. = 200|sample frequency 200 Hz|fs = 200|fs=200 Hz|Fs: 200
f_s = 200 Hz|FS 200|fsamp = 200|rate = 200 Hz|Rate: 200|data rate 200 Hz|Hz: 200|Hz = 200|200 sps|200 SPS
SPS: 200|sps=200|200 samples/sec|200 samples/s|200 samples per second|samples per second: 200|samples/sec: 200
number of samples per sec: 200|Samples/s = 200|200 points per second|200 pts/sec|13200 pts at 200 pts/sec
200 Hz|0.2 kHz|sampled at 200 Hz|Sampling: 200 Hz|digitized at 200 Hz|acquisition rate 200 Hz
acquisition frequency: 200 Hz|sampling rate of 200 samples per second|campionamento 200 Hz|campionamento: 200
Campionamento a 200 Hz|campionato a 200 Hz|dati campionati a 200 Hz|frequenza di campionamento 200 Hz
Frequenza di campionamento (Hz): 200|frequenza di campionamento = 200|frequenza campionamento: 200 Hz
freq. di campionamento 200 Hz|freq. camp. 200 Hz|Frequenza di acquisizione: 200 Hz|200 campioni/s
200 campioni al secondo|campioni al secondo: 200|200 campioni/sec|200 punti al secondo
velocità di campionamento 200 Hz|tasso di campionamento: 200 Hz|200 campioni per secondo|resampled to 200 Hz
ricampionato a 200 Hz|200 letture al secondo
"""


def wordings(table: str) -> list[str]:
    return [one for row in table.strip().splitlines() for one in row.split("|")]


@pytest.mark.parametrize("head", wordings(STEPS) + wordings(RATES))
def test_that_a_step_or_a_rate_is_used_and_refused_beside_another(head):
    if head.startswith(("13200", "NPTS")):
        head = head.replace("13200", "40")
    assert read(f"{head}\n{SAMPLES}", unit="g").time_step == pytest.approx(0.005, rel=1e-12)
    error = refused(f"{head}\n{SAMPLES}", head, unit="g", time_step=0.01)
    assert error.code == "contradicts_line"
    assert refused(f"{head}\n{TIMES}", head, unit="g").code == "two_time_steps"
    comment = f"# Record of Norcia, {head}"
    if not re.match(r"[0-9#]|H|FS|SPS|Rate|Fs", head):
        assert refused(f"{comment}\n{TIMES}", comment, unit="g").code == "two_time_steps"


COUNTS = """
NPTS 80|NPTS= 80|npts: 80|npt = 80|nsamples = 80|n_samples: 80|NDATA: 80|npoints 80|number of points: 80
Number of points = 80|number of samples 80|Number of Data : 80|number of data points: 80|No. of points 80
NO. OF POINTS =   80|no. of samples: 80|nr of samples 80|num. of points: 80|N. of points = 80|# of samples: 80
number of values 80|number of readings: 80|number of time steps: 80|total points: 80
total number of samples: 80|points: 80|Points = 80|samples: 80|Samples=80|data points: 80|80 points|80 samples
80 data points|80 points of accel data|80 accelerogram points|sample count: 80|count of samples 80
numero di campioni: 80|numero campioni 80|Numero di punti = 80|numero di dati: 80|numero dati: 80
numero totale di campioni: 80|num. campioni 80|n. campioni: 80|n. di punti: 80|n° campioni = 80
n° di punti: 80|campioni: 80|punti = 80|80 campioni|80 punti|80 valori|numero di valori: 80
numero di letture 80|Totale campioni: 80|numero di passi: 80|record of 80 samples|serie di 80 campioni
NPTS, DT: 80, 0.01
"""


@pytest.mark.shows("records.plain")
@pytest.mark.parametrize("head", wordings(COUNTS))
def test_that_a_count_must_be_that_of_the_samples(head):
    head = head.replace("accelerogram points", "data points")
    text = f"{head.replace('80', '40')}\n{TIMES}"
    assert not [w for w in read(text, unit="g").warnings if w.code == "number_not_understood"]
    error = refused(f"{head}\n{TIMES}", head.replace("   ", "  "), unit="g")
    assert "40 samples, but the header declares 80" in str(error)


UNITS = {
    "g": """
Acc (g)|Acceleration [g]|acc_g|Acc g|accel g|units: g|Units = G|UNITS OF G|in units of g|unit g|t [s]  a [g]
time,acc@s,g|acceleration in g|values in g|valori in g|unità: g|Unità di misura: g|u.m. = g|accelerazione [g]
accelerazioni in g|dati in g|amplitude in g's|g
""",
    "m/s2": """
Acc (m/s2)|acc [m/s^2]|acc [m/s²]|acc [m/s**2]|acc [m/s/s]|acc [m/sec2]|acc [m/sec/sec]|acc [m s-2]|a [m·s⁻²]
acc_m_s2|acc [ms-2]|m/s2|values in m/s^2|metres per second squared|meters/second^2|units: m/s/s|unità: m/s²
metri al secondo quadrato|m/sec^2
""",
    "cm/s2": """
Acc (cm/s2)|acc [cm/s²]|acc [cm/s/s]|acc [gal]|Gal|units: gal|gals|cm/sec/sec|IN CM/SEC/SEC|cm/sec^2|cm/s^2
acc_cm/s2|Acc_cm_s2|acc gal|units cm/s**2|unità: cm/s2|cm al secondo quadrato|valori in gal
accelerazione in cm/s²|espressa in cm/s2|cm per second per second
""",
    "mm/s2": """
Acc (mm/s2)|mm/s²|units: mm/s/s|accelerazioni in mm/s2|units of 1.00 mm/s/s|values in 0.1 gal|mm/sec2
""",
}
"""@ is an end of line."""
UNIT_ROWS = [(head.replace("@", "\n"), unit) for unit in UNITS for head in wordings(UNITS[unit])]


@pytest.mark.shows("records.plain")
@pytest.mark.parametrize(("head", "unit"), UNIT_ROWS)
def test_that_a_unit_is_that_of_the_samples(head, unit):
    other = "g" if unit != "g" else "cm/s2"
    assert read(f"{head}\n{TIMES}").unit == unit
    last = head.splitlines()[-1]
    assert refused(f"{head}\n{TIMES}", last, unit=other).code == "contradicts_line"


NOT_READ = {
    1e-3 * G: """
Acc (mg)|acc_mg|units: mg|acc [milli-g]|valori in mg|mg|units: 1e-3 g|1e-3 g|(10^-3 g)|units of 0.001 g|10⁻³ g
g/1000
""",
    0.01 * G: """
Acc (%g)|units: %g|acc [% g]|% of g|acceleration in % g
""",
    0.0254: """
Acc (in/s2)|in/s2|inch/sec^2|in/sec/sec
""",
    0.3048: """
units: ft/s2|ft/s²|feet per second squared
""",
    0.1 * G: """
acc [g/10]|UNITS G/10
""",
    None: """
g*1000|acc (g x 1000)|units: g*1000|acc [0.01 m/s2 / 2]|Counts|counts|raw counts|acc [counts]|units: counts
digital counts|unità: conteggi|Volts|units: V|acc (V)|acc [mV]|s;mV|units: volt|unità: mV
""",
    1e-5: """
mgal|acc [mGal]
""",
    0.1: """
dm/s2
""",
    1e-6: """
acc (µm/s²)|um/s^2
""",
}
"""m/s2 in one, None where nobody can know -> how heads write it."""
NOT_READ_ROWS = [(head, si) for si in NOT_READ for head in wordings(NOT_READ[si])]


@pytest.mark.parametrize(("head", "si"), NOT_READ_ROWS)
def test_that_a_unit_no_option_names_is_refused_until_unit_and_scale_say_the_same(head, si):
    for given in ({}, {"unit": "g"}, {"unit": "cm/s2"}):
        refused(f"{head}\n{TIMES}", head, **given)
    if si is not None:
        letters = folded(head)
        unit, one = ("cm/s2", 0.01) if "gal" in letters else ("g", G) if "g" in letters else ("m/s2", 1.0)
        found = read(f"{head}\n{TIMES}", si / one, unit=unit)
        assert found.pga == pytest.approx(si / G * read(TIMES, unit="g").pga, rel=1e-9)


FACTORS = """
Scale factor: 2.5|scale factor = 2.5|SCALE FACTOR 2.5|scaling factor: 2.5|scale = 2.5|Scale: 2.5
multiply by 2.5|multiply all values by 2.5|values to be multiplied by 2.5|multiplier: 2.5
multiplication factor 2.5|factor = 2.5|Factor: 2.5|conversion factor: 2.5|calibration factor = 2.5|gain: 2.5
gain = 2.5|sensitivity: 2.5|amplitude factor 2.5|normalization factor: 2.5|divide by 0.4|divided by 0.4|x 2.5
× 2.5|scale factor 2,5|fattore di scala: 2.5|fattore di scala 2,5|fattore di scala = 2,5|fattore: 2.5
fattore moltiplicativo 2,5|fattore di conversione: 2.5|fattore di calibrazione 2.5|moltiplicare per 2.5
moltiplicare i valori per 2,5|da moltiplicare per 2.5|moltiplicatore: 2.5|scala: 2.5
valori moltiplicati per 2.5|coefficiente moltiplicativo: 2.5|dividere per 0,4|guadagno: 2.5|sensibilità: 2.5
scale factor (-): 2.5|scale factor 5/2|scale factor 2.5 x 10^0
"""


@pytest.mark.shows("records.plain")
@pytest.mark.parametrize("head", wordings(FACTORS))
def test_that_a_factor_is_refused_until_scale_says_the_same(head):
    for given in (1.0, 2.0, 0.4):
        assert refused(f"{head}\n{TIMES}", head, given, unit="g").code == "factor_stated"
    assert read(f"{head}\n{TIMES}", 2.5, unit="g").scale == 2.5


THOUSANDTH = """
multiply by 0.001|scale factor 1e-3|fattore: 10^-3|divide by 1000|x 0.001|Scale factor = 1/1000|dividere per 1000
"""


@pytest.mark.parametrize("head", wordings(THOUSANDTH))
def test_that_a_factor_of_a_thousand_is_read_as_such(head):
    assert dict(refused(f"{head}\n{TIMES}", head, unit="g").values)["factor"] == pytest.approx(1e-3)


QUANTITIES = """
Jerk (m/s3)|jerk|Time  Jerk|Jerk time history|t [s]  j [m/s^3]|cm/s3|Rotation (rad)|rotation
rotational velocity (rad/s)|units: rad|rotazione [rad]|rotazioni|t;rad|strain|Strain (-)|microstrain
strain [µε]|deformazione|deformazioni|pressure (kPa)|Pressure|units: Pa|pressione [kPa]|pressione|sforzo [MPa]
stress (MPa)|kine|units: kine|Kine|acc (kine)|voltage|Voltage [V]|tensione [V]|Velocity (cm/s)|velocity
VELOCITY TIME HISTORY|vel (m/s)|t v [m/s]|units: cm/s|unità: cm/s|velocità|Velocità [m/s]|values in cm/s
displacement|Displacement (cm)|disp (m)|units: cm|spostamento|spostamenti [mm]|valori in mm|force (kN)
Forza [kN]|temperature|units: inches|response spectrum|spettro di risposta|Period (s), PSA (g)|Fourier
Tilt (mrad)|g/s|power spectral density|PSD|acc [m/s/s^3]|acceleration (m/s/s/s^2)
"""


@pytest.mark.parametrize("head", wordings(QUANTITIES))
def test_that_another_quantity_is_refused_whatever_is_given(head):
    for given in ("g", "cm/s2"):
        assert refused(f"{head}\n{TIMES}", head, unit=given).code in ("other_quantity", "unit_not_read")


VERTICALS = """
Vertical|VERTICAL|vertical component|Component: UP|Component UP|HNZ|hnz|UP|UD|U-D|Up|DWN|Z|V|# Z|Channel: HNZ
channel HNZ|Direction: Z|direction vertical|Orientation: Up|Componente verticale|componente: Z|Comp. UP|COMP V
Direzione: verticale|verticale|Canale: HNZ|Stream: HGZ|IT.AMT..HNZ|Up-down|asse Z|Verticale
"""
HORIZONTALS = [
    "NS",
    "EW",
    "N21E",
    "HNE",
    "Component: 090",
    "Channel: HNN",
    "direzione N-S",
    "L",
    "T",
    "comp. WE",
    "horizontal component",
    "componente orizzontale",
    "Vertical array, borehole",
]


@pytest.mark.shows("records.channels")
@pytest.mark.parametrize("head", wordings(VERTICALS) + HORIZONTALS)
def test_that_a_vertical_is_named_wherever_the_head_says_it(head):
    codes = [warning.code for warning in read(f"{head}\n{TIMES}", unit="g").warnings]
    assert ("vertical" in codes) == (head not in HORIZONTALS)


SILENT = """
Norcia, 30/10/2016 06:40:18 UTC|Event 2016-10-30T06:40:18|Mw 6.5|Magnitude: 6.5
magnitudo 6,5, profondità 10 km|Lat. 42.83, Lon. 13.11|latitude 42.5000|longitudine 13.0000
Epicentral distance 12 km|Vs30 = 500 m/s|Vs30 (m/s): 400|peak 0.5 at 4.2 s
Filter: 0.1-25 Hz|bandpass 0.1 - 50 Hz|filtro passa banda 0.1-40 Hz|corner frequencies 0.05 and 40 Hz
Butterworth order 4|High-pass 0.1 Hz|station 200|Stazione AMT, quota 100 m|Station code 1024
Recording station: 090 CDMG STATION 24278|event id 20161030_000029|azimuth 250|Frequency range: 0.12-23.0 Hz
soil class B, site factor 1.2|damping 0.05|serial number 4096|version 2.0|seed 100|Richter scale 6.5
scala Mercalli 8|scale factor: 1|scale factor 1.0|multiply by 1|Fattore di scala: 1,0|scale = 1.0
filter with 4 poles|FFT of 4096 points|8 header lines|dt = 0.01|40 points|100 Hz
Sampling rate: 100 Hz, 40 samples|campionamento 100 Hz|npts 40, dt 0.01|return period 475 years
periodo di ritorno 475 anni|shear wave velocity 400 m/s|corrected for tilt|baseline corrected
Corrected acceleration of El Centro|gravity = 9.81 m/s2|g = 9.81 m/s2|Time (s)  Acc|Tempo Accelerazione
rotated by 37 degrees|rotation angle = 37.0|acceleration rotated to 233|Data: 30/10/2016|data 2016-10-30
El Centro 1940 data|Palermo (PA)|processed in 3 steps|sensitivity 1.25 V/g|Calibration 2019
Quality factor: 100|rotation to fault normal|arrival times 4.5 8.2|scala 1:25000
Created 2024-01-05 by A. Rossi
"""


@pytest.mark.parametrize("head", wordings(SILENT))
def test_that_a_head_of_other_things_is_neither_refused_nor_doubted(head):
    found = read(f"# {head}\n{TIMES}", unit="g")
    assert {warning.code for warning in found.warnings} <= {"unit_as_given", "ends_moving"}


DOUBTED = """
# 200|0.005 -|# TX 0.02|# CH1 200|N = 41|length: 4000|fc 200|# K 981|# 1e-6 LSBX|tc = 0.005|parameter 0.02
parametro: 0,02|samp 0.02 ?|# 400|# 39|durata? 0.02|Lunghezza: 41|q 9.81
"""


@pytest.mark.parametrize("head", wordings(DOUBTED))
def test_that_a_number_that_could_be_a_step_a_rate_or_a_count_is_said(head):
    mark = "#" if head[0].isdigit() else ""
    warnings = {w.code: w for w in read(f"# title\n{mark}{head}\n{TIMES}", unit="g").warnings}
    assert "number_not_understood" in warnings
    assert head.lstrip("# ") in warnings["number_not_understood"].text()
    assert head.lstrip("# ") in warnings["number_not_understood"].text("it")


def test_that_a_factor_already_in_the_samples_is_said():
    for head in (
        "scaled by 2.5",
        "Scalato per 2,5",
        "scale factor 2.5 (already applied)",
        "fattore di scala 2,5 applicato",
        "already multiplied by 2.5",
        "già scalato per 2.5",
    ):
        codes = {w.code: w for w in read(f"{head}\n{TIMES}", unit="g").warnings}
        assert "already_scaled" in codes and "2.5" in codes["already_scaled"].text()


@pytest.mark.parametrize(
    ("head", "code"),
    [
        ("dt = 0.01\nsampling rate 200 Hz", "two_steps_stated"),
        ("scale factor 2\nmultiply by 3", "two_factors_stated"),
        ("acc (g)\nunits: mg", "two_units"),
        ("Acc (g)\nvalues in cm/s2", "two_units"),
        ("dt = 0.01, dt = 0.02", "two_steps_stated"),
    ],
)
def test_that_a_head_that_contradicts_itself_is_refused(head, code):
    for line in head.splitlines():
        assert refused(f"{head}\n{TIMES}", line).code == code


def test_that_the_table_has_three_hundred_wordings():
    tables = map(wordings, (STEPS, RATES, COUNTS, FACTORS, QUANTITIES, VERTICALS, SILENT, DOUBTED))
    assert sum(map(len, tables)) + len(UNIT_ROWS) + len(NOT_READ_ROWS) >= 300


def test_that_a_unit_is_no_factor_and_leaves_the_scale_to_the_case():
    """One of a unit the case names: any scale may be given; of another one only what it is of that unit."""
    for head in ("Acc (g)", "acceleration in cm/s2", "Acc (gal)", "Acc (m/s2)"):
        one, twice = read(f"{head}\n{TIMES}"), read(f"{head}\n{TIMES}", 2.0)
        assert twice.pga == 2.0 * one.pga
    assert refused(f"Acc (mg)\n{TIMES}", "Acc (mg)", 2.0).code == "unit_not_read"


@pytest.mark.parametrize(
    ("first", "second", "named"),
    [
        ("Acc (gal)", "units: mg", ("cm/s2", "mg")),
        ("units: ft/s2", "Acc (cm/sec/sec)", ("ft/s2", "cm/s2")),
        ("Acc (G)", "units: mm/s^2", ("g", "mm/s2")),
    ],
)
def test_that_two_units_are_named_as_the_case_names_them_or_else_as_written(first, second, named):
    error = refused(f"{first}\n{second}\n{TIMES}", second)
    assert error.code == "two_units" and (error.values["one"], error.values["other"]) == named
