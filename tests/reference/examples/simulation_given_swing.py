"""An arm with a given angle q(t): M = J q'' + m g a cos q, and the instants at which it passes 8 N m."""
from printing import *

J, m, g, a = mpf("0.5"), mpf(2), mpf("9.81"), mpf("0.5")
q = lambda t: mp.radians(30) + mp.radians(20) * mp.sin(3 * t)
M = lambda t: -J * 9 * mp.radians(20) * mp.sin(3 * t) + m * g * a * mp.cos(q(t))
at = [mp.findroot(lambda t: M(t) - 8, near) for near in (mpf("0.05"), mpf(1), mpf("2.14"))]
print(f"expect M = {mp.nstr(M(mpf(0)), 14)} N*m within 1e-13 at event begin")
print(f"expect time(low) = {mp.nstr(at[0], 14)} s within 1e-13")
print(f"expect angle(arm) = {mp.nstr(mp.degrees(q(at[0])), 14)} deg within 1e-13 at event low")
print(f"expect time(high) = {mp.nstr(at[1], 14)} s within 1e-13")
print(f"expect time(low, 2) = {mp.nstr(at[2], 14)} s within 1e-13")
print("expect count(low) = 2")
