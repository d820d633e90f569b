"""Is a file cut inside its last number? `E-03` cut to `E-0` is a thousand times larger, and no count sees it."""

import re

from core.errors import RecordError
from core.ground.records.grammar import GLUED, NUMBER_LETTERS, quoted
from core.text.sentence import sentence

NEIGHBOURS = 20
"""Lines above the last one that its last number is compared with."""

MIN_ROWS, MIN_DIGITS = 4, 3
"""Numbers of one shape, and digits, that make it the shape of a file."""

_TOKEN = re.compile(r"[+-]?(?P<whole>[0-9]*)(?:[.,](?P<decimals>[0-9]*))?(?:[EeDd][+-]?(?P<exponent>[0-9]*))?")


def _shapes(token: str) -> tuple[tuple[int, int], tuple[int, int]]:
    """(decimals, digits of the exponent) and (significant digits, digits of the exponent)."""
    match = _TOKEN.match(token)
    assert match is not None
    exponent = len(match["exponent"] or "")
    mantissa = (match["whole"] + (match["decimals"] or "")).lstrip("0")
    return (len(match["decimals"] or ""), exponent), (len(mantissa), exponent)


def _tokens(line: str) -> list[str]:
    """The numbers of a line, also glued ones; the mark of decimals may be a comma where ; or tabs stand between."""
    if not line.translate(NUMBER_LETTERS):
        return GLUED.sub(" ", line).split()
    if re.search(r"[0-9],[0-9]", line) and not ("." in line and "," in line):
        parts = re.split(r"[;\t]" if re.search(r"[;\t]", line) else r"[,\s]", line)
    else:
        parts = re.split(r"[,;\s]", line)
    glued = [GLUED.split(part.strip()) for part in parts]
    return [token for part in glued for token in part if token]


def refuse_cut(lines: list[str], ended: bool) -> None:
    """Raise RecordError where the last number of a file may be half a number.

    lines : of the file
    ended : its last line has a line end
    Where the lines above it have one length, or the numbers of its column one shape (decimals, digits of the
    exponent), the last has it too or is cut; where they have none, a last line without an end may be cut anywhere.
    """
    tail = [line for line in lines[-NEIGHBOURS - 1 :] if line.strip()]
    rows = [(line, _tokens(line)) for line in tail]
    rows = [(line, row) for line, row in rows if row and all(map(_TOKEN.fullmatch, row))]
    if not rows or rows[-1][0] != tail[-1]:
        return  # what is no number is refused by the reader, or ends the file as NaN
    *_, last = rows[-1][1]
    place = len(rows[-1][1]) - 1
    shapes, same = _shapes_above(rows, place)
    full = _fills_its_line(rows)
    if full is not None and (full or not ended):
        whole = full
    elif same is not None:
        zero = not last.strip("+-0.") and (ended or (last == "0" and "0" in _first(lines, place)))
        whole = zero or _shapes(last)[same] == shapes[0][same]
    else:
        shortest = min((exponent for (_, exponent), _ in shapes), default=0)
        whole = ended and _shapes(last)[0][1] >= shortest
    if not whole:
        unended = same is None and not ended
        raise RecordError(
            "last_number_cut",
            last=quoted(last),
            why=sentence("accepted", "without_line_end" if unended else "shorter_than_above"),
            mend=sentence("accepted", "write_all_digits" if ended else "end_last_line"),
        )


def _shapes_above(rows: list[tuple[str, list[str]]], place: int):
    """(`_shapes` of the numbers above the last, which of both kinds is the same throughout or None).

    rows : lines with their numbers
    place : column of the last number, from 0
    """
    above = [row[place] for _, row in rows[:-1] if len(row) > place]
    if len(above) < MIN_ROWS:
        above = [token for _, row in rows for token in row][:-1]
    shapes = [_shapes(token) for token in above if token != "0"]
    if len(above) >= MIN_ROWS:
        for kind, least in enumerate((1, MIN_DIGITS)):
            if len({pair[kind] for pair in shapes}) == 1 and max(shapes[0][kind]) >= least:
                return shapes, kind
    return shapes, None


def _fills_its_line(rows: list[tuple[str, list[str]]]) -> bool | None:
    """Whether the last line is as long as those above; None where these have no one length. rows : with numbers."""
    line, numbers = rows[-1]
    lengths = {len(other.rstrip()) for other, _ in rows[:-1]}
    one_row = all(len(row) == len(numbers) for _, row in rows)
    if not one_row or len(lengths) != 1 or len(rows) <= MIN_ROWS:
        return None
    return len(line.rstrip()) >= next(iter(lengths))


def _first(lines: list[str], place: int) -> list[str]:
    """Numbers of this column in the first lines, the last one apart: does the file write zero as 0?"""
    filled = [line for line in lines[: NEIGHBOURS + 1] if line.strip()]
    rows = (_tokens(line) for line in (filled[:-1] if len(lines) <= NEIGHBOURS + 1 else filled))
    return [row[place] for row in rows if len(row) > place]
