"""Every zeta that a face shows is one of the answer: note, docx, workbook, JSON, terminal of random cases read back."""

import dataclasses
import io
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from app.terminal.batch import summary
from core.answer.answer import Answer, answers_worst_first
from core.report.json_report import dumps
from core.report.note.brief import note
from core.report.note.document import document
from core.report.note.parts import Table
from core.study.run import run
from core.text.sentence import Sentence
from core.variation import measures
from tests.clauses_alone import parse_case
from tests.core.report.whole_workbook import content
from tests.core.variation.random_walls import random_tables

SHOWN = re.compile(r"ζ(?:_E|_16)?(?:[^0-9\n]{0,3}|[^0-9\n]{0,3}(?:about|circa) )(\d+[.,]\d\d)(?!\d)")
"""A zeta in a text: its two decimals."""


HALF = 0.0051
"""Half a unit of what is shown."""


def zetas_of(answer: Answer) -> set[float]:
    """Every zeta of the answer for a wall, its checks, rows, states and measures."""
    found: set[float] = set()

    def walk(value, name="") -> None:
        if isinstance(value, bool) or value is None:
            return
        if isinstance(value, float | int):
            if "zeta" in name or name in ("low", "high", "gives_way", "bound", "base"):
                found.add(float(value))
        elif isinstance(value, Sentence):
            for key, part in value.values:
                walk(getattr(part, "value", part), f"zeta_{key}")
        elif dataclasses.is_dataclass(value):
            for field in dataclasses.fields(value):
                walk(getattr(value, field.name), field.name if "zeta" not in name else name)
        elif isinstance(value, dict):
            for part in value.values():
                walk(part, name)
        elif hasattr(value, "_asdict"):
            for key, part in value._asdict().items():
                walk(part, key)
        elif isinstance(value, list | tuple):
            for part in value:
                walk(part, name)

    walls = answer.result.walls
    walk(answer.verdict, "zeta")
    for wall in walls:
        if wall.part.origin == answer.decides.part.origin:
            walk(wall.assessment)
            found |= {check.ratio for check in wall.code_check if check is not None}  # Eq. 9 beside them
            kinematic = wall.assessment.kinematic if wall.assessment else None
            if kinematic is not None and kinematic.without_ties is not None:  # in the results by this name
                found.add(kinematic.without_ties.ratio)
    return found


def shown_in(text: str) -> Iterator[float]:
    for number in SHOWN.findall(text):
        yield float(number.replace(",", "."))


LEAST = {"least", "minimo", "minima", "lowest"}
"""Heads of columns of zeta that do not say so."""


def by_heads(heads, rows) -> Iterator[str]:
    """The cells of a table, those below a head of zeta with it."""
    for row in rows:
        for head, cell in zip(heads, row, strict=False):
            yield f"ζ {cell}" if "ζ" in str(head) or str(head) in LEAST else str(cell)


def cells_of(file: bytes) -> Iterator[str]:
    """Texts of a workbook, and the numbers below a head of zeta."""
    from openpyxl import load_workbook

    for sheet in load_workbook(io.BytesIO(file)):
        of_zeta: set[int] = set()
        for row in sheet.iter_rows(values_only=True):
            for column, cell in enumerate(row):
                if isinstance(cell, str) and not cell.startswith("="):
                    (of_zeta.add if "ζ" in cell and len(cell) < 12 else of_zeta.discard)(column)
                    yield cell
                elif isinstance(cell, float) and column in of_zeta:
                    yield f"ζ {cell:.2f}"


def words_of(parts) -> Iterator[str]:
    """Every text of the parts of a note."""
    for part in parts:
        if isinstance(part, Table):
            yield from by_heads(part.heads, part.rows)
            continue
        for value in vars(part).values() if hasattr(part, "__dict__") else part:
            if isinstance(value, str):
                yield value
            elif isinstance(value, list | tuple):
                yield from words_of([value])


def docx_words(file: bytes) -> list[str]:
    import docx

    made = docx.Document(io.BytesIO(file))
    words = [paragraph.text for paragraph in made.paragraphs]
    for table in made.tables:
        heads, *rows = [[cell.text for cell in row.cells] for row in table.rows]
        words += by_heads(heads, rows)
    return words


def json_zetas(value) -> Iterator[float]:
    """Every number of the results that is a zeta by its key."""
    if isinstance(value, dict):
        for name, part in value.items():
            if name.startswith("zeta") and isinstance(part, float | int):
                yield float(part)
            yield from json_zetas(part)
    elif isinstance(value, list):
        for part in value:
            yield from json_zetas(part)


def compare(seed: int, count: int) -> int:
    """Compare so many random cases; how many zetas were read back."""
    read = 0
    for table in random_tables(count, first=seed):
        result = run(parse_case(table), base_dir=Path())
        (answer,) = answers_worst_first(result)
        known = sorted(zetas_of(answer))
        written = dumps(result)
        for zeta in json_zetas(json.loads(written)):
            read += 1
            assert min(abs(zeta - value) for value in known) < 1e-9, zeta
        texts = {"terminal": [summary(result, Path(), "w")], "JSON": [written]}
        for language in ("en", "it"):
            parts = note(result, language)
            texts[f"note {language}"] = list(words_of(parts))
            texts[f"docx {language}"] = docx_words(document(parts, language))
        texts["workbook"] = list(cells_of(content(result, [])))
        for face, words in texts.items():
            for text in words:
                for zeta in shown_in(text):
                    read += 1
                    near = min((abs(zeta - value) for value in known), default=1.0)
                    assert near <= HALF, (face, zeta, text[:200], known)
    return read


@pytest.fixture(autouse=True)
def no_search(monkeypatch):
    """No search of what makes a wall that fails pass, which takes seconds."""
    monkeypatch.setattr(measures, "MOST", 0)


@pytest.mark.shows("answer.faces")
def test_that_every_zeta_of_every_file_is_one_of_the_answer():
    assert compare(41_000, 6) > 60


@pytest.mark.long
@pytest.mark.parametrize("seed", range(42_000, 42_200, 20))
def test_that_every_zeta_of_the_files_of_200_cases_is_one_of_the_answer(seed):
    assert compare(seed, 20) > 200
