"""The demand, the analysis and the title block of the report."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import QFileDialog, QGroupBox, QPushButton, QVBoxLayout, QWidget

from app.input.building_form import BuildingForm
from app.input.editors import Choice
from app.input.evidence_form import DemandEvidenceForm
from app.input.fields import ChoiceField, Field, clear_fields, connect
from app.input.hazard_form import HazardForm
from app.input.made_fields import make_field, make_fields
from app.input.note_form import title_field, with_button
from app.input.place_form import PlaceForm
from app.look import theme
from app.look.case_views import CaseViews
from app.look.labels import PlainLabel
from app.look.language import current_language, describe_message, number, result_word, tr
from app.look.section import FoldingSection
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from core.case.place import OF_SPECTRUM, apply_site
from core.case.schema import Analysis, Generate, Report
from core.case.site import Demand, Spectrum, least_factor
from core.codes.demand import unusual_ag_notices
from core.codes.limits import EXCEEDANCE
from core.codes.spectrum_codes import CODES, NATIONAL, requires_key
from core.codes.target_spectrum import Target
from core.errors import InputError
from core.known import require_value
from core.setting.demand_input import read_target_spectrum
from core.units import G

if TYPE_CHECKING:
    from app.input.law_curve import SpectrumCurve

RESTED = 120
"""Time after a key before the spectrum is drawn again [ms]."""

SITE_KEYS = ("ag_g", "site", "coordinates", "nominal_life_years", "use_class_factor", "return_period_years")
"""Fields of the demand that a place makes needless."""


def has_return_period(demand: Demand) -> bool:
    """Whether its return period is known."""
    try:
        return demand.return_period is not None
    except TypeError:  # still to be given
        return False


def make_by(fields: list[Field], group: str) -> list[Field]:
    """Those of these fields that stand in a group of the form."""
    return [field for field in fields if field.entry.metadata.get("form") == group]


class DemandForm(QWidget):
    """Edits [demand]. motions_asked : motions are to be generated for the spectrum"""

    motions_asked = Signal()

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.place: PlaceForm | None = None
        self.forget()
        self.given = QGroupBox(tr("Check against a demand"))
        self.given.setCheckable(True)
        self.given.toggled.connect(self._toggled)
        self._make_spectrum()
        motion = [make_field(Demand, key) for key in ("limit_state", "ag_g", "soil_factor", "housner_intensity_cm")]
        self.of_spectrum = make_fields(Spectrum, "code", first=("f0", "tc_star_s"))
        below = [
            *make_fields(Demand, "knowledge"),
            *make_fields(Demand, "check", first=("demand_scaling", "period_range_s", "zeta_target")),
            *make_fields(Demand, "site"),
        ]
        self.of_demand = [*motion, *below]
        self.fields = {field.key: field for field in (*self.of_demand, *self.of_spectrum)}
        connect(self.of_demand, self._changed)
        connect(self.of_spectrum, self._spectrum_changed)
        self.curve: SpectrumCurve | None = None
        self.target: Target | None = None
        self.rested = QTimer(self)
        self.rested.setSingleShot(True)
        self.rested.setInterval(RESTED)
        self.rested.timeout.connect(self._draw)
        self.view = QWidget()
        self.curve_place = QVBoxLayout(self.view)
        self.curve_place.addWidget(self.summary)
        self.no_records = QPushButton(tr("No records yet: generate {n} motions →", n=Generate().count))
        self.no_records.setFlat(True)
        self.no_records.setStyleSheet(f"color: {theme.current.curves[0]}; text-align: left;")
        self.no_records.clicked.connect(lambda _=False: self.motions_asked.emit())
        self.curve_place.addWidget(self.no_records)
        inside = QVBoxLayout(self.given)
        self.place = PlaceForm(session)
        for widget in (self.place, *motion[:2], self.hint, self.kind, *motion[2:], *self.of_spectrum, self.file):
            inside.addWidget(widget)
        self.hazard = HazardForm(session)
        self.sections = [
            FoldingSection(tr("Confidence factor"), make_by(below, "knowledge"), open=True),
            FoldingSection(tr("Records at the demand, limits"), make_by(below, "check")),
            FoldingSection(tr("Site, return period, hazard"), [*make_by(below, "site"), self.hazard]),
        ]
        for widget in self.sections:
            inside.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        self.building, self.evidence = BuildingForm(session), DemandEvidenceForm(session)
        for widget in (self.given, FoldingSection(tr("Evidence"), [self.evidence])):
            layout.addWidget(widget)
        layout.addStretch(1)
        self.parts = CaseViews(
            self, self._show_demand, self.place.show_case, self.hazard.show_case, self.evidence.show_case
        )

    def forget(self) -> None:
        """Another case: what was switched off in the last one does not come back in this."""
        if self.place is not None:
            self.place.forget()
        self.last: tuple | None = None
        self.spectra = {code: Spectrum(code, "") for code in CODES}  # "": not given yet

    def _make_spectrum(self) -> None:
        """How the spectrum is given, with what is said of it."""
        self.hint, self.summary = PlainLabel(), PlainLabel()
        self.hint.setWordWrap(True)
        self.summary.setWordWrap(True)
        self.kind = Choice()
        self.kind.setAccessibleName(tr("Spectrum"))
        for name, shown in (
            ("none", tr("no spectrum, S given")),
            *((name, code.name) for name, code in CODES.items()),
            ("file", tr("spectrum of a file")),
        ):
            self.kind.addItem(shown, name)
        self.kind.activated.connect(self._kind_chosen)
        self.file = QPushButton(tr("Choose file…"))
        self.file.clicked.connect(self._choose_file)

    def show_case(self) -> None:
        """Fill the form from the session."""
        self.parts.show()

    def _show_demand(self) -> None:
        demand = self.session.case.demand
        self.given.blockSignals(True)
        self.given.setChecked(demand is not None)
        self.given.blockSignals(False)
        self.no_records.hide()
        if demand is None:
            clear_fields((*self.of_demand, *self.of_spectrum))
            self.kind.setCurrentIndex(-1)
            for label in (self.hint, self.summary):
                label.setText("")
            for section in self.sections:
                section.say()
            self._await(None)
            return
        for field in self.of_demand:
            field.show_value(getattr(demand, field.key))
        self._say_contents(demand)
        self.hint.setText(self._asked(demand.ag_g))
        spectrum, kind = demand.spectrum, self._kind_of(demand)
        self.kind.setCurrentIndex(self.kind.findData(kind))
        for field in self.of_spectrum:
            if spectrum:
                field.show_value(getattr(spectrum, field.key))
            field.setVisible(spectrum is not None and requires_key(spectrum.code, field.key) is not False)
        self._show_given(spectrum)
        self.fields["soil_factor"].setVisible(spectrum is None)
        self.fields["housner_intensity_cm"].setVisible(kind == "none")
        self.file.setVisible(kind == "file")
        self.file.setText(demand.spectrum_file or tr("Choose file…"))
        try:
            target = read_target_spectrum(demand, self.session.base_dir)
        except InputError as error:
            target = None
            self.summary.setText(describe_message(error))
        except (TypeError, KeyError):  # values of the site are still to be given
            target = None
            self.summary.setText(tr("The values of the site are still missing."))
        else:
            self.summary.setText(self._said(demand, target))
        case = self.session.case
        self.no_records.setVisible(target is not None and not case.record and case.generate is None)
        self._await(target)

    def _await(self, target: Target | None) -> None:
        """Draw this spectrum when the hand rests; the first one at once, and none."""
        self.target = target
        if self.curve is None or target is None:
            self.rested.stop()
            self._draw()
        else:
            self.rested.start()

    def _draw(self) -> None:
        """The spectrum, where it is seen: it is made and drawn when it is looked at."""
        if not self.isVisible():
            return
        target = self.target
        if self.curve is None:
            from app.input.law_curve import SpectrumCurve

            self.curve = SpectrumCurve()
            self.curve.setMaximumHeight(420)
            self.curve_place.addWidget(self.curve, 1)
            self.curve_place.addStretch(0)
        demand = self.session.case.demand
        self.curve.show_target(target, self._other_states(demand) if target and demand else {})

    def _show_given(self, spectrum: Spectrum | None) -> None:
        """What follows from the place is not asked for."""
        free = self.session.case.site is None
        for key in SITE_KEYS:
            self.fields[key].setVisible(free)
        for key in OF_SPECTRUM:
            self.fields[key].setVisible(free and spectrum is not None and spectrum.code == NATIONAL)
        self.hazard.setVisible(free)

    def _other_states(self, demand: Demand) -> dict:
        """The spectra of the other limit states of the place."""
        site = self.session.case.site
        if site is None:
            return {}
        others = (state for state in EXCEEDANCE if state != demand.limit_state)
        return {
            state: read_target_spectrum(
                require_value(apply_site(site, replace(demand, limit_state=state))), self.session.base_dir
            )
            for state in others
        }

    def _say_contents(self, demand: Demand) -> None:
        """What each folded section holds."""
        scaling = next(
            field for field in self.of_demand if isinstance(field, ChoiceField) and field.key == "demand_scaling"
        )
        said = (
            f"FC {number(demand.confidence_factor, 'g')}, {result_word(f'confidence_{demand.confidence_on}')}",
            f"{scaling.words[demand.demand_scaling]}, ζ {number(demand.zeta_target, 'g')}, "
            f"q {number(demand.q_code, 'g')}",
            ", ".join(
                filter(
                    None,
                    (demand.site, f"T_R {number(demand.return_period, '.0f')}" if has_return_period(demand) else ""),
                )
            ),
        )
        for section, words in zip(self.sections, said, strict=True):
            section.say(words)

    def showEvent(self, event) -> None:
        super().showEvent(event)
        self.show_case()
        self._draw()

    @staticmethod
    def _kind_of(demand: Demand) -> str:
        """Where the spectrum is from."""
        return demand.spectrum.code if demand.spectrum else "file" if demand.spectrum_file else "none"

    @staticmethod
    def _asked(ag) -> str:
        """What a_g is, or whether it is meant."""
        doubts = unusual_ag_notices(ag * G) if isinstance(ag, float | int) else []
        words = "\n".join(doubt.text(current_language()) for doubt in doubts)
        return words or tr("a_g on rigid ground, S apart")

    @staticmethod
    def _said(demand: Demand, target) -> str:
        if target is None:
            if not isinstance(demand.ag_g, float | int):
                return ""
            return f"S a_g {number(demand.ag_g * (demand.soil_factor or 1.0), '.3f')} g"
        words = f"S {number(target.soil, '.3f')}, S a_g {number(target.pga / G, '.3f')} g"
        if hasattr(target, "t_b"):
            periods = (("T_B", target.t_b), ("T_C", target.t_c), ("T_D", target.t_d))
            words += "\n" + ", ".join(f"{name} {number(value, '.3f')} s" for name, value in periods)
        return words

    def _toggled(self, on: bool) -> None:
        """With the demand go the motions made for it; both come back as they were."""
        case = self.session.case
        if on:
            demand, made = self.last or (Demand(TO_BE_GIVEN), None)  # what is of the site is never assumed
            self.session.edit(replace(case, demand=demand, generate=made))
        else:
            self.last = (case.demand, case.generate)
            self.session.edit(replace(case, demand=None, generate=None))

    def _changed(self, field, value) -> None:
        demand, values = self.session.case.demand, {field.key: value}
        if demand is None:
            return
        if field.key == "knowledge_level":  # FC follows the level; another one that was given stays, but none below it
            stated, least = demand.confidence_factor, least_factor(value)
            own = stated != least_factor(demand.knowledge_level)
            values["confidence_factor"] = max(stated, least) if own else least
        self.session.edit_section("demand", ("demand", field.key), **values)

    def _spectrum_changed(self, field, value) -> None:
        demand = self.session.case.demand
        if demand and demand.spectrum:
            spectrum = replace(demand.spectrum, **{field.key: value})
            self.session.edit_section("demand", ("demand", field.key), spectrum=spectrum)

    def _kind_chosen(self, index: int) -> None:
        kind, demand = self.kind.itemData(index), require_value(self.session.case.demand)
        if kind == self._kind_of(demand) != "file":
            return
        if demand.spectrum:
            self.spectra[demand.spectrum.code] = demand.spectrum
        values: dict[str, Any] = {"spectrum": None, "spectrum_file": None}
        values["spectrum"] = self.spectra.get(kind)
        if values["spectrum"]:
            values |= {"soil_factor": None, "housner_intensity_cm": None}
        if kind == "file":
            self._choose_file()
            return
        self.session.edit_section("demand", **values)

    def _choose_file(self) -> None:
        name, _ = QFileDialog.getOpenFileName(self, tr("Spectrum: two columns, s and g"), str(self.session.base_dir))
        if name:
            self.session.edit_section(
                "demand", spectrum=None, spectrum_file=self.session.relative(Path(name)), housner_intensity_cm=None
            )
        else:
            self.show_case()


class AnalysisForm(QWidget):
    """Edits [analysis] and [report]."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.of_analysis, self.of_report = make_fields(Analysis), make_fields(Report)
        connect(
            self.of_analysis,
            lambda field, value: session.edit_section("analysis", ("analysis", field.key), **{field.key: value}),
        )
        connect(
            self.of_report,
            lambda field, value: session.edit_section("report", ("report", field.key), **{field.key: value}),
        )
        self.title_field = title_field(session)
        with_button(next(field for field in self.of_report if field.key == "logo"), session)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        for label, chosen in ((tr("Report"), [self.title_field, *self.of_report]), (tr("Analysis"), self.of_analysis)):
            group = QGroupBox(label)
            inside = QVBoxLayout(group)
            for field in chosen:
                inside.addWidget(field)
            layout.addWidget(group)
        layout.addStretch(1)

    def show_case(self) -> None:
        """Fill the form from the session."""
        case = self.session.case
        self.title_field.show_value(case.title)
        for field in self.of_analysis:
            field.show_value(getattr(case.analysis, field.key))
        for field in self.of_report:
            field.show_value(getattr(case.report, field.key))
