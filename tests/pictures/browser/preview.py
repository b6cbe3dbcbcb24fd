#!/usr/bin/env python3
"""Opens a page of `assur preview` in a browser.

    tests/pictures/browser/preview.py

follows a file with the program that ASSUR names (target/release/assur): slider and keys move the picture, a link that is clicked
shows its statement, a change of the file redraws at the same pose, a mistake keeps the picture and is shown as text. With SHOTS
names a folder for pictures of the page. Exits with 1 where anything is wrong.
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
ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))
EXAMPLE = ROOT / "examples/crank-slider.mech"
UPRIGHT = ROOT / "examples/flywheel/engine.mech"
# seconds for a change to arrive
PATIENCE = 10
SLIDER = "document.querySelector('.motion-slider')"
# the centre of a drawn thing in the window
CENTRE = """(() => {
  const box = document.querySelector('g.link[data-name="NAME"] *').getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
})()"""


class Check:
    def __init__(self, browser, file):
        self.browser, self.file, self.faults = browser, file, []

    def hold(self, what, truth):
        if not truth:
            self.faults.append(what)

    def wait(self, what, script):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if self.browser.run(f"(() => {{ try {{ return Boolean({script}) }} catch {{ return false }} }})()"):
                return
            time.sleep(0.05)
        self.faults.append(f"{what}: never")

    def crank(self):
        return self.browser.run(CENTRE.replace("NAME", "crank"))

    def shot(self, name):
        folder = os.environ.get("SHOTS")
        if folder:
            data = self.browser.call("Page.captureScreenshot")["data"]
            (pathlib.Path(folder) / f"{name}.png").write_bytes(base64.b64decode(data))

    def page(self):
        text = self.file.read_text()
        self.wait("the picture", SLIDER)
        self.shot("preview")
        first = self.crank()
        self.browser.run(f"(s => {{ s.value = s.max / 4; s.dispatchEvent(new Event('input')) }})({SLIDER})")
        moved = self.crank()
        self.hold("the slider moves the crank", abs(moved[0] - first[0]) + abs(moved[1] - first[1]) > 5)
        pose = int(self.browser.run(f"{SLIDER}.value"))
        self.browser.key("ArrowRight")
        self.hold("a key moves on", int(self.browser.run(f"{SLIDER}.value")) == pose + 1)

        self.browser.click(*self.crank())
        said = self.browser.run("document.getElementById('statement').textContent")
        line = next(i for i, line in enumerate(text.split("\n"), 1) if line.startswith("link 1 crank"))
        self.hold(f"a click shows the statement: {said}", said.endswith(f"{self.file.name}:{line}  link 1 crank A-B r"))

        before = self.browser.run("document.querySelector('#picture svg').outerHTML.length")
        self.file.write_text(text.replace("link 1 crank", "lnk <b>crank"))
        self.wait("the mistake", "document.getElementById('diagnostics').textContent.includes('lnk <b>crank')")
        self.shot("preview-wrong")
        self.hold("a mistake is text", self.browser.run("document.querySelector('#diagnostics b') === null"))
        after = self.browser.run("document.querySelector('#picture svg').outerHTML.length")
        self.hold("a mistake keeps the picture", after == before)

        self.file.write_text(text.replace("crank", "arm"))
        self.wait("the change", "document.querySelector('g.link[data-name=\"arm\"]')")
        self.hold("a change keeps the pose", int(self.browser.run(f"{SLIDER}.value")) == pose + 1)
        self.hold("without a mistake", self.browser.run("document.getElementById('diagnostics').textContent") == "")
        self.file.write_text(UPRIGHT.read_text())
        self.wait("another mechanism", "document.querySelector('#picture svg title').textContent.includes('Flywheel')")
        height = self.browser.run("document.querySelector('#picture svg').getBoundingClientRect().height")
        self.hold(f"a high picture fits the window: {height}", height < 0.7 * 900)
        self.shot("preview-upright")
        self.browser.look(390, dark=True)
        self.shot("preview-phone")
        self.hold("it fits a phone", self.browser.run("document.documentElement.scrollWidth <= innerWidth"))


def main():
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
    if not program:
        sys.exit("there is no browser: install chromium, or name one in CHROMIUM")
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "crank-slider.mech"
        file.write_text(EXAMPLE.read_text())
        preview = subprocess.Popen([ASSUR, "preview", "--no-open", file], stdout=subprocess.PIPE, text=True)
        browser = Browser(program)
        try:
            browser.look(900)
            browser.call("Page.navigate", url=preview.stdout.readline().strip())
            check = Check(browser, file)
            check.page()
            faults = check.faults + [f"the page says {m}" for m in browser.messages]
        finally:
            browser.close()
            preview.terminate()
            preview.wait()
    print(f"a page of assur preview: {len(faults)} faults, {time.monotonic() - begin:.1f} s", *faults, sep="\n  ")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
