"""Indicator diagram: the monotone cubic of Fritsch and Butland over the periodic table, by its definition in Hermite's
basis; the torque by the power of a crank-slider whose piston alone has mass; integrals by Gauss-Legendre from row to row."""
from mpmath import quad

from printing import *

TABLE = [(0, "3.2"), (15, "4.6"), (40, "2.4"), (90, "0.8"), (140, "0.35"), (180, "0.12"), (360, "0.1"), (380, "0.09"),
         (540, "0.09"), (630, "0.25"), (690, "1.1"), (720, "3.2")]
X = [mpf(a) * pi / 180 for a, _ in TABLE]
Y = [mpf(b) * 10**6 for _, b in TABLE]
H = [X[i + 1] - X[i] for i in range(len(X) - 1)]
D = [(Y[i + 1] - Y[i]) / H[i] for i in range(len(H))]


def harmonic(before, after):
    if D[before] * D[after] <= 0:
        return mpf(0)
    a = (1 + H[after] / (H[before] + H[after])) / 3
    return D[before] * D[after] / (a * D[after] + (1 - a) * D[before])


M = [harmonic(i - 1, i) for i in range(len(H))]    # the first row lies between the last and the first interval
M.append(M[0])


def p(phi, slope=False):
    i = max(k for k in range(len(H)) if X[k] <= phi)
    t, h = (phi - X[i]) / H[i], H[i]
    if slope:
        return ((6 * t**2 - 6 * t) * (Y[i] - Y[i + 1]) / h + (3 * t**2 - 4 * t + 1) * M[i] + (3 * t**2 - 2 * t) * M[i + 1])
    return ((2 * t**3 - 3 * t**2 + 1) * Y[i] + (t**3 - 2 * t**2 + t) * h * M[i]
            + (3 * t**2 - 2 * t**3) * Y[i + 1] + (t**3 - t**2) * h * M[i + 1])


r, l, m, w = mpf("0.06"), mpf("0.22"), mpf("1.1"), mpf(1500) * 2 * pi / 60
area = pi / 4 * mpf("0.01")


def x1(phi):
    s, c = mp.sin(phi), mp.cos(phi)
    return -r * s - r**2 * s * c / sqrt(l**2 - (r * s) ** 2)


def x2(phi):
    s, c = mp.sin(phi), mp.cos(phi)
    root = sqrt(l**2 - (r * s) ** 2)
    return -r * c - r**2 * (c**2 - s**2) / root - r**4 * (s * c) ** 2 / root**3


def work(phi):
    return -(p(phi) - 10**5) * area * x1(phi)


def torque(phi):
    return m * w**2 * x1(phi) * x2(phi) - work(phi)


poses = [i * pi / 2 for i in range(8)]
keys("M", [torque(f) for f in poses], "N*m")
key("pressure", p(poses[3]), "MPa", " at pose 4")
key("dp", p(poses[7], True), "MPa", " at pose 8")
total = sum(quad(work, X[i : i + 2]) for i in range(len(H)))
key("W", total, "J")
key("mean(M)", -total / (4 * pi), "N*m")
