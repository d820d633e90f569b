"""Workbooks as the programs write them that offices use: the same cells, another XML."""

import io
import zipfile
from dataclasses import dataclass
from xml.sax.saxutils import escape, quoteattr

MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
STRICT = "http://purl.oclc.org/ooxml/spreadsheetml/main"
STRICT_OFFICE = "http://purl.oclc.org/ooxml/officeDocument/relationships"
RELATIONS = "http://schemas.openxmlformats.org/package/2006/relationships"
TYPES = "http://schemas.openxmlformats.org/package/2006/content-types"


@dataclass(frozen=True)
class Formula:
    """A formula and its value, None where no program computed it."""

    text: str
    value: float | None = None


@dataclass(frozen=True)
class Fault:
    """An error value of Excel."""

    text: str


@dataclass(frozen=True)
class Day:
    """A number that is shown as a date."""

    number: float


@dataclass(frozen=True)
class Writer:
    """How a program writes.

    prefix : of the elements of a sheet
    book : part of the workbook; sheet : part of a sheet by its number n, or by "only", "" for the first
    absolute : targets of relations begin at the root
    texts : shared, inline, or str (text as the value of the cell, as programmers write it)
    places : whether rows and cells say where they are
    spoken : attributes of a row that say what is not so
    """

    prefix: str = ""
    book: str = "xl/workbook.xml"
    sheet: str = "xl/worksheets/sheet{n}.xml"
    absolute: bool = False
    texts: str = "shared"
    places: bool = True
    spoken: str = ""
    spaces: tuple[str, str] = (MAIN, OFFICE)


WRITERS = {
    "Excel": Writer(),
    "Excel, strict": Writer(spaces=(STRICT, STRICT_OFFICE)),
    "Open XML SDK": Writer("x:", sheet="xl/worksheets/sheet{n}.xml", absolute=True, texts="str"),
    "ClosedXML": Writer("x:", sheet="xl/worksheets/sheet{only}.xml", absolute=True),
    "LibreOffice": Writer(spoken=' customFormat="false" ht="12.8" hidden="false" customHeight="false"'),
    "Google": Writer(spoken=' ht="15.75" customHeight="1"'),
    "a stream writer": Writer(texts="inline", places=False),
    "a bank": Writer("s:", "Book/Main.xml", "Book/Tabellen/Blatt {n}.bin.xml", texts="inline"),
}


def letters(column: int) -> str:
    name = ""
    while column:
        column, rest = divmod(column - 1, 26)
        name = chr(65 + rest) + name
    return name


def workbook(writer: Writer, rows, merged=(), hidden_rows=(), hidden_columns=(), others=(), state="visible") -> bytes:
    """The file of a sheet with these rows, after the hidden ones of others: pairs of name and rows.

    merged : areas, "A1:B1"; hidden_rows, hidden_columns : numbers from 1
    """
    sheets = [("Foglio 1", rows, state)] + [(name, cells, "hidden") for name, cells in others]
    shared: list[str] = []
    bodies = []
    for k, (_, cells, _) in enumerate(sheets):
        own = (merged, hidden_rows, hidden_columns) if k == 0 else ((), (), ())
        bodies.append(_sheet(writer, cells, shared, *own))
    p, (main, office) = writer.prefix, writer.spaces
    space = f'xmlns{":" + p[:-1] if p else ""}="{main}" xmlns:r="{office}"'
    head = '<?xml version="1.0" encoding="utf-8"?>'
    names = [writer.sheet.format(n=n, only="" if n == 1 else n) for n in range(1, len(sheets) + 1)]
    listed = "".join(
        f'<{p}sheet name={quoteattr(name)} sheetId="{n}" state="{shown}" r:id="R{n}cafe"/>'
        for n, (name, _, shown) in enumerate(sheets, start=1)
    )
    folder = writer.book.rpartition("/")[0]

    def target(part: str) -> str:
        part = part.replace(" ", "%20")
        return "/" + part if writer.absolute else part.removeprefix(folder + "/")

    related = {f"R{n}cafe": ("worksheet", name) for n, name in enumerate(names, start=1)}
    related |= {"t1": ("sharedStrings", f"{folder}/sharedStrings.xml")} if shared else {}
    related["s1"] = ("styles", f"{folder}/styles.xml")
    relations = "".join(
        f'<Relationship Target="{target(part)}" Type="{office}/{kind}" Id="{key}"/>'
        for key, (kind, part) in reversed(related.items())
    )
    texts = "".join(f"<{p}si><{p}t xml:space='preserve'>{escape(one)}</{p}t></{p}si>" for one in shared)
    kinds = {
        writer.book: "sheet.main",
        **dict.fromkeys(names, "worksheet"),
        f"{folder}/styles.xml": "styles",
        f"{folder}/sharedStrings.xml": "sharedStrings",
    }
    types = "".join(
        f'<Override PartName="/{part}" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.'
        f'{kind}+xml"/>'
        for part, kind in kinds.items()
    )
    types += '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
    parts = {
        "[Content_Types].xml": f'{head}<Types xmlns="{TYPES}">{types}</Types>',
        "_rels/.rels": f'{head}<Relationships xmlns="{RELATIONS}"><Relationship Id="b" Type="{office}/officeDocument" '
        f'Target="{"/" if writer.absolute else ""}{writer.book}"/></Relationships>',
        writer.book: f"{head}<{p}workbook {space}><{p}sheets>{listed}</{p}sheets></{p}workbook>",
        f"{folder}/_rels/{writer.book.rpartition('/')[2]}.rels": f'{head}<Relationships xmlns="{RELATIONS}">'
        f"{relations}</Relationships>",
        f"{folder}/sharedStrings.xml": f"{head}<{p}sst {space}>{texts}</{p}sst>",
        f"{folder}/styles.xml": f'{head}<{p}styleSheet {space}><{p}numFmts><{p}numFmt numFmtId="164" '
        f'formatCode="0.00&quot; m (s)&quot;"/><{p}numFmt numFmtId="165" formatCode="[$-410]dd/mm/yyyy"/></{p}numFmts>'
        f'<{p}cellXfs><{p}xf numFmtId="0"/><{p}xf numFmtId="164"/><{p}xf numFmtId="165"/><{p}xf numFmtId="14"/>'
        f"</{p}cellXfs></{p}styleSheet>",
    }
    parts |= dict(zip(names, (f"{head}<{p}worksheet {space}>{b}</{p}worksheet>" for b in bodies), strict=True))
    return packed(parts)


def packed(parts: dict) -> bytes:
    """A zip of these members."""
    room = io.BytesIO()
    with zipfile.ZipFile(room, "w", zipfile.ZIP_DEFLATED) as folder:
        for name, content in parts.items():
            folder.writestr(name, content)
    return room.getvalue()


def unpacked(content: bytes) -> dict[str, bytes]:
    """The members of a zip."""
    with zipfile.ZipFile(io.BytesIO(content)) as folder:
        return {name: folder.read(name) for name in folder.namelist()}


def _sheet(writer: Writer, rows, shared: list[str], merged, hidden_rows, hidden_columns) -> str:
    p = writer.prefix
    hidden = "true" if "false" in writer.spoken else "1"
    columns = "".join(f'<{p}col min="{k}" max="{k}" width="9" hidden="{hidden}"/>' for k in hidden_columns)
    body = f"<{p}cols>{columns}</{p}cols>" if columns else ""
    body += f"<{p}sheetData>"
    for n, row in enumerate(rows, start=1):
        place = f' r="{n}"' if writer.places else ""
        said = writer.spoken.replace('hidden="false"', "") if n in hidden_rows else writer.spoken
        said += f' hidden="{hidden}"' if n in hidden_rows else ""
        cells = ""
        for k, value in enumerate(row, start=1):
            if value is not None or not writer.places:
                where = f' r="{letters(k)}{n}"' if writer.places else ""
                cells += _cell(writer, value, where, shared)
        body += f"<{p}row{place}{said}>{cells}</{p}row>\n"
    body += f"</{p}sheetData>"
    if merged:
        areas = "".join(f"<{p}mergeCell ref='{area}'/>" for area in merged)
        body += f'<{p}mergeCells count="{len(merged)}">{areas}</{p}mergeCells>'
    return body


def _cell(writer: Writer, value, where: str, shared: list[str]) -> str:
    p = writer.prefix

    def cell(inside: str, kind: str = "") -> str:
        return f"<{p}c{where}{kind}>{inside}</{p}c>"

    if value is None:
        return f"<{p}c{where}/>"
    if isinstance(value, Formula):
        known = "" if value.value is None else f"<{p}v>{value.value!r}</{p}v>"
        return cell(f"<{p}f>{escape(value.text)}</{p}f>{known}")
    if isinstance(value, Fault):
        return cell(f"<{p}v>{value.text}</{p}v>", ' t="e"')
    if isinstance(value, Day):
        return cell(f"<{p}v>{value.number!r}</{p}v>", ' s="2"')
    if isinstance(value, bool):
        return cell(f"<{p}v>{int(value)}</{p}v>", ' t="b"')
    if not isinstance(value, str):
        return cell(f"<{p}v>{value!r}</{p}v>", ' s="1"')
    if writer.texts == "inline":
        return cell(f"<{p}is><{p}t>{escape(value)}</{p}t></{p}is>", ' t="inlineStr"')
    if writer.texts == "str":
        return cell(f"<{p}v>{escape(value)}</{p}v>", ' t="str"')
    shared.append(value)
    return cell(f"<{p}v>{len(shared) - 1}</{p}v>", ' t="s"')
