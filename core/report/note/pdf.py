"""The calculation note as a PDF, and its pages as pictures: set by Typst from resources/templates/note.typ.

Texts go to Typst as data (`sys.inputs`), never as code; the mathematics of a derivation is written by `equation.TYPST`.
"""

import datetime
import difflib
import functools
import io
import json
import re
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from core.errors import InputError, section
from core.packages import require
from core.report.note.equation import IN_PDF, TYPST, rows
from core.report.note.figure_geometry import laid_out
from core.report.note.parts import Bars, Beside, Blanks, Derivation, Figures, Heading, Item, Part, Table
from core.report.words import Words
from core.version import NAME, line

TEMPLATE = Path(__file__).resolve().parents[3] / "resources" / "templates" / "note.typ"

FONT = "New Computer Modern"
"""Font that comes with the program, so that a note is the same on every machine."""

STANDARDS = {"a-3a": ["a-3a", "ua-1"], "a-1b": ["a-1b"]}
"""Standards a PDF is set by, for each choice of [report] pdf_standard."""

NO_DATE = datetime.date(2000, 1, 1)
"""Date of a note that states none, in its properties alone."""

SIGNATURE = 52.0
"""Room above a line to sign on [pt]."""

NUMERIC = re.compile(r"[-−+]?[0-9][0-9.,  ]*(e[-+][0-9]+)?|–")

USUAL_LETTERS = re.compile(
    "[\u0020-\u007e\u00a0-\u017f\u0391-\u03c9\u2009\u2013\u2014\u2018-\u201e\u2022\u2026\u2032]*"
)
"""Letters FONT surely has."""


@dataclass(frozen=True)
class Attachment:
    """A file within a note. relationship : source, data or supplement (PDF/A-3)"""

    name: str
    content: str
    mime: str
    relationship: str
    description: str


@dataclass(frozen=True)
class Office:
    """[report]: whose note it is. logo : a picture, PNG, JPEG or SVG"""

    author: str = ""
    letterhead: tuple[str, ...] = ()
    logo: bytes | None = None


class Note:
    """A note that is ready to be set.

    parts : of content.py; foot : what stands at the foot of each page; date : as [report] has it
    """

    def __init__(
        self,
        parts: Sequence[Part],
        language: str,
        foot: str = "",
        date: str = "",
        office: Office | None = None,
        attachments: Sequence[Attachment] = (),
        font: str = FONT,
    ):
        require("report")
        if font:
            check_font(font)
        self.words, self.office, self.day = Words(language), office or Office(), day_of(date)
        data = {
            "title": next((part.text for part in parts if isinstance(part, Heading)), NAME),
            "author": self.office.author,
            "language": language,
            "font": font or FONT,
            "date": {"year": self.day.year, "month": self.day.month, "day": self.day.day},
            "foot": foot or line(),
            "office": self.words.say("Mark of the office"),
            "letterhead": list(self.office.letterhead),
            "logo": list(self.office.logo) if self.office.logo else None,
            "words": {name: self.words.say(text) for name, text in NOTE_WORDS.items()},
            "parts": [self._part(part) for part in parts],
            "alone": False,
        }
        self.data: dict[str, Any] = legible(data)
        self.attachments = [vars(attachment) | {"type": attachment.mime} for attachment in attachments]
        self.lock = threading.Lock()

    def pdf(self, standard: str = "a-3a") -> bytes:
        """The file; with attachments where its standard takes some. Raises InputError where Typst refuses it."""
        attached = self.attachments if standard == "a-3a" else []
        return self._set(attached, format="pdf", pdf_standards=STANDARDS[standard], timestamp=self._stamp())

    def pages(self, resolution: float) -> list[bytes]:
        """Set each page as PNG. resolution : [dpi]"""
        images = self._again(lambda made: made.compile(format="png", ppi=resolution))
        return images if isinstance(images, list) else [images]

    def places(self) -> list[dict[str, Any]]:
        """Places of the marks: page from 1, y from the top [pt], and what each leads to."""
        return json.loads(self._again(lambda made: made.eval(LEADS_QUERY)))

    def lines(self) -> list[tuple[int, float, str]]:
        """Lines of the pages: page from 1, y of the line from the top [pt], its text."""
        import pypdf

        placed_lines: list[tuple[int, float, str]] = []
        content = self._again(lambda made: made.compile(format="pdf", timestamp=self._stamp()))
        reader = pypdf.PdfReader(io.BytesIO(content))
        for number, page in enumerate(reader.pages, start=1):
            tall, of_page = float(page.mediabox.height), dict[float, str]()

            def seen(text, matrix, placed, *_, tall=tall, of_page=of_page):
                y = round(tall - (placed[5] * matrix[3] + matrix[5]), 1)
                of_page[y] = of_page.get(y, "") + text.replace("\n", "")

            page.extract_text(visitor_text=seen)
            placed_lines += [(number, y, text) for y, text in sorted(of_page.items()) if text.strip()]
        return placed_lines

    def _stamp(self) -> int:
        return int(datetime.datetime.combine(self.day, datetime.time(), datetime.UTC).timestamp())

    def _given(self, attachments) -> dict[str, Any]:
        data = json.dumps(self.data | {"attachments": attachments}, ensure_ascii=False)
        own = self.data["font"] == FONT and USUAL_LETTERS.fullmatch(_texts(self.data)) is not None
        return {"sys_inputs": {"data": data}, "ignore_system_fonts": own}

    @functools.cached_property
    def _compiler(self) -> Any:
        """Typst on this note without attachments: what it has laid out once serves pages of another size and marks."""
        import typst

        return typst.Compiler(str(TEMPLATE), **self._given([]))

    def _again(self, work: Callable[[Any], Any]) -> Any:
        """What `work(compiler)` gives; a compiler serves one thread at a time. Raises InputError as `pdf`."""
        import typst

        with self.lock:
            try:
                return work(self._compiler)
            except typst.TypstError as error:
                raise InputError("note_not_set", reason=error.message) from None

    def _set(self, attachments, **how) -> Any:
        import typst

        try:
            return typst.compile(_template(), **self._given(attachments), **how)
        except typst.TypstError as error:
            raise InputError("note_not_set", reason=error.message) from None

    def _part(self, part: Part) -> dict[str, Any]:
        """A part as the template takes it: its kind and its fields, and what follows from them."""
        given = {"kind": type(part).__name__.lower()} | {
            entry.name: getattr(part, entry.name) for entry in fields(part)
        }
        match part:
            case Heading():
                outlined = part.listed and part.level == 2
                return given | {"outlined": outlined, "target": None if part.wall is None else {"wall": part.wall}}
            case Item():
                return given | {"sign": BOXES.get(part.sign, part.sign)}
            case Table():
                columns = list(zip(*part.rows, strict=True)) or [()] * len(part.widths)
                return given | {
                    "tones": {f"{n},{k}": tone for (n, k), tone in part.tones.items()},
                    "right": [bool(cells) and all(map(NUMERIC.fullmatch, cells)) for cells in columns],
                    "targets": [{"wall": wall} for wall in part.walls],
                }
            case Bars():
                names = ("name", "clause", "value", "tone", "decides", "written")
                rows = [(n, c, z or 0.0, *rest, self.words.number(z, ".2f")) for n, c, z, *rest in part.rows]
                return given | {"rows": [dict(zip(names, row, strict=True)) for row in rows]}
            case Derivation():
                short = all(step.quantity is None or not step.formula for step in part.steps)
                return given | {"steps": [self._step(step) for step in part.steps], "short": short}
            case Figures():
                return given | {"figures": [laid_out(figure, self.words, len(part.figures)) for figure in part.figures]}
            case Beside():
                drawn = None if part.figure is None else laid_out(part.figure, self.words, ABREAST_OF_TEXT)
                return given | {"parts": [self._part(one) for one in part.parts], "figure": drawn}
            case Blanks():
                return given | {"height": SIGNATURE}
        return given

    def _step(self, step) -> dict[str, Any]:
        language = self.words.language
        equation = " \\ = ".join("= ".join(row) for row in rows(step, language, TYPST, IN_PDF))
        alt = f"{step.written(language)} = {step.result_written(language)} {step.unit.replace('–', '')}".strip()
        return {"math": equation, "alt": alt, "label": step.label, "clause": step.clause}


ABREAST_OF_TEXT = 4
"""A drawing beside parts has the size of one of so many figures."""

NOTE_WORDS = {"page": "page", "fig": "Fig."}

LEADS_QUERY = "query(<leads>).map(m => (..m.value, page: m.location().page(), y: m.location().position().y.pt()))"
"""Query by which the template is asked for its marks."""

BOXES = {"☑": "ticked", "☐": "open"}
"""Signs that the template draws as boxes."""


def picture(figure, words: Words, resolution: float = 300.0) -> bytes:
    """A figure alone as PNG."""
    made = Note((Figures([figure]),), words.language)
    made.data["alone"] = True
    return made.pages(resolution)[0]


@functools.cache
def _template() -> bytes:
    return TEMPLATE.read_bytes()


@functools.lru_cache(16)
def check_font(font: str) -> None:
    """Raise InputError for a font this machine has not."""
    import typst

    known = sorted(set(typst.Fonts().families()))
    if font not in known:
        near = difflib.get_close_matches(font, known, 5) or known[:5]
        raise InputError("no_font", key="font", font=font, known=", ".join(near), place=(section("[report]"),))


def day_of(date: str) -> datetime.date:
    """The day of [report] date, as 2026-11-25 or 25/11/2026; NO_DATE of any other text."""
    for form in ("%Y-%m-%d", "%d/%m/%Y", "%d.%m.%Y", "%d-%m-%Y"):
        try:
            return datetime.datetime.strptime(date.strip(), form).date()
        except ValueError:
            continue
    return NO_DATE


def _texts(value: Any) -> str:
    """All texts in it, one after the other."""
    if isinstance(value, str):
        return value
    if isinstance(value, dict):
        return "".join(map(_texts, value.values()))
    return "".join(map(_texts, value)) if isinstance(value, list) and value and not isinstance(value[0], int) else ""


def legible(value: Any) -> Any:
    """Replace each letter that no font shows by its code, as U+0001, in every text of a value: PDF/A takes no letter
    without a shape."""
    strange = sorted(set(USUAL_LETTERS.sub("", _texts(value))))
    codes = {letter: f"U+{ord(letter):04X}" for letter in strange if not _is_shown(letter)}
    return _replaced(value, str.maketrans(codes)) if codes else value


def _replaced(value: Any, codes: dict) -> Any:
    if isinstance(value, str):
        return value.translate(codes)
    if isinstance(value, dict):
        return {key: _replaced(entry, codes) for key, entry in value.items()}
    if isinstance(value, list) and value and not isinstance(value[0], int):
        return [_replaced(entry, codes) for entry in value]
    return value


@functools.lru_cache(4096)
def _is_shown(letter: str) -> bool:
    """Whether a font of this machine has a letter."""
    import typst

    if not letter.isprintable() and letter not in "\n\t":
        return False
    source = b'#set text(font: sys.inputs.font, lang: "en")\n#set document(title: "-")\n#("a" + sys.inputs.letter)'
    try:
        typst.compile(source, format="pdf", pdf_standards=["a-3a"], sys_inputs={"letter": letter, "font": FONT})
    except typst.TypstError:
        return False
    return True
