"""What shows a value: a document, printed as the engineer's declaration. Nothing reads the meaning of its words: its
kind says what it can show."""

from collections.abc import Iterable
from dataclasses import dataclass

from core.case import asked
from core.case.asked import DEMAND, WALL, evidence_keys
from core.case.keys import choice_key, text_key
from core.errors import InputError
from core.text.sentence import Sentence, sentence

PRESENCE = "drawing", "opening", "survey", "photograph"
STRENGTH = "test", "calculation", "dimensioned_drawing"
STATED = "study", "act"
"""Kinds of documents that show that a thing is there, those that show what it stands too, and those that state what is
asked: a study or a publication, an act of the client or of an authority."""

KINDS_THAT_SHOW = {
    asked.SEEN: (*PRESENCE, *STRENGTH, "study"),
    asked.MEASURED: (*STRENGTH, "study"),
    asked.TESTED: ("test", "calculation", "study"),
    asked.STATED: ("calculation", *STATED),
    asked.ORDERED: STATED,
}
"""What a document has to be -> its kinds."""


@dataclass(frozen=True)
class Document:
    """evidence of a hold, of a leaf, of what is set aside.

    kind : a photograph shows no strength; dimensioned_drawing : a drawing with the anchors dimensioned
    """

    kind: str = choice_key(*PRESENCE, *STRENGTH)
    reference: str = text_key()
    date: str = text_key()
    note: str = text_key()

    @property
    def shows_strength(self) -> bool:
        """Whether it shows what a thing stands, not only that it is there."""
        return self.kind in STRENGTH

    @property
    def words(self) -> Sentence:
        """It as the reports have it."""
        more = ", ".join(filter(None, (self.reference, self.date, self.note)))
        kind = sentence("word", f"evidence_{self.kind}")
        return sentence("mechanism", "shown", kind=kind, more=more) if more else kind


@dataclass(frozen=True)
class WallEvidence(Document):
    """[[wall.evidence]]: the document that shows a value of the wall which raises zeta. of : its key"""

    kind: str = choice_key(*PRESENCE, *STRENGTH, *STATED)
    of: str = choice_key(*evidence_keys(WALL), default="", required=True)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of documents that can show its value."""
        return KINDS_THAT_SHOW[asked.shown_by(WALL, self.of)]


@dataclass(frozen=True)
class DemandEvidence(Document):
    """[[demand.evidence]]: the document that shows a value of the demand or of the building. of : its key"""

    kind: str = choice_key(*PRESENCE, *STRENGTH, *STATED)
    of: str = choice_key(*evidence_keys(DEMAND), default="", required=True)

    @property
    def kinds(self) -> tuple[str, ...]:
        """Kinds of documents that can show its value."""
        return KINDS_THAT_SHOW[asked.shown_by(DEMAND, self.of)]


AnyEvidence = WallEvidence | DemandEvidence


def kinds_that_show(section: str, what: str) -> tuple[str, ...]:
    """Kinds of documents that answer for an input: those of a hold are kinds of it. section, what : of its row"""
    own = (*PRESENCE, *STRENGTH)
    return tuple(kind for kind in KINDS_THAT_SHOW[what] if section != asked.HOLD or kind in own)


def is_named(reference: str) -> bool:
    """Whether a reference names a document: it has a letter or a number."""
    return any(letter.isalnum() for letter in reference)


def document_of(evidence: Iterable[AnyEvidence], key: str) -> Document | None:
    """The document that shows the value of a key, None where none is given."""
    return next((entry for entry in evidence if entry.of == key), None)


def check_evidence(evidence: Iterable[AnyEvidence], here) -> None:
    """Raise InputError for a document without a reference, of a kind that cannot show its value, or beside another one
    for the same key. here : place of the section that has them"""
    keys: set[str] = set()
    for entry in evidence:
        if entry.of in keys:
            raise InputError("evidence_twice", place=here, key="of", name=entry.of)
        keys.add(entry.of)
        if entry.kind not in entry.kinds:
            raise InputError(
                "evidence_kind", place=here, key="kind", found=entry.kind, name=entry.of, kinds=entry.kinds
            )
        if not is_named(entry.reference):
            raise InputError("evidence_reference", place=here, key="reference", name=entry.of)
