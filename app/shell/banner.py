"""The line above the tabs: what keeps the case from running, and by a click the place where it is mended."""

import html

from PySide6.QtWidgets import QDockWidget, QLabel

from app.input.fields import Field
from app.look import theme
from app.look.language import described, tr
from core.errors import InputError

MOST_LETTERS = 160


class Banner(QLabel):
    """Says the first problem of the input of a window, in this order: a broken rule of the case, a field that holds
    what is not accepted, a record in use that cannot be read, what the last run of this case refused."""

    def __init__(self, window):
        super().__init__()
        self.window_of = window
        self.setWordWrap(True)
        self.setStyleSheet(f"color: {theme.current.amber}; font-weight: 600;")
        self.linkActivated.connect(lambda _: self.lead())

    def show_problem(self) -> bool:
        """Mark the fields and say what is wrong. Returns whether the case can run."""
        window = self.window_of
        broken = window.session.problem()
        error = broken or self._refused()
        wall = window.walls.wall.name if window.walls.wall else ""
        for field in window.fields:
            here = error is not None and field.named_in(error, wall)
            field.show_rule(described(error) if here else "")
        words = described(broken) if broken else ""
        wrong = next((field for field in window.fields if field.wrong), None)
        if not words and wrong is not None:
            words = f"{wrong.caption.text()}: {wrong.error}"
        runs = not words
        row = window.records.unreadable_row()
        if not words and row is not None:
            words = window.records.rows[row][1]
        if not words and error:
            words = described(error)
        ask = not words and window.session.stale and window.job is None
        shown = words if len(words) < MOST_LETTERS else words[: MOST_LETTERS - 3] + "…"
        shown = html.escape(shown, quote=False)
        if words and self._leads(error, row):
            colour = theme.current.amber
            shown += f" <a href='field' style='color:{colour}'>{tr('Show where')}</a>"
        self.setText(shown if words else tr("The input has changed: press F5.") if ask else "")
        self.setToolTip(words)
        return runs

    def _refused(self) -> InputError | None:
        """What the last run refused, while the case is the same."""
        case, error = self.window_of.refused
        return error if case is self.window_of.session.case else None

    def _field(self) -> Field | None:
        """The field that holds what is not accepted, or that a rule names."""
        marked = [field for field in self.window_of.fields if field.error or field.rule]
        return marked[0] if marked else None

    def _wall_in_question(self, error: InputError | None) -> int | None:
        """Row of the wall that an error is about."""
        walls = self.window_of.session.case.wall
        rows = [k for k, wall in enumerate(walls) if error and wall.name == error.wall]
        return rows[0] if rows else None

    def _leads(self, error: InputError | None, row: int | None) -> bool:
        return self._field() is not None or row is not None or self._wall_in_question(error) is not None

    def lead(self) -> None:
        """Show the dock, the tab and the field or the record in question, and put the cursor there."""
        window = self.window_of
        error = window.session.problem() or self._refused()
        field, wall = self._field(), self._wall_in_question(error)
        if field is None and wall is not None:
            window.walls.list.setCurrentRow(wall)
            window.refresh()
            field = self._field()
        row = window.records.unreadable_row()
        if field is None and wall is None and row is not None:
            self._raise("records")
            window.records.point_at(row)
            return
        self._raise("input")
        target = field or window.walls
        for k in range(window.forms.count()):
            area = window.forms.widget(k)
            if area.isAncestorOf(target):
                window.forms.setCurrentIndex(k)
                if field:
                    area.ensureWidgetVisible(field)
        (field.editor if field else window.walls.list).setFocus()

    def _raise(self, name: str) -> None:
        dock = self.window_of.findChild(QDockWidget, name)
        dock.show()
        dock.raise_()
