"""Statements of the head of plain text on its samples, by the tables of `wordings`: time step, count, factor,
direction; and the numbers of it that nobody understood."""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from core.errors import RecordError
from core.ground.records import wordings
from core.ground.records.channels import is_vertical
from core.ground.records.grammar import UNITS, Parsed, head_lines, quoted
from core.ground.records.head_units import factor_of, refuse_other_quantity, units_of
from core.ground.records.placement import structure_words
from core.ground.records.wordings import FACTOR, TIMING, N, any_of, folded
from core.quantities import unit_of
from core.text.sentence import notice

RATIO_TOLERANCE = 1e-3
"""Share by which two time steps may differ that are the same in print."""

_BETWEEN = wordings.words("""
    of | is | are | was | at | a | an | in | the | to | by | with | and | e | di | da | del | dei | della | delle |
    lo | il | i | per | pari | ad | ogni | about | equal | uguale | constant | costante | uniform | uniforme |
    every | circa | fixed | fisso | value | valore | temporale | tempo | time | campionamento | sampling |
    acquisizione | acquisition | digitalizzazione | integrazione | lettura | tra | fra | due | between | samples |
    campioni | points | punti | successivi | used | usato | size | length | frequency | frequenza | freq |
    interval | rate | step | spacing | data | dati | nominal | nominale | original | originale | file | d
""")
_WORDS = rf"{any_of(_BETWEEN)}(?![a-z0-9])"
_LINK = rf"(?:[ :=~_'\"]|\.(?![0-9])|-(?=[> ])|>|{_WORDS}){{0,16}}+"
"""Words and marks between a label and its number."""

_TIME_UNIT = any_of(wordings.TIME_UNITS)
_RATE_UNIT = f"(?:{wordings.RATE_PHRASE}|{any_of(wordings.RATE_UNITS)})"
_UNIT_BEFORE, _UNIT_AFTER = (rf"(?:(?P<{side}r>{_RATE_UNIT})|(?P<{side}t>{_TIME_UNIT}))(?![a-z0-9/])" for side in "ab")
_START, _END = r"(?<![a-z0-9])", r"(?![a-z0-9])"
_TIMED = [
    (
        kind,
        re.compile(
            rf"{_START}(?:{any_of(words)}{'|' + wordings.RATE_PHRASE if kind == 'rate' else ''}){_END}"
            rf"(?:[ _]*+{_WORDS})*+(?:[ _]*+[(\[,]?[ ]*+{_UNIT_BEFORE}[ ]*+[)\]]?)?+{_LINK}"
            rf"(?<![0-9])(?P<n>{N}(?: *+/ *+{N})?+)(?![0-9]|\.[0-9])[ \-]*+[(\[]?[ ]*+(?:{_UNIT_AFTER})?+"
        ),
    )
    for kind, words in TIMING.items()
]
_VAGUE = re.compile(any_of(wordings.VAGUE_TIMING) + _END)
_OF_RATE = re.compile(rf"(?<![a-z0-9.,])(?P<n>{N}) *+(?:{wordings.RATE_PHRASE}|sps{_END})")
_LONE_NUMBER = re.compile(rf"(?P<n>{N}) *+{_UNIT_AFTER}")
_PAIR = re.compile(rf"{_START}npts[ ,;/&]*+(?:and|e)?[ ]*+dt[ :=]*+([0-9]++)[ ,;]++({N})(?![0-9])")
"""A list of both, read as `npts = 40 dt = 0.01`."""

_KIND = r"(?:(?:data|time|sample|acceleration)[ _-]?)?"
_NOUN, _GAP = any_of(wordings.NOUNS), rf"(?P<gap>{any_of(wordings.GAPS)})"
_NUMBER_OF = (
    r"(?:numbers?|no\.?|nr\.?|num\.?|n\.?|n[o°]\.?|nro\.?|#|total|totale|quantity|numero|how many)[ _]*+"
    r"(?:total |totale )?(?:of |di |dei |delle |the )?+(?:[a-z]{3,14}[ _])?"
)
_WHOLE = r"(?P<n>[1-9][0-9]*+(?:[ .,'][0-9]{3})*+)(?![0-9a-z]|[.,/:-][0-9])"
_COUNTED = [
    re.compile(
        rf"{_START}{_NUMBER_OF}{_KIND}(?:{_NOUN}|{any_of(wordings.NUMBERED)}|{_GAP}){_END}"
        rf"(?! *+(?:/|per\b|al\b))[ ()a-z]{{0,8}}?[ :=]*+{_WHOLE}"
    ),
    re.compile(rf"{_START}(?:{any_of(wordings.COUNT)}|{_KIND}(?:{_NOUN}|{_GAP})(?= *+[:=])){_END}[ :=]*+{_WHOLE}"),
    re.compile(
        r"(?<![a-z0-9.,/:-])(?<!first )(?<!last )(?<!primi )(?<!ultimi )(?<!every )(?<!ogni )"
        rf"{_WHOLE} *+{_KIND}{_NOUN}{_END}"
        r"(?! *+(?:/|per\b|al\b|a (?:line|row|second)|in (?:a|each) |across|each|every|ogni|on (?:a|each)|su ogni))"
    ),
]
_MAYBE_COUNTED = re.compile(rf"{_START}{any_of(wordings.VAGUE_COUNT)} *+[:=] *+{_WHOLE}")
_NOT_COUNTED = re.compile(
    r"\b(?:header|testata|intestazione|skip|columns?|colonn[ae]|comment|filter|filtr\w+|poles?|fft|taper)\b"
)

_NOT_OF_SAMPLES = rf"(?! *+(?:[:%]|[a-z]++ *+/|{_TIME_UNIT}{_END}|{_RATE_UNIT}))"
_TO_FACTOR = (
    r"(?: *+[(\[][^()\[\]]{0,24}[)\]])?(?:[ :=~]|\b(?:of|is|by|di|per|pari|a|e|x|the)\b)*+"
    rf"(?P<n>{FACTOR}){_NOT_OF_SAMPLES}"
)
_MARKED = rf"(?:\A|(?<=[,;(|]) ?){any_of(wordings.FACTORS_BEFORE_A_MARK)}(?= *+[:=(\[])"
_MULTIPLIED = [
    (1, re.compile(rf"(?:{_START}{any_of(wordings.FACTORS)}{_END}|{_MARKED}){_TO_FACTOR}")),
    (-1, re.compile(rf"{_START}{any_of(wordings.DIVISORS)}{_END}{_TO_FACTOR}")),
]
_APPLIED = re.compile(
    rf"{_START}{any_of(wordings.APPLIED)} *+(?:factor|un fattore|a factor)?(?: of| di)? *+(?P<n>{FACTOR})"
)
_TIMES = re.compile(rf"(?:\A|[:=(]) *+x *+(?P<n>{FACTOR}) *+(?:\Z|\))")

_TIME_OF_COLUMN = re.compile(rf"\b(?:time|tempo|t) *+[(\[_,] *+({_TIME_UNIT}) *+(?:[)\],;]|\Z)")
_LONE = re.compile(rf"(?<![a-z0-9.,/:_^*+-])({N})(?![a-z0-9/:_^*-]|[.,][0-9])(?! *+(?:m|km|cm|mm|deg|%|g|gal)\b)")
_MARKS = " \t#%!/*;,'\"<>|:-"


_CELL = re.compile(r"\A([^0-9,;\t:=]*[a-z][^0-9,;\t:=]*)[,;\t] *(?=[+-]?[.,]?[0-9])")
"""A label and its number in two cells of a line, read as `label: number`."""

_DECIMATED = re.compile(r"\b(?:decimat\w*|down-?sampl\w*|sottocampion\w*|sfoltit\w*)")
_PEAK = re.compile(
    r"\b(?:pga|pha|peak (?:ground )?acc\w*|acc\w* (?:di picco|massima|max)|max(?:imum|\.)? acc\w*)\b"
    rf"[^0-9+-]{{0,12}}(?P<peak>[+-]?{N}) *[\[(]?"
)


@dataclass(frozen=True)
class Statement:
    """A number a head states. value : in the unit of its kind ([s], samples, -); line : where, quoted; span : (number
    of the line, start, end) of it, folded."""

    value: float
    line: str
    span: tuple[int, int, int]


@dataclass(frozen=True)
class Head:
    """The lines of a head above the samples, as written and folded."""

    raw: list[str]
    lines: list[str]


def head_of(text: str) -> Head:
    raw = head_lines(text)
    lines = (_CELL.sub(r"\1: ", folded(line).strip(_MARKS)) for line in raw)
    return Head(raw, [_PAIR.sub(r"npts=\1 dt=\2", line) for line in lines])


def _found(head: Head, pattern: re.Pattern) -> Iterator[tuple[re.Match, int]]:
    for k, line in enumerate(head.lines):
        for match in pattern.finditer(line):
            yield match, k


def _statement(head: Head, match: re.Match, k: int, value: float) -> Statement:
    return Statement(value, quoted(head.raw[k]), (k, match.start(), match.end()))


def _seconds(kind: str, match: re.Match, line: str) -> float | None:
    """Time step [s] that a number with its label and unit states; None where it states none."""
    value = factor_of(match["n"])
    groups = match.groupdict()
    time = groups.get("bt") or groups.get("at")
    rate = groups.get("br") or groups.get("ar")
    if groups.get("bt") or (time and not groups.get("br")):
        rate = None
    if value is None or not value > 0.0:
        return None
    if kind == "either" and not (time or rate):
        kind = "rate" if value >= 10.0 else "step" if value < 1.0 else ""
    if rate:
        of_one = wordings.RATE_UNITS.get(rate.strip(), 1.0)
        step = 1.0 / (value * of_one)
    elif time:
        step = value * wordings.TIME_UNITS[time]
    elif not kind:
        return None
    else:
        step = 1.0 / value if kind == "rate" else value
    vague = _VAGUE.match(match[0]) or kind == "either"
    if vague and (
        not 1e-5 <= step <= (0.2 if time or rate else 0.1) or (wordings.OTHER_NUMBERS.search(line) and not time)
    ):
        return None
    return step


def time_steps(head: Head) -> list[Statement]:
    """The time steps a head states, those of sampling rates among them [s]. Raises RecordError where two differ."""
    stated = []
    for kind, pattern in _TIMED:
        for match, k in _found(head, pattern):
            step = _seconds(kind, match, head.lines[k])
            if step is not None:
                stated.append(_statement(head, match, k, step))
    for match, k in _found(head, _OF_RATE):
        value = factor_of(match["n"])
        if value:
            stated.append(_statement(head, match, k, 1.0 / value))
    for k, line in enumerate(head.lines):
        if (match := _LONE_NUMBER.fullmatch(line)) is None:
            continue
        step = _seconds("", match, line)
        if step is not None and 1e-5 <= step <= 0.2:
            stated.append(_statement(head, match, k, step))
    stated = _widest(stated)
    for one in stated[1:]:
        if abs(one.value - stated[0].value) > RATIO_TOLERANCE * stated[0].value:
            raise RecordError(
                "two_steps_stated", one=stated[0].value, first=stated[0].line, other=one.value, second=one.line
            )
    return stated


def _widest(statements: list[Statement], others: list[Statement] | tuple = ()) -> list[Statement]:
    """Matches that are no part of another one."""
    spans = _by_line([*statements, *others])
    return [
        statement
        for statement in statements
        if not any(
            first <= statement.span[1] and statement.span[2] <= last and (first, last) != statement.span[1:]
            for first, last in spans[statement.span[0]]
        )
    ]


def _by_line(statements: Iterable[Statement]) -> dict[int, list[tuple[int, int]]]:
    """(start, end) of the statements of each line."""
    spans = defaultdict(list)
    for statement in statements:
        spans[statement.span[0]].append(statement.span[1:])
    return spans


def counts(head: Head, n: int) -> tuple[list[Statement], list[Statement]]:
    """(statements that agree with n samples, numbers that may be counts of something else). Raises RecordError where a
    head declares another number of samples."""
    agreed, unsure = [], []
    for pattern in (*_COUNTED, _MAYBE_COUNTED):
        for match, k in _found(head, pattern):
            digits = match["n"]
            accepted = {int(re.sub(r"[^0-9]", "", digits)[:18]), int(re.split("[^0-9]", digits)[0][:18])}
            gap = "gap" in match.groupdict() and match["gap"]
            statement = _statement(head, match, k, max(accepted))
            if _OF_RATE.match(head.lines[k], match.start("n")):
                continue
            if accepted & ({n, n - 1} if gap else {n}):
                agreed.append(statement)
            elif _NOT_COUNTED.search(head.lines[k]):
                continue
            elif pattern is _MAYBE_COUNTED:
                unsure.append(statement)
            else:
                raise RecordError("count_stated", n=n, declared=max(accepted), line=statement.line)
    return agreed, unsure


def factors(head: Head) -> tuple[list[Statement], list[Statement]]:
    """(factors that the samples have still to be multiplied by, those that are in them). Raises RecordError where two
    differ."""
    applied = [
        _statement(head, match, k, value) for match, k in _found(head, _APPLIED) if (value := factor_of(match["n"]))
    ]
    stated = []
    for sign, pattern in [*_MULTIPLIED, (1, _TIMES)]:
        for match, k in _found(head, pattern):
            value = factor_of(match["n"])
            if value and not wordings.NO_FACTOR.search(head.lines[k]) and abs(value) < 1e15:
                there = applied if wordings.IN_THE_SAMPLES.search(head.lines[k]) else stated
                there.append(_statement(head, match, k, value**sign))
    stated = _widest(stated, applied)
    for one in stated[1:]:
        if abs(one.value - stated[0].value) > 1e-6 * abs(stated[0].value):
            raise RecordError("two_factors_stated", first=stated[0].line, second=one.line)
    return stated, applied


def seconds_of_time(head: str) -> float:
    """Seconds of one unit of the time column: of a head `Time (ms)`, `Time (min)`; else 1."""
    for line in head_of(head).lines:
        match = _TIME_OF_COLUMN.search(line)
        if match:
            return wordings.TIME_UNITS[match[1]]
    return 1.0


def first_step(said: str) -> float | None:
    """The time step a head states [s], None where it states none. Raises RecordError where two differ."""
    return next((one.value for one in time_steps(head_of(said))), None)


def are_components(said: str, n: int, width: int) -> bool:
    """Whether a table of n rows holds components side by side: the head counts the rows, or names each column in its
    last line. Values wrapped over lines are counted by all of them."""
    if not 2 <= width <= 4:
        return False
    head = head_of(said)
    if counts(head, n)[0]:
        return True
    last = said.rsplit("\n", 1)[-1].strip()
    fields = [one for one in re.split(r"[;,\t]| {2,}", last) if one.strip()]
    if len(words := last.split()) == width and all(_DIRECTION.fullmatch(word) for word in words):
        return True
    return len(fields) == width and not any(char.isdigit() for char in last)


_DIRECTION = re.compile(r"(?:n-?s|e-?w|n-?o|u-?d|north|south|east|west|up|nord|sud|est|ovest|vert\w*|[xyz])\.?", re.I)
"""A direction above a column."""


def apply_head_statements(parsed: Parsed, said: str, declared: float | None, given: float | None) -> None:
    """Take over what a head says of the samples: time step, count and factor.

    parsed : with the step of the time column, None without one; declared : step of a line `npts dt` [s]; given : that
    of the case [s]. Raises RecordError where one contradicts another, or the count of samples."""
    head, n = head_of(said), parsed.values.size
    steps = time_steps(head)
    stated, line = (declared, "npts dt") if declared else (steps[0].value, steps[0].line) if steps else (None, "")
    if stated and not parsed.time_step and not given and (at := next(_found(head, _DECIMATED), None)):
        raise RecordError("decimated", line=quoted(head.raw[at[1]]))
    if stated and parsed.time_step and abs(parsed.time_step - stated) > RATIO_TOLERANCE * stated:
        raise RecordError("two_time_steps", stated=stated, column_step=parsed.time_step, line=line)
    if declared and steps and abs(steps[0].value - declared) > RATIO_TOLERANCE * declared:
        raise RecordError("two_steps_stated", one=declared, first=line, other=steps[0].value, second=steps[0].line)
    parsed.time_step = stated or parsed.time_step
    parsed.lines["time_step_s"] = line
    agreed, unsure = counts(head, n)
    parsed.counted = parsed.counted or bool(agreed)
    multiplied, applied = factors(head)
    parsed.warnings += [notice("already_scaled", factor=f"{one.value:g}") for one in applied[:1]]
    if multiplied and abs(multiplied[0].value - 1.0) > 1e-9:
        value, of_unit = multiplied[0].value, parsed.factor[0] if parsed.factor else 1.0
        error = RecordError("factor_stated", factor=value, line=multiplied[0].line)
        parsed.factor = (value * of_unit, error)
    known = [*steps, *agreed, *multiplied, *applied]
    lines = [one.line for one in unsure] + not_understood(head, known, parsed.time_step or given, n)
    if lines:
        shown = ", ".join(dict.fromkeys(lines[:3]))
        parsed.warnings.append(notice("number_not_understood", lines=shown))


def stated_peak(said: str, unit: str | None) -> float | None:
    """The largest acceleration a head states with its unit, in the unit of the samples; None where it states none.
    unit : of the samples, of `UNITS`"""
    if unit is None:
        return None
    for match, k in _found(head_of(said), _PEAK):
        line = head_of(said).lines[k]
        of = wordings.UNIT.match(line, match.end())
        written_unit = next(units_of(of, line), None) if of else None
        value = factor_of(match["peak"])
        if value and written_unit is not None and written_unit.quantity == "acceleration":
            return abs(value) * written_unit.size / UNITS[unit]
    return None


def not_understood(head: Head, known: list[Statement], step: float | None, n: int) -> list[str]:
    """Lines with a number that could be a step, a rate, a count or a factor and is none that is known, quoted; known
    ones are left out, and those that agree with the time step [s] and the n samples used."""
    spans = _by_line(known)
    used = [float(n), *((step, 1.0 / step, n * step, (n - 1) * step) if step else ())]
    lines = []
    for k, line in enumerate(head.lines):
        if wordings.OTHER_NUMBERS.search(line):
            continue
        for match in _LONE.finditer(line):
            value = factor_of(match[1])
            inside = any(start <= match.start() < end for start, end in spans[k])
            if value is None or inside or any(abs(value - x) <= RATIO_TOLERANCE * abs(x) for x in used):
                continue
            if line == match[0] or _plausible(value, n):
                lines.append(quoted(head.raw[k]))
                break
    return lines


def _plausible(value: float, n: int) -> bool:
    """Whether a number looks like a rate, a step, a factor or nearly the count of samples."""
    rates = (*wordings.RATES, *(1.0 / rate for rate in wordings.RATES), *wordings.GRAVITY)
    near = value.is_integer() and abs(value - n) <= max(2, 0.02 * n)
    power = value in (1e-6, 1e-5, 1e-4, 0.1)
    return near or power or any(abs(value - x) <= RATIO_TOLERANCE * x for x in rates)


def _named(head: str, width: int, column: int) -> Iterator[str]:
    """Words that lines of a head write above a column of the table (counted from 1)."""
    for line in head_lines(head):
        for fields, apart in (
            (re.split(r"[;,\t]", line), True),
            (re.split(r" {2,}", line.strip()), False),
            (line.split(), False),
            (re.split(r"(?<=[\])]) +", line.strip()), False),
        ):
            named = len(fields) >= column if apart else len(fields) == width
            if len(fields) > 1 and named and 1 <= column <= len(fields):
                yield fields[column - 1]


_SHORT_NAME = re.compile(
    r"(([vdu]|vel|disp?)_?([xyz]|ns|ew|ud)|(vel|disp?)_?([0-9]|f|raw|filt)?"
    r"|(drift|theta|phi|rot|gyro|strain|force)_?(base|top|[xyz]|[0-9]+)?|[fmv]_?(base|top))(\s*[\[(].*)?",
    re.IGNORECASE,
)
"""Names of columns of a velocity, a displacement, a rotation or a force in programs: vx, ux, vel_f, disp1, drift,
rot_x, gyro_z, F_base."""


def refuse_column(head: str, width: int, column: int) -> None:
    """Raise RecordError where a head names another quantity above the column that is asked for."""
    for field in _named(head, width, column):
        if _SHORT_NAME.fullmatch(field.strip(" \"'")):
            raise RecordError("other_quantity", quantity=field.strip(), line=quoted(field))
        for text in re.findall(r"[\[(]([^\[\]()]{2,})", field):  # one letter is a direction
            unit = unit_of(text)
            if unit is not None and (unit.force or unit.angle or unit[1:] == (0, 1, -1, 0)):
                raise RecordError("other_quantity", quantity=text.strip(), line=quoted(field))
        refuse_other_quantity(field)


def standing(head: str, width: int, column: int) -> str:
    """Words by which a head places the sensor of a column in a structure: its name above the column, or a line that is
    of all columns; "" where none does."""
    named = [field for field in _named(head, width, column) if any(map(str.isalpha, field))]
    rows = [line for line in head_lines(head) if width < 3 or len(re.split(r"[;,\t]| {2,}", line.strip())) < width]
    return structure_words(rows, " ".join(named[:1]))


def vertical(head: str, width: int, column: int) -> bool:
    """Whether a head names a vertical direction, of the column or of the file."""
    for raw in head_lines(head):
        line = folded(raw).strip(_MARKS + "()[].")
        fields = [field for field in re.split(r"[;,\t|]| {2,}", line) if field.strip()]
        if width > 1 and (len(fields) >= width or (width > 2 and len(line.split()) >= width)):
            continue  # the head of a table: the column says
        codes = [match[1] for match in wordings.DIRECTION_LABEL.finditer(line)]
        if codes:  # of `dir 90 deg, UD` the last word
            codes += [word for word in re.split(r"[ ,;()]+", line) if word in ("ud", "u-d", "up", "vert", "vertical")]
        if len(line.split()) <= 3:
            codes += [line, *(word for word in re.split(r"[ .]+", line) if len(word) > 1 and word != "su")]
        if wordings.VERTICAL_WORDS.search(line) or any(
            wordings.DIRECTION_CODES.fullmatch(code.strip("()[],.;'\"")) for code in codes
        ):
            return True
    return any(map(is_vertical, _named(head, width, column)))
