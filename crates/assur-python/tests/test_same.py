"""Python says what the program says, bit for bit."""

from __future__ import annotations

import csv
import io
import math
import re

import pytest
from conftest import ROOT, documents, files, program

import assur

EXAMPLES = files("examples")
ERRORS = files("tests/errors")


@pytest.fixture(scope="module")
def solved() -> dict[str, list[dict]]:
    return documents(EXAMPLES)


@pytest.fixture(scope="module")
def wrong() -> dict[str, list[dict]]:
    return documents(ERRORS)


def same(found: float, printed: float | bool | None) -> bool:
    """A number as in JSON; what does not exist is left out there, and NaN here."""
    return math.isnan(found) if printed is None else found == float(printed)


def cells(document: dict, pose: dict) -> dict[str, float]:
    """What JSON says about a pose, by the names of columns."""
    found: dict[str, float] = {}
    for name, value in {**document.get("cycle", {}), **pose["drives"], **pose.get("quantities", {})}.items():
        parts = dict(zip((f"{name}.x", f"{name}.y"), value)) if isinstance(value, list) else {name: value}
        found.update(parts)
    for name, value in pose.get("balances", {}).items():
        found.setdefault(name, value)
    for pair, entries in pose.get("reactions", {}).items():
        for entry in entries:
            x, y = entry.get("force", (None, None))
            found[f"reaction({pair}, {entry['on']}).x"] = x
            found[f"reaction({pair}, {entry['on']}).y"] = y
            found[f"moment({pair}, {entry['on']})"] = entry.get("moment")
    return found


@pytest.mark.parametrize("file", EXAMPLES)
def test_every_example_is_the_programs_json(file: str, solved: dict[str, list[dict]]) -> None:
    printed = solved[file]
    if "variant" in printed[0]:
        pytest.skip("its rows are compared in `test_rows_of_a_file`")
    (document,) = printed
    solution = assur.load(file).solve()
    poses = document["poses"]
    assert solution.poses[: len(poses)] == ([pose["name"] for pose in poses] or [""][: len(poses)])
    assert list(solution.diagnostics) == document["diagnostics"]
    compared = 0
    for i, pose in enumerate(poses):
        known = cells(document, pose)
        assert all(name in solution for name in pose.get("quantities", {}))
        for name in solution:
            if name in known:
                assert same(solution[name][i], known[name]), (name, pose["name"])
                compared += 1
        assert same(solution.condition[i], pose.get("condition"))
        for kind, printed_residual in pose.get("residuals", {}).items():
            assert same(solution.residuals[kind][i], printed_residual)
    if not poses:
        known = document.get("cycle", {})
        for name in solution:
            if name in known:
                assert same(solution[name][0], known[name])
    assert compared or not poses
    assert [met for *_, met in solution.expectations] == [e["passed"] for e in document["expectations"]]


@pytest.mark.parametrize("file", ERRORS)
def test_every_wrong_file_has_the_same_diagnostics(file: str, wrong: dict[str, list[dict]]) -> None:
    (document, *rows) = wrong[file]
    if rows or "variant" in document:
        # what a course refuses may solve
        found = [d["code"] for d in assur.Problem((ROOT / file).read_text(), file).test()]
        assert found or file.startswith("tests/errors/course/")
        return
    if "poses" in document:
        assert list(assur.load(file).solve().diagnostics) == document["diagnostics"]
        return
    with pytest.raises(assur.ProblemError) as raised:
        assur.load(file).solve()
    assert list(raised.value.diagnostics) == document["diagnostics"]
    assert document["diagnostics"][0]["message"].split()[0] in str(raised.value)


def test_errors_look_as_in_the_terminal() -> None:
    file = "tests/errors/name/unknown/" + next(iter((ROOT / "tests/errors/name/unknown").glob("*.mech"))).name
    with pytest.raises(assur.ProblemError) as raised:
        assur.load(file)
    assert str(raised.value).strip() in program("check", file).stderr


def own_table(text: str) -> dict[str, list] | None:
    """The table of variants in a file, as columns."""
    found = re.search(r"^variants \{\n(.*?)^\}", text, re.MULTILINE | re.DOTALL)
    if not found:
        return None
    lines = [line.split("//")[0].strip() for line in found[1].splitlines()]
    head, *rows = csv.reader((line for line in lines if line), skipinitialspace=True)
    columns = {name.strip(): [row[i].strip() for row in rows] for i, name in enumerate(head)}
    return {name: cells if name == "variant" else [float(x) for x in cells] for name, cells in columns.items()}


TABLES = [file for file in EXAMPLES if own_table((ROOT / file).read_text(encoding="utf-8"))]


@pytest.mark.parametrize("file", TABLES)
def test_rows_of_a_file(file: str) -> None:
    """The rows of a file's own table as a table of arrays: the lines of `assur batch`, to all its 15 digits."""
    head, *lines = csv.reader(io.StringIO(program("batch", file, "--format", "csv").stdout))
    answers = assur.load(file).batch(own_table((ROOT / file).read_text(encoding="utf-8"))).read()
    units = answers.units
    heads = [f"{name} [{units[name]}]" if name in units else name for name in answers]
    assert heads == head
    assert len(answers) == len(lines)
    for i, name in enumerate(answers):
        for found, row in zip(answers[name], lines):
            assert is_printed(found, row[i]), (name, row)


def is_printed(found: object, cell: str) -> bool:
    """Whether a cell of an answer is that of CSV; numbers to 15 digits."""
    if found is None or isinstance(found, (str, bool)):
        return {None: "", True: "true", False: "false"}.get(found, found) == cell
    return cell == "" if math.isnan(found) else float(f"{found:.15g}") == float(cell)


def test_the_program_is_the_module() -> None:
    import subprocess
    import sys
    from pathlib import Path

    script = Path(sys.executable).with_name("assur")
    ran = subprocess.run([script, "explain", "mech::name::unknown"], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == assur.explain("mech::name::unknown").strip()
    assert program("check", "nothing.mech").returncode == 2
    assert program("test", "examples/crank-slider.mech").returncode == 0


def test_format_and_explain() -> None:
    assert assur.format("mech 1\n\n\nground {A (0,0)}\n") == "mech 1\n\nground { A (0, 0) }\n"
    with pytest.raises(assur.ProblemError):
        assur.format("grund { A")
    with pytest.raises(KeyError, match="mech::name::unknown"):
        assur.explain("name::unknwn")
