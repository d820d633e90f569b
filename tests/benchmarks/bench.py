"""What the program costs and how exact it is, measured on this machine.

    python3 run.py bench                                    # speed of methods, search and batch, see speed.py
    python3 run.py bench --work-precision [--output DIR]    # error against time, see work_precision.py
    python3 run.py bench --q-error [--output DIR]           # error of q against time, see q_error.py
    python3 run.py bench --loads [--pairs N]                # what loads cost, see loads.py
    python3 run.py bench --paired OTHER_TREE [--pairs N]    # this tree against another, see paired.py
    python3 run.py bench --processes [--pairs N]            # the same figures in fresh processes, see processes.py
    python3 run.py bench --steps [--output DIR]             # q against the step, see step_study.py
    python3 run.py bench --zeta                             # zeta of the dynamic check against its grid
    python3 run.py bench --memory                           # peak memory and time of large work
    python3 run.py bench --memory --walls N                 # the same of so many walls, as a Parquet file
    python3 run.py bench --scale [--walls N] [--output DIR] # cost of a wall up to so many, see cost_per_wall.py
    python3 run.py bench --window                           # start of the window, redraws, event loop, keys
    python3 run.py bench --window --against OTHER_TREE [--pairs N] # the starts of two trees in turn
    python3 run.py bench --screenshots [--output DIR]       # every tab, both themes and languages
    python3 run.py bench --pictures [--output DIR]          # the pictures of README and guides, see pictures.py
    python3 run.py bench --records                          # a million samples read, 200 files previewed
    python3 run.py bench --noise [--cases N]                # errors of histories beside the effect of noise
    python3 run.py bench --noise --explain [--cases N]      # what each error is that eight draws do not explain
    python3 run.py bench --tolerances [--cases N] [--pairs N] # the same for other tolerances of a step, and their speed
    python3 run.py bench --compile                          # what a cold start compiles, kernel by kernel
    python3 run.py bench --note                             # seconds of the calculation note after a run
    python3 run.py bench --branch                           # a history with the elastic branch, both ways
    python3 run.py bench --selection                        # seven records of a thousand, and of few
    python3 run.py bench --sure                             # moves of the inputs, sliders of What if
    python3 run.py bench --outcomes                         # analyses, time and outcomes of the shipped cases
    python3 run.py bench --outcomes --against OTHER_TREE [--cases N] [--walls N] # two trees, random walls
    python3 run.py bench --ties [LIST.toml]                 # what q = 2 is worth for a tie, see tie_study.py

With --small it takes fewer of the same inputs, as in the tests (inputs.py): what it prints then says nothing. Every
benchmark asserts that what it measures happened.
"""

import argparse
import importlib
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from core.jit import cache  # noqa: E402
from tests.benchmarks.inputs import Command  # noqa: E402  (of this tree, which the line above puts on the path)

BENCHMARKS = {
    "work_precision": "work_precision",
    "q_error": "q_error",
    "loads": "loads",
    "paired": "paired",
    "processes": "processes",
    "steps": "step_study",
    "zeta": "zeta_spread",
    "memory": "memory",
    "scale": "cost_per_wall",
    "window": "window_speed",
    "screenshots": "screenshots",
    "pictures": "pictures",
    "records": "record_speed",
    "ties": "tie_study",
    "noise": "noise_promise",
    "tolerances": "tolerance_sweep",
    "compile": "compile_times",
    "note": "note_speed",
    "branch": "branch_speed",
    "selection": "selection_speed",
    "sure": "sure_speed",
    "outcomes": "outcomes",
}
"""Word of the command -> module of this folder, whose `main(options)` measures and prints."""


def options_of(words: list[str]) -> Command:
    """The words of the command: pairs, cases, walls, output, ..., and those of BENCHMARKS, one or none of them."""
    parser = argparse.ArgumentParser(prog="run.py bench")
    asked = parser.add_mutually_exclusive_group()
    for word in BENCHMARKS:
        if word == "paired":
            asked.add_argument("--paired", type=Path, metavar="OTHER_TREE")
        elif word == "ties":
            asked.add_argument("--ties", type=Path, metavar="LIST.toml", nargs="?", const=True)
        else:
            asked.add_argument(f"--{word.replace('_', '-')}", action="store_true")
    parser.add_argument("--small", action="store_true", dest="_small")
    parser.add_argument("--pairs", type=int, help="25 of --paired, else 7")
    parser.add_argument("--cases", type=int, default=1000)
    parser.add_argument("--walls", type=int)
    parser.add_argument("--against", type=Path, metavar="OTHER_TREE")
    parser.add_argument("--explain", action="store_true")
    parser.add_argument("--tangent", action="store_true")
    parser.add_argument("--output", type=Path)
    return parser.parse_args(words, namespace=Command())


def main(words: list[str]) -> None:
    """Measure what the words ask for."""
    cache.own_process()
    options = options_of(words)
    chosen = next((BENCHMARKS[word] for word in BENCHMARKS if getattr(options, word)), "speed")
    importlib.import_module(f"tests.benchmarks.{chosen}").main(options)


if __name__ == "__main__":
    main(sys.argv[1:])
