"""The wording of every text a person reads, by group and code: (English, Italian)."""

from core.text.channel_errors import CHANNEL_ERRORS
from core.text.demand_errors import DEMAND_ERRORS
from core.text.error_parts import ACCEPTED, PLACES
from core.text.errors import CASE_ERRORS
from core.text.file_errors import FILE_ERRORS
from core.text.keys import CHOICES, KEYS, SECTIONS
from core.text.load_errors import LOAD_ERRORS
from core.text.method import METHOD_BODIES, METHOD_LABELS
from core.text.note import NOTE
from core.text.notices import SENTENCES as NOTICES
from core.text.report import REPORT
from core.text.study import STUDY
from core.text.terminal import TERMINAL
from core.text.verdicts import ADDED, MISSING_WORDS, REASONS, SHORT
from core.text.verdicts import SENTENCES as VERDICTS
from core.text.window import WINDOW
from core.text.window_charts import WINDOW_CHARTS
from core.text.window_forms import WINDOW_FORMS
from core.text.window_help import WINDOW_HELP
from core.text.words import ASSUMPTIONS, LOADS, WORDS


def _by_english(texts: dict[str, str]) -> dict[str, tuple[str, str]]:
    """Texts whose code is their English wording."""
    return {english: (english, italian) for english, italian in texts.items()}


CATALOGUE: dict[str, dict[str, tuple[str, str]]] = {
    "error": {**CASE_ERRORS, **DEMAND_ERRORS, **FILE_ERRORS, **CHANNEL_ERRORS, **LOAD_ERRORS},
    "place": PLACES,
    "accepted": ACCEPTED,
    "notice": NOTICES,
    "word": {**WORDS, **LOADS, **KEYS, **SECTIONS, **CHOICES},
    "assumption": ASSUMPTIONS,
    "verdict": VERDICTS,
    "added": ADDED,
    "reason": REASONS,
    "missing": MISSING_WORDS,
    "short": SHORT,
    "method_label": METHOD_LABELS,
    "method_body": METHOD_BODIES,
    "report": _by_english({**STUDY, **REPORT, **NOTE}),
    "window": _by_english({**WINDOW, **WINDOW_FORMS, **WINDOW_CHARTS, **WINDOW_HELP}),
    "terminal": _by_english(TERMINAL),
}
