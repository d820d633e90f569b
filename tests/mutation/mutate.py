"""Are the tests awake? Small faults put into the modules that decide, one at a time; each must fail a test.

    python3 run.py mutate [--each N] [MODULE ...]

A tool of our own, since mutmut and cosmic-ray run the whole suite for each fault: here a module knows its tests,
and compiled kernels, which are in none of these modules, are kept for all runs. The faults are drawn by chance
with a fixed seed: comparisons at their limit, signs, factors, limits moved by a tenth, conditions turned. Faults
that change nothing are named in `survivors.txt`, each with its reason.
"""

import argparse
import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
HAND = "tests/validation/test_circolare_by_hand.py"
DISPLACEMENT = "tests/validation/test_displacement_demand.py"
READERS = ["tests/core/ground/test_records.py", "tests/core/ground/test_record_refusals.py"]
OWN = (
    "core/wall/block.py",
    "core/wall/loads.py",
    "core/wall/moment_rotation.py",
    "core/wall/restitution.py",
    "core/wall/rocking_model.py",
    "core/wall/wall_loads.py",
    "core/codes/capacity_curve.py",
    "core/codes/demand.py",
    "core/codes/eq9.py",
    "core/codes/floor_spectrum.py",
    "core/codes/kinematic_chain.py",
    "core/codes/multiplier_search.py",
    "core/codes/record_compatibility.py",
    "core/codes/record_sample.py",
    "core/codes/risk.py",
    "core/codes/target_spectrum.py",
    "core/ground/selection.py",
    "core/variation/sensitivity.py",
    "core/variation/turned_round.py",
)
"""Modules whose own tests, in the file of their name, hold their facts."""

TESTS = {
    **{module: [f"tests/{Path(module).with_name('test_' + Path(module).name)}"] for module in OWN},
    "core/codes/kinematic.py": [HAND, DISPLACEMENT, "tests/core/codes/test_kinematic.py"],
    "core/codes/dynamic_check.py": [
        HAND,
        "tests/core/codes/test_dynamic_check.py",
        "tests/core/codes/test_verdict.py",
        "tests/core/study/test_run.py",
    ],
    "core/capacity/ida.py": ["tests/core/capacity/test_ida.py"],
    "core/capacity/bisection.py": ["tests/core/capacity/test_ida.py"],
    "core/codes/verdict.py": ["tests/core/codes/test_verdict.py", HAND],
    "core/codes/limits.py": [
        "tests/core/codes/test_limits.py",
        "tests/core/case/test_rules.py",
        "tests/core/case/test_schema.py",
        HAND,
    ],
    "core/codes/collapse_rate.py": [
        "tests/core/codes/test_collapse_rate.py",
        "tests/core/report/test_certainty.py::test_that_what_the_hazard_does_not_hold_is_said_from_a_twentieth_on",
    ],
    "core/study/how_sure.py": [
        "tests/core/study/test_how_sure.py",
        "tests/core/variation/test_sensitivity.py::test_that_what_turns_a_satisfied_verdict_is_said_and_the_verdict_stays",
    ],
    "core/variation/whole_wall.py": [
        "tests/core/variation/test_whole_wall.py",
        "tests/core/variation/test_sensitivity.py",
        "tests/core/variation/test_turned_round.py",
    ],
    "core/variation/swings.py": ["tests/core/variation/test_sensitivity.py", "tests/core/report/test_certainty.py"],
    "core/ground/records/grammar.py": READERS,
    "core/ground/records/plain.py": READERS,
    "core/ground/records/cut.py": READERS,
    "core/case/wall_table.py": ["tests/core/case/test_wall_table.py"],
    "core/ooxml/package.py": ["tests/core/ooxml/test_package.py"],
    "core/ooxml/sheet.py": ["tests/core/ooxml/test_sheet.py"],
}
COMPARED = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
}
REPLACED = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.And: ast.Or,
    ast.Or: ast.And,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}
SECONDS = 240
FIXED_STAMP = ('return build().get("kernels") or', 'return "mutants" or')
"""Replaced in core/jit/cache.py: the kernels are of no module that changes, and compiled once for all."""


def faults(tree: ast.Module) -> list[tuple[Any, str]]:
    """(node, attribute) of every place a fault can be put."""
    passed_over = {
        id(part)
        for node in ast.walk(tree)
        for name in ("annotation", "returns")
        if getattr(node, name, None)
        for part in ast.walk(getattr(node, name))
    }
    # nothing assigns to a frozen class: whether it is one no test can see
    passed_over |= {
        id(part)
        for node in ast.walk(tree)
        for decorator in getattr(node, "decorator_list", [])
        for part in ast.walk(decorator)
    }
    found: list[tuple[Any, str]] = []
    for node in ast.walk(tree):
        if id(node) in passed_over:
            continue
        if isinstance(node, ast.Compare) and type(node.ops[0]) in COMPARED:
            found.append((node, "ops"))
        elif isinstance(node, (ast.BinOp, ast.BoolOp)) and type(node.op) in REPLACED:
            texts = isinstance(node, ast.BinOp) and any(
                isinstance(side, (ast.JoinedStr, ast.List)) or isinstance(getattr(side, "value", 0), str)
                for side in (node.left, node.right)
            )
            if not texts:
                found.append((node, "op"))
        elif isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Not):
            found.append((node, "operand"))
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float, bool):
            found.append((node, "value"))
    return found


def put(node: Any, attribute: str) -> None:
    """Put the fault."""
    if attribute == "ops":
        node.ops[0] = COMPARED[type(node.ops[0])]()
    elif attribute == "op":
        node.op = REPLACED[type(node.op)]()
    elif attribute == "operand":
        node.op = ast.UAdd()
        node.operand = ast.Call(ast.Name("bool", ast.Load()), [node.operand], [])
    elif isinstance(node.value, bool):
        node.value = not node.value
    else:
        node.value = node.value + 1 if isinstance(node.value, int) else node.value * 1.1 or 0.1


def tested(tree: Path, tests: list[str], environment: dict) -> bool:
    """Whether the tests of a module pass in this tree."""
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *tests]
    try:
        found = subprocess.run(command, cwd=tree, env=environment, capture_output=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return False
    return found.returncode == 0


def main() -> int:
    words = argparse.ArgumentParser()
    words.add_argument("modules", nargs="*", default=list(TESTS))
    words.add_argument("--each", type=int, default=12, help="faults in each module; 0: all")
    options = words.parse_args()
    known = (Path(__file__).parent / "survivors.txt").read_text(encoding="utf-8").splitlines()
    killed = survived = excused = 0
    with tempfile.TemporaryDirectory() as name:
        tree = Path(name) / "tree"
        shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns(".git", ".venv*", "dist", "build"))
        cache = tree / "core" / "jit" / "cache.py"
        cache.write_text(cache.read_text().replace(*FIXED_STAMP))
        environment = dict(
            os.environ,
            PYTHONPATH=str(tree),
            RIBALTA_CACHE=str(Path(name) / "cache"),
            RIBALTA_RECORDS=os.environ.get("RIBALTA_RECORDS", str(ROOT.parent / "shared" / "records")),
        )
        for module in options.modules:
            source = (ROOT / module).read_text(encoding="utf-8")
            if not tested(tree, TESTS[module], environment):
                print(f"{module}: its tests fail without a fault")
                return 1
            places = range(len(faults(ast.parse(source))))
            chosen = random.Random(module).sample(places, min(options.each or len(places), len(places)))
            for place in sorted(chosen):
                changed = ast.parse(source)
                node, attribute = faults(changed)[place]
                line = source.splitlines()[node.lineno - 1].strip()
                before = ast.unparse(node)
                put(node, attribute)
                (tree / module).write_text(ast.unparse(ast.fix_missing_locations(changed)))
                if not tested(tree, TESTS[module], environment):
                    killed += 1
                elif (words := f"{module}: {before} -> {ast.unparse(node)} in {line}") in known:
                    excused += 1
                else:
                    survived += 1
                    print(words, flush=True)
            (tree / module).write_text(source)
    total = killed + survived
    print(f"{killed} of {total} faults found ({killed / max(total, 1):.0%}); {excused} change nothing, as stated")
    return 0 if killed >= 0.9 * total else 1


if __name__ == "__main__":
    sys.exit(main())
