"""A plate in general plane motion: v_B = v_A + w x r, a_B = a_A + alpha x r - w^2 r; F = m a_B, M = J alpha + r x F."""
from fractions import Fraction as Q

v, a, r, w, alpha, m, J = (Q(3), Q(0)), (Q(1), Q(2)), (Q(2, 5), Q(3, 10)), Q(5), Q(4), Q(2), Q(1, 10)
vb = (v[0] - w * r[1], v[1] + w * r[0])
ab = (a[0] - alpha * r[1] - w * w * r[0], a[1] + alpha * r[0] - w * w * r[1])
force = tuple(m * x for x in ab)
moment = J * alpha + r[0] * force[1] - r[1] * force[0]


def n(x):
    return format(float(x), ".14g")


print(f"expect velocity(plate.B) = ({n(vb[0])} m/s, {n(vb[1])} m/s) within 1e-12")
print(f"expect acceleration(plate.B) = ({n(ab[0])} m/s^2, {n(ab[1])} m/s^2) within 1e-12")
print(f"expect effort(plate.A) = ({n(force[0])} N, {n(force[1])} N) within 1e-12")
print(f"expect effort(plate) = {n(moment)} N*m within 1e-12")
print(f"expect power(plate.A) = {n(force[0] * v[0] + force[1] * v[1])} W within 1e-12")
