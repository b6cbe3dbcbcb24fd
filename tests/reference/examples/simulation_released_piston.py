"""A crank-slider under a constant force on its piston, in the angle of the crank; force in B from the rod and the piston."""
from dynamics import *

r, l, s = 0.1, 0.35, 0.117
J_1, m_2, J_2, m_3, F = 0.5, 2.5, 0.0425, 2.14, -2000.0


def places(q):
    (a,) = q
    b = (cos(a) * r, sin(a) * r)
    rod = atan2(-b[1], sqrt(l * l - b[1] * b[1]))
    return b, point(*b, rod, (s, 0.0)), rod, point(*b, rod, (l, 0.0))[0]


def scene(_, q):
    _, (x, y), rod, piston = places(q)
    return [(J_1, q[0], 0.0), (m_2, x, 0.0), (m_2, y, 0.0), (J_2, rod, 0.0), (m_3, piston, F)]


f = rates(scene)


def force_in_b(t, y):
    b, (x, h), rod, piston = places([Jet(y[0], y[1], f(t, y)[1])])
    # along the guide: rod and piston together; moments of the rod about C give the other part
    across_c = m_3 * piston.c - F
    b_x = m_2 * x.c + across_c
    d_x, d_y = b[0].a - piston.a, b[1].a
    e_x, e_y = x.a - piston.a, h.a
    # moments of the forces on the rod about C
    b_y = (J_2 * rod.c + m_2 * (e_x * h.c - e_y * x.c) + d_y * b_x) / d_x
    return math.hypot(b_x, b_y)


a0 = math.acos((0.4 ** 2 + r * r - l * l) / (2.0 * 0.4 * r))
t, y = 0.0, [a0, 0.0]
t, y, found = integrate(f, y, t, 0.12, 0.005, events=[("inner", lambda _, y: y[0] - math.pi)])
key("time(inner)", found["inner"][0][0], "s", "1e-10")
for end in (0.12, 0.28):
    events = [("back", lambda _, y: y[1])]
    t, y, found = integrate(f, y, t, end, 0.005, events=events) if end > t else (t, y, found)
    key("angle(crank)", y[0], "rad", "1e-9", f" at time = {end} s")
    key("omega(crank)", y[1], "rad/s", "1e-9", f" at time = {end} s")
    key("displacement(D)", places([Jet(y[0])])[3].a, "m", "1e-9", f" at time = {end} s")
    key("mag(reaction(B, rod))", force_in_b(t, y), "N", "1e-9", f" at time = {end} s")
key("time(back)", found["back"][0][0], "s", "1e-9")
