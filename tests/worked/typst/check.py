#!/usr/bin/env python3
"""Compiles worked solutions in Typst.

    tests/worked/typst/check.py [--all]

writes the solutions of every ninth example (of all examples with --all) in three languages with the program that ASSUR names
(target/release/assur), and its answers as tables, and compiles each with the package typst of PyPI. Exits with 1 where one does not compile.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import typst

ROOT = pathlib.Path(__file__).resolve().parents[3]
ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))


def main():
    step = 1 if "--all" in sys.argv[1:] else 9
    faults, count = [], 0
    for example in sorted((ROOT / "examples").rglob("*.mech"))[::step]:
        for language in ["en", "zh", "ru", "tables"]:
            with tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path(folder) / "page.typ"
                if language == "tables":
                    made = subprocess.run([ASSUR, "solve", example, "--format", "typst"], capture_output=True, cwd=ROOT)
                    path.write_bytes(made.stdout)
                else:
                    subprocess.run([ASSUR, "report", example, "--lang", language, "-o", path], capture_output=True, cwd=ROOT)
                # an example that has no solution is written for its diagnostics
                if not path.exists():
                    continue
                count += 1
                try:
                    typst.compile(str(path), output=str(path.with_suffix(".pdf")))
                except typst.TypstError as error:
                    faults.append(f"{example.relative_to(ROOT)}, {language}: {error}")
    print(f"{count} documents, {len(faults)} faults")
    print("\n".join(faults))
    sys.exit(1 if faults or not count else 0)


main()
