"""A quantity of a derivation: one function whose body is one expression, and what stands beside it in a calculation.

The name of the function is that of the cell and of the key; its parameters are the quantities it needs. A face
(core/derivation/faces.py) walks the expression and writes it as a live formula, in symbols, in numbers, as an equation.
"""

import ast
import inspect
import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from core.known import require_value


@dataclass(frozen=True)
class Given:
    """A number that is not derived: of the case, of the run, or a constant of the clause.

    name : of its cell; symbol, unit : as they are written
    digits : behind the decimal mark within a formula; shape : number format of its cell
    label : what the row of the workbook says in place of the symbol, a text of the group "report"
    """

    name: str
    symbol: str
    unit: str = "–"
    digits: int = 3
    shape: str = "0.0000"
    label: str = ""
    clause: str = ""


@dataclass(frozen=True)
class Quantity(Given):
    """A number that is derived.

    function : of the quantities it needs, by name
    """

    function: Callable[..., float] = float

    @property
    def needs(self) -> tuple[str, ...]:
        """Names of the quantities it needs."""
        code = self.function.__code__
        return code.co_varnames[: code.co_argcount]

    @cached_property
    def tree(self) -> ast.expr:
        """The expression its function returns, read from the source when a face first asks for it."""
        return expression(self.function)


def expression(function: Callable) -> ast.expr:
    """The expression a function returns. Raises ValueError where its body is anything else."""
    body = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0].body  # type: ignore[attr-defined]
    last = body[-1]
    if not isinstance(last, ast.Return) or any(not isinstance(line, ast.Expr) for line in body[:-1]):
        raise ValueError(f"{function.__name__} is more than one expression")
    return require_value(last.value)


def quantity(
    symbol: str, unit: str, clause: str = "", digits: int = 3, shape: str = "0.0000", name: str = "", label: str = ""
) -> Callable[[Callable], Quantity]:
    """Decorator: the function is the quantity of its name, or of `name` where walls of several kinds have it by several
    formulas. symbol : {state}, {damping} stand for those of the demand"""

    def described(function: Callable[..., float]) -> Quantity:
        return Quantity(name or function.__name__, symbol, unit, digits, shape, label, clause, function)

    return described
