"""A triangular plate: integrals over the triangle, its points as u B + v C with u + v < 1."""
from printing import *

rho, B, C = mpf(12), (mpf("0.6"), mpf(0)), (mpf("0.2"), mpf("0.5"))
area = B[0] * C[1] - B[1] * C[0]


def over(f):
    return rho * area * mp.quad(lambda u: mp.quad(lambda v: f(u * B[0] + v * C[0], u * B[1] + v * C[1]), [0, 1 - u]), [0, 1])


m = over(lambda x, y: mpf(1))
x, y = over(lambda x, y: x) / m, over(lambda x, y: y) / m
about = over(lambda x, y: x * x + y * y)
print(f"expect m_plate = {mp.nstr(m, 14)} kg within 1e-13")
print(f"expect S.x = {mp.nstr(x, 14)} m within 1e-13 at time = 0 s")
print(f"expect S.y = {mp.nstr(y, 14)} m within 1e-13 at time = 0 s")
print(f"expect J_A = {mp.nstr(about, 14)} kg*m^2 within 1e-13")
print(f"expect J_S = {mp.nstr(about - m * (x * x + y * y), 14)} kg*m^2 within 1e-13")
