"""Rows of variants: tables in, tables out."""

from __future__ import annotations

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pyarrow as pa
import pytest

import assur

COUNT = 3000


@pytest.fixture(scope="module")
def problem(engine: str) -> assur.Problem:
    return assur.compile(engine)


@pytest.fixture(scope="module")
def rows() -> dict[str, np.ndarray]:
    i = np.arange(COUNT)
    return {"r [mm]": 80.0 + i % 40, "l [mm]": 300.0 + i % 77, "n [rpm]": 500.0 + i % 1500, "phi [deg]": i * 0.37 % 360}


def lines(table: object) -> list[dict]:
    return pa.table(table).to_pylist()


def test_tables_of_any_kind(problem: assur.Problem, rows: dict[str, np.ndarray]) -> None:
    pl = pytest.importorskip("polars")
    wanted = lines(problem.batch(rows))
    table = pa.table(rows)
    fields = [pa.field(name.split(" ")[0], pa.float64(), metadata={"unit": name.split("[")[1][:-1]}) for name in rows]
    with_units = pa.table(list(rows.values()), schema=pa.schema(fields))
    declared = {name.split(" ")[0]: cells for name, cells in rows.items()}
    for same in [
        table,
        with_units,
        declared,
        pl.DataFrame(rows),
        table.to_batches()[0],
        pa.RecordBatchReader.from_batches(table.schema, table.to_batches(max_chunksize=100)),
        {name: cells.tolist() for name, cells in rows.items()},
        {name: cells.astype(np.float32 if name != "phi [deg]" else float) for name, cells in rows.items()},
    ]:
        assert lines(problem.batch(same)) == wanted
    in_metres = {"r [m]": rows["r [mm]"] / 1000, **{k: v for k, v in rows.items() if k != "r [mm]"}}
    answers, other = problem.batch(rows).read(), problem.batch(in_metres).read()
    assert np.allclose(answers["Mb"], other["Mb"], rtol=1e-12)


def test_the_same_for_any_number_of_threads(problem: assur.Problem, rows: dict[str, np.ndarray]) -> None:
    one, three = (problem.batch(rows, threads=threads).read() for threads in (1, 3))
    for name in one:
        assert np.asarray(one[name]).tolist() == np.asarray(three[name]).tolist()
    with pytest.raises(ValueError, match="threads"):
        problem.batch(rows, threads=-1)


def test_a_large_batch_keeps_its_order(problem: assur.Problem) -> None:
    """It is solved part by part: 65,536 rows at a time."""
    lengths = 80 + np.arange(150_000) % 40 + 0.25
    found = problem.batch({"r [mm]": lengths}).read()
    assert (np.array(found["row"]) == 1 + np.arange(150_000)).all()
    assert (found["r"] == lengths).all()


def test_small_batches_are_gathered(problem: assur.Problem) -> None:
    """They are solved 8,192 rows at a time or more, 65,536 at the most, in their order."""
    sizes = [1, 0, 7, 8_183, 1, 9_000, 100, 70_000, 3]
    lengths = 80 + np.arange(sum(sizes)) % 40 + 0.25
    whole = pa.record_batch({"r [mm]": lengths})
    ends = np.cumsum(sizes)
    batches = [whole.slice(end - size, size) for end, size in zip(ends, sizes)]
    parts = list(problem.batch(pa.RecordBatchReader.from_batches(whole.schema, batches)))
    assert [len(part) for part in parts] == [8_192, 9_000, 65_536, 4_567]
    answers = pa.concat_tables(pa.table(part) for part in parts)
    assert (answers["r"].to_numpy() == lengths).all()
    assert answers.equals(pa.table(problem.batch(whole)).combine_chunks())


def test_what_was_read_before_an_error_is_solved(problem: assur.Problem) -> None:
    batch = pa.record_batch({"r [mm]": [100.0, 90.0]})

    def broken():
        yield batch
        yield batch
        raise OSError("the disk is gone")

    parts = iter(problem.batch(pa.RecordBatchReader.from_batches(batch.schema, broken())))
    assert [line["row"] for line in lines(next(parts))] == [1, 2, 3, 4]
    with pytest.raises(ValueError, match="the disk is gone"):
        next(parts)




def test_a_row_is_the_file_with_its_values(problem: assur.Problem, engine: str, rows: dict) -> None:
    answers = problem.batch(rows).read()
    assert answers["row"] == list(range(1, COUNT + 1))
    for i in (0, 17, COUNT - 1):
        given = {name.split(" ")[0]: f"{cells[i]} {name.split('[')[1][:-1]}" for name, cells in rows.items()}
        alone = assur.compile(engine, set=given).solve().to(units="file")
        for name in alone:
            assert alone[name][0] == answers[name][i]


def test_a_broken_row_is_a_null_with_its_reason(problem: assur.Problem) -> None:
    answers = problem.batch({"r [mm]": [100.0, 400.0, np.nan, np.inf, -1.0], "phi [deg]": [45.0, 90.0, 45.0, 45.0, 45.0]})
    found = lines(answers)
    assert [line["Mb"] is None for line in found] == [False, True, True, True, True]
    assert [bool(line["error"]) for line in found] == [False, True, True, True, True]
    assert "`r` is missing" in found[2]["error"] and "`r`" in found[3]["error"]


def test_columns_that_do_not_fit(problem: assur.Problem) -> None:
    with pytest.raises(assur.ProblemError, match="`rr`"):
        problem.batch({"rr": [1.0]})
    with pytest.raises(assur.UnitError, match="column `r`"):
        problem.batch({"r [N]": [1.0]})
    with pytest.raises(assur.ProblemError):
        problem.batch({"r [furlong]": [1.0]})
    with pytest.raises(ValueError, match="column `l` has 1 rows, but `r` has 2"):
        problem.batch({"r": [1.0, 2.0], "l": [1.0]})
    with pytest.raises(ValueError, match="no columns"):
        problem.batch({})
    with pytest.raises(TypeError, match="column `r`"):
        problem.batch({"r": [1j]})
    with pytest.raises(TypeError, match="column `r`"):
        problem.batch({"r": "abc"})
    with pytest.raises(TypeError, match="3 is called|called 3"):
        problem.batch({3: [1.0]})
    with pytest.raises(TypeError, match="mapping of arrays"):
        problem.batch(7)
    with pytest.raises((ValueError, TypeError), match="column `r`"):
        problem.batch(pa.table({"r": [[1.0], [2.0]]}))
    with pytest.raises(assur.ProblemError):
        problem.batch({"a\nb": [1.0], 'q"': [2.0]})
    with pytest.raises(UnicodeEncodeError):
        problem.batch({"\ud800": [1.0]})
    with pytest.raises(assur.ProblemError):
        problem.batch({f"x{i}": [1.0] for i in range(1000)})
    assert len(problem.batch({"r": []}).read()) == 0
    assert len(problem.batch(pa.table({"r": pa.array([], pa.float64())})).read()) == 0
    assert lines(problem.batch(pa.table({"r": pa.nulls(2)})))[0]["error"]


class Lying:
    """An object whose schema belongs to another array."""

    def __init__(self, schema: object, array: object) -> None:
        self.schema, self.array = schema, array

    def __arrow_c_array__(self, requested_schema: object = None) -> tuple[object, object]:
        return self.schema.__arrow_c_schema__(), self.array.__arrow_c_array__()[1]


def test_objects_that_lie(problem: assur.Problem) -> None:
    number = pa.record_batch({"r": [1.0, 2.0]})
    with pytest.raises((ValueError, TypeError)):
        problem.batch(Lying(pa.schema([("r", pa.float64()), ("l", pa.float64())]), number))
    with pytest.raises((ValueError, TypeError)):
        problem.batch(Lying(pa.schema([("r", pa.string())]), number))
    with pytest.raises((ValueError, TypeError)):
        problem.batch(pa.array([1.0]))

    class Empty:
        __arrow_c_stream__ = None

    with pytest.raises((ValueError, TypeError)):
        problem.batch(Empty())


def test_answer_keys(problem: assur.Problem, rows: dict) -> None:
    key = problem.batch({**rows, "variant": [f"v{i}" for i in range(COUNT)]}, key=True).read()
    assert list(key)[:3] == ["row", "variant", "pose"] and "error" not in key.keys() and "r" not in key.keys()
    graded = assur.grade(key, key, within=0.01)
    assert graded["right"] == graded["total"] > COUNT
    assert key["variant"][5] == "v5"


def test_a_stream_is_read_once(problem: assur.Problem, rows: dict) -> None:
    stream = problem.batch(rows)
    parts = list(stream)
    assert sum(map(len, parts)) == COUNT and list(stream) == []
    other = problem.batch(rows)
    pa.table(other)
    with pytest.raises(ValueError, match="read already"):
        other.read()


def test_solvers_are_sent_as_text(engine: str, rows: dict) -> None:
    solver = assur.Solver(engine)
    table = pa.table(rows)
    whole = solver(table)
    assert isinstance(whole, pa.Table) and "row" not in whole.column_names
    sent = pickle.loads(pickle.dumps(solver))
    parts = [sent(table.slice(at, 700)) for at in range(0, COUNT, 700)]
    assert pa.concat_tables(parts).combine_chunks().equals(whole.combine_chunks())
    assert len(pickle.dumps(solver)) < len(engine) + 500
    assert pickle.loads(pickle.dumps(assur.compile(engine))).solve()["Mb"] == assur.compile(engine).solve()["Mb"]


def test_processes(engine: str, rows: dict) -> None:
    joblib = pytest.importorskip("joblib")
    table = pa.table(rows)
    whole = assur.Solver(engine)(table).combine_chunks()
    solver = joblib.delayed(assur.Solver(engine))
    parts = joblib.Parallel(n_jobs=2)(solver(table.slice(at, 1500)) for at in (0, 1500))
    assert pa.concat_tables(parts).combine_chunks().equals(whole)


def test_dask(engine: str, rows: dict) -> None:
    dask = pytest.importorskip("dask")
    table, solver = pa.table(rows), assur.Solver(engine)
    parts = [dask.delayed(solver)(table.slice(at, 1500)) for at in (0, 1500)]
    found = dask.compute(*parts, scheduler="processes", num_workers=2)
    assert pa.concat_tables(found).combine_chunks().equals(solver(table).combine_chunks())


def test_forked_workers(engine: str, rows: dict) -> None:
    import multiprocessing

    # the threads of this process are running
    wanted = assur.compile(engine).batch(rows).read()["Mb"]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        for found in pool.map(forked, [(engine, rows)] * 2):
            assert (found == wanted).all()


def forked(args: tuple[str, dict]) -> np.ndarray:
    text, rows = args
    return np.array(assur.compile(text).batch(rows).read()["Mb"])


def test_the_gil_is_released(problem: assur.Problem, rows: dict) -> None:
    """A thread of Python counts while another solves: without the GIL, it would wait."""
    import threading

    counted, done = [0], threading.Event()

    def count() -> None:
        while not done.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    way = np.linspace(0, 200, 100_000)
    before = counted[0]
    problem.solve(way, threads=1)
    during = counted[0] - before
    done.set()
    thread.join()
    assert during > 100
    with ThreadPoolExecutor(2) as pool:
        one, two = pool.map(lambda _: problem.batch(rows).read()["Mb"], range(2))
    assert (one == two).all()


def test_an_interrupt_ends_it(engine: str) -> None:
    import os
    import signal
    import subprocess
    import sys
    import time

    code = (
        "import assur, numpy, signal, sys\n"
        # where a shell has started this in the background the signal is ignored
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "problem = assur.compile(sys.stdin.read())\n"
        "print('begun', flush=True)\n"
        "try:\n"
        "    for _ in range(1000): problem.batch({'r': numpy.full(100_000, 100.0)}).read()\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted', flush=True)\n"
    )
    child = subprocess.Popen([sys.executable, "-c", code], stdin=-1, stdout=-1, text=True)
    child.stdin.write(engine)
    child.stdin.close()
    assert child.stdout.readline() == "begun\n"
    time.sleep(0.5)
    os.kill(child.pid, signal.SIGINT)
    assert child.stdout.read() == "interrupted\n"
    assert child.wait(timeout=30) == 0
