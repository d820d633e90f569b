"""The loads and ties of a wall."""

from collections.abc import Callable
from dataclasses import replace

from app.input.entries_form import EntriesForm
from app.input.optional_group import OptionalGroup
from app.input.wall_text import load_kind_text
from app.look.language import number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.load_rules import COMBINED, OF_A_TIE
from core.case.loads import Bars, Load
from core.case.values import field_of


def load_words(load: Load) -> str:
    """A load in the list."""
    size = "–" if load.kn_m in (None, "") else f"{number(load.kn_m, 'g')}"
    height = "–" if load.h_m in (None, "") else f"{number(load.h_m, 'g')}"
    return f"{load_kind_text(load)}, {size} kN/m, h {height} m"


def _load_has(load: Load, key: str) -> bool:
    """Whether a load of this kind has this key."""
    if key in OF_A_TIE:
        return load.is_tie and (load.bar is None or key not in ("fy_mpa", "elongation_m"))
    if key in COMBINED:
        return load.is_weight
    if key == "kn_m":
        return load.bar is None
    return key == "h_m" or key == "kind" or (not load.is_tie and (key != "mass" or load.kind == "vertical"))


class LoadsForm(EntriesForm):
    """Edits the loads of the wall at `index()`, one at a time."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "load", {}, load_words, _load_has)
        self.list.setAccessibleName(tr("Loads"))
        self.add_button = self.add_menu(tr("Add a load"), field_of(Load, "kind").metadata["names"], self.add)
        self.delete_button.setText(tr("Delete this load"))
        empty = Bars(TO_BE_GIVEN, TO_BE_GIVEN)
        self.bars = OptionalGroup(tr("Bars in place of the force"), "bar", empty, lambda: self.entry, self._edit_bars)
        self.column.addWidget(self.bars)

    def _choose(self) -> None:
        self.bars.forget()
        super()._choose()

    def _show_entry(self) -> None:
        super()._show_entry()
        self.bars.setVisible(self.entry is not None and self.entry.is_tie)
        self.bars.show_case()

    def add(self, kind: str) -> None:
        """A load at the top of the wall, its size to be given."""
        if self.wall is not None:
            self.append(Load(kind, None, self.wall.height_m or TO_BE_GIVEN), unloaded_confirmed=False)

    def show_tie(self) -> None:
        """Show the first tie, if there is one and none is shown."""
        row = next((k for k, load in enumerate(self.entries) if load.is_tie), None)
        if row is not None and not (self.entry and self.entry.is_tie):
            self.list.setCurrentRow(row)

    def changed(self, entry: Load, key: str, value) -> Load:
        """Another kind has its own keys, and the parts of a weight take the place of its size."""
        if key == "kind":
            mass = entry.mass if value == "vertical" else None
            return Load(value, entry.kn_m, entry.h_m, None if value == "tie" else entry.d_m, mass)
        load = super().changed(entry, key, value)
        return replace(load, kn_m=None) if key in COMBINED else load

    def _edit_bars(self, *place, bar: Bars | None) -> None:
        """Bars that come or go take the force with them."""
        if self.entry is not None:
            load = replace(self.entry, bar=bar)
            self.put(load if place else replace(load, kn_m=None), *(place or ("bar",)))
