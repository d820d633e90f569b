"""What holds a wall: each hold, one at a time, with the document that shows it."""

from collections.abc import Callable
from dataclasses import replace

from app.input.entries_form import EntriesForm
from app.input.optional_group import OptionalGroup
from app.look.language import current_language, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.hold import AT_A_HEIGHT, BETWEEN, HOLDS, Document, Hold
from core.case.hold_rules import OF_ENDS
from core.text.sentence import capital, choice


def hold_words(hold: Hold) -> str:
    """A hold in the list."""
    said = [hold.name or capital(choice(hold.kind, current_language()))]
    if hold.kind in AT_A_HEIGHT:
        said.append(f"h {_shown(hold.h_m)} m")
    elif hold.spacing_m is not None:
        said.append(f"L {_shown(hold.spacing_m)} m")
    if hold.out_kn_m not in (None, ""):
        said.append(f"{_shown(hold.out_kn_m)} kN/m")
    return ", ".join(said)


def _shown(value) -> str:
    return "–" if value in (None, "") else number(value, "g")


def _hold_has(hold: Hold, key: str) -> bool:
    """Whether a hold of this kind has this key."""
    if key == "h_m":
        return hold.kind in AT_A_HEIGHT
    if key in ("from_m", "to_m"):
        return hold.kind not in AT_A_HEIGHT
    if key in OF_ENDS:
        return hold.kind in BETWEEN and hold.spacing_m is not None
    if key == "spacing_m":
        return hold.kind in BETWEEN
    if key == "out_kn_m":
        return hold.kind in AT_A_HEIGHT or hold.spacing_m is not None
    return True


class HoldsForm(EntriesForm):
    """Edits the holds of the wall at `index()`, one at a time."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "hold", {}, hold_words, _hold_has)
        self.list.setAccessibleName(tr("Holds"))
        self.add_button = self.add_menu(tr("Add a hold"), HOLDS, self.add)
        self.delete_button.setText(tr("Delete this hold"))
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

    def add(self, kind: str) -> None:
        """A hold at the top of the wall, or over its height."""
        if self.wall is not None:
            at = (self.wall.height_m or TO_BE_GIVEN) if kind in AT_A_HEIGHT else None
            self.append(Hold(kind, h_m=at))

    def focus_missing(self) -> None:
        """The cursor where something is missing: the first hold, or what shows one."""
        bare = next((k for k, hold in enumerate(self.entries) if hold.evidence is None), None)
        if bare is None:
            self.add_button.setFocus()
            return
        self.list.setCurrentRow(bare)
        self.shown_by.setFocus()

    def changed(self, entry: Hold, key: str, value) -> Hold:
        """Another kind has its own keys: what only the last one has goes."""
        if key != "kind":
            return super().changed(entry, key, value)
        hold = replace(entry, kind=value)
        gone = {field.key: field.entry.default for field in self.fields if not _hold_has(hold, field.key)}
        hold = replace(hold, **gone)
        if value in AT_A_HEIGHT and hold.h_m is None and self.wall is not None:
            hold = replace(hold, h_m=self.wall.height_m or TO_BE_GIVEN)
        return hold

    def _edit_evidence(self, *place, evidence: Document | None) -> None:
        if self.entry is not None:
            self.put(replace(self.entry, evidence=evidence), *(place or ("evidence",)))
