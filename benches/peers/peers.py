"""KinePy, pylinkage and assur side by side, on one thread: microseconds per position and worst relative errors.

    python3 benches/peers/peers.py

Makes a virtual environment under target/peers, installs the versions of requirements.txt from PyPI, builds assur, and runs
all of them turn by turn; the least time of all turns counts. Errors are those against assur's answers, which stand against
an independent solution and a double-double one in the tests; relative to the greatest value of the kind over the turn.
"""
import json
import os
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PLACE = ROOT / "target" / "peers"
CASES = ("crank-slider", "four-bar", "six-bar")
COUNT = 360
TURNS = 5
ASKS = {"positions": "position(A)", "velocities": "omega(crank), velocity({})", "accelerations": "acceleration({})",
        "reactions, torque": "Mb, reactions"}
POINT = {"crank-slider": "C", "four-bar": "C", "six-bar": "F"}


def in_environment():
    """Runs this script again with the interpreter that has the peers."""
    python = PLACE / "bin" / "python"
    if not python.exists():
        venv.create(PLACE, with_pip=True)
    subprocess.run([python, "-m", "pip", "install", "-q", "-r", HERE / "requirements.txt"], check=True)
    one = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")}
    os.execve(python, [str(python), __file__, "--here"], {**os.environ, **one})


def built():
    """The paths of `assur` and of the program that measures files."""
    command = ["cargo", "build", "--release", "--features", "lanes", "--bin", "assur", "--bench", "position", "--message-format", "json"]
    out = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    made = [m for m in map(json.loads, out.splitlines()) if m.get("executable")]
    return [next(m["executable"] for m in made if m["target"]["name"] == name) for name in ("assur", "position")]


def least(run, repeats):
    best = float("inf")
    for _ in range(repeats):
        start = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - start)
    return best


class Case:
    def __init__(self, name, assur):
        self.name = name
        path = HERE / f"{name}.mech"
        self.text = path.read_text()
        out = subprocess.run([assur, "solve", path, "--format", "json"], check=True, capture_output=True, text=True).stdout
        self.poses = json.loads(out)["poses"]
        self.times = {}

    def keep(self, what, value):
        self.times[what] = min(value, self.times.get(what, float("inf")))

    def points(self, point, what="position"):
        return [p["points"][point][what] for p in self.poses]

    def measure_assur(self, program):
        machine = self.text.split("\nfind ")[0]
        with tempfile.TemporaryDirectory() as folder:
            for what, find in ASKS.items():
                path = Path(folder) / "scene.mech"
                path.write_text(f"{machine}\nfind {find.format(POINT[self.name])}\n")
                out = json.loads(subprocess.run([program, path], check=True, capture_output=True, text=True).stdout)
                self.keep(("assur", what), out["us"])
                self.keep(("assur, eight together", what), out["us_together"])
                self.keep(("assur, lanes", what), out["us_in_lanes"])

    def measure_kinepy(self, machine):
        for count, repeats in ((COUNT, 20), (10 * COUNT, 5), (100 * COUNT, 2)):
            self.keep(("KinePy", "positions"), 1e6 * least(lambda: machine.positions(count), repeats) / count)
            self.keep(("KinePy", "reactions, torque"), 1e6 * least(lambda: machine.dynamics(count), repeats) / count)

    def measure_pylinkage(self, machine):
        for count, repeats in ((COUNT, 50), (100 * COUNT, 5)):
            self.keep(("pylinkage", "positions"), 1e6 * least(lambda: machine.positions(count), repeats) / count)
            self.keep(("pylinkage", "accelerations"), 1e6 * least(lambda: machine.kinematics(count), repeats) / count)

    def errors_of_kinepy(self, machine):
        machine.dynamics(COUNT)
        places = max(relative(machine.place(point), self.points(point)) for point in machine.places)
        worst = 0.0
        for pair in machine.pins:
            want = [p["reactions"][pair][0]["force"] for p in self.poses]
            got = machine.reactions(pair)
            # which of the two links the force is counted on is each program's own
            worst = max(worst, min(relative(got, want), relative(-got, want)))
        want, got = [[p["balances"]["Mb"]] for p in self.poses], machine.torque()[:, None]
        return places, max(worst, min(relative(got, want), relative(-got, want)))

    def errors_of_pylinkage(self, fresh):
        machine = fresh()
        got = machine.kinematics(COUNT)
        errors = []
        for values, what in zip(got, ("position", "velocity", "acceleration")):
            rows = [(values[:, machine.index(p)], self.points(p, what)) for p in machine.points]
            errors.append(max(relative(g, want[1:] + want[:1]) for g, want in rows))
        return errors[0], max(errors)


def relative(got, want):
    import numpy

    want = numpy.array(want)
    return float(numpy.abs(got - want).max() / numpy.abs(want).max())


def main():
    import with_kinepy
    import with_pylinkage

    assur, program = built()
    cases = [Case(name, assur) for name in CASES]
    peers = [(with_kinepy.Machine(c.name), with_pylinkage.Machine(c.name)) for c in cases]
    errors = []
    for case, (kinepy, _) in zip(cases, peers):
        kinepy.assemble({point: case.points(point) for point in kinepy.places})
        errors.append((case.errors_of_kinepy(kinepy), case.errors_of_pylinkage(lambda: with_pylinkage.Machine(case.name))))
    for _ in range(TURNS):
        for case, (kinepy, pylinkage) in zip(cases, peers):
            case.measure_assur(program)
            case.measure_kinepy(kinepy)
            case.measure_pylinkage(pylinkage)
    print(f"Microseconds per position: {' / '.join(CASES)}.\n")
    print("| program | what | µs | times assur's | worst relative error |\n| --- | --- | --- | --- | --- |")
    rows = [(who, what) for who in ("assur", "assur, eight together", "assur, lanes") for what in ASKS]
    rows += [("KinePy", "positions"), ("KinePy", "reactions, torque"), ("pylinkage", "positions"), ("pylinkage", "accelerations")]
    for who, what in rows:
        times = [c.times[(who, what)] for c in cases]
        ratio = error = ""
        if not who.startswith("assur"):
            ratio = " / ".join(f"{t / c.times[('assur', what)]:.3g}" for t, c in zip(times, cases))
            which, level = int(who == "pylinkage"), int(what != "positions")
            error = " / ".join(f"{e[which][level]:.0e}" for e in errors)
        print(f"| {who} | {what} | {' / '.join(f'{t:.3g}' for t in times)} | {ratio} | {error} |")


if __name__ == "__main__":
    main() if "--here" in sys.argv else in_environment()
