"""Geneva wheel over several turns: the direction of the slot from the place of the pin, its derivatives by series; the force of
the pin from the wheel's equilibrium about its centre, else the couple of the locking arc over the distance of the centres."""
from mpmath import diff

from printing import *

a, J2, M2 = mpf("0.1"), mpf("0.002"), mpf("0.3")
r, w = a * mp.sin(pi / 4), 2 * pi
m1, s1 = mpf("0.5"), mpf("0.02")


def direction(phi):
    """Of the pin, seen from the wheel's centre, less a half turn."""
    return -mp.atan2(r * mp.sin(phi), a - r * mp.cos(phi))


rows = {name: [] for name in "angle way omega alpha rate normal C A M".split()}
for degrees in (-30, 0, 30, 90, 200, 330, 400, 700):
    phi = deg(degrees)
    turns = int(mp.floor((degrees + 180) / mpf(360)))
    here = phi - 2 * pi * turns
    engaged = abs(here) < pi / 4
    delta = direction(here) if engaged else (pi / 4 if here < 0 else -pi / 4)
    d1 = diff(direction, here) * w if engaged else mpf(0)
    d2 = diff(direction, here, 2) * w**2 if engaged else mpf(0)
    rows["angle"].append(pi + delta - turns * pi / 2)
    rows["omega"].append(d1)
    rows["alpha"].append(d2)
    couple = J2 * d2 - M2                                   # of pin or arc on the wheel about C
    if engaged:
        way = lambda f: sqrt(a**2 + r**2 - 2 * a * r * mp.cos(f))
        rows["way"].append(way(here))
        rows["rate"].append(diff(way, here) * w)
        place, arm = (r * mp.cos(here), r * mp.sin(here)), way(here)
        slot = (mp.cos(pi + delta), mp.sin(pi + delta))
    else:
        place, arm, slot = (mpf(0), mpf(0)), a, (mpf(-1), mpf(0))
    N = couple / arm
    F = (-slot[1] * N, slot[0] * N)                         # on the wheel, along the left normal of the slot
    rows["normal"].append(N)
    rows["C"].append((-F[0], -F[1]))
    inertia = (m1 * s1 * w**2 * mp.cos(phi), m1 * s1 * w**2 * mp.sin(phi))
    rows["A"].append((F[0] - inertia[0], F[1] - inertia[1]))
    rows["M"].append(place[0] * F[1] - place[1] * F[0])
keys("angle(wheel)", rows["angle"], "deg")
keys("omega(wheel)", rows["omega"], "rad/s")
keys("alpha(wheel)", rows["alpha"], "rad/s^2")
for i, pose in enumerate((1, 2, 3, 6, 7, 8)):
    key("displacement(K)", rows["way"][i], "mm", f" at pose {pose}")
    key("relative_velocity(K)", rows["rate"][i], "m/s", f" at pose {pose}")
keys("normal(K, wheel)", rows["normal"], "N")
keys("reaction(C, wheel)", rows["C"], "N")
keys("reaction(A, crank)", rows["A"], "N")
keys("Mb", rows["M"], "N*m")
