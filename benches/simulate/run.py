"""Motions under loads in assur and in its peers, side by side, each on one thread: the table of docs/measured/simulation.md.

    python3 benches/simulate/run.py [--write] [REPEATS]

Makes a virtual environment under target/simulate-peers, installs the versions of requirements.txt from PyPI, builds assur (or
takes the program that ASSUR names), takes R with deSolve (Debian: r-cran-desolve) where the system has it, and runs Andrews' mechanism and chains of 1, 2, 10 and 40 four-bars in all of them. Of
REPEATS (5) runs the least time on the processor counts. For every peer several tolerances or steps are tried; the fastest that keeps an error
is shown. Errors are against the references of scenes.py, never a tool's own. `--write` puts the table into docs/measured/simulation.md.
"""
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PLACE = ROOT / "target" / "simulate-peers"
PYTHON = PLACE / "bin" / "python"
PAGE = ROOT / "docs" / "measured" / "simulation.md"
BEGIN, END = "<!-- peers: written by benches/simulate/run.py -->\n", "<!-- end of peers -->\n"
TARGETS = (1e-6, 1e-9, 1e-12)
ACCURACIES = ["1e-3", *(f"1e-{k}" for k in range(4, 14))]
LONGEST = 60  # s on the processor
R = "R with deSolve"  # not a module of Python

# who: module of the environment, script, method, settings to try, what a setting is
PEERS = {
    "RADAU5 (Fortran, R's deSolve)": (R, "with_radau5.py", "radau", ["1e-4", "1e-5", "1e-8", "1e-12", "1e-13"]),
    "scipy, Radau (the same in Python)": ("scipy", "with_scipy.py", "Radau", ["1e-5", "1e-8", "1e-10"]),
    "scipy, DOP853": ("scipy", "with_scipy.py", "DOP853", ["1e-5", "1e-6", "1e-9", "1e-11"]),
    "SUNDIALS IDA": ("sksundae", "with_ida.py", "ida", ["1e-8", "1e-10", "1e-12"]),
    "MuJoCo, Runge–Kutta": ("mujoco", "with_mujoco.py", "RK4", ["3e-5", "1e-5", "3e-7"]),
    "Exudyn, generalised α": ("exudyn", "with_exudyn.py", "gen-alpha", ["3e-6", "1e-6"]),
}
CHAINS = {
    "RADAU5 (Fortran, R's deSolve)": ["1e-9"], "scipy, DOP853": ["1e-10"], "MuJoCo, Runge–Kutta": ["1e-3"], "Exudyn, generalised α": ["1e-3"],
}
MOST_EQUATIONS = 1  # four-bars in a row: general equations lose their way at the first dead position, and take minutes over more


def environment():
    """Installs the peers and runs this script again with their interpreter."""
    if not PYTHON.exists():
        venv.create(PLACE, with_pip=True)
    for line in (HERE / "requirements.txt").read_text().split():
        subprocess.run([PYTHON, "-m", "pip", "install", "-q", "--disable-pip-version-check", line])
    threads = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
    quiet = {"PYTHONDONTWRITEBYTECODE": "1", "NUMBA_CACHE_DIR": str(PLACE / "numba")}
    os.execve(PYTHON, [str(PYTHON), __file__, "--here", *sys.argv[1:]], {**os.environ, **dict.fromkeys(threads, "1"), **quiet})


def program():
    if os.environ.get("ASSUR"):
        return os.environ["ASSUR"]
    subprocess.run(["cargo", "build", "--release", "--bin", "assur"], cwd=ROOT, check=True)
    return str(ROOT / "target" / "release" / "assur")


def missing(module):
    if module == R:
        return not shutil.which("Rscript") or subprocess.run(["Rscript", "-e", "library(deSolve)"], capture_output=True).returncode != 0
    return subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True).returncode != 0


def of_peer(peer, scene, setting, repeats):
    """What a peer prints, with the time of its whole process; or why there is nothing."""
    _, script, method, _ = PEERS[peer]
    command = [str(PYTHON), str(HERE / script), scene.name, method, setting, str(repeats)]
    bound = lambda: resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))
    out = subprocess.run(command, cwd=HERE, capture_output=True, text=True, preexec_fn=bound)
    if out.returncode < 0:
        return f"not within {LONGEST} s"
    if out.returncode:
        return out.stderr.strip().splitlines()[-1][:70] if out.stderr.strip() else "fails"
    found = json.loads(out.stdout.splitlines()[-1])
    found["angles"] = {name: float("nan") if angle is None else angle for name, angle in found["angles"].items()}
    return found


def of_assur(assur, text, repeats):
    """For every accuracy: microseconds of all runs, evaluations, angles at the end; or why there is nothing."""
    file = Path(tempfile.mkdtemp()) / "scene.mech"
    file.write_text(text)
    rows = []
    for _ in range(repeats):
        out = subprocess.run([assur, "accuracy", str(file), "--format", "json"], capture_output=True, text=True)
        if out.returncode:
            said = [line for line in out.stderr.splitlines() if "×" in line]
            return (said or [out.stderr])[0].strip(" ×"), file
        again = json.loads(out.stdout)["knobs"][0]["settings"]
        rows = rows or again
        for row, other in zip(rows, again):
            row["microseconds"] = min(row["microseconds"], other["microseconds"])
    for row in rows:
        row["angles"] = printed([assur, "solve", str(file), "--format", "csv", "--within", row["setting"]])
    return rows, file


def printed(command):
    """The angles of the last line that a command prints."""
    head, *lines = subprocess.run(command, capture_output=True, text=True).stdout.splitlines()
    names = [re.sub(r"^angle\((\w+)\).*", r"\1", name) for name in head.split(",")]
    # a run that misses its accuracy ends with a line without numbers
    last = [line for line in lines if not line.endswith(",")][-1]
    return {name: float(x) for name, x in zip(names, last.split(","))}


def process(command, repeats):
    """The least time of a whole process on the processor, ms."""
    times = []
    for _ in range(repeats):
        begin = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, cwd=HERE, capture_output=True)
        end = resource.getrusage(resource.RUSAGE_CHILDREN)
        times.append(end.ru_utime + end.ru_stime - begin.ru_utime - begin.ru_stime)
    return 1e3 * min(times)


def three(x):
    return f"{x:.3g}" if x < 1000 else f"{x:,.0f}"


def table(heads, rows):
    line = lambda cells: "| " + " | ".join(cells) + " |"
    return "\n".join([line(heads), line(["---"] + ["---:"] * (len(heads) - 1)), *map(line, rows)]) + "\n"


def andrews(assur, repeats, absent):
    from scenes import error, mech, scene
    found = scene("andrews")
    text = mech(found)
    # a load of time has no energy: it leaves the motion to DOP853
    texts = {"assur": text, "assur, DOP853": re.sub(r"(?m)^torque .*$", r"\g<0> + 1e-30 N*m/s*time", text)}
    tried, files = {}, {}
    for own, text in texts.items():
        rows, files[own] = of_assur(assur, text, repeats)
        if isinstance(rows, str):
            return f"{own}: {rows}\n"
        tried[own] = [(r["microseconds"] / 1e3, error(found, r["angles"]), r["setting"], r["printed_evaluations"], r["evaluations"]) for r in rows]
    for peer, (_, _, _, settings) in PEERS.items():
        tried[peer] = []
        for setting in settings if peer not in absent else []:
            got = of_peer(peer, found, setting, repeats)
            if not isinstance(got, str):
                tried[peer].append((1e3 * got["seconds"], error(found, got["angles"]), setting, int(got["evaluations"]), int(got["evaluations"])))
            print(f"{peer} {setting}: {tried[peer][-1] if not isinstance(got, str) else got}", file=sys.stderr)
    lines, own = [], {}
    for target in TARGETS:
        kept = [t for t in tried["assur"] if t[1] <= target]
        own[target] = min(kept)[0] if kept else None
    for who, all_of_it in tried.items():
        if who in absent:
            lines.append([who, "not there", "", "", "", "", ""])
            continue
        for target in TARGETS:
            kept = [t for t in all_of_it if t[1] <= target]
            if not kept:
                best = min((t[1] for t in all_of_it), default=float("inf"))
                lines.append([who, f"{target:.0e}", f"not reached (best {best:.0e})", "", "", "", ""])
                continue
            ms, off, setting, evaluations, _ = min(kept)
            if who in files:
                whole = process([assur, "solve", str(files[who]), "--within", setting], repeats)
            else:
                _, script, method, _ = PEERS[who]
                whole = process([str(PYTHON), script, found.name, method, setting, "1"], min(repeats, 3))
            ratio = f"{three(ms / own[target])}×" if own[target] else "–"
            lines.append([who, f"{target:.0e}", setting, f"{off:.0e}", f"{evaluations:,}", f"{three(ms)} ({ratio})", three(whole)])
    heads = ["", "error kept", "tolerance, step", "error", "evaluations", "run, ms", "process, ms"]
    return table(heads, lines)


def chains(assur, repeats, absent):
    from scenes import mech, scene
    lines, numbers = [], (1, 10, 40)
    for n in numbers:
        found = scene(f"bars-{n}")
        off = lambda angles: abs(angles["c0"] - found.reference["c0"])
        file = Path(tempfile.mkdtemp()) / "scene.mech"
        file.write_text(mech(found, "1e-8"))
        angles = printed([assur, "solve", str(file), "--format", "csv"])
        whole = process([assur, "solve", str(file), "--format", "csv"], 3 * repeats)
        own = whole - process([assur, "check", str(file)], 3 * repeats)
        lines.append([f"assur, N = {n}", "1e-8", f"{off(angles):.0e}", three(own)])
        print(lines[-1], whole, file=sys.stderr)
        for peer, settings in CHAINS.items():
            general = PEERS[peer][1] in ("with_radau5.py", "with_scipy.py", "with_ida.py")
            if peer in absent or (general and n > MOST_EQUATIONS):
                continue
            for setting in settings:
                got = of_peer(peer, found, setting, min(repeats, 3))
                if isinstance(got, str):
                    lines.append([f"{peer}, N = {n}", setting, got, ""])
                    continue
                ms = 1e3 * got["seconds"]
                lines.append([f"{peer}, N = {n}", setting, f"{off(got['angles']):.0e}", f"{three(ms)} ({three(ms / own)}×)"])
            print(lines[-1], file=sys.stderr)
    return table(["", "tolerance, step", "error of the angle", "run, ms"], lines)


def main():
    words = [word for word in sys.argv[1:] if word != "--here"]
    write = "--write" in words
    repeats = next((int(word) for word in words if word.isdigit()), 5)
    sys.path.insert(0, str(HERE))
    absent = {peer for peer, (module, *_) in PEERS.items() if missing(module)}
    assur = program()
    notes = [f"{peer} is not there." for peer in sorted(absent)]
    text = "\n### Andrews' mechanism, 0.03 s\n\n" + andrews(assur, repeats, absent)
    text += "\n### N four-bars in a row, 10 s\n\n" + chains(assur, repeats, absent) + "\n"
    text += " ".join(notes) + "\n" if notes else ""
    sys.stdout.write(text)
    if write:
        page = PAGE.read_text()
        before, rest = page.split(BEGIN)
        PAGE.write_text(before + BEGIN + text + END + rest.split(END)[1])


if __name__ == "__main__":
    main() if "--here" in sys.argv else environment()
