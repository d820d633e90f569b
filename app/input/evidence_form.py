"""The documents that show what raises zeta, of a wall and of the demand, one at a time."""

from collections.abc import Callable

from app.input.entries_form import EntriesForm
from app.input.fields import Field
from app.look.language import current_language, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.asked import DEMAND, WALL, evidence_keys
from core.case.document import AnyEvidence, DemandEvidence, WallEvidence
from core.case.site import Demand
from core.text.sentence import capital, choice


def evidence_words(entry: AnyEvidence) -> str:
    """A document in the list: of what, and its reference."""
    named = capital(choice(entry.of, current_language())) if entry.of else "–"
    return ", ".join(filter(None, (named, entry.reference)))


class EvidenceForm(EntriesForm):
    """Edits the documents of the wall at `index()`."""

    keys: tuple[str, ...] = evidence_keys(WALL)
    kind: type[AnyEvidence] = WallEvidence

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index, "evidence", {}, evidence_words, first=("of",))
        self.list.setAccessibleName(tr("Evidence"))
        self.add_button = self.add_menu(tr("Add evidence"), self.keys, self.add)

    def add(self, key: str) -> None:
        """A document of a key, the one there is of it already."""
        self.show_key(key)

    def show_key(self, key: str) -> Field:
        """The first field of the document of a key, to be given where there is none."""
        row = next((k for k, entry in enumerate(self.entries) if entry.of == key), None)
        if row is None:
            self.append(self.kind(TO_BE_GIVEN, of=key))
        else:
            self.list.setCurrentRow(row)
        return next(field for field in self.fields if field.key == "kind")


class DemandEvidenceForm(EvidenceForm):
    """Edits the documents of the demand and of the building."""

    keys = evidence_keys(DEMAND)
    kind = DemandEvidence
    owner = Demand

    def __init__(self, session: Session):
        super().__init__(session, lambda: 0)

    @property
    def entries(self) -> tuple:
        demand = self.session.case.demand
        return demand.evidence if demand else ()

    def edit(self, *place, **values) -> None:
        """Change the documents of the demand, if there is one."""
        if self.session.case.demand is not None:
            self.session.edit_section("demand", ("demand", *place) if place else None, **values)
