"""A five-bar in the angles of a crank and its rod; pin force of the rods from the equations of the other two bars."""
from dynamics import *

g, m, j, lc, lr = 9.81, 2.0, 0.01, 0.25, 0.4


def bars(q):
    """(x, y, angle) of the middles of all bars, pins, and the angles of c and d."""
    a, b = q
    pin_b = (cos(a) * lc, sin(a) * lc)
    pin_c = (pin_b[0] + cos(b) * lr, pin_b[1] + sin(b) * lr)
    e = (Jet(0.5), Jet(0.0))
    pin_d = dyad(pin_c, e, lr, lc, 1)
    c = atan2(pin_c[1] - pin_d[1], pin_c[0] - pin_d[0])
    d = atan2(pin_d[1], pin_d[0] - e[0])
    middle = lambda p, q: ((p[0] + q[0]) * 0.5, (p[1] + q[1]) * 0.5)
    o = (Jet(0.0), Jet(0.0))
    return [(*middle(o, pin_b), a), (*middle(pin_b, pin_c), b), (*middle(pin_d, pin_c), c), (*middle(e, pin_d), d)], pin_c, pin_d


def scene(_, q):
    all_bars, _, _ = bars(q)
    torques = (8.0 - 0.4 * q[0].b, 0.0, 0.0, -0.3 * all_bars[3][2].b)
    return [term for (x, y, phi), M in zip(all_bars, torques) for term in (*weight(m, x, y, g), (j, phi, M))]


f = rates(scene)


def pin_force(t, y):
    """Force on the rod c in C: moments of c and d about D and E."""
    dy = f(t, y)
    (_, _, c, d), pin_c, pin_d = bars([Jet(y[i], y[2 + i], dy[2 + i]) for i in (0, 1)])
    (cx, cy, cphi), (dx, dy_, dphi) = c, d
    m_c, m_d = (m * cx.c, m * (cy.c + g)), (m * dx.c, m * (dy_.c + g))
    u, v = (pin_c[0].a - pin_d[0].a, pin_c[1].a - pin_d[1].a), (pin_d[0].a - 0.5, pin_d[1].a)
    # about D: u x F = j c'' + u/2 x m_c; D pulls d with F - m_c, about E: v x (F - m_c) - v/2 x m_d - 0.3 d' = j d''
    cross = lambda p, q: p[0] * q[1] - p[1] * q[0]
    one = j * cphi.c + 0.5 * cross(u, m_c)
    two = j * dphi.c + cross(v, m_c) + 0.5 * cross(v, m_d) + 0.3 * dphi.b
    return math.hypot(*solve([[-u[1], u[0]], [-v[1], v[0]]], [one, two]))


b0 = dyad((Jet(lc * math.cos(math.radians(100))), Jet(lc * math.sin(math.radians(100)))),
          (Jet(0.5 + lc * math.cos(math.radians(70))), Jet(lc * math.sin(math.radians(70)))), lr, lr, 1)
b0 = math.atan2(b0[1].a - lc * math.sin(math.radians(100)), b0[0].a - lc * math.cos(math.radians(100)))
y, t = [math.radians(100), b0, 0.0, 0.0], 0.0


def in_line(_, y):
    all_bars, _, _ = bars([Jet(y[0], y[2]), Jet(y[1], y[3])])
    return math.sin(all_bars[1][2].a - all_bars[2][2].a)


def keys(y, tail):
    all_bars, _, _ = bars([Jet(y[0], y[2]), Jet(y[1], y[3])])
    d = all_bars[3][2]
    key("angle(a)", y[0], "rad", "1e-10", tail)
    key("angle(d)", d.a % (2 * math.pi), "rad", "1e-10", tail)
    key("omega(a)", y[2], "rad/s", "1e-10", tail)
    key("omega(d)", d.b, "rad/s", "1e-10", tail)


t, y, _ = integrate(f, y, t, 0.15, 0.01)
keys(y, " at time = 0.15 s")
key("mag(reaction(C, c))", pin_force(t, y), "N", "1e-10", " at time = 0.15 s")
t, y, found = integrate(f, y, t, 0.35, 0.01, events=[("in_line", in_line)])
key("time(in_line)", found["in_line"][0][0], "s", "1e-10")
keys(y, " at time = 0.35 s")
key("mag(reaction(C, c))", pin_force(t, y), "N", "1e-10", " at time = 0.35 s")
