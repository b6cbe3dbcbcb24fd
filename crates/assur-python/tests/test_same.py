"""Python says what the program says, bit for bit."""

from __future__ import annotations

import csv
import io
import math

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
        assert [d["code"] for d in assur.Problem((ROOT / file).read_text(), file).test()]
        return
    text = (ROOT / file).read_text(encoding="utf-8")
    if "poses" in document:
        assert list(assur.load(file).solve().diagnostics) == document["diagnostics"]
        return
    if "variants" in text and "structure" in document:
        pytest.skip("its table is wrong, and not what is solved without one")
    with pytest.raises(assur.ProblemError) as raised:
        assur.load(file).solve()
    assert list(raised.value.diagnostics) == document["diagnostics"]
    assert document["diagnostics"][0]["message"].split()[0] in str(raised.value)


def test_errors_look_as_in_the_terminal() -> None:
    file = "tests/errors/name/unknown/" + next(iter((ROOT / "tests/errors/name/unknown").glob("*.mech"))).name
    with pytest.raises(assur.ProblemError) as raised:
        assur.load(file)
    assert str(raised.value).strip() in program("check", file).stderr


@pytest.mark.parametrize("file", [f for f in EXAMPLES if "exercise-set" in f or "variants" in f])
def test_rows_of_a_file(file: str, tmp_path) -> None:
    """The rows of a file's own table as a table of arrays: the lines of `assur batch`, to all its 15 digits."""
    printed = program("batch", file, "--format", "csv").stdout
    head, *lines = csv.reader(io.StringIO(printed))
    text = (ROOT / file).read_text(encoding="utf-8")
    if "variants" not in text.replace("--variants", ""):
        pytest.skip("no table")
    problem = assur.load(file)
    givens = head[1 : head.index("pose")]
    table = {name: [row[head.index(name)] for row in lines] for name in givens}
    table = {name: cells if name == "variant" else [float(x) for x in cells] for name, cells in table.items()}
    firsts = [i for i, row in enumerate(lines) if i == 0 or row[0] != lines[i - 1][0]]
    table = {name: [cells[i] for i in firsts] for name, cells in table.items()}
    if not table:
        pytest.skip("its table has keys alone")
    try:
        answers = problem.batch(table).read()
    except assur.ProblemError as error:
        assert {d["code"] for d in error.diagnostics} <= {"mech::expect::key_column", "mech::request::key_column"}, error
        pytest.skip("its keys are columns that are not printed")
    assert len(answers) == len(lines)
    units = answers.units
    heads = [f"{name} [{units[name]}]" if name in units else name for name in answers]
    assert heads == head
    for name, title in zip(answers, heads):
        for found, row in zip(answers[name], lines):
            cell = row[head.index(title)]
            if isinstance(found, str) or found is None:
                assert (found or "") == cell
            elif cell in ("true", "false"):
                assert found == (cell == "true")
            elif cell:
                assert float(f"{found:.15g}") == float(cell), (name, row)
            else:
                assert math.isnan(found)


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
