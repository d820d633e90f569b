"""Colours of the window, light and dark, told apart by colour-blind eyes (from Okabe and Ito 2008, simulated in
tests/app/test_colours.py)."""

from dataclasses import dataclass

from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

from app.look.application import application


@dataclass(frozen=True)
class Theme:
    """back : of plots
    ink : of axes and text; grid
    edge : of fields and boxes
    quiet : of secondary text
    curves : in their order
    good, amber, bad : always beside a word
    """

    name: str
    back: str
    window: str
    ink: str
    grid: str
    edge: str
    quiet: str
    curves: tuple[str, ...]
    good: str
    amber: str
    bad: str


LIGHT = Theme(
    "light",
    "#ffffff",
    "#f3f5f7",
    "#1f2d3d",
    "#d9dfe5",
    "#7f8b96",
    "#5b6875",
    ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#666666"),
    "#00704e",
    "#8a5a00",
    "#a6192e",
)
DARK = Theme(
    "dark",
    "#1b2026",
    "#242a31",
    "#e6eaee",
    "#3a434d",
    "#7d8894",
    "#9aa7b4",
    ("#56b4e9", "#f58231", "#3ddbaa", "#e58fc0", "#f5d04c", "#c2e5fa", "#8c8c8c"),
    "#3ddbaa",
    "#f5c24c",
    "#ff7a59",
)
THEMES = {theme.name: theme for theme in (LIGHT, DARK)}

VERDICT_MARKS = {"good": "✓", "amber": "!", "bad": "✗"}
"""Beside a number in the colour of a verdict, which is never told by its colour alone."""

current = LIGHT


def font_points(times: float) -> str:
    """A size of letters in a style sheet, so many times that of the desktop."""
    return f"font-size: {times * QApplication.font().pointSizeF():g}pt;"


def add_tone_mark(tone: str, words: str) -> str:
    """Words of this tone after its mark, alone where they are it or the tone has none."""
    mark = VERDICT_MARKS.get(tone, "")
    return words if words in ("", mark, *VERDICT_MARKS.values()) else f"{mark} {words}".strip()


def set_theme(name: str) -> None:
    """Give the application the palette of "light" or "dark"; widgets made from now on use it."""
    global current
    current = THEMES[name]
    if application().style().name() != "fusion":
        application().setStyle("Fusion")
    palette = QPalette()
    shades = {
        QPalette.ColorRole.Window: current.window,
        QPalette.ColorRole.Base: current.back,
        QPalette.ColorRole.AlternateBase: current.window,
        QPalette.ColorRole.Button: current.window,
        QPalette.ColorRole.WindowText: current.ink,
        QPalette.ColorRole.Text: current.ink,
        QPalette.ColorRole.ButtonText: current.ink,
        QPalette.ColorRole.ToolTipBase: current.back,
        QPalette.ColorRole.ToolTipText: current.ink,
        QPalette.ColorRole.Highlight: current.curves[0],
        QPalette.ColorRole.HighlightedText: current.back,
        QPalette.ColorRole.PlaceholderText: current.quiet,
    }
    for role, shade in shades.items():
        palette.setColor(role, QColor(shade))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText, QPalette.ColorRole.WindowText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(current.quiet))
    application().setPalette(palette)
    # Fusion draws the edge of a field 1.4 times darker than its window: this gives it 3 : 1 against its base
    edged = QPalette(palette)
    edged.setColor(QPalette.ColorRole.Window, QColor(current.edge).lighter(140))
    fields = ("QLineEdit", "QPlainTextEdit", "QComboBox", "QCheckBox", "QSlider")
    for kind in (*fields, "QGroupBox", "QToolButton", "QPushButton"):
        application().setPalette(edged, kind)  # type: ignore[arg-type]  # the stub asks for bytes, which Qt refuses
