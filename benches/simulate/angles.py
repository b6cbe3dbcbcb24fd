"""The equations of a scene in the angles of all links: masses, right-hand side and loop equations, compiled by numba.

    M(θ) θ'' + G(θ)ᵀ λ = Q(θ, θ'),  g(θ) = 0,  G = ∂g/∂θ
"""
import numpy
from numba import njit


def arrays(scene):
    """Every point as a sum of vectors that are fixed to links: [number of points, link, xy], and a constant."""
    count = len(scene.links)

    def to_origin(name):
        if name == "ground":
            return numpy.zeros((count, 2)), numpy.zeros(2)
        link = scene.links[scene.index(name)]
        way, base = to_point(link.before, link.pin[0])
        way[scene.index(name)] -= link.points[link.pin[1]]
        return way, base

    def to_point(name, point):
        if name == "ground":
            return numpy.zeros((count, 2)), numpy.array(scene.ground[point], float)
        way, base = to_origin(name)
        link = scene.links[scene.index(name)]
        way[scene.index(name)] += link.centre if point is None else link.points[point]
        return way, base

    centres = numpy.array([to_point(link.name, None)[0] for link in scene.links])
    loops, gaps = [], []
    for one, p, two, q in scene.loops:
        (a, base), (b, other) = to_point(one, p), to_point(two, q)
        loops.append(a - b)
        gaps.append(base - other)
    mass = numpy.array([link.mass for link in scene.links])
    inertia = numpy.array([link.inertia for link in scene.links])
    torque = numpy.zeros(count)
    if scene.torque:
        torque[scene.index(scene.torque[0])] = scene.torque[1]
    eye, spring = numpy.zeros((count, 2)), numpy.zeros(4)
    if scene.spring:
        link, point, ground, stiffness, free = scene.spring
        eye, base = to_point(link, point)
        spring[:] = [*(base - scene.ground[ground]), stiffness, free]
    return centres, numpy.array(loops), numpy.array(gaps), mass, inertia, torque, eye, spring, scene.gravity


@njit(cache=True)
def terms(q, v, centres, loops, gaps, mass, inertia, torque, eye, spring, gravity):
    """M, Q, G, −G'θ', g."""
    n, m = len(q), 2 * len(loops)
    c, s = numpy.cos(q), numpy.sin(q)
    M, Q = numpy.diag(inertia), torque.copy()
    J = numpy.zeros((2, n))
    for body in range(len(centres)):
        ax, ay = 0.0, -gravity
        for k in range(n):
            x, y = centres[body, k]
            px, py = c[k] * x - s[k] * y, s[k] * x + c[k] * y
            J[0, k], J[1, k] = -py, px
            ax += px * v[k] ** 2
            ay += py * v[k] ** 2
        for i in range(n):
            if J[0, i] != 0.0 or J[1, i] != 0.0:
                Q[i] += mass[body] * (J[0, i] * ax + J[1, i] * ay)
                for k in range(n):
                    M[i, k] += mass[body] * (J[0, i] * J[0, k] + J[1, i] * J[1, k])
    if spring[2] != 0.0:
        x, y = spring[0], spring[1]
        for k in range(n):
            x += c[k] * eye[k, 0] - s[k] * eye[k, 1]
            y += s[k] * eye[k, 0] + c[k] * eye[k, 1]
        length = numpy.sqrt(x * x + y * y)
        pull = -spring[2] * (length - spring[3]) / length
        for k in range(n):
            px, py = c[k] * eye[k, 0] - s[k] * eye[k, 1], s[k] * eye[k, 0] + c[k] * eye[k, 1]
            Q[k] += pull * (-py * x + px * y)
    G, bias, gap = numpy.zeros((m, n)), numpy.zeros(m), numpy.zeros(m)
    for loop in range(len(loops)):
        gap[2 * loop], gap[2 * loop + 1] = gaps[loop]
        for k in range(n):
            x, y = loops[loop, k]
            px, py = c[k] * x - s[k] * y, s[k] * x + c[k] * y
            G[2 * loop, k], G[2 * loop + 1, k] = -py, px
            bias[2 * loop] += px * v[k] ** 2
            bias[2 * loop + 1] += py * v[k] ** 2
            gap[2 * loop] += px
            gap[2 * loop + 1] += py
    return M, Q, G, bias, gap


@njit(cache=True)
def accelerated(q, v, M, Q, G, bias):
    """θ'' and λ of M θ'' + Gᵀ λ = Q, G θ'' = bias."""
    n, m = len(q), len(bias)
    A, b = numpy.zeros((n + m, n + m)), numpy.zeros(n + m)
    A[:n, :n], A[:n, n:], A[n:, :n] = M, G.T, G
    b[:n], b[n:] = Q, bias
    return numpy.linalg.solve(A, b)


def ode(scene):
    """y' of y = (θ, θ')."""
    data, n = arrays(scene), len(scene.links)

    @njit
    def rates(t, y):
        M, Q, G, bias, _ = terms(y[:n], y[n:], *data)
        return numpy.concatenate((y[n:], accelerated(y[:n], y[n:], M, Q, G, bias)[:n]))

    return rates


def start(scene):
    q, v = (numpy.array([getattr(link, what) for link in scene.links], float) for what in ("angle", "rate"))
    return q, v
