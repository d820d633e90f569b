"""Units and quantities that a head states, by the tables of `wordings`."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from core.errors import RecordError
from core.ground.records import wordings
from core.ground.records.grammar import UNITS, Parsed, head_lines, quoted
from core.ground.records.wordings import any_of, folded

_LABEL = re.compile(r"\b(pga|peak|max(?:imum)?|min(?:imum)?|gravity|picco|massim[oa]|gravita)\b|^\W*g *=")
"""Words of a line that gives one value, not the samples."""

_VALUE = re.compile(r"[0-9]\.?[ \t]*\Z|[0-9][ed][+-]?[0-9]+[ \t]*\Z")
"""The end of a text that gives a number: what follows is its unit, not that of the samples."""

_NUMBER_AFTER = re.compile(r"[ \t]*+[:=]?[ \t]*+[+-]?[.0-9]")
_BRACKETS = re.compile(r"[\[(]([^\[\]()]{1,40})[\])]")
_FIELD = re.compile(r"[;,\t|]| {2,}")
_FIELD_EDGE = re.compile(r"\A[\s#%!/*'\"\[(<:]++|[\s'\"\])>:]++\Z")
_CONVERTED = re.compile(r"\b(?:convert\w*|trasformat\w*|changed) +(?:to|into|in) +(?=\S)")
_TIME_FIELD = re.compile(rf"(?:t|time|tempo)?[ _.]*{any_of(wordings.TIME_UNITS)}\.?")
_TIME_NAME = re.compile(r"\W*(?:t|time|tempo)\b")
_BESIDE_WORD = re.compile(rf"\b{wordings.ACCELERATION_WORD}[a-z]{{0,3}}[ ._:,-]*+(?=[a-z0-9%])")
_BRACKET_END = re.compile(r" *+(?:[\])]|[,;])")
_FIELD_END = re.compile(r" *+(?:\Z|[;,\t|)\"']|  )")
_LETTERS = "abcdefghijklmnopqrstuvwxyz0123456789/"
_ACCELERATION_WORD = re.compile(r"\bacc(?:\b|el|_)|\ba\b *[\[(]")
_SPECTRUM = re.compile(
    r"\b(spectr(?:um|a|al)|spettr\w*|response(?![ \t]+spectr)|fourier|fft|psd|psa|psv|pseudo\w*"
    r"|s_?[avde]\b(?![ \t]*+=))"
    r"|\b(?:periods?|periodo|frequenc(?:y|ies)|frequenza)[ \t]*+[\[(](?![^\])]*[\])][ \t]*+[:=]?[ \t]*+[0-9])"
)
_PERIOD = re.compile(r"\bperiod(?:s|o)?\b")
_OF_A_TARGET = re.compile(
    r"\b(target|match|compatib|return|ritorno|corner|filter|sampl|campion)|\b(?:d|di) campionamento"
)
_MOTION = re.compile(rf"\b(?:{wordings.MOTION})")
_OTHER_QUANTITY = re.compile(rf"\b(?:{wordings.OTHER_QUANTITY})")


@dataclass(frozen=True)
class Unit:
    """A unit as a head writes it.

    quantity : "acceleration", "velocity", ...
    si : one of it [m/s2], None of another quantity
    text : as written
    line : where, quoted
    """

    quantity: str
    si: float | None
    text: str
    line: str

    @property
    def size(self) -> float:
        """Acceleration of one of this unit [m/s2]."""
        assert self.si is not None
        return self.si

    @property
    def key(self) -> str:
        """The unit of `UNITS` it is, or a multiple of."""
        near = [key for key, of_one in UNITS.items() if abs(self.size / of_one - 1.0) < 1e-9]
        letters = re.sub("[^a-z]", "", self.text)
        base = "g" if letters in ("g", "mg", "ug") or "g" in letters.replace("gal", "") else "m/s2"
        return (near or ["cm/s2" if "gal" in letters else base])[0]

    @property
    def name(self) -> str:
        """Name of the unit as the case has it, else as written."""
        return self.key if self.factor == 1.0 else self.text

    @property
    def factor(self) -> float:
        """Units of its key in one of this unit [-]."""
        ratio = self.size / UNITS[self.key]
        return 1.0 if abs(ratio - 1.0) < 1e-9 else ratio


def factor_of(text: str) -> float | None:
    """Value of a number, a power or a quotient as text; None where it has none."""
    text = text.replace(" ", "").replace(",", ".").replace("**", "^").replace("d", "e")
    times, _, power = text.rpartition("^")
    try:
        if power != text and times:
            base = times.removesuffix("10").rstrip("*x")
            return (float(base) if base else 1.0) * 10.0 ** float(power)
        over, _, under = text.partition("/")
        first, _, tens = over.partition("x10") if "x10" in over else over.partition("*10")
        value = float(first) * (10.0 ** float(tens) if tens else 1.0)
        return value / float(under) if under else value
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def units_of(match: re.Match, line: str) -> Iterator[Unit]:
    """The unit of a match of `wordings.UNIT`; none of a factor that is no number."""
    text = match[0].strip()
    if match["named"]:
        word = next(w for w in wordings.NAMED_UNITS if re.fullmatch(any_of([w]), match["named"]))
        quantity, si = wordings.NAMED_UNITS[word]
    else:
        power = _power(match)
        quantity = wordings.OF_POWER.get(power, "other")
        si = wordings.LENGTH_UNITS[match["length"]] if power == 2 else None
    for name, sign in (("before", 1), ("after", -1 if match["how"] in ("/", "per") else 1)):
        if match[name] and si is not None:
            factor = factor_of(match[name])
            if not factor or not 0.0 < abs(factor) < 1e300:
                return
            si *= factor**sign
    yield Unit(quantity, si, text, quoted(line))


def _power(match: re.Match) -> int:
    """Over how many seconds a length stands."""
    if match["minus"] or match["under"]:
        return int(match["minus"] or match["under"])
    if match["square"]:
        return 2
    if not match["over"]:
        return 0
    slashes = len(re.findall(r"/|\b(?:per|al|a|over)\b", match["over"]))
    word = match["word"] or ""
    if match["power"]:
        return slashes - 1 + int(match["power"])
    return slashes if not word else 3 if "cub" in word else 2


def take_unit(parsed: Parsed, unit: Unit | None) -> None:
    """Keep the unit a head states, and as a factor what it is of the unit of the case."""
    if unit is None:
        return
    parsed.unit, parsed.lines["unit"] = unit.key, unit.line
    if unit.factor != 1.0:
        error = RecordError("unit_not_read", unit=unit.text, line=unit.line)
        parsed.factor = (unit.factor, error)


def _bare(match: re.Match) -> bool:
    """Whether a unit could be something else where nobody says that it is one: V, m."""
    return match["named"] in wordings.AMBIGUOUS_UNITS or bool(match["length"] and not _power(match))


def _said(line: str) -> Iterator[tuple[re.Match, bool, bool]]:
    """(unit, whether it follows a number, whether a number follows it) of what a line says to be a unit."""
    for match in _BRACKETS.finditer(line):
        start = match.start(1) + len(match[1]) - len(match[1].lstrip())
        unit = wordings.UNIT.match(line, start, match.end(1))
        if not unit or not _BRACKET_END.match(line, unit.end()):
            continue
        if unit["named"] in wordings.AMBIGUOUS_UNITS and not _ACCELERATION_WORD.search(line):
            continue
        before = line[max(0, match.start() - 40) : match.start()]
        yield unit, bool(_VALUE.search(before)), bool(_NUMBER_AFTER.match(line, match.end()))
    for match in (*wordings.UNIT_SAID.finditer(line), *_CONVERTED.finditer(line)):
        unit = wordings.UNIT.match(line, match.end())
        if unit and not (unit["length"] == "in" and not _power(unit)):
            yield unit, False, bool(_NUMBER_AFTER.match(line, unit.end()))


def _in_words(line: str) -> Iterator[re.Match]:
    """Units of a line that says of none that it is one: alone in a field, after `acc`, or one of acceleration only."""
    fields = [line.strip()]  # "%g" is no comment
    if not wordings.UNIT.fullmatch(fields[0]):
        fields = [_FIELD_EDGE.sub("", field) for field in _FIELD.split(line)]
    timed = len(fields) > 1 and any(map(_TIME_FIELD.fullmatch, fields))
    for field in fields:
        match = wordings.UNIT.fullmatch(field)
        if match and (timed or not _bare(match)) and not _of_a_value(match):
            yield match
    for word in _BESIDE_WORD.finditer(line):
        match = wordings.UNIT.match(line, word.end())
        if match and not _bare(match) and not _of_a_value(match) and _FIELD_END.match(line, match.end()):
            yield match
    for match in wordings.UNIT.finditer(line):
        at = match.start("named") if match["named"] else match.start("length")
        alone = not at or line[at - 1] not in _LETTERS
        only = _power(match) > 1 if match["length"] else re.search("gal|kine", match["named"])
        if only and alone and not _of_a_value(match) and not _VALUE.search(line[max(0, at - 40) : at]):
            yield match


def _of_a_value(match: re.Match) -> bool:
    """Whether the number before a unit is a value: 0.31 g, not 1e-3 g."""
    return bool(match["before"]) and not re.search(r"[e^]|10 *\Z|0\.0+1\Z", match["before"])


def _units(head: str) -> Iterator[tuple[Unit, str]]:
    """(unit, "said" of the samples, "beside" one value or in "words") of a head."""
    for raw in head_lines(head):
        line = folded(raw)
        label = _LABEL.search(line)
        for match, of_one, _ in _said(line):
            yield from ((unit, "beside" if of_one or label else "said") for unit in units_of(match, raw))
        if not label:
            for match in _in_words(line):
                yield from ((unit, "words") for unit in units_of(match, raw))


def stated_unit(head: str) -> Unit | None:
    """Unit of acceleration a head states. A unit after a number is that of another quantity (`gravity = 9.81 [m/s2]`,
    `PGA 0.013 (g)`) and states nothing; where it differs from the one stated, or two are stated, nobody knows which
    holds. Raises RecordError then, and for counts and volts."""
    by_wording: dict[str, list[Unit]] = {"said": [], "beside": [], "words": []}
    for unit, how in _units(head):
        if unit.quantity in ("counts", "voltage") and how != "beside":
            raise RecordError("unit_not_read", unit=unit.text, line=unit.line)
        if unit.quantity == "acceleration":
            by_wording[how].append(unit)
    units = by_wording["said"] or by_wording["words"]
    words = [one for one in by_wording["words"] if units and one.line != units[0].line]
    for other in [*units[1:], *words, *by_wording["beside"]] if units else ():
        one = units[0]
        if abs(other.size / one.size - 1.0) > 1e-9:
            raise RecordError("two_units", one=one.name, first=one.line, other=other.name, second=other.line)
    return units[0] if units else None


_ROTATED = re.compile(r"\b(?:gm)?rot_?[di]_?(?:[0-9]{1,3}|nn|pp)\b", re.IGNORECASE)
"""RotD50, RotD100, GMRotI50: measures of all directions."""


def refuse_other_quantity(head: str) -> None:
    """Raise RecordError where a header speaks of a velocity, a displacement, a rotation, ... or a spectrum, whatever
    else stands in it. A line that names the acceleration too is the head of a table; a record matched to a spectrum
    is one."""
    plain = stated_unit(head) is None
    for raw in head_lines(head):
        line = wordings.NOT_THE_SAMPLES.sub(" ", folded(raw))
        other = None
        if not _OF_A_TARGET.search(line):
            if _ROTATED.search(line):
                raise RecordError("rotated_spectra", line=quoted(raw))
            other = _SPECTRUM.search(line) or (plain and _PERIOD.search(line))
        said = other[0] if other else _other_of(line)
        if said:
            raise RecordError("other_quantity", quantity=said.strip("[()] "), line=quoted(raw))


def _other_of(line: str) -> str | None:
    """Quantity that a line names which is no head of a table with an acceleration."""
    fields = [field for field in re.split(r"[;,\t]| {2,}|(?<=[\])]) ", line) if field.strip()]
    if len(fields) == 1 and _TIME_NAME.match(line):
        fields = line.split()
    line, fields = line.replace("_", " "), [field.replace("_", " ") for field in fields]  # raw_acc, vel_f
    if len(fields) > 1 and any(
        _ACCELERATION_WORD.search(field) and not _words_of_other(field) and not _units_of_other(field)
        for field in fields
    ):
        return None
    return _words_of_other(line) or _units_of_other(line)


def _words_of_other(line: str) -> str | None:
    """A word of another quantity."""
    match = _MOTION.search(line)
    if not match and not _ACCELERATION_WORD.search(line) and (other := _OTHER_QUANTITY.search(line)):
        valued = _NUMBER_AFTER.match(line, other.end()) or _VALUE.search(line[: other.start()])
        match = None if valued else other
    return match[0] if match else None


def _units_of_other(line: str) -> str | None:
    """A unit of another quantity that a line says to be that of the samples."""
    said = [match for match, of_one, valued in _said(line) if not of_one and not valued]
    words = [] if _LABEL.search(line) else list(_in_words(line))
    for match in [*said, *words]:
        for unit in units_of(match, line):
            if unit.quantity not in ("acceleration", "counts", "voltage") and not (
                match["length"] and not _power(match) and match["length"] not in wordings.BARE_LENGTHS
            ):
                return unit.text
    return None
