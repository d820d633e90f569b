"""Below the drawing of the input: the checks of the wall at every key, its verdict and what raises it when the hand
rests."""

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QCheckBox, QGridLayout, QWidget

from app.look import theme
from app.look.labels import PlainLabel, RichLabel, escape_html
from app.look.language import current_language, describe_message, number, tr, wall_title
from app.look.section import FoldingSection
from app.views.answer_lines import required_actions, verdict_color, verdict_limitations
from app.views.ladder import Ladder, Rung
from app.views.zeta_rungs import rung_of, rungs_of
from app.work.worker import Job
from core.capacity.limit_states import LIMIT_FRACTION
from core.case.schema import Case
from core.codes.assumption import ALL_TOGETHER_KEY, Assumption, format_value
from core.codes.verdict import Verdict
from core.errors import InputError
from core.known import require_value
from core.study.results import StudyResult
from core.text.sentence import word
from core.variation.evaluate import Evaluation

if TYPE_CHECKING:
    from app.shell.window import MainWindow

LIVE_FORMS = ("wall", "demand", "building")
"""Forms whose input moves zeta of the wall."""

AT_ONCE_MS, RESTED_MS = 0, 400
"""Pauses after a key: before the checks of the clauses, for which no letter waits, and before the wall runs."""

MAX_ROWS_SHOWN, MAX_LINES_SHOWN = 5, 2
"""Rows of assumptions, and lines of what limits the verdict; all are on the page Answer."""


WAITING = "…"
"""Stands for what is on its way."""

MAX_WALLS_AT_REST = 500
"""Walls of a case up to which the one of the form is run beside them."""


def _files_of(case: Case | None, base_dir: Path) -> tuple:
    """State of the files that the demand is read from, which another program may change."""
    demand = case.demand if case else None
    names = [name for name in (demand.spectrum_file, demand.hazard_file) if name] if demand else []
    states = []
    for name in names:
        with contextlib.suppress(OSError):
            status = (base_dir / name).stat()
            states.append((status.st_mtime_ns, status.st_size))
    return tuple(states)


class Swing(QWidget):
    """zeta of a wall and at the other end of one input, on the axis of zeta that all rows share."""

    def __init__(self, here: float, there: float, target: float, end: float):
        super().__init__()
        self.here, self.there, self.target, self.end = here, there, target, end
        self.setMinimumWidth(60)

    def sizeHint(self) -> QSize:
        return QSize(140, self.fontMetrics().height())

    def paintEvent(self, event) -> None:
        painter = QPainter(self)
        per_zeta, middle = (self.width() - 2.0) / self.end, 0.5 * self.height()
        low, high = sorted((self.here, self.there))
        shade = QColor(theme.current.bad if low < self.target <= high else theme.current.amber)
        painter.fillRect(QRectF(low * per_zeta, middle - 5.0, max((high - low) * per_zeta, 1.0), 10.0), shade)
        painter.setPen(QPen(QColor(theme.current.ink), 1.5))
        place = self.target * per_zeta
        painter.drawLine(QPointF(place, 0.0), QPointF(place, float(self.height())))


class Switch(QCheckBox):
    """A box whose text is cut where it has no room, whole in its tip."""

    def __init__(self, text: str):
        super().__init__()
        self.words = text
        self.setAccessibleName(text)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, round(1.4 * self.fontMetrics().height()))

    sizeHint = minimumSizeHint

    def resizeEvent(self, event) -> None:
        super().resizeEvent(event)
        room = self.width() - 2 * self.fontMetrics().height()
        self.setText(self.fontMetrics().elidedText(self.words, Qt.TextElideMode.ElideRight, room))


class LiveAnswer(FoldingSection):
    """Runs the wall of the form alone, off the thread of the window; nothing of the case or its result changes.

    Folded, it computes nothing; whether it is stays in the settings.
    """

    def __init__(self, window: "MainWindow"):
        ladder, heading, board, lines = Ladder(), PlainLabel(), QWidget(), RichLabel()
        kept = bool(window.settings.value("live", True, bool))
        super().__init__(tr("Answer as you type"), (ladder, heading, board, lines), kept)
        self.ladder, self.heading, self.board, self.lines = ladder, heading, board, lines
        self.grid = QGridLayout(board)
        self.grid.setContentsMargins(0, 0, 0, 0)
        self.grid.setVerticalSpacing(2)
        self.grid.setColumnStretch(0, 3)
        self.grid.setColumnStretch(1, 1)
        lines.setWordWrap(True)
        heading.setStyleSheet(f"color: {theme.current.quiet};")
        self.window_of = window
        self.at: tuple | None = None
        self.row = -1
        self.job: Job | None = None
        self.result: StudyResult | None = None
        self.switches: dict[str, Switch] = {}
        self.at_once, self.rested = QTimer(self, singleShot=True), QTimer(self, singleShot=True)
        for timer, pause, slot in ((self.at_once, AT_ONCE_MS, self._clauses), (self.rested, RESTED_MS, self._run_wall)):
            timer.setInterval(pause)
            timer.timeout.connect(slot)
        self.lines.linkActivated.connect(lambda target: window.navigator.ask(target))
        self.turned.connect(self._folded)

    def _folded(self, on: bool) -> None:
        self.window_of.settings.setValue("live", on)
        self.follow()

    def follow(self) -> None:
        """Take up the wall of the form where it, the demand or the building is another one; rest while it is folded,
        out of sight, or the case runs."""
        window, session = self.window_of, self.window_of.session
        given = window.stages.input
        case = session.checked() if given.missing.can_run() else None
        self.setVisible(given.kind in LIVE_FORMS and bool(session.case.wall) and session.case.demand is not None)
        runs = self.head.isChecked() and self.isVisible() and window.runner.job is None
        row = window.walls.current
        at = (case, session.base_dir, row, (session.samples, _files_of(case, session.base_dir))) if runs else None
        if at == self.at:
            return
        self.at = at
        if row != self.row:
            self.row = row
            self.body.setMinimumHeight(0)
        self._leave()
        self._show_rows([], None)
        self.lines.setText("")
        self.ladder.hide()
        if at is None:  # nothing of another input stays in sight
            self.say()
            return
        if case is None or case.demand is None:
            self.ladder.hide()
            self.say(tr("ζ follows once nothing is missing"))
            return
        self.say(WAITING)
        self.at_once.start()

    def showEvent(self, event) -> None:
        super().showEvent(event)
        self.follow()

    def hideEvent(self, event) -> None:
        super().hideEvent(event)
        self.follow()

    def _keep_height(self) -> None:
        """What stands above is not to jump at each key: of one wall it grows only."""
        layout = require_value(self.body.layout())
        layout.activate()
        self.body.setMinimumHeight(max(self.body.minimumHeight(), layout.totalMinimumSize().height()))

    def end(self) -> None:
        """Leave what is not finished, before the window goes or is built again."""
        self.at = None
        self._leave()

    def _leave(self) -> None:
        self.at_once.stop()
        self.rested.stop()
        job, self.job, self.result = self.job, None, None
        if job is not None:
            job.cancel()

    def _clauses(self) -> None:
        """The checks of the clauses, of which the letter at hand needs to wait for none."""
        from core.setting.demand_input import read_demand
        from core.study.one_wall import single_wall_case
        from core.variation.wall_evaluation import WallContext, evaluate_wall

        whole, base, row, _ = require_value(self.at)
        case = single_wall_case(whole, row)
        try:
            demand = require_value(read_demand(case, base))
            setting = WallContext(case, base, (demand, [], []))
            evaluated = evaluate_wall(setting, None)
        except InputError as error:
            self.ladder.hide()
            self.say(describe_message(error))
            return
        asked = case.record or case.generate or case.select or case.default_histories
        awaited = bool(asked) and demand.limit_state in LIMIT_FRACTION
        self._show_checks(rungs_of(evaluated, demand.q_code, None, {}, False, awaited), demand.zeta_target)
        if case.select is not None or len(whole.wall) > MAX_WALLS_AT_REST:
            self.say(tr("histories with a run (F5)"))
            return
        self.rested.start()

    def _show_checks(self, rungs: list[Rung], target: float) -> None:
        self.ladder.show_rungs(rungs, target)
        self.ladder.setVisible(bool(rungs))

    def _run_wall(self) -> None:
        """The verdict of the wall, as a run of the case finds it."""
        from core.study.one_wall import run_wall

        (case, base, row, _), memory = require_value(self.at), self.window_of.runner.finished_runs
        jobs = max(1, (os.cpu_count() or 1) - 1)  # one is the window's
        self._start(lambda job: run_wall(case, row, base, memory, jobs, job.cancelled), self._arrived)

    def _start(self, work, arrived) -> None:
        job = self.job = Job(work)
        job.done.connect(lambda answer: arrived(answer) if self.job is job else None)
        job.failed.connect(lambda words, log: self.say(f"{words} {log}".strip()) if self.job is job else None)
        job.start()

    def _arrived(self, result: StudyResult) -> None:
        self.result, language = result, current_language()
        wall = result.walls[result.verdicts[0].governing]
        verdict = require_value(wall.assessment).verdict
        self._show_run()
        told = [
            row for row in verdict.assumptions if row.key != ALL_TOGETHER_KEY and row.check in ("", verdict.governing)
        ]
        self._show_rows(told, verdict)
        warnings = [warning.text(language) for warning in wall.warnings if warning.code != "variant_alone"]
        said = [*required_actions(result, wall, language), *verdict_limitations(result, wall, language, warnings)]
        if require_value(self.at)[0].sensitivity is not None:
            said.insert(0, tr("[sensitivity] is not in this answer: F5."))
        more = [tr("{n} more", n=len(said) - MAX_LINES_SHOWN)] if len(said) > MAX_LINES_SHOWN else []
        self.lines.setText("<br>".join([*said[:MAX_LINES_SHOWN], *more]))
        self._keep_height()

    def _show_run(self) -> None:
        """The checks as the wall is."""
        result = require_value(self.result)
        wall = result.walls[result.verdicts[0].governing]
        assessment = require_value(wall.assessment)
        verdict, language = assessment.verdict, current_language()
        rungs = [rung_of(check, check.name == verdict.governing, assessment.dynamic) for check in assessment.checks]
        self._show_checks(rungs, verdict.zeta_target)
        self._say(
            f"{wall_title(wall.name)}: {word(verdict.code, language)}", verdict.zeta_e, verdict_color(result, wall)
        )

    def _say(self, outcome: str, zeta: float | None, shade: str) -> None:
        """An outcome in the head, in its colour."""
        self.say(f"{outcome}   ζ {number(zeta, '.2f')}")
        self.head.content.setStyleSheet(f"color: {shade}; font-weight: 600;")

    def say(self, words: str = "") -> None:
        self.head.content.setStyleSheet(f"color: {theme.current.quiet};")
        super().say(words)

    # the assumptions as switches

    def _show_rows(self, rows: Sequence[Assumption], verdict: Verdict | None) -> None:
        """What raises zeta, each with zeta at its other end, the lowest first, and a switch to it."""
        while self.grid.count():
            old = require_value(require_value(self.grid.takeAt(0)).widget())
            old.hide()
            old.deleteLater()
        self.switches = {}
        known_zetas = [row for row in rows if row.zeta is not None]
        self.board.setVisible(bool(known_zetas))
        self.heading.setVisible(bool(known_zetas))
        if verdict is None or not known_zetas:
            return
        here, target, language = verdict.zeta_e or 0.0, verdict.zeta_target, current_language()
        end = 1.1 * max(here, target, *(row.zeta or 0.0 for row in known_zetas))
        self.heading.setText(tr("What raises ζ; ticked, it is at its other end:"))
        for k, row in enumerate(sorted(known_zetas, key=lambda row: row.zeta or 0.0)[:MAX_ROWS_SHOWN]):
            taken, other = format_value(row, row.value, language), format_value(row, row.other_end, language)
            text = f"{word(f'key_{row.key}', language)}: {taken} → {other}"
            name = Switch(text)
            name.setEnabled(row.has_switch)
            name.toggled.connect(lambda _: self._turned(rows))
            name.setToolTip(escape_html(f"{text}\n{row.words.text(language)}"))
            self.switches[row.key] = name
            zeta = PlainLabel(number(row.zeta, ".2f"))
            zeta.setStyleSheet(f"color: {theme.current.bad if row.turns else theme.current.ink};")
            for column, part in enumerate((name, Swing(here, row.zeta or 0.0, target, end), zeta)):
                self.grid.addWidget(part, k, column)

    def _turned(self, rows: Sequence[Assumption]) -> None:
        """zeta with what is ticked at its other end."""
        from core.study.one_wall import run_at_alternatives

        ticked = {key for key, box in self.switches.items() if box.isChecked()}
        chosen = [row for row in rows if row.key in ticked]
        result, memory = require_value(self.result), self.window_of.runner.finished_runs
        if self.job is not None:
            self.job.cancel()
        if not chosen:
            self.job = None
            self._show_run()
            return
        self.say(WAITING)
        self._start(lambda job: run_at_alternatives(result, chosen, memory, job.cancelled), self._show_turned)

    def _show_turned(self, evaluation: Evaluation | None) -> None:
        if evaluation is None:
            self._say(tr("so it does not stand"), None, theme.current.bad)
            return
        decides = evaluation.decides
        self.ladder.show_rungs(
            [rung_of(check, check is decides, evaluation.dynamic) for check in evaluation.checks],
            evaluation.scene.demand.zeta_target,
        )
        shade = theme.current.ink if evaluation.satisfied else theme.current.bad
        self._say(tr("so: {outcome}", outcome=word(evaluation.outcome, current_language())), evaluation.zeta, shade)
