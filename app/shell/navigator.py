"""What of the case and of its result is in front: stages, pages, the wall shown; tree, form and pages follow one
another."""

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.look.language import tr
from app.shell.header import Header
from app.shell.pages import LazyPage
from app.shell.pointing import point_at_evidence, point_at_key
from app.shell.stages import ANSWER, WHY, Stages, stage_of
from app.shell.tree import ProjectTree, Row, hinge_text
from app.views.result_tab import ResultTab
from app.work.runner import Runner
from app.work.session import Session
from core.capacity.accuracy import Accuracy
from core.case.sensitivity import Ranges
from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.setting.demand_input import read_target_spectrum
from core.study.results import StudyResult, WallResult

OF_A_RESULT = ("check", "histories", "sure", "capacity", "intensity", "validation")
"""Pages that show nothing without a result."""

Tab = TypeVar("Tab", bound=QWidget)


def row_of(result: StudyResult, wall: WallResult, walls: tuple[Wall, ...]) -> int | None:
    """Row of the wall, among those of a case that may have changed since, that a wall of a result is of or is a part
    of: the one that was analysed, else the one in its place; None where that is another one."""
    asked, k = wall.part.asked, wall.part.origin
    if k < len(walls) and walls[k] == asked:  # nearly always: to search each of 200 takes a tenth of a second
        return k
    if asked in walls:
        return walls.index(asked)
    return k if k < len(walls) and walls[k] not in result.case.wall else None


class Navigator(QObject):
    """Brings stages, pages and walls to the front.

    shown : index of the result that is shown, -1 without one; fresh : pages that show it
    parts : pages that show walls that were finished, of a case that runs or was cancelled
    staged : another stage is in front; moved : another wall, result or page of it; run_asked : by an answer or a notice
    """

    staged = Signal()
    moved = Signal()
    run_asked = Signal()

    def __init__(self, session: Session, runner: Runner, stages: Stages, header: Header, tree: ProjectTree):
        super().__init__(stages)
        self.session, self.runner = session, runner
        self.stages, self.header, self.tree = stages, header, tree
        self.pages, self.beside = stages.pages, stages.answer.beside
        self.walls, self.demand = stages.input.walls, stages.input.demand
        self.records, self.missing = stages.input.records, stages.input.missing
        self.shown = -1
        self.parts: set[str] = set()
        self.fresh: set[QWidget] = set()
        self._known_rows: tuple[StudyResult | None, tuple[Wall, ...], dict[int, list[int]]] = (None, (), {})
        header.staged.connect(self.show_stage)
        header.noticed.connect(self.follow_notice)
        tree.chosen.connect(self.choose_row)
        for page in self.pages.values():
            page.asked.connect(self.follow_notice)
        self.walls.selected.connect(self._wall_selected)
        self.demand.motions_asked.connect(lambda: self.ask("generate"))
        stages.why.currentChanged.connect(lambda _: self.show_result())
        stages.answer.widened.connect(self._show_beside)

    # stages and pages

    def show_stage(self, name: str) -> None:
        """Bring a stage to the front: input, answer, why, report. The form is that of the row of the tree."""
        self.header.show_stage(name)
        marked = self.tree.current
        if name == "input" and marked is not None:
            self.stages.input.show_kind(marked.kind if marked.kind in self.stages.input.areas else "wall")
        elif name in ("answer", "why") and marked is not None and marked.wall < 0 and self.page != "walls":
            self._mark_wall_shown()
        self.stages.show_stage(name)
        self.staged.emit()
        self.show_result()

    def _mark_wall_shown(self) -> None:
        """In the tree, in the place of a form that is not in front."""
        if self.session.case.wall:
            self.tree.select(("wall", self.walls.current, ""))

    @property
    def page(self) -> str | None:
        """Name of the page in front, None on the stage Input."""
        front = self.stages.front
        if front == "answer":
            return ANSWER[self.stages.answer.stack.currentIndex()]
        if front == "why":
            return WHY[self.stages.why.currentIndex()]
        return "note" if front == "report" else None

    def show_page(self, name: str) -> None:
        """Bring a page to the front, with its stage."""
        if name in ANSWER:
            self.stages.answer.stack.setCurrentIndex(ANSWER.index(name))
        elif name in WHY:
            self.stages.why.setCurrentIndex(WHY.index(name))
        self.show_stage(stage_of(name))

    def show_answer(self) -> None:
        """After a run: of one wall its answer, of several which wants a look first."""
        if self.page == "walls" and len(self.results_of()) == 1:
            self.show_page("check")

    def show_input(self, kind: str, row: int | None = None) -> None:
        """Bring a form to the front. kind : wall, demand, building, records, report; row : of the wall"""
        if row is not None:
            self.walls.select(row)
        if kind == "wall" and not self.session.case.wall:
            self.tree.select(("walls", -1, ""))
        else:
            self.tree.select((kind, self.walls.current, "") if kind == "wall" else (kind, -1, ""))
        self.stages.input.show_kind(kind)
        self.show_stage("input")

    def show_form_of(self, field: QWidget) -> None:
        """Bring the form a field or section is in to the front."""
        for kind, area in self.stages.input.areas.items():
            if area.isAncestorOf(field):
                self.show_input(kind)
        if self.stages.note_form.isAncestorOf(field):
            self.show_stage("report")

    def then_input(self, change: Callable[[], object]) -> None:
        """Change the walls, then show the form of the one chosen."""
        change()
        self.show_input("wall")

    def follow_notice(self) -> None:
        """To what is missing, else a run."""
        if self.missing.problems:
            self.missing.lead()
        else:
            self.run_asked.emit()

    def choose_row(self, row: Row) -> None:
        """What is chosen in the tree: its form, or its result on the stage in front."""
        if row.kind in ("demand", "records", "building", "report"):
            self.show_input(row.kind)
        elif row.kind == "walls":
            self.show_page("walls")
        elif row.wall >= 0:
            self.tree.select(row.key)
            self.walls.select(row.wall)
            self.follow_tree()
            self.stages.input.show_kind("wall")
            if self.stages.front == "input":
                self.show_stage("input")
            elif self.stages.front == "answer" and (self.wall is not None or self._finished is not None):
                self.show_page("check")

    def _wall_selected(self, row: int) -> None:
        """The form shows another wall: the tree follows, and the pages."""
        current = self.tree.current
        if current is None or current.wall != row:
            self.tree.select(("wall", row, ""))
        self.stages.input.show_kind("wall")
        self.moved.emit()

    def follow_tree(self) -> None:
        """The row marked in the tree, the form and the pages are of one wall: that of the form. A wall without a result
        shows none."""
        row, marked = self.walls.current, self.tree.current
        if self.session.case.wall and (marked is None or marked.wall not in (-1, row)):
            self.tree.select(("wall", row, ""))
            marked = self.tree.current
        if self.session.result is None:
            return
        results = self.results_of().get(row, [])
        if marked is not None and marked.wall >= 0:
            results = [require_value(marked.result)] if marked.kind == "hinge" else results[:1]
        if self.shown in results or (self.shown < 0 and not results):
            return
        self.shown = results[0] if results else -1
        self.fresh.clear()
        if not results:
            self._empty_pages()
        self.show_result()

    def results_of(self) -> dict[int, list[int]]:
        """Row of a wall of the case -> indices of its results, the one that decides first."""
        result, walls = self.session.result, self.session.case.wall
        if result is None:
            return {}
        if self._known_rows[0] is not result or self._known_rows[1] is not walls:
            ordered = [k for verdict in result.verdicts for k in verdict.results] or range(len(result.walls))
            by_row: dict[int, list[int]] = {}
            for k in ordered:
                row = row_of(result, result.walls[k], walls)
                if row is not None:
                    by_row.setdefault(row, []).append(k)
            self._known_rows = (result, walls, by_row)
        return self._known_rows[2]

    def show_spectra(self, page: LazyPage | None = None) -> None:
        """The spectra of the input as it stands. page : beside the records; None is that of the stage Why"""
        demand = self.session.case.demand
        try:
            target = read_target_spectrum(demand, self.session.base_dir) if demand else None
        except (InputError, TypeError, KeyError):  # still to be given
            target = None
        result = self.session.result
        rules = result.compliance if result and not self.session.stale else None
        floor = self.wall.floor if self.wall and not self.session.stale else None
        from app.views.result_tabs import SpectraTab

        content = (page or self.pages["spectra"]).content
        assert isinstance(content, SpectraTab)
        content.show_records(self.records.motions, target, rules, floor, self.shown)

    @property
    def wall(self) -> WallResult | None:
        """The result that is shown."""
        result = self.session.result
        return result.walls[self.shown] if result and 0 <= self.shown < len(result.walls) else None

    def pick(self, k: int) -> None:
        """Show the answer of the k-th result."""
        self._pick(k)
        self.show_page("check")

    def ask(self, what: str) -> None:
        """Lead to what an answer asks for: variant, generate, a form by its kind, the field of a key ("key:period_s"),
        the document that shows its value ("reason:law")."""
        part, _, key = what.partition(":")
        if key:
            self.show_input("wall")
            (point_at_evidence if part == "reason" else point_at_key)(self, key)
        elif what == "variant":
            self.then_input(self.walls.add_variant)
            self.walls.sections["holds"].unfold()  # a tie, or what stands more
            self.walls.holds.add_button.setFocus()
        elif what == "holds":
            self.show_input("wall")
            self.walls.sections["holds"].unfold()
            self.walls.holds.focus_missing()
        elif what == "set_aside":
            self.show_input("wall")
            self.walls.sections["hinges"].unfold()
            self.walls.set_aside.add_button.setFocus()
        elif what == "generate":
            self.show_input("records")
            self.records.generate()
        elif what == "sensitivity":
            self.session.edit(replace(self.session.case, sensitivity=Ranges()))
            self.run_asked.emit()
        else:
            self.show_input(what)
            if what == "building":  # which is to be given: its height first
                self.demand.building.given.setChecked(True)
                self.demand.building.fields[0].editor.setFocus()

    def show_run_history(self, run: tuple) -> None:
        """The history of this (motion, polarity) of the wall shown."""
        from app.views.histories_tab import HistoriesTab

        self.show_page("histories")
        self._tab("histories", HistoriesTab).show_run(run)

    def pick_row(self, row: int) -> None:
        """Show the answer of a wall that is judged while others run."""
        self.walls.select(row)
        if self._finished is not None:
            self.show_page("check")

    def pick_input(self, k: int) -> None:
        """Show the input of the wall of the k-th result."""
        self._pick(k)
        self.show_input("wall")

    def _pick(self, k: int) -> None:
        """Pages, form and tree show the k-th result."""
        result = require_value(self.session.result)
        self.shown = k
        self.fresh.clear()
        row = row_of(result, result.walls[k], self.session.case.wall)
        if row is not None:
            self.walls.select(row)
            hinge = hinge_text(result.walls[k])
            self.tree.select(("wall", row, ""))
            if self.results_of().get(row, [k])[0] != k:
                self.tree.select(("hinge", row, hinge))
            self.follow_tree()
        self.show_result()

    def show_result(self) -> None:
        """What the page in front shows, and what stands beside it."""
        if self.page is not None:
            self.fill(self.page)
        self._show_beside()
        self.cover_pages()

    def fill(self, name: str) -> None:
        """A page, once per result and wall."""
        page, part = self.pages[name], self._finished
        if name == "spectra":
            self.show_spectra()
        elif name == "check" and part is not None:
            content = page.content
            assert isinstance(content, ResultTab)
            content.show_wall(part, part.walls[part.verdicts[0].governing])
            self.fresh.discard(page)
            self.parts.add(name)
        elif self.wall is None and name in OF_A_RESULT:
            self.parts.discard(name)
            self.say_empty()
        elif page not in self.fresh and (self.wall is not None or page.made is None):
            self.parts.discard(name)
            self._show_wall(page)

    @property
    def _finished(self) -> StudyResult | None:
        """The wall of the form, where it was judged by what runs or was cancelled, and is as it was then."""
        part = self.runner.finished_results.get(self.walls.current) if self.runner.is_of_input else None
        return part if part is not None and part.verdicts else None

    def _show_wall(self, page: LazyPage) -> None:
        content, result, wall = page.content, self.session.result, self.wall
        if result is not None and wall is not None:
            assert isinstance(content, ResultTab)
            content.show_wall(result, wall)
            self.fresh.add(page)

    def say_empty(self) -> None:
        """What brings something to show, where there is none."""
        page = self.page
        if self.wall is None and page in OF_A_RESULT and not (page == "check" and self._finished is not None):
            problem = next((one for one in self.missing.problems if one.stops), None)
            words = tr("Nothing to show yet. Press F5.")
            if problem is not None:
                words = tr("Nothing to show yet. First: {problem}", problem=problem.words)
            elif self.runner.job is not None:
                words = tr("Nothing to show yet. The analysis is running.")
            self.pages[page].say(words)

    def _show_beside(self) -> None:
        """The rocking wall beside the answer, where the window is wide."""
        answer = self.stages.answer
        answer.show_beside(self.wall is not None and self.page == "check")
        if answer.has_beside() and self.beside not in self.fresh and self.stages.front == "answer":
            self._show_wall(self.beside)

    def cover_pages(self) -> None:
        """Grey the page in front where its result is of an earlier input; Spectra shows the input as it is."""
        if self.page in self.parts:
            self.stages.veil.cover(not self.runner.is_of_input)
            return
        live = self.page in (None, "spectra")
        self.stages.veil.cover(self.session.stale and not live)

    def show_finished(self) -> None:
        """The verdicts that are there while others run."""
        from app.views.walls_tab import WallsTab

        self._tab("walls", WallsTab).show_running(self.runner.finished_walls, self.runner.zetas_so_far())
        self.fresh.discard(self.pages["walls"])
        self.parts.add("walls")
        self.cover_pages()

    def show_judged(self) -> None:
        """The wall of the form may be judged while others run: its answer, where that is in front."""
        if self.page == "check" and self._finished is not None:
            self.fill("check")
            self.cover_pages()

    def keep_finished(self) -> None:
        """What ran is cancelled: the walls that were finished stay in sight until the input changes."""
        from app.views.walls_tab import WallsTab

        self.show_finished()
        self._tab("walls", WallsTab).say_cancelled()
        self.fresh.add(self.pages["walls"])
        self.show_result()

    def leave_finished(self) -> None:
        """What ran has failed, or the input has changed since: the last result again, or none."""
        self.parts = set()
        for name in ("walls", "check"):
            self.fresh.discard(self.pages[name])
            if self.session.result is None:
                self.pages[name].empty()
        self.show_result()

    def state_accuracy(self) -> None:
        """The accuracy statement of the wall shown, off this thread."""
        self.runner.state_accuracy(self.shown)

    def show_accuracy(self, k: int, accuracy: Accuracy | None) -> None:
        """The accuracy statement of the k-th result, where that is shown."""
        from app.views.validation_tab import ValidationTab

        if self.shown == k:
            self._tab("validation", ValidationTab).show_accuracy(accuracy)

    def take(self, result: StudyResult | None) -> None:
        """A result of study.run in the place of the last one; None while there is none."""
        self.session.result, self.parts = result, set()
        self.fresh.clear()
        if result is None:
            self.shown = -1
            self._empty_pages()
        else:
            results = self.results_of().get(self.walls.current, [])
            if self.shown not in results:
                self.shown = results[0] if results else 0
        self.moved.emit()
        self.show_result()

    def _empty_pages(self) -> None:
        for page in (*self.pages.values(), self.beside):
            page.empty()

    def _tab(self, name: str, kind: type[Tab]) -> Tab:
        """What a page holds, which is of this kind."""
        content = self.pages[name].content
        assert isinstance(content, kind)
        return content
