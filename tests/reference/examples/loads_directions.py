"""Directions of the page, points at an angle, distances and instant centres: a four-bar with two forces."""
from planar import *

m = Mechanism().ground(A=(0, 0), D=(mpf("0.4"), 0))
m.bar("crank", "A-B", mpf("0.12"))
m.bar("coupler", "B-C", mpf("0.36"), P=(mpf("0.2") * mp.cos(deg(35)), mpf("0.2") * mp.sin(deg(35))))
m.bar("rocker", "D-C", mpf("0.25"))
m.revolute("A", "ground", "crank")
m.revolute("B", "crank", "coupler")
m.revolute("C", "coupler", "rocker")
m.revolute("D", "ground", "rocker")
m.drive("crank", mpf(0), mpf(10))
m.force("coupler", "P", (0, -250))
m.force("rocker", "C", (-90, 0))
m.balance_force("Fb", "crank", "B", deg(90))
turn = m.sweep(m.solve(left_of("C", "B", "D")), "crank", [deg(30 * i) for i in range(3)])
turn = turn[1:]


def meet(p, q, r, s):
    """Where the line through p and q meets that through r and s."""
    d, e, f = sub(q, p), sub(s, r), sub(r, p)
    t = (f[0] * e[1] - f[1] * e[0]) / (d[0] * e[1] - d[1] * e[0])
    return (p[0] + t * d[0], p[1] + t * d[1])


for i, s in enumerate(turn, 1):
    A, B, C, D, P = (s.position(p) for p in ("ground.A", "crank.B", "rocker.C", "ground.D", "coupler.P"))
    tail = f" at pose {i}"
    key("distance(D, P)", mp.sqrt(dot(sub(P, D), sub(P, D))), "mm", tail)
    key("instant_centre(coupler)", meet(A, B, D, C), "mm", tail)
    key("instant_centre(crank, rocker)", meet(B, C, A, D), "mm", tail)
    key("Fb", s.balance["Fb"], "N", tail)
    key("reaction(A, crank)", s.reaction("A", "crank"), "N", tail)
