"""The pages of the stages Answer, Why and Report, each imported when it is made: few are looked at in every session."""

from collections.abc import Callable

from PySide6.QtWidgets import QWidget

from app.look.language import tr
from app.shell.navigator import Navigator
from app.shell.pages import LazyPage


def histories() -> QWidget:
    """The rocking wall, for its page and for the room beside the answer."""
    from app.views.histories_tab import HistoriesTab

    return HistoriesTab()


def pages(
    language: str, navigator: Callable[[], Navigator], export_note: Callable[[], None]
) -> dict[str, tuple[LazyPage, str]]:
    """Pages and their labels by name. navigator() : asked when a page is made, which is after all are placed"""

    def walls() -> QWidget:
        from app.views.walls_tab import WallsTab

        tab = WallsTab(language)
        tab.picked.connect(navigator().pick)
        tab.row_picked.connect(navigator().pick_row)
        return tab

    def check() -> QWidget:
        from app.views.check_tab import CheckTab

        tab = CheckTab(language)
        tab.asked.connect(navigator().ask)
        tab.record_picked.connect(navigator().show_run_history)
        return tab

    def sure() -> QWidget:
        from app.views.sure_tab import SureTab

        tab = SureTab(language)
        tab.asked.connect(navigator().ask)
        return tab

    def capacity() -> QWidget:
        from app.views.capacity_tab import CapacityTab

        return CapacityTab()

    def intensity() -> QWidget:
        from app.views.result_tabs import IntensityTab

        return IntensityTab()

    def spectra() -> QWidget:
        from app.views.result_tabs import SpectraTab

        return SpectraTab(language)

    def validation() -> QWidget:
        from app.views.validation_tab import ValidationTab

        tab = ValidationTab()
        tab.asked.connect(navigator().state_accuracy)
        return tab

    def note() -> QWidget:
        from app.views.note_tab import NoteTab

        tab = NoteTab(lambda: navigator().session.base_dir)
        tab.checked.connect(navigator().pick)
        tab.picked.connect(navigator().pick_input)
        tab.exported.connect(export_note)
        return tab

    return {
        "walls": (LazyPage(walls), tr("Overview")),
        "check": (LazyPage(check), tr("Answer")),
        "histories": (LazyPage(histories), tr("Histories")),
        "sure": (LazyPage(sure), tr("How sure")),
        "capacity": (LazyPage(capacity), tr("Capacity and fragility")),
        "intensity": (LazyPage(intensity), tr("q against SI")),
        "spectra": (LazyPage(spectra), tr("Records and spectra")),
        "validation": (LazyPage(validation), tr("Accuracy")),
        "note": (LazyPage(note), tr("Note")),
    }
