"""The guide runs from top to bottom, and so do the examples for courses."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
import xml.etree.ElementTree as xml

import pytest
from conftest import ROOT

import assur

PYTHON = ROOT / "examples/python"


def test_the_guide() -> None:
    for needed in ("pyarrow", "polars", "joblib"):
        pytest.importorskip(needed)
    page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    names: dict = {}
    blocks = list(re.finditer(r"^```python\n(.*?)^```$", page, re.MULTILINE | re.DOTALL))
    assert len(blocks) > 10
    for block in blocks:
        lines_before = page[: block.start(1)].count("\n")
        exec(compile("\n" * lines_before + block[1], "docs/python.md", "exec"), names)


def test_prairielearn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(PYTHON / "prairielearn")
    data: dict = {}
    runpy.run_path("server.py")["generate"](data)
    assert 80 <= data["params"]["r"] <= 120 and data["params"]["scheme"].startswith("<svg")
    assert all(isinstance(float(x), float) for x in data["correct_answers"].values())


def test_nbgrader(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    monkeypatch.chdir(PYTHON / "prairielearn")
    runpy.run_path(str(PYTHON / "nbgrader_cell.py"))
    wrong = (PYTHON / "nbgrader_cell.py").read_text().replace("Mb = 472.5", "Mb = -472.5")
    (tmp_path / "wrong.py").write_text(wrong)
    with pytest.raises(AssertionError):
        runpy.run_path(str(tmp_path / "wrong.py"))


def test_moodle(tmp_path) -> None:
    table = tmp_path / "rows.csv"
    table.write_text("r [mm],n [rpm]\n100,1500\n90,1200\n")
    command = [sys.executable, PYTHON / "moodle.py", PYTHON / "prairielearn/engine.mech", table]
    quiz = xml.fromstring(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
    assert len(quiz) == 4
    answer = float(quiz[0].find("answer/text").text)
    assert answer == pytest.approx(472.519, rel=1e-5)


def test_notebooks() -> None:
    shell = pytest.importorskip("IPython.core.interactiveshell").InteractiveShell.instance()
    shell.run_line_magic("load_ext", "assur")
    text = "shaft I { wheel a teeth 20 }\nshaft O { wheel b teeth 50 }\nmesh k: a - b\ndrive I at 10 rad/s\nfind omega(O)\n"
    shell.run_cell_magic("mech", "gears", text)
    assert shell.user_ns["gears"]["omega(O)"].tolist() == [-4.0]
    assert "mech::name::unknown" in str(shell.run_cell_magic("mech", "", text.replace("a - b", "a - c")))


def test_the_lexer_is_in_the_wheel() -> None:
    pygments = pytest.importorskip("pygments.lexers")
    text = "link crank A-B 100 mm // <b>\n"
    assert type(pygments.get_lexer_by_name("mech")).__module__.startswith("assur.")
    page = assur.Problem(text).text._repr_html_()
    assert "<span style" in page and "&lt;b&gt;" in page and assur.Problem(text).text == text


def test_import_is_light() -> None:
    """NumPy is imported where a column is looked at, not before."""
    code = "import assur, sys; sys.exit('numpy' in sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
