"""What a client is told is the outcome of the wall, whichever of its hinges is open."""

import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
pytest.importorskip("PySide6.QtWidgets", reason="Qt cannot start here", exc_type=ImportError)

from app.shell import client_view
from app.shell.client_view import ClientView, sides_of
from core.case.rules import parse_case
from core.study.run import run
from tests.app.driving import settle

WALL = {"name": "w", "height_m": 6.0, "thickness_m": 0.6, "mechanism": "one_sided", "base_z_m": 0.0}
WALL |= {"unit_weight_kn_m3": 18.0, "hold": [{"kind": "cross_walls"}], "unloaded_confirmed": True}
SPECTRUM = {"code": "EN1998", "type": 1, "soil": "B"}


@pytest.fixture(scope="module")
def result():
    walls = [WALL | {"variant": "stato di fatto"}, WALL | {"variant": "progetto", "thickness_m": 0.75}]
    table = {"wall": walls, "building": {"height_m": 9.0, "storeys": 3, "period_s": 0.3}}
    table |= {
        "demand": {"ag_g": 0.15, "spectrum": SPECTRUM},
        "generate": {"scatter": 0.0, "count": 3},
        "analysis": {"q_step": 0.1},
    }
    return run(parse_case(table), base_dir=Path())


@pytest.mark.shows("window.client")
def test_that_whichever_hinge_is_shown_the_share_and_the_outcome_are_those_of_the_wall(result):
    assert len(result.walls) > len(result.verdicts) == 2
    zetas = {wall.assessment.verdict.zeta_e for wall in result.walls}
    assert len(zetas) > 2  # the hinges differ
    for shown in result.walls:
        sides = sides_of(result, shown)
        for side, verdict in zip(sides, result.verdicts, strict=True):
            decides = result.walls[verdict.governing]
            assert side.share == verdict.zeta_least / decides.assessment.verdict.zeta_target
            assert side.wall is decides


@pytest.mark.shows("window.client")
def test_that_of_records_that_are_not_at_the_demand_no_share_of_it_is_told(result):
    """119 % was told whatever a_g was."""
    apart = replace(result, compliance=replace(result.compliance, compatible=False))
    for side in sides_of(apart, apart.walls[0]):
        decides = side.wall.assessment.verdict.governing
        assert (side.share is None) == (decides == "dynamic")
    assert all(side.share is not None for side in sides_of(result, result.walls[0]))


def test_that_a_film_is_made_while_the_window_lives_and_can_be_cancelled(result, application, tmp_path, monkeypatch):
    """Its frames are those of the view, in real time; a cancelled one leaves no file."""
    from PIL import Image

    view = ClientView(None, "a wall", sides_of(result, result.walls[0]))
    view.resize(900, 500)
    view.show()
    monkeypatch.setattr(client_view, "MAX_SECONDS", 0.5)
    made = view.film(tmp_path / "f.gif")
    settle(application, made.job.isFinished)
    with Image.open(tmp_path / "f.gif") as film:
        lasts = []
        for k in range(film.n_frames):  # frames alike are one that lasts longer
            film.seek(k)
            lasts.append(film.info["duration"])
        assert made.count == 10 and sum(lasts) == 500 and max(film.size) <= 960
    monkeypatch.setattr(client_view, "MAX_SECONDS", 20.0)
    cancelled = view.film(tmp_path / "g.gif")
    settle(application, lambda: cancelled.painted > 3)
    cancelled.dialog.canceled.emit()  # as its button
    settle(application, cancelled.job.isFinished)
    assert not (tmp_path / "g.gif").exists()
    said = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: said.append(kind))
    monkeypatch.setattr(view, "picture", lambda: 1 / 0)
    failed = view.film(tmp_path / "h.gif")
    settle(application, failed.job.isFinished)
    assert said == [ZeroDivisionError] and not (tmp_path / "h.gif").exists()
    view.close()
    view.deleteLater()
