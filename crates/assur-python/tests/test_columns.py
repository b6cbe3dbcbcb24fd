"""Columns: no copies, units, positions from outside."""

from __future__ import annotations

import numpy as np
import pyarrow as pa
import pytest
from conftest import ROOT

import assur

WAY = np.linspace(0, 2 * np.pi, 500, endpoint=False)


@pytest.fixture(scope="module")
def problem(engine: str) -> assur.Problem:
    return assur.compile(engine)


@pytest.fixture(scope="module")
def solution(problem: assur.Problem) -> assur.Solution:
    return problem.solve(WAY)


def address(array: np.ndarray) -> int:
    return array.__array_interface__["data"][0]


def test_no_column_is_copied(solution: assur.Solution) -> None:
    pl = pytest.importorskip("polars")
    table, frame = pa.table(solution), pl.DataFrame(solution)
    batch = pa.record_batch(solution)
    for name in solution:
        own = address(solution[name])
        assert own == solution._columns.numbers(name).address
        assert own == address(solution[name])
        assert own == table[name].chunk(0).buffers()[1].address
        assert own == batch[name].buffers()[1].address
        assert own == address(frame[name].to_numpy())
        assert not solution[name].flags.writeable


def test_data_frames_of_pandas(solution: assur.Solution) -> None:
    pytest.importorskip("pandas")
    frame = solution.to_pandas()
    assert list(frame.columns) == solution.keys() and (frame["Mb"] == solution["Mb"]).all()


def test_a_view_keeps_its_memory(problem: assur.Problem) -> None:
    view = problem.solve(WAY)["Mb"]
    kept = view.copy()
    for _ in range(20):
        problem.solve(WAY)
    assert (view == kept).all()


def test_units_are_in_the_fields(solution: assur.Solution) -> None:
    assert solution.units["Mb"] == "N*m"
    assert solution.units["crank"] == "rad"
    schema = pa.schema(solution)
    assert schema.field("Mb").metadata == {b"unit": b"N*m"}
    written = solution.to(units="file")
    assert written.units["crank"] == "deg"
    assert np.allclose(written["crank"], np.degrees(solution["crank"]), rtol=1e-15)
    assert written.to("si")["crank"] is not None and written.to("si").units["crank"] == "rad"
    with pytest.raises(ValueError, match="file"):
        solution.to(units="imperial")


def test_vectors_are_two_columns(solution: assur.Solution) -> None:
    x, y = solution["reaction(A, crank)"]
    assert (x == solution["reaction(A, crank).x"]).all() and (y == solution["reaction(A, crank).y"]).all()
    with pytest.raises(KeyError, match="did you mean"):
        solution["Mb2"]


def test_positions_of_any_kind_of_array(problem: assur.Problem, solution: assur.Solution) -> None:
    strided = np.repeat(WAY, 2)[::2]
    frozen = WAY.copy()
    frozen.flags.writeable = False
    swapped = WAY.astype(WAY.dtype.newbyteorder())
    for way in [strided, frozen, swapped, list(WAY), {"crank": WAY}, tuple(WAY)]:
        assert (problem.solve(way)["Mb"] == solution["Mb"]).all()
    small = WAY.astype(np.float32)
    assert (problem.solve(small)["crank"] == small.astype(float)).all()
    assert (problem.solve(np.arange(4))["crank"] == np.arange(4)).all()
    assert (problem.solve(0.5)["crank"] == [0.5]).all()
    assert len(problem.solve([])) == 0 == len(problem.solve(np.array([])))


def test_positions_that_do_not_fit(problem: assur.Problem) -> None:
    wrong = {
        ValueError: [
            np.ones((2, 2)),
            np.array(1.0).reshape(1, 1, 1),
            np.array([0, np.nan]),
            [0.1, float("inf")],
            np.ma.array([1.0, 2.0], mask=[False, True]),
            {"crnk": [0.1]},
            {"crank": [0.1], "rod": [0.1]},
            [[0.1], [0.1, 0.2]],
        ],
        TypeError: ["abc", [True], np.array([1j]), object(), [None], {"crank": None}, [1, "x"], np.array(["1"])],
    }
    for exception, cases in wrong.items():
        for case in cases:
            with pytest.raises(exception, match="crank|crnk|rod|positions"):
                problem.solve(case)
    with pytest.raises(ValueError, match="did you mean `crank`"):
        problem.solve({"crnk": [0.1]})
    with pytest.raises(ValueError, match="position 1"):
        problem.solve(np.array([0, np.nan]))


def test_several_drives() -> None:
    problem = assur.load("examples/drives/excavator.mech")
    assert problem.drives == {"c1": "m", "c2": "m"}
    own = problem.solve()
    moved = problem.solve({"c1": np.linspace(2.2, 2.3, 5), "c2": 2.5})
    assert len(moved) == 5 and (moved["c2"] == 2.5).all()
    assert (problem.solve({"c1": [own["c1"][0]]})["c2"] == own["c2"]).all()
    for wrong, why in [([2.25], "2 drives"), ({"c1": [2.2, 2.3], "c2": [2.5] * 3}, "3 positions"), ({"c3": 1.0}, "c3")]:
        with pytest.raises(ValueError, match=why):
            problem.solve(wrong)


def test_points_as_positions() -> None:
    problem = assur.load("examples/drives/point-drive.mech")
    own = problem.solve()
    point = np.array([own["crank.A"]])[:, :, 0]
    again = problem.solve({"crank.A": point})
    for name in own:
        assert np.array_equal(own[name], again[name], equal_nan=True)
    with pytest.raises(ValueError, match=r"drive `crank.A` takes two numbers"):
        problem.solve({"crank.A": [1.0]})


def test_a_motion_has_instants_of_its_own() -> None:
    file = next(iter(sorted(ROOT.glob("examples/simulation/*.mech"))))
    problem = assur.load(file)
    assert len(problem.solve()) > 1
    with pytest.raises(ValueError, match="motion under loads"):
        problem.solve([0.1])


def test_positions_without_a_solution_are_null() -> None:
    problem = assur.compile(
        """
ground { A (0, 0); D (300 mm, 0) }
link a A-B 100 mm
link b B-C 120 mm
link c D-C 120 mm
revolute A: ground - a
revolute B: a - b
revolute C: b - c
revolute D: ground - c
drive a = 0 deg
assemble C left of B-D
find angle(c)
"""
    )
    solution = problem.solve([0.0, 3.0, 0.1])
    assert np.isnan(solution["angle(c)"]).tolist() == [False, True, False]
    (failure,) = solution.failures
    assert failure.position == 1 and failure.code and failure.message
    table = pa.table(solution)
    assert table["angle(c)"].null_count == 1
    assert table["error"][1].as_py() == failure.message and table["error"][0].as_py() is None
    assert np.isnan(solution.condition[1])


def test_values_from_outside(engine: str) -> None:
    long = assur.compile(engine, set={"r": "120 mm"}).solve()["Mb"]
    assert (assur.compile(engine).solve(set={"r": "0.12 m"})["Mb"] == long).all()
    with pytest.raises(assur.UnitError):
        assur.compile(engine, set={"r": "3 N"})
    with pytest.raises(assur.UnitError):
        assur.compile(engine, set={"r": 3})
    with pytest.raises(assur.ProblemError) as of_the_text:
        assur.compile("link a A-B 10 kg\n")
    assert not isinstance(of_the_text.value, assur.UnitError)
    with pytest.raises(assur.ProblemError, match="no `given`"):
        assur.compile(engine, set={"rr": "3 mm"})
    with pytest.raises(TypeError, match="`r`"):
        assur.compile(engine, set={"r": None})
    with pytest.raises(ValueError, match="within"):
        assur.compile(engine, within=float("nan"))
    assert assur.compile(engine).solve(within=1e-9)["Mb"] == pytest.approx(assur.compile(engine).solve()["Mb"])


def test_the_same_for_any_number_of_threads(problem: assur.Problem) -> None:
    way = np.linspace(0, 20, 20_000)
    one, four = problem.solve(way, threads=1), problem.solve(way, threads=4)
    for name in one:
        assert one[name].tobytes() == four[name].tobytes()
    with pytest.raises(ValueError, match="threads"):
        problem.solve(way, threads=0)


def test_a_text_with_lone_surrogates_is_refused() -> None:
    for call in (assur.compile, assur.format, assur.explain):
        with pytest.raises(UnicodeEncodeError):
            call("link \ud800")


def test_in_notebooks(problem: assur.Problem, solution: assur.Solution) -> None:
    assert "&lt;script&gt;" in assur.Problem("link <script>", name="a.mech")._repr_html_()
    page = solution._repr_html_()
    assert page.startswith("<table>") and "20 of 500 positions" in page and "Mb [N*m]" in page
    assert problem._repr_html_().startswith("<iframe sandbox")
    assert problem.draw().startswith("<svg") and problem.draw(kind="animation").is_page
    assert problem.draw(pose=1) == problem.draw(pose="1") == problem.draw()
    with pytest.raises(ValueError, match="did you mean `scheme`"):
        problem.draw(kind="schem")
    with pytest.raises(assur.ProblemError):
        problem.draw(pose=7)
    with pytest.raises(assur.ProblemError) as raised:
        assur.compile("link <b>")
    assert "<b>" not in raised.value._repr_html_()
