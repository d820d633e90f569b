"""The mechanisms of a wall that the engineer sets aside, one at a time, each with its document."""

from collections.abc import Callable
from dataclasses import replace

from app.input.entries_form import EntriesForm
from app.input.optional_group import OptionalGroup
from app.look.language import current_language, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.hold import Document
from core.case.set_aside import ROWS, SetAside
from core.text.sentence import capital, choice


def set_aside_words(entry: SetAside) -> str:
    """A mechanism in the list."""
    low, high = (number(at, "g") if isinstance(at, float | int) else "" for at in (entry.from_m, entry.to_m))
    where = f"{low}–{high} m" if low and high else f"≥ {low} m" if low else f"≤ {high} m" if high else ""
    return ", ".join(filter(None, (capital(choice(entry.mechanism, current_language())), where)))


class SetAsideForm(EntriesForm):
    """Edits the mechanisms that are set aside of the wall at `index()`."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "set_aside", {}, set_aside_words)
        self.list.setAccessibleName(tr("Mechanisms set aside"))
        self.add_button = self.add_menu(tr("Set a mechanism aside"), ROWS, self.add)
        self.delete_button.setText(tr("Look at it again"))
        empty = Document(TO_BE_GIVEN)
        self.shown_by = OptionalGroup(tr("Evidence"), "evidence", empty, lambda: self.entry, self._edit_evidence)
        self.column.addWidget(self.shown_by)

    def _choose(self) -> None:
        self.shown_by.forget()
        super()._choose()

    def _show_entry(self) -> None:
        super()._show_entry()
        self.shown_by.setVisible(self.entry is not None)
        self.shown_by.show_case()

    def add(self, mechanism: str) -> None:
        """A mechanism over the whole wall, its document to be given."""
        if self.wall is not None:
            self.append(SetAside(mechanism, evidence=Document(TO_BE_GIVEN)))

    def _edit_evidence(self, *place, evidence: Document | None) -> None:
        if self.entry is not None:
            self.put(replace(self.entry, evidence=evidence), *(place or ("evidence",)))
