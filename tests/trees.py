"""The syntax tree of a source, parsed and gone through once however many tests look at it; none changes it."""

import ast
import functools
from pathlib import Path


@functools.cache
def tree_of(source: Path) -> ast.Module:
    return ast.parse(source.read_text(encoding="utf-8"))


@functools.cache
def nodes_of(source: Path) -> tuple[ast.AST, ...]:
    """All nodes of its tree."""
    return tuple(ast.walk(tree_of(source)))
