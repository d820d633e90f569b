"""A walk through the forms, step by step at random: every state they reach is saved, opened again and recovered."""

import os
import random

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QFileDialog, QMessageBox, QPlainTextEdit, QToolButton

from app.input.fields import ChoiceField, FlagField
from app.look.section import FoldingSection, unfold_to
from app.shell.header import STAGES
from app.work.session import Session
from core.case.hold import HOLD_KINDS
from core.case.loads import Load
from core.case.values import field_of
from core.case.writer import table_of
from tests.app.driving import settle

TEXTS = (
    "", "", " ", "0", "1", "2", "3,5", "0.4", "7", "12", "45", "90", "1e9", "-1", "abc", "nan", "5;5", "3; 6", "0.1-2",
    "base", "floors", "a \"quoted\" = name", "è [°] #", "x" * 600, "w", "\t", "2026-11-25", "=SUM(A1)", "\u200b",
)  # fmt: skip
"""What is typed into a field, whatever it takes."""

WALLS = "name;height_m;thickness_m;mechanism;base_z_m\n;m;cm;;m\npasted;4;40;one_sided;0\n"
CORNERS = (
    "", "0 0", "0\t0\n4\t0", "0;0\n4;0\n4;5,5\n0;5.5", "0 0\n1 1\n0 1\n1 0", "0 0\n4 0\n2", "-1 -1\n1e9 2\n3 3", "x",
)  # fmt: skip
CLIPBOARDS = (WALLS, "30 0.08\n475 0.2\n", "")


class Walk:
    """Steps in a window, each an act of a person. done : their names, for a state that is not kept"""

    def __init__(self, window, seed: int, tmp_path):
        self.window, self.chance, self.folder = window, random.Random(seed), tmp_path
        self.done: list[str] = []
        acts = {
            self.type_into_a_field: 40,
            self.turn_a_section: 4,
            self.choose_a_mechanism: 3,
            self.choose_a_shape: 4,
            self.choose_a_law: 3,
            self.add_a_load: 6,
            self.choose_a_load: 3,
            self.delete_a_load: 1,
            self.add_a_hold: 6,
            self.choose_a_hold: 3,
            self.delete_a_hold: 1,
            self.tick_bars: 3,
            self.tick_return_walls: 3,
            self.drag_a_load: 2,
            self.drag_a_hold: 2,
            self.change_the_shape: 14,
            self.tick_the_demand: 2,
            self.choose_a_spectrum: 4,
            self.choose_a_place: 4,
            self.tick_the_building: 2,
            self.paste: 2,
            self.change_the_walls: 5,
            self.choose_a_row_of_the_tree: 4,
            self.change_the_stage: 5,
            self.change_the_records: 3,
            self.undo_or_redo: 10,
        }
        self.acts, self.weights = list(acts), list(acts.values())

    def step(self) -> None:
        """One act; its name with what it took is kept."""
        act = self.chance.choices(self.acts, self.weights)[0]
        self.done.append(f"{act.__name__} {act() or ''}")

    def one_of(self, entries):
        return self.chance.choice(list(entries))

    def type_into_a_field(self):
        """Only into one that a person sees, once its section is unfolded."""
        field = self.one_of(self.window.stages.fields)
        unfold_to(field)
        areas = self.window.stages.input.areas.values()
        area = next((area for area in areas if area.isAncestorOf(field)), field.parentWidget())  # else of the note
        if not field.isVisibleTo(area) or not field.editor.isEnabled():
            return None
        if isinstance(field, FlagField):
            field.editor.click()
            return field.key
        if isinstance(field, ChoiceField):
            k = self.chance.randrange(field.editor.count())
            field.editor.setCurrentIndex(k)
            field.editor.activated.emit(k)
            return f"{field.key} {k}"
        text = self.one_of(TEXTS)
        if isinstance(field.editor, QPlainTextEdit):
            field.editor.setPlainText(text)
            return f"{field.key} {text!r}"
        text = text[: field.editor.maxLength()]
        if self.chance.random() < 0.5:
            field.editor.setFocus()
        field.editor.setText(text)
        field.editor.textEdited.emit(field.editor.text())
        return f"{field.key} {text!r}"

    def turn_a_section(self):
        self.one_of(self.window.stages.input.findChildren(FoldingSection)).head.click()

    def choose_a_mechanism(self):
        if self.window.walls.wall is not None:
            self.one_of(self.window.walls.mechanisms.values()).click()

    def _choose(self, box):
        if box.isEnabled() and box.isVisibleTo(box.parentWidget()):
            k = self.chance.randrange(box.count())
            box.setCurrentIndex(k)
            box.activated.emit(k)
            return k
        return None

    def choose_a_shape(self):
        return self._choose(self.window.walls.shape)

    def choose_a_law(self):
        return self._choose(self.window.walls.impact.law)

    def add_a_load(self):
        kind = self.one_of(field_of(Load, "kind").metadata["names"])
        self.window.walls.loads.add(kind)
        return kind

    def _choose_entry(self, entries):
        if entries.count():
            entries.setCurrentRow(self.chance.randrange(entries.count()))

    def choose_a_load(self):
        self._choose_entry(self.window.walls.loads.list)

    def delete_a_load(self):
        self.window.walls.loads.delete_button.click()

    def add_a_hold(self):
        """A tie as often as any other."""
        kind = self.one_of(("tie", self.one_of(tuple(HOLD_KINDS))))
        self.window.walls.holds.add(kind)
        return kind

    def choose_a_hold(self):
        self._choose_entry(self.window.walls.holds.list)

    def delete_a_hold(self):
        self.window.walls.holds.delete_button.click()

    def _tick(self, box):
        if not box.isHidden():
            box.setChecked(not box.isChecked())
            return box.isChecked()
        return None

    def tick_bars(self):
        return self._tick(self.window.walls.holds.bars)

    def tick_return_walls(self):
        return self._tick(self.window.walls.across) if self.window.walls.wall else None

    def drag_a_load(self):
        wall = self.window.walls.wall
        if wall is not None and wall.load and wall.height_m:
            height = wall.height_m * self.chance.random()
            self.window.walls.drawing.moved.emit("load", self.chance.randrange(len(wall.load)), height)

    def drag_a_hold(self):
        wall = self.window.walls.wall
        if wall is not None and wall.hold and wall.height_m:
            height = wall.height_m * self.chance.random()
            self.window.walls.drawing.moved.emit("hold", self.chance.randrange(len(wall.hold)), height)

    def change_the_shape(self):
        """An opening, a step or a solid more, another one, one less; corners; wedges, with their length."""
        body = self.window.walls.body
        if self.window.walls.wall is None:
            return None
        entries = self.one_of(body.lists)
        act = self.chance.randrange(6)
        if act < 2:
            buttons = [one for one in entries.findChildren(QToolButton) if one is not entries.delete_button]
            self.one_of(buttons).click()
        elif act == 2 and entries.list.count():
            entries.list.setCurrentRow(self.chance.randrange(entries.list.count()))
        elif act == 3:
            entries.delete_button.click()
        elif act == 4:
            self._tick(body.wedges)
            body.brick_length.setText("25")
            body.brick_height.setText(self.one_of(("20", "", "x")))
            body.brick_height.textEdited.emit("")
            body.fill.click()
        elif body.solids.entry is not None:
            corners = next(field for field in body.solids.fields if field.key == "polygon_m")
            unfold_to(corners)
            corners.editor.setPlainText(self.one_of(CORNERS))
        return f"{entries.key} {act}"

    def tick_the_demand(self):
        return self._tick(self.window.demand.given)

    def choose_a_place(self) -> None:
        form = self.window.demand.place
        if self.chance.random() < 0.4:
            form.given.setChecked(not form.given.isChecked())
        elif self.chance.random() < 0.5:
            names = ("Modena (MO)", "L'Aquila", "Castro", "Castro (LE)", "Nowhere", "")
            form.municipality.choose(self.chance.choice(names))
        else:
            text = self.chance.choice(("42.35 13.4", "48.8 2.3", "39.2 N 9.1 E", "x", ""))
            form.point.setText(text)
            form.point.textEdited.emit(text)

    def choose_a_spectrum(self):
        return self._choose(self.window.demand.kind) if self.window.session.case.demand else None

    def tick_the_building(self):
        return self._tick(self.window.demand.building.given)

    def paste(self):
        text = self.one_of(CLIPBOARDS)
        QGuiApplication.clipboard().setText(text)
        self.one_of((self.window.walls.paste, self.window.demand.hazard.paste))()
        return repr(text)

    def change_the_walls(self):
        walls = self.window.walls
        act = self.one_of((walls.add, walls.add_variant, walls.duplicate, walls.delete))
        if len(self.window.session.case.wall) > 6:
            act = walls.delete
        act()
        return act.__name__

    def choose_a_row_of_the_tree(self):
        row = self.one_of(self.window.tree.rows)
        self.window.navigator.choose_row(row)
        return row.key

    def change_the_stage(self):
        name = self.one_of(STAGES)
        self.window.navigator.show_stage(name)
        return name

    def change_the_records(self):
        records = self.window.records
        if self.chance.random() < 0.5:
            records.table.selectAll()
        act = self.one_of((records.reverse, records.remove, records.generate, records.scale_to_target))
        if act == records.remove and self.chance.random() < 0.7:
            return None
        act()
        return act.__name__

    def undo_or_redo(self):
        act = self.one_of((self.window.session.undo, self.window.session.undo, self.window.session.redo))
        act()
        return act.__name__


def shown(window) -> dict:
    """What is said of the case as it stands, and whether it may run."""
    problems = [(problem.words, problem.stops) for problem in window.missing.problems]
    fields = {f"{k} {one.key}": (one.isHidden(), one.rule, one.wrong) for k, one in enumerate(window.stages.fields)}
    may = window.run_action.isEnabled(), window.run_button.isEnabled()
    rows = {str(k): row.text for k, row in enumerate(window.tree.rows)}
    return {"may run": may, "problems": problems, "notice": window.header.notice_words, **rows, **fields}


def check_shown(window, application) -> None:
    """Once the hand rests nothing in sight or behind is of an earlier state, and what may run is what lacks nothing."""
    application.processEvents()
    window.parts.flush_pending()
    before = shown(window)
    stopped = any(problem.stops for problem in window.missing.problems)
    assert before["may run"] == (not stopped, not stopped) and window.missing.can_run() != stopped
    window.refresh()
    after = shown(window)
    assert {key: (before.get(key), now) for key, now in after.items() if now != before.get(key)} == {}


def check_drafts(walk: Walk, session: Session, wholly: bool) -> None:
    """What is at hand is autosaved and recovered equal; wholly : saved and opened again as well."""
    wanted = table_of(session.case)
    session.autosave()
    other = Session(walk.folder / "recovery_folder")
    if session.dirty:
        other.recover(session.recovery_file)
        assert table_of(other.case) == wanted
    if wholly:
        path = session.path.with_name("again.toml")
        other._start(session.case)
        other.base_dir = session.base_dir
        other.save(path)
        saved = table_of(other.case)
        other.open(path)
        assert table_of(other.case) == saved
        assert saved | {"record": None} == wanted | {"record": None}  # of these the paths are those of the folder
        assert str(other.problem()) == str(session.problem())
        assert [str(one) for one in other.problems()] == [str(one) for one in session.problems()]
    other.close()


def walk_through(window, application, tmp_path, monkeypatch, faults, seed: int, steps: int) -> None:
    """`steps` acts; after each what is at hand is kept, at the end undo and redo go all the way."""
    monkeypatch.setattr(QMessageBox, "warning", lambda *_: None)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    monkeypatch.setattr(type(window.records), "ask_replace", lambda self: walk.chance.choice((True, False, None)))
    walk, first = Walk(window, seed, tmp_path), window.session.case
    try:
        for n in range(steps):
            walk.step()
            check_shown(window, application)
            assert faults == []
            check_drafts(walk, window.session, wholly=n % 5 == 0)
        settle(application, lambda: not window.records.pending)
        while window.session.future:
            window.session.redo()
        last = window.session.case
        while window.session.past:
            window.session.undo()
            assert faults == []
        assert window.session.case == first
        while window.session.future:
            window.session.redo()
        assert window.session.case == last and faults == []
    except (Exception, pytest.fail.Exception) as error:
        raise AssertionError(f"seed {seed}, after {len(walk.done)} steps: " + "; ".join(walk.done[-12:])) from error


@pytest.mark.shows("window.drafts")
@pytest.mark.parametrize(("seed", "acts"), [(2, 30), *(pytest.param(k, 80, marks=pytest.mark.long) for k in (1, 2))])
def test_that_every_state_the_forms_reach_is_kept(opened, application, tmp_path, monkeypatch, faults, seed, acts):
    """A load without its size, a spectrum without its soil, an empty name among them."""
    walk_through(opened, application, tmp_path, monkeypatch, faults, seed, acts)


@pytest.mark.long
@pytest.mark.parametrize("seed", range(10, 22))
def test_that_every_state_a_long_walk_reaches_is_kept(opened, application, tmp_path, monkeypatch, faults, seed):
    walk_through(opened, application, tmp_path, monkeypatch, faults, seed, 400)
