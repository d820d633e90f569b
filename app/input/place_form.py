"""The place of the building: by the name of its municipality, by coordinates, on the map."""

from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QGroupBox, QVBoxLayout, QWidget

from app.input.fields import clear_fields, connect
from app.input.made_fields import make_field
from app.input.place_fields import CoordinatesField, MunicipalityField
from app.input.place_map import PlaceMap
from app.look import theme
from app.look.labels import PlainLabel
from app.look.language import describe_message, number, tr
from app.work.draft import TO_BE_GIVEN
from app.work.session import Session
from app.work.site_demand import restored
from core.case.place import Site
from core.case.site import Demand, Spectrum
from core.codes.limits import EXCEEDANCE
from core.codes.spectrum_codes import NATIONAL
from core.errors import InputError

GIVEN_BY_PLACE: dict[str, Any] = {"site": "", "coordinates": "", "return_period_years": None, "hazard_file": None}
"""Keys of a demand that a place takes the place of."""


class States(QWidget):
    """The hazard at each limit state, a label for each column: a table of HTML takes ten times as long to be laid out.
    A label of one size moves nothing else in the form when its numbers change or are not known."""

    HEADS = ("", "T_R", "a_g [g]", "F_0", "T_C*")

    def __init__(self):
        super().__init__()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        self.columns = [(PlainLabel(), PlainLabel()) for _ in self.HEADS]
        for k, labels in enumerate(self.columns):
            for row, label in enumerate(labels):
                label.setAlignment(Qt.AlignmentFlag.AlignRight)
                label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
                grid.addWidget(label, row, k, Qt.AlignmentFlag.AlignRight)
            labels[0].setStyleSheet("font-weight: 600;")
        grid.setColumnStretch(len(self.HEADS), 1)

    def show_rows(self, rows: list[list[str]]) -> None:
        """Words of each state, none where they are not known."""
        for k, (head, body) in enumerate(zip(self.HEADS, self.columns, strict=True)):
            for label, text in zip(body, (head if rows else "", "\n".join(row[k] for row in rows)), strict=True):
                label.setText(text)
                if rows:
                    label.setFixedSize(label.sizeHint().expandedTo(label.minimumSize()))


class PlaceForm(QWidget):
    """Edits [site]. While it is given, the demand follows from it."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.forget()
        self.given = QGroupBox(tr("From the place (national grid)"))
        self.given.setCheckable(True)
        self.given.toggled.connect(self._toggled)
        self.municipality, self.coordinates = MunicipalityField(), CoordinatesField()
        self.search, self.point = self.municipality.editor, self.coordinates.editor
        self.municipality.edited.connect(self._named)
        self.coordinates.edited.connect(self._pointed)
        self.fields = [make_field(Site, key) for key in ("nominal_life_years", "use_class")]
        connect(self.fields, self._changed)
        self.words, self.states = PlainLabel(), States()
        self.words.setWordWrap(True)
        self.map = PlaceMap()
        self.map.chosen.connect(lambda *at: self._edit(("site", "point"), latitude=at[0], longitude=at[1]))
        inside = QVBoxLayout(self.given)
        source = PlainLabel(tr("Grid: D.M. 14/01/2008, Annex B. Municipalities: ISTAT, GeoNames (CC BY 4.0)."))
        source.setWordWrap(True)
        source.setStyleSheet(f"color: {theme.current.quiet};")
        self.inside = (
            *(self.municipality, self.coordinates, *self.fields),
            *(self.words, self.states, self.map, source),
        )
        for widget in self.inside:
            inside.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.given)

    def show_case(self) -> None:
        """Fill the form from the session."""
        site = self.session.case.site
        self.given.blockSignals(True)
        self.given.setChecked(site is not None)
        self.given.blockSignals(False)
        for widget in self.inside:
            widget.setVisible(site is not None)
        if site is None:
            clear_fields((self.municipality, self.coordinates, *self.fields))
            self.words.clear()
            self.states.show_rows([])
            self.map.show_point(None)
            return
        for field in self.fields:
            field.show_value(getattr(site, field.key))
        self.municipality.show_value((site.municipality, site.province))
        given = None not in (site.latitude, site.longitude)
        self.coordinates.show_value((site.latitude, site.longitude) if given else None)
        self._say(site)

    def _say(self, site: Site) -> None:
        """The nodes with their distances, and the limit states."""
        try:
            hazard = site.hazard
        except (InputError, TypeError) as error:
            self.words.setText(describe_message(error) if isinstance(error, InputError) else "")
            self.states.show_rows([])
            self.map.show_point(None)
            return
        self.map.show_point((hazard.latitude, hazard.longitude))
        around = zip(hazard.nodes, hazard.distances, strict=True)
        nodes = ", ".join(f"{node} ({number(km, '.1f')} km)" for node, km in around)
        words = tr("Nodes of the grid: {nodes}", nodes=nodes) if nodes else hazard.island
        if site.latitude is None:
            words += "\n" + tr("The centre of a town is not a building: put the point where it stands.")
        self.words.setText(words)
        rows = []
        for state in EXCEEDANCE:
            try:
                years = site.return_period(state)
            except TypeError:  # V_N is still to be given
                self.states.show_rows([])
                return
            values = zip(hazard.at(years), (".3f", ".3f", ".3f"), strict=True)
            rows.append([state, number(years, ".0f"), *(number(value, form) for value, form in values)])
        self.states.show_rows(rows)

    def forget(self) -> None:
        """Another case: nothing of the last one comes back in this."""
        self.before: Demand | None = None

    def _toggled(self, on: bool) -> None:
        case, demand = self.session.case, self.session.case.demand
        if on:
            self._begin(demand, Site())
            return
        if demand and self.before and demand.ag_g == "":  # it gave nothing
            demand = restored(demand, self.before)
        self.session.edit(replace(case, site=None, demand=demand))

    def _begin(self, demand: Demand | None, site: Site) -> None:
        """From now on the demand follows from the place."""
        self.before = demand
        demand = replace(demand, **GIVEN_BY_PLACE) if demand else None
        if demand and not (demand.spectrum or demand.spectrum_file or demand.soil_factor):
            # a place without a spectrum and S would be a demand on rock: soil and topography are asked for
            demand = replace(demand, spectrum=Spectrum(NATIONAL, ""), housner_intensity_cm=None)
        self.session.edit(replace(self.session.case, site=site, demand=demand))

    def take(self, municipality: str) -> None:
        """The demand of a municipality, as the list of the search names it."""
        case = self.session.case
        name, province = self.municipality.meant(municipality)
        named: dict[str, Any] = {"municipality": name, "province": province, "latitude": None, "longitude": None}
        if case.site is None:
            self._begin(case.demand or Demand(TO_BE_GIVEN), Site(**named))
        else:
            self._edit(**named)

    def _edit(self, place: object = None, **values) -> None:
        site = self.session.case.site
        if site is not None:
            self.session.edit(replace(self.session.case, site=replace(site, **values)), place)

    def _changed(self, field, value) -> None:
        self._edit(("site", field.key), **{field.key: value})

    def _named(self, value: tuple[str, str]) -> None:
        """A municipality is chosen: its seat is the point until another one is put."""
        name, province = value
        self._edit(("site", "municipality"), municipality=name, province=province, latitude=None, longitude=None)

    def _pointed(self, value: tuple[float, float] | None) -> None:
        latitude, longitude = value or (None, None)
        self._edit(("site", "coordinates"), latitude=latitude, longitude=longitude)
