"""A line of a derivation as mathematics: fractions, roots, powers and indices, by one of two notations, that of Word
(OMML) and that of Typst."""

import ast
import json
import re
from collections.abc import Callable
from dataclasses import dataclass
from xml.etree import ElementTree
from xml.sax.saxutils import escape

from core.derivation.faces import ATOM, CONSTANTS, POWER, PRODUCT, SUM, Face
from core.report.note.parts import Step
from core.text.sentence import format_number

NAMESPACE = "http://schemas.openxmlformats.org/officeDocument/2006/math"

THIN_SPACE = "\u2009"
"""Space between the factors of a product in symbols."""

INDEXED = re.compile(
    r"([^\s_/()+−·=]+)_([^\s_/()]*[^\s_/(),*])(\*?)|(?<![\w.])([^\W\d_])(\d(?:,\w)?)(?![\w.])(\*?)|(?<!\w)([^\W\d_])()(\*)"
)
"""A symbol with its index and its star, as T_0, α0, a_0* and e*."""


@dataclass(frozen=True)
class Notation:
    """run : upright text; letter : of a symbol; indexed : a base, its index and whether it has a star; each of the
    others takes what it is made of, as it is written"""

    run: Callable[[str], str]
    letter: Callable[[str], str]
    indexed: Callable[[str, str, bool], str]
    fraction: Callable[[str, str], str]
    power: Callable[[str, str], str]
    root: Callable[[str], str]
    brackets: Callable[[str], str]

    def symbol(self, text: str) -> str:
        """A symbol with its indices set low."""
        pieces, end = [], 0
        for match in INDEXED.finditer(text):
            base, index, star = next(match.group(k, k + 1, k + 2) for k in (1, 4, 7) if match[k])
            pieces += [
                self.letter(text[end : match.start()]),
                self.indexed(self.letter(base), self.run(index), bool(star)),
            ]
            end = match.end()
        return "".join([*pieces, self.letter(text[end:])])


def _omml_run(text: str) -> str:
    return f'<m:r><m:rPr><m:nor/></m:rPr><m:t xml:space="preserve">{escape(text)}</m:t></m:r>' if text else ""


OMML = Notation(
    run=_omml_run,
    letter=_omml_run,
    indexed=lambda base, index, star: (
        (f"<m:sSub><m:e>{base}</m:e><m:sub>{index}</m:sub></m:sSub>" if index else base) + _omml_run("*" * star)
    ),
    fraction=lambda over, under: f"<m:f><m:num>{over}</m:num><m:den>{under}</m:den></m:f>",
    power=lambda base, exponent: f"<m:sSup><m:e>{base}</m:e><m:sup>{exponent}</m:sup></m:sSup>",
    root=lambda inner: f'<m:rad><m:radPr><m:degHide m:val="1"/></m:radPr><m:deg/><m:e>{inner}</m:e></m:rad>',
    brackets=lambda inner: f"<m:d><m:e>{inner}</m:e></m:d>",
)


SIGNS = {THIN_SPACE: "thin ", " ": "thin ", " · ": "dot.op ", " + ": "+ ", " − ": "- ", " = ": "= "}
"""Operators of Typst, which have their own spaces."""


def _typst_run(text: str) -> str:
    """An operator, else a string of Typst, which is never code."""
    return SIGNS.get(text) or (json.dumps(text, ensure_ascii=False) if text else "")


def _typst_letters(text: str) -> str:
    """Single letters are set italic, words, numbers and signs upright."""
    words = re.findall(r"[^\W\d_]+(?:-[^\W\d_]+)*|\d+(?:[.,]\d+)*|[^\w]", text)
    single = re.compile(r"[^\W\d_ΣΔ]")
    return "".join(f"italic({_typst_run(word)})" if single.fullmatch(word) else _typst_run(word) for word in words)


def _typst_indexed(base: str, index: str, star: bool) -> str:
    return f"attach({base}" + (f", b: {index}" if index else "") + (", t: *" if star else "") + ")"


TYPST = Notation(
    run=_typst_run,
    letter=_typst_letters,
    indexed=_typst_indexed,
    fraction=lambda over, under: f"frac({over}, {under})",
    power=lambda base, exponent: f"attach({base}, t: {exponent})",
    root=lambda inner: f"sqrt({inner})",
    brackets=lambda inner: f"lr(\\({inner}\\))",
)


class Equation(Face):
    """leaf : a name as it is written, None of a constant; point : between factors"""

    def __init__(
        self, notation: Notation, function: Callable, leaf: Callable[[str], str | None], point: str, language: str
    ):
        super().__init__(function)
        self.notation, self.leaf, self.point, self.language = notation, leaf, point, language
        self.in_angle = False

    def within(self, node, least):
        pieces, precedence = self.of(node)
        return pieces if precedence >= least else [self.notation.brackets("".join(pieces))]

    def operation(self, left, operator, right):
        """A quotient is a fraction, an exponent stands high."""
        to = self.notation
        first, second = ("".join(self.of(side)[0]) for side in (left, right))
        if operator is ast.Div:
            return [to.fraction(first, second)], ATOM
        if operator is ast.Pow:
            return [to.power("".join(self.within(left, ATOM)), second)], POWER
        if operator is ast.Mult:
            return [*self.within(left, PRODUCT), to.run(self.point), *self.within(right, PRODUCT)], PRODUCT
        sign = " + " if operator is ast.Add else " − "
        return [*self.within(left, SUM), to.run(sign), *self.within(right, SUM + (operator is ast.Sub))], SUM

    def total(self, each):
        return [self.notation.run("Σ"), *self.within(each, PRODUCT)], PRODUCT

    def call(self, name, arguments):
        """A root has its sign, another function its name."""
        to, body = self.notation, self.inlined(name, arguments)
        if body is not None:
            return self.of(body)
        outside, self.in_angle = self.in_angle, name in ("sin", "cos", "tan") and not isinstance(arguments[0], ast.Name)
        inner = ["".join(self.of(argument)[0]) for argument in arguments]
        self.in_angle = outside
        if name == "sqrt":
            return [to.root(inner[0])], ATOM
        if name == "kilo":
            return [inner[0], to.run(" · 10³" if self.point != THIN_SPACE else "")], PRODUCT
        if name == "radians":
            return [inner[0]], ATOM
        if name == "abs":
            return [to.run("|"), inner[0], to.run("|")], ATOM
        head = {"log": "ln", "atan": "arctan"}.get(name, name)
        if name in ("sin", "cos", "tan") and isinstance(arguments[0], ast.Name):
            return [to.run(f"{head} "), inner[0], to.run("°" if self.point != THIN_SPACE else "")], POWER
        return [to.run(head), to.brackets(to.run(", ").join(inner))], ATOM

    def name(self, name):
        if (leaf := self.leaf(name)) is not None:
            degree = (
                self.notation.run("°")
                if self.in_angle and name.endswith("_degrees") and self.point != THIN_SPACE
                else ""
            )
            return [f"{leaf} {degree}" if degree else leaf], ATOM
        if name in CONSTANTS and (self.point == THIN_SPACE or name == "pi"):
            return [self.notation.letter(CONSTANTS[name])], ATOM
        return self.constant(self.known(name))

    def constant(self, value):
        return [self.notation.run(format_number(float(value), "g", self.language))], ATOM


MAX_LINE, MAX_WHOLE_LINE = 42, 77
"""Characters a line has room for beside its label and clause, in the wide letters an office without Cambria Math sets
them in, and over the whole width."""

IN_PDF = 50
"""The first of them in the letters of the PDF."""


def width(node: ElementTree.Element) -> int:
    """Characters of an equation side by side: of a fraction the wider of its parts."""
    if node.tag == f"{{{NAMESPACE}}}f":
        return max(width(part) for part in node)
    around = 2 * (node.tag in (f"{{{NAMESPACE}}}d", f"{{{NAMESPACE}}}rad"))
    return len(node.text or "") + around + sum(width(part) for part in node)


def sides(step: Step, language: str, to: Notation) -> list[str]:
    """Sides of a step, between its signs of equality: symbol, formula, numbers, result and unit."""
    parts = [to.symbol(step.symbol)]
    if step.formula and step.quantity is not None:
        symbols = {name: to.symbol(text) for name, text in step.symbols.items()}
        face = Equation(to, step.quantity.function, symbols.get, THIN_SPACE, language)
        parts.append("".join(face.of(step.quantity.tree)[0]))
    if step.numbers and step.quantity is not None:
        numbers = {name: to.run(shown.text(language)) for name, shown in step.values.items()}
        face = Equation(to, step.quantity.function, numbers.get, " · ", language)
        parts.append("".join(face.of(step.quantity.tree)[0]))
    unit = "" if step.unit in ("–", "") else f" {step.unit}"
    return [*parts, to.run(step.result_written(language) + unit)]


def rows(step: Step, language: str, to: Notation, longest: int = MAX_LINE) -> list[list[str]]:
    """`sides` as they stand in a line each: what a line has no room for stands below, what no line has room for is left
    out, its numbers standing above."""
    written, measured = sides(step, language, to), [_width(side) + 2 for side in sides(step, language, OMML)]
    lines, room = [[written[0], written[1]]], measured[0] + measured[1]
    for side, wide in zip(written[2:], measured[2:], strict=True):
        if room + wide <= longest:
            lines[-1].append(side)
            room += wide
        elif wide <= MAX_WHOLE_LINE or side is written[-1]:
            lines.append([side])
            room = wide
    return lines


def equations(step: Step, language: str) -> list[str]:
    """The lines of a step in OMML."""
    first, *others = (OMML.run(" = ").join(row) for row in rows(step, language, OMML))
    return [_math(line) for line in (first, *(OMML.run("= ") + line for line in others))]


def _width(content: str) -> int:
    return width(ElementTree.fromstring(_math(content)))


def _math(content: str) -> str:
    return f'<m:oMath xmlns:m="{NAMESPACE}">{content}</m:oMath>'
