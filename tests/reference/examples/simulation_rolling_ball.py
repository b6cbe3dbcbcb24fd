"""A ball slides and then rolls: slip v + w r falls at f g + r f g m r/J = f g (1 + 5/2)."""
from printing import *

g, r, m, v, f = mpf("9.81"), mpf("0.11"), mpf(6), mpf(8), mpf("0.12")
J = 2 * m * r * r / 5
t = v / (f * g * (1 + m * r * r / J))
rolling = v - f * g * t
way = v * t - f * g * t * t / 2
lost = m * v * v / 2 - (m + J / r**2) * rolling**2 / 2
print(f"expect time(rolls) = {mp.nstr(t, 14)} s within 1e-12")
print(f"expect position(ball.C).x = {mp.nstr(way, 14)} m within 1e-12 at event rolls")
print(f"expect velocity(ball.C).x = {mp.nstr(rolling, 14)} m/s within 1e-12 at event rolls")
print(f"expect friction_work(K) = {mp.nstr(-lost, 14)} J within 1e-12 at event end")
print(f"expect position(ball.C).x = {mp.nstr(way + rolling * (3 - t), 14)} m within 1e-12 at time = 3 s")
