"""A disc slips down a slope: friction f N with N = m g cos(beta) slows it and turns it."""
from printing import *

g, r, f, t = mpf("9.81"), mpf("0.15"), mpf("0.2"), mpf(2)
beta = 40 * pi / 180
a = g * (mp.sin(beta) - f * mp.cos(beta))
alpha = -2 * f * g * mp.cos(beta) / r
print(f"expect mag(acceleration(disc.C)) = {mp.nstr(a, 14)} m/s^2 within 1e-12 at time = 1 s")
print(f"expect alpha(disc) = {mp.nstr(alpha, 14)} rad/s^2 within 1e-12 at time = 1 s")
print(f"expect way = {mp.nstr(a * t * t / 2, 14)} m within 1e-12 at time = 2 s")
print(f"expect abs(slip_speed(K)) = {mp.nstr((a + alpha * r) * t, 14)} m/s within 1e-12 at time = 2 s")
print(f"expect rolls_up_to = {mp.nstr(mp.atan(3 * f) * 180 / pi, 14)} deg within 1e-12")
