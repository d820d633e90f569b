"""The loads of a wall."""

from collections.abc import Callable
from dataclasses import replace

from app.input.entries_form import EntriesForm
from app.input.wall_text import load_kind_text
from app.look.language import number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.load_rules import COMBINED
from core.case.loads import Load
from core.case.values import field_of
from core.wall.load_kinds import LOAD_KINDS


def load_words(load: Load) -> str:
    """A load in the list."""
    size = "–" if load.kn_m in (None, "") else f"{number(load.kn_m, 'g')}"
    height = "–" if load.h_m in (None, "") else f"{number(load.h_m, 'g')}"
    return f"{load_kind_text(load)}, {size} kN/m, h {height} m"


def _load_has(load: Load, key: str) -> bool:
    """Whether a load of this kind has this key."""
    if key in COMBINED:
        return load.is_weight
    return key != "mass" or load.rests


class LoadsForm(EntriesForm):
    """Edits the loads of the wall at `index()`, one at a time."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "load", {}, load_words, _load_has)
        self.list.setAccessibleName(tr("Loads"))
        self.add_button = self.add_menu(tr("Add a load"), field_of(Load, "kind").metadata["names"], self.add)
        self.delete_button.setText(tr("Delete this load"))

    def add(self, kind: str) -> None:
        """A load at the top of the wall, its size to be given."""
        if self.wall is not None:
            self.append(Load(kind, None, self.wall.height_m or TO_BE_GIVEN), unloaded_confirmed=False)

    def changed(self, entry: Load, key: str, value) -> Load:
        """Another kind has its own keys, and the parts of a weight take the place of its size."""
        if key == "kind":
            mass = entry.mass if LOAD_KINDS[value].rests else None
            return Load(value, entry.kn_m, entry.h_m, entry.d_m, mass)
        load = super().changed(entry, key, value)
        return replace(load, kn_m=None) if key in COMBINED else load
