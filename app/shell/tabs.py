"""The pages of the stages Answer, Why and Report."""

from collections.abc import Callable

from PySide6.QtWidgets import QWidget

from app.look.language import tr
from app.shell.navigator import Navigator
from app.shell.pages import Page
from app.views.capacity_tab import CapacityTab
from app.views.check_tab import CheckTab
from app.views.histories_tab import HistoriesTab
from app.views.result_tabs import IntensityTab, SpectraTab
from app.views.sure_tab import SureTab
from app.views.walls_tab import WallsTab


def pages(
    language: str, navigator: Callable[[], Navigator], validation: Callable[[], QWidget], note: Callable[[], QWidget]
) -> dict[str, tuple[Page, str]]:
    """Pages and their labels by name. navigator() : asked when a page is made, which is after all are placed;
    validation, note : make these tabs"""

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
