#!/usr/bin/env python3
"""Compares pictures in pixels with the browser.

    tests/pictures/browser/pixels.py

draws pictures of every kind as PNG and as SVG with the program that ASSUR names, a build with the feature png, and counts the
pixels in which the first differ from what the browser shows of the second. Exits with 1 where more than 2 % do.
"""

import base64
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from devtools import Browser

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))
PICTURES = [("kinetostatics/six-bar", "scheme"), ("kinetostatics/six-bar", "lever"), ("shaper/shaper-a", "velocities --pose 3"),
            ("shaper/shaper-a", "accelerations --pose 3"), ("friction/four-bar", "friction"), ("flywheel/engine", "plot"),
            ("shaper/shaper-a", "work"), ("flywheel/engine", "hodograph rod.S"), ("trains/planetary-gearbox", "train"),
            ("contacts/geneva-turns", "scheme --pose 1"), ("drives/cylinder-lift", "scheme")]
MOST = 0.02


def draw(example, kind, path):
    words = [ASSUR, "draw", f"examples/{example}.mech", *kind.split(), "-o", "-", "--format", path.suffix[1:]]
    done = subprocess.run(words, capture_output=True, cwd=ROOT)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}: {done.stderr.decode()}")
    path.write_bytes(done.stdout)


def main():
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
    if not program:
        sys.exit("there is no browser: install chromium, or name one in CHROMIUM")
    begin, faults = time.monotonic(), 0
    with tempfile.TemporaryDirectory() as folder:
        browser = Browser(program)
        try:
            browser.open(HERE / "empty.html")
            browser.run((HERE / "page.js").read_text())
            for example, kind in PICTURES:
                svg, png = (pathlib.Path(folder) / f"picture.{ending}" for ending in ["svg", "png"])
                draw(example, kind, svg)
                draw(example, kind, png)
                pixels = png.read_bytes()
                # width and height stand in the head
                width, height = (int.from_bytes(pixels[at:at + 4], "big") for at in [16, 20])
                urls = ["data:image/svg+xml;base64," + base64.b64encode(svg.read_bytes()).decode(),
                        "data:image/png;base64," + base64.b64encode(pixels).decode()]
                share = browser.run(f"differing('{urls[0]}', '{urls[1]}', {width}, {height})")
                faults += share > MOST
                print(f"{example} {kind}: {100 * share:.2f} % of {width} x {height} pixels differ from resvg")
        finally:
            browser.close()
    print(f"{time.monotonic() - begin:.0f} s, {faults} faults")
    sys.exit(1 if faults else 0)


main()
