"""A wall between its transverse walls in the window: its drawing, its place in the tree, the page Histories."""

from pathlib import Path

from tests.core.case.test_spanning import BUILDING, DEMAND, TIE, WALL
from tests.holds import between

SPANS = {"hold": between(5.0, **TIE)}


def result_of():
    from core.case.rules import parse_case
    from core.study.run import run

    table = {"wall": [{**WALL, **SPANS}], "demand": DEMAND, "building": BUILDING}
    return run(parse_case({**table, "generate": {"count": 1}, "analysis": {"q_step": 0.05}}), base_dir=Path())


def test_that_its_histories_are_said_to_be_none_and_nothing_of_the_wall_before_stays(opened, application):
    from app.shell.tree import hinge_text
    from app.views.histories_tab import HistoriesTab

    result = result_of()
    turns, spans = result.walls
    tab = HistoriesTab()
    tab.setParent(opened)
    tab.show_wall(result, turns)
    assert tab.energy.data and "C " in tab.words.text()
    tab.show_wall(result, spans)
    assert not tab.energy.data and not tab.rotation.data and tab.words.text() == "No histories are made of this wall."
    assert hinge_text(spans) == "L 5 m, horizontal bending" and hinge_text(turns).startswith("+0 m")
    tab.show_wall(result, turns)
    assert tab.energy.data
    tab.setParent(None)  # the window is lent to the next test


def test_that_the_drawing_has_a_plan_where_the_case_says_how_far_the_walls_stand_apart(opened, application):
    from app.look.plan_drawing import plan_of
    from core.case.rules import parse_case

    wall, bare = (parse_case({"wall": [table]}).wall[0] for table in ({**WALL, **SPANS}, WALL))
    assert plan_of(wall).strip.height == 5.0 and plan_of(bare) is None
    opened.walls.drawing.show_wall(wall)
    with_plan = opened.walls.drawing.grab().toImage()
    opened.walls.drawing.show_wall(bare)
    assert with_plan != opened.walls.drawing.grab().toImage()


def test_that_holds_are_added_changed_and_shown_by_a_document(opened, application):
    form, session = opened.walls.holds, opened.session
    session.edit_wall(0, mechanism="one_sided", hold=())
    opened.walls.show_case()
    form.add("floor")
    (hold,) = session.case.wall[0].hold
    assert (hold.kind, hold.h_m) == ("floor", session.case.wall[0].height_m)
    shown = {field.key for field in form.fields if not field.isHidden()}
    assert shown == {"kind", "name", "h_m", "out_kn_m"}
    fields = {field.key: field for field in form.fields}
    fields["kind"].edited.emit("cross_walls")
    (hold,) = session.case.wall[0].hold
    assert (hold.kind, hold.h_m, hold.only_there) == ("cross_walls", None, True)
    form.shown_by.setChecked(True)
    form.shown_by.fields[0].edited.emit("survey")
    assert session.case.wall[0].hold[0].evidence.kind == "survey"
    form.delete()
    assert session.case.wall[0].hold == ()


def test_that_the_answer_leads_to_the_hold_that_nothing_shows(opened, application):
    from tests.holds import behind

    opened.session.edit_wall(0, mechanism="one_sided", hold=())
    opened.navigator.ask("holds")
    assert opened.walls.sections["holds"].isVisibleTo(opened.walls)
    table = parse_holds([*behind("drawing"), *behind("")])
    opened.session.edit_wall(0, hold=table)
    opened.navigator.ask("holds")
    assert opened.walls.holds.list.currentRow() == 1


def parse_holds(tables):
    from core.case.rules import parse_case

    return parse_case({"wall": [{**WALL, "hold": tables}]}).wall[0].hold


def test_that_the_drawing_shows_the_leaf_and_its_connectors(opened, application):
    from app.look.drawing import leaf_lines
    from core.case.rules import parse_case
    from tests.core.case.test_detached import LEAF, WALL

    wall = parse_case({"wall": [{**WALL, "leaf": LEAF}]}).wall[0]
    face, *rows = leaf_lines(wall)
    assert [z for _, z in face] == [0.0, 6.0] and face[0][0] == 0.5 * 0.6 - 0.22
    assert [row[0][1] for row in rows] == [1.5, 3.0, 4.5]
    opened.walls.drawing.show_wall(wall)
    with_leaf = opened.walls.drawing.grab().toImage()
    opened.walls.drawing.show_wall(parse_case({"wall": [WALL]}).wall[0])
    assert with_leaf != opened.walls.drawing.grab().toImage()
