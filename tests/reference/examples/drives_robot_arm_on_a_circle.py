"""The arm of `drives_robot_arm.py` with its tip on a circle, without weight."""
from drives_robot_arm import arm, degrees
from printing import *

r, w, t = mpf("0.1"), mpf(4), mpf("0.3")
c, s = mp.cos(w * t), mp.sin(w * t)
tip = (mpf("0.55") + r * c, mpf("0.2") + r * s)
q1, q2, w1, w2, a1, a2, M1, M2 = arm(tip, (-r * w * s, r * w * c), (-r * w * w * c, -r * w * w * s), mpf(0))
print(f"expect angle(upper) = {degrees(q1)} deg within 1e-12 at time = 0.3 s")
print(f"expect angle(fore) = {degrees(q2)} deg within 1e-12 at time = 0.3 s")
print(f"expect M1 = {mp.nstr(M1, 14)} N*m within 1e-12 at time = 0.3 s")
print(f"expect M2 = {mp.nstr(M2, 14)} N*m within 1e-12 at time = 0.3 s")
print(f"expect power = {mp.nstr(M1 * w1 + M2 * (w2 - w1), 14)} W within 1e-12 at time = 0.3 s")
