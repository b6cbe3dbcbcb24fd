"""A disc with a hole: the disc less the disc that was cut out, and the mass centre by the first moment."""
from printing import *

rho, t, r, q, e = mpf(7850), mpf("0.02"), mpf("0.15"), mpf("0.04"), mpf("0.08")
disc, hole = rho * t * pi * r**2, rho * t * pi * q**2
m = disc - hole
x = -hole * e / m
about = disc * r**2 / 2 - hole * (q**2 / 2 + e**2)
print(f"expect m_disc = {mp.nstr(m, 14)} kg within 1e-13")
print(f"expect x_S = {mp.nstr(1000 * x, 14)} mm within 1e-13")
print(f"expect J_O = {mp.nstr(about, 14)} kg*m^2 within 1e-13")
print(f"expect J_S = {mp.nstr(about - m * x**2, 14)} kg*m^2 within 1e-13")
