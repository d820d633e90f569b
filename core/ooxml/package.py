"""Packages of Office Open XML (ECMA-376-2): parts found by their relations, read as a stream within bounds.

Names of elements are local names: a writer chooses its prefixes (`x:row`), the names of its parts, and whether the
targets of its relations are absolute.
"""

import io
import posixpath
import zipfile
import zlib
from collections.abc import Callable
from urllib.parse import unquote
from xml.parsers import expat

from core.errors import InputError

MEMBER = b"PK\x01\x02"
"""How the entry of a member begins in the list of a zip: counted before the list is made."""

MAX_PARTS = 2000
"""Members of a package; a workbook of a hundred sheets with charts has some hundreds."""

MAX_ELEMENTS = 600_000
"""Elements of all the parts that are read: three for a cell, and as many for each text or format."""

MAX_CELL_TEXT = 200_000
"""Characters of a text; a cell of Excel holds 32 767."""

MAX_TAG = 1_000_000
"""Bytes of a tag or a comment, which the parser looks at anew with each piece until it ends."""

PART_CHUNK = 1 << 16
"""Bytes handed to the parser at a time."""

MAX_RELATIONS = 2_000_000
"""Bytes of the relations of a package and its workbook."""

COMPRESSED = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""Compression methods that members of a package may have (ECMA-376-2, C.3.3); of the others each raises errors of its
own."""

DAMAGED = (
    zipfile.BadZipFile,
    zlib.error,
    expat.ExpatError,
    EOFError,
    NotImplementedError,
    RuntimeError,
    OSError,
    ValueError,
    LookupError,
    OverflowError,
    TypeError,
)
"""Errors that a damaged or hostile package raises."""

# callbacks of `Package.parse`
Start = Callable[[str, str, dict[str, str]], None]
End = Callable[[str, str, str], None]


class Package:
    """The parts of a package. Raises InputError for what cannot be one.

    content : the bytes of the file
    max_bytes : of all that is read, unpacked
    """

    def __init__(self, content: bytes, max_bytes: int):
        self.max_bytes, self.left, self.elements = max_bytes, max_bytes, 0
        if content.count(MEMBER) > MAX_PARTS:
            raise InputError("workbook_too_large")
        self.folder = zipfile.ZipFile(io.BytesIO(content))
        self.parts: dict[str, zipfile.ZipInfo] = {}
        for entry in self.folder.infolist():
            name = _key(entry.filename)
            if self.parts.setdefault(name, entry) is not entry:
                raise ValueError("part")

    def related(self, source: str = "") -> dict[str, tuple[str, str]]:
        """Id of each relation of a part -> (last word of its type, the part it leads to). source : "" for the package
        itself; a part without relations has none, and what lies outside the package is left out."""
        folder, _, name = _key(source).rpartition("/")
        held = posixpath.join(folder, "_rels", f"{name}.rels")
        relations = {}

        def start(parent: str, name: str, attributes: dict[str, str]) -> None:
            if name == "Relationship" and attributes.get("TargetMode") != "External":
                target = _key(posixpath.join("/", folder, attributes["Target"].replace("\\", "/")))
                relations[attributes["Id"]] = (attributes["Type"].rpartition("/")[2], target)

        if held in self.parts:
            self.parse(held, start)
        return relations

    def one(self, source: str, kind: str) -> str | None:
        """The part a relation of this type leads to from another, None without one."""
        return next((part for word, part in self.related(source).values() if word == kind), None)

    def parse(self, part: str, start: Start, end: End = lambda parent, name, text: None) -> None:
        """Hand each element of a part over, in the order of the file.

        start(parent, name, attributes) : local names of the elements; attributes that have a prefix are named by
            their namespace as well, see `local_name`
        end(parent, name, text) : the text of the element, behind the last one within it
        """
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text, parser.buffer_size = True, PART_CHUNK
        local: dict[str, str] = {}
        stack, text = [""], ""

        def opened(full: str, attributes: dict[str, str]) -> None:
            nonlocal text
            self.elements += 1
            if self.elements > MAX_ELEMENTS:
                raise InputError("workbook_too_large")
            name = local.get(full) or local.setdefault(full, local_name(full))
            start(stack[-1], name, attributes)
            stack.append(name)
            text = ""

        def closed(full: str) -> None:
            nonlocal text
            name = stack.pop()
            end(stack[-1], name, text)
            text = ""

        def written(piece: str) -> None:
            nonlocal text
            text += piece
            if len(text) > MAX_CELL_TEXT:
                raise InputError("workbook_too_large")

        def refused(*_) -> None:  # entities that grow, files outside
            raise ValueError("DOCTYPE")

        parser.StartElementHandler, parser.EndElementHandler = opened, closed
        parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = written, refused
        read, entry = 0, self.parts[_key(part)]
        if entry.compress_type not in COMPRESSED:
            raise ValueError("compression")
        with self.folder.open(entry) as stream:
            while piece := stream.read(PART_CHUNK):
                self.left -= len(piece)
                if self.left < 0:
                    raise InputError("workbook_unpacked", mb=self.max_bytes / 1e6)
                parser.Parse(piece, False)
                read += len(piece)
                if read - parser.CurrentByteIndex > MAX_TAG:
                    raise InputError("workbook_too_large")
        parser.Parse(b"", True)


def _key(name: str) -> str:
    """A name of a part or of a member as it is compared: without case, from the root."""
    return posixpath.normpath("/" + unquote(name.replace("\\", "/"))).lstrip("/").casefold()


def local_name(full: str) -> str:
    """The name of an element or attribute without its namespace."""
    return full.rpartition(" ")[2]


def is_workbook(content: bytes) -> bool:
    """Whether a zip is a workbook by its relations, and not an archive of files."""
    try:
        package = Package(content, MAX_RELATIONS)
        book = package.one("", "officeDocument")
        return book is not None and bool(package.related(book))
    except (InputError, *DAMAGED):  # who reads it as an archive says what is wrong with it
        return False
