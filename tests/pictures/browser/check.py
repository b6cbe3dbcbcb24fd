#!/usr/bin/env python3
"""Looks at pictures and animations in a browser.

    tests/pictures/browser/check.py [--all]

draws the pictures of a selection of the examples (of all with --all) with the program that ASSUR names
(target/release/assur) and opens them 390, 900 and 1600 px wide, light, dark and printed: no label on another, nothing wider
than the page, no message, no request, texts as wide as the table of widths says within 8 %. Presses slider, play and keys of
animations and compares three frames with the schemes of these positions, and with those of the picture that moves without a
script. Where rsvg-convert is installed, what it shows of the
twelve scenes is compared with the browser. Exits with 1 where anything is wrong.
"""

import base64
import json
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
# every so many of the examples, and those with every kind of picture
EVERY = 9
ALWAYS = ["kinetostatics/six-bar", "shaper/full-stroke", "friction/four-bar", "flywheel/engine", "cams/lever",
          "trains/planetary-gearbox", "contacts/geneva-turns", "drives/cylinder-lift"]
# animations of which three frames are compared with the schemes of their positions
MOVING = {"shaper/full-stroke": [1, 7, 12], "drives/cylinder-lift": [1, 3, 5], "flywheel/engine": [1, 13, 24]}
# pictures of the scenes of the design, and how they are drawn
SCENES = ROOT / "tests/pictures/snapshots"
WIDTHS = [390, 900, 1600]
# frames of an animation with and without a script
FRAMES = 24
# frames in which labels may lie on each other
COVERED = 0.01
# of the length that holds a text, mm between a frame and its scheme, share of pixels
WIDTH, FRAME, PIXELS = 0.08, 0.08, 0.02


def draw(*words):
    done = subprocess.run([ASSUR, "draw", *map(str, words)], capture_output=True, text=True, cwd=ROOT)
    return done.returncode


def examples(everything):
    names = sorted(str(p.relative_to(ROOT / "examples"))[:-5] for p in (ROOT / "examples").rglob("*.mech"))
    return [n for i, n in enumerate(names) if everything or i % EVERY == 0 or n in ALWAYS]


class Check:
    def __init__(self, browser, folder):
        self.browser, self.folder, self.faults = browser, folder, []
        self.script = (HERE / "page.js").read_text()
        self.pages = self.looks = self.texts = self.figures = 0
        self.widest, self.covered = 0.0, []

    def fault(self, name, faults):
        self.faults += [f"{name}: {fault}" for fault in faults]

    def open(self, path):
        self.browser.open(path)
        self.browser.run(self.script)

    def quiet(self, name):
        """The page has said nothing and asked for nothing but itself."""
        self.fault(name, self.browser.messages)
        self.fault(name, [f"asks for {url[:80]}" for url in self.browser.requests[1:]])

    def page(self, name, path):
        """A page in all widths and colours."""
        self.pages += 1
        papers = []
        for width in WIDTHS:
            for media, dark in [("screen", False), ("screen", True), ("print", False)]:
                self.browser.look(width, media, dark)
                if not self.looks or (width, media, dark) == (WIDTHS[0], "screen", False):
                    self.open(path)
                self.looks += 1
                where = f"{name}, {width} px {'printed' if media == 'print' else 'dark' if dark else 'light'}"
                self.fault(where, self.browser.run("overflow()"))
                papers.append(self.browser.run("colours()"))
        # boxes are in millimetres of paper, the same in every width
        self.fault(name, self.browser.run("labels()"))
        found = self.browser.run(f"widths({WIDTH})")
        self.texts += found["count"]
        self.figures += self.browser.run("document.querySelectorAll('svg.fig').length")
        self.widest = max(self.widest, found["most"])
        self.fault(name, found["wrong"])
        if papers[0] == papers[1] or papers[0] != papers[2]:
            self.fault(name, [f"the paper is {papers[:3]}"])
        self.quiet(name)
        self.browser.look(900)

    def animation(self, name, path):
        """Slider, play and keys; how often labels lie on each other while it moves."""
        b = self.browser
        self.open(path)
        value = lambda: int(b.run("document.querySelector('.motion-slider').value"))
        last = int(b.run("document.querySelector('.motion-slider').max"))
        b.key("ArrowRight")
        steps = [value()]
        b.key("ArrowLeft")
        b.key("ArrowLeft")
        steps.append(value())
        if steps != [1, last]:
            self.fault(name, [f"the arrow keys go to {steps} of {last}"])
        centre = "(e => { e.scrollIntoView(); const r = e.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] })"
        b.click(*b.run(f"{centre}(document.querySelector('.motion-slider'))"))
        if abs(value() - last / 2) > 0.1 * last + 1:
            self.fault(name, [f"the slider goes to {value()} of {last}"])
        for press in ["click", "blank"]:
            before = value()
            if press == "click":
                b.click(*b.run(f"{centre}(document.querySelector('.motion-play'))"))
            else:
                b.run("document.activeElement.blur()")
                b.key(" ", "Space")
            # a busy machine shows its first frame late
            patience = time.monotonic() + 10
            while value() == before and time.monotonic() < patience:
                time.sleep(0.05)
            if value() == before:
                self.fault(name, [f"it does not play after a {press}"])
            b.run("document.activeElement.blur()")
            b.key(" ", "Space")
            stopped = value()
            time.sleep(0.1)
            if value() != stopped:
                self.fault(name, [f"it does not stop after a {press}"])
        on = b.run("(() => { let n = 0; for (let i = 0; i < played.frames; i++) { played.show(i); n += overlaps(document.querySelector('svg.fig'), 0.05).length > 0 } played.show(0); return n / played.frames })()")
        self.covered.append((on, name))
        if on > COVERED:
            self.fault(name, [f"labels lie on each other in {100 * on:.1f} % of the frames"])
        self.quiet(name)

    def frames(self, name, source, poses):
        """Three frames have their hinges where the schemes of these positions have them."""
        moving = self.folder / "moving.html"
        draw(source, "animation", "-o", moving)
        compared = 0
        for pose in poses:
            scheme = self.folder / "scheme.svg"
            draw(source, "--pose", pose, "--loads", "none", "-o", scheme)
            self.open(scheme)
            still = self.browser.run("hinges('svg')")
            # `…: kinematic scheme at pose 7, crank = 8.2 deg`
            words = self.browser.run("title(document.documentElement)").split(" at ")[-1].split(", ")[-1]
            self.open(moving)
            if not self.browser.run(f"shows({json.dumps(words)})"):
                self.fault(name, [f"no frame says {words}"])
                continue
            moved = self.browser.run("hinges('svg.fig')")
            names = sorted(set(still["places"]) & set(moved["places"]))
            for other in names[1:]:
                apart = [[place[other][i] - place[names[0]][i] for i in (0, 1)] for place in (still["places"], moved["places"])]
                ratio = still["scale"] / moved["scale"]
                away = max(abs(apart[0][i] * ratio - apart[1][i]) for i in (0, 1))
                compared += 1
                if away > FRAME * max(1.0, ratio):
                    self.fault(name, [f"{other} at pose {pose} is {away:.3f} mm off"])
        if compared < 3:
            self.fault(name, [f"only {compared} hinges are compared"])

    def without_script(self, name, source):
        """The picture that moves without a script has its hinges where the page has them."""
        page, picture = self.folder / "moving.html", self.folder / "moving.svg"
        for out in [page, picture]:
            draw(source, "animation", "--frames", FRAMES, "-o", out)
        places = {}
        for path, go in [(page, "played.show({0})"), (picture, "(e => (e.pauseAnimations(), e.setCurrentTime(6 * {0} / {1})))(document.documentElement)")]:
            self.open(path)
            selector = "svg.fig" if path == page else "svg"
            for frame in [0, FRAMES // 3, FRAMES - 2]:
                self.browser.run(go.format(frame, FRAMES - 1))
                places.setdefault(frame, []).append(self.browser.run(f"hinges('{selector}')")["places"])
            self.quiet(f"{name} without a script")
        moved = 0.0
        for frame, (there, here) in places.items():
            if sorted(there) != sorted(here) or len(here) < 2:
                self.fault(name, [f"frame {frame} without a script has the hinges {sorted(here)}, the page {sorted(there)}"])
            for hinge in set(there) & set(here):
                away = max(abs(there[hinge][i] - here[hinge][i]) for i in (0, 1))
                moved = max([moved] + [abs(here[hinge][i] - places[0][1][hinge][i]) for i in (0, 1)])
                if away > FRAME:
                    self.fault(name, [f"{hinge} in frame {frame} without a script is {away:.3f} mm off"])
        if moved < 1.0:
            self.fault(name, ["nothing moves without a script"])

    def rasters(self):
        """librsvg shows what the browser shows."""
        shares = {}
        for path in sorted(SCENES.glob("*.svg")):
            done = subprocess.run(["rsvg-convert", "-w", "900", str(path)], capture_output=True)
            if done.returncode != 0:
                self.fault(path.name, [done.stderr.decode()])
                continue
            self.open(path)
            height = self.browser.run("(v => Math.round(900 * v.height / v.width))(document.documentElement.viewBox.baseVal)")
            self.browser.open(HERE / "empty.html")
            self.browser.run(self.script)
            urls = ["data:image/svg+xml;base64," + base64.b64encode(path.read_bytes()).decode(),
                    "data:image/png;base64," + base64.b64encode(done.stdout).decode()]
            share = self.browser.run(f"differing('{urls[0]}', '{urls[1]}', 900, {height})")
            shares[path.stem] = share
            if share > PIXELS:
                self.fault(path.name, [f"{100 * share:.2f} % of the pixels differ from librsvg"])
        return shares


def main():
    everything = "--all" in sys.argv[1:]
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
    if not program:
        sys.exit("there is no browser: install chromium, or name one in CHROMIUM")
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        browser = Browser(program)
        check = Check(browser, pathlib.Path(folder))
        try:
            for name in examples(everything):
                source, page = f"examples/{name}.mech", check.folder / "page.html"
                page.unlink(missing_ok=True)
                draw(source, "--all", "-o", page)
                if page.exists():
                    check.page(name, page)
                moving = check.folder / "moving.html"
                moving.unlink(missing_ok=True)
                if draw(source, "animation", "-o", moving) == 0:
                    check.page(f"{name}, moving", moving)
                    check.animation(f"{name}, moving", moving)
            for name, poses in MOVING.items():
                check.frames(name, f"examples/{name}.mech", poses)
                check.without_script(name, f"examples/{name}.mech")
            differing = check.rasters() if shutil.which("rsvg-convert") else {}
        finally:
            browser.close()
    print(f"{check.pages} pages, {check.figures} pictures, {check.looks} looks, {check.texts} texts, widest {100 * check.widest:.1f} % off")
    shares = ", ".join(f"{100 * share:.0f} % {name}" for share, name in sorted(check.covered, reverse=True)[:5])
    print(f"frames of animations in which labels meet: {shares}")
    for name, share in differing.items():
        print(f"{name}: {100 * share:.2f} % of the pixels differ from librsvg")
    print(f"{time.monotonic() - begin:.0f} s, {len(check.faults)} faults")
    print("\n".join(check.faults[:200]))
    sys.exit(1 if check.faults else 0)


main()
