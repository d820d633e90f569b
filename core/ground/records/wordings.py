"""The words heads of accelerograms use, as tables: wording -> quantity, unit, factor. All are in lower case, without
accents, Δt as dt, powers as ^2: see `folded`."""

import re
import unicodedata
from collections.abc import Iterable

from core.ground.records.grammar import HEAD_LINE, NUMBER
from core.quantities import words_of

_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
_POWER = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺]++")
_LETTERS = str.maketrans(
    {
        "Δ": "d",
        "δ": "d",
        "∆": "d",
        "Τ": "t",
        "τ": "t",
        "µ": "u",
        "μ": "u",
        "ε": "e",
        "×": "x",
        "·": "*",
        "⋅": "*",
        "−": "-",
        "–": "-",
        "÷": "/",
        "∕": "/",
        "⁄": "/",
        "’": "'",
        "°": "",
        "º": "",
    }
)


def folded(line: str) -> str:
    """A line of a head as the tables write it."""
    if not line.isascii():
        line = _POWER.sub(lambda run: "^" + run[0].translate(_DIGITS), line).translate(_LETTERS)
        line = "".join(x for x in unicodedata.normalize("NFKD", line) if not unicodedata.combining(x))
    return line.lower()[:HEAD_LINE]


def words(table: str) -> tuple[str, ...]:
    """The wordings of a table, with | between them."""
    return tuple(one.strip() for one in table.split("|"))


def any_of(wordings: Iterable[str]) -> str:
    """A pattern of any of these wordings, the longest first; a blank in one is a blank, `_`, `-`, a point or nothing,
    a * at the end any letters."""
    ordered = (re.escape(wording) for wording in sorted(wordings, key=len, reverse=True))
    parts = (one.replace(r"\ ", "[ _.-]{0,2}+").replace(r"\*", r"\w*+") for one in ordered)
    return "(?:" + "|".join(parts) + ")"


N = NUMBER.replace("[EeDd]", "[ed]").replace(r"\.[0-9]", "[.,][0-9]")
"""A number of a head: the comma may be the decimal mark."""

_TEN = rf"(?: *+(?:x|\*) *+10 *+(?:\^|\*\*)? *+-?[0-9]++|(?:\^|\*\*) *+-?[0-9]++| *+/ *+{N})"
FACTOR = rf"(?:{N}{_TEN}?+)"
"""A number, a power (10^-3, 2.5 x 10^-3) or a quotient."""

_SECOND = r"(?:s(?:ec(?:ond[oi]?s?|s)?)?)\.?(?![a-z])"

TIME_UNITS = {word: factor for word, factor in words_of(time=1).items() if factor <= 60.0} | {"sec.": 1.0}
"""Seconds of one unit."""

RATE_UNITS = words_of(time=-1) | dict.fromkeys(("sps", "cps", "c/s", "s/s"), 1.0)
SAMPLES = words("""
    samples | sample | samps | samp | pts | points | campioni | punti | letture | valori | values |
    readings | data points | dati
""")
RATE_PHRASE = rf"{any_of(SAMPLES)} *+(?:/|per|al|a|each|every|ogni) *+{_SECOND}"
"""`samples per second`, `campioni al secondo`: Hz by themselves."""

TIMING = {
    "step": words("""
        dt | d t | delta | delta t | timestep | step | step size | interval | intervals | spacing |
        increment | sampling period | sample period | sampling time | sample time | sampling dt |
        time resolution | ts | passo | intervallo | incremento | spaziatura | periodo di campionamento |
        tempo di campionamento | periodo campionamento | tempo campionamento | risoluzione temporale |
        every | ogni
    """),
    "rate": words("""
        rate | samplerate | fs | f s | f samp | fsamp | sps | hz | hertz | sampling frequency |
        sample frequency | sampling freq | sample freq | samp freq | sampl freq | sampling hz |
        acquisition frequency | frequenza di campionamento | frequenza campionamento |
        freq di campionamento | freq campionamento | freq camp | frequenza camp | frequenza di camp |
        frequenza di acquisizione | frequenza acquisizione | frequenza di digitalizzazione | cadenza |
        tasso di campionamento | velocita di campionamento | sampling speed
    """),
    "either": words("""
        sampling | sampled | resampled | digitized | digitised | campionamento | campionato | campionata |
        campionati | campionate | ricampionato | ricampionata | acquisito | digitalizzato |
        digitalizzata
    """),
}
"""Wordings of a time step, of a sampling rate, of whichever the unit says."""

VAGUE_TIMING = words("""
    step | delta | interval | intervals | increment | spacing | every | ogni | rate | intervallo |
    incremento | spaziatura | passo | hz | hertz | ts | cadenza | sampling time | sample time
""")
"""Vague wordings of a time step or a rate: a number beside one that is no plausible step or rate states none (`step 2
of the processing`)."""

NOUNS = words("""
    points | pts | samples | data points | time points | readings | values | ordinates | campioni |
    punti | valori | letture | ordinate
""")
NUMBERED = words("data | accelerations | dati | accelerazioni")
"""Samples: `40 points`, `points: 40`, `number of points 40`; of the latter kind only (`data: 30/10/2016` is a date)."""

GAPS = words("""
    steps | time steps | timesteps | intervals | time intervals | passi | passi temporali | intervalli
""")
"""Wordings of intervals: a record of n samples has n or n - 1 of them."""

COUNT = words("""
    npts | npt | npoints | nsamples | nsamp | nsample | ndata | nsteps | ndat | nvalues | n samp |
    sample count | samples count | point count | data count | count of samples | count of points |
    data length | nt | numpts | npunti | ncampioni | ndati
""")
VAGUE_COUNT = words("""
    n | count | length | record length | size | lunghezza | conteggio | totale | total | ns | np | nd
""")

FACTORS = words("""
    scale factor | scaling factor | scalefactor | multiplying factor | multiplication factor |
    multiply by | multiply with | multiply all by | multiply data by | multiply values by |
    multiply all values by | multiply samples by | multiplied by | multiply the values by |
    multiply the data by | multiply the samples by | to be multiplied by | conversion factor |
    conv factor | calibration factor | amplitude factor | amplification factor | normalization factor |
    normalisation factor | normalizing factor | fattore di scala | fattore scala |
    fattore moltiplicativo | fattore di conversione | fattore di calibrazione |
    fattore di amplificazione | fattore di normalizzazione | coefficiente di scala |
    coefficiente moltiplicativo | moltiplicare per | moltiplicare i valori per | moltiplicare i dati per |
    moltiplicare i campioni per | moltiplicare tutto per | moltiplica per | moltiplicato per |
    moltiplicati per | moltiplicata per | da moltiplicare per | costante di conversione |
    costante di calibrazione
""")
FACTORS_BEFORE_A_MARK = words("""
    scale | scaling | multiplier | factor | conversion | calibration | amplification | gain |
    sensitivity | lsb | fattore | coefficiente | moltiplicatore | scala | guadagno | sensibilita |
    conversione | calibrazione
""")
"""Wordings of a factor by which the samples have still to be multiplied; a single word only at the beginning and with :
or =."""

DIVISORS = words("""
    divide by | divided by | divide values by | divide data by | divide all by | divide the values by |
    divisor | dividere per | dividere i valori per | dividere tutto per | diviso per | divisi per |
    divisore
""")
APPLIED = words("""
    scaled by | already scaled by | already multiplied by | rescaled by | scaled with | scaled up by |
    scaled down by | scalato per | scalato di | scalati per | scalata per | gia scalato per |
    gia moltiplicato per | riscalato per
""")
"""Factors that are in the samples."""

IN_THE_SAMPLES = re.compile(r"\b(?:applied|already|included|applicato|gia|compreso|incluso)\b")
"""Words of a line whose factor is in the samples."""

_OTHER_FACTORS = words("""
    richter | mercalli | mcs | magnitude | magnitudo | intensity | soil | site | behaviour | behavior | damping |
    importance | ductility | struttura | suolo | smorzamento | comportamento | sottosuolo | topogra* |
    confidence | confidenza | participation | map | time
""")
NO_FACTOR = re.compile(rf"\b{any_of(_OTHER_FACTORS)}\b")
"""Words of a line whose factor or scale is not that of the samples."""

LENGTH_UNITS = words_of(length=1)
BARE_LENGTHS = words("m | cm | mm | in | inch | inches")
"""Lengths that alone are the unit of a displacement."""

OF_POWER = {0: "displacement", 1: "velocity", 2: "acceleration", 3: "jerk"}
"""Quantity of a length over so many seconds; of more it has no name."""

_OVER = rf"(?P<over>(?: *+(?:/|per|al|a|over) *+\(? *+{_SECOND}){{1,3}}+)"
PER_SECONDS = (
    rf"(?:{_OVER}(?: *+(?:\^|\*\*)? *+(?P<power>[23])(?![0-9.]))?+"
    r"(?: *+al)?+(?P<word> *+(?:squared|square|cubed|quadrat[oi]|quadro|cubo))?+"
    r"|(?P<square> *+(?:/|per) *+(?:square|sq\.?) *+s(?:ec(?:ond)?)?\b)"
    r"|[ .*_]*+s(?:ec)? *+(?:\^|\*\*)? *+\(? *+- *+(?P<minus>[123]) *+\)?|_+(?:s|sec)(?P<under>[23]))"
)
"""How a length stands over seconds: /s/s, per second squared, s-2, _s2."""

_SPACED = words("milli g | micro g | g units | units of g | % of g | % g | %")
_AS_ONE_WORD = {"g units": "g", "units of g": "g", "%": "%g"}
_OF_ACCELERATION = words_of(length=1, time=-2) | {
    one: words_of(length=1, time=-2)[_AS_ONE_WORD.get(one, one.replace(" ", ""))] for one in _SPACED
}
"""How an acceleration is written -> m/s2 in one."""

_OF_OTHERS = {
    "counts": words("""
        counts | count | cts | raw counts | raw count | digital counts | adc counts | adc units |
        digital units | digit | digits | lsb | conteggi | bit | bits
    """),
    "voltage": words("v | volt | volts | mv/g | v/g | mv | millivolt | millivolts | uv | microvolt | microvolts"),
    "velocity": words("kine | kines | mkine | millikine | knots | km/h | kmh | mph"),
    "jerk": words("g/s | g/sec | gal/s | gal/sec"),
    "rotation": words("""
        rad | rads | mrad | urad | radians | radian | radianti | rad/s | rad/sec | rad/s2 | rad/s^2 |
        mrad/s | deg/s | deg/sec | degrees/s | gradi/s | rad/sec2
    """),
    "strain": words("strain | microstrain | micro strain | nanostrain | ustrain | ue | mm/mm | m/m"),
    "pressure": words("""
        pa | kpa | mpa | hpa | gpa | bar | mbar | psi | ksi | n/mm2 | n/mm^2 | n/m2 | n/m^2 | kn/m2 |
        kg/cm2 | kg/cm^2
    """),
    "force": words("kn | kgf | newton | newtons"),
}
NAMED_UNITS: dict[str, tuple[str, float | None]] = {
    word: ("acceleration", si) for word, si in _OF_ACCELERATION.items()
} | {word: (quantity, None) for quantity, written in _OF_OTHERS.items() for word in written}
"""Unit -> (quantity, of an acceleration m/s2 of one)."""

AMBIGUOUS_UNITS = words("v | % | pa | bit | m | ue | bar | gs | kn")
"""Units that could be something else: they count where they are said to be units, or beside an acceleration."""

_LENGTH = any_of(LENGTH_UNITS)
_FACTOR_BEFORE = rf"(?:(?:(?:x|\*|times) *+)?(?P<before>{FACTOR}) *+(?:x|\*|times)? *+)?"
_FACTOR_AFTER = rf"(?: *+(?P<how>x|\*|times|/|per) *+(?P<after>{FACTOR}))?"
UNIT = re.compile(
    rf"{_FACTOR_BEFORE}(?:(?P<named>{any_of(NAMED_UNITS)})(?![a-z0-9%'])(?! *+/ *+s)"
    rf"|(?P<length>{_LENGTH})(?:{PER_SECONDS}|(?![a-z0-9]))){_FACTOR_AFTER}(?![a-z0-9^]| *+/ *+[a-z])"
)
"""A unit with the factor before or after it."""

_OF_UNITS = words("""
    unit | units | unita | unita di misura | unita' di misura | u.m. | um | unit of measure | unit of measurement
""")
_IN_UNITS = words("""
    acceleration | accelerations | accelerazione | accelerazioni | accelerogram | accelerogramma | acc | acc. |
    accel | accel. | value | values | valori | data | dati | sample | samples | campioni | amplitude |
    amplitudes | ampiezza | ampiezze | ordinate | ordinates | ordinata | expressed | given | measured |
    espresso | espressa | espressi | espresse | misurato | misurata | misurati | misurate | unit | units |
    time history | time histories | record | signal | segnale | serie
""")
UNIT_SAID = re.compile(
    rf"(?:\b{any_of(_OF_UNITS)}(?![a-z])(?: *+(?:(?:of|are|is|in|di|sono|misura)\b|[:=]))*+"
    rf"|\b{any_of(_IN_UNITS)} +in(?: units? of)?) *+[(\[]? *+(?=\S)"
)
"""Words that stand before a unit that is said to be one."""

_SAMPLES_SAID = words("""
    acc | accel | acceleration | accelerations | accelerazione | accelerazioni | data | dati | value | values |
    valori | samples | campioni | signal | segnale | record
""")
ACCELERATION_WORD = any_of(_SAMPLES_SAID)
"""Words of an acceleration beside which a unit may stand."""

MOTION = r"veloc\w*|vel(?![a-z]{2})\w*|displ\w*|disp\b\.?|spostament\w*"
_OTHERS = words("""
    jerk | jerks | strappo | rotation | rotations | rotational | rotazione | rotazioni | rotazionale | tilt | tilts |
    inclinazione | inclinazioni | strain | strains | microstrain | nanostrain | deformazione | deformazioni |
    pressure | pressures | pressione | pressioni | stress | stresses | tensione | tensioni | sforzo | sforzi |
    force | forces | forza | forze | voltage | voltages | volt | volts | millivolts | raw counts |
    digital counts | temperature | temperatures | temperatura
""")
OTHER_QUANTITY = rf"{any_of(_OTHERS)}\b"
"""Words of a motion that is no acceleration, and of what is no motion; the latter count where no number stands beside
them and no acceleration is named."""

NOT_THE_SAMPLES = re.compile(
    r"\b(?:veloc\w+ (?:di )?campionamento|(?:shear|s|p|sound)[ -]?waves? velocit\w+|fft of|stress[ -]drop|air force"
    r"|velocit\w+ (?:delle|di) onde[a-z ]*|(?:rotation|rotated)[ -]?(?:angle|by|of|to|into)|angle of rotation"
    r"|angolo di rotazione|rotazione di|(?:for|before|after) rotation|peak (?:ground )?(?:velocity|displacement)"
    r"|accel\w*(?:,| and|,? e|,? &) (?:veloc\w*)(?:,? (?:and|e|&) displ\w*)? time histor(?:y|ies)"
    r"|(?:base ?line|drift|mean|offset|tilt) correct\w*|correct\w* (?:for|of) tilt)\b"
)
"""Phrases that speak of another quantity without saying that the samples are one."""

VERTICAL_WORDS = re.compile(
    r"\b(?:verticale?|verticali|up[ -]?down|su[ -]?giu|vert\.?(?![a-z])|z[ -]?axis|asse z)(?! *(?:array|and|e|o|or)\b)"
)
_DIRECTION_OF = words("""
    comp | comp. | component | componente | componenti | channel | canale | chan | cha | direction | direzione | dir |
    orientation | orientazione | orientamento | stream | axis | asse | sensor | verso
""")
DIRECTION_LABEL = re.compile(
    rf"\b{any_of(_DIRECTION_OF)}(?:[ _-]?(?:name|code|nome|codice))?\.?(?: *+[:=] *+| ++)(\S{{1,20}})"
)
DIRECTION_CODES = re.compile(
    r"(?:up|down|dwn|dn|ver|vert|vertical[ei]?|u-d|ud|u|z|v|h[a-z]z|[a-z]nz|[a-z]gz|[a-z]hz|[a-z]lz|su)\.?"
)
"""A vertical in words; what stands before a direction; verticals as networks write them."""

_NUMBERED_OTHERWISE = words("""
    filter* | filtr* | bandpass | band | butterworth | corner | cut* | hp | lp | high pass | low pass | fft | window |
    finestra | passa* | taper* | pole | poles | order | ordine | range | magnitude | magnitudo | mag | mw | ml | ms |
    md | lat* | lon* | dist* | depth | profond* | elev* | quota | height | altezza | azimut* | vs30 | vs 30 |
    strike | dip | rake | pga | pgv | pgd | peak | picco | max* | min | minimum | minimo | massim* | date | data: |
    origin | event* | station* | stazion* | code | codice | id | seed | seme | serial | version* | line | lines |
    riga | righe | damping | smorzamento | natural | instrument | strumento | intensity | intensita | arias |
    housner | gravity | gravita | return | ritorno | format | copyright | page | pages | pagina | fig | eq | km |
    kilomet* | deg | degrees | gradi | bearing | baro* | target | anni | year | years | vref | corrected by
""")
OTHER_NUMBERS = re.compile(rf"\b{any_of(_NUMBERED_OTHERWISE)}(?![a-z])")
"""Words of a line whose numbers are known to be something else."""

_RATES = """
    20 25 40 50 60 64 75 80 100 120 125 128 150 160 200 204.8 240 250 256 300 320 400 409.6 500 512 600 800 1000 1024
    1200 2000 2048 4000 4096
"""
_GRAVITY = "9.8 9.81 9.807 9.80665 980 981 980.7 980.665 9806.65 9810 386.1 386.09 386.4 32.2 32.174"
RATES, GRAVITY = (tuple(map(float, table.split())) for table in (_RATES, _GRAVITY))
"""Numbers that are likely a rate [Hz], its inverse a step; a factor from g."""
