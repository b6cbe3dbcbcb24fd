#!/usr/bin/env python3
"""Looks at worked solutions in a browser, on screens and on paper.

    tests/worked/browser/check.py [--all]

writes the solutions of examples of all chapters (of all examples with --all) with the program that ASSUR names (target/release/assur)
and opens them 390, 900 and 1600 px wide, light and dark, and as wide as A4 has room: nothing wider than the page, no formula cut off, no
message, no request, no scroll bar on paper, headings without gaps, tables with header cells, contrast of 4.5 : 1. Prints them and reads
from the PDF how long the scale bars are on paper, and that no page but the last is more than half empty, unless a figure follows that has
no room on it. Exits with 1 where anything is wrong.
"""

import base64
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(ROOT / "tests/pictures/browser")]

from devtools import Browser, Failure  # noqa: E402
from paper import Page, pages  # noqa: E402

ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))
# what is written: an example, and how
PAGES = [("crank-slider", []), ("kinetostatics/six-bar", []), ("kinetostatics/six-bar", ["--lang", "ru"]), ("dyads/rpp", ["--lang", "zh"]),
         ("shaper/shaper-b", []), ("friction/four-bar", []), ("flywheel/engine", []), ("cams/lever", []), ("trains/planetary-gearbox", []),
         ("general/class-iii-triad", []), ("synthesis/crank-rocker", []),
         ("exercise-set/11-kinetostatics-of-a-six-bar", ["--sheet"])]
WIDTHS = [390, 900, 1600]
# what A4 has between its margins, px; how wide a scale bar may be off; how much of a page may be empty
A4, SCALE, EMPTY = round((210 - 28) / 25.4 * 96), 0.005, 0.5
CONTRAST = 4.5


class Check:
    def __init__(self, browser):
        self.browser, self.faults = browser, []
        self.script = (HERE / "page.js").read_text()
        self.looks = self.bars = self.sheets = self.before_figures = 0

    def fault(self, name, faults):
        self.faults += [f"{name}: {fault}" for fault in faults]

    def page(self, name, path):
        b = self.browser
        b.look(WIDTHS[0])
        b.open(path)
        b.run(self.script)
        self.fault(name, b.run("outline()") + b.run("figures()"))
        for width, media, dark in [(w, "screen", d) for w in WIDTHS for d in (False, True)] + [(A4, "print", False), (A4, "print", True)]:
            b.look(width, media, dark)
            self.looks += 1
            where = f"{name}, {width} px {'printed' if media == 'print' else 'dark' if dark else 'light'}"
            self.fault(where, b.run("overflow()") + b.run(f"contrast({CONTRAST})"))
            self.fault(where, b.run(f"clipped({'false' if media == 'print' else 'true'})"))
            if media == "print":
                self.fault(where, b.run("bars()"))
        b.look(900)
        wanted, tallest = b.run("lengths()"), b.run("tallest()")
        b.look(900, "print")
        pdf = base64.b64decode(b.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"])
        self.paper(name, wanted, tallest, [Page(contents) for contents in pages(pdf)])
        self.fault(name, b.messages)
        self.fault(name, [f"asks for {url[:80]}" for url in b.requests[1:]])

    def paper(self, name, wanted, tallest, printed):
        self.sheets += len(printed)
        found = [bar for page in printed for bar in page.bars()]
        self.bars += len(found)
        if len(found) != len(wanted):
            self.fault(name, [f"{len(found)} of {len(wanted)} scale bars are on paper"])
        for bar, length in zip(found, wanted):
            if abs(bar / length - 1) > SCALE:
                self.fault(name, [f"a scale bar of {length:.2f} mm is {bar:.2f} mm long on paper"])
        # 16 mm above and below
        room = 842 - 2 * 16 / 25.4 * 72
        for number, page in enumerate(printed[:-1], 1):
            empty = (page.lowest - 16 / 25.4 * 72) / room
            if empty > EMPTY and empty * room * 25.4 / 72 < tallest:
                self.before_figures += 1
            elif empty > EMPTY:
                self.fault(name, [f"page {number} of {len(printed)} is empty from {100 * (1 - empty):.0f} % on"])


def main():
    program = os.environ.get("CHROMIUM") or shutil.which("chromium") or shutil.which("google-chrome")
    if not program:
        sys.exit("there is no browser: install chromium, or name one in CHROMIUM")
    written = PAGES
    if "--all" in sys.argv[1:]:
        written = [(str(p.relative_to(ROOT / "examples"))[:-5], []) for p in sorted((ROOT / "examples").rglob("*.mech"))]
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        browser = Browser(program)
        check = Check(browser)
        try:
            for example, words in written:
                path = pathlib.Path(folder) / "page.html"
                path.unlink(missing_ok=True)
                name = " ".join([example, *words])
                done = subprocess.run([ASSUR, "report", f"examples/{example}.mech", *words, "-o", path], capture_output=True, text=True, cwd=ROOT)
                if path.exists():
                    try:
                        check.page(name, path)
                    except Failure as failure:
                        check.fault(name, [str(failure)])
                        browser.close()
                        browser = check.browser = Browser(program)
                elif "--all" not in sys.argv[1:]:
                    check.fault(name, [f"no page: {done.stderr}"])
        finally:
            browser.close()
    print(f"{len(written)} solutions, {check.looks} looks, {check.sheets} sheets of A4, {check.bars} scale bars on paper")
    print(f"{check.before_figures} sheets are half empty before a figure that has no room on them")
    print(f"{time.monotonic() - begin:.0f} s, {len(check.faults)} faults")
    print("\n".join(check.faults[:200]))
    sys.exit(1 if check.faults else 0)


main()
