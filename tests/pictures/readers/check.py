#!/usr/bin/env python3
"""Reads DXF, TikZ and PDF pictures back with other programs.

    pip install ezdxf pypdf
    apt-get install --no-install-recommends texlive-latex-base texlive-pictures texlive-luatex poppler-utils
    tests/pictures/readers/check.py

draws all pictures of twelve examples, of every kind, and their schemes in true size, with the program that ASSUR names (target/release/assur;
it needs the feature `pdf`). ezdxf finds nothing to mend in any DXF, and its points are those of the SVG, as far as that has digits. pdflatex and
lualatex compile every TikZ picture without a warning; the paths of these PDFs are those of the DXF within 0.01 mm, those of the program's own
as far as SVG has digits. The program's own have all fonts within, and every label for poppler to find. Every format has the same bytes in a second run.
Exits with 1 where anything is wrong.
"""

import concurrent.futures
import html
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unicodedata

import ezdxf
import pypdf
from pypdf.generic import ContentStream

ROOT = pathlib.Path(__file__).resolve().parents[3]
ASSUR = os.environ.get("ASSUR", str(ROOT / "target/release/assur"))
EXAMPLES = ["kinetostatics/six-bar", "friction/four-bar", "flywheel/engine", "cams/lever", "trains/planetary-gearbox",
            "drives/cylinder-lift", "masses/rotor-in-four-planes", "harmonics/piston", "beams/beam-with-overhang",
            "motion/curvature-four-bar", "trusses/roof-of-seven-bars", "equilibrium/bar-upright"]
# what SVG and a PDF of it have of digits, and what is allowed of a PDF of TeX, mm
SVG, PDF = 0.015, 0.01
# points per millimetre
POINT = 72 / 25.4
FAULT = re.compile(r"Warning|Overfull|Underfull|Missing character|^!", re.MULTILINE)


def draw(*words):
    done = subprocess.run([ASSUR, "draw", *map(str, words)], capture_output=True, text=True, cwd=ROOT)
    return done.returncode


class Dxf:
    """The points of a drawing in order, and its circles."""

    def __init__(self, path):
        document = ezdxf.readfile(path)
        audit = document.audit()
        self.faults = [str(e.message) for e in audit.errors + audit.fixes]
        self.points, self.rounds, self.count = [], [], 0
        layers = {layer.dxf.name for layer in document.layers}
        for e in document.modelspace():
            self.count += 1
            if e.dxf.layer not in layers:
                self.faults.append(f"the layer {e.dxf.layer} is not declared")
            if e.dxf.color != 256:
                self.faults.append(f"a {e.dxftype()} has a colour of its own")
            self.read(e)

    def read(self, e):
        kind = e.dxftype()
        if kind == "LINE":
            self.points += [e.dxf.start, e.dxf.end]
        elif kind == "POLYLINE":
            self.points += [v.dxf.location for v in e.vertices]
        elif kind == "SOLID":
            self.points += [e.dxf.vtx0, e.dxf.vtx1, e.dxf.vtx2]
        elif kind == "CIRCLE":
            self.rounds.append((e.dxf.center, e.dxf.radius))
        elif kind == "ARC":
            self.rounds.append((e.dxf.center, e.dxf.radius))
            self.points += [e.start_point, e.end_point]
        elif kind == "POINT":
            self.points.append(e.dxf.location)
        elif kind != "TEXT":
            self.faults.append(f"{kind} is not expected")


class Near:
    """Points by their places."""

    def __init__(self, points, cell=0.05):
        self.cell, self.cells = cell, {}
        for x, y in points:
            self.cells.setdefault((round(x / cell), round(y / cell)), []).append((x, y))

    def distance(self, x, y):
        i, j = round(x / self.cell), round(y / self.cell)
        near = [p for a in (-1, 0, 1) for b in (-1, 0, 1) for p in self.cells.get((i + a, j + b), [])]
        return min((math.hypot(x - p[0], y - p[1]) for p in near), default=self.cell)


def svg(text):
    """Ends of lines and of parts of paths, middles of circles; y up."""
    number = r"-?[\d.]+"
    points = []
    for x1, y1, x2, y2 in re.findall(rf'<line [^>]*x1="({number})" y1="({number})" x2="({number})" y2="({number})"', text):
        points += [(x1, y1), (x2, y2)]
    for path in re.findall(r'<path [^>]*d="([^"]*)"', text):
        for command, rest in re.findall(r"([MLA])([^MLAZ]*)", path):
            points.append(rest.split()[-2:])
    for x, y, w, h in re.findall(rf'<rect class="n0" x="({number})" y="({number})" width="({number})" height="({number})"', text):
        points += [(float(x) + a * float(w), float(y) + b * float(h)) for a in (0, 1) for b in (0, 1)]
    points += re.findall(rf'<circle [^>]*cx="({number})" cy="({number})"', text)
    return [(float(x), -float(y)) for x, y in points]


def strokes(page, content, resources, matrix):
    """Points of the paths of a page or of a form in it, and the curves between them, points of the page."""
    stack, points, curves, at = [], [], [], None

    def place(x, y):
        a, b, c, d, e, f = matrix
        return a * x + c * y + e, b * x + d * y + f

    for operands, operator in ContentStream(content, page.pdf).operations:
        numbers = [float(x) for x in operands] if operator in (b"cm", b"m", b"l", b"c", b"re") else []
        if operator == b"q":
            stack.append(matrix)
        elif operator == b"Q":
            matrix = stack.pop()
        elif operator == b"cm":
            matrix = product(numbers, matrix)
        elif operator in (b"m", b"l"):
            at = place(*numbers)
            points.append(at)
        elif operator == b"c":
            ends = [at] + [place(*numbers[i:i + 2]) for i in (0, 2, 4)]
            curves.append(ends)
            at = ends[3]
            points.append(at)
        elif operator == b"re":
            x, y, w, h = numbers
            points += [place(x, y), place(x + w, y), place(x, y + h), place(x + w, y + h)]
        elif operator == b"Do":
            form = resources["/XObject"][operands[0]].get_object()
            if form["/Subtype"] == "/Form":
                own = product([float(x) for x in form.get("/Matrix", [1, 0, 0, 1, 0, 0])], matrix)
                found = strokes(page, form, form.get("/Resources", resources), own)
                points, curves = points + found[0], curves + found[1]
    return points, curves


def product(first, then):
    a, b, c, d, e, f = first
    m = then
    return (a * m[0] + b * m[2], a * m[1] + b * m[3], c * m[0] + d * m[2], c * m[1] + d * m[3],
            e * m[0] + f * m[2] + m[4], e * m[1] + f * m[3] + m[5])


def pdf(path, box):
    """Points of the paths of a page and the curves between them, mm with the origin of the drawing, y up."""
    [page] = pypdf.PdfReader(path).pages
    height = float(page.mediabox.height)
    points, curves = strokes(page, page.get_contents(), page["/Resources"], (1, 0, 0, 1, 0, 0))
    place = lambda at: (at[0] / POINT + box[0], (at[1] - height) / POINT + box[1])
    return list(map(place, points)), [list(map(place, ends)) for ends in curves], (float(page.mediabox.width) / POINT, height / POINT)


def off_circles(curves, rounds):
    """How far curves are from the circles that they are parts of."""
    worst = 0.0
    for a, b, c, d in curves:
        for t in (0.0, 0.25, 0.5):
            s = 1 - t
            x, y = (s**3 * a[i] + 3 * s * s * t * b[i] + 3 * s * t * t * c[i] + t**3 * d[i] for i in (0, 1))
            worst = max(worst, min((abs(math.hypot(x - m.x, y - m.y) - r) for m, r in rounds), default=math.inf))
    return worst


def rounded(text):
    """Rectangles of an SVG with round corners, which are sharp in DXF; y up."""
    number = r"(-?[\d.]+)"
    found = re.findall(rf'<rect [^>]*x="{number}" y="{number}" width="{number}" height="{number}" rx=', text)
    return [(float(x), -float(y) - float(h), float(x) + float(w), -float(y)) for x, y, w, h in found]


def off_paths(path, box, dxf, round_boxes=()):
    """How far the paths of a PDF are from those of the DXF, and its page from the picture, mm."""
    points, curves, size = pdf(path, box)
    there = Near(points)
    sharp = Near([(x, y) for a, b, c, d in round_boxes for x in (a, c) for y in (b, d)])
    off = max([there.distance(p.x, p.y) for p in dxf.points if sharp.distance(p.x, p.y) > SVG], default=0.0)
    inside = lambda at: any(a - SVG < at[0] < c + SVG and b - SVG < at[1] < d + SVG for a, b, c, d in round_boxes)
    curves = [ends for ends in curves if not (inside(ends[0]) and inside(ends[3]))]
    return max(off, off_circles(curves, dxf.rounds), abs(size[0] - box[2] + box[0]), abs(size[1] - box[1] + box[3]))


def plain(text):
    return "".join(unicodedata.normalize("NFKC", text).split())


def lettering(path, text):
    """What is wrong with fonts and labels of a PDF beside those of the SVG."""
    fonts = subprocess.run(["pdffonts", path], capture_output=True, text=True, check=True).stdout.splitlines()[2:]
    # name, kind, encoding, then yes or no: embedded, subset, with the table of its letters
    faults = [f"a font is not embedded: {font}" for font in fonts if re.search(r" (yes|no) +(yes|no) +(yes|no) ", font)[1] != "yes"]
    found = plain(subprocess.run(["pdftotext", "-raw", path, "-"], capture_output=True, text=True, check=True).stdout)
    labels = [plain(html.unescape(re.sub(r"<[^>]*>", "", label))) for label in re.findall(r"<text[ >].*?</text>", text, re.DOTALL)]
    return faults + [f"the label {label} is not found" for label in labels if label not in found]


def picture(name, folder):
    """What is wrong with a picture in its formats, how far points are off in SVG, in PDF of TeX and in its own, mm, and the entities."""
    dxf = Dxf(folder / f"{name}.dxf")
    faults = list(dxf.faults)
    text = (folder / f"{name}.tex").read_text()
    # left, top, right, bottom
    box = [float(x) for x in re.search(r"boundingbox \(([^)]*)\) rectangle \(([^)]*)\)", text).expand(r"\1,\2").split(",")]
    # an animation moves in SVG
    own = [] if name.endswith("-animation") else svg((folder / f"{name}.svg").read_text())
    middles = [(m.x, m.y) for m, _ in dxf.rounds]
    ends = [(p.x, p.y) for p in dxf.points]
    known, shown = Near(ends + middles), Near(own)
    in_svg = max([shown.distance(*p) for p in ends if own] + [known.distance(*p) for p in own], default=0.0)
    faults += [f"a point is {in_svg:.4f} mm off that of the SVG"] if in_svg > SVG else []
    in_pdf, in_own = [], 0.0
    faults += [] if text.isascii() else ["TikZ is not ASCII"]
    for engine in ["pdflatex", "lualatex"]:
        where = folder / engine
        where.mkdir(exist_ok=True)
        command = [engine, "-interaction=nonstopmode", f"-output-directory={where}", folder / f"{name}.tex"]
        done = subprocess.run(command, capture_output=True, cwd=folder)
        log = (where / f"{name}.log").read_text(errors="replace")
        said = FAULT.findall(log)
        if done.returncode or said:
            faults.append(f"{engine}: {done.returncode} {said[:3]}")
            continue
        in_pdf.append((off_paths(where / f"{name}.pdf", box, dxf), engine))
    faults += [f"{what}: a path is {off:.4f} mm off" for off, what in in_pdf if off > PDF]
    if own:
        shown = (folder / f"{name}.svg").read_text()
        off = off_paths(folder / f"{name}.pdf", box, dxf, rounded(shown))
        in_own = off
        faults += [f"PDF: a path is {off:.4f} mm off"] if off > SVG else []
        faults += lettering(folder / f"{name}.pdf", shown)
    return faults, [in_svg, max(in_pdf)[0] if in_pdf else 0.0, in_own], dxf.count


def main():
    faults, worst, entities = [], [0.0, 0.0, 0.0], 0
    with tempfile.TemporaryDirectory() as root, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        root, wanted = pathlib.Path(root), []
        for example in EXAMPLES:
            folder, again = root / example.replace("/", "-"), root / "again" / example.replace("/", "-")
            source = ROOT / f"examples/{example}.mech"
            for into in [folder, again]:
                for form in ["svg", "dxf", "tex", "tikz", "pdf"]:
                    draw(source, "--all", "-o", into, "--format", form)
                draw(source, "-o", into / "true-size.dxf", "--true-size")
            for path in sorted(folder.iterdir()):
                if path.read_bytes() != (again / path.name).read_bytes():
                    faults.append(f"{example}: {path.name} differs in a second run")
            if (folder / "true-size.dxf").exists():
                faults += [f"{example}: true size: {fault}" for fault in Dxf(folder / "true-size.dxf").faults]
            wanted += [(path.stem, folder) for path in sorted(folder.glob("*.tex"))]
        for (name, _), found in zip(wanted, pool.map(lambda of: picture(*of), wanted)):
            faults += [f"{name}: {fault}" for fault in found[0]]
            worst = [max(pair) for pair in zip(worst, found[1])]
            entities += found[2]
    print("\n".join(faults), end="\n" if faults else "")
    print(f"{len(wanted)} pictures of {len(EXAMPLES)} examples, {entities} entities of DXF: at most {worst[0]:.4f} mm off "
          f"SVG, {worst[1]:.4f} mm between DXF and the PDF of TeX, {worst[2]:.4f} mm and its own; {len(faults)} faults")
    return 1 if faults or not wanted else 0


if __name__ == "__main__":
    sys.exit(main())
