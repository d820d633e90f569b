"""A line of a derivation as an equation of Word (OMML): fractions, roots, powers and indices set as mathematics."""

import ast
import re
from collections.abc import Callable
from xml.etree import ElementTree
from xml.sax.saxutils import escape

from core.derivation.faces import ATOM, CONSTANTS, POWER, PRODUCT, SUM, Face
from core.report.note.parts import Step
from core.text.sentence import numeral

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"

THIN = "\u2009"
"""Between the factors of a product in symbols."""

INDEXED = re.compile(r"([^\s_/()+−·=]+)_([^\s_/()]*[^\s_/(),])")
"""A symbol with its index, as T_0."""


def run(text: str) -> str:
    """Upright text."""
    return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{escape(text)}</m:t></m:r>' if text else ""


def symbol(text: str) -> str:
    """A symbol with its indices set low."""
    pieces, end = [], 0
    for match in INDEXED.finditer(text):
        pieces.append(run(text[end : match.start()]))
        pieces.append(f"<m:sSub><m:e>{run(match[1])}</m:e><m:sub>{run(match[2])}</m:sub></m:sSub>")
        end = match.end()
    return "".join([*pieces, run(text[end:])])


class Equation(Face):
    """leaf : a name as OMML, None of a constant; point : between factors"""

    def __init__(self, function: Callable, leaf: Callable[[str], str | None], point: str, language: str):
        super().__init__(function)
        self.leaf, self.point, self.language = leaf, point, language

    def within(self, node, least):
        pieces, precedence = self.of(node)
        return pieces if precedence >= least else [_bracketed("".join(pieces))]

    def operation(self, left, operator, right):
        first, second = ("".join(self.of(side)[0]) for side in (left, right))
        if operator is ast.Div:
            return [f"<m:f><m:num>{first}</m:num><m:den>{second}</m:den></m:f>"], ATOM
        if operator is ast.Pow:
            base = "".join(self.within(left, ATOM))
            return [f"<m:sSup><m:e>{base}</m:e><m:sup>{second}</m:sup></m:sSup>"], POWER
        if operator is ast.Mult:
            return [*self.within(left, PRODUCT), run(self.point), *self.within(right, PRODUCT)], PRODUCT
        sign = " + " if operator is ast.Add else " − "
        return [*self.within(left, SUM), run(sign), *self.within(right, SUM + (operator is ast.Sub))], SUM

    def total(self, each):
        return [run("Σ"), *self.within(each, PRODUCT)], PRODUCT

    def call(self, name, arguments):
        """A root has its sign, another function its name."""
        body = self.inlined(name, arguments)
        if body is not None:
            return self.of(body)
        inner = ["".join(self.of(argument)[0]) for argument in arguments]
        if name == "sqrt":
            return [f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>{inner[0]}</m:e></m:rad>'], ATOM
        if name == "kilo":
            return [inner[0], run(" · 10³" if self.point != THIN else "")], PRODUCT
        if name == "radians":
            return [inner[0]], ATOM
        if name == "abs":
            return [run("|"), inner[0], run("|")], ATOM
        head = {"log": "ln", "atan": "arctan"}.get(name, name)
        if name in ("sin", "cos", "tan") and isinstance(arguments[0], ast.Name):
            return [run(f"{head} "), inner[0], run("°" if self.point != THIN else "")], POWER
        return [run(head), _bracketed(run(", ").join(inner))], ATOM

    def name(self, name):
        if (found := self.leaf(name)) is not None:
            return [found], ATOM
        if name in CONSTANTS and (self.point == THIN or name == "pi"):
            return [run(CONSTANTS[name])], ATOM
        return self.constant(self.known(name))

    def constant(self, value):
        return [run(numeral(float(value), "g", self.language))], ATOM


def _bracketed(inner: str) -> str:
    return f"<m:d><m:e>{inner}</m:e></m:d>"


LONGEST = 50
"""Characters a line has room for."""


def width(node: ElementTree.Element) -> int:
    """Characters of an equation side by side: of a fraction the wider of its parts."""
    if node.tag == f"{{{NAMESPACE}}}f":
        return max(width(part) for part in node)
    around = 2 * (node.tag in (f"{{{NAMESPACE}}}d", f"{{{NAMESPACE}}}rad"))
    return len(node.text or "") + around + sum(width(part) for part in node)


def equations(step: Step, language: str) -> list[str]:
    """The line of a step: symbol, formula, numbers, result and unit; what it has no room for stands below."""
    sides = [symbol(step.symbol)]
    if step.formula and step.quantity is not None:
        symbols = {name: symbol(text) for name, text in step.symbols.items()}
        face = Equation(step.quantity.function, symbols.get, THIN, language)
        sides.append("".join(face.of(step.quantity.tree)[0]))
    if step.numbers and step.quantity is not None:
        numbers = {name: run(shown.text(language)) for name, shown in step.values.items()}
        face = Equation(step.quantity.function, numbers.get, " · ", language)
        sides.append("".join(face.of(step.quantity.tree)[0]))
    unit = "" if step.unit in ("–", "") else f" {step.unit}"
    sides.append(run(step.result_written(language) + unit))
    lines = [sides[0] + run(" = ") + sides[1]]
    for side in sides[2:]:
        longer = lines[-1] + run(" = ") + side
        if width(ElementTree.fromstring(_math(longer))) <= LONGEST:
            lines[-1] = longer
        else:
            lines.append(run("= ") + side)
    return [_math(line) for line in lines]


def _math(content: str) -> str:
    return f'<m:oMath xmlns:m="{NAMESPACE}">{content}</m:oMath>'
