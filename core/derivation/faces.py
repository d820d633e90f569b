"""Faces of a derivation: an expression as a live formula, in symbols, in numbers.

A face holds notations; brackets come from precedence, never from a text.
"""

import ast
import functools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from core.derivation.quantity import Quantity, expression
from core.text.sentence import format_number

SUM, PRODUCT, POWER, ATOM = 1, 2, 3, 4
"""Precedence: what binds weaker stands in brackets."""

OPERATORS: dict[type, tuple[str, int]] = {
    ast.Add: ("+", SUM),
    ast.Sub: ("-", SUM),
    ast.Mult: ("*", PRODUCT),
    ast.Div: ("/", PRODUCT),
    ast.Pow: ("^", POWER),
}

EXCEL = {
    "sqrt": "SQRT({})",
    "min": "MIN({})",
    "max": "MAX({})",
    "abs": "ABS({})",
    "log": "LN({})",
    "atan": "ATAN({})",
    "arctan": "DEGREES(ATAN({}))",
    "radians": "RADIANS({})",
    "sin": "SIN(RADIANS({}))",
    "cos": "COS(RADIANS({}))",
    "tan": "TAN(RADIANS({}))",
    "kilo": "(1000*{})",
}
"""Functions of a spreadsheet, by those of a derivation."""

CONSTANTS = {"CANTILEVER_KAPPA": "κ", "pi": "π"}
"""Constants that have a symbol; the others are written as numbers."""

SUPERSCRIPTS = {2: "²", 3: "³"}


@dataclass(frozen=True)
class Shown:
    """A number within a written formula. cell : the cell that holds it, None where none does"""

    value: float
    digits: int
    cell: str | None

    def text(self, language: str) -> str:
        """Text of the number; a negative one stands in brackets."""
        written = format_number(self.value, f".{self.digits}f", language)
        return f"({written})" if self.value < 0.0 else written


@dataclass(frozen=True)
class Place:
    """A name within a live formula. constant : its value where the module has a constant of this name, else None"""

    name: str
    constant: float | None

    def text(self, cells: Mapping[str, str]) -> str:
        """Text of the name: its cell, its range of the table of loads or modes, or a number."""
        if self.name in cells:
            cell = cells[self.name]
            return f"({cell})" if cell.startswith("-") else cell
        return f"{self.constant:.15g}"


class Face:
    """Walks the expression of a quantity. `of` gives pieces and their precedence."""

    def __init__(self, function: Callable):
        self.function = function

    def of(self, node: ast.expr) -> tuple[list, int]:
        match node:
            case ast.BinOp(left, operator, right):
                return self.operation(left, type(operator), right)
            case ast.UnaryOp(ast.USub(), operand):
                return ["(", self.minus, *self.within(operand, PRODUCT), ")"], ATOM
            case ast.Call(ast.Name("sum"), [ast.GeneratorExp(each)]):
                return self.total(each)
            case ast.Call(ast.Name(name), arguments):
                return self.call(name, arguments)
            case ast.IfExp(test, body, orelse):
                return self.choice(test, body, orelse)
            case ast.Attribute(ast.Name(item), column):
                return self.name(f"{item}.{column}")
            case ast.Name(name):
                return self.name(name)
            case ast.Constant(value):
                return self.constant(value)
        raise ValueError(ast.unparse(node))

    minus = "−"

    def within(self, node: ast.expr, least: int) -> list:
        """Pieces of an operand, in brackets where it binds weaker than it must."""
        pieces, precedence = self.of(node)
        return pieces if precedence >= least else ["(", *pieces, ")"]

    def inlined(self, name: str, arguments: Sequence[ast.expr]) -> ast.expr | None:
        """Expression of a function of the module with its arguments in place; None of any other function."""
        function = self.function.__globals__.get(name)
        if not callable(function) or function.__module__ != self.function.__module__:
            return None
        parameters = function.__code__.co_varnames[: function.__code__.co_argcount]
        places = dict(zip(parameters, arguments, strict=True))

        class Placed(ast.NodeTransformer):
            def visit_Name(self, node):
                return places.get(node.id, node)

        return Placed().visit(expression(function))

    def known(self, name: str) -> float | None:
        """Value of a constant of the module; None where it has none of this name."""
        value = self.function.__globals__.get(name)
        return float(value) if isinstance(value, (int, float)) else None

    def operation(self, left, operator, right) -> tuple[list, int]:
        raise NotImplementedError

    def total(self, each) -> tuple[list, int]:
        raise NotImplementedError

    def call(self, name, arguments) -> tuple[list, int]:
        raise NotImplementedError

    def choice(self, test, body, orelse) -> tuple[list, int]:
        raise Branches

    def name(self, name) -> tuple[list, int]:
        raise NotImplementedError

    def constant(self, value) -> tuple[list, int]:
        raise NotImplementedError


class Formula(Face):
    """A live formula of a spreadsheet, a Place for each name."""

    minus = "-"

    def operation(self, left, operator, right):
        sign, own = OPERATORS[operator]
        # a^b^c and a^-b are read differently by spreadsheets: operands of a power are atoms
        first = self.within(left, ATOM if operator is ast.Pow else own)
        return [*first, sign, *self.within(right, own + 1)], own

    def total(self, each):
        return ["SUMPRODUCT(", *self.of(each)[0], ")"], ATOM

    def call(self, name, arguments):
        body = self.inlined(name, arguments)
        if body is not None:
            return self.of(body)
        head, end = EXCEL[name].split("{}")
        pieces = [piece for argument in arguments for piece in (",", *self.of(argument)[0])]
        return [head, *pieces[1:], end], ATOM

    def choice(self, test, body, orelse):
        left, right = (self.of(side)[0] for side in (test.left, test.comparators[0]))
        return ["IF(", *left, "<", *right, ",", *self.of(body)[0], ",", *self.of(orelse)[0], ")"], ATOM

    def name(self, name):
        if name == "pi":
            return ["PI()"], ATOM
        return [Place(name, self.known(name))], ATOM

    def constant(self, value):
        return [f"{value:.15g}"], ATOM


class Written(Face):
    """Symbols or numbers. leaf : pieces of a name with their precedence; point : between factors"""

    def __init__(self, function: Callable, leaf: Callable[[str], tuple[list, int] | None], point: str, language: str):
        super().__init__(function)
        self.leaf, self.point, self.language, self.in_angle = leaf, point, language, False

    def operation(self, left, operator, right):
        if operator is ast.Pow:
            exponent = SUPERSCRIPTS.get(getattr(right, "value", 0))
            return [*self.within(left, ATOM), *([exponent] if exponent else ["^", *self.within(right, ATOM)])], POWER
        if operator is ast.Div:
            return [*self.within(left, PRODUCT), "/", *self.within(right, PRODUCT + 1)], PRODUCT
        if operator is ast.Mult:
            return [*self.factor(left), self.point, *self.factor(right)], PRODUCT
        sign = " + " if operator is ast.Add else " − "
        return [*self.within(left, SUM), sign, *self.within(right, SUM + (operator is ast.Sub))], SUM

    def factor(self, node) -> list:
        """A quotient within a product stands in brackets."""
        quotient = isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div)
        return self.within(node, ATOM if quotient else PRODUCT)

    def total(self, each):
        return ["Σ", *self.within(each, PRODUCT)], PRODUCT

    def call(self, name, arguments):
        """An angle is written in degrees: sin α, sin 6.84°."""
        body = self.inlined(name, arguments)
        if body is not None:
            return self.of(body)
        if name in ("kilo", "radians"):
            pieces, precedence = self.of(arguments[0])
            return (pieces, precedence) if name == "radians" or self.point == " " else ([*pieces, " · 10³"], PRODUCT)
        if name == "abs":
            return ["|", *self.of(arguments[0])[0], "|"], ATOM
        outside, self.in_angle = self.in_angle, name in ("sin", "cos", "tan") and not isinstance(arguments[0], ast.Name)
        pieces = [piece for argument in arguments for piece in (", ", *self.of(argument)[0])][1:]
        self.in_angle = outside
        head = {"sqrt": "√", "log": "ln", "atan": "arctan"}.get(name, name)
        if name in ("sin", "cos", "tan") and isinstance(arguments[0], ast.Name):
            return [f"{head} ", *pieces, *(["°"] if self.point != " " else [])], POWER
        return [head, "(", *pieces, ")"], ATOM

    def name(self, name):
        if (leaf := self.leaf(name)) is not None:
            if self.in_angle and name.endswith("_degrees") and self.point != " ":
                return [*leaf[0], "°"], leaf[1]
            return leaf
        if name in CONSTANTS and (self.point == " " or name == "pi"):
            return [CONSTANTS[name]], ATOM
        return self.constant(self.known(name))

    def constant(self, value):
        if value is None:
            raise ValueError(f"{self.function.__name__} needs what no line before it gives")
        return [format_number(float(value), "g", self.language)], ATOM


class Branches(ValueError):
    """The formula of a spectrum, which has a branch for each range of periods, is no line of a calculation."""


def formula(quantity: Quantity, cells: Mapping[str, str]) -> str:
    """The quantity as a formula of a spreadsheet, "=...". cells : name -> cell, range or number"""
    return "=" + "".join(piece if isinstance(piece, str) else piece.text(cells) for piece in _live(quantity))


@functools.cache
def _live(quantity: Quantity) -> list:
    """Pieces of the formula, which are the same for every wall."""
    return Formula(quantity.function).of(quantity.tree)[0]


def in_symbols(quantity: Quantity, symbols: Mapping[str, str], language: str) -> str:
    """The right side in symbols, as "(t − 2 u)/H". symbols : of the names it needs, and of what a sum runs over"""
    return _in_symbols(quantity, tuple(symbols.items()), language)


@functools.lru_cache(1 << 10)
def _in_symbols(quantity: Quantity, pairs: tuple[tuple[str, str], ...], language: str) -> str:
    symbols = dict(pairs)

    def leaf(name: str):
        if name not in symbols:
            return None
        apart = any(mark in symbols[name] for mark in " /") and not symbols[name].endswith(")")
        return [symbols[name]], PRODUCT if apart else ATOM

    return "".join(Written(quantity.function, leaf, " ", language).of(quantity.tree)[0])


def in_numbers(quantity: Quantity, shown: Mapping[str, Shown], language: str) -> list[str | Shown]:
    """The right side in numbers: words and numbers one after the other."""

    def leaf(name: str):
        return ([shown[name]], ATOM) if name in shown else None

    return Written(quantity.function, leaf, " · ", language).of(quantity.tree)[0]
