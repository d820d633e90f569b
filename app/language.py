"""The language of the window: Qt Linguist files of resources/translations."""

from PySide6.QtCore import QCoreApplication, QLocale, QTranslator

from app import sentences

FOLDER = sentences.FOLDER
LANGUAGES = {"en": "English", "it": "Italiano"}

_installed: list[QTranslator] = []


def tr(text: str) -> str:
    """A visible string in the language of the window."""
    return QCoreApplication.translate("", text)


def set_language(code: str) -> None:
    """Install the translations of "en" or "it"; widgets made from now on speak it."""
    application = QCoreApplication.instance()
    while _installed:
        application.removeTranslator(_installed.pop())
    sentences.speak(code)
    if code != "en":
        translator = QTranslator()
        if translator.load(str(FOLDER / f"ribalta_{code}.qm")):
            application.installTranslator(translator)
            _installed.append(translator)


def system_language() -> str:
    """The system's language where it is one of ours, else English."""
    code = QLocale.system().name()[:2]
    return code if code in LANGUAGES else "en"
