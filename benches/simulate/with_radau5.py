"""`python with_radau5.py SCENE radau TOLERANCE REPEATS`: RADAU5 in Fortran by R's deSolve, on the angles of all links as with
scipy, the equations compiled by the C compiler."""
import subprocess
import sys
import tempfile
from pathlib import Path

import angles
import numpy
from peer import BUDGET
from scenes import scene

R = """
suppressPackageStartupMessages(library(deSolve))
dyn.load("scene.so")
y <- c({start})
run <- function() radau(y, c(0, {end}), func = "rates", parms = NULL, dllname = "scene", initfunc = NULL,
                        rtol = {tolerance}, atol = {tolerance}, maxsteps = 1e6)
# R tells milliseconds: the mean of many
spent <- function() sum(proc.time()[1:2])
found <- run(); begin <- spent(); count <- 0
while (count < 10 * {repeats} && spent() - begin < {budget}) {{ found <- run(); count <- count + 1 }}
mean <- (spent() - begin) / count
stopifnot(attr(found, "istate")[1] >= 0, nrow(found) == 2)
names <- c({names})
angles <- sprintf('"%s": %.17g', names, found[2, 2:(1 + length(names))])
cat(sprintf('{{"seconds": %.9g, "evaluations": %d, "angles": {{%s}}}}\\n', mean, attr(found, "istate")[3], paste(angles, collapse = ", ")))
"""


def constant(name, values):
    values = numpy.asarray(values, float)
    sizes = "".join(f"[{n}]" for n in values.shape)
    braces = lambda x: "{" + ", ".join(map(braces, x)) + "}" if numpy.ndim(x) else float(x).hex()
    return f"static const double {name}{sizes} = {braces(values)};\n"


found = scene(sys.argv[1])
names = ("centres", "loops", "gaps", "mass", "inertia", "torque", "eye", "spring", "gravity")
header = f"enum {{ N = {len(found.links)}, M = {2 * len(found.loops)} }};\n"
header += "".join(constant(name, data) for name, data in zip(names, angles.arrays(found)) if name != "gaps")
start = ", ".join(repr(float(x)) for part in angles.start(found) for x in part)
quoted = ", ".join(f'"{link.name}"' for link in found.links)
with tempfile.TemporaryDirectory() as place:
    Path(place, "scene.h").write_text(header)
    source = Path(__file__).with_name("radau5.c")
    compiler = ["cc", "-O3", "-march=native", "-ffast-math", "-shared", "-fPIC", "-I", place, str(source), "-o", "scene.so", "-lm"]
    subprocess.run(compiler, cwd=place, check=True)
    words = {"start": start, "end": found.end, "tolerance": sys.argv[3], "repeats": sys.argv[4], "names": quoted, "budget": BUDGET}
    Path(place, "run.R").write_text(R.format(**words))
    sys.exit(subprocess.run(["Rscript", "--vanilla", "run.R"], cwd=place).returncode)
