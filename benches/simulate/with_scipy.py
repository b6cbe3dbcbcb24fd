"""`python with_scipy.py SCENE METHOD TOLERANCE REPEATS`: scipy on the angles of all links, the loops differentiated twice."""
import sys

import angles
import numpy
from peer import report
from scipy.integrate import solve_ivp
from scenes import scene

found, method, tolerance = scene(sys.argv[1]), sys.argv[2], float(sys.argv[3])
rates, (q, v) = angles.ode(found), angles.start(found)
y = numpy.concatenate((q, v))
rates(0.0, y)


def run():
    end = solve_ivp(rates, (0.0, found.end), y, method=method, rtol=tolerance, atol=tolerance, t_eval=[found.end])
    if not end.success:
        raise RuntimeError(end.message)
    return dict(zip([link.name for link in found.links], end.y[: len(q), -1])), end.nfev


report(run)
