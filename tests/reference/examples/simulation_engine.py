"""A motor with a linear characteristic runs up a crank-slider: one equation for the angle of the crank; forces on rod and piston."""
from dynamics import *

r, l, s, m_rod, j_rod, m_piston, j = 0.1, 0.35, 0.117, 2.5, 0.0425, 2.14, 0.5
top, most = 1500 * math.pi / 30, 80.0


def places(phi):
    b = (cos(phi) * r, sin(phi) * r)
    psi = atan2(-b[1], sqrt(l * l - b[1] * b[1]))
    return b, psi, point(*b, psi, (s, 0.0)), b[0] + cos(psi) * l


def scene(_, q):
    _, psi, (x, y), c = places(q[0])
    return [(j, q[0], most * (1.0 - q[0].b / top)), (m_rod, x, 0.0), (m_rod, y, 0.0), (j_rod, psi, 0.0), (m_piston, c, 0.0)]


f = rates(scene)


def crank_pin(t, y):
    """Force of the crank on the rod, from the rod's and the piston's equations."""
    b, psi, (sx, sy), c = places(Jet(y[0], y[1], f(t, y)[1]))
    # piston: Rx = m c''; rod about its mass centre with R on the piston at C: F from the crank at B
    rx = m_piston * c.c
    fx = m_rod * sx.c + rx
    # j psi'' = (B - S) x F - (C - S) x R, with Fy - Ry = m sy''
    bx, by, cx, cy = b[0].a - sx.a, b[1].a - sy.a, c.a - sx.a, -sy.a
    # bx Fy - by Fx - cx Ry + cy Rx = j psi'', Ry = Fy - m sy''
    fy = (j_rod * psi.c + by * fx - cx * m_rod * sy.c - cy * rx) / (bx - cx)
    return math.hypot(fx, fy)


start = [math.pi / 4, 0.0]
t, y, _ = integrate(f, start, 0.0, 1.0, 0.01)
key("angle(crank)", y[0], "rad", "1e-10", " at time = 1 s")
key("omega(crank)", y[1], "rad/s", "1e-10", " at time = 1 s")
t, y, found = integrate(f, y, t, 2.0, 0.01, events=[("fast", lambda t, y: y[1] - 1200 * math.pi / 30)])
for n in (1, 2, 3):
    key(f"time(fast, {n})" if n > 1 else "time(fast)", found["fast"][2 * n - 2][0], "s", "1e-10")
key("omega(crank)", y[1], "rad/s", "1e-10", " at time = 2 s")
key("mag(reaction(B, rod))", crank_pin(t, y), "N", "1e-9", " at time = 2 s")
# the force grows with the square of the speed: the greatest of the last turn
t, y, _ = integrate(f, start, 0.0, 1.945, 0.01)
h, best = 5e-4, (0.0, 0.0, 0.0)
while t < 2.0 - 1e-9:
    y, t = extrapolated(f, t, y, h)[0], t + h
    best = max(best, (crank_pin(t, y), t, y))
_, t, y = best
a, b = -h, h
for _ in range(60):
    u, w = a + 0.382 * (b - a), a + 0.618 * (b - a)
    at = [crank_pin(t + x, extrapolated(f, t, y, x)[0]) for x in (u, w)]
    a, b = (a, w) if at[0] > at[1] else (u, b)
print(f"# the greatest force is at {t + a:.6f} s")
key("max(mag(reaction(B)))", max(at), "N", "1e-9", places=11)
