"""A physical pendulum of a rod and a disc: moments about the hinge by integration along the rod."""
from printing import *

line, l, disc, r, g = mpf("0.4"), mpf("0.9"), mpf(2), mpf("0.12"), mpf("9.81")
m = line * l + disc
first = mp.quad(lambda x: line * x, [0, l]) + disc * l
about = mp.quad(lambda x: line * x**2, [0, l]) + disc * (r**2 / 2 + l**2)
print(f"expect m_all = {mp.nstr(m, 14)} kg within 1e-13")
print(f"expect r_S = {mp.nstr(first / m, 14)} m within 1e-13")
print(f"expect J_A = {mp.nstr(about, 14)} kg*m^2 within 1e-13")
print(f"expect omega_0 = {mp.nstr(mp.sqrt(first * g / about), 14)} rad/s within 1e-13")
