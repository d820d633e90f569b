"""Whether a text of the engineer names something, as far as a program can tell."""

import re

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


def _words(text: str) -> list[str]:
    return "".join(letter if letter.isalpha() else " " for letter in text.casefold()).split()
