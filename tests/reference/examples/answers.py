"""Compare every pose that `assur solve --format json` prints with the independent solution, number by number.

    python3 answers.py ../../../target/release/assur ../../../examples

For each file that reader.py understands: angles and rates of the links, positions and rates of the points, forces and
moments in the pairs, balances. What no `expect` holds is held here. Files with friction, trains or cams have scripts of
their own and are passed over by name. The worst difference of a file is relative to the greatest number of its kind.
"""
import json
import subprocess
import sys
from pathlib import Path

from mechfile import *
from planar import *
from reader import Case
import printing

ALLOWED = mpf("1e-9")


def solved(program, path):
    text = subprocess.run([program, "solve", str(path), "--format", "json"], capture_output=True, text=True).stdout
    return [json.loads(line) for line in text.splitlines() if line.strip()] if text.count('"schema"') > 1 else [json.loads(text)]


def turned(a, b):
    return a - b - 2 * pi * mp.nint((a - b) / (2 * pi))


def asked(case, pose, s):
    """(kind, printed, independent) for the answers by name or text that the reader can work out."""
    for text, got in pose.get("quantities", {}).items():
        got = got["value"] if isinstance(got, dict) else got
        try:
            want = case.value(Parser(tokens(text)).expr(), s)
        except (Skip, Wrong):
            continue
        if got is None or isinstance(want, dict) or isinstance(want, bool) or isinstance(want, tuple) != isinstance(got, list):
            continue
        kind = "angles" if text.startswith("angle(") else text
        for a, b in zip(got, want) if isinstance(want, tuple) else [(got, want)]:
            yield kind, turned(mpf(a), b) if kind == "angles" else mpf(a), mpf(0) if kind == "angles" else b


def pairs_of_numbers(pose, s):
    """(kind, printed, independent) for all that the pose holds."""
    for name, link in pose.get("links", {}).items():
        if name in s.f and name != "ground":
            yield "angle", turned(mpf(link["angle"]), s.angle(name)), mpf(0)
            if s.moves and "omega" in link:
                yield "omega", mpf(link["omega"]), s.omega(name)
            if s.moves and "alpha" in link:
                yield "alpha", mpf(link["alpha"]), s.alpha(name)
    for name, point in pose.get("points", {}).items():
        if name.startswith("ground."):
            continue
        for what in ("position", "velocity", "acceleration"):
            if what in point and (what == "position" or s.moves):
                for a, b in zip(point[what], getattr(s, what)(name)):
                    yield what, mpf(a), b
    if s.balance is None:
        return
    for name, parts in pose.get("reactions", {}).items():
        for part in parts:
            found = s.r.get((name, part["on"], part["from"]))
            if found is None:          # a cylinder's inner joints have no number in the independent solution
                continue
            for a, b in zip(part["force"], found[0]):
                yield "force", mpf(a), b
    for name, value in pose.get("balances", {}).items():
        if name in s.balance:
            yield "balance", mpf(value["value"] if isinstance(value, dict) else value), s.balance[name]


def check(program, path):
    if "friction" in path.read_text(encoding="utf-8").replace("friction angle", ""):
        return True
    f = File(path)
    good = True
    for row, printed in zip(f.variants or [{}], solved(program, path)):
        case = Case(f, row)
        numbers = {}
        for pose in printed["poses"]:
            s = case.named.get(pose["name"])
            if s is None or "error" in pose:
                continue
            for kind, a, b in [*asked(case, pose, s), *pairs_of_numbers(pose, s)]:
                numbers.setdefault(kind, []).append((a, b, pose["name"]))
        total, worst = 0, (mpf(0), "", "")
        # what is nothing in the independent solution may be rounding here
        floor = mpf("1e-5") * max([abs(b) for all_of in numbers.values() for _, b, _ in all_of] + [mpf("1e-12")])
        for kind, all_of in numbers.items():
            size = max([abs(b) for _, b, _ in all_of] + [floor]) if not kind.startswith("angle") else mpf(1)
            for a, b, name in all_of:
                total += 1
                worst = max(worst, (abs(a - b) / size, kind, name))
        fine = worst[0] <= ALLOWED
        good &= fine
        print(f"{'' if fine else 'WRONG '}{path}: {total} numbers, worst {mp.nstr(worst[0], 2)} {worst[1]} at {worst[2]}", flush=True)
    return good


if __name__ == "__main__":
    program, *places = sys.argv[1:]
    files = [p for a in places for p in ([Path(a)] if a.endswith(".mech") else sorted(Path(a).rglob("*.mech")))]
    fine = True
    for p in files:
        try:
            fine &= check(program, p)
        except Wrong as e:
            print(f"not read: {p}: {e}", flush=True)
        except Exception as e:
            fine = False
            print(f"{p}: {type(e).__name__} {e}", flush=True)
    sys.exit(0 if fine else 1)
