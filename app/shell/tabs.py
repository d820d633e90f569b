"""The pages of the stages Answer, Why and Report."""

from collections.abc import Callable

from app.look.language import tr
from app.shell.navigator import Navigator
from app.shell.pages import Page
from app.views.capacity_tab import CapacityTab
from app.views.check_tab import CheckTab
from app.views.histories_tab import HistoriesTab
from app.views.note_tab import NoteTab
from app.views.result_tabs import IntensityTab, SpectraTab
from app.views.sure_tab import SureTab
from app.views.validation_tab import ValidationTab
from app.views.walls_tab import WallsTab


def pages(
    language: str, navigator: Callable[[], Navigator], export_note: Callable[[], None]
) -> dict[str, tuple[Page, str]]:
    """Pages and their labels by name. navigator() : asked when a page is made, which is after all are placed"""

    def walls() -> WallsTab:
        tab = WallsTab(language)
        tab.picked.connect(navigator().pick)
        return tab

    def check() -> CheckTab:
        tab = CheckTab(language)
        tab.asked.connect(navigator().ask)
        tab.record_picked.connect(navigator().pick_run)
        return tab

    def sure() -> SureTab:
        tab = SureTab(language)
        tab.asked.connect(navigator().ask)
        return tab

    def validation() -> ValidationTab:
        tab = ValidationTab()
        tab.asked.connect(navigator().state_accuracy)
        return tab

    def note() -> NoteTab:
        tab = NoteTab(lambda: navigator().session.base_dir)
        tab.checked.connect(navigator().pick)
        tab.picked.connect(navigator().pick_input)
        tab.exported.connect(export_note)
        return tab

    return {
        "walls": (Page(walls), tr("Overview")),
        "check": (Page(check), tr("Answer")),
        "histories": (Page(HistoriesTab), tr("Histories")),
        "sure": (Page(sure), tr("How sure")),
        "capacity": (Page(CapacityTab), tr("Capacity and fragility")),
        "intensity": (Page(IntensityTab), tr("q against SI")),
        "spectra": (Page(lambda: SpectraTab(language)), tr("Records and spectra")),
        "validation": (Page(validation), tr("Accuracy")),
        "note": (Page(note), tr("Note")),
    }
