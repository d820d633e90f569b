"""What a wall carries and what holds it: loads, ties, return walls, hinges, variant."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QGroupBox, QHBoxLayout, QListWidget, QMenu, QToolButton, QVBoxLayout, QWidget

from app.input.fields import ChoiceField, Field, blank, connect
from app.input.hinges_field import HingesField
from app.input.made_fields import make_fields
from app.look.language import named, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.load_rules import COMBINED, OF_A_TIE
from core.case.loads import Bars, Load, ReturnWalls
from core.case.values import field_of
from core.case.wall import Wall
from core.known import known
from core.text.catalogue import CATALOGUE

KINDS = field_of(Load, "kind").metadata["names"]


def named_kinds() -> dict[str, str]:
    """Kinds of load as menu and list show them, one without words by its name."""
    words = CATALOGUE["word"]
    return {kind: named(f"load_{kind}") if f"load_{kind}" in words else kind for kind in KINDS}


class LoadsForm(QWidget):
    """Edits the loads of the wall at `index()`, one at a time. What else holds it, `wall_fields` and `across`, stands
    in sections of the form of the wall."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__()
        self.session, self.index = session, index
        self.forget()
        self.list = QListWidget()
        self.list.setMaximumHeight(64)
        self.list.setAccessibleName(tr("Loads"))
        self.list.currentRowChanged.connect(lambda _: self._show_load())
        self.kind = ChoiceField(Load, "kind", named_kinds())
        self.load_fields = [self.kind, *make_fields(Load, "size")]
        self.wall_fields = make_fields(Wall, "held", first=("tie_height_m",))
        connect(self.load_fields, self._load_changed)
        connect(self.wall_fields, self._wall_changed)
        self._lay_out()

    def forget(self) -> None:
        """Another wall: what was switched off in the last one does not come back in this."""
        self.former: ReturnWalls | None = None
        self.former_bar: Bars | None = None

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        buttons = QHBoxLayout()
        self.add_button, self.delete_button = QToolButton(), QToolButton()
        self.add_button.setText(tr("Add a load"))
        self.add_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self.add_button)
        for kind, shown in named_kinds().items():
            menu.addAction(shown, lambda kind=kind: self.add(kind))
        self.add_button.setMenu(menu)
        self.delete_button.setText(tr("Delete this load"))
        self.delete_button.clicked.connect(self.delete)
        buttons.addWidget(self.add_button)
        buttons.addWidget(self.delete_button)
        buttons.addStretch(1)
        column.addLayout(buttons)
        self.bars = QGroupBox(tr("Bars in place of the force"))
        self.bars.setCheckable(True)
        self.bars.toggled.connect(self._bars_toggled)
        of_bars = QVBoxLayout(self.bars)
        self.bar_fields = make_fields(Bars)
        connect(self.bar_fields, self._bars_changed)
        for field in self.bar_fields:
            of_bars.addWidget(field)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.list, *self.load_fields, self.bars):
            column.addWidget(widget)
        self.across = QGroupBox(tr("Friction of return walls (in α0 only)"))
        self.across.setCheckable(True)
        self.across.toggled.connect(self._across_toggled)
        inside = QVBoxLayout(self.across)
        self.across_fields = make_fields(ReturnWalls)
        connect(self.across_fields, self._across_changed)
        for field in self.across_fields:
            inside.addWidget(field)

    # showing

    @property
    def wall(self) -> Wall | None:
        walls = self.session.case.wall
        return walls[self.index()] if self.index() < len(walls) else None

    @property
    def load(self) -> Load | None:
        row = self.list.currentRow()
        loads = self.wall.load if self.wall else ()
        return loads[row] if 0 <= row < len(loads) else None

    def show_case(self) -> None:
        """Fill the form from the wall."""
        wall = self.wall
        if wall is None:
            with QSignalBlocker(self.list), QSignalBlocker(self.across):
                self.list.clear()
                self.across.setChecked(False)
            self._show_load()
            blank((*self.wall_fields, *self.across_fields, *self.load_fields, *self.bar_fields))
            return
        row = self.list.currentRow()
        words = [self._words(load) for load in wall.load]
        with QSignalBlocker(self.list):
            if words != [self.list.item(k).text() for k in range(self.list.count())]:
                self.list.clear()
                self.list.addItems(words)
            self.list.setCurrentRow(min(max(row, 0), len(words) - 1))
        self._show_load()
        for field in self.wall_fields:
            field.show_value(getattr(wall, field.key))
            if isinstance(field, HingesField):
                field.show_usual(wall, self.session.case.building)
        with QSignalBlocker(self.across):
            self.across.setChecked(wall.return_walls is not None)
        for field in self.across_fields:
            field.setVisible(wall.return_walls is not None)
            if wall.return_walls is not None:
                field.show_value(getattr(wall.return_walls, field.key))

    def _show_load(self) -> None:
        load = self.load
        self.list.setVisible(bool(self.wall and self.wall.load))
        self.delete_button.setEnabled(load is not None)
        for field in self.load_fields:
            field.setVisible(load is not None)
            if load is not None:
                field.show_value(getattr(load, field.key))
                field.setVisible(self._is_shown(load, field.key))
        bar = load.bar if load is not None else None
        self.bars.setVisible(load is not None and load.is_tie)
        with QSignalBlocker(self.bars):
            self.bars.setChecked(bar is not None)
        for field in self.bar_fields:
            field.setVisible(bar is not None)
            if bar is not None:
                field.show_value(getattr(bar, field.key))

    @staticmethod
    def _is_shown(load: Load, key: str) -> bool:
        """Whether a load of this kind has this key."""
        if key in OF_A_TIE:
            return load.is_tie and (load.bar is None or key not in ("fy_mpa", "elongation_m"))
        if key in COMBINED:
            return load.is_weight
        if key == "kn_m":
            return load.bar is None
        return key == "h_m" or key == "kind" or (not load.is_tie and (key != "mass" or load.kind == "vertical"))

    @staticmethod
    def _words(load: Load) -> str:
        size = "–" if load.kn_m in (None, "") else f"{number(load.kn_m, 'g')}"
        height = "–" if load.h_m in (None, "") else f"{number(load.h_m, 'g')}"
        return f"{named_kinds()[load.kind]}, {size} kN/m, h {height} m"

    # changes

    def _edit(self, place: tuple | None = None, **values) -> None:
        if self.wall is not None:
            self.session.edit_wall(self.index(), place and ("wall", self.index(), *place), **values)

    def add(self, kind: str) -> None:
        """A load at the top of the wall, its size to be given."""
        wall = self.wall
        if wall is None:
            return
        load = Load(kind, None, wall.height_m or TO_BE_GIVEN)
        self._edit(load=(*wall.load, load), unloaded_confirmed=False)
        self.list.setCurrentRow(len(wall.load))

    def show_tie(self) -> None:
        """Show the first tie, if there is one and none is shown."""
        row = next((k for k, load in enumerate(self.wall.load if self.wall else ()) if load.is_tie), None)
        if row is not None and not (self.load and self.load.is_tie):
            self.list.setCurrentRow(row)

    def delete(self) -> None:
        """Take the load away that is shown."""
        row = self.list.currentRow()
        if self.wall is not None and self.load is not None:
            self._edit(load=tuple(load for k, load in enumerate(known(self.wall).load) if k != row))

    def _load_changed(self, field: Field, value) -> None:
        load = self.load
        if load is None or self.wall is None:
            return
        changed = replace(load, **{field.key: value})
        if field.key in COMBINED:
            changed = replace(changed, kn_m=None)
        if field.key == "kind":
            mass = load.mass if value == "vertical" else None
            changed = Load(value, load.kn_m, load.h_m, None if value == "tie" else load.d_m, mass)
        self._replace(changed, field.key)

    def _bars_toggled(self, on: bool) -> None:
        load = self.load
        if load is None:
            return
        if not on:
            self.former_bar = load.bar
        empty = Bars(TO_BE_GIVEN, TO_BE_GIVEN)
        self._replace(replace(load, bar=(self.former_bar or empty) if on else None, kn_m=None), "bar")

    def _bars_changed(self, field: Field, value) -> None:
        if self.load is not None and self.load.bar is not None:
            self._replace(replace(self.load, bar=replace(self.load.bar, **{field.key: value})), "bar", field.key)

    def _replace(self, changed: Load, *key: str) -> None:
        """Put this load in the place of the one that is shown."""
        row = self.list.currentRow()
        loads = tuple(changed if k == row else one for k, one in enumerate(known(self.wall).load))
        self._edit(("load", row, *key), load=loads)

    def _wall_changed(self, field: Field, value) -> None:
        self._edit((field.key,), **{field.key: value})

    def _across_toggled(self, on: bool) -> None:
        if self.wall is None:
            return
        if not on:
            self.former = self.wall.return_walls
        empty = ReturnWalls(TO_BE_GIVEN, TO_BE_GIVEN, TO_BE_GIVEN, TO_BE_GIVEN)
        self._edit(return_walls=(self.former or empty) if on else None)

    def _across_changed(self, field: Field, value) -> None:
        if self.wall is not None and self.wall.return_walls is not None:
            changed = replace(self.wall.return_walls, **{field.key: value})
            self._edit(("return_walls", field.key), return_walls=changed)
