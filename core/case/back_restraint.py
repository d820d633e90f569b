"""What stands behind a wall, or holds its top: one of a list, with what shows it. It was a free text before 0.16."""

import re

RESTRAINTS = ("cross_walls", "tied_floors", "buttress", "ring_beam", "other")
"""What can hold a wall. Behind a one-sided wall contact is what counts, for one held at its top the connection."""

EVIDENCE = ("drawing", "photograph", "opening", "test", "none")
"""What shows that it is there."""

OLD_WORDS = {
    "cross_walls": (
        *("cross wall", "transverse wall", "return wall", "longitudinal wall", "side wall", "partition"),
        *("pareti trasversali", "parete trasversale", "pareti ortogonali", "parete ortogonale", "setti", "setto"),
        *("muri trasversali", "muro trasversale", "muri ortogonali", "muri di spina", "muri longitudinali", "spina"),
    ),
    "tied_floors": ("floor", "roof", "vault", "solai", "solaio", "tetto", "copertura", "volta", "volte", "impalcat"),
    "buttress": ("buttress", "contraffort", "speron"),
    "ring_beam": ("ring beam", "cordolo", "cordoli", "tie beam"),
}
"""Words by which an older text is one of the list; any other that names something is \"other\"."""

DENIALS = (
    *("not", "no", "none", "without", "missing", "absent", "lacking", "never", "unknown", "undefined", "tbd", "todo"),
    *("non", "nessun", "nessuno", "nessuna", "senza", "manca", "mancano", "assente", "assenti", "ignoto", "boh"),
    *("definire", "verificare", "confermare", "defined", "verified", "confirmed", "checked"),
)
"""Words of a text that says there is nothing, or nothing known."""


BETWEEN = "cross_walls", "buttress"
"""Restraints that hold a wall only where they stand."""


def holds_only_there(restraint: str | None, note: str) -> bool:
    """Whether what holds a wall is one of BETWEEN, or another thing whose note names cross walls."""
    named = restraint == "other" and any(word in note.casefold() for word in OLD_WORDS["cross_walls"])
    return restraint in BETWEEN or named


def upgrade_restraint_keys(table: dict) -> dict:
    """The keys of a wall with an older text of back_restraint as one of RESTRAINTS and, unless a note is given, the
    text as its note; a text that names nothing is left as it is, and refused as no choice."""
    said = table.get("back_restraint")
    if not isinstance(said, str) or said in RESTRAINTS:
        return table
    if not said.strip():
        return {key: value for key, value in table.items() if key != "back_restraint"}
    words = said.casefold()
    parts = "".join(letter if letter.isalnum() else " " for letter in words).split()
    if set(parts) & set(DENIALS) or not is_meaningful(said):
        return table
    choice = next((name for name, known in OLD_WORDS.items() if any(one in words for one in known)), "other")
    return {"restraint_note": said, **table, "back_restraint": choice}


_GONE = re.compile(r"\b(?:crollat|demolit|rimoss|inesistent|collapsed|demolished|removed)\w*", re.IGNORECASE)
MAX_SHORT_WORDS = 3
"""Words of a note that are too few to speak of anything else than what holds the wall."""

_CITED = re.compile(
    r"\b(?:report|relazione|prova|prove|test|circolare|ntc|norma|normativa|code|legge|law|tab)\b", re.IGNORECASE
)
"""A document that is cited by its number."""


_FILLERS = """
    none nothing nobody unknown tbd tbc todo null nd na not no yes ok test nessuno nessuna nessun niente nulla ignoto
    sconosciuto si va bene prova boh mah restraint without restrained connected unconnected free vincolo vincolata
    vincolato senza non collegata collegato libera libero lo so la il i di del della da definire verificare confermare
    to be defined verified confirmed checked know vedi sopra see above relazione report come prassi as usual per from by
    norma normativa code ntc circolare legge law secondo esperienza experience mia my own professionale professional
    giudizio judgement judgment progettista engineer scelta choice ipotesi assumption assunto assumed valore value
    later dopo poi ora adesso così cosi now soon presto bozza draft provvisorio temporary temporaneo controllare check
    usuale solito asd asdf qwe qwerty bla xxx lorem ipsum dont don t n d e and the a of in on an at is it
"""
FILLERS = frozenset(_FILLERS.split())
"""Words that say nothing, alone or with one another."""

MIN_LETTERS = 3
"""Letters, and different ones, of a text that names something."""


def is_meaningful(text: str) -> bool:
    """Whether a text names something, as far as a program can tell."""
    letters = [letter for letter in text.casefold() if letter.isalpha()]
    several = len(letters) >= MIN_LETTERS and len(set(letters)) >= MIN_LETTERS
    cited = any(map(str.isdigit, text)) and _CITED.search(text)
    return several and (bool(cited) or not FILLERS.issuperset(_words(text)))


def denies_restraint(note: str) -> bool:
    """Whether a note says no more than that what holds the wall is not there."""
    return len(_words(note)) <= MAX_SHORT_WORDS and bool(_GONE.search(note))


def _words(text: str) -> list[str]:
    return "".join(letter if letter.isalpha() else " " for letter in text.casefold()).split()
