"""Lines of a derivation as rows of the sheet Check: live formulas, and the value of the program beside them."""

from core.derivation.faces import formula
from core.derivation.line import INPUT, Columns, Line, Section
from core.report.cells import BAD, GOOD, Book, fill, header, number, rule, style, text
from core.report.derivation_text import DerivationText
from core.report.rows import CHANGED_COLUMN, INPUT_FILL, formula_row, input_row, mark_changed, run_value_row
from core.study.results import StudyResult, WallResult
from core.text.sentence import word

SIZE = "0.000"

MAX_FORMULA_LETTERS = 42
"""Characters of a line in symbols that the first column has room for; a longer one shows its symbol alone."""


class Rows:
    """Writes the sections of a wall, or of the demand, and knows their cells.

    prefix : what the names of its cells begin with
    cells : name of a quantity -> its cell, range or constant; of a wall those of the demand to begin with
    """

    def __init__(self, book: Book, sheet, result: StudyResult, prefix: str = "", known: "Rows | None" = None):
        self.book, self.sheet, self.prefix = book, sheet, prefix
        self.cells: dict[str, str] = dict(known.cells) if known else {}
        self.phrases: DerivationText = DerivationText(result, book.language, known.phrases if known else None)

    def write(self, section: Section, row: int) -> int:
        """The lines from this row on; returns the next."""
        self.phrases.enter(section)
        self.cells |= {name: f"{value!r}" for name, value in section.constants.items()}
        for line in section.lines:
            row = self._columns(line, row) if isinstance(line, Columns) else self._line(line, row)
        return row

    def _line(self, line: Line, row: int) -> int:
        of, book, sheet = line.of, self.book, self.sheet
        said = self.phrases.of(line)
        name = self.prefix + of.name
        if isinstance(line.value, str):
            text(sheet, row, 1, said.title)
            text(sheet, row, 3, self.phrases.read(line.value), align="right")
            text(sheet, row, 5, said.unit, align="center")
            return row + 1
        if line.quantity is None:
            write = input_row if line.source == INPUT else run_value_row
            row = write(book, sheet, row, said.title, line.value, said.unit, name, of.shape)
        else:
            fits = said.title == said.symbol and 0 < len(said.written) <= MAX_FORMULA_LETTERS
            label = said.written if fits else said.title
            cells = self.cells | {one: self.cells[other] for one, other in line.other.items()}
            live, run = formula(line.quantity, cells), line.run_name and self.prefix + line.run_name
            row = formula_row(book, sheet, row, label, said.clause, live, line.value, said.unit, name, of.shape, run)
            if run:
                self.cells[line.run_name] = run
        self.cells[of.name] = name
        if line.passed is not None:
            self._outcome(row - 1, name, line.passed)
        return row

    def _columns(self, columns: Columns, row: int) -> int:
        """A table whose columns the formulas sum over."""
        book, sheet, of_case = self.book, self.sheet, columns.source == INPUT
        heads = [f"{symbol} [{unit}]" for symbol, unit in zip(columns.symbols.values(), columns.units, strict=True)]
        header(sheet, row, [book.say(columns.title), *heads], 1, 18)
        first = row + 1
        for label, values in columns.rows:
            row += 1
            text(sheet, row, 1, self.phrases.read(label))
            for column, value in enumerate(values, start=2):
                if columns.cells:
                    live = f"={self.prefix}{columns.cells[row - first][column - 2]}"
                    book.formula(sheet.cell(row, column), live, value, SIZE)
                    continue
                cell = number(sheet, row, column, value, SIZE)
                if of_case:
                    fill(cell, INPUT_FILL)
                    number(sheet, row, CHANGED_COLUMN + column - 1, value, SIZE)
            if of_case:
                last = 1 + len(values)
                now = f"{sheet.cell(row, 2).coordinate}:{sheet.cell(row, last).coordinate}"
                then = (sheet.cell(row, CHANGED_COLUMN + column - 1).coordinate for column in (2, last))
                mark_changed(book, sheet, row, now, ":".join(then))
            rule(sheet, row, 1, 1 + len(values))
        for column, key in enumerate(columns.symbols, start=2):
            letter = sheet.cell(row, column).column_letter
            cells = f"${letter}${first}:${letter}${row}"
            shift = columns.shift.get(key)
            self.cells[key] = f"({cells}-{self.cells[shift]})" if shift else cells
        return row + 1

    def _outcome(self, row: int, zeta: str, passed: bool) -> None:
        """A live word in the row of zeta: passed from the zeta required."""
        yes, no = (word(code, self.book.language) for code in ("passed", "not_passed"))
        live = f'=IF({zeta}>=zeta_target-1E-12,"{yes}","{no}")'
        cell = self.book.formula(self.sheet.cell(row, 6), live, yes if passed else no)
        style(cell, bold=True, color=GOOD if passed else BAD)


def cell_prefix(result: StudyResult, wall: WallResult) -> str:
    """Prefix of the names of the cells of a wall: wall1_ for the first of the result."""
    return f"wall{result.numbers[id(wall)]}_"
