"""What holds a wall: each hold, one at a time, with the document that shows it."""

from collections.abc import Callable
from dataclasses import replace

from app.input.entries_form import EntriesForm
from app.input.optional_group import OptionalGroup
from app.look.language import current_language, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.hold import HOLD_KINDS, Bars, Document, Hold, hold_kind
from core.case.hold_rules import OF_ENDS
from core.case.tie_rules import NOT_SOUGHT, OF_A_TIE
from core.text.sentence import capital, choice


def hold_words(hold: Hold) -> str:
    """A hold in the list."""
    said = [hold.name or capital(choice(hold.kind, current_language()))]
    if hold.has_height:
        said.append(f"h {_shown(hold.h_m)} m")
    elif hold.spacing_m is not None:
        said.append(f"L {_shown(hold.spacing_m)} m")
    if hold.design:
        said.append(tr("to be designed"))
    if hold.out_kn_m not in (None, ""):
        said.append(f"{_shown(hold.out_kn_m)} kN/m")
    return ", ".join(said)


def _shown(value) -> str:
    return "–" if value in (None, "") else number(value, "g")


def _hold_has(hold: Hold, key: str) -> bool:
    """Whether a hold of this kind has this key."""
    if key == "h_m":
        return hold.has_height
    if key in ("from_m", "to_m"):
        return not hold.has_height
    if key in OF_ENDS:
        return hold.is_local and hold.spacing_m is not None
    if key == "spacing_m":
        return hold.is_local or hold.design
    if key in OF_A_TIE and not hold.is_bar:
        return False
    if key in NOT_SOUGHT and hold.design:
        return False
    if key == "fy_mpa":
        return hold.bar is None
    if key == "elongation_m" and not hold.is_bar:
        return hold.has_height and hold.out_kn_m is not None
    if key in ("in_kn_m", "stiffness_kn_m2"):
        return hold.has_height and not hold.is_bar and hold.out_kn_m is not None
    if key == "out_kn_m":
        return hold.bar is None and (hold.has_height or hold.spacing_m is not None)
    return True


class HoldsForm(EntriesForm):
    """Edits the holds of the wall at `index()`, one at a time."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "hold", {}, hold_words, _hold_has)
        self.list.setAccessibleName(tr("Holds"))
        self.add_button = self.add_menu(tr("Add a hold"), tuple(HOLD_KINDS), self.add)
        self.delete_button.setText(tr("Delete this hold"))
        bars, empty = Bars(TO_BE_GIVEN, TO_BE_GIVEN), Document(TO_BE_GIVEN)
        self.bars = OptionalGroup(tr("Bars in place of the force"), "bar", bars, lambda: self.entry, self._edit_bars)
        self.column.addWidget(self.bars)
        self.shown_by = OptionalGroup(tr("Evidence"), "evidence", empty, lambda: self.entry, self._edit_evidence)
        self.column.addWidget(self.shown_by)

    def _choose(self) -> None:
        self.bars.forget()
        self.shown_by.forget()
        super()._choose()

    def _show_entry(self) -> None:
        super()._show_entry()
        self.bars.setVisible(self.entry is not None and self.entry.is_tie)
        self.bars.show_case()
        self.shown_by.setVisible(self.entry is not None)
        self.shown_by.show_case()

    def add(self, kind: str) -> None:
        """A hold at the top of the wall, or over its height."""
        if self.wall is not None:
            at = (self.wall.height_m or TO_BE_GIVEN) if hold_kind(kind).has_height else None
            self.append(Hold(kind, h_m=at))

    def show_tie(self) -> None:
        """Show the first tie, if there is one and none is shown."""
        row = next((k for k, hold in enumerate(self.entries) if hold.is_bar), None)
        if row is not None and not (self.entry and self.entry.is_bar):
            self.list.setCurrentRow(row)

    def focus_missing(self) -> None:
        """The cursor where something is missing: the first hold, or what shows one."""
        bare = next((k for k, hold in enumerate(self.entries) if hold.is_contact and hold.evidence is None), None)
        if bare is None:
            self.add_button.setFocus()
            return
        self.list.setCurrentRow(bare)
        self.shown_by.setFocus()

    def changed(self, entry: Hold, key: str, value) -> Hold:
        """Another kind has its own keys, and a tie that is sought: what only the last one has goes."""
        hold = super().changed(entry, key, value)
        if key not in ("kind", "design"):
            return hold
        hold = hold if hold.is_bar else replace(hold, bar=None)
        gone = {field.key: field.entry.default for field in self.fields if not _hold_has(hold, field.key)}
        hold = replace(hold, **gone)
        if hold.has_height and hold.h_m is None and self.wall is not None:
            hold = replace(hold, h_m=self.wall.height_m or TO_BE_GIVEN)
        return hold

    def _edit_bars(self, *place, bar: Bars | None) -> None:
        """Bars that come or go take the force with them."""
        if self.entry is not None:
            hold = replace(self.entry, bar=bar)
            self.put(hold if place else replace(hold, out_kn_m=None, fy_mpa=None), *(place or ("bar",)))

    def _edit_evidence(self, *place, evidence: Document | None) -> None:
        if self.entry is not None:
            self.put(replace(self.entry, evidence=evidence), *(place or ("evidence",)))
