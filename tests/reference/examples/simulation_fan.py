"""A motor of constant torque and a fan whose torque grows with the square of its speed: the hyperbolic tangent."""
from printing import *

M, k, j1, j2, i = mpf(12), mpf("0.004"), mpf("0.03"), mpf("1.6"), mpf("0.4")
last = mp.sqrt(M / (k * i ** 3))
T = (j1 + i * i * j2) * last / M
print(f"expect time(nearly) = {digits(T * mp.log(mpf(19)) / 2)} s within 1e-11")
for t in ("1", "10"):
    e = mp.exp(2 * mpf(t) / T)
    share = (e - 1) / (e + 1)
    print(f"expect omega(motor) = {digits(last * share)} rad/s within 1e-11 at time = {t} s")
    # what the belt carries drives the fan: its drag and its inertia
    force = (k * (i * last * share) ** 2 + j2 * i * last / T * (1 - share * share)) / mpf("0.2")
    print(f"expect tangential_force(b) = {digits(force)} N within 1e-10 at time = {t} s")
e = mp.exp(mpf(10) / T)
print(f"expect angle(motor) = {digits(last * T * mp.log((e + 1 / e) / 2))} rad within 1e-11 at time = 10 s")
