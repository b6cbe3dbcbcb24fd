"""The ellipse of a point of a trammel: its evolute in closed form."""
from printing import *

a, b, q = mpf("0.3"), mpf("0.2"), mp.radians(35)
s, c = mp.sin(q), mp.cos(q)
rho = ((a * s) ** 2 + (b * c) ** 2) ** mpf("1.5") / (a * b)
x, y = (a * a - b * b) / a * c ** 3, (b * b - a * a) / b * s ** 3
print(f"expect rho = {mp.nstr(rho, 14)} m within 1e-13")
print(f"expect curvature_centre(bar.P) = ({mp.nstr(x, 14)} m, {mp.nstr(y, 14)} m) within 1e-13")
