"""The window What if: sizes, loads, ties and a_g of a wall by sliders, zeta of every check redrawn as they move."""

from dataclasses import replace

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QDialog, QGridLayout, QHBoxLayout, QLabel, QPushButton, QSlider, QVBoxLayout, QWidget

from app.look.language import current_language, described, number, tr
from app.views.ladder import Ladder, Rung
from app.work.worker import Job
from core.case.schema import Case
from core.errors import InputError
from core.report.sure_words import REACH
from core.study.plan import read_inputs
from core.study.swings import Reach
from core.study.turned_round import keys_of, moved_keys, reach_of, with_values
from core.study.what_if import NONE, Setting, Zetas, lowest, setting_of, zetas
from core.text.sentence import Number, sentence

STEPS, RANGE = 200, 2.0
"""Places of a slider, and the factor of the value at hand at its upper end; its inverse is at the lower."""

SETTLED_MS = 120
"""Pause after which the histories follow the hand."""

EVERY = 8
"""Every how many points of the grid zeta of histories is searched meanwhile: by 2 %."""

OWN_Q = "linear_q_slv"
"""The check that asks for a search of q, which is not made here."""

SHOWN = {**REACH, "height_m": (1.0, ".2f"), "load_factor": (100.0, ".0f")}
"""Key -> what its value is multiplied with for the unit of its words, and its format."""


def captions() -> dict[str, str]:
    """What the sliders are called."""
    return {
        "thickness_m": tr("Thickness [cm]"),
        "height_m": tr("Height [m]"),
        "tie_kn_m": tr("Ties together [kN/m]"),
        "load_factor": tr("Loads [%]"),
        "ag_g": "a_g [g]",
    }


class WhatIfWindow(QDialog):
    """The wall of the form; nothing of the case changes until it is taken."""

    def __init__(self, window):
        super().__init__(window)
        self.setWindowTitle(tr("What if"))
        self.resize(760, 560)
        self.owner, self.row = window, 0
        self.case: Case | None = None
        self.setting: Setting | None = None
        self.jobs: dict[str, Job] = {}
        self.known: dict[str, float | None] = {}
        self.sliders: dict[str, QSlider] = {}
        self.values_shown: dict[str, QLabel] = {}
        self.given: dict[str, float] = {}
        self.heading, self.word, self.ladder = QLabel(), QLabel(), Ladder()
        self.word.setWordWrap(True)
        self.timer = QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.setInterval(SETTLED_MS)
        self.timer.timeout.connect(self.follow)
        self.board, self.grid = QWidget(), QGridLayout()
        self.board.setLayout(self.grid)
        self.take, self.back = QPushButton(tr("Take it")), QPushButton(tr("Back to the case"))
        self.find = QPushButton(tr("Find for the ζ required"))
        self.find.setToolTip(
            tr("The value of each slider, the others as they are, at which ζ of a check is as required")
        )
        buttons = QHBoxLayout()
        for button, slot in ((self.find, self.search), (self.back, self.reset), (self.take, self.take_it)):
            button.setAutoDefault(False)
            button.clicked.connect(slot)
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        told = QLabel(tr("ζ of the checks as the sliders move; the verdict is that of a run (F5)."))
        told.setWordWrap(True)
        for part in (self.heading, self.board, self.ladder, told, self.word):
            layout.addWidget(part)
        layout.addStretch(1)
        layout.addLayout(buttons)
        self.show_case()

    # the wall

    def show_case(self) -> None:
        """Take the wall of the form as it is now."""
        self.stop()
        self.case, self.row = self.owner.session.checked(), self.owner.walls.current
        self.setting, self.known = None, {}
        problem = self.owner.session.problem()
        if self.case is not None and self.case.demand is not None:
            try:
                base = self.owner.session.base_dir
                self.setting = setting_of(self.case, self.row, base, read_inputs(self.case, base))
            except InputError as error:
                problem = error
        for part in (self.board, self.ladder, self.take, self.back, self.find):
            part.setEnabled(self.setting is not None)
        self._fill()
        if self.setting is None:
            self.heading.setText(tr("No demand: no check.") if problem is None else described(problem))
            return
        self.heading.setText(f"<b>{self.case.wall[self.row].title}</b>")
        self.follow()

    def _fill(self) -> None:
        """A slider for each value that can be moved."""
        while self.grid.count():
            self.grid.takeAt(0).widget().deleteLater()
        self.sliders.clear()
        self.values_shown.clear()
        self.given = moved_keys(self.setting) if self.setting else {}
        if self.case and self.case.site:  # which gives a_g
            self.given.pop("ag_g", None)
        names = captions()
        for row, key in enumerate(self.given):
            slider, value = QSlider(Qt.Orientation.Horizontal), QLabel()
            slider.setRange(-STEPS, STEPS)
            slider.setTickPosition(QSlider.TickPosition.TicksBelow)
            slider.setTickInterval(STEPS)  # the middle is the value at hand
            slider.setAccessibleName(names[key])
            slider.valueChanged.connect(self._moved)
            value.setMinimumWidth(value.fontMetrics().horizontalAdvance("0000.000 (0000.000)"))
            self.sliders[key], self.values_shown[key] = slider, value
            for column, part in enumerate((QLabel(names[key]), slider, value)):
                self.grid.addWidget(part, row, column)
        self._say_values()

    @property
    def values(self) -> dict[str, float]:
        """By key, of the sliders that are moved."""
        return {
            key: self.given[key] * RANGE ** (slider.value() / STEPS)
            for key, slider in self.sliders.items()
            if slider.value()
        }

    def _say_values(self) -> None:
        values = self.values
        for key, label in self.values_shown.items():
            factor, form = SHOWN[key]
            given = number(factor * self.given[key], form)
            label.setText(given if key not in values else f"{number(factor * values[key], form)} ({given})")

    # zeta

    def _moved(self) -> None:
        """The checks of the clauses at once, the histories when the hand rests."""
        self._say_values()
        if self.setting is None:
            return
        moved = self._setting()
        if moved is None:
            return
        try:
            found = zetas(moved, every=0)
        except InputError as error:
            self.word.setText(described(error))
            found = NONE
        self._show(found, waiting=True)
        self.timer.start()

    def _setting(self) -> Setting | None:
        """With the values of the sliders; None, and why, where the wall does not stand with them."""
        try:
            moved = with_values(self.setting, self.values)
        except InputError as error:
            self.stop()
            self.word.setText(described(error))
            self._show(NONE)
            return None
        self.word.setText("")
        return moved

    def follow(self) -> None:
        """The histories of the values now, off the thread of the window; an earlier one is left."""
        moved = self._setting() if self.setting else None
        if moved is None:
            return
        self.stop("zeta")
        first = not self.values

        def arrived(found: Zetas) -> None:
            if first:
                self.known = dict(found.by_check) | self._of_the_run()
            self._show(found)

        self._start("zeta", lambda job: zetas(moved, every=EVERY, cancelled=job.cancelled), arrived)

    def _of_the_run(self) -> dict[str, float | None]:
        """zeta of each check by the run, where its input is still the one shown."""
        result = self.owner.session.result
        if result is None or self.owner.session.stale:
            return {}
        walls = [wall for wall in result.walls if wall.part.origin == self.row and wall.assessment]
        found = [(check.label, check.zeta) for wall in walls for check in wall.assessment.checks]
        return {label: lowest([zeta for name, zeta in found if name == label]) for label, _ in found if label != OWN_Q}

    def search(self) -> None:
        """The answer turned round, of each slider alone."""
        moved = self._setting() if self.setting else None
        if moved is None:
            return
        self.stop("search")
        self.word.setText(tr("Searching…"))

        def work(job: Job) -> list[Reach]:
            return [reach_of(moved, key, now, job.cancelled) for key, now in keys_of(moved).items()]

        self._start("search", work, self._found)

    def _found(self, reached: list[Reach]) -> None:
        lines, names = [], captions()
        for one in reached:
            factor, form = SHOWN[one.key]
            ends = []
            for label, value in one.by_check.items():
                said = number(None if value is None else factor * value, form)
                ends.append(f"{tr('any') if label in one.throughout else said} ({self._check(label)})")
            lines.append(f"{names[one.key]}: {'; '.join(ends)}")
        target = number(self.setting.demand.zeta_target, ".2f")
        self.word.setText("\n".join([tr("For ζ {zeta}:", zeta=target), *lines]))

    def _start(self, name: str, work, arrived) -> None:
        job = self.jobs[name] = Job(work)
        job.done.connect(lambda found: arrived(found) if self.jobs.get(name) is job else None)
        job.failed.connect(lambda words, _: self.word.setText(words) if self.jobs.get(name) is job else None)
        job.start()

    def stop(self, *names: str) -> None:
        """Leave what is not finished."""
        self.timer.stop()
        for name in names or tuple(self.jobs):
            if job := self.jobs.pop(name, None):
                job.cancel()

    def _check(self, label: str) -> str:
        q = Number(self.case.demand.q_code, "g")
        return sentence("short", label, q=q).text(current_language())

    def _show(self, found: Zetas, waiting: bool = False) -> None:
        """The ladder; zeta as it is beside each. waiting : the histories are still to come"""
        target, rungs = self.setting.demand.zeta_target, []
        labels = list(self.known) or list(found.by_check)
        for k, label in enumerate(labels):
            zeta, given = found.by_check.get(label), self.known.get(label)
            tone = "amber" if zeta is None else "good" if zeta >= target else "bad"
            said = "…" if waiting and label == "dynamic" else ""
            values = tr("as it is {zeta}", zeta=number(given, ".2f")) if given is not None and self.values else said
            rungs.append(Rung(self._check(label), said, zeta, values, tone, k == 0))
        self.ladder.show_rungs(rungs, target)

    # what becomes of it

    def reset(self) -> None:
        """Every slider back to the value of the case."""
        for slider in self.sliders.values():
            slider.blockSignals(True)
            slider.setValue(0)
            slider.blockSignals(False)
        self._say_values()
        self.follow()

    def take_it(self) -> None:
        """The values into the case, a step of undo."""
        values = self.values
        moved = self._setting() if values else None
        now = self.owner.session.checked()
        if moved is None:
            return
        if now != self.case:
            self.word.setText(tr("The case has changed: choose again."))
            self.show_case()
            return
        wall, new = self.case.wall[self.row], moved.case.wall[0]
        sizes = ("thickness_m", "slenderness_deg", "height_over_thickness", "height_m", "load")
        walls = list(self.case.wall)
        walls[self.row] = replace(wall, **{key: getattr(new, key) for key in sizes})
        case = replace(self.case, wall=tuple(walls))
        if "ag_g" in values and case.demand is not None:
            case = replace(case, demand=replace(case.demand, ag_g=values["ag_g"]))
        self.owner.session.edit(case)
        self.show_case()

    def reject(self) -> None:
        self.stop()
        super().reject()
