"""A cam from a table of lifts: the periodic spline by its second derivatives at the rows (Gauss elimination of the full
matrix), the follower by Newton, the torque by the lever arm of the contact force, the pressure angle from its tangent."""
from mpmath import atan

from printing import *

LIFTS = ["0", "1.2", "4.5", "8.8", "12.4", "14.3", "14.9", "14", "11.2", "7.2", "3.3", "0.8"]
Y = [mpf(s) / 1000 for s in LIFTS]
n, h = len(Y), pi / 6


def solved(rows):
    """Gauss elimination with the right side in the last column."""
    size = len(rows)
    for i in range(size):
        k = max(range(i, size), key=lambda r: abs(rows[r][i]))
        rows[i], rows[k] = rows[k], rows[i]
        for r in range(size):
            if r != i:
                f = rows[r][i] / rows[i][i]
                rows[r] = [a - f * b for a, b in zip(rows[r], rows[i])]
    return [rows[i][size] / rows[i][i] for i in range(size)]


rows = []
for i in range(n):
    row = [mpf(0)] * (n + 1)
    row[(i - 1) % n] += h / 6
    row[i] += 2 * h / 3
    row[(i + 1) % n] += h / 6
    row[n] = (Y[(i + 1) % n] - 2 * Y[i] + Y[i - 1]) / h
    rows.append(row)
M2 = solved(rows)                                  # second derivatives at the rows


def lift(phi):
    i = int(phi / h) % n
    t = phi - i * h
    a, b = M2[i], M2[(i + 1) % n]
    y0, y1 = Y[i], Y[(i + 1) % n]
    value = a * (h - t) ** 3 / (6 * h) + b * t**3 / (6 * h) + (y0 / h - a * h / 6) * (h - t) + (y1 / h - b * h / 6) * t
    first = -a * (h - t) ** 2 / (2 * h) + b * t**2 / (2 * h) + (y1 - y0) / h - (b - a) * h / 6
    return value, first, (a * (h - t) + b * t) / h


r0, e, m, g, k, w = mpf("0.04"), mpf("0.006"), mpf("0.8"), mpf("9.81"), mpf(9000), mpf(600) * pi / 30
d0 = sqrt(r0**2 - e**2)
N, M, angle, speed, second, way = [], [], [], [], [], []
for i in range(12):
    # the cam turns counter-clockwise: its profile runs against phi; poses lie on the rows and are continuous there
    s, s1, s2 = lift(i * h + mpf(10) ** -30)
    tan = (s1 - e) / (d0 + s)                      # of the pressure angle
    down = k * (mpf("0.05") - (mpf("0.12") - (d0 + s + mpf("0.05")))) + m * g
    F = m * s2 * w**2 + down                       # along the guide
    N.append(F * sqrt(1 + tan**2))
    M.append(F * s1)                               # power: M w = F s1 w
    angle.append(abs(atan(tan)))
    way.append(s)
    speed.append(s1 * w)
    second.append(s2 * w**2)
keys("h", way, "mm")
keys("relative_velocity(G)", speed, "m/s")
keys("relative_acceleration(G)", second, "m/s^2")
keys("N", N, "N")
keys("M", M, "N*m")
keys("pressure_angle(K)", angle, "deg")
