"""A bent pendulum at rest: J about O of both rods, then what each rod needs for its own acceleration."""
from printing import *

g, L1, L2, m1, m2 = mpf("9.81"), mpf("0.6"), mpf("0.4"), mpf(3), mpf(2)
A = mp.matrix([L1, 0])
along = mp.matrix([mp.cos(pi / 3), mp.sin(pi / 3)])
S1, S2 = A / 2, A + along * L2 / 2
J1, J2 = m1 * L1**2 / 12, m2 * L2**2 / 12
J = J1 + m1 * (S1.T * S1)[0] + J2 + m2 * (S2.T * S2)[0]
alpha = -g * (m1 * S1[0] + m2 * S2[0]) / J
a1, a2 = (mp.matrix([-S[1], S[0]]) * alpha for S in (S1, S2))
up = mp.matrix([0, g])
F2 = (a2 + up) * m2
F1 = (a1 + up) * m1 + F2
d = A - S2
M2 = J2 * alpha - (d[0] * F2[1] - d[1] * F2[0])
for name, value, unit in [
    ("alpha(first)", alpha, "rad/s^2"),
    ("reaction(O, first).x", F1[0], "N"),
    ("reaction(O, first).y", F1[1], "N"),
    ("reaction(A, second).x", F2[0], "N"),
    ("reaction(A, second).y", F2[1], "N"),
    ("moment(A, second)", M2, "N*m"),
]:
    print(f"expect {name} = {mp.nstr(value, 14)} {unit} within 1e-12 at time = 0 s")
