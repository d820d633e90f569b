"""The calculation note as a Word document (.docx), figures included: it goes into an office's own note.

python-docx, because a docx is what an office edits; its pictures are those of the PDF.
"""

import io
from xml.etree import ElementTree

from core.packages import require
from core.report.note.equation import MAX_LINE, equations, width
from core.report.note.parts import Bars, Blanks, Box, Derivation, Figures, Heading, Item, Paragraph, Part, Table
from core.report.note.pdf import picture
from core.report.steps import Steps
from core.report.words import Words
from core.report.xml_text import escape_for_xml
from core.version import NAME

COLORS = {
    "ink": "#1F2D3D",
    "quiet": "#6B7785",
    "accent": "#2B5C8A",
    "good": "#1B6E4B",
    "amber": "#8A5A00",
    "bad": "#A6192E",
}
TEXT_WIDTH_CM = 17.0
"""Width of the text of an A4 page [cm]."""

CELL_LETTER_WIDTH, MARGINS = 0.21, 0.4
"""Width of a bold letter of a cell, and of both margins of a cell [cm]."""

BLANKS = 105
"""Letters of a line of blanks to fill in."""


def document(parts: list[Part], language: str, steps: Steps | None = None, subject: str = "") -> bytes:
    """The docx file. subject : what it is of, at most 255 letters. Raises OutputError where the packages of the group
    `report` are not installed."""
    require("report")
    import docx

    made = docx.Document()
    writer = _Writer(made, Words(language), steps or Steps())
    for part in writer.steps.each(escape_for_xml(parts)):
        writer.add(part)
    about = made.core_properties
    about.author = about.last_modified_by = NAME
    about.subject = subject
    content = io.BytesIO()
    made.save(content)
    return content.getvalue()


def widths_of(part: Table) -> list[float]:
    """Widths of the columns [cm] in proportion to those asked, each as wide as its longest word, where there is room:
    an office parts "0,45" in a narrower one."""
    whole = sum(part.widths)
    asked = [TEXT_WIDTH_CM * width / whole for width in part.widths]
    words = (
        [len(word) for row in (part.heads, *part.rows) if row for word in row[k].split()] for k in range(len(asked))
    )
    least = [MARGINS + CELL_LETTER_WIDTH * max(lengths, default=0) for lengths in words]
    lacking = sum(max(0.0, need - size) for need, size in zip(least, asked, strict=True))
    room = sum(max(0.0, size - need) for need, size in zip(least, asked, strict=True))
    taken = min(1.0, lacking / room) if room > 0.0 else 0.0
    given = min(1.0, room / lacking) if lacking > 0.0 else 0.0
    return [size + (need - size) * (given if need > size else taken) for need, size in zip(least, asked, strict=True)]


class _Writer:
    """Puts parts into a document, one after the other."""

    def __init__(self, made, words: Words, steps: Steps):
        from docx.shared import Cm, Pt, RGBColor

        self.made, self.words, self.steps = made, words, steps
        self.cm, self.pt, self.rgb = Cm, Pt, RGBColor
        self.figures = 0
        section = made.sections[0]
        section.page_width, section.page_height = Cm(21.0), Cm(29.7)
        section.left_margin = section.right_margin = Cm(2.0)
        section.top_margin, section.bottom_margin = Cm(1.6), Cm(1.6)
        made.styles["Normal"].font.size = Pt(9.5)
        made.styles["Normal"].paragraph_format.space_after = Pt(2)

    def add(self, part: Part) -> None:
        if isinstance(part, Heading):
            heading = self.made.add_heading(part.text, part.level)
            heading.paragraph_format.page_break_before = part.new_page
        elif isinstance(part, Paragraph):
            self._run(self.made.add_paragraph(), part.text, part.tone)
        elif isinstance(part, Item):
            self._run(self.made.add_paragraph(), f"{part.sign}  {part.text}", part.tone)
        elif isinstance(part, Bars):
            number = self.words.number
            rows = [[name, number(zeta, ".2f"), clause] for name, clause, zeta, _, _ in part.rows]
            tones = {(n, 1): tone for n, (*_, tone, _) in enumerate(part.rows)}
            self._table(Table([self.words.say("Check"), "ζ", self.words.say("Clause")], rows, (3, 1, 2), tones))
        elif isinstance(part, Table):
            self._table(part)
        elif isinstance(part, Derivation):
            self._derivation(part.steps)
        elif isinstance(part, Figures):
            self._figures(part.figures)
        elif isinstance(part, Box):
            table = self.made.add_table(1, 1, style="Table Grid")
            table.cell(0, 0).text = "\n" * (part.lines - 1)
        elif isinstance(part, Blanks):
            room = BLANKS - sum(len(label) + 6 for label in part.labels)
            line = "_" * (room // len(part.labels))
            self.made.add_paragraph("\n" + "     ".join(f"{label} {line}" for label in part.labels))

    def _run(self, paragraph, content: str, tone: str = "", size: float | None = None) -> None:
        run = paragraph.add_run(content)
        run.bold = tone in ("strong", "good", "amber", "bad")
        if tone in COLORS:
            run.font.color.rgb = self.rgb.from_string(COLORS[tone][1:])
        if size:
            run.font.size = self.pt(size)

    def _cells(self, table, widths) -> None:
        table.autofit = False
        whole = sum(widths)
        sizes = [self.cm(TEXT_WIDTH_CM * width / whole) for width in widths]
        for column, size in zip(table.columns, sizes, strict=True):
            column.width = size
        for row in table.rows:  # `column.cells` makes the whole table anew for each column
            for cell, size in zip(row.cells, sizes, strict=True):
                cell.width = size

    def _table(self, part: Table) -> None:
        plain = not part.heads
        rows = len(part.rows) + (0 if plain else 1)
        table = self.made.add_table(rows, len(part.widths), style="Normal Table" if plain else "Table Grid")
        self._cells(table, widths_of(part))
        lines = iter(table.rows)  # an index would count them from the first each time
        if not plain:
            head_row = next(lines)
            for cell, head in zip(head_row.cells, part.heads, strict=True):
                self._run(cell.paragraphs[0], head, "strong", 8.5)
            self._repeat(head_row)
        for n, (line, row) in enumerate(self.steps.each(zip(lines, part.rows, strict=True))):
            cells = line.cells
            for k, content in enumerate(row):
                tone = part.tones.get((n, k), "quiet" if plain and k == 0 else "")
                self._run(cells[k].paragraphs[0], content, tone, 9 if plain else 8.5)

    def _repeat(self, row) -> None:
        """A header row that comes again on the next page."""
        from docx.oxml import OxmlElement

        row._tr.get_or_add_trPr().append(OxmlElement("w:tblHeader"))

    def _derivation(self, steps) -> None:
        from docx.oxml import OxmlElement, parse_xml

        table = self.made.add_table(len(steps), 3, style="Normal Table")
        self._cells(table, (11.0, 3.6, 2.4))
        for row, step in zip(table.rows, steps, strict=True):
            row._tr.get_or_add_trPr().append(OxmlElement("w:cantSplit"))
            written = equations(step, self.words.language)
            lines = [parse_xml(line) for line in written]
            place, second, third = row.cells[0], *(cell.paragraphs[0] for cell in row.cells[1:])
            wide = any(width(ElementTree.fromstring(line)) > MAX_LINE for line in written)
            if wide:  # label and clause stand below
                place = place.merge(row.cells[2])
                for paragraph in place.paragraphs[1:]:
                    paragraph._p.getparent().remove(paragraph._p)
            place.paragraphs[0]._p.append(lines[0])
            for line in lines[1:]:
                place.add_paragraph()._p.append(line)
            if wide:
                self._run(place.add_paragraph(), f"{step.label} {step.clause}".strip(), "quiet", 8)
                continue
            if step.label:
                self._run(second, step.label, "quiet", 8)
            self._run(third, step.clause, "quiet", 8)

    def _figures(self, figures) -> None:
        table = self.made.add_table(2, len(figures), style="Normal Table")
        self._cells(table, [1.0] * len(figures))
        for k, figure in enumerate(self.steps.each(figures)):
            self.figures += 1
            run = table.cell(0, k).paragraphs[0].add_run()
            run.add_picture(
                io.BytesIO(picture(figure, self.words)), width=self.cm((TEXT_WIDTH_CM - 0.5) / max(2, len(figures)))
            )
            caption = f"Fig. {self.figures}. {figure.caption}"
            self._run(table.cell(1, k).paragraphs[0], caption, "quiet", 8)
        self.made.add_paragraph()
