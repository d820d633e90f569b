"""All that keeps the case from running, each line a link to where it is mended."""

import html
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QVBoxLayout

from app.input.entries_form import entry_named
from app.input.fields import Field
from app.look import theme
from app.look.labels import PlainLabel, RichLabel
from app.look.language import describe_message, tr, wall_title
from app.look.section import unfold_to
from app.shell.pointing import first_empty, point_at
from core.case.hold import Bars
from core.case.loads import Load
from core.case.problems import load_of, wall_of
from core.errors import InputError

if TYPE_CHECKING:
    from app.shell.window import MainWindow

MAX_PROBLEMS = 8
"""Lines that are shown."""

MAX_LETTERS = 700
"""Letters of a line: a longer sentence is whole in the tip of the notice."""


class Problem(NamedTuple):
    """words : the sentence; lead : shows where; stops : whether the case cannot run"""

    words: str
    lead: Callable[[], None]
    stops: bool = True


class ProblemsPanel(QFrame):
    """Says the problems of the input of a window, in this order: broken rules of the case, fields that hold what is not
    accepted, a record in use or a logo that cannot be read, what the last run of this case refused."""

    def __init__(self, window: "MainWindow"):
        super().__init__()
        self.window_of = window
        self.problems: list[Problem] = []
        self.heading, self.lines = PlainLabel(), RichLabel()
        self.heading.setStyleSheet(f"color: {theme.current.amber}; font-weight: 600;")
        self.lines.setWordWrap(True)
        self.lines.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self.lines.setAccessibleName(tr("What is missing"))
        self.lines.linkActivated.connect(self.lead)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 6, 10, 6)
        layout.addWidget(self.heading)
        layout.addWidget(self.lines)
        self.setStyleSheet(f"Missing {{ border: 1px solid {theme.current.amber}; border-radius: 4px; }}")

    def text(self) -> str:
        """The first problem in words."""
        return self.problems[0].words if self.problems else ""

    def can_run(self) -> bool:
        """Whether no rule of the case is broken and no field holds a text that is not in the case."""
        window = self.window_of
        return not window.session.problems() and not any(field.wrong for field in window.stages.fields)

    def show_problems(self) -> None:
        """Mark the fields and list what is wrong."""
        window = self.window_of
        errors, refused = window.session.problems(), self._refused()
        logo = self._logo()
        told = [(one, self._place_of(one)) for one in (*errors, refused, logo) if one]
        fields = window.stages.fields
        for field in fields if told else (one for one in fields if one.rule):
            here = next((error for error, place in told if self._is_named(field, error, place)), None)
            field.show_rule(describe_message(here) if here else "")
        problems = [Problem(describe_message(error), partial(self._lead_to, error)) for error in errors]
        for field in fields:
            if field.wrong:
                words = f"{field.caption.text()}: {field.error}"
                problems.append(Problem(words, partial(point_at, window.navigator, field)))
        row = window.records.unreadable_row()
        if row is not None:
            words = str(window.records.rows[row][1])
            problems.append(Problem(words, lambda: self._record(row), False))
        if logo:
            problems.append(Problem(describe_message(logo), lambda: self._lead_to(logo), False))
        if refused and not problems:
            problems.append(Problem(describe_message(refused), lambda: self._lead_to(refused), False))
        if above := self._without_building():
            words = tr(
                "{walls}: the motion above the ground follows from the building; no verdict without it", walls=above
            )
            problems.append(Problem(words, lambda: window.navigator.ask("building"), False))
        self.problems = problems
        self._write()

    def _write(self) -> None:
        colour = theme.current.curves[0]
        lines = []
        for k, problem in enumerate(self.problems[:MAX_PROBLEMS]):
            words = problem.words
            words = words if len(words) < MAX_LETTERS else words[: MAX_LETTERS - 1] + "…"
            words = html.escape(words, quote=False)
            lines.append(f"<a href='{k}' style='color:{colour}; text-decoration:none'>→ {words}</a>")
        if len(self.problems) > MAX_PROBLEMS:
            lines.append(tr("{n} more", n=len(self.problems) - MAX_PROBLEMS))
        count = len(self.problems)
        one, many = tr("Before F5: one thing to give or mend"), tr("Before F5: {n} things to give or mend", n=count)
        self.heading.setText(one if count == 1 else many)
        self.lines.setText("<br>".join(lines))
        self.setVisible(bool(self.problems))
        for part in (self.lines, self):
            part.updateGeometry()

    def _logo(self) -> InputError | None:
        """Why the note could not show its logo."""
        session = self.window_of.session
        if not session.case.report.logo:
            return None
        from core.report.note.archive import office_of  # a second of imports on a slow processor

        try:
            office_of(session.case.report, session.base_dir)
        except InputError as error:
            return error
        return None

    def _refused(self) -> InputError | None:
        """What the last run refused, while the case is the same."""
        case, error = self.window_of.runner.last_refusal
        return error if case is self.window_of.session.case else None

    def _without_building(self) -> str:
        """Walls that no check can be made of, for the building that carries them is not given."""
        case = self.window_of.session.case
        if case.demand is None or case.building is not None:
            return ""
        heights = (wall.base_z_m for wall in case.wall)  # "" while it is to be given
        raised = (isinstance(z, (int, float)) and z > 0.0 for z in heights)
        return ", ".join(
            wall_title(wall.title) for wall, up in zip(case.wall, raised, strict=True) if up or wall.bends or wall.arch
        )

    def lead(self, link: str = "0") -> None:
        """Show where a problem is, and put the cursor there."""
        if self.problems:
            self.problems[min(int(link), len(self.problems) - 1)].lead()

    def lead_in(self, kind: str) -> None:
        """The cursor into the first field of a form in which something is missing."""
        area = self.window_of.stages.input.areas[kind]
        wrong = (field for field in self.window_of.stages.fields if field.rule and area.isAncestorOf(field))
        if field := next(wrong, None):
            point_at(self.window_of.navigator, field)

    def _place_of(self, error: InputError) -> tuple[str, int | None]:
        """(title of the wall whose form shows an error, index of the load it is about)."""
        walls = self.window_of.walls
        title = walls.wall.title if walls.wall else ""
        if wall_of(self.window_of.session.case, error) == walls.current:
            title = error.wall or title  # of its part above a hinge, say
        return title, load_of(error)

    def _is_named(self, field: Field, error: InputError, place: tuple[str, int | None]) -> bool:
        """Whether an error, of this `_place_of`, is about this field as the forms stand: of the wall and the load they
        show."""
        title, load = place
        if error.code == "one_geometry" and self._is_given(field):
            return False
        if field.section is Load and load not in (None, self.window_of.walls.loads.list.currentRow()):
            return False
        if field.section is Bars and entry_named(error, "hold") != self.window_of.walls.holds.list.currentRow() + 1:
            return False
        return field.named_in(error, title)

    def _is_given(self, field: Field) -> bool:
        """Whether a field of a wall that lacks a size is none of those that are missing where its form shows them."""
        wall = self.window_of.walls.wall
        shapes = (wall.thickness_m, wall.slenderness_deg, wall.height_over_thickness) if wall else ()
        lacks = wall is not None and (wall.height_m is None or shapes.count(None) == len(shapes))
        return lacks and (field.isHidden() or field.value not in (None, ""))

    def _lead_to(self, error: InputError) -> None:
        window = self.window_of
        row, load = wall_of(window.session.case, error), load_of(error)
        if row is not None:
            window.navigator.show_input("wall", row)
            window.walls.body.point_at(error)
            window.walls.holds.point_at(error)
            window.walls.set_aside.point_at(error)
        if row is not None and load is not None:
            window.walls.loads.list.setCurrentRow(load)
        here = self._place_of(error)
        field = first_empty(
            [one for one in window.stages.fields if self._is_named(one, error, here) and not one.isHidden()]
        )
        if field is not None:
            point_at(window.navigator, field)
        elif row is not None and "mechanism" in error.keys:
            unfold_to(window.walls.mechanisms["two_sided"])
            window.walls.mechanisms["two_sided"].setFocus()
        elif row is None:
            section = (error.section or "").strip("[]").split(".")[0]
            place = {"demand": "demand", "building": "building", "report": "report", "analysis": "report"}
            place |= {"site": "demand"}
            window.navigator.show_input(
                {"record": "records", "generate": "records", "select": "records"}.get(section)
                or place.get(section, "wall")
            )

    def _record(self, row: int) -> None:
        self.window_of.navigator.show_input("records")
        self.window_of.records.point_at(row)
