"""`python with_ida.py SCENE ida TOLERANCE REPEATS`: SUNDIALS IDA by scikit-sundae; index 2 after Gear, Gupta and Leimkuhler."""
import sys

import angles
import numpy
from numba import njit
from peer import report
from scenes import scene
from sksundae.ida import IDA

found, tolerance = scene(sys.argv[1]), float(sys.argv[3])
data, (q, v) = angles.arrays(found), angles.start(found)
n, m = len(q), 2 * len(found.loops)


@njit
def equations(y, yp, res):
    q, v, force, shift = y[:n], y[n : 2 * n], y[2 * n : 2 * n + m], y[2 * n + m :]
    M, Q, G, bias, gap = angles.terms(q, v, *data)
    res[:n] = yp[:n] - v + G.T @ shift
    res[n : 2 * n] = M @ yp[n : 2 * n] - Q + G.T @ force
    res[2 * n : 2 * n + m] = G @ v
    res[2 * n + m :] = gap


def residual(t, y, yp, res):
    equations(y, yp, res)


M, Q, G, bias, _ = angles.terms(q, v, *data)
solved = angles.accelerated(q, v, M, Q, G, bias)
y = numpy.concatenate((q, v, solved[n:], numpy.zeros(m)))
yp = numpy.concatenate((v, solved[:n], numpy.zeros(2 * m)))
algebraic = list(range(2 * n, 2 * n + 2 * m))
equations(y, yp, numpy.zeros(2 * n + 2 * m))
# multipliers are not judged
allowed = numpy.concatenate((numpy.full(2 * n, tolerance), numpy.full(2 * m, 1e6)))


def run():
    solver = IDA(residual, algebraic_idx=algebraic, rtol=tolerance, atol=allowed, max_num_steps=1_000_000)
    end = solver.solve(numpy.array([0.0, found.end]), y, yp)
    if not end.success:
        raise RuntimeError(str(end.message))
    return dict(zip([link.name for link in found.links], end.y[-1][:n])), int(end.nfev)


report(run)
