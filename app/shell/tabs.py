"""The pages of the stages Answer, Why and Report."""

from app.look.language import tr
from app.shell.pages import Page
from app.views.capacity_tab import CapacityTab
from app.views.check_tab import CheckTab
from app.views.histories_tab import HistoriesTab
from app.views.result_tabs import IntensityTab, SpectraTab
from app.views.sure_tab import SureTab
from app.views.walls_tab import WallsTab


def pages(language: str, validation, pick, note, ask, pick_run) -> dict[str, tuple[Page, str]]:
    """Pages and their labels by name. validation, note : make these tabs; pick(k) : shows the k-th wall; ask(what) :
    leads to what the answer asks for; pick_run(run) : shows the history of (motion, polarity)"""

    def walls() -> WallsTab:
        tab = WallsTab(language)
        tab.picked.connect(pick)
        return tab

    def check() -> CheckTab:
        tab = CheckTab(language)
        tab.asked.connect(ask)
        tab.record_picked.connect(pick_run)
        return tab

    def sure() -> SureTab:
        tab = SureTab(language)
        tab.asked.connect(ask)
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
