"""Borders of the architecture that import-linter does not see."""

import ast

import pytest

from tests.conftest import ROOT

SOURCES = sorted([*(ROOT / "core").rglob("*.py"), *(ROOT / "app").rglob("*.py")])


@pytest.mark.parametrize("source", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_that_no_module_is_two_subjects(source):
    assert len(source.read_text().splitlines()) <= 420


def test_that_every_public_function_and_class_says_what_it_is():
    bare = []
    for source in SOURCES:
        tree = ast.parse(source.read_text())
        for node in ast.walk(tree):
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
                body = [n for n in node.body if not isinstance(n, ast.Expr)]
                if not ast.get_docstring(node) and len(body) > 6:
                    bare.append(f"{source.name}:{node.name}")
        assert ast.get_docstring(tree) or not tree.body, source
    assert bare == []


def test_that_no_record_of_the_shelf_is_in_the_project(shelf, index):
    import hashlib

    known = {row["sha256"] for row in index.values()}
    for path in ROOT.rglob("*"):
        if path.is_file() and ".git" not in path.parts and ".venv" not in path.parts:
            assert hashlib.sha256(path.read_bytes()).hexdigest() not in known, path


def test_that_the_bundled_motions_are_those_the_program_makes(tmp_path):
    from core.ground.artificial import write_example_records

    write_example_records(tmp_path)
    for path in sorted((ROOT / "resources" / "motions").glob("*.txt")):
        assert path.read_text() == (tmp_path / path.name).read_text()
