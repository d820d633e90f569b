"""Asks programs the scenes of scenes.json and scores their answers: digits right, failures, ns a sample.

    python3 run_benchmark.py NAME=COMMAND [NAME=COMMAND ...] [--scene NAME ...] [--timeout SECONDS]

Each scene goes to each program in turn, a process of its own, as JSON on its standard input; its last line of standard
output is the answer. README.md beside this file describes both. Nothing but the standard library is needed.
"""

import argparse
import json
import math
import shlex
import statistics
import subprocess
from decimal import Decimal
from pathlib import Path

SCENES = Path(__file__).with_name("scenes.json")
FUNCTIONS = {name: getattr(math, name) for name in ("sin", "cos", "exp", "sqrt", "pi")}
MODULUS = 2**31 - 1
CAP = 40
"""Digits to which the answers are known."""


def samples(ground: dict, seed: int = 1) -> list[float]:
    """The samples [m/s2] of a ground: its formula at t = k dt, rounded to whole micrometres per second squared."""
    phases = [2 * math.pi * (seed * pow(48271, j, MODULUS) % MODULUS) / MODULUS for j in range(100)]
    known = {**FUNCTIONS, "phase": phases.__getitem__, "__builtins__": {"max": max, "sum": sum, "range": range}}
    code = compile(ground["formula"], ground["formula"], "eval")
    times = (k * ground["dt"] for k in range(ground["samples"]))
    return [round(1e6 * eval(code, {**known, "t": t})) / 1e6 for t in times]


def problem(scene: dict, seeds: int = 0) -> dict:
    """What a program reads: the scene without its answer, the formula of its ground replaced by its samples."""
    ask, ground = scene["ask"], scene["ground"]
    asked = {key: scene[key] for key in ("name", "block", "start", "ask")} | {"gravity": 9.80665, "dt": ground["dt"]}
    if "seeds" in ask:
        return asked | {"grounds": [samples(ground, seed) for seed in range(1, (seeds or ask["seeds"]) + 1)]}
    return asked | {"ground": samples(ground)}


def score(scene: dict, answer: dict) -> tuple[float, str]:
    """Digits right of the worst of all numbers, and what else is wrong. Errors of rotations are relative to the largest
    rotation of the answer, of all other numbers to the number itself."""
    known, digits, wrong = scene["answer"], float(CAP), ""
    turns = [abs(Decimal(value)) for key in ("rotation", "peak") for value in listed(known.get(key, []))]
    largest = max(turns, default=Decimal(0)) or Decimal(scene["block"]["slenderness"])
    for key, right in known.items():
        if key not in answer:
            return 0.0, f"no {key}"
        found = answer[key]
        if isinstance(right, int):  # a count, or yes and no
            wrong = wrong or ("" if found == right else f"{key} {json.dumps(found)} for {json.dumps(right)}")
            continue
        if len(listed(found)) != len(listed(right)):
            return 0.0, f"{len(listed(found))} numbers of {key} for {len(listed(right))}"
        for one, other in zip(listed(found), listed(right), strict=True):
            unit = largest if key in ("rotation", "peak") else abs(Decimal(other))
            error = abs(Decimal(str(one)) - Decimal(other)) / unit if one is not None else Decimal(1)
            digits = min(digits, float(-error.log10()) if error else CAP) if error.is_finite() else 0.0
    return (0.0 if wrong else max(digits, 0.0)), wrong


def listed(value) -> list:
    return value if isinstance(value, list) else [value]


def run(command: str, scene: dict, text: str, timeout: float) -> tuple[float | None, str, float | None]:
    """(digits right or None, what is wrong, ns a sample or None) of a program on a scene."""
    try:
        done = subprocess.run(shlex.split(command), input=text, capture_output=True, text=True, timeout=timeout)
        answer = json.loads(done.stdout.strip().rpartition("\n")[2]) if done.returncode == 0 else None
        if not isinstance(answer, dict):
            return None, f"failed: exit {done.returncode}", None
    except (subprocess.TimeoutExpired, OSError, ValueError) as error:
        return None, f"failed: {type(error).__name__}", None
    if "declined" in answer:
        return None, f"declined: {answer['declined']}", None
    count = scene["ground"]["samples"] * scene["ask"].get("seeds", 1)
    return *score(scene, answer), 1e9 * answer["seconds"] / count if "seconds" in answer else None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="NAME=COMMAND")
    parser.add_argument("--scene", nargs="*", default=[], help="these alone")
    parser.add_argument("--timeout", type=float, default=600.0, help="seconds a scene")
    options = parser.parse_args()
    if wrong := [word for word in options.programs if "=" not in word]:
        parser.error(f"{wrong[0]}: a program is NAME=COMMAND")
    programs = dict(program.split("=", 1) for program in options.programs)
    scenes = [one for one in json.loads(SCENES.read_text()) if not options.scene or one["name"] in options.scene]
    times = {name: [] for name in programs}
    right = dict.fromkeys(programs, 0)
    print(f"| scene | {' | '.join(programs)} |\n|---|{'---|' * len(programs)}")
    for scene in scenes:
        text, row, ns = json.dumps(problem(scene)), [], {}
        for name, command in programs.items():
            digits, wrong, ns[name] = run(command, scene, text, options.timeout)
            right[name] += digits is not None and digits >= 1
            row.append(wrong or f"{digits:.1f}")
        first = ns[next(iter(programs))]
        for name, value in ns.items():
            times[name] += [(value, value / first)] if value and first else []
        print(f"| {scene['name']} | {' | '.join(row)} |", flush=True)
    print(f"| a digit or more, of {len(scenes)} | {' | '.join(str(count) for count in right.values())} |")
    for k, title in ((0, "ns a sample, median"), (1, "over the first program, median")):
        row = [f"{statistics.median(pair[k] for pair in pairs):.3g}" if pairs else "-" for pairs in times.values()]
        print(f"| {title} | {' | '.join(row)} |")


if __name__ == "__main__":
    main()
