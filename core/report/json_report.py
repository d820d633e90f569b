"""StudyResult -> the results JSON: exact values, the contract of the program. Its keys are those of
core/report/stated."""

import itertools
import json
from typing import Any

from core.report.stated.quantity import serialize
from core.report.stated.study import OF_STUDY, PAIRS, RESULTS, VERDICTS, WALLS
from core.study.results import StudyResult

_ENCODER = json.JSONEncoder(indent=1, allow_nan=False, ensure_ascii=False)


def _text(value: Any, depth: int) -> bytes:
    """JSON text of a value that lies so deep; raises ValueError should a number not be finite."""
    return _ENCODER.encode(value).replace("\n", "\n" + " " * depth).encode()


def results(result: StudyResult) -> dict:
    """The results as a mapping of the contract's keys; numbers are exact or None."""
    return serialize(RESULTS, result)


def dumps(result: StudyResult) -> str:
    """The results as JSON text; raises ValueError should a number not be finite."""
    text = JsonReport()
    for wall in result.split_by_wall():
        text.add(wall)
    return text.content(result).decode()


class JsonReport:
    """The results as JSON text, made while the walls of a study finish."""

    def __init__(self):
        self._verdicts: list[bytes] = []
        self._walls: list[bytes] = []

    def add(self, result: StudyResult) -> None:
        """The next wall, see `StudyResult.by_wall`. Raises ValueError should a number not be finite."""
        self._verdicts += [_text(one, 2) for one in serialize(VERDICTS, result)["verdicts"]]
        self._walls += [_text(one, 2) for one in serialize(WALLS, result)["walls"]]

    def content(self, result: StudyResult) -> bytes:
        """The file, once all walls are there. Raises ValueError should a number not be finite."""
        parts = {
            **{key: [_text(value, 1)] for key, value in serialize(OF_STUDY, result).items()},
            "verdicts": _listed(self._verdicts),
            "walls": _listed(self._walls),
            **{key: [_text(value, 1)] for key, value in serialize(PAIRS, result).items()},
        }
        pieces = [b"{"]
        for key, value in parts.items():
            pieces += [b"\n " if len(pieces) == 1 else b",\n ", _text(key, 1), b": ", *value]
        return b"".join([*pieces, b"\n}\n"])


def _listed(items: list[bytes]) -> list[bytes]:
    """Pieces of a list of the first level."""
    if not items:
        return [b"[]"]
    between = (piece for item in items for piece in (b",\n  ", item))
    return [b"[\n  ", *itertools.islice(between, 1, None), b"\n ]"]
