#!/usr/bin/env python3
"""Makes the pages of docs as HTML, next to the playground: docs/site/build.py FOLDER, as `playground/dist/docs`.

Needs the package `markdown` of PyPI. ASSUR names the program whose output is printed below the blocks of the reference. A block that is a
whole file gets a link that opens it in the playground; one that moves does so in place, by `embed/assur-mech.js` of the playground.
Addresses are relative, and a link that leads nowhere ends the program with 1.
"""

import base64
import html
import os
import re
import shutil
import subprocess
import sys
import zlib
from pathlib import Path

import markdown

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
ASSUR = os.environ.get("ASSUR", ROOT / "target/release/assur")
VERSION = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(), re.MULTILINE)[1]
# what is copied as it is
FOLDERS = ["pictures", "reports", "json-schema", "measured/accuracy", "measured/simulation"]
MENU = ["tour", "language", "commands", "simulation", "teaching", "report", "pictures", "reading", "glossary"]
# others, below the menu's end
MORE = ["accuracy", "effects", "numerics", "editors", "python", "library"]


def title(page: Path) -> str:
    return page.read_text(encoding="utf-8").partition("\n")[0].lstrip("# ")


def name(page: str) -> str:
    """What the menu calls a page: a word."""
    return {"simulation": "motion", "report": "solutions", "reading": "textbook"}.get(page, page).capitalize()


def opened(text: str) -> str:
    """Where the playground opens a text, from its own page on: base64url of raw deflate."""
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    data = packer.compress(text.encode()) + packer.flush()
    return f"#1/{VERSION}/" + base64.urlsafe_b64encode(data).rstrip(b"=").decode()


def run(command: str, text: str, *more: str) -> tuple[int, str, str]:
    done = subprocess.run([ASSUR, command, "-", *more], input=text, capture_output=True, text=True, cwd=ROOT)
    return done.returncode, done.stdout, done.stderr


def slug(text: str, separator: str) -> str:
    """The name of a heading, as GitHub has it."""
    kept = re.sub(r"[^\w\- ]", "", html.unescape(re.sub("<[^>]+>", "", text)).lower())
    return kept.strip().replace(" ", separator)


class Page:
    """One page: its blocks of code are set aside before Markdown reads it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.top = "../" * (len(path.relative_to(DOCS).parts) - 1)
        self.is_tour = path.stem == "tour"
        self.blocks: list[str] = []

    def block(self, found: re.Match) -> str:
        language, text = found[1], found[2]
        self.blocks.append(self.shown(language.strip(), text))
        return f"\n\n<div>block {len(self.blocks) - 1}</div>\n\n"

    def shown(self, language: str, text: str) -> str:
        code = f"<pre><code>{html.escape(text, quote=False)}</code></pre>"
        files = (ROOT / "examples/tour").glob("*.txt")
        is_wrong = language == "text" and any(text == file.read_text(encoding="utf-8") for file in files)
        if language == "mech" or is_wrong:
            parts = [f'<a class="open" href="{self.top}../{opened(text)}">open</a>', code]
            # what has an animation is a whole mechanism
            if not is_wrong and run("draw", text, "animation", "--format", "svg")[0] == 0:
                inside = html.escape(text, quote=False)
                parts.append(f"<details><summary>move it here</summary><assur-mech>{inside}</assur-mech></details>")
            if not is_wrong and not self.is_tour:
                status, out, err = run("solve", text)
                if status != 0:
                    sys.exit(f"{self.path}: a block is not solved:\n{text}\n{err}")
                parts.append(f"<details><summary>output</summary><pre>{html.escape(err + out)}</pre></details>")
            return f'<div class="mech">{"".join(parts)}</div>'
        return f'<div class="{language.split(" ")[0] or "text"}">{code}</div>'

    def link(self, found: re.Match) -> str:
        """An address of the repository as one of the site."""
        kind, address = found[1], html.unescape(found[2])
        if re.match("https?:|#", address):
            return found[0]
        file, _, place = address.partition("#")
        target = (self.path.parent / file).resolve()
        inner = target.relative_to(ROOT).as_posix() if target.is_relative_to(ROOT) else ""
        if inner == "playground":
            return f'{kind}="{self.top}../"'
        if target.suffix == ".mech":
            return f'{kind}="{self.top}../{opened(target.read_text(encoding="utf-8"))}"'
        if target.suffix == ".md" and target.is_relative_to(DOCS):
            return f'{kind}="{file[:-3]}.html{"#" if place else ""}{place}"'
        if target.is_relative_to(DOCS):
            return found[0]
        # of the repository alone
        return f'title="{inner} in the repository"'

    def written(self) -> str:
        text = self.path.read_text(encoding="utf-8")
        text = re.sub(r"^```(.*)\n((?:.*\n)*?)```$", self.block, text, flags=re.MULTILINE)
        reader = markdown.Markdown(
            extensions=["tables", "toc", "sane_lists"],
            extension_configs={"toc": {"slugify": slug, "toc_depth": "2-3"}},
        )
        # lists directly below a line of text
        text = re.sub(r"^((?![-*|>#] |\d+\. |  ).+)\n(?=- )", r"\1\n\n", text, flags=re.MULTILINE)
        body = reader.convert(text)
        # a page is called by its name, not by its file
        body = re.sub(r'(<a href="[^"#]*?([a-z]+)\.md[^"]*">)\2\.md</a>', lambda found: f"{found[1]}{name(found[2])}</a>", body)
        body = re.sub(r'(href|src)="([^"]*)"', self.link, body)
        body = body.replace("<table>", '<div class="table"><table>').replace("</table>", "</table></div>")
        body = re.sub(r"<div>block (\d+)</div>", lambda found: self.blocks[int(found[1])], body)
        moves = "<assur-mech>" in body
        script = f'<script type="module" src="{self.top}../embed/assur-mech.js"></script>' if moves else ""
        return TEMPLATE.format(
            title=html.escape(title(self.path)), top=self.top, menu=self.menu(), contents=reader.toc, body=body, script=script
        )

    def menu(self) -> str:
        def entry(page: str) -> str:
            here = ' aria-current="page"' if self.path == DOCS / f"{page}.md" else ""
            return f'<a href="{self.top}{page}.html"{here}>{name(page)}</a>'

        more = "".join(entry(page) for page in MORE)
        return f'<a href="{self.top}../">Playground</a>' + "".join(map(entry, MENU)) + f'<span class="more">{more}</span>'


TEMPLATE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · assur</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{top}style.css">
{script}
</head>
<body>
<header><nav aria-label="Pages">{menu}</nav></header>
<div class="page">
<aside aria-label="On this page">{contents}</aside>
<main>
{body}
</main>
</div>
</body>
</html>
"""


def check(out: Path) -> None:
    """Every address leads to a file of the site, and to a heading of it; that of the playground is above."""
    wrong = []
    anchors = {page: set(re.findall(r'id="([^"]+)"', page.read_text(encoding="utf-8"))) for page in out.rglob("*.html")}
    made = [page for page in anchors if (DOCS / page.relative_to(out)).with_suffix(".md").exists()]
    for page in made:
        for address in re.findall(r'(?:href|src)="([^"]+)"', page.read_text(encoding="utf-8")):
            file, _, place = html.unescape(address).partition("#")
            target = (page.parent / file).resolve() if file else page
            if address.startswith(("http", "data:")) or not target.is_relative_to(out) or target == out:
                continue
            if not target.exists() or (place and place not in anchors.get(target, {place})):
                wrong.append(f"{page.relative_to(out)}: {address}")
    if wrong:
        sys.exit("these lead nowhere:\n" + "\n".join(wrong))


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit("docs/site/build.py FOLDER")
    out = Path(sys.argv[1]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    pages = sorted(DOCS.glob("*.md")) + sorted((DOCS / "measured").glob("*.md"))
    for path in pages:
        to = (out / path.relative_to(DOCS)).with_suffix(".html")
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(Page(path).written(), encoding="utf-8")
    shutil.copy(out / "tour.html", out / "index.html")
    shutil.copy(Path(__file__).with_name("style.css"), out)
    for folder in FOLDERS:
        shutil.copytree(DOCS / folder, out / folder, dirs_exist_ok=True)
    check(out)
    print(f"{len(pages)} pages in {out}")


if __name__ == "__main__":
    main()
