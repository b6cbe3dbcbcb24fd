"""The Python package against the library and against the program, in one run: seconds of the processor, which other work on the machine
changes little.

    python3 benches/columns.py [WHEEL]

A million positions as columns, against `benches/columns.rs`; a million rows as a stream of Arrow, against the same rows as
comma-separated values through the program of the wheel; the same on two threads, by the clock. Makes a virtual environment under
target/columns.
"""
import itertools
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PLACE = ROOT / "target" / "columns"
COUNT = int(os.environ.get("COUNT", "1000000"))
PART = 50_000
TURNS = 3
VARIANTS = ROOT / "examples/variants/crank-slider.mech"


def in_environment(wheel):
    python = PLACE / "bin" / "python"
    if not python.exists():
        venv.create(PLACE, with_pip=True)
    subprocess.run([python, "-m", "pip", "install", "-q", "numpy", "pyarrow"], check=True)
    subprocess.run([python, "-m", "pip", "install", "-q", "--force-reinstall", "--no-deps", wheel], check=True)
    os.execv(python, [str(python), __file__, "--here"])


def newest_wheel():
    found = [path for folder in ("artefacts", "python/wheels") for path in (ROOT / "target" / folder).glob("assur-*.whl")]
    if not found:
        sys.exit("no wheel is built: dist/build.sh, or name one")
    return max(found, key=lambda path: path.stat().st_mtime)


def bench():
    command = ["cargo", "bench", "--quiet", "--bench", "columns", "--no-run", "--message-format", "json"]
    out = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    messages = map(json.loads, out.splitlines())
    return next(m["executable"] for m in messages if m.get("executable") and m["target"]["name"] == "columns")


def least(run, clock=time.process_time):
    best = float("inf")
    for _ in range(TURNS):
        start = clock()
        run()
        best = min(best, clock() - start)
    return best


def children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    import numpy

    import assur

    library = float(subprocess.check_output([bench()]))
    turn = numpy.arange(1_000_000) * (2 * numpy.pi / 1_000_000)
    problem = assur.load(ROOT / "examples/crank-slider.mech")
    package = least(lambda: problem.solve(turn, threads=1))
    print(f"a million positions: {package:.2f} s, {package / library:.2f} times the library alone")

    of_arrow, columns = least(lambda: stream(1)), rows(0, COUNT)
    with tempfile.TemporaryDirectory() as folder:
        table, out = Path(folder, "rows.csv"), Path(folder, "out.csv")
        numpy.savetxt(table, numpy.column_stack(list(columns.values())), fmt="%.10g", delimiter=",", header=",".join(columns), comments="")
        command = [sys.executable, "-m", "assur", "batch", VARIANTS, "--variants", table, "--threads", "1", "--out", out]
        of_csv = least(lambda: subprocess.run(command, check=True, stderr=subprocess.DEVNULL), children)
    print(f"{COUNT} rows: {of_arrow:.2f} s as Arrow, {of_csv:.2f} s as comma-separated values: {of_csv / of_arrow:.2f} times as long")
    subprocess.run([sys.executable, __file__, "--rows"], check=True)


def rows_alone():
    """In a process of its own, whose memory counts."""
    one, two = (least(lambda: stream(threads), time.perf_counter) for threads in (1, 2))
    print(f"two threads: {one / two:.2f} times as fast as one, by the clock of a machine with a load of {os.getloadavg()[0]:.1f}")
    # that of getrusage may be of the process that started this one
    greatest = next(line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM"))
    print(f"greatest memory: {int(greatest.split()[1]) >> 10} MiB")


def rows(first, count):
    """Some of the rows, as columns."""
    import numpy

    i = numpy.arange(first, first + count)
    return {
        "r [mm]": 80.0 + i % 40, "l [mm]": 300.0 + i % 77, "n [rpm]": 500.0 + i % 1500, "phi [deg]": i * 37 % 36000 / 100, "P [N]": i % 2000 * 1.0,
    }


def stream(threads):
    """Solves all rows, of which only some are in memory at a time."""
    import pyarrow

    import assur

    given = (pyarrow.record_batch(rows(at, min(PART, COUNT - at))) for at in range(0, COUNT, PART))
    first = next(given)
    given = pyarrow.RecordBatchReader.from_batches(first.schema, itertools.chain([first], given))
    answers = assur.load(VARIANTS).batch(given, threads=threads)
    assert sum(len(part) for part in pyarrow.RecordBatchReader.from_stream(answers)) == COUNT


if __name__ == "__main__":
    if "--here" in sys.argv:
        main()
    elif "--rows" in sys.argv:
        rows_alone()
    else:
        in_environment(sys.argv[1] if len(sys.argv) > 1 else str(newest_wheel()))
