"""Two rotors and a clutch: constant accelerations until the speeds are equal."""
from printing import *

J_1, J_2, M, w = mpf(2), mpf(5), mpf(40), rpm(1500)
t = w / (M / J_1 + M / J_2)
print(f"expect time(engaged) = {digits(t)} s within 1e-12")
print(f"expect omega(one) = {digits(M / J_2 * t)} rad/s within 1e-12 at event engaged")
print(f"expect omega(two) = {digits(M / J_2 * t)} rad/s within 1e-12 at event end")
print(f"expect friction_work(k) = {digits(-M * w * t / 2)} J within 1e-12 at event end")
print(f"expect slip = {digits(w * t / 2 / (2 * pi))} within 1e-12 at event end")
