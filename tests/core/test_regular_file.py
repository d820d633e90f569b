"""The door by which files are read: what is no regular file, or too large, is refused and holds nothing up."""

import ast
import os
import threading
from pathlib import Path

import pytest

from core.regular_file import TooLarge, first_bytes, read_regular
from tests.test_boundaries import ROOT, SOURCES
from tests.trees import nodes_of

ENDLESS = ["pipe", "zero", "folder"]


def endless(kind: str, folder: Path, name: str) -> Path:
    """A thing without an end under the name of a file."""
    path = folder / name
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "zero":
        path.symlink_to("/dev/zero")
    else:
        path.mkdir()
    return path


def within(seconds: float, work):
    """What a call raises; a failure where it does not come back."""
    found: list = []

    def run():
        try:
            found.append(work())
        except BaseException as error:
            found.append(error)

    thread = threading.Thread(target=run, daemon=True)
    thread.start()
    thread.join(seconds)
    assert found, "it does not come back"
    return found[0]


@pytest.mark.skipif(os.name == "nt", reason="no pipes with names")
@pytest.mark.parametrize("kind", ENDLESS)
def test_that_what_has_no_end_is_refused_at_once(kind, tmp_path):
    path = endless(kind, tmp_path, "a")
    assert isinstance(within(5.0, lambda: read_regular(path, 1000)), OSError)
    assert isinstance(within(5.0, lambda: first_bytes(path, 5)), OSError)


def test_that_a_file_is_read_up_to_its_bound(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"x" * 1000)
    assert read_regular(path, 1000) == b"x" * 1000 and first_bytes(path, 3) == b"xxx"
    with pytest.raises(TooLarge) as refused:
        read_regular(path, 999)
    assert refused.value.size == 1000
    with pytest.raises(FileNotFoundError):
        read_regular(tmp_path / "none", 10)


OWN = {
    "app/__main__.py": "nowhere, for what is printed after stdout was closed",
    "app/shell/guide.py": "the guide",
    "app/shell/menus.py": "the list of recent files, of the program",
    "app/terminal/check_export.py": "a resource of the program",
    "app/terminal/command_line.py": "members of a workbook, the heads alone",
    "app/terminal/export.py": "a member of a workbook that is there already",
    "app/terminal/verification.py": "reports of its own, in a folder of its own",
    "app/views/figure_file.py": "a buffer",
    "app/shell/client_view.py": "a buffer",
    "app/work/recovery.py": "drafts of the program",
    "app/work/session.py": "the file that is open, against what is on the disk",
    "core/capacity/scale_free_law.py": "a resource of the program",
    "core/atomic_write.py": "files beside those that are written",
    "core/study/case_script.py": "a resource of the program",
    "core/child.py": "its own work and answer, in a folder of its own",
    "core/ground/records/container.py": "members of a container in memory",
    "core/jit/cache.py": "machine code of the program",
    "core/jit/numba_extensions.py": "sources of the program",
    "core/jit/shipped.py": "machine code of the program",
    "core/jit/stamp.py": "sources of the program",
    "core/jit/trial.py": "machine code of the program",
    "core/ooxml/package.py": "members of a workbook in memory",
    "core/regular_file.py": "the door",
    "core/report/cells.py": "sheets that are being written",
    "core/report/note/pdf.py": "a resource of the program",
    "core/lab/solved/histories.py": "a resource of the program",
    "core/lab/research/pack.py": "what the study itself has read, and the lock of the program",
    "core/lab/research/page.py": "results of the program's own studies",
    "core/lab/solved/pack.py": "cases of the program",
    "core/study/check_script.py": "a resource of the program",
    "core/study/journal.py": "journals, which are locked",
    "core/study/self_test.py": "a resource of the program",
    "core/text/catalogue.py": "a resource of the program",
    "core/version.py": "the program",
}
"""Modules that open or read files without the door -> whose."""


@pytest.mark.shows("doors.endless")
def test_that_files_a_user_names_are_read_by_one_door():
    found = set()
    for path in SOURCES:
        for node in nodes_of(path):
            if not isinstance(node, ast.Call):
                continue
            name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
            is_file = name in ("read_bytes", "read_text") or (
                name == "open" and (isinstance(node.func, ast.Name) or not _of_the_window(node))
            )
            if is_file:
                found.add(path.relative_to(ROOT).as_posix())
    assert found - set(OWN) == set()


OWNERS = ("os", "self", "self.session", "self.files", "session", "window.files", "window.session", "atomic_write")


def _of_the_window(node: ast.Call) -> bool:
    """Whether a method `open` is that of a session, a page or the system's descriptors."""
    owner = ast.unparse(node.func.value) if isinstance(node.func, ast.Attribute) else ""
    return owner in OWNERS
