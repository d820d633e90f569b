"""The place of the building: by the name of its municipality, by coordinates, on the map."""

from dataclasses import replace

from PySide6.QtCore import QStringListModel, Qt
from PySide6.QtWidgets import QCompleter, QGroupBox, QLabel, QLineEdit, QVBoxLayout, QWidget

from app.input.fields import connect
from app.input.made_fields import make_field
from app.input.place_map import PlaceMap
from app.look import theme
from app.look.language import described, number, tr
from app.work.session import Session
from core.case.coordinates import parse_coordinates
from core.case.place import Site
from core.codes.limits import EXCEEDANCE
from core.errors import InputError

ELSEWHERE = {"site": "", "coordinates": "", "return_period_years": None, "hazard_file": None}
"""Keys of a demand that a place takes the place of."""

OFFERED = 12
"""Municipalities the list of a search shows."""


class PlaceForm(QWidget):
    """Edits [site]. While it is given, the demand follows from it."""

    def __init__(self, session: Session):
        super().__init__()
        self.session = session
        self.given = QGroupBox(tr("From the place (national grid)"))
        self.given.setCheckable(True)
        self.given.toggled.connect(self._toggled)
        self.search, self.point = QLineEdit(), QLineEdit()
        self.search.setPlaceholderText(tr("Municipality"))
        self.search.setAccessibleName(tr("Municipality"))
        self.point.setPlaceholderText("42.3498 N 13.3995 E, 42°20'59\" 13°23'58\"")
        self.point.setAccessibleName(tr("Coordinates"))
        self.names = QStringListModel()
        completer = QCompleter(self.names, self)
        completer.setCompletionMode(QCompleter.CompletionMode.UnfilteredPopupCompletion)
        completer.setCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        completer.activated.connect(self._named)
        self.search.setCompleter(completer)
        self.search.textEdited.connect(self._offer)
        self.search.editingFinished.connect(lambda: self._named(self.search.text()))
        self.point.editingFinished.connect(self._pointed)
        self.fields = [make_field(Site, key) for key in ("nominal_life_years", "use_class")]
        connect(self.fields, self._changed)
        self.words, self.states = QLabel(), QLabel()
        self.words.setWordWrap(True)
        self.states.setTextFormat(Qt.TextFormat.RichText)
        self.states.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.map = PlaceMap()
        self.map.chosen.connect(lambda *at: self._edit(("site", "point"), latitude=at[0], longitude=at[1]))
        inside = QVBoxLayout(self.given)
        source = QLabel(tr("Grid: D.M. 14/01/2008, Annex B. Municipalities: ISTAT, GeoNames (CC BY 4.0)."))
        source.setWordWrap(True)
        source.setStyleSheet(f"color: {theme.current.quiet};")
        self.inside = (self.search, self.point, *self.fields, self.words, self.states, self.map, source)
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
            for line in (self.search, self.point):
                line.clear()
            self.words.clear()
            self.states.clear()
            self.map.show_point(None)
            return
        for field in self.fields:
            field.show_value(getattr(site, field.key))
        name = f"{site.municipality} ({site.province})" if site.province else site.municipality
        if not self.search.hasFocus() and self.search.text() != name:
            self.search.setText(name)
        if not self.point.hasFocus():
            given = None not in (site.latitude, site.longitude)
            self.point.setText(f"{site.latitude:.6g}, {site.longitude:.6g}" if given else "")
        self._say(site)

    def _say(self, site: Site) -> None:
        """The nodes with their distances, and the limit states."""
        try:
            hazard = site.hazard
        except (InputError, TypeError) as error:
            self.words.setText(described(error) if isinstance(error, InputError) else "")
            self.states.clear()
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
                self.states.clear()
                return
            values = zip(hazard.at(years), (".3f", ".3f", ".3f"), strict=True)
            cells = [state, number(years, ".0f"), *(number(value, form) for value, form in values)]
            rows.append("".join(f"<td align='right'>{cell}&nbsp;&nbsp;</td>" for cell in cells))
        heads = "".join(f"<th align='right'>{head}&nbsp;&nbsp;</th>" for head in ("", "T_R", "a_g [g]", "F_0", "T_C*"))
        body = "".join(f"<tr>{row}</tr>" for row in rows)
        self.states.setText(f"<table><tr>{heads}</tr>{body}</table>")

    def _toggled(self, on: bool) -> None:
        case = self.session.case
        demand = replace(case.demand, **ELSEWHERE) if on and case.demand else case.demand
        self.session.edit(replace(case, site=Site() if on else None, demand=demand))

    def _edit(self, place: object = None, **values) -> None:
        site = self.session.case.site
        if site is not None:
            self.session.edit(replace(self.session.case, site=replace(site, **values)), place)

    def _changed(self, field, value) -> None:
        self._edit(("site", field.key), **{field.key: value})

    def _offer(self, text: str) -> None:
        """The municipalities of the letters typed so far."""
        from core.codes.national_hazard import beginning_with

        found = beginning_with(text, OFFERED)
        self.names.setStringList([f"{one.name} ({one.province})" for one in found])

    def _named(self, text: str) -> None:
        """A municipality is chosen: its seat is the point until another one is put."""
        name, _, rest = text.strip().partition(" (")
        site, province = self.session.case.site, rest.rstrip(")")
        if site is not None and (name, province) != (site.municipality, site.province):
            self._edit(None, municipality=name, province=province, latitude=None, longitude=None)

    def _pointed(self) -> None:
        text, site = self.point.text().strip(), self.session.case.site
        if site is None or not self.point.isModified():
            return
        self.point.setModified(False)
        if not text:
            self._edit(None, latitude=None, longitude=None)
            return
        try:
            latitude, longitude = parse_coordinates(text)
        except InputError as error:
            self.words.setText(described(error))
            return
        self._edit(None, latitude=latitude, longitude=longitude)
