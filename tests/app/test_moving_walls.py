"""The walls that rock beside the charts of a history."""

import numpy as np


def test_that_a_film_is_played_to_its_end_from_its_beginning_and_holds_its_last_sample(opened, application):
    from app.views.moving_walls import Film, MovingWalls

    walls = MovingWalls()
    walls.setParent(opened)
    first, second = Film(np.array([0.0, 0.01, 0.02, 0.03]), 0.01), Film(np.array([0.0, -2.0]), 0.01)
    walls.play.setChecked(True)
    assert not walls.timer.isActive()  # there is nothing to play
    walls.play.setChecked(False)
    walls.take([first, second], [])
    times = []
    walls.asked.connect(times.append)
    walls.asked.connect(walls.show_time)
    walls.play.setChecked(True)
    walls.started = 0.025  # as after a rest of the hand
    walls._next()
    assert walls.play.isChecked() and times[-1] >= 0.025
    walls.started = 0.04
    walls._next()
    assert not walls.play.isChecked() and not walls.timer.isActive()
    assert [drawing.rotation for drawing in walls.drawings] == [0.03, -1.5]  # a wall that fell stays in sight
    walls.play.setChecked(True)
    assert walls.started < 0.02  # again from where it begins to move
    walls.play.setChecked(False)
    walls.setParent(None)  # the window is lent to the next test
