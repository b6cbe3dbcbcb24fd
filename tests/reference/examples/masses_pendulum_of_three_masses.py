"""A pendulum of three masses: each part as its own body about the hinge, J = sum of J_i + m_i x_i^2, and the forces of the parts."""
from printing import *

g = mpf("9.81")
parts = [(mpf(3), mpf("0.4"), mpf("0.16")), (mpf(5), mpf("0.8"), mpf("0.05625")), (mpf(4), mpf("-0.25"), mpf(0))]
m, first = sum(p[0] for p in parts), sum(p[0] * p[1] for p in parts)
about = sum(J + k * x * x for k, x, J in parts)
alpha = -first * g / about
force = sum(k * (x * alpha + g) for k, x, _ in parts)
print(f"expect r_S = {mp.nstr(first / m, 14)} m within 1e-12 at time = 0 s")
print(f"expect J_A = {mp.nstr(about, 14)} kg*m^2 within 1e-12 at time = 0 s")
print(f"expect J_S = {mp.nstr(about - first ** 2 / m, 14)} kg*m^2 within 1e-12 at time = 0 s")
print(f"expect alpha(arm) = {mp.nstr(alpha, 14)} rad/s^2 within 1e-13 at time = 0 s")
print(f"expect reaction(A, arm).y = {mp.nstr(force, 14)} N within 1e-13 at time = 0 s")
print(f"expect T = {mp.nstr(2 * pi * mp.sqrt(about / (first * g)), 14)} s within 1e-13 at time = 0 s")
