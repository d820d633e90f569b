"""A table whose cells copy into Word and Excel."""

import math
from collections.abc import Sequence
from typing import Any

from PySide6.QtGui import QColor, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from app.look import theme
from app.look.language import number, tr
from core.known import require_value
from core.report.plain_cell import plain_cell
from core.report.tables import WINDOW, DataTable

SCROLL_BAR_ROOM = 24
"""What the widest column gives at last, for no scroll bar [px]."""

MAX_WRAPPED_ROWS = 400
"""Rows up to which their height follows their words: more take too long."""


class Table(QTableWidget):
    """Read-only cells; Ctrl+C copies the selection, or all of it, with tabs between the cells.

    live : what it shows is of the input as it stands, not of the last result
    wraps : its columns give way where the room is short; else it scrolls
    """

    stale = False
    """Whether the input has changed since the result shown: what leaves the program says so, charts too."""

    live = False

    def __init__(self, name: str, heads: list[str], wraps: bool = True):
        super().__init__(0, len(heads))
        self.wraps, self.fitted = wraps, 0
        self.setAccessibleName(name)
        self.setTabKeyNavigation(False)  # the arrows go from cell to cell, Tab leaves
        self.setHorizontalHeaderLabels(heads)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.verticalHeader().hide()
        self.setAlternatingRowColors(True)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self.setWordWrap(wraps)
        self.horizontalHeader().setStretchLastSection(True)

    def show_rows(self, rows: list[list], colors: list[list[str | None]] | None = None) -> None:
        """Fill the table with words."""
        self.setRowCount(len(rows))
        for r, row in enumerate(rows):
            for c, content in enumerate(row):
                item = QTableWidgetItem(str(content))
                if colors and colors[r][c]:
                    item.setForeground(QColor(colors[r][c]))
                self.setItem(r, c, item)
        self.fit()

    def show_table(self, table: DataTable, rows: Sequence[Any]) -> None:
        """Fill it with the rows of a table, its heads with it."""
        self.setColumnCount(len(columns := table.shown(WINDOW, rows)))
        self.setHorizontalHeaderLabels([column.head for column in columns])
        shades = {"good": theme.current.good, "bad": theme.current.bad, "quiet": theme.current.quiet}
        tones = table.tones(WINDOW, rows)
        colors = [[shades.get(tones.get((n, k), "")) for k in range(len(columns))] for n in range(len(rows))]
        self.show_rows(table.words(WINDOW, rows, number), colors)

    def _head(self, column: int) -> str:
        return require_value(self.horizontalHeaderItem(column)).text()

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        if self.width() != self.fitted:  # not for a scroll bar that comes and goes
            self.fit()

    def fit(self) -> None:
        """Columns as wide as their words; where they are too many, the wide ones give way and their words wrap."""
        self.fitted = self.width()
        head = self.horizontalHeader()
        # rows that wrap may bring the vertical scroll bar
        room = self.width() - 2 * self.frameWidth() - self.verticalScrollBar().sizeHint().width() - 2
        columns = [c for c in range(self.columnCount()) if not self.isColumnHidden(c)]
        wanted = {c: max(self.sizeHintForColumn(c), head.sectionSizeHint(c)) + 4 for c in columns}
        over = sum(wanted.values()) - room + 2
        if self.wraps and over > 0:
            least = {c: min(wanted[c], self._widest_word(c)) for c in columns}
            slack = sum(wanted.values()) - sum(least.values())
            share = min(1.0, over / max(slack, 1))
            for c in columns:
                wanted[c] -= math.ceil(share * (wanted[c] - least[c]))
            widest = max(columns, key=lambda c: wanted[c])
            wanted[widest] -= max(0, min(SCROLL_BAR_ROOM, sum(wanted.values()) - room + 2))
        for c, width in wanted.items():
            self.setColumnWidth(c, width)
        if self.rowCount() <= MAX_WRAPPED_ROWS:
            self.resizeRowsToContents()

    def _widest_word(self, column: int) -> int:
        """Width [px] below which a word of a column would be cut."""
        cells = [self.item(r, column) for r in range(min(self.rowCount(), MAX_WRAPPED_ROWS))]
        words = {word for cell in cells if cell for word in cell.text().split()}
        metrics, bold = self.fontMetrics(), self.horizontalHeader().fontMetrics()
        widths = [metrics.horizontalAdvance(word) for word in words]
        widths += [  # a head does not wrap: its unit stands in its line
            bold.horizontalAdvance(line) + 4 for line in self._head(column).split("\n")
        ]
        return max(widths) + 10

    def text(self) -> str:
        """Selected cells, or the whole table with its heads, with tabs and line ends."""
        chosen = self.selectedIndexes()
        rows = sorted({index.row() for index in chosen}) or range(self.rowCount())
        columns = sorted({index.column() for index in chosen}) or range(self.columnCount())
        lines = []
        if Table.stale and not self.live:
            lines.append(tr("The input has changed since these results."))
        if len(chosen) != 1:
            lines.append("\t".join(self._head(c).replace("\n", " ") for c in columns))
        for r in rows:
            cells = (self.item(r, c) for c in columns)
            words = (" ".join(cell.text().split()) if cell else "" for cell in cells)
            lines.append("\t".join(map(plain_cell, words)))
        return "\n".join(lines)

    def keyPressEvent(self, event) -> None:
        if event.matches(QKeySequence.StandardKey.Copy):
            QGuiApplication.clipboard().setText(self.text())
        else:
            super().keyPressEvent(event)
