"""Packages are found by their relations, and cost what their contents are worth."""

import io
import zipfile

import pytest

from core.errors import InputError
from core.ooxml.package import MAX_CELL_TEXT, MAX_ELEMENTS, MAX_PARTS, MAX_TAG, Package, is_workbook
from tests.core.ooxml.writers import RELATIONS, WRITERS, Writer, packed, unpacked, workbook

SIZE = 40_000_000
BOOK = workbook(Writer(), [["a", 1.5]])
SHEET = "xl/worksheets/sheet1.xml"


def with_sheet(xml: str) -> bytes:
    """A workbook with another content of its sheet."""
    return packed({**unpacked(BOOK), SHEET: xml})


@pytest.mark.parametrize("writer", WRITERS.values(), ids=WRITERS)
def test_that_a_workbook_is_known_by_its_relations(writer):
    assert is_workbook(workbook(writer, [["a"]]))


def test_that_an_archive_of_files_is_no_workbook():
    parts = unpacked(BOOK)
    assert not is_workbook(packed({"xl/workbook.xml": b"", "a.txt": b"0.1"}))
    assert not is_workbook(packed({**parts, "A.txt": b"", "a.txt": b""}))
    assert not is_workbook(packed({name: parts[name] for name in parts if "rels" not in name}))
    assert not is_workbook(b"PK\x03\x04" + b"\0" * 60)


@pytest.mark.parametrize(
    ("target", "part"),
    [
        ("/x/a.xml", "x/a.xml"),
        ("a.xml", "xl/a.xml"),
        ("../x/a.xml", "x/a.xml"),
        ("./a.xml", "xl/a.xml"),
        ("..\\x\\a.xml", "x/a.xml"),
        ("A%20b.XML", "xl/a b.xml"),
        ("../../../a.xml", "a.xml"),
    ],
)
def test_that_a_target_is_absolute_or_relative_to_its_source(target, part):
    relation = f'<r:Relationship Id="k" Type="urn:x/worksheet" Target="{target}"/>'
    outside = '<r:Relationship Id="e" Type="urn:x/worksheet" Target="http://x" TargetMode="External"/>'
    relations = f'<r:Relationships xmlns:r="{RELATIONS}">{relation}{outside}</r:Relationships>'
    package = Package(packed({"XL\\_rels\\Book.xml.rels": relations}), SIZE)
    assert package.related("xl/book.xml") == {"k": ("worksheet", part)}
    assert package.related("other.xml") == {}


def test_that_only_the_text_of_an_element_is_handed_over():
    ends = []
    package = Package(packed({"a.xml": "<p:a xmlns:p='u'> <p:b>x&amp;y</p:b>\n <c/> </p:a>"}), SIZE)
    package.parse("a.xml", lambda *_: None, lambda *found: ends.append(found))
    assert ends == [("a", "b", "x&y"), ("a", "c", ""), ("", "a", " ")]


@pytest.mark.parametrize(
    "xml",
    [
        "<a>" + "<b/>" * (MAX_ELEMENTS + 1) + "</a>",
        "<a>" * (MAX_ELEMENTS + 1),
        "<a>" + "x" * (MAX_CELL_TEXT + 1) + "</a>",
        "<a " + " ".join(f'b{k}=""' for k in range(MAX_TAG // 5)) + "/>",
        "<a><!--" + "x" * (2 * MAX_TAG) + "--></a>",
    ],
    ids=["elements", "depth", "text", "attributes", "comment"],
)
def test_that_a_part_that_grows_is_left_where_it_passes_its_bound(xml):
    package = Package(packed({"a.xml": xml}), SIZE)
    with pytest.raises(InputError, match="more parts, cells, texts or formats than can be read"):
        package.parse("a.xml", lambda *_: None)
    assert package.elements <= MAX_ELEMENTS + 1
    assert SIZE - package.left <= len(xml) and len(xml) < SIZE


def test_that_no_more_is_unpacked_than_allowed():
    package = Package(packed({"a.xml": "<a>" + ("<b/>" + " " * 1000) * 6000 + "</a>"}), 1_000_000)
    with pytest.raises(InputError, match="larger than 1 MB:"):
        package.parse("a.xml", lambda *_: None)
    assert package.left < 0


def test_that_a_package_at_its_bounds_is_read(monkeypatch):
    monkeypatch.setattr("core.ooxml.package.MAX_ELEMENTS", 3)
    monkeypatch.setattr("core.ooxml.package.MAX_CELL_TEXT", 2)
    package = Package(packed({"a.xml": "<a><b/><c>xy</c></a>"}), 20)
    package.parse("a.xml", lambda *_: None)
    assert (package.left, package.elements) == (0, 3)


def test_that_a_part_is_stored_or_deflated():
    room = io.BytesIO()
    with zipfile.ZipFile(room, "w", zipfile.ZIP_LZMA) as folder:
        folder.writestr("a.xml", "<a/>")
    with pytest.raises(ValueError, match="compression"):
        Package(room.getvalue(), SIZE).parse("a.xml", lambda *_: None)


def test_that_a_zip_of_countless_members_is_not_listed(monkeypatch):
    content = packed({f"{k}": b"" for k in range(MAX_PARTS + 1)})
    monkeypatch.setattr("zipfile.ZipFile", lambda *_: pytest.fail("it was listed"))
    with pytest.raises(InputError, match="more parts"):
        Package(content, SIZE)


@pytest.mark.parametrize("xml", ['<!DOCTYPE a [<!ENTITY b "c">]><a/>', '<!DOCTYPE a SYSTEM "file:///etc/passwd"><a/>'])
def test_that_a_part_declares_no_entities(xml):
    with pytest.raises(ValueError, match="DOCTYPE"):
        Package(with_sheet(xml), SIZE).parse(SHEET, lambda *_: None)
