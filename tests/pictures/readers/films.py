#!/usr/bin/env python3
"""Compares GIF and APNG with the animation that a browser shows.

    pip install pillow
    tests/pictures/readers/films.py

films ten animations with the program that ASSUR names (target/release/assur; it needs the feature `gif`), in both formats, and shows the page of
the same frames in Chromium. Pillow finds the frames, the time of six seconds and no end in both; each frame is that of the page, as far as
another program's letters allow; both formats have the same bytes in a second run. Exits with 1 where anything is wrong.
"""

import base64
import io
import os
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageChops, ImageStat

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/pictures/browser"))
import devtools  # noqa: E402

ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))
CHROMIUM = os.environ.get("CHROMIUM", "chromium")
EXAMPLES = ["accuracy/four-bar", "kinetostatics/six-bar", "shaper/full-stroke", "crank-slider", "cams/lever", "trains/planetary-gearbox",
            "drives/cylinder-lift", "simulation/pendulum", "flywheel/engine", "motion/curvature-four-bar"]
COUNT, WIDTH = 48, 640
# how far a frame may be from the page, of 255 levels, on average
LEVELS = 2.0


def draw(source, path):
    done = subprocess.run([ASSUR, "draw", str(source), "animation", "--frames", str(COUNT), "-o", str(path)], capture_output=True, text=True, cwd=ROOT)
    return done.stderr.strip() if done.returncode else ""


def shot(browser, frame, size):
    """A frame as the page shows it."""
    browser.run(f"(played.show({frame}), (f => {{ f.style.cssText = 'position:fixed;left:0;top:0;max-width:none;max-height:none;z-index:9;background:#fff;width:{size[0]}px;height:{size[1]}px' }})(document.querySelector('svg.fig')))")
    clip = {"x": 0, "y": 0, "width": size[0], "height": size[1], "scale": 1}
    data = browser.call("Page.captureScreenshot", format="png", clip=clip)["data"]
    return Image.open(io.BytesIO(base64.b64decode(data))).convert("RGB")


def film(path):
    """The frames of a film, its time in ms and how often it is shown."""
    with Image.open(path) as image:
        frames, time = [], 0.0
        for k in range(image.n_frames):
            image.seek(k)
            frames.append(image.convert("RGB"))
            time += image.info["duration"]
        return frames, time, image.info.get("loop")


def compared(browser, name, folder):
    source, faults, worst = ROOT / f"examples/{name}.mech", [], 0.0
    page = folder / "page.html"
    if said := draw(source, page):
        return [said], worst
    films = {}
    for form in ["gif", "apng"]:
        paths = [folder / f"{run}.{form}" for run in (1, 2)]
        said = [draw(source, path) for path in paths]
        if any(said):
            return said, worst
        if paths[0].read_bytes() != paths[1].read_bytes():
            faults.append(f"{form}: other bytes in a second run")
        films[form], time, loop = film(paths[0])
        if len(films[form]) != COUNT or abs(time - 6000) > 1 or loop != 0:
            faults.append(f"{form}: {len(films[form])} frames in {time} ms, shown {loop} times")
    browser.open(page)
    for k in range(COUNT):
        seen = shot(browser, k, films["gif"][0].size)
        worst = max([worst] + [sum(ImageStat.Stat(ImageChops.difference(seen, frames[k])).mean) / 3 for frames in films.values()])
    faults += [f"a frame is {worst:.2f} levels off"] if worst > LEVELS else []
    return faults, worst


def main():
    faults = []
    with tempfile.TemporaryDirectory() as root:
        browser = devtools.Browser(CHROMIUM)
        # higher than any picture
        browser.call("Emulation.setDeviceMetricsOverride", width=1200, height=2000, deviceScaleFactor=1, mobile=False)
        for name in EXAMPLES:
            folder = pathlib.Path(root) / name.replace("/", "-")
            folder.mkdir()
            found, worst = compared(browser, name, folder)
            sizes = [f"{path.stat().st_size // 1000} kB" for path in sorted(folder.glob("1.*png")) + sorted(folder.glob("1.gif"))]
            print(f"{name}: at most {worst:.2f} levels off, APNG and GIF {', '.join(sizes)}")
            faults += [f"{name}: {fault}" for fault in found]
        browser.close()
    print("\n".join(faults), end="\n" if faults else "")
    print(f"{len(EXAMPLES)} animations, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
