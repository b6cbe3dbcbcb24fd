"""The Python package against KinePy and pylinkage on one sweep of the four-bar, in one run on one thread: what each takes over what
assur takes, as docs/python.md has it.

    python3 benches/peers/package.py [WHEEL]

Makes a virtual environment under target/peers-package with NumPy, the peers of requirements.txt and the wheel (of target/artefacts or
target/python/wheels without a word). assur finds residuals and condition of every position besides; pylinkage has no forces. The least
of several turns counts, and every number is compared with assur's.
"""
import os
import subprocess
import sys
import time
import venv
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PLACE = ROOT / "target" / "peers-package"
COUNT = 36_000
TURNS = 20
PEERS = ("kinepy", "pylinkage")


def in_environment(wheel):
    """Runs this script again with an interpreter that has the peers and the wheel."""
    python = PLACE / "bin" / "python"
    if not python.exists():
        venv.create(PLACE, with_pip=True)
    wanted = [line for line in (HERE / "requirements.txt").read_text().split() if line.startswith(PEERS)]
    subprocess.run([python, "-m", "pip", "install", "-q", *wanted], check=True)
    subprocess.run([python, "-m", "pip", "install", "-q", "--force-reinstall", "--no-deps", wheel], check=True)
    threads = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
    os.execve(python, [str(python), __file__, "--here"], {**os.environ, **dict.fromkeys(threads, "1")})


def newest_wheel():
    found = [path for folder in ("artefacts", "python/wheels") for path in (ROOT / "target" / folder).glob("assur-*.whl")]
    if not found:
        sys.exit("no wheel is built: crates/assur-python/test.sh, or name one")
    return max(found, key=lambda path: path.stat().st_mtime)


def seconds(run):
    start = time.process_time()
    run()
    return time.process_time() - start


def main():
    import numpy

    import assur
    import with_kinepy
    import with_pylinkage

    text = (HERE / "four-bar.mech").read_text()
    machine = text.split("\nfind ")[0]
    turn = numpy.arange(COUNT) * (2 * numpy.pi / COUNT)
    with_forces = assur.compile(text)
    with_places = assur.compile(machine + "\nfind position(coupler.C)\n")
    with_motion = assur.compile(machine + "\nfind position(coupler.C), velocity(coupler.C), acceleration(coupler.C)\n")

    kinepy = with_kinepy.Machine("four-bar")
    few = assur.compile(machine + "\nfind position(coupler.C)\n").solve(turn[::100])
    kinepy.assemble({"coupler.C": numpy.column_stack(few["position(coupler.C)"])})
    pylinkage = with_pylinkage.Machine("four-bar")

    solve = lambda problem: problem.solve(turn, threads=1)
    runs = {
        "assur, positions": lambda: solve(with_places),
        "assur, accelerations": lambda: solve(with_motion),
        "assur, reactions and torque": lambda: solve(with_forces),
        "KinePy, positions": lambda: kinepy.positions(COUNT),
        "KinePy, reactions and torque": lambda: kinepy.dynamics(COUNT),
        "pylinkage, positions": lambda: pylinkage.positions(COUNT),
        "pylinkage, accelerations": lambda: pylinkage.kinematics(COUNT),
    }
    least = {who: min(seconds(run) for _ in range(TURNS)) for who, run in runs.items()}

    solution = solve(with_forces)
    worst = max(solution.residuals["equilibrium"].max(), solution.residuals["closure"].max())
    torque = kinepy.torque()
    difference = min(abs(torque - sign * solution["Mb"]).max() for sign in (1, -1)) / abs(solution["Mb"]).max()
    print(f"four-bar, {COUNT} positions, one thread, least of {TURNS} turns of processor time")
    print(f"assur: worst residual {worst:.0e}; torque of KinePy differs by {difference:.0e} of the greatest\n")
    print("| what | µs per position | times assur |\n| --- | --- | --- |")
    for who, time_taken in least.items():
        own = least["assur, " + who.split(", ", 1)[1]]
        print(f"| {who} | {1e6 * time_taken / COUNT:.3g} | {time_taken / own:.3g} |")


if __name__ == "__main__":
    if "--here" in sys.argv:
        main()
    else:
        in_environment(sys.argv[1] if len(sys.argv) > 1 else str(newest_wheel()))
