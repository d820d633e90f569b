"""The open benchmark (resources/benchmark): its scenes, its runner, and what the program answers."""

import json
import shlex
import sys

import mpmath as mp
import pytest

from tests.conftest import ROOT
from tests.validation import benchmark_answers

FOLDER = ROOT / "resources" / "benchmark"
RUNNER = benchmark_answers.benchmark("run_benchmark")
PROGRAMS = benchmark_answers.benchmark("programs")
SCENES = json.loads(RUNNER.SCENES.read_text())

DIGITS = {
    "quarter_period_upright": 8,
    "decay": 12,
    "marginal_survives": 3,
    "marginal_overturns": 7,
    "west_above": 10,
    "grazing": 9,
    "spanos_koh_strong": 8,
    "hogan": 11,
    "elastic_impacts": 12,
    "trilinear": 12,
    "trilinear_stiff": 11,
    "small_long_steps": 10,
    "earthquake": 11,
    "set_two_sided": 12,
}
"""Right of a scene that amplifies what doubles leave, one less than in the table of its README; 14 of every other."""

SEEDS = 5
"""Motions of a set in each run; all of them are `long`."""

RECOMPUTED = ("quarter_period", "small_long_steps")


def scene_of(name: str) -> dict:
    return next(scene for scene in SCENES if scene["name"] == name)


def test_that_every_scene_is_whole_and_its_ground_the_same_on_every_machine():
    assert len({scene["name"] for scene in SCENES}) == len(SCENES) == 30
    for scene in SCENES:
        ask, answer = scene["ask"], scene["answer"]
        assert set(answer) == (set(ask) - {"seeds"} | ({"overturned"} if "seeds" in ask else set())), scene["name"]
        listed = benchmark_answers.numbers(answer)
        assert all(isinstance(value, str) for value in listed)
        assert all(len(value.lstrip("-0.").replace(".", "")) >= 39 for value in listed if float(value)), scene["name"]
        assert float(scene["interval"]) <= 1e-39
        assert scene["start"] == [0.0, 0.0] or scene["start"][0] > 0.0
        assert benchmark_answers.digest(RUNNER.samples(scene["ground"])) == scene["sha256"], scene["name"]


@pytest.mark.parametrize("seeds", [1, pytest.param(200, marks=pytest.mark.long)])
def test_that_no_sample_is_so_near_to_a_half_that_a_sine_of_another_machine_rounds_it_elsewhere(seeds):
    for scene in SCENES:
        finer = scene["ground"] | {"formula": f"{2**30} * ({scene['ground']['formula']})"}
        for seed in range(1, min(seeds, scene["ask"].get("seeds", 1)) + 1):
            parts = [round(1e6 * sample) % 2**30 for sample in RUNNER.samples(finer, seed)]
            # another sine moves a sum of 29 of them by no more than 2
            assert min(abs(part - 2**29) for part in parts) > 16, scene["name"]


@pytest.mark.parametrize("name", [scene["name"] for scene in SCENES if "seeds" not in scene["ask"]])
def test_that_ribalta_answers_every_scene(name):
    scene = scene_of(name)
    asked = RUNNER.problem(scene)
    digits, wrong = RUNNER.score(scene, PROGRAMS.answer(asked, PROGRAMS.ribalta(asked)))
    assert not wrong and digits >= DIGITS.get(name, 14)


@pytest.mark.parametrize("seeds", [SEEDS, pytest.param(200, marks=pytest.mark.long)])
@pytest.mark.parametrize("name", [scene["name"] for scene in SCENES if "seeds" in scene["ask"]])
def test_that_ribalta_answers_every_set(name, seeds):
    scene = scene_of(name)
    asked = RUNNER.problem(scene, seeds)
    answer = PROGRAMS.answer(asked, PROGRAMS.ribalta(asked))
    if seeds == 200:
        digits, wrong = RUNNER.score(scene, answer)
        assert not wrong and digits >= DIGITS.get(name, 14)
    else:
        overturned, _ = benchmark_answers.ranked(scene | {"ask": {"peaks": []}}, asked["grounds"])
        assert answer["overturned"] == overturned


@pytest.mark.parametrize(
    "name",
    [pytest.param(scene["name"], marks=[] if scene["name"] in RECOMPUTED else pytest.mark.long) for scene in SCENES],
)
def test_that_an_answer_comes_out_anew_within_its_interval(name):
    """By another precision than those it was printed from."""
    scene = scene_of(name)
    found = benchmark_answers.computed(scene, 52, 32, RUNNER.samples)
    with mp.workdps(60):
        for one, other in zip(
            benchmark_answers.numbers(found), benchmark_answers.numbers(scene["answer"]), strict=True
        ):
            assert abs(one - mp.mpf(other)) <= mp.mpf(scene["interval"])
    counts = {key: value for key, value in found.items() if isinstance(value, int)}
    assert counts.items() <= scene["answer"].items()


@pytest.mark.parametrize(("samples", "impacts"), [(4, 0), (301, 1)])
def test_that_impacts_stop_at_the_last_sample_and_overturns_goes_on(samples, impacts):
    """A leaning wall thrown back over its base: 4 samples end before the impact after which it falls."""
    scene = scene_of("decay")
    scene = scene | {"start": [0.06, -0.4], "ground": scene["ground"] | {"samples": samples}}
    scene |= {"ask": {"impacts": True, "overturns": True}}
    asked = RUNNER.problem(scene)
    with mp.workdps(30):
        assert benchmark_answers.single(scene, asked["ground"], 24) == {"impacts": impacts, "overturns": True}
    for program in (PROGRAMS.ribalta, PROGRAMS.scipy):
        answer = PROGRAMS.answer(asked, program(asked))
        assert (answer["impacts"], answer["overturns"]) == (impacts, True)


@pytest.mark.parametrize("name", ["quarter_period", "quarter_period_upright"])
def test_that_a_quarter_period_is_an_elliptic_integral(name):
    scene = scene_of(name)
    with mp.workdps(60):
        alpha, p2, start = map(mp.mpf, (scene["block"]["slenderness"], scene["block"]["p2"], scene["start"][0]))
        modulus = mp.cos((alpha - start) / 2)
        amplitude = mp.asin(mp.cos(alpha / 2) / modulus)
        quarter = (mp.ellipk(modulus**2) - mp.ellipf(amplitude, modulus**2)) / mp.sqrt(p2)
        assert abs(quarter - mp.mpf(scene["answer"]["impact_times"][0])) <= mp.mpf(scene["interval"])


def run_on(code: str, tmp_path, capsys, monkeypatch, *names: str) -> str:
    """What the runner prints of a program of these lines of Python on some scenes."""
    path = tmp_path / "program.py"
    path.write_text(code)
    command = f"toy={shlex.quote(sys.executable)} {shlex.quote(str(path))}"
    monkeypatch.setattr(sys, "argv", ["run_benchmark.py", command, "--scene", *names])
    RUNNER.main()
    return capsys.readouterr().out


TOY = """import json, sys
asked = json.load(sys.stdin)
assert len(asked["ground"]) == 201 and asked["gravity"] == 9.80665
print("a word before")
print(json.dumps({"impact_times": [TIME], "seconds": 1e-3}))
"""


def test_that_the_runner_scores_any_command(tmp_path, capsys, monkeypatch):
    known = scene_of("quarter_period")["answer"]["impact_times"][0]
    for time, said in ((float(known), "| 1"), (f'"{known}"', "| 40.0 |"), (float(known) * 1.001, "| 3.0 |")):
        printed = run_on(TOY.replace("TIME", str(time)), tmp_path, capsys, monkeypatch, "quarter_period")
        assert f"| quarter_period {said}" in printed
        assert "| a digit or more, of 1 | 1 |" in printed and "| ns a sample, median | 4.98e+03 |" in printed


@pytest.mark.parametrize(
    "code, said",
    [
        ("import sys; sys.exit(3)", "failed: exit 3"),
        ("print('no answer')", "failed: JSONDecodeError"),
        ("""print('{"declined": "no pulse"}')""", "declined: no pulse"),
        ("""print('{"impact_times": []}')""", "0 numbers of impact_times for 1"),
        ("""print('{"impact_times": [NaN]}')""", "0.0"),
    ],
)
def test_that_a_program_that_fails_is_a_failure_and_the_others_go_on(tmp_path, capsys, monkeypatch, code, said):
    printed = run_on(code, tmp_path, capsys, monkeypatch, "quarter_period")
    assert f"| quarter_period | {said} |" in printed
    assert "| a digit or more, of 1 | 0 |" in printed
