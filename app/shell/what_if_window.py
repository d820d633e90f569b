"""The window What if: sizes, loads, ties and a_g of a wall by sliders, zeta of every check redrawn as they move."""

import html
from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QDialog, QGridLayout, QHBoxLayout, QLabel, QPushButton, QSlider, QVBoxLayout, QWidget

from app.look.labels import PlainLabel, RichLabel
from app.look.language import current_language, describe_message, number, tr
from app.views.ladder import Ladder
from app.views.zeta_rungs import check_words, rungs_of
from app.work.worker import Job
from core.answer.answer import zeta_by_check
from core.case.floor_loads import infer_floor_supports
from core.case.schema import Case
from core.codes.multiplier_search import Precision
from core.errors import InputError
from core.known import require_value
from core.report.uncertainty_text import reach_written
from core.setting.plan import Inputs, read_inputs
from core.variation.evaluate import COARSE_PRECISION, FULL_PRECISION
from core.variation.inverse_design import design_keys, find_target_value, set_values, slider_keys
from core.variation.swings import TargetValue
from core.variation.wall_evaluation import (
    NO_EVALUATION,
    WallContext,
    WallEvaluation,
    evaluate_wall,
    make_wall_context,
    replace_wall,
)

if TYPE_CHECKING:
    from app.shell.window import MainWindow

STEPS, SLIDER_FACTOR = 200, 2.0
"""Places of a slider, and the factor of the value at hand at its upper end; its inverse is at the lower."""

SETTLED_MS = 120
"""Pause after which the histories follow the hand."""

OWN_Q = "linear_q_slv"
"""The check that asks for a search of q, which is not made here."""

VALUE_FORMATS = {
    "thickness_m": (100.0, ".1f", 3),
    "height_m": (1.0, ".2f", 2),
    "tie_kn_m": (1.0, ".2f", 2),
    "load_factor": (100.0, ".0f", 2),
    "ag_g": (1.0, ".3f", 3),
}
"""Key -> what its value is multiplied with for the unit of its words, its format, and the decimals it is taken with."""

FORCE, PLACE = 2, 3
"""Decimals of a load [kN/m] and of its place in the wall [m] that follow a slider."""

TRIED = (0.98, 1.02)
"""Factors of a value: where the wall is refused at both, as under a load that is at its top, it has no slider."""


def captions() -> dict[str, str]:
    """What the sliders are called."""
    return {
        "thickness_m": tr("Thickness [cm]"),
        "height_m": tr("Height [m]"),
        "tie_kn_m": tr("Ties together [kN/m]"),
        "load_factor": tr("Loads [%]"),
        "ag_g": "a_g [g]",
    }


def why_ag_stays(case: Case) -> str:
    """Why a_g has no slider: with another one the case would contradict itself, or its records would not follow as
    they do here. Empty where it has one."""
    demand = require_value(case.demand)
    if case.site or demand.hazard or demand.hazard_file:
        return tr("a_g is not moved: it is that of the hazard of the site.")
    if demand.spectrum_file:
        return tr("a_g is not moved: it belongs to the spectrum of the file.")
    if case.select:
        return tr("a_g is not moved: the records are chosen for it.")
    if case.record and demand.demand_scaling == "as_given":
        return tr("a_g is not moved: the records are taken as given and do not follow it.")
    return ""


class WhatIfWindow(QDialog):
    """The wall of the form; nothing of the case changes until it is taken."""

    def __init__(self, window: "MainWindow"):
        super().__init__(window)
        self.setObjectName("what_if")
        self.setWindowTitle(tr("What if"))
        self.resize(760, 560)
        self.owner, self.row, self.base_dir = window, 0, window.session.base_dir
        self.case: Case | None = None
        self.setting: WallContext | None = None
        self.jobs: dict[str, Job] = {}
        self.zetas: dict[str, float | None] = {}
        self.sliders: dict[str, QSlider] = {}
        self.values_shown: dict[str, QLabel] = {}
        self.given: dict[str, float] = {}
        self.heading, self.still, self.word, self.ladder = RichLabel(), PlainLabel(), PlainLabel(), Ladder()
        self.timer, self.told = QTimer(self), QTimer(self)
        for timer, slot in ((self.timer, self.follow), (self.told, self._take_again)):
            timer.setSingleShot(True)
            timer.setInterval(SETTLED_MS)
            timer.timeout.connect(slot)
        self.board, self.grid = QWidget(), QGridLayout()
        self.board.setLayout(self.grid)
        self.take, self.back = QPushButton(tr("Take it")), QPushButton(tr("Back to the case"))
        self.find_button = QPushButton(tr("Find for the ζ required"))
        self.find_button.setToolTip(
            tr("The value of each slider, the others as they are, at which ζ of a check is as required")
        )
        buttons = QHBoxLayout()
        for button, slot in ((self.find_button, self.search), (self.back, self.reset), (self.take, self.take_it)):
            button.setAutoDefault(False)
            button.clicked.connect(slot)
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        told = PlainLabel(tr("ζ of the checks as the sliders move; the verdict is that of a run (F5)."))
        for label in (self.still, told, self.word):
            label.setWordWrap(True)
        for part in (self.heading, self.board, self.still, self.ladder, told, self.word):
            layout.addWidget(part)
        layout.addStretch(1)
        layout.addLayout(buttons)
        window.session.listeners.append(self.case_changed)
        window.walls.selected.connect(self.case_changed)
        self.show_case()

    # the wall

    def show_case(self, notice: str = "") -> None:
        """Take the wall of the form as it is now. notice : what is said beside it"""
        self.stop()
        self.told.stop()
        self.base_dir = self.owner.session.base_dir
        self.case, self.row = self.owner.session.checked(), self.owner.walls.current
        self.setting, self.zetas = None, {}
        self._show_setting()
        if self.case is None or self.case.demand is None:
            problem = self.owner.session.problem()
            self.heading.setText(tr("No demand: no check.") if problem is None else describe_message(problem))
            self.word.setText(notice)
            return
        self.heading.setText(f"<b>{html.escape(self.case.wall[self.row].title)}</b>")
        case, base, session = self.case, self.base_dir, self.owner.session

        def arrived(inputs: Inputs) -> None:
            self.setting = make_wall_context(case, self.row, base, inputs)
            self.zetas = self._of_the_run()
            self._show_setting()
            self._moved()
            self.word.setText(notice)
            self.follow()

        result = session.result
        if result is not None and result.demand is not None and not session.stale:
            arrived((result.demand, list(result.motions), list(result.kinds)))
            return
        self.word.setText("\n".join([*([notice] if notice else []), tr("Reading the records…")]))
        self._start("read", lambda _: read_inputs(case, base), arrived)

    def _show_setting(self) -> None:
        """The sliders, where there is something to move."""
        for part in (self.board, self.ladder, self.take, self.back, self.find_button):
            part.setEnabled(self.setting is not None)
        self._fill()
        if self.setting is None:
            self.ladder.show_rungs([], 1.0)

    def case_changed(self) -> None:
        """Take the wall shown again when changes of the session or of the form rest."""
        if self._is_as_shown():
            return
        self.stop()
        self.setting = None
        self._show_setting()
        self.told.start()

    def _is_as_shown(self) -> bool:
        session = self.owner.session
        if self.case is None:  # another rule may be broken now
            return False
        return (session.checked(), session.base_dir, self.owner.walls.current) == (self.case, self.base_dir, self.row)

    def _take_again(self) -> None:
        same = self.owner.session.checked() == self.case
        self.show_case("" if same else tr("The case has changed: choose again."))

    def _fill(self) -> None:
        """A slider for each value that can be moved."""
        while self.grid.count():
            old = require_value(require_value(self.grid.takeAt(0)).widget())
            old.hide()  # it goes only when the event at hand is over
            old.deleteLater()
        self.sliders.clear()
        self.values_shown.clear()
        self.given = self._moved_keys() if self.setting else {}
        self.still.setText(why_ag_stays(require_value(self.case)) if self.setting else "")
        self.still.setVisible(bool(self.still.text()))
        names = captions()
        for row, key in enumerate(self.given):
            slider, value = QSlider(Qt.Orientation.Horizontal), PlainLabel()
            slider.setRange(-STEPS, STEPS)
            slider.setTickPosition(QSlider.TickPosition.TicksBelow)
            slider.setTickInterval(STEPS)  # the middle is the value at hand
            slider.setAccessibleName(names[key])
            slider.valueChanged.connect(self._moved)
            value.setMinimumWidth(value.fontMetrics().horizontalAdvance("0000.000 (0000.000)"))
            self.sliders[key], self.values_shown[key] = slider, value
            for column, part in enumerate((PlainLabel(names[key]), slider, value)):
                self.grid.addWidget(part, row, column)
        self._say_values()

    def _moved_keys(self) -> dict[str, float]:
        """Key -> value of what has a slider."""
        setting = require_value(self.setting)

        def stands(key: str, value: float) -> bool:
            try:
                set_values(setting, {key: value})
            except InputError:
                return False
            return True

        movable = slider_keys(setting)
        if why_ag_stays(require_value(self.case)):
            movable.pop("ag_g", None)
        return {key: now for key, now in movable.items() if any(stands(key, share * now) for share in TRIED)}

    @property
    def values(self) -> dict[str, float]:
        """By key, of the sliders that are moved, as they are shown."""
        return {
            key: round(self.given[key] * SLIDER_FACTOR ** (slider.value() / STEPS), VALUE_FORMATS[key][2])
            for key, slider in self.sliders.items()
            if slider.value()
        }

    def _say_values(self) -> None:
        values = self.values
        for key, label in self.values_shown.items():
            factor, form, _ = VALUE_FORMATS[key]
            given = number(factor * self.given[key], form)
            label.setText(given if key not in values else f"{number(factor * values[key], form)} ({given})")

    # zeta

    def _moved(self) -> None:
        """The checks of the clauses at once, the histories when the hand rests."""
        self.stop()  # what is on its way is of another place of the slider
        self._say_values()
        self.word.setText("")
        moved = self._setting()
        if moved is None:
            return
        try:
            evaluated = evaluate_wall(moved, None)
        except InputError as error:
            self.word.setText(describe_message(error))
            evaluated = NO_EVALUATION
        self._show(evaluated, None)
        self.timer.start()

    def _setting(self) -> WallContext | None:
        """With the values of the sliders; None, and why, where the wall does not stand with them."""
        if self.setting is None:
            return None
        try:
            return self._rounded(set_values(self.setting, self.values))
        except InputError as error:
            self.stop()
            self.word.setText(describe_message(error))
            self._show(NO_EVALUATION)
            return None

    def _rounded(self, moved: WallContext) -> WallContext:
        """With the loads and ties that follow a slider in the digits they are written with."""
        wall, was = moved.case.wall[0], require_value(self.setting).case.wall[0]

        def rounded(entries: Iterable, before: Iterable, **digits: int) -> tuple:
            changed = []
            for entry, old in zip(entries, before, strict=True):
                keys = (key for key in digits if getattr(entry, key) != getattr(old, key))
                changed.append(replace(entry, **{key: round(getattr(entry, key), digits[key]) for key in keys}))
            return tuple(changed)

        loads, holds = rounded(wall.load, was.load, kn_m=FORCE, d_m=PLACE), rounded(wall.hold, was.hold, out_kn_m=FORCE)
        return replace_wall(moved, replace(wall, load=loads, hold=holds))

    def follow(self) -> None:
        """The histories of the values now, off the thread of the window: at a glance, then as a run finds them. Earlier
        ones are left."""
        if (moved := self._setting()) is not None:
            self._search_zeta(moved, COARSE_PRECISION)

    def _search_zeta(self, moved: WallContext, precision: Precision) -> None:
        self.stop("zeta")
        first, base = not self.values, self.base_dir
        asked = require_value(self.case).generate and "ag_g" in self.values and precision == FULL_PRECISION
        taken = self._taken(moved) if asked else None

        def work(job: Job) -> WallEvaluation:
            at = replace(moved, inputs=read_inputs(taken, base)) if taken else moved  # motions made for that spectrum
            return evaluate_wall(at, precision, cancelled=job.cancelled)

        def arrived(whole: WallEvaluation) -> None:
            if first:
                self.zetas = dict(whole.by_check) | self._of_the_run()
            again = precision == COARSE_PRECISION and "dynamic" in whole.by_check
            self._show(whole, COARSE_PRECISION if again else FULL_PRECISION)
            if again:
                self._search_zeta(moved, FULL_PRECISION)

        self._start("zeta", work, arrived)

    def _of_the_run(self) -> dict[str, float | None]:
        """zeta of each check by the run, where its input is still the one shown."""
        result = self.owner.session.result
        if result is None or self.owner.session.stale:
            return {}
        return {label: zeta for label, zeta in zeta_by_check(result, self.row).items() if label != OWN_Q}

    def search(self) -> None:
        """The answer turned round, of each slider alone."""
        moved = self._setting()
        if moved is None:
            return
        self.stop("search")
        self.word.setText(tr("Searching…"))
        keys = {key: now for key, now in design_keys(moved).items() if key in self.given}

        def work(job: Job) -> list[TargetValue]:
            return [find_target_value(moved, key, now, job.cancelled) for key, now in keys.items()]

        self._start("search", work, self._found)

    def _found(self, reached: list[TargetValue]) -> None:
        lines, names = [], captions()
        for one in reached:
            ends = []
            for label, value in one.by_check.items():
                said = reach_written(one.key, value, current_language())
                ends.append(f"{tr('any') if label in one.throughout else said} ({self._check(label)})")
            lines.append(f"{names[one.key]}: {'; '.join(ends)}")
        target = number(require_value(self.setting).demand.zeta_target, ".2f")
        self.word.setText("\n".join([tr("For ζ {zeta}:", zeta=target), *lines]))

    def _start(self, name: str, work, arrived) -> None:
        job = self.jobs[name] = Job(work)
        job.done.connect(lambda answer: arrived(answer) if self.jobs.get(name) is job else None)
        job.failed.connect(lambda words, _: self.word.setText(words) if self.jobs.get(name) is job else None)
        job.start()

    def stop(self, *names: str) -> None:
        """Leave what is not finished."""
        self.timer.stop()
        for name in names or tuple(self.jobs):
            if job := self.jobs.pop(name, None):
                job.cancel()

    def _check(self, label: str) -> str:
        return check_words(label, require_value(require_value(self.case).demand).q_code)

    def _show(self, whole: WallEvaluation, precision: Precision | None = FULL_PRECISION) -> None:
        """The ladder; zeta as it is beside each. precision : of the histories, None while none are made; those of a
        run follow"""
        setting, moved = require_value(self.setting), bool(self.values)
        rungs = rungs_of(whole, setting.demand.q_code, precision, self.zetas, moved, setting.has_histories)
        self.ladder.show_rungs(rungs, setting.demand.zeta_target)

    # what becomes of it

    def reset(self) -> None:
        """Every slider back to the value of the case."""
        for slider in self.sliders.values():
            slider.blockSignals(True)
            slider.setValue(0)
            slider.blockSignals(False)
        self._moved()
        self.follow()

    def _taken(self, moved: WallContext) -> Case:
        """The case with the values of the sliders."""
        case = require_value(self.case)
        wall, new = case.wall[self.row], moved.case.wall[0]
        sizes = ("thickness_m", "slenderness_deg", "height_over_thickness", "height_m")
        walls = list(case.wall)
        kept: dict[str, Any] = {key: getattr(new, key) for key in sizes}
        moved_holds = iter(new.hold)  # the tie that is sought is none of them
        kept["hold"] = tuple(hold if hold.design else next(moved_holds) for hold in wall.hold)
        walls[self.row] = replace(wall, **kept | {"load": new.load[: len(wall.load)]})
        floors = infer_floor_supports(case.building, wall, new)  # they bear where the sliders moved them
        case = replace(case, wall=tuple(walls), building=floors)
        if "ag_g" in self.values:
            case = replace(case, demand=replace(require_value(case.demand), ag_g=self.values["ag_g"]))
        return case

    def take_it(self) -> None:
        """The values into the case, a step of undo."""
        moved = self._setting() if self.values else None
        if moved is None:
            return
        if not self._is_as_shown():
            self._take_again()
            return
        case = self._taken(moved)
        self.owner.session.edit(case)
        self.show_case()

    def reject(self) -> None:
        """Nothing of a closed window listens any more."""
        self.stop()
        self.told.stop()
        listeners = self.owner.session.listeners
        if self.case_changed in listeners:
            listeners.remove(self.case_changed)
        super().reject()
        self.deleteLater()
