#!/usr/bin/env python3
"""Writes every output of every example in every form into a folder, with the instructions of small runs, and prints how many differ
from another folder that it wrote.

    tests/freeze.py target/debug/assur target/before
    ...a change that is to move nothing...
    tests/freeze.py target/debug/assur target/after target/before
"""

import concurrent.futures
import filecmp
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent
FORMS = {
    "check": ["check"],
    "plan": ["check", "--plan"],
    "modes": ["check", "--modes"],
    "table": ["solve", "--accuracy"],
    "json": ["solve", "--format", "json"],
    "jsonl": ["solve", "--format", "jsonl"],
    "csv": ["solve", "--format", "csv"],
    "markdown": ["solve", "--format", "markdown"],
    "latex": ["solve", "--format", "latex"],
    "typst": ["solve", "--format", "typst"],
    "pictures": ["draw", "--all", "--format", "html"],
    "html": ["report", "--format", "html"],
    "text": ["report"],
    "typst": ["report", "--format", "typst"],
    "russian": ["report", "--format", "markdown", "--lang", "ru"],
    "chinese": ["report", "--format", "markdown", "--lang", "zh"],
    "sheet": ["report", "--sheet"],
    "key": ["report", "--key"],
    "fmt": ["fmt", "--check"],
}
# in files that are wrong: what is said, for people and for programs
WRONG = {"table": ["solve"], "json": ["solve", "--format", "json"], "fix": ["check"]}
# counts and figures of this run alone
PASSING = re.compile(" +[0-9.]+ +[0-9]+ %|[0-9]+ % of|[0-9.,]+ (?:s|ms|µs|ns)\\b".encode())


def write(program: pathlib.Path, folder: pathlib.Path, file: str, form: str, words: list[str]) -> None:
    environment = {**os.environ, "NO_COLOR": "1", "COLUMNS": "100"}
    run = subprocess.run([program, *words, file], cwd=ROOT, env=environment, capture_output=True, timeout=600, check=False)
    said = PASSING.sub(b"*", run.stderr) if form == "table" else run.stderr
    out = PASSING.sub(b"*", run.stdout) if form in ("table", "plan") else run.stdout
    place = folder / file
    place.mkdir(parents=True, exist_ok=True)
    (place / form).write_bytes(out + b"\n--- %d ---\n" % run.returncode + said)


def instructions(program: pathlib.Path, folder: pathlib.Path) -> None:
    """Start and one small file, in instructions: a figure that a change may move, beside the outputs that it may not."""
    for file in ["examples/first.mech", "examples/crank-slider.mech", "examples/simulation/pendulum.mech"]:
        counter = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "solve", file]
        run = subprocess.run(counter, cwd=ROOT, capture_output=True, text=True, check=False)
        count = re.search(r"Collected : (\d+)", run.stderr)
        if count:
            print(f"{file}: {int(count[1]) / 1e6:.2f} million instructions")


def main() -> int:
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    examples = [str(path.relative_to(ROOT)) for path in sorted(ROOT.glob("examples/**/*.mech"))]
    wrong = [str(path.relative_to(ROOT)) for path in sorted(ROOT.glob("tests/errors/**/*.mech"))]
    outputs = [(file, form, words) for file in examples for form, words in FORMS.items()]
    outputs += [(file, form, words) for file in wrong for form, words in WRONG.items()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done in [pool.submit(write, program, folder, *output) for output in outputs]:
            done.result()
    print(f"{len(outputs)} outputs in {folder}")
    if "--count" in sys.argv:
        instructions(program, folder)
    before = [pathlib.Path(path) for path in sys.argv[3:] if not path.startswith("--")]
    if not before:
        return 0
    other = [f"{file}/{form}" for file, form, _ in outputs if not same(folder / file / form, before[0] / file / form)]
    print("\n".join(other), f"{len(other)} differ from {before[0]}", sep="\n" if other else "")
    return 1 if other else 0


def same(one: pathlib.Path, other: pathlib.Path) -> bool:
    return other.exists() and filecmp.cmp(one, other, shallow=False)


if __name__ == "__main__":
    sys.exit(main())
