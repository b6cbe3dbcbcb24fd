"""assur and its peers side by side, each on one thread: microseconds per position and worst relative errors, as the table of
docs/measured/effects.md.

    python3 benches/peers/peers.py [TURNS]

Makes a virtual environment under target/peers, installs the versions of requirements.txt from PyPI, builds assur, and runs all
of them turn by turn, TURNS times (5); the least time counts. A peer that cannot be installed has a row that says so. Errors are
differences from assur's answers, which the tests compare with independent solutions, relative to the greatest value of the kind
over the turn.
"""
import importlib
import json
import os
import re
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
MILLION = 1_000_000
POSITIONS, VELOCITIES, ACCELERATIONS, FORCES = "positions", "velocities", "accelerations", "reactions, torque"
ASKS = {POSITIONS: "position({})", VELOCITIES: "velocity({})", ACCELERATIONS: "acceleration({})", FORCES: "Mb, reactions"}
POINT = {"crank-slider": "C", "four-bar": "C", "six-bar": "F"}

FROM_ANGLE = "sine and cosine of the drive; answers stored in an array"
THREADS = [("", "", "1"), (", two threads", ", by the clock", "2")]
WHOLE = {
    "csv": "the whole program for a million positions, of the four-bar 14 numbers each: sines, following, closure, writing to /dev/null",
    "jsonl": "the same, of the four-bar 98 numbers each: motion of all links and points, reactions, residuals",
}
ROWS = [
    *(("assur, one by one", what, FROM_ANGLE) for what in ASKS),
    *(("assur, lanes", what, FROM_ANGLE) for what in ASKS),
    ("assur, lanes, from the text", FORCES, "the same for 36,000 positions, and once reading and compiling the text and following a turn with residuals"),
    *((f"`assur solve --format {form}`{on}", FORCES, WHOLE[form] + clock) for form in WHOLE for on, clock, _ in THREADS),
    ("plan alone, one by one", FORCES, "sine and cosine given, nothing stored"),
    ("plan alone, lanes", FORCES, "sine and cosine given, nothing stored"),
    ("by hand", FORCES, FROM_ANGLE),
    ("by hand, sine and cosine given", FORCES, "answers stored in an array"),
    ("by hand, lanes", FORCES, FROM_ANGLE),
    ("by hand, lanes, sine and cosine given", FORCES, "answers stored in an array"),
    ("KinePy", POSITIONS, "sines in numpy; arrays of places"),
    ("KinePy", FORCES, "sines, positions, accelerations by differences; arrays of forces in all pairs"),
    ("pylinkage", POSITIONS, "steps of the crank, sines; arrays of places; no forces"),
    ("pylinkage", ACCELERATIONS, "steps of the crank, sines, positions, velocities; arrays of all; no forces"),
    ("MuJoCo, Euler", FORCES, "a step in time, no angle given; forces in all pairs, torque"),
    ("MuJoCo, Runge–Kutta", FORCES, "a step in time, no angle given; forces in all pairs, torque"),
    ("Exudyn", FORCES, "a step in time, no angle given; forces in all hinges, torque"),
    ("Drake", FORCES, "sines, closure by Newton's method, velocities, accelerations, in Python; forces in the cut pins, torque"),
]
# who → module, what else its machines are made with
MOVING = {
    "MuJoCo, Euler": ("with_mujoco", ["Euler"]),
    "MuJoCo, Runge–Kutta": ("with_mujoco", ["RK4"]),
    "Exudyn": ("with_exudyn", []),
    "Drake": ("with_drake", []),
}


def in_environment():
    """Runs this script again with the interpreter that has the peers."""
    python = PLACE / "bin" / "python"
    if not python.exists():
        venv.create(PLACE, with_pip=True)
    for line in (HERE / "requirements.txt").read_text().split():
        subprocess.run([python, "-m", "pip", "install", "-q", line])
    threads = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
    os.execve(python, [str(python), __file__, "--here", *sys.argv[1:]], {**os.environ, **dict.fromkeys(threads, "1")})


def built():
    """The paths of `assur` and of the program that measures files."""
    made = []
    # the loops by hand are compiled as benches are, not as the program
    for what in (["build", "--release", "--bin", "assur"], ["bench", "--no-run", "--bench", "position"]):
        command = ["cargo", *what, "--message-format", "json"]
        out = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
        made += [m for m in map(json.loads, out.splitlines()) if m.get("executable")]
    return [next(m["executable"] for m in made if m["target"]["name"] == name) for name in ("assur", "position")]


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def least(run, repeats, ready=lambda: None):
    best = float("inf")
    for _ in range(repeats):
        ready()
        start = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - start)
    return best


def relative(got, want):
    import numpy

    want = numpy.array(want)
    return float(numpy.abs(got - want).max() / numpy.abs(want).max())


def either(got, want):
    """Which of the two links a force is counted on is each program's own."""
    return min(relative(got, want), relative(-got, want))


class Case:
    """A machine: its text, assur's answers, and of every row the least time and the error."""

    def __init__(self, name, assur):
        self.name = name
        path = HERE / f"{name}.mech"
        self.text = path.read_text()
        self.poses = json.loads(output(assur, "solve", path, "--format", "json"))["poses"]
        self.times, self.errors, self.peers = {}, {}, {}

    def keep(self, who, what, value):
        self.times[who, what] = min(value, self.times.get((who, what), float("inf")))

    def points(self, point, what="position"):
        return [p["points"][point][what] for p in self.poses]

    def force_error(self, forces, torque):
        found = [either(got, [p["reactions"][pair][0]["force"] for p in self.poses]) for pair, got in forces.items()]
        return max(*found, either(torque, [p["balances"]["Mb"] for p in self.poses]))

    def add_peers(self, modules):
        """Makes the peers' machines, and compares each once with assur."""
        if "with_kinepy" in modules:
            machine = self.peers["KinePy"] = modules["with_kinepy"].Machine(self.name)
            machine.assemble({point: self.points(point) for point in machine.places})
            machine.dynamics(COUNT)
            self.errors["KinePy", POSITIONS] = max(relative(machine.place(p), self.points(p)) for p in machine.places)
            forces = {pair: machine.reactions(pair) for pair in machine.pins}
            self.errors["KinePy", FORCES] = self.force_error(forces, machine.torque())
        if "with_pylinkage" in modules:
            new = modules["with_pylinkage"].Machine
            self.peers["pylinkage"], fresh = new(self.name), new(self.name)
            errors = []
            for values, what in zip(fresh.kinematics(COUNT), ("position", "velocity", "acceleration")):
                rows = [(values[:, fresh.index(p)], self.points(p, what)) for p in fresh.points]
                errors.append(max(relative(got, want[1:] + want[:1]) for got, want in rows))
            self.errors["pylinkage", POSITIONS], self.errors["pylinkage", ACCELERATIONS] = errors[0], max(errors)
        for who, (module, more) in MOVING.items():
            if module in modules:
                machine = self.peers[who] = modules[module].Machine(self.name, self.poses[0], *more)
                machine.ready()
                machine.turn()
                self.errors[who, FORCES] = self.force_error(*machine.answers())

    def measure_assur(self, assur, program):
        machine = self.text.split("\nfind ")[0]
        ways = ("one by one", "lanes")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.mech"
            for what, find in ASKS.items():
                path.write_text(f"{machine}\nfind {find.format(POINT[self.name])}\n")
                out = json.loads(output(program, path))
                for way, array, plan in zip(ways, out["array"], out["plan"]):
                    self.keep(f"assur, {way}", what, array)
                    self.keep(f"plan alone, {way}", what, plan)
                self.keep("assur, lanes, from the text", what, out["text"])
            path.write_text(self.text.replace(f"in {COUNT} steps", f"in {MILLION} steps"))
            for form in WHOLE:
                for on, _, threads in THREADS:
                    command = [assur, "solve", path, "--format", form, "--threads", threads]
                    run = lambda: subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
                    self.keep(f"`assur solve --format {form}`{on}", FORCES, 1e6 * least(run, 1) / MILLION)
        if self.name == "four-bar":
            out = json.loads(output(program, "--by-hand"))
            for way, array, plan in zip(("by hand", "by hand, lanes"), out["array"], out["plan"]):
                self.keep(way, FORCES, array)
                self.keep(f"{way}, sine and cosine given", FORCES, plan)

    def measure_peers(self):
        # arrays of these two may be of any length
        for who, what, call in (
            ("KinePy", POSITIONS, "positions"), ("KinePy", FORCES, "dynamics"),
            ("pylinkage", POSITIONS, "positions"), ("pylinkage", ACCELERATIONS, "kinematics"),
        ):
            if who in self.peers:
                run = getattr(self.peers[who], call)
                for count, repeats in ((COUNT, 20), (10 * COUNT, 5), (100 * COUNT, 2)):
                    self.keep(who, what, 1e6 * least(lambda: run(count), repeats) / count)
        for who in MOVING:
            if who in self.peers:
                machine = self.peers[who]
                self.keep(who, FORCES, 1e6 * least(machine.turn, 10, machine.ready) / COUNT)


def row(cases, who, what, includes):
    each = lambda of: " / ".join(of(c) if (who, what) in c.times else "–" for c in cases)
    if not any((who, what) in c.times for c in cases):
        return f"| {who} | {what} | not installed | | | | |"
    times = each(lambda c: f"{c.times[who, what]:.3g}")
    ratios = [each(lambda c: f"{c.times[who, what] / c.times[f'assur, {way}', what]:.3g}") for way in ("one by one", "lanes")]
    errors = each(lambda c: f"{c.errors[who, what]:.0e}") if (who, what) in cases[-1].errors else ""
    return f"| {who} | {what} | {includes} | {times} | {' | '.join(ratios)} | {errors} |"


def main(turns):
    modules = {}
    for name in ("with_kinepy", "with_pylinkage", "with_mujoco", "with_exudyn", "with_drake"):
        try:
            modules[name] = importlib.import_module(name)
        except ImportError as error:
            print(f"{name}: {error}", file=sys.stderr)
    assur, program = built()
    cases = [Case(name, assur) for name in CASES]
    for case in cases:
        case.add_peers(modules)
    for _ in range(turns):
        for case in cases:
            case.measure_assur(assur, program)
            case.measure_peers()
    processor = re.search("model name.*: (.*)", Path("/proc/cpuinfo").read_text())
    machine = f" {processor[1]}, one thread;" if processor else ""
    print(f"Microseconds per position, {' / '.join(CASES)};{machine} the least of {turns} turns:\n")
    print("| program | what | includes | µs | times assur, one by one | times assur, lanes | worst relative error |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for one in ROWS:
        print(row(cases, *one))


if __name__ == "__main__":
    args = [a for a in sys.argv[1:] if a != "--here"]
    main(int(args[0]) if args else 5) if "--here" in sys.argv else in_environment()
