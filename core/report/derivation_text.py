"""The words of a line of a derivation in a language: title, formula in symbols and in numbers, unit, clause, label."""

from contextlib import suppress
from dataclasses import dataclass

from core.codes.kinematic import STATE_DAMPING
from core.derivation.faces import Branches, Shown, in_numbers, in_symbols
from core.derivation.line import FULL, Columns, Line, Section, Word
from core.study.results import StudyResult
from core.text.sentence import format_number, localized, word

PERIOD_CLAUSES = {"SLV": "C8.7.1.10", "SLC": "C8.7.1.11"}
"""Clauses of T_SLV and T_SLC."""


@dataclass(frozen=True)
class LineText:
    """symbol, unit, clause : filled in
    title : of the row of a workbook; label : beside the line of a note
    symbols, numbers : the right side, empty where the line shows none
    """

    symbol: str
    unit: str
    clause: str
    title: str
    label: str
    symbols: str
    numbers: list[str | Shown]

    @property
    def written(self) -> str:
        """Symbol and formula, "" without one."""
        return f"{self.symbol} = {self.symbols}" if self.symbols else ""


class DerivationText:
    """Says the lines of a section one after the other: a line needs the symbols and values of those before it."""

    def __init__(self, result: StudyResult, language: str, known: "DerivationText | None" = None):
        state = result.demand_required.limit_state if result.demand else ""
        self.language = language
        self.symbols: dict[str, str] = dict(known.symbols) if known else {}
        self.shown: dict[str, Shown] = dict(known.shown) if known else {}
        self.words = {
            "state": state,
            "damping": f"{100.0 * STATE_DAMPING[state]:g}" if state in STATE_DAMPING else "",
            "period_clause": PERIOD_CLAUSES.get(state, ""),
            "years": localized("report", "years", language),
        }

    def enter(self, section: Section) -> None:
        """Take up the constants and columns of a section."""
        for name, value in section.constants.items():
            self.symbols[name] = format_number(value, ".2f", self.language)
            self.shown[name] = Shown(value, 2, None)
        for line in section.lines:
            if isinstance(line, Columns):
                self.symbols |= line.symbols

    def read(self, value):
        """A value as it is read: the word of a code, any other as it is."""
        return word(value, self.language) if isinstance(value, Word) else value

    def said(self, text: str, **words) -> str:
        """A text of the group "report", or a word of a result."""
        if isinstance(text, Word):
            return word(text, self.language)
        return localized("report", text, self.language, **words) if text else ""

    def of(self, line: Line, cell: str | None = None, run_cell: str | None = None) -> LineText:
        """The words of a line, which those after it may name. cell : that has its value; run_cell : that has the one of
        the program"""
        of = line.of
        values = {name: self.read(value) for name, value in line.words.items()}
        words = {**self.words, **values}
        symbol, unit, clause = (part.format(**words) for part in (of.symbol, of.unit, of.clause))
        title = line.title or of.label
        for one, other in line.other.items():
            self.symbols[one], self.shown[one] = self.symbols[other], self.shown[other]
        symbols, numbers = "", []
        if line.quantity is not None:
            with suppress(Branches):
                symbols = in_symbols(line.quantity, self.symbols, self.language)
                if symbols.startswith(symbol) and symbols[len(symbol) :][:1] in ("", "("):  # its symbol is its formula
                    symbols = ""
            if line.note == FULL:
                with suppress(Branches):
                    numbers = in_numbers(line.quantity, self.shown, self.language)
        said = LineText(
            symbol,
            unit,
            clause,
            self.said(title, **words) if title else symbol,
            self.said(line.label, **words),
            symbols,
            numbers,
        )
        for name, place in ((of.name, cell), (line.run_name, run_cell)):
            self.symbols[name] = symbol
            if isinstance(line.value, (int, float)):
                self.shown[name] = Shown(line.value, of.digits, place)
        return said
