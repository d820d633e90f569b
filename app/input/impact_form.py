"""Restitution model and moment law of a wall, with formula, value and curve."""

import math
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from app.input.editors import Choice
from app.input.fields import ChoiceField, clear_fields
from app.input.number_fields import NumberField
from app.input.wall_editor import WallEditor
from app.look.labels import PlainLabel
from app.look.language import current_language, describe_message, number, result_word, tr
from app.work.session import Session
from core.case.wall import Wall
from core.errors import InputError
from core.known import require_value
from core.text.sentence import format_number
from core.wall.block import Block
from core.wall.moment_rotation import LAWS
from core.wall.restitution import MODELS, Contact, impact_ratio

if TYPE_CHECKING:
    from app.input.law_curve import LawCurve


CURVE_HEIGHT = 120
"""Height that the curve of the law takes [px]."""


def captions() -> dict:
    """Restitution models as the list shows them; None is the default of the mechanism."""
    return {
        None: tr("default of the mechanism"),
        "housner": "Housner (Eq. 4)",
        "sorrentino_experimental": tr("Sorrentino, experimental (Eq. 5)"),
        "costa_upper": tr("Costa, upper bound"),
        "one_sided_theoretical": tr("one-sided, theoretical (Eq. 6)"),
        "one_sided_experimental": tr("one-sided, experimental (Eq. 7)"),
        "user": tr("given velocity ratio"),
    }


def named_models() -> dict:
    """Every restitution model by its caption, one without words by its name."""
    return {None: None} | {model: model for model in MODELS} | captions()


def named_laws() -> dict:
    """Moment-rotation laws as the list shows them, with their ends over alpha; "own" is one of two numbers."""
    words = {"rigid": tr("rigid"), "doherty": "Doherty", "al_shawa": "Al Shawa"}
    first = {"auto": tr("by the clause"), "elastic": tr("elastic branch")}
    ends = {name: "" if law.is_rigid else f" {law.elastic_limit:g}, {law.plateau_end:g}" for name, law in LAWS.items()}
    return first | {name: words.get(name, name) + ends[name] for name in LAWS} | {"own": tr("own D1, D2")}


def scopes() -> dict:
    """What each model rests on and how far it goes."""
    return {
        "housner": tr("theory: angular momentum kept, no sliding, no bouncing"),
        "sorrentino_experimental": tr("tests on walls of tuff units and of clay bricks"),
        "costa_upper": tr("tests on sack stone masonry; above Eq. 4 for α > 6.63°"),
        "one_sided_theoretical": tr("theory: impacts of base, upper corner and base again"),
        "one_sided_experimental": tr(
            "tests; v over the overturning velocity, beyond v = 1.58 held at e = 0; value for v = 0"
        ),
        "user": tr("given, 0 to 1"),
    }


def formula_of(model: str, block: Block, contact: Contact | None = None) -> str:
    """The formula of a model with the factors and the angle of this block: a setback or a mass that moves with the wall
    makes them others than those of a rectangle; of a model without a formula its source. contact : of a block with
    masses that move with it"""
    from core.derivation.body import RATIOS
    from core.derivation.faces import in_symbols

    language = current_language()
    if model not in RATIOS:
        return "e" if model == "user" else f"e ({MODELS[model].source})"
    factor = format_number(2.0 * block.radius**2 / block.inertia_over_mass, ".5g", language)
    inner, top = f"{factor} sin²α", f"{factor} cos²α"
    if contact is not None:
        corner, upper = (contact.width, 0.0), (contact.width, contact.height)
        inner = format_number(1.0 - impact_ratio(block, (0.0, 0.0), corner), ".5g", language)
        top = format_number(1.0 - impact_ratio(block, corner, upper), ".5g", language)
    symbols = {"e_base": f"(1 − {inner})", "e_top": f"|1 − {top}|"}
    degrees = format_number(math.degrees(block.slenderness), ".5g", language)
    return f"e = {in_symbols(RATIOS[model], symbols, language)} ({RATIOS[model].clause}, α = {degrees}°)"


class LawField(NumberField):
    """An end of an own law over alpha, checked as the velocity ratio is: 0 to 1."""

    def __init__(self, end: str):
        self.end = end
        super().__init__(Wall, "velocity_ratio")

    def text_of(self, part: str) -> str:
        return result_word(f"key_{self.end}") if part == ".caption" else ""

    def key_in_errors(self) -> str:
        return self.end


class ImpactForm(WallEditor):
    """Edits restitution and law of the wall at `index()`."""

    def __init__(self, session: Session, index: Callable[[], int]):
        super().__init__(session, index)
        self.scopes = scopes()
        column = QVBoxLayout(self)
        self.model = ChoiceField(Wall, "restitution", named_models())
        self.velocity_ratio = NumberField(Wall, "velocity_ratio")
        self.law = Choice()
        for name, shown in named_laws().items():
            self.law.addItem(shown, name)
        self.law.setAccessibleName(tr("Moment-rotation law"))
        self.law.activated.connect(self._law_chosen)
        self.first = LawField("elastic_limit")
        self.last = LawField("plateau_end")
        self.first.edited.connect(lambda value: self._law_end("elastic_limit", value))
        self.last.edited.connect(lambda value: self._law_end("plateau_end", value))
        self.model.edited.connect(self._model_chosen)
        self.velocity_ratio.edited.connect(lambda value: self.edit("velocity_ratio", velocity_ratio=value))
        self.formula = PlainLabel()
        self.formula.setWordWrap(True)
        for widget in (self.model, self.velocity_ratio, self.formula):
            column.addWidget(widget)
        row = QHBoxLayout()
        ends = QVBoxLayout()
        ends.addWidget(self.law)
        ends.addWidget(self.first)
        ends.addWidget(self.last)
        ends.addStretch(1)
        row.addLayout(ends, 1)
        self.room = QWidget()  # of one size, with a curve or without: what is shown moves nothing
        self.room.setFixedHeight(CURVE_HEIGHT)
        inside = QVBoxLayout(self.room)
        inside.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.room, 1)
        column.addLayout(row)

    def show_case(self) -> None:
        """Fill the form from the wall."""
        wall = self.wall
        if wall is None:
            clear_fields((self.model, self.velocity_ratio, self.first, self.last))
            self.formula.setText("")
            self.law.setCurrentIndex(-1)
            self._draw_law()
            return
        model = wall.restitution or ("user" if wall.velocity_ratio is not None else None)
        self.model.show_value(model)
        self.velocity_ratio.setVisible(model == "user")
        self.velocity_ratio.show_value(wall.velocity_ratio)
        lines = []
        for mechanism in wall.mechanisms() if wall.mechanism else ():
            try:
                model_used = wall.restitution_of(mechanism)
                word = result_word(mechanism)
                formula = formula_of(model_used.model, wall.block(), wall.in_si.contact)
                lines.append(f"{word}: {formula} = {number(model_used.ratio_at_rest, '.4f')}")
                if model_used.model in self.scopes:
                    lines.append(f"({self.scopes[model_used.model]})")
            except InputError as error:
                lines.append(describe_message(error))
            except TypeError:  # work in progress
                lines.append(tr("Sizes, weights or loads are still missing."))
                break
        self.formula.setText("\n".join(lines) or tr("Choose a mechanism."))
        own = wall.law if isinstance(wall.law, dict) else None
        self.law.setCurrentIndex(self.law.findData(wall.law if own is None else "own"))
        for field, key in ((self.first, "elastic_limit"), (self.last, "plateau_end")):
            field.setVisible(own is not None)
            if own is not None:
                field.show_value(own[key])
        self._draw_law()

    @cached_property
    def law_curve(self) -> "LawCurve":
        """Made when it is first looked at."""
        from app.input.law_curve import LawCurve

        made = LawCurve()
        require_value(self.room.layout()).addWidget(made)
        made.show_wall(self.wall)
        return made

    def _draw_law(self) -> None:
        """Nothing where nobody sees it: it is drawn when it is shown."""
        if self.isVisible():
            self.law_curve.show_wall(self.wall)

    def showEvent(self, event) -> None:
        super().showEvent(event)
        self._draw_law()

    def _model_chosen(self, model) -> None:
        wall = self.wall
        if wall is None:
            return
        ratio = None
        if model == "user":
            try:
                ratio = round(wall.restitution_of(wall.mechanisms()[0]).ratio_at_rest, 3)
            except (InputError, TypeError):
                ratio = 0.9
        self.edit(restitution=model, velocity_ratio=ratio)

    def _law_chosen(self, index: int) -> None:
        name = self.law.itemData(index)
        law = {"elastic_limit": 0.06, "plateau_end": 0.28} if name == "own" else name
        self.edit(law=law)

    def _law_end(self, key: str, value) -> None:
        if self.wall is not None and isinstance(self.wall.law, dict):
            self.edit(key, law={**self.wall.law, key: value})
