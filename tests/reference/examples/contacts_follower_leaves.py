"""A flat follower on an eccentric: s = e sin q, N = m (g - e w^2 sin q) + F_0 + k e (1 + sin q), zero where sin q is known."""
from printing import *

m, g, e, w, k, F_0 = mpf(2), mpf("9.81"), mpf("0.012"), mpf(90), mpf(2000), mpf(20)
N = lambda q: m * (g - e * w**2 * mp.sin(q)) + F_0 + k * e * (1 + mp.sin(q))
q = mp.asin((m * g + F_0 + k * e) / (m * e * w**2 - k * e))
assert abs(N(q)) < mpf(10) ** -20
print(f"expect drive(leaves) = {mp.nstr(mp.degrees(q), 14)} deg within 1e-13")
print(f"expect time(leaves) = {mp.nstr((q + pi / 2) / w, 14)} s within 1e-13")
print(f"expect drive(returns) = {mp.nstr(180 - mp.degrees(q), 14)} deg within 1e-13")
print("expect count(leaves) = 1")
print(f"expect least = {mp.nstr(N(pi / 2), 14)} N within 1e-13")
print("expect where = 90 deg within 1e-9")
print(f"expect angle(cam) = {mp.nstr(mp.degrees(q), 14)} deg within 1e-13 at event leaves")
