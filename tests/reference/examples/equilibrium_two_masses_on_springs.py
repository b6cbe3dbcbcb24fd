"""Two masses between three springs: both roots of the characteristic equation."""
from printing import *

m1, m2, k1, k2, k3 = mpf(2), mpf(1), mpf(300), mpf(400), mpf(200)
print("expect x_1 = 1 m within 1e-12")
print("expect x_2 = 2 m within 1e-12")
a, b = (k1 + k2) / m1, (k2 + k3) / m2
half, root = (a + b) / 2, mp.sqrt(((a - b) / 2) ** 2 + k2 ** 2 / (m1 * m2))
for i, square in enumerate((half - root, half + root), 1):
    print(f"expect omega_{i} = {mp.nstr(mp.sqrt(square), 14)} rad/s within 1e-12")
print("expect stable()")
