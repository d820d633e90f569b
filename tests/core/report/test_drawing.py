"""A matplotlibrc of the user or of the folder changes no figure that leaves the program."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from core.case.solids import Opening
from core.case.wall import Wall
from core.lab.research import figures, study_files
from core.report.note import document
from core.report.note.parts import Curve, Figure
from core.report.note.wall_figures import elevation
from core.report.words import Words

mpl = pytest.importorskip("matplotlib")

OF_A_USER = {"lines.linewidth": 9, "axes.facecolor": "red", "savefig.dpi": 30, "font.size": 20}


def test_that_the_settings_of_a_user_change_no_figure():
    series = tuple(
        figures.Series(look, (1.0, 2.0, 3.0), (1.0, 2.0, 4.0), look, k)
        for k, look in enumerate((figures.POINTS, figures.LINE, figures.DASHED))
    )
    of_study = figures.Figure("key", "title", "x", "y", series)
    of_note = Figure("caption", [Curve("", [0.0, 1.0], [0.0, 2.0], "ink")], x="x", y="y")

    def drawn():
        return study_files.figure_files(of_study), document.picture(of_note, Words("en"))

    plain = drawn()
    with mpl.rc_context(OF_A_USER):
        assert drawn() == plain
        assert mpl.rcParams["lines.linewidth"] == 9


def test_that_the_elevation_of_a_body_speaks_of_openings_only_where_it_has_some():
    words = Words("en")
    for openings, said in (((), "w: elevation"), ((Opening(1.0, 1.0, 1.0, 1.0),), "w: elevation, openings in red")):
        wall = Wall("w", "one_sided", height_m=6.0, thickness_m=0.5, length_m=4.0, unit_weight_kn_m3=18.0, gable_m=1.0)
        figure = elevation(SimpleNamespace(name="w", wall=replace(wall, openings=openings)), words)
        assert figure.caption == said
