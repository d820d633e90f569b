"""The key plan and the floors of a building in the window."""

from dataclasses import replace

from app.input.wall_text import add_building_loads
from app.views.plan_chart import PlanChart, _along
from app.work.draft import TO_BE_GIVEN
from core.case.site import Building, FloorLoad
from core.report.key_plan import Placed
from tests.core.report.test_key_plan import study, walls


def test_that_a_click_on_a_wall_of_the_plan_opens_it(opened, application):
    chart, picked = PlanChart(), []
    chart.setParent(opened)
    chart.picked.connect(picked.append)
    result = study(*walls())
    assert chart.show_result(result)
    for x, y, name in ((4.0, 0.2, "south"), (7.9, 5.0, "east"), (2.0, 9.1, "north")):
        chart.clicked.emit(x, y)
        assert result.walls[picked[-1]].part.asked.name == name
    chart.clicked.emit(4.0, 4.5)
    assert len(picked) == 3
    assert {name for name, *_ in chart.data} == {f"{one.name} ζ {one.zeta:.2f}" for one in chart.placed}
    assert not chart.show_result(study(next(walls()))) and not chart.placed[1:]
    chart.setParent(None)


def test_that_names_are_read_from_below_or_from_the_right():
    ends = {(1.0, 0.0): 0.0, (-1.0, 0.0): 0.0, (0.0, 1.0): 90.0, (0.0, -1.0): 90.0, (1.0, 1.0): 45.0}
    for end, angle in ends.items():
        assert _along(Placed("A", 0, None, ((0.0, 0.0), end), "", None)) == angle


def test_that_a_floor_is_typed_beside_the_building_and_drawn_on_its_wall(opened, application):
    session = opened.session
    session.edit_wall(0, name="street", height_m=6.0, thickness_m=0.5, unit_weight_kn_m3=18.0, base_z_m=0.0)
    session.edit(replace(session.case, building=Building(6.0, 2)))
    form = _floors(opened)
    bare = add_building_loads(session.case, session.case.wall[0])
    form.buttons.itemAt(1).widget().click()
    (floor,) = session.case.building.floors
    assert floor.level_m == TO_BE_GIVEN and floor.mass == "none"
    assert add_building_loads(session.case, session.case.wall[0]) == bare  # nothing is drawn of what is not given yet
    whole = FloorLoad("first", 3.0, "street", 0.3, 5.0, 4.0, "none")
    session.edit(replace(session.case, building=replace(session.case.building, floors=(whole,))))
    form.show_case()
    assert form.list.item(0).text() == "first: 3 m, street"
    (load,) = add_building_loads(session.case, session.case.wall[0]).load
    assert (load.h_m, load.d_m, load.kn_m) == (3.0, 0.3, 10.0)
    form.list.setCurrentRow(0)
    form.delete()
    assert session.case.building.floors == ()


def _floors(opened):
    from app.input.building_form import FloorsForm

    (form,) = opened.findChildren(FloorsForm)
    return form
