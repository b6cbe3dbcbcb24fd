"""Two rotors, a motor, a load and a clutch: constant accelerations before and behind the instant at which the speeds are equal."""
from printing import *

J_1, J_2, C, M, L, w, end = mpf(2), mpf(5), mpf(40), mpf(15), mpf(10), rpm(1500), mpf(10)
a_1, a_2 = (M - C) / J_1, (C - L) / J_2
t = w / (a_2 - a_1)
a = (M - L) / (J_1 + J_2)
print(f"expect time(engaged) = {digits(t)} s within 1e-12")
print(f"expect omega(two) = {digits(a_2 * t)} rad/s within 1e-12 at event engaged")
print(f"expect friction_work(k) = {digits(-C * w * t / 2)} J within 1e-12 at event end")
print(f"expect moment(k, two) = {digits(L + J_2 * a)} N*m within 1e-12 at event end")
print(f"expect omega(one) = {digits(a_2 * t + a * (end - t))} rad/s within 1e-12 at event end")
