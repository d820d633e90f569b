"""A table whose cells copy into Word and Excel."""

import re

from PySide6.QtGui import QColor, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from app.language import tr


def plain_cell(text: str) -> str:
    """Text that no spreadsheet takes for a formula."""
    if re.fullmatch(r"[+-]?[0-9]+([.,][0-9]+)?([eE][+-]?[0-9]+)?", text):
        return text
    return f"'{text}" if text.strip()[:1] in ("=", "+", "-", "@") else text


class Table(QTableWidget):
    """Read-only cells; Ctrl+C copies the selection, or all of it, with tabs between the cells.

    live : what it shows is of the input as it stands, not of the last result
    """

    stale = False
    """Whether the input has changed since the result shown: what is copied says so."""

    live = False

    def __init__(self, name: str, heads: list[str]):
        super().__init__(0, len(heads))
        self.setAccessibleName(name)
        self.setHorizontalHeaderLabels(heads)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.verticalHeader().hide()
        self.setAlternatingRowColors(True)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
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

    def text(self) -> str:
        """Selected cells, or the whole table with its heads, with tabs and line ends."""
        chosen = self.selectedIndexes()
        rows = sorted({index.row() for index in chosen}) or range(self.rowCount())
        columns = sorted({index.column() for index in chosen}) or range(self.columnCount())
        lines = []
        if Table.stale and not self.live:
            lines.append(tr("The input has changed since these results."))
        if len(chosen) != 1:
            lines.append(
                "\t".join(self.horizontalHeaderItem(c).text().replace("\n", " ") for c in columns)
            )
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
