"""The start of the window: application, theme, language, recovery, kernels, errors of slots, logs of crashes."""

import contextlib
import faulthandler
import gc
import os
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QLibraryInfo, QSettings, QStandardPaths, QTimer, QTranslator
from PySide6.QtGui import QFileOpenEvent, QIcon
from PySide6.QtWidgets import QApplication, QMessageBox

from app.look import language, theme
from app.look.labels import escape_html
from app.look.language import quoted_from_file, tr
from app.shell import menus
from app.shell.files import EXAMPLE
from app.shell.window import MainWindow
from app.work import recovery
from app.work.worker import RUNNING_JOBS, write_log
from core.errors import InputError
from core.text.sentence import LANGUAGES
from core.text.start import system_language
from core.version import NAME, VERSION

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ribalta.png"


def offer_recovery(window: MainWindow) -> None:
    """After a crash: the autosaved case, if the user wants it back."""
    for file in window.session.recoverable():
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            window,
            tr("Autosaved case found"),
            escape_html(
                tr("The program ended without saving. Restore the unsaved case?") + f"\n{recovery.describe(file)}"
            ),
            button.Yes | button.Discard | button.Cancel,
            button.Yes,
        )
        if answer == button.Yes:
            try:
                window.start_afresh(partial(window.session.recover, file))
                return
            except InputError as error:
                QMessageBox.warning(window, tr("Not opened"), escape_html(quoted_from_file(error)))
        elif answer == button.Discard:
            recovery.delete_states(file)
        # anything else, Esc among it, is no order to discard: asked again at the next start


def install_hook(window: MainWindow) -> None:
    """An exception in a slot: a log and a dialog, never a silent stop. One that comes at every change of the case is
    one dialog until it is closed."""
    open_now = set()

    def hook(kind, value, trace) -> None:
        import traceback

        sentence = f"{kind.__name__}: {value}"
        if sentence in open_now:
            return
        log = write_log("".join(traceback.format_exception(kind, value, trace)))

        def tell() -> None:
            window.runner.fail(sentence, log)
            open_now.discard(sentence)

        open_now.add(sentence)
        QTimer.singleShot(0, window, tell)

    sys.excepthook = hook


def translate_qt(application: QApplication) -> None:
    """Qt's own dialogs and menus in the language of the window."""
    translator = QTranslator(application)
    folder = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)

    def follow(code: str) -> None:
        application.removeTranslator(translator)
        if code != "en" and translator.load(f"qtbase_{code}", folder):
            application.installTranslator(translator)

    language.followers.append(follow)


def data_folder() -> Path:
    """Where settings, recovery files and logs of crashes are kept; a temporary one for a user who has none."""
    folder = Path(QStandardPaths.writableLocation(QStandardPaths.StandardLocation.AppDataLocation))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return Path(tempfile.mkdtemp(prefix="ribalta-data-"))
    return folder


@contextlib.contextmanager
def logged_crash(folder: Path):
    """Where the process ends by a fault of a library, what it was doing goes to a file of this folder. Yields the
    files of earlier starts, each once."""
    crash_logs = []
    with contextlib.suppress(OSError):
        for file in sorted(folder.glob("crash-*.log")):
            if file.stat().st_size:
                crash_logs.append(file.replace(file.with_suffix(".txt")))
    with tempfile.NamedTemporaryFile("w", dir=folder, prefix=f"crash-{VERSION}-", suffix=".log", delete=False) as log:
        faulthandler.enable(log)
        yield crash_logs
        faulthandler.disable()
    Path(log.name).unlink(missing_ok=True)


class Application(QApplication):
    """Opens in the window what the system asks the application to open: on macOS a double click on a case."""

    opens: Callable[[Path], object] | None = None

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QFileOpenEvent) and self.opens is not None:
            self.opens(Path(event.file()))
            return True
        return super().event(event)


def make(arguments: list[str] | None = None) -> tuple[QApplication, MainWindow]:
    """The application and its window, not shown yet."""
    instance = QApplication.instance()
    application = instance if isinstance(instance, QApplication) else Application(arguments or sys.argv[:1])
    application.setApplicationName(NAME)
    application.setOrganizationName(NAME)
    application.setWindowIcon(QIcon(str(ICON)))
    folder = data_folder()
    settings = QSettings(str(folder / "window.ini"), QSettings.Format.IniFormat)
    translate_qt(application)
    theme.set_theme(menus.chosen(settings, "theme", theme.THEMES) or "light")
    asked = menus.chosen(settings, "language", LANGUAGES)
    language.set_language(asked or system_language())
    return application, MainWindow(settings, folder / "autosave")


def show(window: MainWindow) -> None:
    """Show the window. Python's collector is not to look through what is there by now again and again: it
    would hold up the window for as long."""
    window.show()
    gc.freeze()


def show_start_error(text: str) -> None:
    """A sentence in a dialog before there is a window."""
    application = QApplication.instance()
    if not isinstance(application, QApplication):
        application = QApplication([])
    QMessageBox.critical(application.activeWindow(), NAME, escape_html(text))


def main(path: Path | None) -> int:
    """Show the window, on this case or the example; returns its exit code."""
    application, window = make()
    install_hook(window)
    if isinstance(application, Application):
        application.opens = window.files.open
    show(window)
    if path is not None:
        window.files.open(path)
    else:
        window.session.open(EXAMPLE)
        window.show_first_run()
    QTimer.singleShot(0, lambda: offer_recovery(window))
    window.preparation.begin()
    with logged_crash(Path(window.settings.fileName()).parent) as crashes:
        if crashes:
            word = tr("The program crashed last time; please send {path}", path=crashes[-1])
            window.show_word(word)
        code = application.exec()
    if any(not job.isFinished() for job in RUNNING_JOBS):
        # a thread that compiles cannot be stopped, and nobody is to wait for it
        from core.jit import cache
        from core.study import precompile

        precompile.end()
        cache.close()
        window.settings.sync()
        os._exit(code)
    return code
