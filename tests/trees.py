"""The syntax tree of a source, parsed once however many tests look at it; none changes it."""

import ast
import functools
from pathlib import Path


@functools.cache
def tree_of(source: Path) -> ast.Module:
    return ast.parse(source.read_text(encoding="utf-8"))
